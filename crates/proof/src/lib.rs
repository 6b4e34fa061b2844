//! Engines that decide: sweeps, refutations, proofs, thresholds, settling steps, and the same
//! questions written for other solvers.

pub mod certificate;
pub mod claims;
pub mod counterexample;
pub mod export;
pub mod flow;
pub mod prove;
pub mod refute;
pub mod separation;
pub mod settle;
mod start_sets;
pub mod sweep;
mod symbolic;
pub mod threshold;
