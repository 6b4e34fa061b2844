//! The errata engine: the paper's errors (PROTOCOL section 4), each established by computation on
//! demand.
//!
//! No result is stored: every number in a [`Recomputed`] comes from running the spec, or from
//! exact algebra on the equations as printed.

mod hypotheses;
mod physics;
mod runs;
mod timing;

/// An error in the paper.
#[derive(Clone, Copy)]
pub struct Erratum {
    /// Number in PROTOCOL section 4.
    pub number: u32,
    /// Location in the paper.
    pub place: &'static str,
    /// The printed text.
    pub printed: &'static str,
    compute: fn() -> Recomputed,
}

/// The result of the computation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recomputed {
    /// Whether the printed statement is indeed wrong, unnecessary, or incomplete.
    pub established: bool,
    /// What holds instead, with the computed values.
    pub computed: String,
}

impl Erratum {
    /// Runs the computation, which decides whether the printed statement is wrong as claimed.
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
