//! FMI: units of the co-simulation as FMUs for other tools, and FMUs of other tools as units.
//!
//! What importers see of an exported unit is defined in [`cordon_cosim::fmi`]; [`description`] writes
//! it as `modelDescription.xml`, [`package`] builds the archive around the compiled library that
//! [`binary`] finds, [`archive`] reads one back, and [`import`] puts one in the place of a unit.

pub mod archive;
pub mod binary;
pub mod description;
pub mod import;
pub(crate) mod model_description;
pub mod package;
pub(crate) mod units;
