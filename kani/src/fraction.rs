//! Fractions over powers of one common denominator, in machine integers.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Sub};

use cordon_spec::{Ordered, Scalar};

/// The fraction `numerator / base^power`.
///
/// The spec's positions are rationals. Reducing them would put a loop for the greatest common
/// divisor, whose number of rounds depends on the values, into every proof; over the weight's
/// denominator no reduction is needed: a protocol step raises the power by one. The power
/// depends on the drone and the step only, never on a drawn value, so that the loops here have
/// constant bounds for the model checker. Fractions are compared by cross-multiplication.
///
/// Two fractions that meet in an operation have the same base, or one of them has power 0. An
/// overflow panics (overflow checks are on in the model checker and in every profile of this
/// workspace's tests): that none happens in the stated ranges is part of what each harness proves.
#[derive(Clone, Copy, Debug)]
pub struct Fraction {
    numerator: i32,
    base: i32,
    power: u32,
}

impl Fraction {
    /// The quotient of two integers; the denominator is positive.
    pub fn quotient(numerator: i32, denominator: i32) -> Self {
        Self { numerator, base: denominator, power: 1 }
    }

    /// The numerator over the first power of the base: the value times the base. Of a fraction of
    /// power 0 or 1.
    pub fn over_base(self) -> i32 {
        self.raised(self.base, 1)
    }

    /// Both numerators over the higher of the two powers, with base and power.
    fn aligned(self, other: Self) -> (i32, i32, i32, u32) {
        let base = self.common_base(other);
        let power = if self.power > other.power { self.power } else { other.power };
        (self.raised(base, power), other.raised(base, power), base, power)
    }

    /// The numerator over `base^power`; no iterator, whose parts the model checker would unroll.
    fn raised(self, base: i32, power: u32) -> i32 {
        let mut numerator = self.numerator;
        let mut at = self.power;
        while at < power {
            numerator *= base;
            at += 1;
        }
        numerator
    }

    /// The base of whichever has a denominator.
    fn common_base(self, other: Self) -> i32 {
        assert!(self.power == 0 || other.power == 0 || self.base == other.base);
        if self.power > 0 { self.base } else { other.base }
    }
}

impl Add<&Self> for Fraction {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        let (a, b, base, power) = self.aligned(*other);
        Self { numerator: a + b, base, power }
    }
}

impl Sub<&Self> for Fraction {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        let (a, b, base, power) = self.aligned(*other);
        Self { numerator: a - b, base, power }
    }
}

impl Mul<&Self> for Fraction {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        Self {
            numerator: self.numerator * other.numerator,
            base: self.common_base(*other),
            power: self.power + other.power,
        }
    }
}

impl Scalar for Fraction {
    fn from_int(n: i32) -> Self {
        Self { numerator: n, base: 1, power: 0 }
    }
}

impl Ordered for Fraction {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        let (a, b, ..) = self.aligned(*other);
        Some(a.cmp(&b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half() -> Fraction {
        Fraction::quotient(1, 2)
    }

    #[test]
    fn operations_are_those_of_fractions() {
        let three = Fraction::from_int(3);
        let sum = half() + &three;
        assert_eq!(sum.compare(&Fraction::quotient(7, 2)), Some(Ordering::Equal));
        let difference = three - &half();
        assert_eq!(difference.compare(&Fraction::quotient(5, 2)), Some(Ordering::Equal));
        let product = half() * &half() * &three;
        assert_eq!(product.power, 2);
        assert_eq!((product + &product).compare(&Fraction::quotient(3, 2)), Some(Ordering::Equal));
        assert_eq!(half().compare(&three), Some(Ordering::Less));
        assert_eq!(three.compare(&half()), Some(Ordering::Greater));
    }

    #[test]
    #[should_panic = "overflow"]
    fn an_overflow_is_never_silent() {
        let _ = Fraction::from_int(i32::MAX) + &half();
    }

    #[test]
    #[should_panic]
    fn two_bases_do_not_mix() {
        let _ = half() + &Fraction::quotient(1, 3);
    }
}
