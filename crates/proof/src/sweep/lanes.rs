//! Several starts in one: a machine integer of each, side by side.
//!
//! Sums, differences and products are taken of all at once, which a compiler turns into vector
//! instructions. The order of two such numbers is known where it is the same in every lane. The
//! predicates of `cordon_spec` allow for an order that is not known, and are `Undecided` then:
//! what they say of lanes otherwise is so of each of them.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use cordon_spec::{Ordered, Scalar};
use num_bigint::BigInt;

use super::machine::{Machine, Widened};

/// Number of lanes: four or eight vectors of 128 bits, two or four of 256.
pub const LANES: usize = 16;

/// A number for each lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lanes<T>(pub [T; LANES]);

/// Nothing wraps: the range of every number is proved before lanes are used.
macro_rules! lanes {
    ($t:ty, $bits:expr) => {
        impl Add<&Self> for Lanes<$t> {
            type Output = Self;

            #[inline(always)]
            fn add(mut self, rhs: &Self) -> Self {
                for (a, b) in self.0.iter_mut().zip(&rhs.0) {
                    *a = a.wrapping_add(*b);
                }
                self
            }
        }

        impl Sub<&Self> for Lanes<$t> {
            type Output = Self;

            #[inline(always)]
            fn sub(mut self, rhs: &Self) -> Self {
                for (a, b) in self.0.iter_mut().zip(&rhs.0) {
                    *a = a.wrapping_sub(*b);
                }
                self
            }
        }

        impl Mul<&Self> for Lanes<$t> {
            type Output = Self;

            #[inline(always)]
            fn mul(mut self, rhs: &Self) -> Self {
                for (a, b) in self.0.iter_mut().zip(&rhs.0) {
                    *a = a.wrapping_mul(*b);
                }
                self
            }
        }

        impl Scalar for Lanes<$t> {
            #[inline(always)]
            fn from_int(n: i32) -> Self {
                Self([n.into(); LANES])
            }
        }

        impl Lanes<$t> {
            /// Whether something is so in every lane.
            #[inline(always)]
            fn all(&self, other: &Self, holds: impl Fn($t, $t) -> bool) -> bool {
                // As masks, without a branch.
                let masks = self.0.iter().zip(&other.0).map(|(a, b)| -<$t>::from(holds(*a, *b)));
                masks.fold(-1, |all, mask| all & mask) != 0
            }
        }

        impl Ordered for Lanes<$t> {
            #[inline(always)]
            fn compare(&self, other: &Self) -> Option<Ordering> {
                if self.all(other, |a, b| a < b) {
                    Some(Ordering::Less)
                } else if self.all(other, |a, b| a == b) {
                    Some(Ordering::Equal)
                } else if self.all(other, |a, b| a > b) {
                    Some(Ordering::Greater)
                } else {
                    None
                }
            }
        }

        impl Machine for Lanes<$t> {
            const MAGNITUDE_BITS: Option<u64> = Some($bits);

            fn from_i64(x: i64) -> Self {
                Self([x as $t; LANES])
            }

            fn narrow(x: &BigInt) -> Option<Self> {
                Some(Self([<$t>::try_from(x).ok()?; LANES]))
            }
        }
    };
}

lanes!(i32, 31);
lanes!(i64, 63);

impl Widened<Lanes<i32>> for Lanes<i64> {
    fn widened(x: &Lanes<i32>) -> Self {
        Self(x.0.map(i64::from))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn from(f: impl Fn(i64) -> i64) -> Lanes<i64> {
        Lanes(std::array::from_fn(|l| f(l as i64)))
    }

    #[test]
    fn an_order_is_that_of_every_lane() {
        let x = from(|l| l * l - 7);
        let one = Lanes::<i64>::from_int(1);
        assert_eq!(x.compare(&(x + &one)), Some(Ordering::Less));
        assert_eq!(x.compare(&x), Some(Ordering::Equal));
        assert_eq!((x + &one).compare(&x), Some(Ordering::Greater));
        for odd in 0..LANES {
            for by in [0i32, -1, 1] {
                let mut other = x + &Lanes::from_int(1 - by.abs());
                other.0[odd] = x.0[odd] + i64::from(by);
                assert_eq!(x.compare(&other), None, "{odd} {by}");
            }
        }
    }

    #[test]
    fn each_lane_has_arithmetic_of_its_own() {
        let (a, b) = (from(|l| 3 * l - 20), from(|l| 11 - l * l));
        for l in 0..LANES {
            assert_eq!((a + &b).0[l], a.0[l] + b.0[l]);
            assert_eq!((a - &b).0[l], a.0[l] - b.0[l]);
            assert_eq!((a * &b).0[l], a.0[l] * b.0[l]);
        }
        let narrow = Lanes(std::array::from_fn(|l| l as i32 - 5));
        assert_eq!(Lanes::<i64>::widened(&narrow), from(|l| l - 5));
        let edge = BigInt::from(i32::MIN);
        assert!(Lanes::<i32>::narrow(&edge).is_some());
        assert!(Lanes::<i32>::narrow(&(edge - 1)).is_none());
    }
}
