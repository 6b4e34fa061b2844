//! FMUs of other tools in the place of units.
//!
//! A `Foreign` unit has the name and the variables of the unit whose place it takes, so that
//! nothing else in the co-simulation changes; behind them is an FMU, which the crate `cordon-fmi`
//! loads and calls: by default in a process of its own (see [`Isolation`]).

mod adapter;
#[cfg(feature = "fmi-import")]
pub(super) mod folder;
#[cfg(feature = "fmi-import")]
mod foreign;

use std::path::PathBuf;
use std::time::Duration;

use crate::fmi::archive::Fmu;
use crate::unit::Unit;
#[cfg(not(feature = "fmi-import"))]
use cordon_core::Error;
use cordon_core::Result;
use cordon_run::scenario::Substitute;

/// Where foreign code runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Isolation {
    /// In a child process for each FMU: code that crashes, hangs or ends its process is an error
    /// of the unit.
    Process {
        /// A program that calls [`serve`] when it is given the arguments.
        program: PathBuf,
        /// Arguments after which that program reads calls from its standard input.
        arguments: Vec<String>,
        /// Longest time of a call. Far more than any call takes: what takes longer hangs.
        limit: Duration,
    },
    /// In this process: faster by the way there and back, but nothing stops an FMU from taking
    /// this process with it.
    InProcess,
}

/// An FMU in the place of a unit, see [`Loader`](crate::cosimulation::Loader).
///
/// # Errors
/// The FMU cannot be read, is for another platform, or lacks a variable of the unit; or this
/// program was built without the feature `fmi-import`.
pub fn substitute(
    isolation: &Isolation,
    substitute: &Substitute,
    unit: Box<dyn Unit>,
) -> Result<Box<dyn Unit>> {
    let fmu = Fmu::open(&substitute.fmu)?;
    fmu.binary()?;
    let map = adapter::map(unit.as_ref(), &fmu, substitute)?;
    load(isolation, fmu, unit.as_ref(), map)
}

/// Serves the instance of an FMU to the parent process until that has enough.
///
/// # Errors
/// This process was not started by [`substitute`], or this program was built without the feature
/// `fmi-import`.
#[cfg(all(feature = "fmi-import", unix))]
pub fn serve() -> Result<()> {
    let (orders, answers) = cordon_fmi::remote::pipes_to_parent()?;
    cordon_fmi::host::serve(orders, answers);
    Ok(())
}

/// As above, for a program that cannot run FMUs.
#[cfg(not(all(feature = "fmi-import", unix)))]
pub fn serve() -> Result<()> {
    Err(cordon_core::Error::input("this program runs no FMUs in processes of their own"))
}

#[cfg(feature = "fmi-import")]
fn load(
    isolation: &Isolation,
    fmu: Fmu,
    unit: &dyn Unit,
    map: adapter::Map,
) -> Result<Box<dyn Unit>> {
    Ok(Box::new(foreign::Foreign::new(isolation, fmu, unit, map)?))
}

#[cfg(not(feature = "fmi-import"))]
fn load(_: &Isolation, fmu: Fmu, unit: &dyn Unit, _: adapter::Map) -> Result<Box<dyn Unit>> {
    Err(Error::input(format!(
        "unit `{}`: `{}`: this program was built without the means to run FMUs: \
         build it with the feature `fmi-import`, which is on by default",
        unit.name(),
        fmu.path.display()
    )))
}
