//! The matrix theorem x kind of evidence: what was run now, what was verified by record, what
//! was not run.
//!
//! This is a face over the engines, like the command line: it may know all of them, and no
//! engine knows it or another. Each column is a [`Tier`], in a file of its own; the collector
//! ([`matrix`]) and the formats ([`show`]) know tiers only by that trait.

pub mod certificates;
pub mod external;
pub mod matrix;
pub mod model_checked;
pub mod record;
pub mod show;
pub mod simulated;
pub mod smt;
pub mod sources;
pub mod sweeps;

use std::path::Path;

use cordon_spec::theorems::Theorem;

use cordon_core::{Evidence, Outcome};

/// What a tier that ran has found of a theorem.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TierVerdict {
    /// The theorem holds as far as the evidence reaches.
    Holds,
    /// It does not: with a counterexample in words.
    Refuted(String),
    /// A certificate or proof of it was not accepted: with the reason.
    Rejected(String),
    /// Neither: with the reason.
    Inconclusive(String),
}

impl TierVerdict {
    /// The worse of two verdicts, the first where they are alike.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        if self.outcome().worst(other.outcome()) == self.outcome() { self } else { other }
    }

    /// What a run with this verdict ends with.
    pub fn outcome(&self) -> Outcome {
        match self {
            Self::Holds => Outcome::Holds,
            Self::Refuted(_) => Outcome::Refuted,
            Self::Rejected(_) => Outcome::Rejected,
            Self::Inconclusive(_) => Outcome::Inconclusive,
        }
    }
}

/// What a tier has to say of one theorem, now.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// The tier is not about this theorem: with the reason.
    NotClaimed(String),
    /// It was not run: with the reason.
    NotRun(String),
    /// The tier was run.
    Run {
        /// What the run found.
        verdict: TierVerdict,
        /// What was covered, in words.
        scope: String,
        /// How long it took, in seconds. What a tier does for all theorems at once it says of
        /// each.
        seconds: f64,
    },
}

/// A kind of evidence: one column of the matrix.
pub trait Tier {
    /// Its name, a word.
    fn name(&self) -> &'static str;

    /// The kind of evidence.
    fn kind(&self) -> Evidence;

    /// What runs, with its version; for a tool outside this program, as it is installed.
    fn tool(&self) -> String;

    /// Files and folders below the repository's root that its answers depend on. A record is
    /// good for as long as their content stays.
    fn sources(&self) -> &'static [&'static str];

    /// What it has to say of the theorem in its sharp form.
    fn status(&self, theorem: Theorem) -> Status;

    /// What it found wrong that belongs to no theorem.
    fn problems(&self) -> Vec<TierVerdict> {
        Vec::new()
    }
}

/// What the tiers need to know.
#[derive(Clone, Copy, Debug)]
pub struct Context<'c> {
    /// The root of the repository.
    pub root: &'c Path,
    /// Names of the tiers that take minutes and are run on request only.
    pub run: &'c [String],
}

/// All tiers, from the weakest kind of evidence to the strongest.
pub fn tiers(context: Context<'_>) -> Vec<Box<dyn Tier>> {
    vec![
        Box::new(simulated::Simulated),
        Box::new(sweeps::Grid),
        Box::new(sweeps::Complete),
        Box::new(model_checked::ModelChecked::new(context)),
        Box::new(smt::Smt),
        Box::new(external::creusot(context)),
        Box::new(certificates::Certificates::new(context.root)),
        Box::new(external::rocq(context)),
        Box::new(external::lean(context)),
        Box::new(external::pvs(context)),
    ]
}

/// The names of [`tiers`], in their order.
pub const NAMES: [&str; 10] = [
    "simulated",
    "grid",
    "complete",
    "kani",
    "smt",
    "creusot",
    "certificate",
    "rocq",
    "lean",
    "pvs",
];

/// This program, as a tool.
fn this_program() -> String {
    format!("cordon {}", env!("CARGO_PKG_VERSION"))
}
