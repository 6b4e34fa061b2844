//! How many factors below 1 it takes.

use num_bigint::BigInt;
use num_traits::One;

use cordon_core::Rational;

/// Which way powers are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// The k found is enough.
    Up,
    /// No smaller k than the one found is enough.
    Down,
}

/// The least k with factor^k <= target up to rounding; 0 <= factor < 1, target > 0.
pub fn least_power_at_most(factor: &Rational, target: &Rational, rounding: Rounding) -> u64 {
    if *target >= Rational::one() {
        return 0;
    }
    // Fixed point with enough bits for the target.
    let bits = 128 + target.denom().bits();
    let scale = Rational::from_integer(BigInt::one() << bits);
    let (fixed, target) = match rounding {
        Rounding::Up => ((factor * &scale).ceil(), (target * &scale).floor()),
        Rounding::Down => ((factor * &scale).floor(), (target * &scale).ceil()),
    };
    let (fixed, target) = (fixed.to_integer(), target.to_integer());
    let times = |a: &BigInt, b: &BigInt| match rounding {
        Rounding::Up => -(-(a * b) >> bits),
        Rounding::Down => (a * b) >> bits,
    };
    // Squares up to the first that is not above the target, then down the binary digits of the
    // largest exponent whose power is above it.
    let mut squares = vec![fixed];
    while let Some(last) = squares.last().filter(|&last| *last > target && squares.len() < 63) {
        squares.push(times(last, last));
    }
    let (mut power, mut k) = (scale.to_integer(), 0_u64);
    for (digit, square) in squares.iter().enumerate().rev() {
        let next = times(&power, square);
        if next > target {
            power = next;
            k += 1 << digit;
        }
    }
    k + 1
}
