//! Enclosures in binary fixed point, as scalars of the spec.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use cordon_spec::{Ordered, Scalar};
use num_bigint::BigInt;

use crate::Rational;

/// All numbers from `lo / 2^BITS` to `hi / 2^BITS`. Each operation rounds outwards, so that a
/// run on enclosures encloses the exact run; unlike a run on fractions its numbers keep their
/// length.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enclosure<const BITS: u32> {
    lo: BigInt,
    hi: BigInt,
}

impl<const BITS: u32> Enclosure<BITS> {
    /// The tightest enclosure of a number.
    pub fn of(x: &Rational) -> Self {
        let scaled = x * Rational::from_integer(BigInt::from(1) << BITS);
        Self { lo: scaled.floor().to_integer(), hi: scaled.ceil().to_integer() }
    }
}

impl<const BITS: u32> Add<&Self> for Enclosure<BITS> {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        Self { lo: self.lo + &other.lo, hi: self.hi + &other.hi }
    }
}

impl<const BITS: u32> Sub<&Self> for Enclosure<BITS> {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        Self { lo: self.lo - &other.hi, hi: self.hi - &other.lo }
    }
}

impl<const BITS: u32> Mul<&Self> for Enclosure<BITS> {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        let ends = [
            &self.lo * &other.lo,
            &self.lo * &other.hi,
            &self.hi * &other.lo,
            &self.hi * &other.hi,
        ];
        let [first, rest @ ..] = ends;
        let (mut least, mut largest) = (first.clone(), first);
        for x in rest {
            if x < least {
                least = x;
            } else if x > largest {
                largest = x;
            }
        }
        // A right shift of a BigInt rounds down; of the negated number, up.
        Self { lo: least >> BITS, hi: -(-largest >> BITS) }
    }
}

impl<const BITS: u32> Scalar for Enclosure<BITS> {
    fn from_int(n: i32) -> Self {
        let n = BigInt::from(n) << BITS;
        Self { lo: n.clone(), hi: n }
    }
}

impl<const BITS: u32> Ordered for Enclosure<BITS> {
    /// `None` where the enclosures overlap in more than one common point.
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
