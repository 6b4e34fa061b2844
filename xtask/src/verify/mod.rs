//! The matrix theorem x kind of evidence: what was run now, what was verified by record, what was not
//! run.
//!
//! This is a layer above the engines, like the command line: it may use all of them, and no engine
//! depends on it. Each column is a [`Tier`], in a file of its own; the collector ([`matrix`]) and the
//! formats ([`show`]) know tiers only by that trait.

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

/// The verdict of a tier that ran on a theorem.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TierVerdict {
    /// The theorem holds, as far as the evidence reaches.
    Holds,
    /// It is refuted, with a counterexample in words.
    Refuted(String),
    /// A certificate or proof was not accepted, with the reason.
    Rejected(String),
    /// Neither, with the reason.
    Inconclusive(String),
}

impl TierVerdict {
    /// The worse of two verdicts; the first if they are equally bad.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        if self.outcome().worst(other.outcome()) == self.outcome() { self } else { other }
    }

    /// The outcome of a run with this verdict.
    pub fn outcome(&self) -> Outcome {
        match self {
            Self::Holds => Outcome::Holds,
            Self::Refuted(_) => Outcome::Refuted,
            Self::Rejected(_) => Outcome::Rejected,
            Self::Inconclusive(_) => Outcome::Inconclusive,
        }
    }
}

/// The result of a tier for one theorem, now.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// The tier does not cover this theorem: with the reason.
    NotClaimed(String),
    /// It was not run: with the reason.
    NotRun(String),
    /// The tier was run.
    Run {
        /// The verdict of the run.
        verdict: TierVerdict,
        /// The coverage, in words.
        scope: String,
        /// Duration in seconds. A tier that treats all theorems at once reports the total for each.
        seconds: f64,
    },
}

/// A kind of evidence: one column of the matrix.
pub trait Tier {
    /// Its name, a single word.
    fn name(&self) -> &'static str;

    /// The kind of evidence.
    fn kind(&self) -> Evidence;

    /// The tool that runs, with its version; for an external tool, as installed.
    fn tool(&self) -> String;

    /// Files and folders below the repository's root that its results depend on. A record is valid as
    /// long as they are unchanged.
    fn sources(&self) -> &'static [&'static str];

    /// Its result for the sharp form of the theorem.
    fn status(&self, theorem: Theorem) -> Status;

    /// Problems that concern no particular theorem.
    fn problems(&self) -> Vec<TierVerdict> {
        Vec::new()
    }
}

/// What tiers need to know about the run.
#[derive(Clone, Copy, Debug)]
pub struct Context<'c> {
    /// The root of the repository.
    pub root: &'c Path,
    /// Names of the tiers to run that run on request only.
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
