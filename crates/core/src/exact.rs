//! Exact numbers at the edge: read without rounding, shown as fractions or rounded decimals.

use num_bigint::{BigInt, BigUint, Sign};
use num_integer::Integer;
use num_traits::{One, Pow, Signed, Zero};

use crate::text::{cut, one_line};
use crate::{Error, Result};

/// The exact rationals on which the spec is executed by default.
pub type Rational = num_rational::BigRational;

/// Largest decimal exponent accepted: a number with more zeros is a mistake, and would cost
/// memory in proportion.
const MAX_EXPONENT: i32 = 10_000;

/// Longest number accepted, in characters.
const MAX_LENGTH: usize = 100_000;

/// Reads `7`, `-3/4`, `0.2` or `1.5e-3` exactly (`0.2` is 1/5).
///
/// # Errors
/// Anything else, a zero denominator, and exponents beyond 10,000; `what` names the field.
pub fn parse(what: &str, text: &str) -> Result<Rational> {
    let text = text.trim();
    parse_exact(text).map_err(|why| Error::input(format!("{what}: `{}` {why}", shortened(text))))
}

/// User input in a message: one line, without what is not shown, shortened.
pub fn shortened(text: &str) -> String {
    // Before the rest of a long text is looked at.
    one_line(&cut(text, 40))
}

const EXPECTED: &str = "is not a number: expected an integer, a fraction like 1/5 or a decimal";

fn parse_exact(text: &str) -> Result<Rational, &'static str> {
    if text.len() > MAX_LENGTH {
        return Err("is too long: at most 100000 characters are accepted");
    }
    match text.split_once('/') {
        Some((num, den)) => {
            let (num, den) = (signed_integer(num)?, signed_integer(den)?);
            if den.is_zero() { Err("divides by zero") } else { Ok(Rational::new(num, den)) }
        }
        None => decimal(text),
    }
}

fn signed_integer(text: &str) -> Result<BigInt, &'static str> {
    let (negative, digits) = sign(text);
    let magnitude = digits_to_integer(digits)?;
    Ok(if negative { -magnitude } else { magnitude })
}

fn sign(text: &str) -> (bool, &str) {
    match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    }
}

fn digits_to_integer(digits: &str) -> Result<BigInt, &'static str> {
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(EXPECTED);
    }
    digits.parse().map_err(|_| EXPECTED)
}

fn decimal(text: &str) -> Result<Rational, &'static str> {
    let (negative, text) = sign(text);
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((m, e)) => (m, exponent(e)?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = digits_to_integer(&format!("{whole}{fraction}"))?;
    // `fraction` is at most MAX_LENGTH long.
    let places = exponent - fraction.len() as i32;
    let power = BigInt::from(10).pow(places.unsigned_abs());
    let magnitude =
        if places < 0 { Rational::new(digits, power) } else { Rational::from(digits * power) };
    Ok(if negative { -magnitude } else { magnitude })
}

fn exponent(text: &str) -> Result<i32, &'static str> {
    let (negative, digits) = sign(text);
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(EXPECTED);
    }
    match digits.parse::<i32>() {
        Ok(e) if e <= MAX_EXPONENT => Ok(if negative { -e } else { e }),
        _ => Err("has an exponent beyond 10000"),
    }
}

/// `p/q` in lowest terms, or `p` where q is 1: reads back as the same number.
pub fn fraction(x: &Rational) -> String {
    x.to_string()
}

/// As [`fraction`], but powers of ten below 1 as `10^-m`.
pub fn in_short(x: &Rational) -> String {
    let text = x.denom().to_string();
    match text.strip_prefix('1').filter(|z| !z.is_empty() && z.bytes().all(|b| b == b'0')) {
        Some(zeros) if x.numer().is_one() => format!("10^-{}", zeros.len()),
        _ => fraction(x),
    }
}

/// The decimal with `digits` places after the point, rounded half to even.
pub fn decimal_string(x: &Rational, digits: usize) -> String {
    quotient_decimal(x.numer(), x.denom(), digits)
}

/// [`decimal_string`] of `num/den`, in lowest terms or not; `den` is positive.
pub fn quotient_decimal(num: &BigInt, den: &BigInt, digits: usize) -> String {
    let den = den.magnitude();
    let scaled = num.magnitude() * BigUint::from(10u8).pow(digits);
    let (mut whole, rest) = scaled.div_rem(den);
    let up = match (rest * 2u8).cmp(den) {
        std::cmp::Ordering::Less => false,
        std::cmp::Ordering::Equal => whole.is_odd(),
        std::cmp::Ordering::Greater => true,
    };
    if up {
        whole += BigUint::one();
    }
    let minus = if num.is_negative() && !whole.is_zero() { "-" } else { "" };
    let shown = format!("{whole:0>width$}", whole = whole.to_string(), width = digits + 1);
    let (int, frac) = shown.split_at(shown.len() - digits);
    let point = if digits == 0 { "" } else { "." };
    format!("{minus}{int}{point}{frac}")
}

/// The nearest double, ties to even; infinite beyond the range of doubles.
pub fn to_f64(x: &Rational) -> f64 {
    quotient_to_f64(x.numer(), x.denom())
}

/// [`to_f64`] of `num/den`, in lowest terms or not; `den` is positive.
pub fn quotient_to_f64(num: &BigInt, den: &BigInt) -> f64 {
    nearest_f64(num, den.magnitude())
}

/// [`to_f64`] of `num/den`, in lowest terms or not.
pub fn nearest_f64(num: &BigInt, den: &BigUint) -> f64 {
    by_first_bits(num, den).unwrap_or_else(|| {
        let magnitude = magnitude_to_f64(num.magnitude(), den);
        if num.sign() == Sign::Minus { -magnitude } else { magnitude }
    })
}

/// The nearest double of num/den, where the first 64 bits of both decide it.
fn by_first_bits(num: &BigInt, den: &BigUint) -> Option<f64> {
    let (n, below_n) = first_bits(num.magnitude())?;
    let (d, below_d) = first_bits(den)?;
    if n == u64::MAX {
        return None;
    }
    // Any quotient of numbers that begin with these bits lies between these two, over 2^64.
    let least = (u128::from(n) << 64) / (u128::from(d) + 1);
    let most = (u128::from(n + 1) << 64) / u128::from(d) + 1;
    let exponent = below_n - below_d - 64;
    // Well inside the range of doubles a power of two changes the exponent alone.
    if least as f64 != most as f64 || !(-900..900).contains(&exponent) {
        return None;
    }
    let size = least as f64 * 2.0_f64.powi(exponent as i32);
    Some(if num.sign() == Sign::Minus { -size } else { size })
}

/// The first 64 bits of a number, beginning with a 1, and how many bits follow; negative where zeros
/// were appended. `None` for zero.
fn first_bits(x: &BigUint) -> Option<(u64, i64)> {
    let mut digits = x.iter_u64_digits();
    let more = 64 * (digits.len() as i64 - 1);
    let first = digits.next_back()?;
    let shift = first.leading_zeros();
    let next = digits.next_back().unwrap_or_default();
    let rest = next.checked_shr(u64::BITS - shift).unwrap_or_default();
    Some((first << shift | rest, more - i64::from(shift)))
}

/// The nearest double of num/den, by one correctly rounded quotient of integers.
fn magnitude_to_f64(num: &BigUint, den: &BigUint) -> f64 {
    if num.is_zero() {
        return 0.0;
    }
    // Bring the quotient to 64 or 65 bits and let a sticky bit stand for the rest; rounding to
    // 53 bits is then decided by the integer alone. Below the normal range two roundings could
    // differ, so the quotient is cut to the bits that a subnormal keeps.
    let wanted = 64 - (num.bits() as i64 - den.bits() as i64);
    let lowest = -1074 - 2;
    let shift = wanted.min(-lowest);
    let (scaled_num, scaled_den) = if shift >= 0 {
        (num << shift as u64, den.clone())
    } else {
        (num.clone(), den << shift.unsigned_abs())
    };
    let (quotient, rest) = scaled_num.div_rem(&scaled_den);
    let sticky = (quotient << 1u8) + u8::from(!rest.is_zero());
    let bits: u128 = u128::try_from(&sticky).unwrap_or(u128::MAX);
    scale_by_power_of_two(bits, -(shift + 1))
}

/// `bits * 2^exponent`, rounded once.
fn scale_by_power_of_two(bits: u128, exponent: i64) -> f64 {
    let length = i64::from(u128::BITS - bits.leading_zeros());
    // The exponent of the last bit that the result keeps.
    let last = (length + exponent - 53).max(-1074);
    let drop = last - exponent;
    let kept = if drop <= 0 {
        bits << drop.unsigned_abs()
    } else {
        let half = 1u128 << (drop - 1);
        let (kept, rest) = (bits >> drop, bits & ((half << 1) - 1));
        let up = rest > half || (rest == half && kept & 1 == 1);
        kept + u128::from(up)
    };
    // `kept` has at most 54 bits and is exact as a double; so is each power of two below.
    let mut value = kept as f64;
    let mut left = last;
    while left > 1000 {
        value *= 2f64.powi(1000);
        left -= 1000;
        if value.is_infinite() {
            return value;
        }
    }
    while left < -1000 {
        value *= 2f64.powi(-1000);
        left += 1000;
    }
    value * 2f64.powi(left as i32)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// The first bits decide all but a few cases, and agree with the full computation.
    #[test]
    fn first_bits_round_as_all_bits_do() {
        let (mut decided, mut asked) = (0, 0);
        let mut state = 1_u64;
        let mut random = |bits: u64| {
            let mut x = BigUint::one();
            while x.bits() < bits {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                x = (x << 32u8) + (state >> 32);
            }
            x
        };
        for bits in (1..1400).step_by(7) {
            for other in [1, 53, 54, 64, 65, 700, 1300] {
                let (num, den) = (BigInt::from(random(bits)), random(other));
                let expected = magnitude_to_f64(num.magnitude(), &den);
                asked += 1;
                if let Some(x) = by_first_bits(&num, &den) {
                    assert_eq!(x.to_bits(), expected.to_bits(), "{num}/{den}");
                    assert_eq!(by_first_bits(&-num, &den), Some(-x));
                    decided += 1;
                }
            }
        }
        assert!(asked == 1400 && decided > 1000, "{decided} of {asked}");
        // Halfway between two doubles, and a hair beside it: the first bits alone cannot tell.
        let half = (BigInt::one() << 400u32) * ((BigInt::one() << 53u8) + 1u8);
        for beside in [-1, 0, 1] {
            assert_eq!(by_first_bits(&(&half + beside), &(BigUint::one() << 420u32)), None);
        }
        assert_eq!(by_first_bits(&BigInt::default(), &BigUint::one()), None);
    }
}
