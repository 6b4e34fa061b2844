//! How far a search goes, and what ends it.

use std::fmt;

/// How far to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Last step of a counterexample.
    pub steps: usize,
    /// Most half-spaces of an invariant beside the claims and what is assumed of the start.
    pub half_spaces: usize,
    /// Most work in linear programs, in the unit of [`Work`](cordon_core::simplex::Work).
    pub work: u64,
}

/// What ended a search that decided nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The limit of steps.
    Steps,
    /// The limit of half-spaces.
    HalfSpaces,
    /// The limit of work.
    Work,
    /// Numbers longer than a certificate may have.
    Digits,
    /// A half-space that depends on too many ranges.
    Choices,
    /// A claim that fails where constants differ from step to step; it may hold where they do not.
    Varying,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Steps => "the invariant needs more steps than the search goes back",
            Self::HalfSpaces => "the invariant needs more half-spaces than the search allows",
            Self::Work => "the linear programs take more work than the search allows",
            Self::Digits => "the invariant needs longer numbers than a certificate may have",
            Self::Choices => "a claim depends on more choices in a step than the search combines",
            Self::Varying => {
                "a claim fails where a constant takes another value in each step, which is how ranges \
                 are proved"
            }
        })
    }
}
