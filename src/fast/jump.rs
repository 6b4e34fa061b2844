//! The jump engine: the positions after k steps without the steps between.
//!
//! With fixed ends the deviations from the targets continue oddly beyond the ends, to a ring
//! of `2(N-1)` places on which every place obeys the same rule; with free ends (consensus) the
//! positions continue evenly, to a ring of `2N`. There k steps are one convolution with the
//! k-th power of the kernel ([`Kernel`]).

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use super::answer::Answer;
use super::growth::{limbs_for, longest};
use super::kernel::Kernel;
use super::limbs;
use super::line::{Ends, Line};
use super::multiply::Multiply;
use super::power;
use crate::Result;

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
    let count = line.count();
    // Half the ring; how far drone 0 is from its image beyond the left end; the drones that move.
    let (half, image, moving) = match line.ends {
        Ends::Fixed => (count - 1, 0, 1..count - 1),
        Ends::Free => (count, 1, 0..count),
    };
    if line.deviation.iter().all(Zero::is_zero) {
        return line.deviation.clone();
    }
    let kernel = Kernel::power(line, half, k, by);
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
            // Both places have the same parity as i - j or the opposite one: signs apart.
            pair.fill(0);
            limbs::add(&mut pair, kernel.coefficient(direct), false);
            let flipped = kernel.negative(direct) != kernel.negative(mirrored);
            let odd = line.ends == Ends::Fixed;
            let minus = if flipped != odd {
                limbs::sub(&mut pair, kernel.coefficient(mirrored), false)
            } else {
                limbs::add(&mut pair, kernel.coefficient(mirrored), false)
            };
            if minus {
                limbs::negate(&mut pair);
            }
            let sign = minus ^ kernel.negative(direct) ^ negative;
            limbs::accumulate(&mut sum, &pair, magnitude, sign);
        }
        moved.push(limbs::integer(&mut sum));
    }
    moved
}
