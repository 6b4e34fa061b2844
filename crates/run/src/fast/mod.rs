//! Exact positions after many steps, fast.
//!
//! A line of drones (coverage; consensus on a path) moves by one symmetric rule, read off the
//! spec ([`Line`]). Two engines compute the exact positions after k steps over a common
//! denominator ([`Answer`]):
//!
//! * [`step`]: every step, in cost proportional to N k^2;
//! * [`jump`]: none of the steps, in about the time of one multiplication of numbers as long
//!   as the answer.
//!
//! An own protocol that is no such line moves by sparse matrices ([`Course`]), step by step or by
//! its characteristic polynomial ([`leap`]).
//!
//! [`verify`] checks an answer against the plain spec over random prime fields. Where fractions
//! are too long, [`digits`] encloses the positions tightly enough for certain decimal digits, and
//! [`within`] finds the step from which on they are close to their resting places.

pub mod answer;
mod cost;
pub mod course;
pub mod digits;
pub mod engine;
pub mod growth;
pub mod jump;
mod kernel;
pub mod leap;
mod limbs;
pub mod line;
pub mod multiply;
pub mod ntt;
pub(crate) mod power;
mod ring;
pub mod rule;
pub mod step;
pub mod verify;
pub mod within;

pub use answer::Answer;
pub use course::Course;
pub use engine::{Engine, Motion};
pub use line::{Ends, Line};
pub use multiply::Multiply;
pub use rule::Rule;
