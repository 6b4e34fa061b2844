//! Intervals with exact rational ends.

use std::cmp::Ordering;

use cordon_spec::{Ordered, Scalar};

use super::ring_operators;
use crate::Rational;

/// The closed interval \[lo, hi\]. A run on intervals encloses every run on their members.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    lo: Rational,
    hi: Rational,
}

impl Interval {
    /// The interval between two numbers, in either order.
    pub fn new(a: Rational, b: Rational) -> Self {
        if a <= b { Self { lo: a, hi: b } } else { Self { lo: b, hi: a } }
    }

    /// The interval of one number.
    pub fn point(x: Rational) -> Self {
        Self { lo: x.clone(), hi: x }
    }

    /// The least member.
    pub fn lo(&self) -> &Rational {
        &self.lo
    }

    /// The greatest member.
    pub fn hi(&self) -> &Rational {
        &self.hi
    }

    /// Whether `x` is a member.
    pub fn contains(&self, x: &Rational) -> bool {
        self.lo <= *x && *x <= self.hi
    }
}

fn product(a: Interval, b: &Interval) -> Interval {
    let ends = [&a.lo * &b.lo, &a.lo * &b.hi, &a.hi * &b.lo, &a.hi * &b.hi];
    let [first, rest @ ..] = ends;
    let point = Interval::point(first);
    rest.into_iter()
        .fold(point, |hull, x| Interval { lo: hull.lo.min(x.clone()), hi: hull.hi.max(x) })
}

ring_operators!(
    Interval,
    |a: Interval, b: &Interval| Interval { lo: a.lo + &b.lo, hi: a.hi + &b.hi },
    |a: Interval, b: &Interval| Interval { lo: a.lo - &b.hi, hi: a.hi - &b.lo },
    product
);

impl Scalar for Interval {
    fn from_int(n: i32) -> Self {
        Self::point(Rational::from_int(n))
    }
}

impl Ordered for Interval {
    /// `None` where the intervals overlap in more than one common point.
    fn compare(&self, other: &Self) -> Option<Ordering> {
        if self.hi < other.lo {
            Some(Ordering::Less)
        } else if self.lo > other.hi {
            Some(Ordering::Greater)
        } else if self.lo == self.hi && self == other {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}
