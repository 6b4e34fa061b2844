//! The critical weight of convergence (theorem 7.8): eps*_N = 1/(1 + cos(pi/(N-1))), bracketed
//! by rational Perron vectors without a cosine.
//!
//! A positive vector w whose ratios r_i = (w_{i-1} + w_{i+1})/w_i lie in \[r, R\] decides almost every
//! weight: for 0 < eps < 2/(2 + R) it contracts, |A| w < w, and every run converges; for eps >= 2/(2 +
//! r) it grows, |A| w >= w, and some run does not converge.

use num_bigint::BigInt;
use num_traits::{One, Pow};

use cordon_core::Rational;
use cordon_core::linear::perron::Perron;

/// A bracket of the critical weight, with proofs of both sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bracket {
    /// The number of drones.
    pub count: usize,
    /// The critical weight itself, where it is rational and hence known exactly.
    pub exact: Option<Rational>,
    /// A weight at which every run converges: the multiple of 10^-digits at most one unit below the
    /// critical weight.
    pub below: Rational,
    /// A weight at which some run does not converge: `below` plus 10^-digits, or the critical
    /// weight itself.
    pub above: Rational,
    /// The vector that proves both.
    pub vector: Perron,
    /// A factor c < 1 with |A| w <= c w at `below`.
    pub rate: Rational,
    /// The least ratio of |A| w to w at `above`, at least 1.
    pub growth: Rational,
}

/// The bracket of width 10^-digits for `count` drones. `None` where no vector of sufficient quality was
/// found, which has not happened for any size up to the limits of this module.
pub fn bracket(count: usize, digits: usize) -> Option<Bracket> {
    // log2(10) < 3.33; the spread of the ratios is the width of the bracket, and a few extra bits make
    // it unlikely that a multiple of 10^-digits falls into it.
    let mut bits = 10 * digits as u64 / 3 + 16;
    for _ in 0..6 {
        let vector = Perron::find(count, bits)?;
        if let Some(bracket) = from_vector(count, digits, vector) {
            return Some(bracket);
        }
        bits *= 2;
    }
    None
}

fn from_vector(count: usize, digits: usize, vector: Perron) -> Option<Bracket> {
    let two = Rational::from_integer(2.into());
    let unit = Rational::new(BigInt::one(), BigInt::from(10).pow(digits));
    let contracts_before = &two / (&two + &vector.largest);
    let grows_from = &two / (&two + &vector.least);
    let exact = (vector.least == vector.largest).then(|| grows_from.clone());
    let multiples = (&contracts_before / &unit).ceil() - Rational::one();
    let below = multiples * &unit;
    let above = exact.clone().unwrap_or_else(|| &below + &unit);
    if above < grows_from {
        return None;
    }
    // The spec confirms both factors.
    let (_, contraction) = vector.ratios_by_spec(&below)?;
    let (growth, _) = vector.ratios_by_spec(&above)?;
    let one = Rational::one();
    if contraction >= one || growth < one {
        return None;
    }
    let rate = rounded_up_below_one(&contraction)?;
    Some(Bracket { count, exact, below, above, vector, rate, growth })
}

/// A short fraction 1 - 10^-m at or above `factor < 1`.
pub fn rounded_up_below_one(factor: &Rational) -> Option<Rational> {
    let one = Rational::one();
    let mut unit = one.clone();
    let ten = Rational::from_integer(10.into());
    // 1 - factor is a positive fraction: 10^-m falls below it for some m up to the length of its
    // denominator.
    for _ in 0..=factor.denom().bits() {
        let candidate = &one - &unit;
        if candidate >= *factor {
            return Some(candidate);
        }
        unit /= &ten;
    }
    None
}
