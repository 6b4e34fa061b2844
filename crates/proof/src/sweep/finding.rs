//! What one work item has found.

use cordon_spec::theorems::{Form, Theorem};
use serde::{Deserialize, Serialize};

use super::config::Item;
use crate::counterexample::Counterexample;
use cordon_core::{Evidence, Outcome, Rational, serial};

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Judgement {
    /// No case violates it, and some case meets its premise.
    Holds,
    /// No case meets its premise: nothing was learnt.
    Vacuous,
    /// Some case could not be decided, and none violates it.
    Undecided,
    /// Some case violates it.
    Refuted,
}

impl Judgement {
    /// The judgement in a word.
    pub fn text(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Vacuous => "vacuous",
            Self::Undecided => "undecided",
            Self::Refuted => "refuted",
        }
    }

    /// How a command that found this ends.
    pub fn outcome(self) -> Outcome {
        match self {
            Self::Holds => Outcome::Holds,
            Self::Vacuous | Self::Undecided => Outcome::Inconclusive,
            Self::Refuted => Outcome::Refuted,
        }
    }
}

/// A start from which a conclusion fails: what a result file keeps of a counterexample, which
/// is enough to run it again.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Witness {
    /// The step k whose conclusion fails.
    pub step: usize,
    /// Positions X^0 of every drone; the segment is from the first to the last.
    #[serde(with = "serial::list")]
    pub start: Vec<Rational>,
    /// What fails, in words.
    pub violation: String,
}

impl From<&Counterexample> for Witness {
    fn from(found: &Counterexample) -> Self {
        let (step, start) = (found.step, found.start().to_vec());
        Self { step, start, violation: found.what_fails() }
    }
}

/// Counts of the cases of a work item. On a grid a case is a start and a step k; in a complete
/// sweep it is a step k, for all real starts at once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// Starts tried; in a complete sweep, generators of the set of all starts.
    pub starts: u64,
    /// Cases decided or tried.
    pub cases: u64,
    /// Cases that met the conclusion's own premise.
    pub non_vacuous: u64,
    /// Cases that violate the conclusion.
    pub violations: u64,
    /// Cases that could not be decided: none on a grid.
    pub undecided: u64,
    /// Updates of single drones that were executed (mirror images are not).
    pub updates: u64,
}

impl Counts {
    /// Both together. The number of cases is bounded before a sweep starts, so that these
    /// sums do not overflow; they saturate all the same.
    pub fn plus(self, other: Self) -> Self {
        Self {
            starts: self.starts.saturating_add(other.starts),
            cases: self.cases.saturating_add(other.cases),
            non_vacuous: self.non_vacuous.saturating_add(other.non_vacuous),
            violations: self.violations.saturating_add(other.violations),
            undecided: self.undecided.saturating_add(other.undecided),
            updates: self.updates.saturating_add(other.updates),
        }
    }

    /// What these counts say of the claim.
    pub fn judgement(&self) -> Judgement {
        if self.violations > 0 {
            Judgement::Refuted
        } else if self.undecided > 0 {
            Judgement::Undecided
        } else if self.non_vacuous > 0 {
            Judgement::Holds
        } else {
            Judgement::Vacuous
        }
    }
}

/// What one work item has found: one line of a result file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Finding {
    /// Position in the sweep, from 0.
    pub item: usize,
    /// The theorem that was swept.
    #[serde(with = "serial")]
    pub theorem: Theorem,
    /// As printed, or sharp.
    #[serde(with = "serial")]
    pub form: Form,
    /// Number of drones N.
    pub drones: usize,
    /// The one weight eps of the item.
    #[serde(with = "serial")]
    pub eps: Rational,
    /// The kind of evidence.
    pub evidence: Evidence,
    /// Length of the segment in grid units; none in a complete sweep.
    pub segment: Option<i64>,
    /// Starts, cases and violations, as counted.
    #[serde(flatten)]
    pub counts: Counts,
    /// The verdict that the counts amount to.
    pub verdict: Judgement,
    /// The counterexample with the least k, and of these the first on the grid.
    pub counterexample: Option<Witness>,
    /// Why a case is undecided.
    pub reason: Option<String>,
}

impl Finding {
    /// What these counts say of a work item; a counterexample, a segment and a reason are
    /// still to be filled in.
    pub fn new(item: &Item, evidence: Evidence, counts: Counts) -> Self {
        Self {
            item: item.number,
            theorem: item.theorem,
            form: item.form,
            drones: item.drones,
            eps: item.eps.clone(),
            evidence,
            segment: None,
            counts,
            verdict: counts.judgement(),
            counterexample: None,
            reason: None,
        }
    }
}
