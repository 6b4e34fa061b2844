//! The co-simulation engine: the protocol flown by drones with dynamics (PROTOCOL section 3).
//!
//! Every drone is three [units](unit::Unit): [plant](plant::Plant), [control](control::Control)
//! and [coordination](coordination::Coordination). The coordination unit executes the spec.
//! Units know nothing of each other, the master nothing of drones.

mod body_variables;
pub mod control;
pub mod coordination;
pub mod fmi;
pub mod grid;
pub mod physics;
pub mod plant;
pub mod quotient;
pub mod unit;

#[cfg(feature = "swarm")]
pub mod batch;
#[cfg(feature = "swarm")]
pub mod closed_loop;
#[cfg(feature = "swarm")]
pub mod collision;
#[cfg(feature = "swarm")]
pub mod cosimulation;
#[cfg(feature = "swarm")]
pub mod exact_run;
#[cfg(feature = "swarm")]
pub mod exact_units;
#[cfg(feature = "swarm")]
mod faults;
#[cfg(feature = "swarm")]
mod fleet;
#[cfg(feature = "swarm")]
pub mod master;
#[cfg(feature = "swarm")]
mod order;
#[cfg(feature = "swarm")]
mod own_flight;
#[cfg(feature = "swarm")]
pub mod record;
#[cfg(feature = "swarm")]
pub mod replay;
#[cfg(feature = "swarm")]
pub mod run;
#[cfg(feature = "swarm")]
pub mod seat;
#[cfg(feature = "swarm")]
mod selection;
#[cfg(feature = "swarm")]
pub mod store;
#[cfg(feature = "swarm")]
pub mod wiring;
