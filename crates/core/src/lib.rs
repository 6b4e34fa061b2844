//! What all of Cordon's engines stand on, and nothing that only one of them needs.
//!
//! * [`exact`]: rationals read and shown exactly; [`range`]: ranges and lists of them;
//!   [`random`]: seeded choice.
//! * [`scalar`]: what the spec can be executed on besides rationals.
//! * [`system`]: what every engine knows of a protocol; [`stencil`]: the coefficients of the coverage
//!   step.
//! * [`linear`], [`simplex`]: exact linear algebra and programs.
//! * [`theorems`], [`violation`], [`evidence`]: the theorems by number, violations in words, what verdicts rest on.
//! * [`error`], [`files`], [`fingerprint`], [`serial`], [`text`], [`table`], [`progress`]: how a command ends, how it
//!   reads and writes, what of a user's text is shown, tables, and how far work is.

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
