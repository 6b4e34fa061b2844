//! The harnesses, by what they are about.

pub mod activation;
pub mod arithmetic;
pub mod consensus;
pub mod delay;
pub mod exactness;
pub mod hypotheses;
pub mod local;
pub mod ordering;
pub mod positions;
pub mod predicates;
pub mod sum;
pub mod ticks;
pub mod truth;
pub mod upper_bound;

use crate::harness::Harness;

/// Every harness, module by module.
pub fn all() -> impl Iterator<Item = &'static Harness> {
    [
        ordering::HARNESSES,
        upper_bound::HARNESSES,
        sum::HARNESSES,
        exactness::HARNESSES,
        activation::HARNESSES,
        delay::HARNESSES,
        ticks::HARNESSES,
        local::HARNESSES,
        consensus::HARNESSES,
        positions::HARNESSES,
        arithmetic::HARNESSES,
        hypotheses::HARNESSES,
        predicates::HARNESSES,
        truth::HARNESSES,
        crate::contracts::HARNESSES,
    ]
    .into_iter()
    .flatten()
}
