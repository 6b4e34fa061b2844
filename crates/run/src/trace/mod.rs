//! Traces: the rows of a run that a user wants to see, and what the theorems say of them.

mod check;
mod rows;

pub use check::{Checked, applicable, check};
pub use rows::{Row, Selection, Trace, Unit, select};
