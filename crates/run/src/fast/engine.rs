//! Which engine does the work.

use super::answer::Answer;
use super::line::Line;
use super::multiply::Multiply;
use super::{cost, jump, step};
use cordon_core::Result;

/// How the exact positions are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engine {
    /// The one that is expected to be faster
    #[default]
    Auto,
    /// Every step, in integers over a common denominator
    Step,
    /// No steps between: one power of the step's kernel
    Jump,
}

/// The default backend of long multiplications.
pub fn multiplier() -> &'static dyn Multiply {
    #[cfg(feature = "gmp")]
    {
        &super::multiply::Gmp
    }
    #[cfg(not(feature = "gmp"))]
    {
        &super::ntt::Ntt
    }
}

/// The positions after each of `steps`, in their order.
///
/// # Errors
/// An answer longer than the memory limit.
pub fn positions(line: &Line, steps: &[u64], engine: Engine) -> Result<Vec<Answer>> {
    match engine {
        Engine::Jump => jump::at(line, steps, multiplier()),
        Engine::Step => step::at(line, steps),
        Engine::Auto if jump_is_faster(line, last(steps), steps.iter().copied()) => {
            jump::at(line, steps, multiplier())
        }
        Engine::Auto => step::at(line, steps),
    }
}

fn last(steps: &[u64]) -> u64 {
    steps.iter().copied().max().unwrap_or(0)
}

/// Whether jumping to each of `steps` is expected to be faster than stepping to the `last`.
pub fn jump_is_faster(line: &Line, last: u64, steps: impl IntoIterator<Item = u64>) -> bool {
    let mut left = cost::stepping(line, last);
    steps.into_iter().all(|k| {
        left -= cost::jumping(line, k);
        left > 0.0
    })
}
