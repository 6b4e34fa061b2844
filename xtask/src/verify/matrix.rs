//! The matrix: every tier evaluated on every theorem, with records for the tiers that did not run.

use std::path::Path;

use cordon_spec::theorems::Theorem;

use super::record::Records;
use super::{Evidence, Status, Tier, TierVerdict, sources};
use cordon_core::Outcome;

/// The result for a theorem by one kind of evidence.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// The tier does not cover this theorem: with the reason.
    NotClaimed(String),
    /// Neither run now nor recorded: with the reason.
    NotRun(String),
    /// The tier was run now.
    Run {
        /// What this run found.
        verdict: TierVerdict,
        /// The cases that this run covered.
        scope: String,
        /// Duration in seconds.
        seconds: f64,
    },
    /// Verified by record: the sources are unchanged since.
    Recorded {
        /// What the recorded run found.
        verdict: TierVerdict,
        /// The cases that the recorded run covered.
        scope: String,
        /// The date and tool of the record.
        origin: Origin,
    },
    /// There is a record for other sources: it does not count.
    Stale {
        /// The date and tool of the record.
        origin: Origin,
        /// Why the tier was not run now.
        why: String,
    },
}

/// The origin of a record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Date of the recorded run, in UTC.
    pub date: String,
    /// The tool that ran, with its version.
    pub tool: String,
    /// Hash of the sources at that time.
    pub sources: String,
}

impl Cell {
    /// Its contribution to the outcome, if any.
    fn verdict(&self) -> Option<&TierVerdict> {
        match self {
            Self::Run { verdict, .. } | Self::Recorded { verdict, .. } => Some(verdict),
            Self::NotClaimed(_) | Self::NotRun(_) | Self::Stale { .. } => None,
        }
    }

    /// The status in a word or two.
    pub fn status(&self) -> &'static str {
        match self {
            Self::NotClaimed(_) => "not claimed",
            Self::NotRun(_) => "not run",
            Self::Run { .. } => "run now",
            Self::Recorded { .. } => "by record",
            Self::Stale { .. } => "stale",
        }
    }

    /// The result in a word, where there is one.
    pub fn result(&self) -> Option<&'static str> {
        self.verdict().map(|v| match v {
            TierVerdict::Holds => "holds",
            TierVerdict::Refuted(_) => "refuted",
            TierVerdict::Rejected(_) => "rejected",
            TierVerdict::Inconclusive(_) => "inconclusive",
        })
    }

    /// The coverage, or the reason why there is no result.
    pub fn detail(&self) -> String {
        match self {
            Self::NotClaimed(why) | Self::NotRun(why) => why.clone(),
            Self::Stale { origin, why } => {
                format!("the record of {} is of other sources; {why}", origin.date)
            }
            Self::Run { verdict, scope, .. } | Self::Recorded { verdict, scope, .. } => {
                match verdict {
                    TierVerdict::Holds => scope.clone(),
                    TierVerdict::Refuted(why)
                    | TierVerdict::Rejected(why)
                    | TierVerdict::Inconclusive(why) => {
                        format!("{why} ({scope})")
                    }
                }
            }
        }
    }

    /// Duration of a run, in seconds.
    pub fn seconds(&self) -> Option<f64> {
        match self {
            Self::Run { seconds, .. } => Some(*seconds),
            _ => None,
        }
    }

    /// Where a record comes from.
    pub fn origin(&self) -> Option<&Origin> {
        match self {
            Self::Recorded { origin, .. } | Self::Stale { origin, .. } => Some(origin),
            _ => None,
        }
    }
}

/// The results of one tier.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name of the tier.
    pub name: &'static str,
    /// The kind of evidence.
    pub kind: Evidence,
    /// One cell per theorem, in the matrix's order.
    pub cells: Vec<Cell>,
    /// Problems that concern no particular theorem.
    pub problems: Vec<TierVerdict>,
}

/// The matrix theorem x kind of evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    /// The theorems, one per row.
    pub theorems: Vec<Theorem>,
    /// The tiers, one per column.
    pub columns: Vec<Column>,
}

/// Evaluates every tier on every theorem.
pub fn collect(
    root: &Path,
    tiers: &[Box<dyn Tier>],
    records: &Records,
    theorems: &[Theorem],
    mut progress: impl FnMut(&str),
) -> Matrix {
    let columns = tiers.iter().map(|tier| {
        progress(tier.name());
        let cells = theorems.iter().map(|&t| cell(root, tier.as_ref(), records, t)).collect();
        Column { name: tier.name(), kind: tier.kind(), cells, problems: tier.problems() }
    });
    Matrix { theorems: theorems.to_vec(), columns: columns.collect() }
}

fn cell(root: &Path, tier: &dyn Tier, records: &Records, theorem: Theorem) -> Cell {
    let why = match tier.status(theorem) {
        Status::NotClaimed(why) => return Cell::NotClaimed(why),
        Status::Run { verdict, scope, seconds } => return Cell::Run { verdict, scope, seconds },
        Status::NotRun(why) => why,
    };
    let Some(record) = records.of(tier.name()) else {
        return Cell::NotRun(why);
    };
    let Some(entry) = record.theorems.iter().find(|e| e.number == theorem.number()) else {
        return Cell::NotRun(why);
    };
    let origin = Origin {
        date: record.date.clone(),
        tool: record.tool.clone(),
        sources: record.sources.clone(),
    };
    match sources::hash(root, tier.sources()) {
        Ok(hash) if hash == record.sources => {
            Cell::Recorded { verdict: entry.verdict(), scope: entry.scope.clone(), origin }
        }
        // Sources that cannot be read do not match the record.
        _ => Cell::Stale { origin, why },
    }
}

impl Matrix {
    /// Rejected or refuted if anything is; holds if some tier ran; otherwise inconclusive.
    pub fn outcome(&self) -> Outcome {
        let cells = self.columns.iter().flat_map(|c| c.cells.iter());
        let verdicts = cells.filter_map(Cell::verdict);
        let problems = self.columns.iter().flat_map(|c| c.problems.iter());
        let worst = verdicts
            .chain(problems)
            .map(TierVerdict::outcome)
            .filter(|o| matches!(o, Outcome::Refuted | Outcome::Rejected))
            .fold(Outcome::Holds, Outcome::worst);
        let ran = self
            .columns
            .iter()
            .any(|c| c.cells.iter().any(|cell| matches!(cell, Cell::Run { .. })));
        if worst == Outcome::Holds && !ran { Outcome::Inconclusive } else { worst }
    }
}
