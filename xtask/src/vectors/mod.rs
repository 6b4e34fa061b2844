//! Test vectors for the mechanised mirrors: what the spec computed, as data and as theorems that
//! a proof assistant checks by computation.
//!
//! The Rocq and Lean developments execute the definitions they prove things about on these
//! inputs; the committed files are generated here, and a test compares the bytes.

mod cases;
mod kinds;
mod lean;
mod rocq;
mod show;

use cordon_spec::Phase;

use cordon_core::Rational;

pub use lean::lean;
pub use rocq::rocq;
pub use show::{json, tsv};

/// One value that a vector's definition is given.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Value {
    /// An exact number.
    Number(Rational),
    /// A count, an index or a counter.
    Count(u64),
    /// When the first update comes.
    Phase(Phase),
    /// One number a drone, or a table of them.
    Numbers(Vec<Rational>),
    /// The links of a graph.
    Edges(Vec<(usize, usize)>),
    /// One yes or no a drone.
    Flags(Vec<bool>),
}

/// One evaluation with its result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vector {
    kind: &'static str,
    name: String,
    arguments: Vec<(&'static str, Value)>,
    expected: Vec<Rational>,
}

/// All vectors, computed by the spec.
pub fn vectors() -> Vec<Vector> {
    cases::all()
}
