//! The checker's tests: one binary, which is built once a change.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod anew;
mod bridge;
mod certificates;
mod cli;
mod hostile;
mod meaning;
mod mutants;
mod rules;
mod second;
mod work;
