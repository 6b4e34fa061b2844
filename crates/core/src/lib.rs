//! What all of Cordon's engines stand on, and nothing that only one of them needs.
//!
//! * [`exact`]: rationals read and shown exactly; [`range`]: ranges and lists of them;
//!   [`random`]: seeded choice.
//! * [`scalar`]: what the spec can be executed on besides rationals.
//! * [`stencil`]: the step's coefficients; [`linear`], [`simplex`]: exact linear algebra and
//!   programs.
//! * [`error`], [`files`]: how a command ends, and how it reads and writes.

pub mod error;
pub mod exact;
pub mod files;
pub mod linear;
pub mod random;
pub mod range;
pub mod scalar;
pub mod simplex;
pub mod stencil;
pub mod theorems;

pub use error::{Error, Outcome, Result};
pub use exact::Rational;
