//! Settling: from which step on every drone is within a given distance of its target.
//!
//! *Proved* steps follow from a contraction |A| w <= c w (PROTOCOL section 2): after k steps
//! |e_i| <= c^k * max_j(|e_j^0|/w_j) * w_i. The *true* step comes from running the spec, and
//! from a norm that no step increases, which is what makes "from then on" final.

mod execute;
mod power;
mod stays;

use std::ops::RangeInclusive;

use cordon_spec::placement::{contraction_weight, scaled_error};
use cordon_spec::{Params, Scalar};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use cordon_core::linear::enclosure::Enclosure;
use cordon_core::linear::perron::Perron;
use cordon_core::{Error, Rational, Result};
use cordon_run::fast::{Line, engine, within};
use execute::settling_step;
pub(crate) use power::{Rounding, least_power_at_most};
use stays::Stays;

/// Which runs are meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Starts {
    /// The run from this start; its first and last position are the segment's ends.
    One(Vec<Rational>),
    /// The runs from all starts within the segment \[0, 1\], of so many drones.
    AllWithin(usize),
}

/// Where a proved step comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Contraction {
    /// w_i = i(N-1-i), c = 1 - 8 eps/(N-1)^2: for every N and 0 < eps <= 1/2.
    EveryN,
    /// A rational Perron vector for this N.
    OwnVector(Perron),
}

/// A settling step that a contraction proves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proved {
    /// From this step on every drone is within the distance.
    pub step: u64,
    /// The contraction that proves it.
    pub by: Contraction,
    /// Its factor c, below 1.
    pub rate: Rational,
}

/// The true settling step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Observed {
    /// Established on enclosures, step by step or by jumps, or on exact fractions where
    /// enclosures could not tell.
    Step(u64),
    /// The run is longer than the limit on work: not determined.
    TooLong,
}

/// What is known about settling.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Settling {
    /// Every run converges; proved steps, the weakest first, and the true one.
    Settles {
        /// At least one, the weakest contraction first.
        proved: Vec<Proved>,
        /// No earlier step than this will do: |A| w >= c w for the same vector w, where all
        /// errors of the start have the signs in which A acts on them like |A|; else 0.
        not_before: u64,
        /// The step from which on the runs really are within the distance.
        observed: Observed,
    },
    /// No contraction, and within the distance for ever from this step on all the same.
    Stays {
        /// The step.
        step: u64,
        /// Whether the runs meant converge: of one start that can be, of every start never.
        converges: bool,
    },
    /// The run from the one start is outside the distance again and again.
    NeverFromThisStart,
    /// Some run does not converge: |A| w >= w for this positive w.
    NotFromEveryStart(Perron),
    /// The weight is too near the critical one for the precision tried.
    Undecided,
}

/// Numbers of drones that are accepted.
pub const DRONES: RangeInclusive<usize> = 3..=10_000;

/// Bits of the Perron vectors tried, the first that decides wins.
const PRECISIONS: [u64; 3] = [40, 160, 1_300];

/// Most drone steps on enclosures: some ten seconds.
const MOST_DRONE_STEPS: u64 = 5_000_000;

/// Most of N * k^2 on exact fractions, whose length grows with k: some ten seconds.
const MOST_EXACT_WORK: u64 = 5_000_000;

/// Bits after the point of the enclosures.
const BITS: u32 = 256;

/// Bits after the point of the finer ones: distances down to 10^-600.
const FINE_BITS: u32 = 2048;

/// When the runs are within `within` of the targets for good, at weight `eps`.
///
/// # Errors
/// Fewer than 3 drones, a distance that is not positive, or a segment without length.
pub fn settling(starts: &Starts, eps: &Rational, within: &Rational) -> Result<Settling> {
    let runs = Runs::new(starts, eps)?;
    if !within.is_positive() {
        return Err(Error::input(format!("within: `{within}`: expected a positive distance")));
    }
    for bits in PRECISIONS {
        let Some(vector) = Perron::find(runs.count, bits) else {
            return Ok(Settling::Undecided);
        };
        if vector.factor_below(eps) >= Rational::one() {
            return Ok(match stays::decide(&runs, within) {
                Some(Stays::From(step, converges)) => Settling::Stays { step, converges },
                Some(Stays::Never) if !runs.every => Settling::NeverFromThisStart,
                _ => Settling::NotFromEveryStart(vector),
            });
        }
        let rate = vector.factor_above(eps);
        if rate >= Rational::one() {
            continue;
        }
        let step = runs.proved_step(&rate, within, |i| {
            Rational::from_integer(vector.weights.get(i - 1).cloned().unwrap_or_default())
        });
        let by_vector =
            step.map(|step| Proved { step, rate, by: Contraction::OwnVector(vector.clone()) });
        let proved: Vec<Proved> =
            runs.proved_for_every_n(within).into_iter().chain(by_vector).collect();
        let Some(at_most) = proved.iter().map(|p| p.step).min() else {
            return Ok(Settling::Undecided);
        };
        let not_before = runs.not_before(within, &vector);
        let observed = runs.observe(within, &vector, [not_before, at_most]);
        return Ok(Settling::Settles { proved, not_before, observed });
    }
    Ok(Settling::Undecided)
}

/// The runs, with their extreme starts.
struct Runs {
    count: usize,
    eps: Rational,
    /// The one start; or those of all starts in which some |e_i^k| is largest, one of two
    /// mirrored ones.
    extremes: Vec<Vec<Rational>>,
    /// Whether all starts are meant.
    every: bool,
}

impl Runs {
    fn new(starts: &Starts, eps: &Rational) -> Result<Self> {
        let (count, extremes) = match starts {
            Starts::One(start) => (start.len(), vec![start.clone()]),
            Starts::AllWithin(count) => (*count, extremes_within(*count, eps)),
        };
        if !DRONES.contains(&count) {
            return Err(Error::input(format!(
                "drones: `{count}`: expected a number from {} to {}",
                DRONES.start(),
                DRONES.end()
            )));
        }
        let every = matches!(starts, Starts::AllWithin(_));
        let runs = Self { count, eps: eps.clone(), extremes, every };
        for start in &runs.extremes {
            let (min, max) = ends(start);
            if min >= max {
                return Err(Error::input(format!(
                    "start: `{min}` ... `{max}`: expected the last position above the first"
                )));
            }
        }
        Ok(runs)
    }

    /// Largest |e_i^0| over the extreme starts, for every drone.
    fn initial_errors(&self) -> Vec<Rational> {
        let scale = Rational::from_integer((self.count - 1).into());
        let error = |start: &Vec<Rational>, i| {
            let (min, max) = ends(start);
            (scaled_error(&min, &max, start, i) / &scale).abs()
        };
        let largest = |i: usize| {
            // A mirrored start that was left out counts as well.
            let places = if self.every { [i, self.count - 1 - i] } else { [i, i] };
            let of = |start| places.map(|i| error(start, i)).into_iter().max();
            self.extremes.iter().filter_map(of).max().unwrap_or_default()
        };
        (0..self.count).map(largest).collect()
    }

    /// The contraction that holds for every N, where the weight is in its range.
    fn proved_for_every_n(&self, within: &Rational) -> Option<Proved> {
        let half = Rational::new(1.into(), 2.into());
        if !self.eps.is_positive() || self.eps > half {
            return None;
        }
        let last = BigInt::from(self.count - 1);
        let rate = Rational::one() - &self.eps * Rational::new(8.into(), &last * &last);
        let weight = |i| Rational::from_integer(contraction_weight(self.count, i).into());
        let step = self.proved_step(&rate, within, weight)?;
        Some(Proved { step, by: Contraction::EveryN, rate })
    }

    /// The least k for which rate^k * max_j(|e_j^0|/w_j) * w_i <= within for all i, or one
    /// more: powers are rounded up.
    fn proved_step(
        &self,
        rate: &Rational,
        within: &Rational,
        weight: impl Fn(usize) -> Rational,
    ) -> Option<u64> {
        let errors = self.initial_errors();
        let internal = 1..self.count - 1;
        let norm = internal.clone().map(|j| &errors[j] / weight(j)).max().unwrap_or_default();
        let heaviest = internal.map(weight).max().unwrap_or_default();
        if norm.is_zero() {
            return Some(0);
        }
        let target = within / (norm * heaviest);
        least_power_at_most(rate, &target, Rounding::Up)
    }

    /// A lower bound on the settling step: |e_i^k| >= c^k * min_j(|e_j^0|/w_j) * w_i where no
    /// cancellation occurs.
    fn not_before(&self, within: &Rational, vector: &Perron) -> u64 {
        let heaviest = vector.weights.iter().max().cloned().unwrap_or_default();
        let rate = vector.factor_below(&self.eps);
        let bound = |start: &Vec<Rational>| {
            let ratios = self.signed_errors(start).into_iter().zip(&vector.weights);
            let share = ratios.map(|(e, w)| e / Rational::from_integer(w.clone())).min();
            let share = share.unwrap_or_default() * Rational::from_integer(heaviest.clone());
            if !share.is_positive() {
                return 0;
            }
            least_power_at_most(&rate, &(within / share), Rounding::Down).unwrap_or_default()
        };
        self.extremes.iter().map(bound).max().unwrap_or_default()
    }

    /// The errors of the internal drones times the signs of the Perron vector (1, or (-1)^i
    /// beyond eps = 1/2), all turned so that the first is positive.
    fn signed_errors(&self, start: &[Rational]) -> Vec<Rational> {
        let (min, max) = ends(start);
        let scale = Rational::from_integer((self.count - 1).into());
        let alternate = beyond_half(&self.eps);
        let error = |i: usize| {
            let e = scaled_error(&min, &max, start, i) / &scale;
            if alternate && i.is_multiple_of(2) { -e } else { e }
        };
        let errors: Vec<Rational> = (1..self.count - 1).map(error).collect();
        match errors.first() {
            Some(first) if first.is_negative() => errors.into_iter().map(|e| -e).collect(),
            _ => errors,
        }
    }

    /// The true step, which is known to be in `between`.
    fn observe(&self, within: &Rational, vector: &Perron, between: [u64; 2]) -> Observed {
        let steps =
            self.extremes.iter().map(|start| self.observe_one(start, within, vector, between));
        // Undetermined as soon as one is.
        match steps.collect::<Option<Vec<u64>>>() {
            Some(steps) => Observed::Step(steps.into_iter().max().unwrap_or_default()),
            None => Observed::TooLong,
        }
    }

    /// The run in integers over a common denominator.
    fn line(&self, start: &[Rational]) -> Option<Line> {
        let (min, max) = ends(start);
        Line::coverage(&Params { min, max, eps: self.eps.clone(), n: 0 }, start).ok()
    }

    fn observe_one(
        &self,
        start: &[Rational],
        within: &Rational,
        vector: &Perron,
        [not_before, at_most]: [u64; 2],
    ) -> Option<u64> {
        let budget = MOST_DRONE_STEPS / self.count as u64;
        // Jumps are cheaper than that many steps.
        if at_most > budget / 50
            && let Some(step) = within::first_step(&self.line(start)?, within, engine::multiplier())
        {
            return Some(step);
        }
        if not_before > budget {
            return None;
        }
        settling_step(start, &self.eps, within, vector, [at_most, budget], Enclosure::<BITS>::of)
            .or_else(|| {
                // Distances that the usual enclosures cannot resolve.
                let small = within.denom().bits().saturating_sub(within.numer().bits());
                if small + 64 < u64::from(BITS) {
                    return None;
                }
                let steps = budget / u64::from(FINE_BITS / BITS);
                let steps = [at_most, steps];
                settling_step(start, &self.eps, within, vector, steps, Enclosure::<FINE_BITS>::of)
            })
            .or_else(|| {
                // N k^2 at most the limit.
                let steps = (MOST_EXACT_WORK / self.count as u64).isqrt();
                settling_step(start, &self.eps, within, vector, [at_most, steps], Rational::clone)
            })
    }
}

/// Where the least eigenvalue of A may be the one of largest modulus, and |A| is not A.
fn beyond_half(eps: &Rational) -> bool {
    eps * Rational::from_int(2) > Rational::one()
}

fn ends(start: &[Rational]) -> (Rational, Rational) {
    (start.first().cloned().unwrap_or_default(), start.last().cloned().unwrap_or_default())
}

/// The starts on \[0, 1\] in which the errors are largest at every later step.
///
/// A^k has the signs of A^k with A >= 0 for eps <= 1/2, and those of (-1)^k S |A|^k S with
/// S = diag((-1)^i) beyond: |e_i^k| is largest where every e_j^0 is at its end of
/// \[T_j - 1, T_j\] with the sign that its column has, or with all signs reversed.
fn extremes_within(count: usize, eps: &Rational) -> Vec<Vec<Rational>> {
    let alternate = beyond_half(eps);
    let place = |i: usize, reverse: bool| {
        let to_max = (alternate && i % 2 == 1) != reverse;
        let at_max = i + 1 == count || (i > 0 && to_max);
        if at_max { Rational::one() } else { Rational::zero() }
    };
    let [one, other] = [false, true]
        .map(|reverse| -> Vec<Rational> { (0..count).map(|i| place(i, reverse)).collect() });
    // The protocol is its own mirror image: what it does from one of two mirrored starts, it
    // does from the other.
    let mirrored: Vec<Rational> = one.iter().rev().map(|x| Rational::one() - x).collect();
    if mirrored == other { vec![one] } else { vec![one, other] }
}
