//! The engines as a library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/mod.rs"]
mod common;

mod any_size;
mod cosim_faults;
mod cosim_master;
mod cosim_runs;
mod departing;
mod exact_numbers;
mod export_pvs_own;
mod export_smt2;
mod fast;
mod flow;
mod impulse_response;
mod invariants;
mod own;
mod own_random;
mod parsers;
mod prove;
mod quadratic;
mod refute;
mod separation;
mod settle;
mod smt2_answers;
mod smt2_text;
mod swarm;
mod threshold;
