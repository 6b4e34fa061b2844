//! Settling: from which step on every drone is within a given distance of its target.
//!
//! *Proved* steps follow from a contraction |A| w <= c w (PROTOCOL section 2): after k steps
//! |e_i| <= c^k * max_j(|e_j^0|/w_j) * w_i. The *true* step comes from running the spec, and
//! from a norm that no step increases, which is what makes "from then on" final.

use std::cmp::Ordering;

use cordon_spec::coverage::exec_coverage;
use cordon_spec::placement::{contraction_weight, scaled_error};
use cordon_spec::{Ordered, Params, Scalar, State};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::linear::enclosure::Enclosure;
use crate::linear::perron::Perron;
use crate::{Error, Rational, Result};

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
    /// The contraction.
    pub by: Contraction,
    /// Its factor c, below 1.
    pub rate: Rational,
}

/// The true settling step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Observed {
    /// Established on enclosures or, where these could not tell, on exact fractions.
    Step(u64),
    /// The run is longer than the limit on work: not determined.
    TooLong,
}

/// What is known about settling.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Settling {
    /// Every run converges; proved steps, the weakest first, and the true one.
    Settles {
        /// At least one.
        proved: Vec<Proved>,
        /// The true step.
        observed: Observed,
    },
    /// Some run does not converge: |A| w >= w for this positive w.
    NotFromEveryStart(Perron),
    /// The weight is too near the critical one for the precision tried.
    Undecided,
}

/// Bits of the Perron vectors tried, the first that decides wins.
const PRECISIONS: [u64; 3] = [40, 160, 1_300];

/// Most drone steps on enclosures: a minute or so.
const MOST_DRONE_STEPS: u64 = 20_000_000;

/// Most of N * k^2 on exact fractions, whose length grows with k: a minute or so.
const MOST_EXACT_WORK: u64 = 20_000_000;

/// Bits after the point of the enclosures.
const BITS: u32 = 256;

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
            return Ok(Settling::NotFromEveryStart(vector));
        }
        let rate = vector.factor_above(eps);
        if rate >= Rational::one() {
            continue;
        }
        let observed = runs.observe(within, &vector);
        let by_vector = Proved {
            step: runs.proved_step(&rate, within, |i| {
                Rational::from_integer(vector.weights.get(i - 1).cloned().unwrap_or_default())
            }),
            rate,
            by: Contraction::OwnVector(vector),
        };
        let mut proved: Vec<Proved> = runs.proved_for_every_n(within).into_iter().collect();
        proved.push(by_vector);
        return Ok(Settling::Settles { proved, observed });
    }
    Ok(Settling::Undecided)
}

/// The runs, with their extreme starts.
struct Runs {
    count: usize,
    eps: Rational,
    /// The one start; or those of all starts in which some |e_i^k| is largest.
    extremes: Vec<Vec<Rational>>,
}

impl Runs {
    fn new(starts: &Starts, eps: &Rational) -> Result<Self> {
        let (count, extremes) = match starts {
            Starts::One(start) => (start.len(), vec![start.clone()]),
            Starts::AllWithin(count) => (*count, extremes_within(*count, eps)),
        };
        if !(3..=10_000).contains(&count) {
            return Err(Error::input(format!(
                "drones: `{count}`: expected a number from 3 to 10000"
            )));
        }
        let runs = Self { count, eps: eps.clone(), extremes };
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
        let largest = |i| self.extremes.iter().map(|s| error(s, i)).max().unwrap_or_default();
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
        let step = self.proved_step(&rate, within, weight);
        Some(Proved { step, by: Contraction::EveryN, rate })
    }

    /// The least k for which rate^k * max_j(|e_j^0|/w_j) * w_i <= within for all i, or one
    /// more: powers are rounded up.
    fn proved_step(
        &self,
        rate: &Rational,
        within: &Rational,
        weight: impl Fn(usize) -> Rational,
    ) -> u64 {
        let errors = self.initial_errors();
        let internal = 1..self.count - 1;
        let norm = internal.clone().map(|j| &errors[j] / weight(j)).max().unwrap_or_default();
        let heaviest = internal.map(weight).max().unwrap_or_default();
        if norm.is_zero() {
            return 0;
        }
        let target = within / (norm * heaviest);
        least_power_at_most(rate, &target)
    }

    fn observe(&self, within: &Rational, vector: &Perron) -> Observed {
        let mut last = 0;
        for start in &self.extremes {
            let budget = MOST_DRONE_STEPS / self.count as u64 / self.extremes.len() as u64;
            let enclosed =
                settling_step(start, &self.eps, within, vector, budget, Enclosure::<BITS>::of);
            let step = enclosed.or_else(|| {
                // N k^2 at most the limit.
                let steps = (MOST_EXACT_WORK / self.count as u64).isqrt();
                settling_step(start, &self.eps, within, vector, steps, Rational::clone)
            });
            match step {
                Some(step) => last = last.max(step),
                None => return Observed::TooLong,
            }
        }
        Observed::Step(last)
    }
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
    let alternate = eps * Rational::from_int(2) > Rational::one();
    let place = |i: usize, reverse: bool| {
        let to_max = (alternate && i % 2 == 1) != reverse;
        let at_max = i + 1 == count || (i > 0 && to_max);
        if at_max { Rational::one() } else { Rational::zero() }
    };
    [false, true].map(|reverse| (0..count).map(|i| place(i, reverse)).collect()).to_vec()
}

/// The first step from which on every error of the run is at most `within`; `None` where the
/// scalars cannot tell, or the run is longer than `steps`.
fn settling_step<S: Ordered>(
    start: &[Rational],
    eps: &Rational,
    within: &Rational,
    vector: &Perron,
    steps: u64,
    scalar: impl Fn(&Rational) -> S,
) -> Option<u64> {
    let count = start.len();
    let (min, max) = ends(start);
    let params = Params { min: scalar(&min), max: scalar(&max), eps: scalar(eps), n: 0 };
    // Errors come multiplied by N-1.
    let bound = scalar(&(within * Rational::from_integer((count - 1).into())));
    let norm = NormBound::new(eps, vector, &bound, &scalar);
    let mut state = State { drones: start.iter().map(&scalar).collect::<Vec<S>>(), timesteps: 0 };
    let mut settled_from = 0;
    for k in 0..=steps {
        let errors = (1..count - 1)
            .map(|i| scaled_error(&params.min, &params.max, &state.drones, i))
            .collect::<Vec<S>>();
        if !all_at_most(&errors, |_| &bound)? {
            settled_from = k + 1;
        } else if norm.settles(&errors)? {
            return Some(settled_from);
        }
        state = exec_coverage(&params, &state);
    }
    None
}

/// |e_i| <= f w_i for all i, with f as large as keeps every f w_i within the distance. No step
/// leaves that region, whatever step it is met at.
struct NormBound<S> {
    /// Nothing to be checked beyond the distance itself: w = (1, ..., 1), for eps <= 1/2.
    weights: Option<Vec<S>>,
}

impl<S: Ordered> NormBound<S> {
    fn new(eps: &Rational, vector: &Perron, bound: &S, scalar: &impl Fn(&Rational) -> S) -> Self {
        if eps * Rational::from_int(2) <= Rational::one() {
            return Self { weights: None };
        }
        let heaviest = vector.weights.iter().max().cloned().unwrap_or_default();
        let share = |w: &BigInt| scalar(&Rational::new(w.clone(), heaviest.clone()));
        let weights = vector.weights.iter().map(|w| share(w) * bound).collect();
        Self { weights: Some(weights) }
    }

    /// `Some(true)` only where the region is certainly met.
    fn settles(&self, errors: &[S]) -> Option<bool> {
        match &self.weights {
            None => Some(true),
            // An unknown answer means one more step, nothing worse.
            Some(weights) => Some(all_at_most(errors, |i| &weights[i]).unwrap_or(false)),
        }
    }
}

/// Whether |e_i| <= limit(i) for all i.
fn all_at_most<'a, S: Ordered + 'a>(errors: &[S], limit: impl Fn(usize) -> &'a S) -> Option<bool> {
    let mut all = Some(true);
    for (i, e) in errors.iter().enumerate() {
        let above = e.compare(limit(i));
        let below = (S::from_int(0) - e).compare(limit(i));
        for side in [above, below] {
            match side {
                Some(Ordering::Greater) => return Some(false),
                Some(_) => {}
                None => all = None,
            }
        }
    }
    all
}

/// The least k with factor^k <= target, or one that is larger by rounding; 0 <= factor < 1.
fn least_power_at_most(factor: &Rational, target: &Rational) -> u64 {
    if *target >= Rational::one() {
        return 0;
    }
    // Fixed point with enough bits for the target, powers rounded up.
    let bits = 128 + target.denom().bits();
    let scale = BigInt::one() << bits;
    let fixed = (factor * Rational::from_integer(scale.clone())).ceil().to_integer();
    let target = (target * Rational::from_integer(scale.clone())).floor().to_integer();
    let times = |a: &BigInt, b: &BigInt| -(-(a * b) >> bits);
    // Squares up to the first below the target, then down the binary digits of k - 1.
    let mut squares = vec![fixed];
    while let Some(last) = squares.last().filter(|&last| *last > target && squares.len() < 63) {
        squares.push(times(last, last));
    }
    let (mut power, mut k) = (scale, 0_u64);
    for (digit, square) in squares.iter().enumerate().rev() {
        let next = times(&power, square);
        if next > target {
            power = next;
            k += 1 << digit;
        }
    }
    k + 1
}
