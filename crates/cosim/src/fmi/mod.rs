//! FMI: the units of the co-simulation as FMUs for other tools.
//!
//! [`interface`] defines what importers see of an exported unit, [`description`] writes it as
//! `modelDescription.xml`, [`slave`] enforces the rules of the standard around a unit, and [`package`]
//! builds the archive. The C functions are in the crate `cordon-fmu` (folder `fmu`), the only place
//! with `unsafe`; [`binary`] finds its compiled library.

#[cfg(feature = "package")]
pub mod archive;
#[cfg(feature = "package")]
pub mod binary;
pub mod carried;
#[cfg(feature = "package")]
pub mod description;
#[cfg(feature = "package")]
pub mod import;
pub mod interface;
#[cfg(feature = "package")]
pub(crate) mod model_description;
#[cfg(feature = "package")]
pub mod package;
pub mod slave;
pub mod snapshot;
#[cfg(feature = "package")]
pub(crate) mod units;
pub mod uri;
