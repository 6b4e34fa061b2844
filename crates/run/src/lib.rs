//! Scenarios and the engines that run them.
//!
//! * [`scenario`]: what to run, from a TOML file or from flags.
//! * [`simulate`], [`trace`]: step by step. [`fast`]: any number of steps at once.
//! * [`projection`]: N local machines against the global step. [`swarm`]: millions of drones.

pub mod fast;
pub mod projection;
pub mod protocol;
pub mod scenario;
pub mod simulate;
#[cfg(feature = "swarm")]
pub mod swarm;
pub mod trace;
