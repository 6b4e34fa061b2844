//! Test vectors for the mechanised mirrors: results of the spec, as data and as theorems that a proof
//! assistant checks by computation.
//!
//! The Rocq and Lean developments execute the definitions of their proofs on these inputs; the
//! committed files are generated here, and a test compares them byte by byte.

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

/// An argument of a vector's definition.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Value {
    /// An exact number.
    Number(Rational),
    /// A count, an index or a counter.
    Count(u64),
    /// When the first update happens.
    Phase(Phase),
    /// One number per drone, or a table of them.
    Numbers(Vec<Rational>),
    /// The links of a graph.
    Edges(Vec<(usize, usize)>),
    /// One Boolean per drone.
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
