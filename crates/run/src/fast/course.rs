//! An own protocol in integers: sparse matrices over one common denominator.
//!
//! With `D = base` and `Q = den` every state variable after k steps is an integer over `D * Q^k`.
//! `Q^k` itself is the last number of the state, so that constants are coefficients like others: a
//! step is one matrix with integer entries.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::answer::Answer;
use super::growth::{
    Growth, MAX_ANSWER_BYTES, MAX_STEPPING, limbs_for, log2_above, longest, readable,
};
use super::limbs;
use super::step::{Numbers, Weight};
use crate::scenario::Own;
use cordon_core::system::Map;
use cordon_core::{Error, Rational, Result};

/// A matrix with integer entries: of each row those that are not 0, by column.
pub(super) type Matrix = Vec<Vec<(usize, BigInt)>>;

/// A run that is known up to some step.
#[derive(Clone, Debug)]
pub struct Course {
    maps: Maps,
    /// The common denominator Q of the coefficients, positive.
    pub den: BigInt,
    /// The common denominator D of start and constants, positive.
    pub base: BigInt,
    /// D times the start, and 1.
    pub start: Vec<BigInt>,
    /// No number of the state grows faster than by this factor a step.
    growth: BigInt,
    /// Entries of a step's matrix.
    entries: usize,
}

#[derive(Clone, Debug)]
enum Maps {
    /// In turn.
    Cycle(Vec<Matrix>),
    /// Drawn anew for each step.
    Drawn(Box<Own>),
}

impl Course {
    /// The run by maps that act in turn, for ever, from a whole state.
    pub fn in_turn(maps: &[Map], start: &[Rational]) -> Self {
        let mut course = Self::over(start, &mut |see| maps.iter().for_each(see));
        let (base, den) = (&course.base, &course.den);
        course.maps = Maps::Cycle(maps.iter().map(|m| matrix(m, base, den)).collect());
        course
    }

    /// The run of an own protocol whose choices are drawn, up to step `last`.
    pub fn drawn(own: &Own, start: &[Rational], last: u64) -> Self {
        let mut course = Self::over(start, &mut |see| (1..=last).for_each(|k| see(&own.map(k))));
        course.maps = Maps::Drawn(own.clone().into());
        course
    }

    /// Common denominators and growth of the maps that `each` shows.
    fn over(start: &[Rational], each: Each<'_>) -> Self {
        let mut den = BigInt::one();
        let mut base = start.iter().fold(BigInt::one(), |base, x| base.lcm(x.denom()));
        each(&mut |map| {
            for (constant, row) in &map.rows {
                base = base.lcm(constant.denom());
                den = row.iter().fold(std::mem::take(&mut den), |den, (_, a)| den.lcm(a.denom()));
            }
        });
        let (mut growth, mut entries) = (den.clone(), 0);
        each(&mut |map| {
            let matrix = matrix(map, &base, &den);
            let sum = |row: &Vec<(usize, BigInt)>| row.iter().map(|(_, a)| a.abs()).sum::<BigInt>();
            growth = matrix.iter().map(sum).fold(std::mem::take(&mut growth), BigInt::max);
            entries = entries.max(matrix.iter().map(Vec::len).sum());
        });
        let whole = |x: &Rational| x.numer() * (&base / x.denom());
        let start = start.iter().map(whole).chain([BigInt::one()]).collect();
        Self { maps: Maps::Cycle(Vec::new()), den, base, start, growth, entries }
    }

    /// The matrices that act in turn; `None` where they are drawn.
    pub(super) fn cycle(&self) -> Option<&[Matrix]> {
        match &self.maps {
            Maps::Cycle(maps) => Some(maps),
            Maps::Drawn(_) => None,
        }
    }

    pub(super) fn log2_growth(&self) -> f64 {
        log2_above(&self.growth)
    }

    /// A bound of the bits of every numerator after k steps, without its sign.
    pub fn numerator_bits(&self, k: u64) -> u64 {
        Growth::of(&self.growth).bits(k).saturating_add(longest(&self.start))
    }

    /// Refuses answers beyond memory; `field` is what k was given for.
    ///
    /// # Errors
    /// The answer after k steps would be longer than `MAX_ANSWER_BYTES`: says how long.
    pub fn refuse_beyond_memory(&self, field: &str, k: u64) -> Result<()> {
        let each = self.numerator_bits(k) / 8 + 8;
        let bytes = each.saturating_mul(self.start.len() as u64);
        if bytes <= MAX_ANSWER_BYTES {
            return Ok(());
        }
        Err(Error::input(format!(
            "{field}: `{k}`: {} exact state variables after so many steps take about {}: expected at \
             most {}",
            self.start.len() - 1,
            readable(bytes),
            readable(MAX_ANSWER_BYTES)
        )))
    }

    /// Refuses a run that makes every step up to step `last` and would never end; `field` is what `given`
    /// was given for.
    ///
    /// # Errors
    /// The steps take more than `MAX_STEPPING`: says how long the numbers become.
    pub fn refuse_endless(&self, field: &str, given: u64, last: u64) -> Result<()> {
        if self.stepping(last) <= MAX_STEPPING {
            return Ok(());
        }
        Err(Error::input(format!(
            "{field}: `{given}`: expected fewer: {} state variables make numbers of {} bits by then",
            self.start.len() - 1,
            self.numerator_bits(last)
        )))
    }

    /// As [`Self::refuse_endless`], before all the steps are drawn: a few show how large the numbers of
    /// all get.
    ///
    /// # Errors
    /// As there.
    pub fn refuse_endless_draws(
        own: &Own,
        start: &[Rational],
        field: &str,
        given: u64,
        last: u64,
    ) -> Result<()> {
        Self::drawn(own, start, last.min(64)).refuse_endless(field, given, last)
    }

    /// What all steps up to step k cost, in the units of the cost model.
    pub fn stepping(&self, k: u64) -> f64 {
        let mean = self.log2_growth() * k as f64 / 128.0 + longest(&self.start) as f64 / 64.0 + 1.0;
        let weight = limbs_for(longest(std::iter::once(&self.growth))).to_f64().unwrap_or(1.0);
        self.entries as f64 * k as f64 * (mean * weight + 10.0)
    }
}

/// Shows what it is given every map of a run.
type Each<'e> = &'e mut dyn FnMut(&mut dyn FnMut(&Map));

/// The map as a matrix of numerators, the power of Q last.
fn matrix(map: &Map, base: &BigInt, den: &BigInt) -> Matrix {
    let last = map.rows.len();
    let whole = |a: &Rational, scale: &BigInt| a.numer() * (scale / a.denom());
    let row = |(constant, row): &(Rational, Vec<(usize, Rational)>)| {
        let constant = (!constant.is_zero()).then(|| (last, whole(constant, base) * den));
        row.iter().map(|(j, a)| (*j, whole(a, den))).chain(constant).collect()
    };
    map.rows.iter().map(row).chain([vec![(last, den.clone())]]).collect()
}

/// A run under way.
pub struct Run {
    course: Course,
    /// Of the matrices that act in turn, the weights.
    cycle: Vec<Weights>,
    /// The steps that the course's start has behind it.
    behind: u64,
    k: u64,
    numbers: Numbers,
}

type Weights = Vec<Vec<(usize, Weight)>>;

fn weights(matrix: &Matrix) -> Weights {
    let row = |row: &Vec<(usize, BigInt)>| row.iter().map(|(j, a)| (*j, Weight::of(a))).collect();
    matrix.iter().map(row).collect()
}

impl Run {
    /// The run of a course, which may be advanced to step `last` of the course and no further.
    pub fn new(course: Course, last: u64) -> Self {
        Self::onward(course, 0, last)
    }

    /// The run from the course's start on, which is the state after `k` steps.
    pub(super) fn onward(course: Course, k: u64, last: u64) -> Self {
        let left = last.saturating_sub(k);
        let numbers = Numbers::new(&course.start, Growth::of(&course.growth), left);
        let cycle = course.cycle().unwrap_or_default().iter().map(weights).collect();
        Self { course, cycle, behind: k, k, numbers }
    }

    /// Steps until `k` steps have been made.
    pub fn advance_to(&mut self, k: u64) -> &Self {
        while self.k < k {
            self.k += 1;
            self.numbers.widen(self.k - self.behind);
            self.step();
        }
        self
    }

    fn step(&mut self) {
        let drawn;
        let turn = (self.k - 1) % (self.cycle.len() as u64).max(1);
        let weights = match (&self.course.maps, self.cycle.get(turn as usize)) {
            (Maps::Drawn(own), _) => {
                drawn = weights(&matrix(&own.map(self.k), &self.course.base, &self.course.den));
                &drawn
            }
            (Maps::Cycle(_), Some(weights)) => weights,
            (Maps::Cycle(_), None) => return,
        };
        let Numbers { stride, width, now, next, .. } = &mut self.numbers;
        let (stride, width) = (*stride, *width);
        for (row, into) in weights.iter().zip(next.chunks_exact_mut(stride)) {
            let into = &mut into[..width];
            into.fill(0);
            for (j, weight) in row {
                let from = &now[j * stride..j * stride + width];
                limbs::accumulate(into, from, &weight.magnitude, weight.negative);
            }
        }
        std::mem::swap(now, next);
    }

    /// The exact state after the steps made so far.
    pub fn answer(&self) -> Answer {
        let mut numerators = self.numbers.integers();
        numerators.pop();
        let (base, den) = (self.course.base.clone(), self.course.den.clone());
        Answer { k: self.k, numerators, base, den }
    }
}
