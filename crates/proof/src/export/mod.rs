//! Exports for other tools: SMT-LIB 2 for solvers and PVS for the paper's readers.
//!
//! Formulas about the protocol are never written here a second time where the spec can be
//! executed instead: the SMT-LIB text is what `exec_coverage` and the theorems' predicates
//! compute on terms (`term`, `decision`). PVS, a specification language of its own, is a
//! mirror with generated parts ([`pvs`]).

pub mod conjecture;
mod decision;
pub mod pvs;
pub mod smt2;
pub mod smt_model;
pub mod system;
mod term;
