//! The matrix: every tier asked about every theorem, records in the place of what did not run.

use std::path::Path;

use cordon_spec::theorems::Theorem;

use super::record::Records;
use super::{Evidence, Status, Tier, TierVerdict, sources};
use cordon_core::Outcome;

/// What is known of a theorem by one kind of evidence.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// The tier is not about this theorem: with the reason.
    NotClaimed(String),
    /// Neither run now nor recorded: with the reason.
    NotRun(String),
    /// The tier was run just now.
    Run {
        /// What this run found.
        verdict: TierVerdict,
        /// Which cases this run covered.
        scope: String,
        /// How long it took, in seconds.
        seconds: f64,
    },
    /// Verified by record: the sources are those of the record.
    Recorded {
        /// What the recorded run found.
        verdict: TierVerdict,
        /// Which cases the recorded run covered.
        scope: String,
        /// When, and by what.
        origin: Origin,
    },
    /// There is a record of other sources: it counts for nothing.
    Stale {
        /// When, and by what.
        origin: Origin,
        /// Why it was not run now.
        why: String,
    },
}

/// Where a record comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Date of the recorded run, in UTC.
    pub date: String,
    /// What ran, with its version.
    pub tool: String,
    /// Hash of the sources it ran for.
    pub sources: String,
}

impl Cell {
    /// What it contributes to the outcome, if anything.
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

    /// What was covered, or the reason why there is no result.
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

    /// Seconds of a run.
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

/// What one tier has to say of each theorem.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name of the tier.
    pub name: &'static str,
    /// The kind of evidence.
    pub kind: Evidence,
    /// One cell a theorem, in the matrix's order.
    pub cells: Vec<Cell>,
    /// What is wrong beside the theorems.
    pub problems: Vec<TierVerdict>,
}

/// Theorem x kind of evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    /// The theorems, one a row.
    pub theorems: Vec<Theorem>,
    /// The tiers, one a column.
    pub columns: Vec<Column>,
}

/// Asks every tier about every theorem.
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
        // Sources that cannot be read are not those of the record.
        _ => Cell::Stale { origin, why },
    }
}

impl Matrix {
    /// Rejected or refuted if anything is; holds if some tier ran; else inconclusive.
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
