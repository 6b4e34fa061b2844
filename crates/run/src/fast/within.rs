//! The first step from which on all drones are within a distance of their resting places.
//!
//! With weights in \[0, 1/2\] no step increases the largest deviation, so that bisection finds
//! the step. Powers of the kernel in fixed point compose: k steps take about 2 log2 k
//! multiplications, and an enclosure says where rounding leaves the answer open.

use num_bigint::BigInt;
use num_traits::Signed;

use super::growth::{limbs_for, log2_above};
use super::kernel::Kernel;
use super::line::Line;
use super::multiply::Multiply;
use super::ring::{Sources, convolve, half_ring};
use cordon_core::Rational;

/// Most doublings: 2^40 steps.
const MOST_DOUBLINGS: usize = 40;

/// Bits by which the distance exceeds the largest error that rounding can make.
const MARGIN_BITS: u64 = 64;

/// The first k after which, and after every later step, no drone is farther than `within` from
/// its resting place. `None` where some weight is negative, beyond 2^40 steps, and where the
/// largest deviation is closer to `within` than rounding tells.
pub fn first_step(line: &Line, within: &Rational, by: &dyn Multiply) -> Option<u64> {
    if line.growth() != line.den || !within.is_positive() {
        return None;
    }
    let mut search = Search::new(line, within, by);
    let power = |k: u64| Kernel::fixed_power(line, half_ring(line), k, search.places, by);
    let (none, one) = (power(0), power(1));
    if search.met_after(&none)? {
        return Some(0);
    }
    let mut doublings = vec![one.clone()];
    loop {
        let last = doublings.last()?;
        if search.met_after(last)? || doublings.len() > MOST_DOUBLINGS {
            break;
        }
        doublings.push(last.twice(by));
    }
    // The largest number of steps after which it is not met, by binary digits; the last doubling
    // is beyond it. That the drone watched is within the distance says nothing of the others,
    // but is a good guess: the step that is found so is looked at in full.
    doublings.pop();
    for guessing in [true, false] {
        let (mut below, mut steps) = (None::<Kernel>, 0_u64);
        for (digit, power) in doublings.iter().enumerate().rev() {
            let further = match &below {
                None => power.clone(),
                Some(below) => below.then(power, by),
            };
            let guess = if guessing { search.watched_is_within(&further) } else { None };
            let met = match guess {
                Some(met) => met,
                None => search.met_after(&further)?,
            };
            if !met {
                below = Some(further);
                steps += 1 << digit;
            }
        }
        if steps + 1 >= 1 << MOST_DOUBLINGS {
            return None;
        }
        let first = below.map_or_else(|| one.clone(), |below| below.then(&one, by));
        // After `steps` some drone was beyond the distance for certain.
        if !guessing || search.met_after(&first)? {
            return Some(steps + 1);
        }
    }
    None
}

struct Search<'l> {
    line: &'l Line,
    by: &'l dyn Multiply,
    /// Limbs after the point.
    places: usize,
    /// The distance in units of 1/base, times `2^(64 places)`.
    bound: Rational,
    /// Twice the sum of the deviations' magnitudes.
    doubt: BigInt,
    sources: Sources,
    /// A drone that was farthest from its resting place; looked at before the others.
    watched: Option<usize>,
}

impl<'l> Search<'l> {
    fn new(line: &'l Line, within: &Rational, by: &'l dyn Multiply) -> Self {
        let doubt: BigInt = line.deviation.iter().map(Signed::abs).sum::<BigInt>() * 2;
        let distance = within * Rational::from_integer(line.base.clone());
        let ratio = (Rational::from_integer(doubt.clone() + 1) / &distance).ceil().to_integer();
        // The error of a power of 2^40 is below 2^43 units of the last place.
        let needed = log2_above(&ratio.max(1.into())) as u64 + 44 + MARGIN_BITS;
        // The square of that error times the ring's length has to stay below the last place.
        let places = limbs_for(needed.max(192));
        let unit = Rational::from_integer(BigInt::from(1) << (64 * places));
        let (bound, sources) = (distance * unit, Sources::of(line));
        Self { line, by, places, bound, doubt, sources, watched: None }
    }

    /// Whether every drone is within the distance after the steps of the kernel.
    fn met_after(&mut self, kernel: &Kernel) -> Option<bool> {
        if self.watched_is_within(kernel) == Some(false) {
            return Some(false);
        }
        let deviations = convolve(self.line, kernel, self.by);
        let farthest = (0..deviations.len()).max_by_key(|i| deviations[*i].abs())?;
        self.watched = Some(farthest);
        self.is_within(&deviations[farthest].abs(), kernel)
    }

    /// Whether the drone that is watched is within the distance, where there is one and rounding
    /// tells.
    fn watched_is_within(&self, kernel: &Kernel) -> Option<bool> {
        let deviation = self.sources.one(self.watched?, self.line, kernel);
        self.is_within(&deviation.abs(), kernel)
    }

    fn is_within(&self, deviation: &BigInt, kernel: &Kernel) -> Option<bool> {
        let doubt = &self.doubt * BigInt::from(kernel.error());
        let at_most = |x: BigInt| Rational::from_integer(x) <= self.bound;
        match (at_most(deviation + &doubt), at_most(deviation - &doubt)) {
            (true, _) => Some(true),
            (false, false) => Some(false),
            (false, true) => None,
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use cordon_core::Rational;
    use cordon_spec::Params;
    use num_traits::Signed;

    use super::super::multiply::NumBigint;
    use super::super::step;
    use super::*;

    fn ratio(p: i64, q: i64) -> Rational {
        Rational::new(p.into(), q.into())
    }

    /// Against every step, in integers.
    #[test]
    fn the_step_found_is_the_first() {
        let mut cases = 0;
        for (count, p, q) in [(3, 1, 5), (4, 1, 2), (5, 1, 4), (6, 2, 7), (9, 1, 3), (12, 1, 2)] {
            for (a, b) in [(1, 2), (1, 100), (3, 10_000)] {
                let start: Vec<_> = (0..count)
                    .map(|i| if i + 1 == count { ratio(100, 1) } else { ratio(7 * i, 3) })
                    .collect();
                let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(p, q), n: 0 };
                let line = Line::coverage(&p, &start).unwrap();
                let within = ratio(a, b);
                let found = first_step(&line, &within, &NumBigint).unwrap();
                let worst = |k: u64| {
                    let after = step::at(&line, &[k]).unwrap().remove(0);
                    let scale = after.denominator(&NumBigint) / &line.base;
                    let off = after.numerators.iter().zip(&line.rest);
                    let off = off.map(|(x, rest)| (x - rest * &scale).abs()).max().unwrap();
                    Rational::new(off, scale * &line.base)
                };
                assert!(worst(found) <= within, "N = {count}, within {a}/{b}: {found}");
                assert!(found == 0 || worst(found - 1) > within, "{count} {a}/{b}: {found}");
                cases += 1;
            }
        }
        assert_eq!(cases, 18);
    }

    #[test]
    fn weights_beyond_one_half_and_ties_are_left_open() {
        let start = [0, 1, 2, 9].map(|x| ratio(x, 1));
        let p = |eps| Params { min: ratio(0, 1), max: ratio(9, 1), eps, n: 0 };
        let beyond = Line::coverage(&p(ratio(3, 5)), &start).unwrap();
        assert_eq!(first_step(&beyond, &ratio(1, 10), &NumBigint), None);
        let line = Line::coverage(&p(ratio(1, 2)), &start).unwrap();
        assert_eq!(first_step(&line, &ratio(2, 1), &NumBigint), None, "a tie at step 1");
        assert_eq!(first_step(&line, &ratio(4, 1), &NumBigint), Some(0), "step 0 is exact");
    }
}
