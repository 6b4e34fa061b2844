//! FMI: the units of the co-simulation as other tools see them.
//!
//! [`interface`] defines what importers see of an exported unit, and [`slave`] enforces the rules of
//! the standard around a unit. The C functions are in the crate `cordon-fmu` (folder `fmu`), the only
//! place with `unsafe`; archives and descriptions are in the crate `cordon-formats`.

pub mod carried;
pub mod interface;
pub mod slave;
pub mod snapshot;
pub mod uri;
