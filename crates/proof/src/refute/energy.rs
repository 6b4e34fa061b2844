//! Theorem 7.8, whose conclusion is quadratic in the start, so that extreme starts do not decide it.

use cordon_spec::placement::contraction_weight;
use cordon_spec::theorems::{Form, Theorem, WeightRange};
use num_bigint::BigInt;
use num_traits::{One, Signed};

use super::region::Region;
use crate::counterexample::Counterexample;
use cordon_core::Rational;
use cordon_core::linear::perron::Perron;
use cordon_core::linear::rows::applied;
use cordon_core::stencil::Stencil;

/// Whether the sum of the squared errors decreases in every step from every start off the targets: I -
/// A^2 is positive definite, which the spec decides by leading minors. For the sharp form up to eps =
/// 1/2 the rate is checked too: A >= 0 and A w <= c w row by row.
pub fn always_falls(form: Form, count: usize, eps: &Rational) -> bool {
    let den = Rational::from_integer(eps.denom().clone());
    let in_range = |range: WeightRange| range.contains(&(eps * &den), &den, count).is_true();
    if !in_range(WeightRange::BelowCritical) {
        return false;
    }
    if form == Form::Paper || !in_range(WeightRange::PositiveUpToHalf) {
        return true;
    }
    let integer = |n: usize| Rational::from_integer(n.into());
    let w: Vec<Rational> = (0..count).map(|i| integer(contraction_weight(count, i))).collect();
    let last = BigInt::from(count.saturating_sub(1));
    let rate = Rational::one() - eps * Rational::new(8.into(), &last * &last);
    let Some(rows) = Stencil::executed(eps).error_rows(count) else { return false };
    let next = applied(&rows, &w);
    let contracts = next.iter().zip(&w).all(|(after, before)| after <= &(before * &rate));
    // A >= 0 for these weights: eps and 1 - 2eps are nonnegative.
    contracts && !eps.is_negative()
}

/// Precisions of the Perron vector, in bits: the first start that works has short numbers.
const PRECISIONS: [u64; 5] = [1, 4, 10, 40, 160];

/// A start in the region for which the sum of the squared errors does not decrease at step k, from a
/// fixed family: the most persistent errors around the middle of the region, and mixtures of the middle
/// with extreme starts.
pub fn violating_start(
    form: Form,
    region: &Region,
    eps: &Rational,
    k: usize,
) -> Option<Vec<Rational>> {
    candidates(region).into_iter().find(|x| {
        let start = region.start(x);
        Counterexample::replay(Theorem::Limit, form, eps, start, k).is_some()
    })
}

fn candidates(region: &Region) -> Vec<Vec<Rational>> {
    let middle = region.middle();
    let spacing = Rational::from_integer((region.count - 1).into()).recip();
    let room = &spacing * &spacing / Rational::from_integer(3.into());
    // The simplest first.
    let mut found = vec![middle.clone()];
    for d in &region.directions {
        found.push(middle.iter().zip(d).map(|(x, y)| x + y).collect());
    }
    for bits in PRECISIONS {
        let Some(w) = Perron::find(region.count, bits) else { continue };
        let heaviest = w.weights.iter().max().cloned().unwrap_or_else(BigInt::one);
        for alternate in [true, false] {
            let error = |i: usize, w: &BigInt| {
                let e = Rational::new(w.clone(), heaviest.clone()) * &room;
                if alternate && i % 2 == 1 { -e } else { e }
            };
            let moved = middle.iter().zip(&w.weights).enumerate();
            found.push(moved.map(|(i, (x, w))| x - error(i, w)).collect());
        }
    }
    for (num, den) in [(1, 2), (3, 4), (15, 16)] {
        let t = Rational::new(num.into(), den.into());
        for extreme in &region.points {
            let mixed = middle.iter().zip(extreme).map(|(a, b)| a + (b - a) * &t);
            found.push(mixed.collect());
        }
    }

    found
}
