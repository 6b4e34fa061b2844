//! Doubles as scalars.

use std::cmp::Ordering;

use cordon_spec::{Ordered, Scalar};

use super::ring_operators;

/// A double. Every operation rounds, so a run on doubles shows what a controller would
/// compute; it proves nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Float(pub f64);

ring_operators!(
    Float,
    |a: Float, b: &Float| Float(a.0 + b.0),
    |a: Float, b: &Float| Float(a.0 - b.0),
    |a: Float, b: &Float| Float(a.0 * b.0)
);

impl Scalar for Float {
    fn from_int(n: i32) -> Self {
        Self(n.into())
    }
}

impl Ordered for Float {
    /// `None` where a side is no number.
    fn compare(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}
