//! Very large swarms in doubles, with a rigorous bound on the distance from the exact run.
//!
//! The weights are those of the spec. The bound is a forward error analysis of exactly the loop that
//! runs: its operations, neither fused nor reordered, each have a relative error of at most 2^-53 (and
//! an absolute one of 2^-1074 where a result is subnormal).

use std::ops::RangeInclusive;

use num_bigint::BigInt;
use num_traits::Signed;
use rayon::prelude::*;

use crate::fast::line::LineWeights;
use cordon_core::{Error, Rational, Result, exact, progress};

/// The unit roundoff of doubles.
const ROUNDOFF: f64 = 1.0 / (1u64 << 53) as f64;

/// An upper bound for the absolute errors of the four operations of an update in the subnormal range.
const TINY: f64 = 1e-320;

/// Supported numbers of drones.
pub const DRONES: RangeInclusive<usize> = 3..=100_000_000;

/// A swarm during its run.
#[derive(Clone, Debug)]
pub struct Swarm {
    positions: Vec<f64>,
    side: f64,
    centre: f64,
    /// An upper bound for the sum of the weights' magnitudes.
    total: f64,
    steps: u64,
    /// An upper bound for every |position|.
    largest: f64,
    error: f64,
}

/// Slightly more than `x >= 0`: covers the rounding errors of the few operations that led to it.
fn up(x: f64) -> f64 {
    x * (1.0 + 32.0 * ROUNDOFF) + TINY
}

impl Swarm {
    /// The swarm of the coverage protocol with the given start; drone 0 stays at the first position and
    /// drone N-1 at the last.
    ///
    /// # Errors
    /// A number of drones out of range, positions or a weight beyond the range of doubles.
    pub fn new(eps: &Rational, start: &[Rational]) -> Result<Self> {
        let positions: Vec<f64> = start.iter().map(exact::to_f64).collect();
        let largest = positions.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        Self::assemble(eps, positions, up(largest), up(ROUNDOFF * largest))
    }

    /// N drones, drone i at `min + i*(to - min)/(N-1)` and the last at `max`.
    ///
    /// # Errors
    /// As [`Swarm::new`].
    pub fn spread(eps: &Rational, count: usize, [min, max, to]: [&Rational; 3]) -> Result<Self> {
        refuse_count(count)?;
        let gaps = Rational::from_integer((count - 1).into());
        let (first, last) = (exact::to_f64(min), exact::to_f64(max));
        let spacing = exact::to_f64(&((to - min) / gaps));
        // An index below 2^53 is exact.
        let place = |i: usize| if i + 1 == count { last } else { first + i as f64 * spacing };
        let positions: Vec<f64> = (0..count).map(place).collect();
        let reach = first.abs() + (count as f64 * spacing).abs() + last.abs();
        // Start, spacing, product and sum each have one rounding error.
        Self::assemble(eps, positions, up(reach), up(4.0 * ROUNDOFF * up(reach)))
    }

    fn assemble(eps: &Rational, positions: Vec<f64>, largest: f64, error: f64) -> Result<Self> {
        refuse_count(positions.len())?;
        let LineWeights { side, centre, den } = LineWeights::of(eps)?;
        let ratio = |w: BigInt| Rational::new(w, den.clone());
        let total = exact::to_f64(&ratio(side.abs() * 2 + centre.abs()));
        let (side, centre) = (exact::to_f64(&ratio(side)), exact::to_f64(&ratio(centre)));
        let subnormal = [side, centre].iter().any(|w| *w != 0.0 && !w.is_normal());
        if subnormal || !total.is_finite() {
            return Err(Error::input(format!("eps: `{eps}`: expected a weight that doubles hold")));
        }
        if !largest.is_finite() {
            return Err(Error::input("start: expected positions that doubles hold"));
        }
        // A sum of weights that is exactly 1 needs no rounding up.
        let total =
            if total == 1.0 && !eps.is_negative() && *eps <= half() { 1.0 } else { up(total) };
        Ok(Self { positions, side, centre, total, steps: 0, largest, error })
    }

    /// Protocol steps so far.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The positions, each within [`Swarm::error`] of the exact one.
    pub fn positions(&self) -> &[f64] {
        &self.positions
    }

    /// An upper bound for the distance of every position from the exact run. Infinite once positions
    /// may have left the range of doubles.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Advances all drones by `steps` protocol steps, on all cores; the result does not depend on their
    /// number.
    pub fn advance(&mut self, steps: u64) {
        progress::expect(steps);
        let mut next = vec![0.0; self.positions.len()];
        let mut left = steps;
        while left > 0 {
            // At most STRIDE.
            let now = left.min(STRIDE as u64) as usize;
            next.par_chunks_mut(BLOCK)
                .enumerate()
                .for_each(|(block, into)| self.advance_block(block * BLOCK, into, now));
            std::mem::swap(&mut self.positions, &mut next);
            (0..now).for_each(|_| self.account());
            left -= now as u64;
            self.steps += now as u64;
            progress::advance(now as u64);
        }
    }

    /// The effect of one step on the bounds. With positions x, true positions X, |x - X| <= e and |x|
    /// <= m, the update `side*(a + c) + centre*b` with rounded weights has an error of at most
    /// `total*e` from its operands plus four roundoffs of `total*m` from its own operations.
    fn account(&mut self) {
        let own = up(4.0 * ROUNDOFF * up(self.total * self.largest));
        let inherited = if self.total == 1.0 { self.error } else { up(self.total * self.error) };
        let carried = if self.total == 1.0 { self.largest } else { up(self.total * self.largest) };
        self.error = up(inherited + own);
        self.largest = up(carried + own);
        if !self.largest.is_finite() {
            self.error = f64::INFINITY;
        }
    }

    /// `steps` steps of the drones `first ..`, as many as `into` holds. The neighbours that they depend
    /// on are stepped as well and then dropped: at the edge of the window (unless it is an end drone)
    /// one more drone becomes wrong with each step.
    fn advance_block(&self, first: usize, into: &mut [f64], steps: usize) {
        let from = first.saturating_sub(steps);
        let to = (first + into.len() + steps).min(self.positions.len());
        let mut now = self.positions[from..to].to_vec();
        let mut next = now.clone();
        for _ in 0..steps {
            update(&mut next, &now, self.side, self.centre);
            std::mem::swap(&mut now, &mut next);
        }
        into.copy_from_slice(&now[first - from..][..into.len()]);
    }

    /// The smallest gap between neighbours, and a bound on its error.
    pub fn smallest_gap(&self) -> (f64, f64) {
        let gaps = self.positions.iter().zip(self.positions.iter().skip(1)).map(|(a, b)| b - a);
        let smallest = gaps.fold(f64::INFINITY, f64::min);
        (smallest, up(2.0 * self.error + 4.0 * ROUNDOFF * self.largest))
    }

    /// The largest distance of a drone from its target, and a bound on its error.
    pub fn largest_deviation(&self) -> (f64, f64) {
        let (Some(&min), Some(&max)) = (self.positions.first(), self.positions.last()) else {
            return (0.0, 0.0);
        };
        let gaps = (self.positions.len() - 1) as f64;
        let target = |i: usize| min + (max - min) * (i as f64 / gaps);
        let away = self.positions.iter().enumerate().map(|(i, x)| (x - target(i)).abs());
        let largest = away.fold(0.0, f64::max);
        // The error of a target: that of the ends and of five operations; then that of the difference.
        (largest, up(4.0 * self.error + 24.0 * ROUNDOFF * self.largest))
    }
}

/// Drones that one task steps at a time, so that two copies fit a core's cache.
const BLOCK: usize = 8192;

/// Steps that a task does before it writes back.
const STRIDE: usize = 128;

/// One step of all drones except the first and the last, which stay.
fn update(next: &mut [f64], now: &[f64], side: f64, centre: f64) {
    let (Some(before), Some(own), Some(after)) =
        (now.get(..now.len() - 2), now.get(1..now.len() - 1), now.get(2..))
    else {
        return;
    };
    for (((x, a), b), c) in next.iter_mut().skip(1).zip(before).zip(own).zip(after) {
        *x = side * (a + c) + centre * b;
    }
}

fn half() -> Rational {
    Rational::new(1.into(), 2.into())
}

fn refuse_count(count: usize) -> Result<()> {
    if DRONES.contains(&count) {
        return Ok(());
    }
    Err(Error::input(format!(
        "drones: `{count}`: expected {} to {} drones",
        DRONES.start(),
        DRONES.end()
    )))
}
