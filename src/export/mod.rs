//! Exports for other tools: SMT-LIB 2 for solvers.
//!
//! Formulas about the protocol are never written here a second time where the spec can be
//! executed instead: the SMT-LIB text is what `exec_coverage` and the theorems' predicates
//! compute on terms ([`term`], [`decision`]).

pub mod claim;
pub mod decision;
pub mod smt2;
pub mod smt_model;
pub mod term;
