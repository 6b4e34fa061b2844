//! FMUs of other tools that replace units.
//!
//! A `Foreign` unit has the name and the variables of the unit that it replaces, so that nothing else
//! in the co-simulation changes; behind it is an FMU, which the crate `cordon-fmi` loads and calls: by
//! default in a separate process (see [`Isolation`]).

mod adapter;
#[cfg(feature = "fmi-import")]
pub(super) mod folder;
#[cfg(feature = "fmi-import")]
mod foreign;

use std::path::PathBuf;
use std::time::Duration;

use crate::fmi::archive::Fmu;
#[cfg(not(feature = "fmi-import"))]
use cordon_core::Error;
use cordon_core::Result;
use cordon_cosim::unit::Unit;
use cordon_run::scenario::Substitute;

/// Where the code of an FMU runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Isolation {
    /// In a child process per FMU: if the code crashes, hangs or exits, that is an error of the unit.
    Process {
        /// A program that calls [`serve`] when it is started with the arguments below.
        program: PathBuf,
        /// Arguments that make that program read calls from its standard input.
        arguments: Vec<String>,
        /// Time limit of a call, far above what any call takes: a call that exceeds it is taken to
        /// hang.
        limit: Duration,
    },
    /// In this process: faster, without the communication, but a crash of the FMU ends this process
    /// too.
    InProcess,
}

/// Replaces a unit by an FMU, see [`Loader`](cordon_cosim::cosimulation::Loader).
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

/// Serves the instance of an FMU to the parent process until that ends the session.
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

/// As above, in a build that cannot run FMUs.
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
