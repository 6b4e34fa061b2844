//! Separation of drones in flight: the response of one drone's loop is nowhere negative, shown by
//! a cone that the loop keeps.
//!
//! Drones that are one linear system and start at rest fly along convex combinations of the
//! desired placements so far and of the start, as long as no sample of the response to a command
//! is negative (PROTOCOL section 3): the smallest gap is kept. That no sample is negative, out of
//! infinitely many, follows from rows F with F A = M F, M >= 0, of which the readouts are
//! nonnegative combinations and which the state meets from some step on.
//!
//! Rows are suggested by the modes of A in doubles; whether they are what is wanted is decided on
//! exact numbers.

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

/// Samples looked at for a negative one before a cone is searched, which takes longer.
const FIRST_STEPS: usize = 150;

/// Samples looked at in all, and steps until a state has to be in a cone.
const MOST_STEPS: usize = 800;

/// A linear system, states that it may start in, and forms of the state that should never be
/// negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Response {
    /// Names of the state's members.
    pub state: Vec<String>,
    /// What a state becomes in a step.
    pub matrix: Matrix,
    /// The starts, each with a name for how much of it there is.
    pub starts: Vec<(String, Vec<Rational>)>,
    /// The forms c whose responses are asked for.
    pub readouts: Matrix,
}

/// A readout that is negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Negative {
    /// Number of the start.
    pub start: usize,
    /// Samples after the impulse.
    pub step: usize,
    /// Number of the readout.
    pub readout: usize,
    /// The response there, below 0.
    pub value: Rational,
}

/// What is known of a response.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// No readout is ever negative, from no nonnegative combination of the starts.
    NonNegative(Cone),
    /// A response is negative at this sample.
    Negative(Negative),
    /// Neither a cone nor a negative sample was found.
    Undecided,
}

/// Looks for a cone, or for a negative sample.
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
