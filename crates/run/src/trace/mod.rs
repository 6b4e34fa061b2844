//! Traces: the rows of a run selected by the user, and the verdicts of theorems on them.

mod check;
mod claims;
#[cfg(feature = "swarm")]
mod extremes;
mod positions;
mod rows;

pub use check::{Checked, applicable, check};
pub use claims::{CheckedClaim, check_claims, out_of_range};
#[cfg(feature = "swarm")]
pub use extremes::decimal_widths;
pub use positions::Positions;
pub use rows::{Counted, Row, Rows, Selection, select, shown};
