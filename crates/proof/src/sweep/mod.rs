//! Sweeps: the theorems over every start on a grid, or over all real starts at once.
//!
//! A work item is a theorem in one form for one number of drones and one weight. Its
//! hypothesis and its conclusion are the predicates of [`cordon_spec::theorems`], its update
//! is the [`cordon_core::stencil`] read off the spec. Two kinds of sweep:
//!
//! * **exhaustive on a grid** ([`exhaust`]): every integer start of the theorem's start set on a
//!   grid, every step k up to a last one, in machine integers of a proved range;
//! * **complete for all starts** (the start set's generators, stepped exactly): the step is
//!   linear in the start, so that the theorem holds of all real starts exactly when finitely
//!   many numbers have the right sign.
//!
//! Where a grid is too large, random starts on it give evidence of the kind "sampled".

mod complete;
pub mod config;
mod consistent;
pub mod exhaust;
mod finding;
pub mod grid;
pub mod kernel;
pub mod lanes;
pub mod machine;
pub mod merge;
mod minimise;
pub mod range;
pub mod run;
mod sample;
pub mod shard;
pub mod store;
pub mod summary;
mod weights;

pub use config::{Config, Item, StartSpace};
pub use finding::{Counts, Finding, Judgement, Witness};
pub use weights::WeightSet;
