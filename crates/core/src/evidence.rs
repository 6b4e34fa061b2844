//! What a verdict rests on.

use serde::{Deserialize, Serialize};

/// The kinds of evidence, weakest first; each covers what its description says and no more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(into = "&'static str", try_from = "String")]
#[non_exhaustive]
pub enum Evidence {
    /// One run was checked, at its recorded steps only.
    ThisRunOnly,
    /// Some starts or runs, drawn at random, were checked.
    Sampled,
    /// Every start on a grid was checked, at every step up to a bound.
    ExhaustiveOnGrid,
    /// All real starts were decided, for the listed N, weights and steps.
    CompleteForAllStarts,
    /// A model checker covered all states within bounds, bit by bit.
    ModelChecked,
    /// A solver proved the inductive step: all starts, weights and steps, for the listed N.
    InductivePerCount,
    /// Every step preserves an invariant: all steps, for all starts that satisfy it.
    Inductive,
    /// The independent checker accepted a certificate.
    Certified,
    /// A proof assistant's kernel accepted a proof.
    Mechanised,
}

impl Evidence {
    /// All kinds, the weakest first.
    pub const ALL: [Self; 9] = [
        Self::ThisRunOnly,
        Self::Sampled,
        Self::ExhaustiveOnGrid,
        Self::CompleteForAllStarts,
        Self::ModelChecked,
        Self::InductivePerCount,
        Self::Inductive,
        Self::Certified,
        Self::Mechanised,
    ];

    /// The name of the kind, as printed and as written to result files.
    pub fn text(self) -> &'static str {
        match self {
            Self::ThisRunOnly => "this run only",
            Self::Sampled => "sampled",
            Self::ExhaustiveOnGrid => "exhaustive on a grid",
            Self::CompleteForAllStarts => "complete for all starts",
            Self::ModelChecked => "model-checked within bounds",
            Self::InductivePerCount => "inductive, for each N",
            Self::Inductive => "inductive",
            Self::Certified => "certified",
            Self::Mechanised => "mechanised",
        }
    }
}

impl std::fmt::Display for Evidence {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.text())
    }
}

impl From<Evidence> for &'static str {
    fn from(evidence: Evidence) -> Self {
        evidence.text()
    }
}

impl TryFrom<String> for Evidence {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|e| e.text() == text);
        found.ok_or_else(|| format!("evidence: `{text}` is not a kind of evidence"))
    }
}
