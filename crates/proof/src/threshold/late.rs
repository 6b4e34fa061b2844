//! The critical weight of ordering (theorem 7.2) when messages are late: below it, an invariant for
//! every pattern of delays; above it, a run that violates it. In between, the reason why the search
//! ended.

use cordon_core::{Rational, Result};
use num_bigint::BigInt;
use num_traits::{One, Pow, Zero};
use serde_json::Value;

use super::safety::{Cone, critical};
use crate::counterexample::Counterexample;
use crate::refute::departing::{Order, crossing, order};

/// A weight at which ordering was proved.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    /// The weight up to which order is kept.
    pub eps: Rational,
    /// Number of half-spaces of the invariant.
    pub half_spaces: usize,
    /// The certificate, accepted by the independent checker.
    pub certificate: Value,
}

/// The result for one number of drones and one longest delay, among weights that are multiples of
/// 10^-digits.
#[derive(Clone, Debug, PartialEq)]
pub struct Bracket {
    /// Number of drones, at least 3.
    pub count: usize,
    /// Largest delay of a message, in steps.
    pub longest: usize,
    /// The largest weight at which ordering was proved.
    pub kept: Option<Kept>,
    /// The smallest weight at which a crossing was found, with its run.
    pub lost: Counterexample,
    /// The smallest weight tried at which neither was found, and the reason why the search ended.
    pub open: Option<(Rational, String)>,
    /// Whether the largest weight is the critical one: that of prompt messages, beyond which drones
    /// cross at step 1.
    pub is_exact: bool,
}

/// Default limit of the work at one weight, in units of [`cordon_core::simplex::Work`]: some seconds.
pub const WORK: u64 = 120_000_000;

/// Brackets the critical weight of `count` drones whose messages are up to `longest` steps late, by
/// bisection; the search at each weight takes at most `work`.
///
/// Both sides are facts about the two weights; only the bisection assumes that larger weights are
/// worse. `None` where prompt messages have no critical weight, which does not happen.
///
/// # Errors
/// Drones and delays need more variables than a system may have.
pub fn bracket(count: usize, longest: usize, digits: usize, work: u64) -> Result<Option<Bracket>> {
    let Some(prompt) = critical(Cone::PositiveGaps, count, digits) else { return Ok(None) };
    let mut found =
        Bracket { count, longest, kept: None, lost: prompt.above, open: None, is_exact: false };
    let most = prompt.critical;
    if crossing(count, longest, &most)?.is_none() {
        found.take(&most, order(count, longest, &most, work)?);
        if found.kept.is_some() {
            found.is_exact = true;
            return Ok(Some(found));
        }
    }
    let unit = Rational::from_integer(BigInt::from(10).pow(digits)).recip();
    let weight = |k: &BigInt| Rational::from_integer(k.clone()) * &unit;
    let one = BigInt::one();
    // First the crossings that need no search.
    let (mut lo, mut hi) = (BigInt::zero(), (&found.lost.eps / &unit).ceil().to_integer());
    while &hi - &lo > one {
        let middle: BigInt = (&lo + &hi) / 2;
        match crossing(count, longest, &weight(&middle))? {
            Some(run) => (found.lost, hi) = (run, middle),
            None => lo = middle,
        }
    }
    lo = BigInt::zero();
    while &hi - &lo > one {
        let middle: BigInt = (&lo + &hi) / 2;
        let known = order(count, longest, &weight(&middle), work)?;
        match found.take(&weight(&middle), known) {
            true => lo = middle,
            false => hi = middle,
        }
    }
    Ok(Some(found))
}

impl Bracket {
    /// Records a result at a weight; returns whether order is kept there.
    fn take(&mut self, eps: &Rational, known: Order) -> bool {
        let eps = eps.clone();
        match known {
            Order::Kept(half_spaces, certificate) => {
                self.kept = Some(Kept { eps, half_spaces, certificate });
                return true;
            }
            Order::Lost(run) => self.lost = run,
            Order::Open(end) => self.open = Some((eps, end)),
        }
        false
    }
}
