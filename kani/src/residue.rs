//! Integers modulo a power of two: a ring in which every element is tried.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Sub};

use cordon_spec::{Ordered, Scalar};

use crate::source::{Domain, Source};

/// An integer modulo 2^BITS, BITS from 1 to 8.
///
/// The protocol is defined over any commutative ring, and what is said of it without an order
/// (which values a machine reads, that a sum is kept) can be checked in a small one: all of its
/// elements at once, with narrow multipliers, and with nothing to overflow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Residue<const BITS: u32>(u8);

impl<const BITS: u32> Residue<BITS> {
    const MASK: u8 = u8::MAX >> (8 - BITS);

    fn reduced(value: u8) -> Self {
        Self(value & Self::MASK)
    }

    /// Any element; a test that tries all combinations takes those below 3.
    pub fn draw<S: Source>(source: &mut S) -> Self {
        let value = source.integer(Domain::new(0, (1 << BITS) - 1, 2.min((1 << BITS) - 1)));
        Self::from_int(value)
    }
}

impl<const BITS: u32> Add<&Self> for Residue<BITS> {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        Self::reduced(self.0.wrapping_add(other.0))
    }
}

impl<const BITS: u32> Sub<&Self> for Residue<BITS> {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        Self::reduced(self.0.wrapping_sub(other.0))
    }
}

impl<const BITS: u32> Mul<&Self> for Residue<BITS> {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        Self::reduced(self.0.wrapping_mul(other.0))
    }
}

impl<const BITS: u32> Scalar for Residue<BITS> {
    fn from_int(n: i32) -> Self {
        // Two's complement: the low bits of a negative number are those of its residue.
        Self::reduced(n.to_le_bytes()[0])
    }
}

/// Residues are equal or not; no order of theirs goes with the ring.
impl<const BITS: u32> Ordered for Residue<BITS> {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        (self == other).then_some(Ordering::Equal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_are_those_of_integers() {
        for a in -9..9 {
            for b in -9..9 {
                let (x, y) = (Residue::<4>::from_int(a), Residue::<4>::from_int(b));
                assert_eq!(x + &y, Residue::from_int(a + b));
                assert_eq!(x - &y, Residue::from_int(a - b));
                assert_eq!(x * &y, Residue::from_int(a * b));
                assert_eq!(x == y, (a - b) % 16 == 0);
            }
        }
        assert_eq!(Residue::<8>::from_int(-1), Residue::from_int(255));
    }
}
