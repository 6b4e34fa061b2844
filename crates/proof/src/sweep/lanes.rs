//! Several starts in one: a number of each, side by side.
//!
//! Sums, differences and products are taken of all at once, which a compiler turns into vector
//! instructions. The order of two such numbers is known where it is the same in every lane. The
//! predicates of `cordon_spec` allow for an order that is not known, and are `Undecided` then:
//! what they say of lanes otherwise is so of each of them.
//!
//! Integers of up to 53 bits are kept as doubles, which hold them exactly: sums and products in
//! that range are not rounded, and processors multiply doubles several times as fast as they
//! multiply integers of 64 bits.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use cordon_spec::{Ordered, Scalar};
use num_bigint::BigInt;

use super::machine::Machine;

/// Number of lanes: long enough that what is done once for all of them does not count.
pub const LANES: usize = 32;

/// How many comparisons are gathered before they are looked at.
const GATHERED: usize = 16;

/// A number for each lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<T>(pub [T; LANES]);

/// A number of a lane.
pub trait Number: Copy + Send + Sync {
    /// The number; the range of what is passed is proved.
    fn of(x: i64) -> Self;

    /// The integer that it is.
    fn whole(self) -> i64;
}

/// Operations on all lanes of numbers `$t`, comparisons of which are kept in a `$mask`. Nothing
/// wraps and nothing is rounded: the range of every number is proved before lanes are used.
macro_rules! lanes {
    ($t:ty, $mask:ty, $bits:expr, $add:expr, $sub:expr, $mul:expr) => {
        impl Number for $t {
            #[inline(always)]
            fn of(x: i64) -> Self {
                x as Self
            }

            #[inline(always)]
            fn whole(self) -> i64 {
                self as i64
            }
        }

        impl Add<&Self> for Lanes<$t> {
            type Output = Self;

            #[inline(always)]
            fn add(mut self, rhs: &Self) -> Self {
                for (a, b) in self.0.iter_mut().zip(&rhs.0) {
                    *a = $add(*a, *b);
                }
                self
            }
        }

        impl Sub<&Self> for Lanes<$t> {
            type Output = Self;

            #[inline(always)]
            fn sub(mut self, rhs: &Self) -> Self {
                for (a, b) in self.0.iter_mut().zip(&rhs.0) {
                    *a = $sub(*a, *b);
                }
                self
            }
        }

        impl Mul<&Self> for Lanes<$t> {
            type Output = Self;

            #[inline(always)]
            fn mul(mut self, rhs: &Self) -> Self {
                for (a, b) in self.0.iter_mut().zip(&rhs.0) {
                    *a = $mul(*a, *b);
                }
                self
            }
        }

        impl Scalar for Lanes<$t> {
            #[inline(always)]
            fn from_int(n: i32) -> Self {
                Self([n as $t; LANES])
            }

            #[inline(always)]
            fn from_index(i: usize) -> Self {
                Self([i as $t; LANES])
            }
        }

        impl Lanes<$t> {
            /// Whether something is so in every lane.
            #[inline(always)]
            fn all(&self, other: &Self, holds: impl Fn($t, $t) -> bool) -> bool {
                // As masks, without a branch.
                let mut all = [-1; GATHERED];
                let parts = self.0.chunks_exact(GATHERED).zip(other.0.chunks_exact(GATHERED));
                for (a, b) in parts {
                    for ((all, a), b) in all.iter_mut().zip(a).zip(b) {
                        *all &= -<$mask>::from(holds(*a, *b));
                    }
                }
                all.iter().fold(-1, |all, mask| all & mask) != 0
            }

            /// The order of two that are not less in every lane. Apart, so that the usual case
            /// does not pay for it.
            #[inline(never)]
            fn not_less(&self, other: &Self) -> Option<Ordering> {
                if self.0[0] == other.0[0] {
                    self.all(other, |a, b| a == b).then_some(Ordering::Equal)
                } else {
                    self.all(other, |a, b| a > b).then_some(Ordering::Greater)
                }
            }
        }

        impl Ordered for Lanes<$t> {
            #[inline(always)]
            fn compare(&self, other: &Self) -> Option<Ordering> {
                if self.all(other, |a, b| a < b) {
                    Some(Ordering::Less)
                } else {
                    self.not_less(other)
                }
            }
        }

        impl Machine for Lanes<$t> {
            const MAGNITUDE_BITS: Option<u64> = Some($bits);
            const VECTOR: bool = true;

            type Weight = $t;

            fn from_i64(x: i64) -> Self {
                Self([<$t>::of(x); LANES])
            }

            fn narrow(x: &BigInt) -> Option<Self> {
                Self::weight(x).map(|x| Self([x; LANES]))
            }

            fn weight(x: &BigInt) -> Option<$t> {
                if x.bits() > $bits {
                    return None;
                }
                i64::try_from(x).ok().map(<$t>::of)
            }

            #[inline(always)]
            fn weigh<const T: usize>(terms: [(&$t, &Self); T]) -> Self {
                Self(std::array::from_fn(|l| {
                    let mut terms = terms.iter().map(|(w, x)| $mul(**w, x.0[l]));
                    let first = terms.next().unwrap_or_default();
                    terms.fold(first, |sum, term| $add(sum, term))
                }))
            }
        }
    };
}

lanes!(i32, i32, 31, i32::wrapping_add, i32::wrapping_sub, i32::wrapping_mul);
lanes!(f64, i64, 53, |a: f64, b| a + b, |a: f64, b| a - b, |a: f64, b| a * b);
lanes!(i64, i64, 63, i64::wrapping_add, i64::wrapping_sub, i64::wrapping_mul);

#[cfg(test)]
mod tests {
    use super::*;

    fn from(f: impl Fn(i64) -> i64) -> Lanes<i64> {
        Lanes(std::array::from_fn(|l| f(l as i64)))
    }

    /// The laws of one kind of lanes, on numbers that it holds.
    fn each_lane_is_by_itself<T: Number>()
    where
        Lanes<T>: Machine<Weight = T>,
    {
        let (a, b) = (from(|l| 3 * l - 20), from(|l| 11 - l * l));
        let (x, y) = (Lanes(a.0.map(T::of)), Lanes(b.0.map(T::of)));
        let whole = |x: Lanes<T>| Lanes(x.0.map(T::whole));
        assert_eq!(whole(x + &y), from(|l| 3 * l - 20 + 11 - l * l));
        assert_eq!(whole(x - &y), from(|l| 3 * l - 20 - 11 + l * l));
        assert_eq!(whole(x * &y), from(|l| (3 * l - 20) * (11 - l * l)));
        let weighed = Lanes::<T>::weigh([(&T::of(-5), &x), (&T::of(7), &y)]);
        assert_eq!(whole(weighed), from(|l| -5 * (3 * l - 20) + 7 * (11 - l * l)));
        let one = Lanes::<T>::from_int(1);
        assert_eq!(x.compare(&(x + &one)), Some(Ordering::Less));
        assert_eq!(x.compare(&x), Some(Ordering::Equal));
        assert_eq!((x + &one).compare(&x), Some(Ordering::Greater));
        for odd in 0..LANES {
            for by in [0, -1, 1] {
                let mut other = x + &Lanes::from_int(1 - i32::abs(by));
                other.0[odd] = T::of(a.0[odd] + i64::from(by));
                assert_eq!(x.compare(&other), None, "{odd} {by}");
            }
        }
    }

    #[test]
    fn every_kind_has_the_arithmetic_and_the_order_of_each_lane() {
        each_lane_is_by_itself::<i32>();
        each_lane_is_by_itself::<f64>();
        each_lane_is_by_itself::<i64>();
    }

    #[test]
    fn weights_are_refused_where_their_range_ends() {
        let edge = |bits: u32| (BigInt::from(1) << bits) - 1;
        for sign in [1, -1] {
            assert_eq!(Lanes::<i32>::weight(&(edge(31) * sign)), Some(i32::MAX * sign));
            assert_eq!(Lanes::<i32>::weight(&((edge(31) + 1) * sign)), None);
            let largest = 9_007_199_254_740_991.0;
            assert_eq!(Lanes::<f64>::weight(&(edge(53) * sign)), Some(largest * f64::from(sign)));
            assert_eq!(Lanes::<f64>::weight(&((edge(53) + 1) * sign)), None);
            assert_eq!(Lanes::<i64>::weight(&(edge(63) * sign)), Some(i64::MAX * i64::from(sign)));
            assert_eq!(Lanes::<i64>::weight(&((edge(63) + 1) * sign)), None);
        }
    }
}
