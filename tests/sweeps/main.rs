//! Theorem sweeps.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/mod.rs"]
mod common;

mod kernel;
mod own;
#[path = "../engines/own_random.rs"]
mod own_random;
mod theorems;
