//! Integers that are machine words as long as they fit one.

use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};

/// An integer. The representation is unique: what fits 64 bits is `Small`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Int {
    Small(i64),
    Big(BigInt),
}

impl Int {
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Small(0))
    }

    pub fn is_positive(&self) -> bool {
        match self {
            Self::Small(x) => *x > 0,
            Self::Big(x) => x.sign() == Sign::Plus,
        }
    }

    pub fn is_negative(&self) -> bool {
        !self.is_zero() && !self.is_positive()
    }

    /// The cost of computing it, roughly in operations on machine words: a big integer is allocated,
    /// and reduced by common divisors in time quadratic in its length.
    pub fn work(&self) -> u64 {
        match self {
            Self::Small(_) => 1,
            Self::Big(x) => {
                let words = x.bits().div_ceil(64);
                words.saturating_mul(40 + 6 * words)
            }
        }
    }

    /// The number as a big integer.
    pub fn to_big(&self) -> BigInt {
        match self {
            Self::Small(x) => (*x).into(),
            Self::Big(x) => x.clone(),
        }
    }

    pub fn negated(&self) -> Self {
        match self {
            Self::Small(x) => (-i128::from(*x)).into(),
            Self::Big(x) => (-x).into(),
        }
    }

    /// The determinant a*b - c*d, in machine words where it fits.
    pub fn determinant(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        if let (Self::Small(a), Self::Small(b), Self::Small(c), Self::Small(d)) = (a, b, c, d) {
            // Each product is at most 2^126 in magnitude.
            let [a, b, c, d] = [a, b, c, d].map(|x| i128::from(*x));
            if let Some(x) = (a * b).checked_sub(c * d) {
                return x.into();
            }
        }
        let product = |x: &Self, y: &Self| x.to_big() * y.to_big();
        match (a.is_zero() || b.is_zero(), c.is_zero() || d.is_zero()) {
            (true, true) => Self::Small(0),
            (true, false) => (-product(c, d)).into(),
            (false, true) => product(a, b).into(),
            (false, false) => (product(a, b) - product(c, d)).into(),
        }
    }

    /// How a*b compares with c*d.
    pub fn compare_products(a: &Self, b: &Self, c: &Self, d: &Self) -> Ordering {
        let difference = Self::determinant(a, b, c, d);
        if difference.is_zero() {
            Ordering::Equal
        } else if difference.is_positive() {
            Ordering::Greater
        } else {
            Ordering::Less
        }
    }

    /// The greatest common divisor, not negative.
    pub fn gcd(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Small(a), Self::Small(b)) => i128::from(*a).gcd(&i128::from(*b)).into(),
            (Self::Small(0), Self::Big(x)) | (Self::Big(x), Self::Small(0)) => x.abs().into(),
            // One division reduces the other to a machine word.
            (Self::Small(a), Self::Big(x)) | (Self::Big(x), Self::Small(a)) => {
                Self::from(x % *a).gcd(&Self::Small(*a))
            }
            (Self::Big(a), Self::Big(b)) => {
                match (a.magnitude().to_u128(), b.magnitude().to_u128()) {
                    (Some(a), Some(b)) => BigInt::from(a.gcd(&b)).into(),
                    _ => a.gcd(b).into(),
                }
            }
        }
    }

    /// The quotient by a divisor of this number, not zero.
    pub fn divided(&self, by: &Self) -> Self {
        match (self, by) {
            (Self::Small(a), Self::Small(b)) => (i128::from(*a) / i128::from(*b)).into(),
            (a, b) => (a.to_big() / b.to_big()).into(),
        }
    }
}

impl From<i128> for Int {
    fn from(x: i128) -> Self {
        i64::try_from(x).map_or_else(|_| Self::Big(x.into()), Self::Small)
    }
}

impl From<BigInt> for Int {
    fn from(x: BigInt) -> Self {
        if x.is_zero() { Self::Small(0) } else { x.to_i64().map_or(Self::Big(x), Self::Small) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_is_that_of_big_integers_across_the_edges() {
        let mut samples: Vec<BigInt> = Vec::new();
        for edge in [0, 6, 1 << 40, i128::from(i64::MAX), i128::from(i64::MIN), i128::MAX] {
            samples.extend([-1, 0, 1].map(|d| BigInt::from(edge) + d));
        }
        let mut ran = 0;
        for a in &samples {
            for b in &samples {
                let (x, y) = (Int::from(a.clone()), Int::from(b.clone()));
                assert_eq!(x.gcd(&y).to_big(), a.gcd(b));
                assert_eq!(x.negated().to_big(), -a);
                if !b.is_zero() && (a % b).is_zero() {
                    assert_eq!(x.divided(&y).to_big(), a / b);
                }
                for c in &samples {
                    let z = Int::from(c.clone());
                    let wanted = a * b - c * a;
                    let got = Int::determinant(&x, &y, &z, &x);
                    assert_eq!(got, Int::from(wanted.clone()));
                    assert_eq!(matches!(got, Int::Small(_)), wanted.to_i64().is_some());
                    assert_eq!(Int::compare_products(&x, &y, &z, &x), (a * b).cmp(&(c * a)));
                    ran += 1;
                }
            }
        }
        assert_eq!(ran, 18 * 18 * 18);
    }
}
