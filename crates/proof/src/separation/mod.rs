//! Separation of drones in flight: the response of one drone's loop is never negative, shown by an
//! invariant cone.
//!
//! Drones that are one linear system and start at rest fly along convex combinations of the start and
//! the desired placements so far, as long as no sample of the response to a command is negative
//! (PROTOCOL section 3): the smallest gap is kept. That none of the infinitely many samples is negative
//! follows from rows F with F A = M F, M >= 0, such that the readouts are nonnegative combinations of
//! the rows and F x >= 0 for the state x from some step on.
//!
//! Rows are suggested by the modes of A in doubles; whether they meet these conditions is decided
//! exactly.

mod certificate;
mod cone;
pub mod desired;
mod mass;
mod modes;
mod path;

use cordon_core::Rational;
use cordon_core::linear::matrix::Matrix;

use path::{Entry, entry};

pub use certificate::{negative, nonnegative};
pub use cone::Cone;
pub use mass::{Mass, masses};

/// Samples checked for a negative one before the search for a cone, which takes longer.
const FIRST_STEPS: usize = 150;

/// Most samples checked, and most steps until a state has to be in a cone.
const MOST_STEPS: usize = 800;

/// A linear system, its start states, and forms of the state that should never be negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Response {
    /// Names of the state variables.
    pub state: Vec<String>,
    /// The state transition of one step.
    pub matrix: Matrix,
    /// The starts, each with a name for its factor.
    pub starts: Vec<(String, Vec<Rational>)>,
    /// The forms c whose responses are checked.
    pub readouts: Matrix,
}

/// A negative sample of a readout.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Negative {
    /// Index of the start.
    pub start: usize,
    /// Number of steps after the impulse.
    pub step: usize,
    /// Index of the readout.
    pub readout: usize,
    /// The response there, below 0.
    pub value: Rational,
}

/// The result for a response.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// No readout is ever negative, from any nonnegative combination of the starts.
    NonNegative(Cone),
    /// This sample of a response is negative.
    Negative(Negative),
    /// Neither a cone nor a negative sample was found.
    Undecided,
}

/// Searches for a cone, or for a negative sample.
pub fn decide(response: &Response) -> Finding {
    if let Entry::Negative(sample) = entry(response, None, FIRST_STEPS) {
        return Finding::Negative(sample);
    }
    let Some(mut cone) = cone::find(response) else {
        return match entry(response, None, MOST_STEPS) {
            Entry::Negative(sample) => Finding::Negative(sample),
            _ => Finding::Undecided,
        };
    };
    match entry(response, Some(&cone.rows), MOST_STEPS) {
        Entry::Negative(sample) => Finding::Negative(sample),
        Entry::At(step) => {
            cone.entered = step;
            Finding::NonNegative(cone)
        }
        Entry::Nowhere => Finding::Undecided,
    }
}
