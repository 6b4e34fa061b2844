//! Integers of the sweep kernel: fixed widths whose range is proved before they are used (see
//! [`super::range`]), up to 64 bits for several starts at once ([`super::lanes`]), and big
//! integers beyond.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use cordon_spec::{Ordered, Scalar};
use ethnum::I256;
use num_bigint::BigInt;

/// An integer type that the kernel can run on.
pub trait Machine: Ordered + Send + Sync {
    /// Largest number of bits that a magnitude may have; `None` where there is no limit.
    const MAGNITUDE_BITS: Option<u64>;

    /// Whether it stands for several starts, which vector instructions serve at once.
    const VECTOR: bool = false;

    /// A weight of the step: the same for all starts.
    type Weight: Clone + Send + Sync;

    /// The number; the range of what is passed is proved.
    fn from_i64(x: i64) -> Self;

    /// The number, where it is in range.
    fn narrow(x: &BigInt) -> Option<Self>;

    /// The weight, where it is in range.
    fn weight(x: &BigInt) -> Option<Self::Weight>;

    /// The sum of weights times positions.
    fn weigh<const T: usize>(terms: [(&Self::Weight, &Self); T]) -> Self;
}

/// A number for one start, whose weights are such numbers.
macro_rules! single {
    () => {
        type Weight = Self;

        fn from_i64(x: i64) -> Self {
            x.into()
        }

        fn weight(x: &BigInt) -> Option<Self> {
            Self::narrow(x)
        }

        #[inline(always)]
        fn weigh<const T: usize>(terms: [(&Self, &Self); T]) -> Self {
            let mut terms = terms.into_iter().map(|(w, x)| w.clone() * x);
            let first = terms.next().unwrap_or_else(|| Self::from_int(0));
            terms.fold(first, |sum, term| sum + &term)
        }
    };
}

impl Machine for i128 {
    const MAGNITUDE_BITS: Option<u64> = Some(127);

    single!();

    fn narrow(x: &BigInt) -> Option<Self> {
        Self::try_from(x).ok()
    }
}

impl Machine for BigInt {
    const MAGNITUDE_BITS: Option<u64> = None;

    single!();

    fn narrow(x: &BigInt) -> Option<Self> {
        Some(x.clone())
    }
}

/// A signed integer of 256 bits: enough for squared errors over q^k up to q = 12, k = 30.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wide(I256);

impl From<i64> for Wide {
    fn from(x: i64) -> Self {
        Self(x.into())
    }
}

impl Add<&Self> for Wide {
    type Output = Self;

    fn add(self, rhs: &Self) -> Self {
        Self(self.0 + rhs.0)
    }
}

impl Sub<&Self> for Wide {
    type Output = Self;

    fn sub(self, rhs: &Self) -> Self {
        Self(self.0 - rhs.0)
    }
}

impl Mul<&Self> for Wide {
    type Output = Self;

    fn mul(self, rhs: &Self) -> Self {
        Self(self.0 * rhs.0)
    }
}

impl Scalar for Wide {
    fn from_int(n: i32) -> Self {
        Self(n.into())
    }
}

impl Ordered for Wide {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        Some(self.0.cmp(&other.0))
    }
}

impl Machine for Wide {
    const MAGNITUDE_BITS: Option<u64> = Some(255);

    single!();

    fn narrow(x: &BigInt) -> Option<Self> {
        let bytes = x.to_signed_bytes_le();
        let fill = if x.sign() == num_bigint::Sign::Minus { 0xff } else { 0 };
        let mut whole = [fill; 32];
        whole.get_mut(..bytes.len())?.copy_from_slice(&bytes);
        Some(Self(I256::from_le_bytes(whole)))
    }
}

impl From<&i128> for Wide {
    fn from(x: &i128) -> Self {
        Self((*x).into())
    }
}

impl From<&Wide> for BigInt {
    fn from(x: &Wide) -> Self {
        Self::from_signed_bytes_le(&x.0.to_le_bytes())
    }
}

#[cfg(test)]
mod tests {
    use num_traits::{One, Pow};

    use super::*;

    #[test]
    fn wide_holds_exactly_256_bits() {
        let top: BigInt = BigInt::from(2).pow(255u32) - 1;
        let bottom: BigInt = -BigInt::from(2).pow(255u32);
        for x in [&top, &bottom, &BigInt::one(), &-BigInt::one(), &BigInt::from(-128)] {
            assert_eq!(Wide::narrow(x).map(|w| BigInt::from(&w)), Some(x.clone()));
        }
        assert_eq!(Wide::narrow(&(top + 1)), None);
        assert_eq!(Wide::narrow(&(bottom - 1)), None);
    }

    #[test]
    fn wide_arithmetic_is_that_of_big_integers() {
        let samples: Vec<BigInt> =
            [1i128, -1, 7, i128::from(i64::MAX), i128::MIN, i128::MAX].map(BigInt::from).to_vec();
        for a in &samples {
            for b in &samples {
                let (Some(x), Some(y)) = (Wide::narrow(a), Wide::narrow(b)) else {
                    unreachable!("in range")
                };
                assert_eq!(BigInt::from(&(x + &y)), a + b);
                assert_eq!(BigInt::from(&(x - &y)), a - b);
                assert_eq!(BigInt::from(&(x * &y)), a * b);
                assert_eq!(x.compare(&y), Some(a.cmp(b)));
            }
        }
    }
}
