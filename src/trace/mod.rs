//! Traces: the rows of a run that a user wants to see, checked and shown.

mod check;
mod rows;
pub mod show;

pub use check::{Checked, check};
pub use rows::{Row, Selection, Trace, Unit, select};
