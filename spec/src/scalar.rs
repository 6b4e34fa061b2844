//! What positions and weights are made of.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Sub};

#[cfg(feature = "contracts")]
use crate::model::*;

/// A commutative ring with embedded integers: all that the protocol's update needs.
///
/// Exact rationals, integers, a prime field and polynomials are such rings. Intervals and
/// floating-point numbers implement the trait too; for them the ring laws hold only up to
/// enclosure or rounding, and what they compute is evidence of that kind.
pub trait Scalar:
    Clone
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
{
    /// The real number that the contracts take this scalar for.
    #[cfg(feature = "contracts")]
    #[logic]
    fn model(self) -> Real;

    /// The ring element `1 + ... + 1` (`n` times; negated for `n < 0`).
    #[cfg_attr(feature = "contracts", ensures(result.model() == int(n@)))]
    fn from_int(n: i32) -> Self;

    /// The ring element of an index or a count.
    #[cfg_attr(feature = "contracts", requires(exact::<Self>()), ensures(result.model() == int(i@)))]
    fn from_index(i: usize) -> Self {
        match i32::try_from(i) {
            Ok(n) => Self::from_int(n),
            // Halving ends: i32 holds every index below 2^31.
            Err(_) => {
                let half = Self::from_index(i / 2);
                half.clone() + &half + &Self::from_int((i % 2) as i32)
            }
        }
    }
}

/// A scalar whose elements can be compared: needed by the theorems, never by the protocol.
pub trait Ordered: Scalar {
    /// The order of `self` and `other`, or `None` where it is not known (overlapping
    /// intervals, an overflowed fraction). Total for exact scalars.
    #[cfg_attr(feature = "contracts", ensures(forall<o> result == Some(o) ==> o == self.model().cmp_log(other.model())))]
    fn compare(&self, other: &Self) -> Option<Ordering>;
}

/// Machine integers: exact while every value stays in range, which the caller has to
/// establish (an overflow is never meant; it panics wherever overflow checks are on).
macro_rules! integer_scalar {
    ($($t:ty),*) => {$(
        impl Scalar for $t {
            #[cfg(feature = "contracts")]
            #[logic(open)]
            fn model(self) -> Real {
                int(View::view(self))
            }

            #[cfg_attr(feature = "contracts", ensures(result.model() == int(n@)))]
            fn from_int(n: i32) -> Self {
                <$t>::from(n)
            }
        }

        impl Ordered for $t {
            #[cfg_attr(feature = "contracts", ensures(forall<o> result == Some(o) ==> o == self.model().cmp_log(other.model())))]
            fn compare(&self, other: &Self) -> Option<Ordering> {
                Some(self.cmp(other))
            }
        }
    )*};
}

integer_scalar!(i32, i64, i128);

#[cfg(feature = "rational")]
integer_scalar!(num_bigint::BigInt);

#[cfg(feature = "rational")]
impl Scalar for num_rational::BigRational {
    fn from_int(n: i32) -> Self {
        Self::from_integer(n.into())
    }
}

#[cfg(feature = "rational")]
impl Ordered for num_rational::BigRational {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
