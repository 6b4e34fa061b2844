//! Exact positions after many steps, fast.
//!
//! A line of drones (coverage; consensus on a path) moves by one symmetric rule, read off the
//! spec ([`Line`]). Two engines compute the exact positions after k steps over a common
//! denominator ([`Answer`]):
//!
//! * [`step`]: every step, in cost proportional to N k^2;
//! * [`jump`]: none of the steps, in about the time of one multiplication of numbers as long
//!   as the answer.

pub mod answer;
pub mod growth;
pub mod jump;
mod kernel;
mod limbs;
pub mod line;
pub mod multiply;
pub mod ntt;
mod power;
pub mod step;

pub use answer::Answer;
pub use line::{Ends, Line};
pub use multiply::Multiply;
