//! FMUs of other tools in the place of units.
//!
//! A `Foreign` unit has the name and the variables of the unit whose place
//! it takes, so that nothing else in the co-simulation changes; behind them is an FMU. The crate
//! `fmi` loads and calls it. That crate needs libclang to build, hence the feature `fmi-import`.

mod adapter;
#[cfg(feature = "fmi-import")]
mod foreign;
#[cfg(feature = "fmi-import")]
mod log;
#[cfg(feature = "fmi-import")]
mod session;

use crate::fmi::archive::Fmu;
use crate::unit::Unit;
#[cfg(not(feature = "fmi-import"))]
use cordon_core::Error;
use cordon_core::Result;
use cordon_run::scenario::Substitute;

/// An FMU in the place of a unit: the [`Loader`](crate::cosimulation::Loader) of this program.
///
/// # Errors
/// The FMU cannot be read, is for another platform, or lacks a variable of the unit; or this
/// program was built without the feature `fmi-import`.
pub fn substitute(substitute: &Substitute, unit: Box<dyn Unit>) -> Result<Box<dyn Unit>> {
    let fmu = Fmu::open(&substitute.fmu)?;
    fmu.expect_runnable()?;
    let map = adapter::map(unit.as_ref(), &fmu, &substitute.names)?;
    load(fmu, unit.as_ref(), map)
}

#[cfg(feature = "fmi-import")]
fn load(fmu: Fmu, unit: &dyn Unit, map: Vec<adapter::Counterpart>) -> Result<Box<dyn Unit>> {
    Ok(Box::new(foreign::Foreign::new(fmu, unit, map)?))
}

#[cfg(not(feature = "fmi-import"))]
fn load(fmu: Fmu, unit: &dyn Unit, _map: Vec<adapter::Counterpart>) -> Result<Box<dyn Unit>> {
    Err(Error::input(format!(
        "unit `{}`: `{}`: this program was built without the means to run FMUs: \
         build it with `cargo build --release --features fmi-import`",
        unit.name(),
        fmu.path.display()
    )))
}
