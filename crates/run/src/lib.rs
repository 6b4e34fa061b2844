//! The engines that run scenarios.
//!
//! * [`scenario`], [`protocol`]: what to run, as `cordon-scenario` reads it.
//! * [`simulate`], [`trace`]: step by step. [`fast`]: any number of steps at once.
//! * [`projection`]: N local machines against the global step. [`swarm`]: millions of drones.

pub mod fast;
pub mod projection;
pub mod simulate;
#[cfg(feature = "swarm")]
pub mod swarm;
pub mod trace;

pub use cordon_scenario::{protocol, scenario};
