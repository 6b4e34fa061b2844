//! Certain decimal digits where exact fractions are too long.
//!
//! The jump in fixed point: every coefficient of the kernel is kept to so many bits, rounded
//! down, with a bound of how much it is too small. That bound is an integer, so that the
//! enclosure of every position is exact. The cost no longer grows with k, only with its length.

use num_bigint::{BigInt, BigUint};
use num_traits::Signed;

use super::growth::{MAX_ANSWER_BYTES, limbs_for, log2_above, longest, readable};
use super::kernel::Kernel;
use super::line::Line;
use super::multiply::Multiply;
use super::power;
use super::ring::{convolve, half_ring};
use cordon_core::{Error, Rational, Result, exact};

/// A position between two rationals.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enclosure {
    /// At most the position. Not in lowest terms.
    pub lo: Rational,
    /// At least the position. Not in lowest terms.
    pub hi: Rational,
}

/// A decimal whose digits are all certain.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certain {
    /// The decimal: the position rounded half to even to `digits` places.
    pub decimal: String,
    /// How many places are certain.
    pub digits: usize,
}

/// What is known of all positions after k steps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Digits {
    /// The protocol steps made since the start.
    pub k: u64,
    /// The positions' certain digits, one decimal a drone.
    pub positions: Vec<Certain>,
}

impl Digits {
    /// The least number of certain places of all drones.
    pub fn certain(&self) -> usize {
        self.positions.iter().map(|p| p.digits).min().unwrap_or(0)
    }
}

/// A position in the middle between two decimals of so many places, or very near it, is decided
/// by writing up to this many places more.
const EXTRA_PLACES: usize = 3;

impl Enclosure {
    /// The decimal with `digits` places if those are certain; else with a few more, if those
    /// are (near the middle between two decimals); else with as many as are certain. `None`
    /// where not even the integer is.
    pub fn certain(&self, digits: usize) -> Option<Certain> {
        (digits..=digits + EXTRA_PLACES).chain((0..digits).rev()).find_map(|digits| {
            let decimal = exact::decimal_string(&self.lo, digits);
            let same = decimal == exact::decimal_string(&self.hi, digits);
            same.then_some(Certain { decimal, digits })
        })
    }
}

/// Guard bits beyond what the digits and the error of the power need; doubled where rounding
/// is not decided, this many times.
const GUARD_BITS: u64 = 32;
const ATTEMPTS: u32 = 4;

/// Most drones: the convolution with the start takes their number squared.
pub const MAX_DRONES: usize = 20_000;

/// The positions after each of `steps` to `digits` decimal places, rounded half to even. A
/// position too close to the middle between two decimals to be rounded has a place more; where
/// the last attempt cannot tell even so, it has as many as are certain.
///
/// # Errors
/// Too many drones; or a weight beyond 1/2 (or below 0) with so many steps that the numbers
/// needed on the way do not fit the memory.
pub fn at(line: &Line, steps: &[u64], digits: usize, by: &dyn Multiply) -> Result<Vec<Digits>> {
    steps.iter().map(|&k| after(line, k, digits, by)).collect()
}

fn after(line: &Line, k: u64, digits: usize, by: &dyn Multiply) -> Result<Digits> {
    let mut guard = GUARD_BITS;
    for _ in 1..ATTEMPTS {
        let found = attempt(line, k, digits, guard, by)?;
        if found.certain() >= digits {
            return Ok(found);
        }
        guard *= 4;
    }
    attempt(line, k, digits, guard, by)
}

fn attempt(line: &Line, k: u64, digits: usize, guard: u64, by: &dyn Multiply) -> Result<Digits> {
    // Places after the point that enclosures narrower than 1/2 unit of the last digit need.
    let wanted = (digits as f64 * 3.33) as u64 + guard;
    let enclosures = enclose(line, k, wanted, by)?;
    let certain = |e: &Enclosure| {
        // An enclosure wider than 1 happens to no attempt; it would have no certain place.
        e.certain(digits).unwrap_or(Certain { decimal: "?".to_owned(), digits: 0 })
    };
    Ok(Digits { k, positions: enclosures.iter().map(certain).collect() })
}

/// Encloses every position after `k` steps, to about `bits` bits after the point.
///
/// # Errors
/// As [`at`].
pub fn enclose(line: &Line, k: u64, bits: u64, by: &dyn Multiply) -> Result<Vec<Enclosure>> {
    let count = line.count();
    if count > MAX_DRONES {
        return Err(Error::input(format!(
            "drones: `{count}`: expected at most {MAX_DRONES} where digits are certified"
        )));
    }
    // Beyond [0, 1/2] the magnitudes of the weights sum to more than 1 and positions may
    // cancel by that factor to the power k.
    let growth = line.growth();
    let excess = (log2_above(&growth) - log2_above(&line.den) + 1e-12).max(0.0) * k as f64;
    let excess = if growth == line.den { 0 } else { excess as u64 + 2 };
    // The ring's places times the start, and the error of the power, which is below 4k + 4.
    let reach = longest(&line.deviation) + u64::from(count.ilog2()) + 3 + 68;
    let places = limbs_for(bits.saturating_add(excess).saturating_add(reach));
    // The square of the error times the ring's length has to stay below the last place.
    let places = places.max(limbs_for(2 * 68 + 64));
    let bytes = (places as u64).saturating_mul(16).saturating_mul(count as u64);
    if bytes > MAX_ANSWER_BYTES {
        return Err(Error::input(format!(
            "at: `{k}`: certain digits of {count} drones take about {} on the way: expected at \
             most {}; fewer digits or a weight in [0, 1/2] take less",
            readable(bytes),
            readable(MAX_ANSWER_BYTES)
        )));
    }
    let kernel = Kernel::fixed_power(line, half_ring(line), k, places, by);
    // Every coefficient is off by less than `error` in the same direction, and every deviation
    // meets two of them.
    let sum: BigInt = line.deviation.iter().map(BigInt::abs).sum();
    let margin = sum * 2 * BigInt::from(kernel.error());
    let unit = BigInt::from(1) << (64 * places);
    let power = |w: &BigUint| BigInt::from(power::natural(w, k, by));
    let (up, down) = if excess == 0 {
        (BigInt::from(1), BigInt::from(1))
    } else {
        (power(growth.magnitude()), power(line.den.magnitude()))
    };
    // (rest + (S +- margin)/2^p * W^k/Q^k)/D.
    let scale = &unit * &down;
    let den = &scale * &line.base;
    let end = |rest: &BigInt, s: BigInt| Rational::new_raw(rest * &scale + s * &up, den.clone());
    let convolved = convolve(line, &kernel, by);
    let enclosures = line
        .rest
        .iter()
        .zip(convolved)
        .map(|(rest, s)| Enclosure { lo: end(rest, &s - &margin), hi: end(rest, s + &margin) });
    Ok(enclosures.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn undecided_digits_are_not_claimed() {
        let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
        let e = Enclosure { lo: ratio(12344, 10000), hi: ratio(12346, 10000) };
        // 1.23 is certain, the next digit is 4 or 5.
        assert_eq!(e.certain(8), Some(Certain { decimal: "1.23".into(), digits: 2 }));
        let tie = Enclosure { lo: ratio(14999, 10000), hi: ratio(15001, 10000) };
        assert_eq!(tie.certain(0), Some(Certain { decimal: "1.5".into(), digits: 1 }));
        let wide = Enclosure { lo: ratio(14, 10), hi: ratio(16, 10) };
        assert_eq!(wide.certain(3), None);
    }
}
