//! The co-simulation engine: drones with a body (PROTOCOL section 3).
//!
//! Every drone is three [units](unit::Unit): [plant](plant::Plant), [control](control::Control)
//! and [coordination](coordination::Coordination). The coordination unit executes the spec.
//! Units know nothing of each other, the master nothing of drones.

mod body_variables;
pub mod collision;
pub mod control;
pub mod coordination;
pub mod exact_run;
pub mod exact_units;
mod faults;
pub mod fmi;
pub mod grid;
#[cfg(feature = "package")]
pub mod interchange;
pub mod master;
mod order;
pub mod physics;
pub mod plant;
pub mod quotient;
pub mod record;
pub mod replay;
pub mod run;
pub mod store;
pub mod swarm;
pub mod unit;
pub mod wiring;
