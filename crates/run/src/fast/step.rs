//! The stepping engine: every protocol step, on integers over the common denominator Q^k.
//!
//! No gcd, no allocation and no branch on a value in the loop (`Numbers`).

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use super::answer::Answer;
use super::growth::{Growth, limbs_for, longest};
use super::limbs;
use super::line::{Ends, Line};
use cordon_core::Result;

/// The positions after each of `steps`, which may come in any order and more than once.
///
/// # Errors
/// An answer longer than the memory limit.
pub fn at(line: &Line, steps: &[u64]) -> Result<Vec<Answer>> {
    let last = steps.iter().copied().max().unwrap_or(0);
    line.refuse_beyond_memory("at", last)?;
    let mut wanted = steps.to_vec();
    wanted.sort_unstable();
    wanted.dedup();
    let mut run = Run::new(line.clone(), last);
    let found: Vec<Answer> = wanted.into_iter().map(|k| run.advance_to(k).answer()).collect();
    let at = |k| found.binary_search_by_key(k, |a: &Answer| a.k);
    Ok(steps.iter().filter_map(|k| found.get(at(k).ok()?).cloned()).collect())
}

/// A weight: sign and magnitude.
pub(super) struct Weight {
    pub magnitude: Vec<u64>,
    pub negative: bool,
}

impl Weight {
    pub fn of(w: &BigInt) -> Self {
        Self { magnitude: w.magnitude().to_u64_digits(), negative: w.is_negative() }
    }

    /// Magnitude and the mask that complements a limb where the weight is negative, if the
    /// magnitude is small enough for [`fused`].
    fn short(&self) -> Option<(u64, u64)> {
        let mask = if self.negative { u64::MAX } else { 0 };
        match self.magnitude.as_slice() {
            [] => Some((0, 0)),
            [w] if *w < 1 << 62 => Some((*w, mask)),
            _ => None,
        }
    }
}

/// A run under way.
pub struct Run {
    line: Line,
    k: u64,
    side: Weight,
    centre: Weight,
    den: Weight,
    numbers: Numbers,
}

impl Run {
    /// The run of a line, which may be advanced to step `last` and no further.
    pub fn new(line: Line, last: u64) -> Self {
        let start: Vec<BigInt> = line.start().collect();
        Self {
            k: 0,
            side: Weight::of(&line.side),
            centre: Weight::of(&line.centre),
            den: Weight::of(&line.den),
            numbers: Numbers::new(&start, Growth::of(&line.growth()), last),
            line,
        }
    }

    /// Steps until `k` steps have been made.
    pub fn advance_to(&mut self, k: u64) -> &Self {
        while self.k < k {
            self.step();
        }
        self
    }

    /// One protocol step of every drone.
    fn step(&mut self) {
        self.k += 1;
        self.numbers.widen(self.k);
        let Numbers { stride, width, now, next, .. } = &mut self.numbers;
        let (stride, width) = (*stride, *width);
        let row = |i: usize| &now[i * stride..i * stride + width];
        let last = now.len() / stride - 1;
        let nothing = Weight::of(&BigInt::zero());
        for (i, into) in next.chunks_exact_mut(stride).enumerate() {
            let into = &mut into[..width];
            let (before, own, after) = (i.saturating_sub(1), i, (i + 1).min(last));
            let at_end = i == 0 || i == last;
            let (side, centre) = match self.line.ends {
                Ends::Fixed if at_end => (&nothing, &self.den),
                // At a free end the mirror image beyond it is the drone itself.
                Ends::Fixed | Ends::Free => (&self.side, &self.centre),
            };
            combine(into, [row(before), row(own), row(after)], side, centre);
        }
        std::mem::swap(now, next);
    }

    /// The exact positions after the steps made so far.
    pub fn answer(&self) -> Answer {
        Answer {
            k: self.k,
            numerators: self.numbers.integers(),
            base: self.line.base.clone(),
            den: self.line.den.clone(),
        }
    }
}

/// The numbers of a run, before and after a step, in two flat buffers in two's complement: as long
/// as the last step needs; a step works on as many limbs as its own numbers may have.
pub(super) struct Numbers {
    growth: Growth,
    start_bits: u64,
    /// Limbs from one number to the next.
    pub stride: usize,
    /// Limbs in use.
    pub width: usize,
    pub now: Vec<u64>,
    pub next: Vec<u64>,
}

impl Numbers {
    /// The start, with room for as many steps as `last`, in each of which numbers grow so.
    pub fn new(start: &[BigInt], growth: Growth, last: u64) -> Self {
        // One bit for the sign.
        let start_bits = longest(start) + 1;
        let stride = limbs_for(growth.bits(last) + start_bits);
        let width = limbs_for(growth.bits(0) + start_bits);
        let mut now = vec![0; stride * start.len()];
        for (row, x) in now.chunks_exact_mut(stride).zip(start) {
            limbs::write(&mut row[..width], x);
        }
        Self { growth, start_bits, stride, width, next: now.clone(), now }
    }

    /// Continues the sign of every number into the limbs that come into use in step `k`.
    pub fn widen(&mut self, k: u64) {
        let width = limbs_for(self.growth.bits(k) + self.start_bits).min(self.stride);
        if width > self.width {
            for row in self.now.chunks_exact_mut(self.stride) {
                let sign = if limbs::is_negative(&row[..self.width]) { u64::MAX } else { 0 };
                row[self.width..width].fill(sign);
            }
            self.width = width;
        }
    }

    /// The numbers after the steps made so far.
    pub fn integers(&self) -> Vec<BigInt> {
        let mut scratch = vec![0; self.width];
        let number = |row: &[u64]| {
            scratch.copy_from_slice(&row[..self.width]);
            limbs::integer(&mut scratch)
        };
        self.now.chunks_exact(self.stride).map(number).collect()
    }
}

/// `into = side*before + centre*own + side*after` in two's complement, all of one length.
fn combine(into: &mut [u64], from: [&[u64]; 3], side: &Weight, centre: &Weight) {
    match (side.short(), centre.short()) {
        (Some(s @ (1, 0)), Some(c)) => fused::<true>(into, from, s, c),
        (Some(s), Some(c)) => fused::<false>(into, from, s, c),
        _ => {
            let [before, own, after] = from;
            into.fill(0);
            limbs::accumulate(into, before, &side.magnitude, side.negative);
            limbs::accumulate(into, own, &centre.magnitude, centre.negative);
            limbs::accumulate(into, after, &side.magnitude, side.negative);
        }
    }
}

/// One pass over the limbs. A negative weight -w counts through -w*x = w*(!x) + w, so that
/// the loop has no signs. `UNIT` says that the neighbours' weight is 1.
fn fused<const UNIT: bool>(
    into: &mut [u64],
    [before, own, after]: [&[u64]; 3],
    (side, side_mask): (u64, u64),
    (centre, centre_mask): (u64, u64),
) {
    // Below 3 * 2^62.
    let mut carry = ((side * 2) & side_mask) + (centre & centre_mask);
    let neighbours = before.iter().zip(after);
    for ((x, &b), (&a, &c)) in into.iter_mut().zip(own).zip(neighbours) {
        // Weights are below 2^62: 2^62 * 2^65 + 2^62 * 2^64 + carry is below 2^128.
        let pair = if UNIT {
            u128::from(a) + u128::from(c)
        } else {
            u128::from(side) * (u128::from(a ^ side_mask) + u128::from(c ^ side_mask))
        };
        let sum = pair + u128::from(centre) * u128::from(b ^ centre_mask) + u128::from(carry);
        *x = sum as u64;
        carry = (sum >> 64) as u64;
    }
}
