//! Fractions of machine integers that know when they have overflowed.

use std::cmp::Ordering;

use cordon_spec::{Ordered, Scalar};
use num_integer::Integer;

use super::ring_operators;

/// A fraction of 128-bit integers in lowest terms, exact or overflowed; overflow is absorbing
/// and compares with nothing, so it is never silent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fraction(Option<(i128, i128)>);

impl Fraction {
    /// `num/den`; overflowed where `den` is 0 or lowest terms do not fit.
    pub fn new(num: i128, den: i128) -> Self {
        Self(lowest(num, den))
    }

    /// Numerator and positive denominator in lowest terms, or `None` after an overflow.
    pub fn parts(self) -> Option<(i128, i128)> {
        self.0
    }
}

fn lowest(num: i128, den: i128) -> Option<(i128, i128)> {
    // The least integer has no absolute value in range; excluding it keeps `gcd` and the
    // negations below in range.
    if den == 0 || num == i128::MIN || den == i128::MIN {
        return None;
    }
    let g = num.gcd(&den) * den.signum();
    Some((num / g, den / g))
}

/// `a + sign*b`.
fn sum(a: Fraction, b: &Fraction, sign: i128) -> Fraction {
    let added = || {
        let ((an, ad), (bn, bd)) = (a.0?, b.0?);
        let g = ad.gcd(&bd);
        let (a_scale, b_scale) = (bd / g, ad / g);
        let left = an.checked_mul(a_scale)?;
        let right = bn.checked_mul(b_scale)?.checked_mul(sign)?;
        lowest(left.checked_add(right)?, ad.checked_mul(a_scale)?)
    };
    Fraction(added())
}

fn product(a: Fraction, b: &Fraction) -> Fraction {
    let multiplied = || {
        let ((an, ad), (bn, bd)) = (a.0?, b.0?);
        // Crosswise reduction first, so that only a result out of range overflows.
        let ((an, bd), (bn, ad)) = (lowest(an, bd)?, lowest(bn, ad)?);
        lowest(an.checked_mul(bn)?, ad.checked_mul(bd)?)
    };
    Fraction(multiplied())
}

ring_operators!(
    Fraction,
    |a, b: &Fraction| sum(a, b, 1),
    |a, b: &Fraction| sum(a, b, -1),
    |a, b: &Fraction| product(a, b)
);

impl Scalar for Fraction {
    fn from_int(n: i32) -> Self {
        Self(Some((n.into(), 1)))
    }
}

impl Ordered for Fraction {
    /// `None` where a side has overflowed, or the cross products would.
    fn compare(&self, other: &Self) -> Option<Ordering> {
        let ((an, ad), (bn, bd)) = (self.0?, other.0?);
        Some(an.checked_mul(bd)?.cmp(&bn.checked_mul(ad)?))
    }
}
