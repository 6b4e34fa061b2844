//! The spec on exact numbers, polynomials and prime fields: identities, predicates, ticks.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../../../tests/common/placements.rs"]
mod placements;

mod exact;
mod identities;
mod theorem_predicates;
mod ticks;
