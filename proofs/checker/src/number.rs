//! Exact rationals that count the work done on them: the one bound on the time of a check.

use std::cell::Cell;
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Sub};

use cordon_spec::{Ordered, Scalar};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use crate::fault::{Result, ensure};

type Rational = num_rational::BigRational;

/// Work allowed a file: 128 an operation on short numbers or a name read, more as [`charge`]'s callers say.
pub const MAX_WORK: u64 = 1 << 27;

/// Longest number of a file, in characters. Room for fractions of 1,000 digits, the finest
/// bracket of a critical eps that `cordon threshold` gives.
pub const MAX_NUMBER: usize = 2_100;

thread_local! {
    static LEFT: Cell<u64> = const { Cell::new(MAX_WORK) };
}

/// Starts a check: all work is left.
pub fn refill() {
    LEFT.set(MAX_WORK);
}

/// Work that was done, up to [`MAX_WORK`].
pub fn done() -> u64 {
    MAX_WORK - LEFT.get()
}

/// Whether no work is left.
pub fn exhausted() -> bool {
    LEFT.get() == 0
}

/// Counts some work; whether it is allowed.
pub fn charge(work: u64) -> bool {
    LEFT.set(LEFT.get().saturating_sub(work));
    LEFT.get() > 0
}

/// Counts some work.
///
/// # Errors
/// It is more than is allowed.
pub fn spend(work: u64) -> Result<()> {
    ensure!(charge(work), "work", "more than a file is allowed");
    Ok(())
}

/// An exact rational. Once no work is left every result is 0, whatever the operands: whoever
/// judges by such numbers has to ask [`exhausted`] before believing them.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Number(Rational);

impl Number {
    /// Reads `7` or `-3/4`: nothing else has the one form in which it prints.
    ///
    /// # Errors
    /// No such number.
    pub fn read(text: &str) -> std::result::Result<Self, String> {
        let (num, den) = text.split_once('/').unwrap_or((text, "1"));
        let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
        let short = text.len() <= MAX_NUMBER && charge((text.len() as u64 / 64).pow(2));
        if !short || !digits(num.strip_prefix('-').unwrap_or(num)) || !digits(den) {
            return Err(format!(
                "`{text:.40}`: expected an integer or a fraction like `-3/4`, of at most {MAX_NUMBER} characters"
            ));
        }
        let parse = |t: &str| t.parse::<BigInt>().map_err(|e| format!("`{text:.40}`: {e}"));
        let (num, den) = (parse(num)?, parse(den)?);
        if den.is_zero() {
            return Err(format!("`{text:.40}` divides by zero"));
        }
        let value = Rational::new(num, den);
        match value.to_string() == text {
            true => Ok(Self(value)),
            false => Err(format!("`{text:.40}` is not in lowest terms")),
        }
    }

    /// The integer n.
    pub fn whole(n: i64) -> Self {
        Self(Rational::from_integer(n.into()))
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// Whether it is above 0.
    pub fn is_positive(&self) -> bool {
        self.0.is_positive()
    }

    /// Whether it is an integer.
    pub fn is_integer(&self) -> bool {
        self.0.is_integer()
    }

    /// The value without its sign.
    pub fn magnitude(&self) -> Self {
        Self(self.0.abs())
    }

    /// The quotient; nothing where it divides by zero.
    pub fn over(&self, other: &Self) -> Option<Self> {
        (!other.is_zero()).then(|| self.charged(other, || &self.0 / &other.0))
    }

    /// The quotient of integers that is one, `other` not being 0.
    pub fn divided(&self, other: &Self) -> Self {
        self.charged(other, || Rational::from_integer(self.0.numer() / other.0.numer()))
    }

    /// The denominator in lowest terms.
    pub fn denominator(&self) -> Self {
        Self(Rational::from_integer(self.0.denom().clone()))
    }

    /// What an operation on the two costs: fractions more, since common divisors are sought bit by bit.
    fn cost(&self, other: &Self) -> u64 {
        let bits = |x: &Self| x.0.numer().bits() + x.0.denom().bits();
        let words = (bits(self) + bits(other)) / 64;
        match self.is_integer() && other.is_integer() {
            true => 128 + words * words / 8,
            false => 256 + 192 * words + words * words,
        }
    }

    fn charged(&self, other: &Self, result: impl FnOnce() -> Rational) -> Self {
        Self(if charge(self.cost(other)) { result() } else { Rational::zero() })
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

macro_rules! operations {
    ($($name:ident $method:ident $op:tt;)*) => {$(
        impl $name for &Number {
            type Output = Number;
            fn $method(self, other: Self) -> Number {
                let whole = self.0.is_integer() && other.0.is_integer();
                // Without denominators there is nothing to reduce.
                let short = || Rational::from_integer(self.0.numer() $op other.0.numer());
                self.charged(other, || if whole { short() } else { &self.0 $op &other.0 })
            }
        }

        impl $name<&Self> for Number {
            type Output = Self;
            fn $method(self, other: &Self) -> Self {
                &self $op other
            }
        }
    )*};
}
operations! { Add add +; Sub sub -; Mul mul *; }

impl Scalar for Number {
    fn from_int(n: i32) -> Self {
        Self::whole(n.into())
    }
}

impl Ordered for Number {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        charge(self.cost(other)).then(|| self.cmp(other))
    }
}
