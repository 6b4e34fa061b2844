//! The errata engine: the paper's slips (PROTOCOL section 4), each established anew by
//! computation whenever it is asked.
//!
//! No result is stored: every number in a [`Recomputed`] comes from running the spec, or from
//! exact algebra on the equations as printed.

mod hypotheses;
mod physics;
mod runs;
mod timing;

/// A slip of the paper.
#[derive(Clone, Copy)]
pub struct Erratum {
    /// Number in PROTOCOL section 4.
    pub number: u32,
    /// Where in the paper.
    pub place: &'static str,
    /// What it says there.
    pub printed: &'static str,
    compute: fn() -> Recomputed,
}

/// What the computation found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recomputed {
    /// Whether the printed statement is indeed wrong, or not needed, or incomplete.
    pub established: bool,
    /// What is so instead, with the computed values.
    pub computed: String,
}

impl Erratum {
    /// Runs the spec, and says whether the paper's print is wrong as claimed.
    pub fn establish(&self) -> Recomputed {
        (self.compute)()
    }
}

/// All errata, by number.
pub fn all() -> Vec<Erratum> {
    let mut errata: Vec<_> =
        [timing::ERRATA, runs::ERRATA, hypotheses::ERRATA, physics::ERRATA].concat();
    errata.sort_by_key(|e| e.number);
    errata
}

/// A result from a condition and a text.
fn recomputed(established: bool, computed: impl Into<String>) -> Recomputed {
    Recomputed { established, computed: computed.into() }
}
