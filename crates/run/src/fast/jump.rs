//! The jump engine: the positions after k steps without the steps between.
//!
//! With fixed ends the deviations from the targets continue oddly beyond the ends, to a ring
//! of `2(N-1)` places on which every place obeys the same rule; with free ends (consensus) the
//! positions continue evenly, to a ring of `2N`. There k steps are one convolution with the
//! k-th power of the kernel (`kernel.rs`).

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use super::answer::Answer;
use super::growth::{limbs_for, longest};
use super::kernel::Kernel;
use super::limbs;
use super::line::{Ends, Line};
use super::multiply::Multiply;
use super::power;
use cordon_core::Result;

/// The positions after each of `steps`, which may come in any order and more than once.
///
/// # Errors
/// An answer longer than the memory limit.
pub fn at(line: &Line, steps: &[u64], by: &dyn Multiply) -> Result<Vec<Answer>> {
    let last = steps.iter().copied().max().unwrap_or(0);
    line.refuse_beyond_memory(last)?;
    Ok(steps.iter().map(|&k| after(line, k, by)).collect())
}

fn after(line: &Line, k: u64, by: &dyn Multiply) -> Answer {
    let scale = BigInt::from(power::natural(line.den.magnitude(), k, by));
    let moved = deviations(line, k, by);
    let numerators = line
        .rest
        .iter()
        .zip(moved)
        .map(|(rest, moved)| if rest.is_zero() { moved } else { rest * &scale + moved })
        .collect();
    Answer { k, numerators, base: line.base.clone(), den: line.den.clone() }
}

/// `D * Q^k` times every drone's deviation after k steps.
fn deviations(line: &Line, k: u64, by: &dyn Multiply) -> Vec<BigInt> {
    if line.deviation.iter().all(Zero::is_zero) {
        return line.deviation.clone();
    }
    convolve(line, &Kernel::power(line, half_ring(line), k, by))
}

/// Half the length of the ring that the line is unfolded to.
pub(super) fn half_ring(line: &Line) -> usize {
    match line.ends {
        Ends::Fixed => line.count() - 1,
        Ends::Free => line.count(),
    }
}

/// The convolution of the kernel with the unfolded deviations: one number a drone.
pub(super) fn convolve(line: &Line, kernel: &Kernel) -> Vec<BigInt> {
    let count = line.count();
    // How far drone 0 is from its image beyond the left end, and the drones that move.
    let (image, moving) = match line.ends {
        Ends::Fixed => (0, 1..count - 1),
        Ends::Free => (1, 0..count),
    };
    let sources: Vec<_> = line
        .deviation
        .iter()
        .enumerate()
        .filter(|(_, d)| !d.is_zero())
        .map(|(j, d)| (j, d.magnitude().to_u64_digits(), d.is_negative()))
        .collect();
    // The magnitudes of a power sum to W^k, which fits the kernel's stride: so do their
    // differences, and a sum of them weighted by deviations needs the bits of the largest
    // deviation more, one for its image and one for the sign.
    let width = kernel.stride() + limbs_for(longest(&line.deviation) + 2);
    let mut pair = vec![0; kernel.stride() + 1];
    let mut sum = vec![0; width];
    let mut moved = Vec::with_capacity(count);
    for i in 0..count {
        if !moving.contains(&i) {
            moved.push(BigInt::zero());
            continue;
        }
        sum.fill(0);
        for (j, magnitude, negative) in &sources {
            let (direct, mirrored) = (i.abs_diff(*j), i + j + image);
            let sign = pair_up(&mut pair, kernel, direct, mirrored, line.ends);
            limbs::accumulate(&mut sum, &pair, magnitude, sign ^ negative);
        }
        moved.push(limbs::integer(&mut sum));
    }
    moved
}

/// The magnitude of what a deviation gives a drone: directly, and through its image beyond an
/// end, which is odd for fixed ends and even for free ones. Returns whether it is negative.
fn pair_up(pair: &mut [u64], kernel: &Kernel, direct: usize, mirrored: usize, ends: Ends) -> bool {
    pair.fill(0);
    limbs::add(pair, kernel.coefficient(direct), false);
    let opposite = kernel.negative(direct) != kernel.negative(mirrored);
    let mut below_zero = false;
    if opposite != (ends == Ends::Fixed) {
        below_zero = limbs::sub(pair, kernel.coefficient(mirrored), false);
    } else {
        limbs::add(pair, kernel.coefficient(mirrored), false);
    }
    if below_zero {
        limbs::negate(pair);
    }
    below_zero ^ kernel.negative(direct)
}
