//! The foundations shared by Cordon's engines; what only one engine needs is kept with that engine.
//!
//! * [`exact`]: rationals read and shown exactly; [`range`]: ranges and lists of them;
//!   [`random`]: seeded choice.
//! * [`scalar`]: what the spec can be executed on besides rationals.
//! * [`system`]: a protocol as the engines see it; [`stencil`]: the coefficients of the coverage step.
//! * [`linear`], [`simplex`]: exact linear algebra and programs.
//! * [`theorems`], [`violation`], [`evidence`]: the theorems by number, violations in words, kinds of
//!   evidence.
//! * [`error`], [`files`], [`fingerprint`], [`serial`], [`text`], [`table`], [`progress`]: errors and
//!   exit codes, reading and writing files, showing user text safely, tables, and progress.

pub mod error;
pub mod evidence;
pub mod exact;
pub mod files;
pub mod fingerprint;
pub mod linear;
pub mod progress;
pub mod random;
pub mod range;
pub mod scalar;
pub mod serial;
pub mod simplex;
pub mod stencil;
pub mod system;
pub mod table;
pub mod text;
pub mod theorems;
pub mod violation;

pub use error::{Error, Outcome, Result};
pub use evidence::Evidence;
pub use exact::Rational;
