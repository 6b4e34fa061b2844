//! The jump engine: the positions after k steps without the steps between, as one convolution
//! of the unfolded line (`ring.rs`) with the k-th power of the kernel (`kernel.rs`).

use num_bigint::BigInt;
use num_traits::Zero;

use super::answer::Answer;
use super::kernel::Kernel;
use super::line::Line;
use super::multiply::Multiply;
use super::power;
use super::ring::{convolve, half_ring};
use cordon_core::Result;

/// The positions after each of `steps`, which may come in any order and more than once.
///
/// # Errors
/// An answer longer than the memory limit.
pub fn at(line: &Line, steps: &[u64], by: &dyn Multiply) -> Result<Vec<Answer>> {
    let last = steps.iter().copied().max().unwrap_or(0);
    line.refuse_beyond_memory("at", last)?;
    Ok(steps.iter().map(|&k| after(line, k, by)).collect())
}

/// The positions after `k` steps.
pub fn after(line: &Line, k: u64, by: &dyn Multiply) -> Answer {
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
    convolve(line, &Kernel::power(line, half_ring(line), k, by), by)
}
