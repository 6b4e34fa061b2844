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

/// Most binary digits of a k that is found.
const DIGITS: usize = 63;

/// The least k with factor^k <= target up to rounding; 0 <= factor < 1, target > 0. Where it has
/// more than 63 binary digits: no smaller one than 2^63 is enough, and none is known that is.
pub fn least_power_at_most(
    factor: &Rational,
    target: &Rational,
    rounding: Rounding,
) -> Option<u64> {
    if *target >= Rational::one() {
        return Some(0);
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
    while let Some(last) = squares.last().filter(|&last| *last > target && squares.len() < DIGITS) {
        squares.push(times(last, last));
    }
    if rounding == Rounding::Up && squares.last().is_some_and(|last| *last > target) {
        return None;
    }
    let (mut power, mut k) = (scale.to_integer(), 0_u64);
    for (digit, square) in squares.iter().enumerate().rev() {
        let next = times(&power, square);
        if next > target {
            power = next;
            k += 1 << digit;
        }
    }
    Some(k + 1)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// A step beyond 2^63 was once called enough.
    #[test]
    fn no_step_is_proved_beyond_what_is_counted() {
        let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
        let near_one = |digits: u32| {
            Rational::one() - Rational::new(BigInt::one(), BigInt::from(10).pow(digits))
        };
        let hundredth = ratio(1, 100);
        let up = |factor: &Rational| least_power_at_most(factor, &hundredth, Rounding::Up);
        assert!(up(&near_one(18)).unwrap() > 4_605_170_185_988_091_000);
        assert_eq!(up(&near_one(20)), None);
        assert_eq!(up(&near_one(300)), None);
        let down = least_power_at_most(&near_one(20), &hundredth, Rounding::Down);
        assert_eq!(down, Some(1 << 63), "no smaller one is enough");
        assert_eq!(up(&ratio(1, 2)), Some(7));
    }
}
