//! Cordon: a verification toolkit for a drone coverage protocol with one executable spec.
//!
//! The protocol and its theorems are defined in [`cordon_spec`] and nowhere else. The modules
//! here are engines that execute it, and what they share. Some only show or carry another's runs
//! and know that one: [`trace`] and [`errata`] know [`simulate`]; [`figures`], [`replay`], [`fmi`] and
//! [`interchange`] know [`cosim`]; [`swarm`] takes its weights from [`fast`]. Like the command line
//! ([`cli`]), [`verify`] is a face over several.

pub mod certificate;
pub mod cli;
pub mod cosim;
pub mod counterexample;
pub mod errata;
pub mod error;
pub mod exact;
pub mod export;
pub mod fast;
pub mod figures;
pub mod files;
pub mod fmi;
pub mod interchange;
pub mod linear;
pub mod model_check;
pub mod own_protocol;
pub mod projection;
pub mod prove;
pub mod random;
pub mod refute;
pub mod replay;
pub mod scalar;
pub mod scenario;
pub mod settle;
pub mod simplex;
pub mod simulate;
pub mod stencil;
pub mod swarm;
pub mod sweep;
pub mod threshold;
pub mod trace;
pub mod verify;

pub use error::{Error, Outcome, Result};
pub use exact::Rational;
