//! The coverage protocol and its theorems, written once.
//!
//! A line of N drones spreads evenly along the segment \[min, max\]: the two ends stay, every
//! other drone moves by `x_i' = eps*x_{i-1} + (1 - 2*eps)*x_i + eps*x_{i+1}` (equation 10 of
//! Bernardeschi, Domenici, Fagiolini and Palmieri, "Co-simulation and Formal Verification of
//! Co-operative Drone Control With Logic-Based Specifications"). This crate is the only
//! definition of that protocol in the project: the simulator, the sweeps, the model checker,
//! the certificate checker and the co-simulation all execute it.
//!
//! * [`coverage`]: the protocol as in Listings 3 and 4 (whole swarm).
//! * [`local`]: the protocol as in Listings 5 and 6 (one drone that knows its neighbours).
//! * [`consensus`], [`formation`]: equations 6 and 8 on any undirected [`graph`].
//! * [`activation`], [`delay`]: steps in which drones skip an update or see stale positions.
//! * [`theorems`]: theorems 7.2 to 7.8 as predicates, in the paper's form and the sharp form.
//!
//! Everything is generic over [`Scalar`], a commutative ring with embedded integers.
//! **Control flow depends on indices and counters only, never on positions**: the protocol
//! can therefore be executed on exact rationals, machine integers, intervals, prime fields
//! or polynomials alike, and a run on polynomials *is* the transition relation. Positions
//! are compared in [`theorems`] only, through [`Ordered`].
//!
//! No floats, no I/O, no allocation for a fixed number of drones, no panic for arguments in
//! the stated ranges.

#![no_std]
#![forbid(unsafe_code)]
// Erased contracts leave their names unused.
#![cfg_attr(feature = "contracts", allow(unused_imports))]

#[cfg(feature = "alloc")]
extern crate alloc;
// Loops with an invariant expand to paths of std.
#[cfg(creusot)]
extern crate std;

pub mod activation;
pub mod consensus;
pub mod coverage;
pub mod delay;
pub mod drone_map;
pub mod formation;
pub mod graph;
pub mod local;
// What the contracts mean; not in this folder because it is no part of the spec.
#[cfg(feature = "contracts")]
#[path = "../model/mod.rs"]
pub mod model;
pub mod placement;
pub mod scalar;
pub mod state;
pub mod theorems;

pub use drone_map::DroneMap;
pub use scalar::{Ordered, Scalar};
pub use state::{Params, Phase, State};
