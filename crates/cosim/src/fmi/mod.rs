//! FMI: the units of the co-simulation as FMUs that other tools run.
//!
//! [`interface`] says what an exported unit shows to importers, [`description`] writes that as
//! `modelDescription.xml`, [`slave`] keeps the rules of the standard around a unit, and
//! [`package`] puts the archive together. The C functions are in the crate `cordon-fmu`
//! (folder `fmu`), the only place with `unsafe`; [`binary`] finds what it was compiled to.

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
