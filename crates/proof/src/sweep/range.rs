//! How large the numbers of a sweep can get, established before the sweep runs.
//!
//! A placement X^k is kept as integers x^k with X^k = x^k / den^k, the start being integers of
//! magnitude at most G. Let g be the largest sum of the magnitudes of a role's weights; it is
//! at least den, the weights of every role summing to den. Then |x^k| <= G g^k, and so is every
//! partial sum on the way from x^{k-1}; a placement brought to a later denominator is
//! multiplied by den <= g a step. A conclusion about step k reads `span` placements more, all
//! over den^(k+span): every number it is given is at most V = G g^(k+span).
//!
//! What the predicates of `cordon_spec` compute from such numbers:
//!
//! * 7.2 compares positions, and computes nothing: V.
//! * (N-1) T_i is at most 3(N-1) V, errors times N-1 at most 4(N-1) V, doubled sums at most
//!   2N V: all within 4N V. So are the start predicates, at step 0: within 4N G.
//! * 7.8 squares errors (`degree` is 2): N squares of at most (4(N-1) V)^2, within
//!   16 N^3 V^2; its rate multiplies an error by (N-1)^2 den + 8|num| and by a contraction
//!   weight of at most N^2: within 4N V * N^2 * (N^2 den + 8|num|).
//!
//! The bound is the larger of these. A test runs every predicate on integers that record the
//! largest magnitude they ever had, and another crosses the edge of each width.

use num_bigint::{BigInt, BigUint};
use num_traits::{Pow, Signed, Zero};

use super::machine::Machine;
use cordon_core::Rational;
use cordon_core::stencil::{Role, Stencil};
use cordon_spec::theorems::{Form, Theorem};

/// The largest power of the positions' size that the conclusion of a theorem computes: 0 where
/// it computes nothing, 2 where it squares errors, 1 otherwise.
pub(super) fn degree(theorem: Theorem) -> u32 {
    match theorem {
        Theorem::Ordering => 0,
        Theorem::Limit => 2,
        _ => 1,
    }
}

/// What bounds the numbers of one work item.
#[derive(Clone, Debug)]
pub struct Range {
    degree: u32,
    count: BigUint,
    /// The numerator's magnitude and the denominator of the weight.
    eps: (BigUint, BigUint),
    growth: BigUint,
    length: BigUint,
    span: usize,
}

impl Range {
    /// For conclusions of `theorem` about `count` drones with weight `eps`, from starts of
    /// integer positions of magnitude at most `length` (the segment's ends included).
    pub fn new(
        theorem: Theorem,
        form: Form,
        count: usize,
        eps: &Rational,
        length: &BigInt,
    ) -> Self {
        let stencil = Stencil::of(eps);
        let growth = Role::ALL
            .map(|role| magnitudes(stencil.weights(role).as_array()))
            .into_iter()
            .fold(BigUint::zero(), BigUint::max);
        Self {
            degree: degree(theorem),
            count: count.into(),
            eps: (eps.numer().magnitude().clone(), eps.denom().magnitude().clone()),
            growth,
            length: length.magnitude().clone(),
            span: theorem.span(form, count),
        }
    }

    /// A bound of every magnitude met on the way to the conclusion about step `k`, and in it.
    pub fn bound(&self, k: usize) -> BigUint {
        let value = &self.length * Pow::pow(&self.growth, k + self.span);
        let n = &self.count;
        let linear = n * 4u8 * &value;
        match self.degree {
            0 => return value.max(n * 4u8 * &self.length),
            1 => return linear,
            _ => {}
        }
        let squares = n * n * n * 16u8 * &value * &value;
        let (num, den) = &self.eps;
        let rate = linear * n * n * (n * n * den + num * 8u8);
        squares.max(rate)
    }

    /// The last of the steps `0 ..= last` whose conclusion the machine integers `S` can hold;
    /// `None` where not even step 0 fits.
    pub fn last_step<S: Machine>(&self, last: usize) -> Option<usize> {
        let Some(bits) = S::MAGNITUDE_BITS else {
            return Some(last);
        };
        // The bound grows with the step.
        let fits = |k| self.bound(k).bits() <= bits;
        if !fits(0) {
            return None;
        }
        let (mut good, mut bad) = (0, last + 1);
        while bad - good > 1 {
            let middle = good + (bad - good) / 2;
            if fits(middle) { good = middle } else { bad = middle }
        }
        Some(good)
    }
}

fn magnitudes(weights: [&BigInt; 5]) -> BigUint {
    weights.into_iter().map(|w| w.abs().magnitude().clone()).sum()
}
