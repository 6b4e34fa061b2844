//! Perron vectors: positive vectors that the step of the errors stretches evenly.
//!
//! On the internal drones e' = A e with A = tridiag(eps, 1-2eps, eps). For a positive vector w
//! let r_i = (w_{i-1} + w_{i+1}) / w_i (w_0 = w_{N-1} = 0). Then |A| w has the ratios
//! |1 - 2eps| + eps r_i to w, so that one vector brackets the spectral radius of |A| from both
//! sides for every eps (Collatz-Wielandt), and the tighter the more even the r_i are.
//!
//! The vector is found by shooting: w_1 = 1, w_{i+1} = mu w_i - w_{i-1}, with mu the largest number for
//! which w_{N-1} = 0. Fixed-point arithmetic suffices for the search: its result is judged by exact
//! ratios.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use super::rows::applied;
use crate::Rational;
use crate::stencil::Stencil;

/// A positive integer vector on the internal drones 1 .. N-2 and its exact ratios.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Perron {
    /// w_1 .. w_{N-2}, all positive.
    pub weights: Vec<BigInt>,
    /// The least r_i, in lowest terms: bounds the spectral radius from below.
    pub least: Rational,
    /// The largest r_i, in lowest terms: bounds the spectral radius from above.
    pub largest: Rational,
}

/// Most steps of Newton's method: quadratic at the end, and before that the distance to the
/// largest root shrinks at least by the factor 1 - 1/(N-2).
const NEWTON_STEPS: usize = 10_000;

impl Perron {
    /// The Perron vector of `count >= 3` drones, its ratios about `2^-bits` apart. `None`
    /// where the search fails, which shows in the ratios and nowhere else.
    pub fn find(count: usize, bits: u64) -> Option<Self> {
        let internal = count.checked_sub(2).filter(|&n| n >= 1)?;
        // Rounding errors of the recurrence grow like N^2.
        let guard = 4 * u64::from(usize::BITS - count.leading_zeros()) + 16;
        let scale = BigInt::one() << (bits + guard);
        let mu = largest_root(internal, &scale);
        // A whole mu (N = 3, 4) gives an exact eigenvector of small integers.
        let half = &scale >> 1u8;
        let whole = (&mu + half) / &scale;
        let exact = shoot(internal, &whole, &BigInt::one());
        let vector = if exact.end.is_zero() && exact.weights.iter().all(BigInt::is_positive) {
            exact.weights
        } else {
            shoot(internal, &mu, &scale).weights
        };
        Self::judged(vector)
    }

    /// The vector with its ratios. `None` unless all entries are positive.
    pub fn judged(weights: Vec<BigInt>) -> Option<Self> {
        if !weights.iter().all(BigInt::is_positive) {
            return None;
        }
        let zero = BigInt::zero();
        let before = std::iter::once(&zero).chain(&weights);
        let after = weights.iter().skip(1).chain(std::iter::once(&zero));
        // Compared as fractions without reduction: the numbers are coprime as a rule.
        let ratios: Vec<Rational> = before
            .zip(after)
            .zip(&weights)
            .map(|((a, b), w)| Rational::new_raw(a + b, w.clone()))
            .collect();
        let least = ratios.iter().min()?.reduced();
        let largest = ratios.iter().max()?.reduced();
        Some(Self { weights, least, largest })
    }

    /// A factor c with |A| w <= c w: |1 - 2eps| + |eps| * largest r_i.
    pub fn factor_above(&self, eps: &Rational) -> Rational {
        factor(eps, &self.largest)
    }

    /// A factor c with |A| w >= c w: |1 - 2eps| + |eps| * least r_i.
    pub fn factor_below(&self, eps: &Rational) -> Rational {
        factor(eps, &self.least)
    }

    /// The least and the largest ratio of |A| w to w at this weight, computed with the spec's
    /// step on w with signs such that A acts on it like |A| (alternating signs beyond
    /// eps = 1/2). An independent check of the factors above.
    pub fn ratios_by_spec(&self, eps: &Rational) -> Option<(Rational, Rational)> {
        let alternate = eps * Rational::from_integer(2.into()) > Rational::one();
        let sign = |i: usize| alternate && i % 2 == 1;
        let mut e = vec![Rational::zero()];
        for (i, w) in self.weights.iter().enumerate() {
            let w = Rational::from_integer(w.clone());
            e.push(if sign(i) { -w } else { w });
        }
        e.push(Rational::zero());
        let next = applied(&Stencil::executed(eps).error_rows(e.len())?, &e);
        let ratios = next.iter().zip(&e).skip(1).take(self.weights.len()).map(|(after, before)| {
            let r = after / before;
            if alternate { -r } else { r }
        });
        let ratios: Vec<Rational> = ratios.collect();
        Some((ratios.iter().min()?.clone(), ratios.iter().max()?.clone()))
    }
}

fn factor(eps: &Rational, ratio: &Rational) -> Rational {
    (Rational::one() - eps * Rational::from_integer(2.into())).abs() + eps.abs() * ratio
}

/// A shot: the vector, and the component w_{N-1} that should be zero.
struct Shot {
    weights: Vec<BigInt>,
    end: BigInt,
}

fn shoot(internal: usize, mu: &BigInt, scale: &BigInt) -> Shot {
    let (mut before, mut now) = (BigInt::zero(), scale.clone());
    let mut weights = Vec::with_capacity(internal);
    for _ in 0..internal {
        let next = mu * &now / scale - &before;
        weights.push(std::mem::replace(&mut now, next));
        before = weights.last().cloned().unwrap_or_default();
    }
    Shot { weights, end: now }
}

/// The largest mu with w_{N-1}(mu) = 0, in fixed point: Newton's method from mu = 2, which is
/// above it; the polynomial is convex there, so that the iterates fall until they stand still.
fn largest_root(internal: usize, scale: &BigInt) -> BigInt {
    let mut mu = scale * 2;
    for _ in 0..NEWTON_STEPS {
        let (value, slope) = value_and_slope(internal, &mu, scale);
        if !value.is_positive() || !slope.is_positive() {
            break;
        }
        let step = value * scale / slope;
        if step.is_zero() {
            break;
        }
        mu -= step;
    }
    mu
}

/// w_{N-1} and its derivative in mu.
fn value_and_slope(internal: usize, mu: &BigInt, scale: &BigInt) -> (BigInt, BigInt) {
    let (mut before, mut now) = (BigInt::zero(), scale.clone());
    let (mut slope_before, mut slope) = (BigInt::zero(), BigInt::zero());
    for _ in 0..internal {
        let slope_next = &now + mu * &slope / scale - &slope_before;
        let next = mu * &now / scale - &before;
        (slope_before, slope) = (slope, slope_next);
        (before, now) = (now, next);
    }
    (now, slope)
}
