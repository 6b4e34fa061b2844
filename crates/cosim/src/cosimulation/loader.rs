//! Loading FMUs that replace units.

use std::fmt;
use std::sync::Arc;

use crate::unit::Unit;
use cordon_core::{Error, Result};
use cordon_run::scenario::Substitute;

/// Loads an FMU that replaces a unit: the result has the unit's name and variables.
#[derive(Clone)]
pub struct Loader(Arc<Load>);

type Load = dyn Fn(&Substitute, Box<dyn Unit>) -> Result<Box<dyn Unit>> + Send + Sync;

impl Loader {
    /// A loader that replaces a unit by the result of `load`.
    pub fn new(
        load: impl Fn(&Substitute, Box<dyn Unit>) -> Result<Box<dyn Unit>> + Send + Sync + 'static,
    ) -> Self {
        Self(Arc::new(load))
    }

    /// Loads the FMU that replaces a unit.
    ///
    /// # Errors
    /// It cannot be loaded, or does not fit the unit.
    pub(super) fn load(
        &self,
        substitute: &Substitute,
        unit: Box<dyn Unit>,
    ) -> Result<Box<dyn Unit>> {
        (self.0)(substitute, unit)
    }
}

impl fmt::Debug for Loader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Loader")
    }
}

impl Default for Loader {
    /// The loader of a program that cannot load FMUs.
    fn default() -> Self {
        Self::new(|substitute, unit| {
            Err(Error::input(format!(
                "unit `{}`: `{}`: expected a unit of this program: nothing loads FMUs here",
                unit.name(),
                substitute.fmu.display()
            )))
        })
    }
}
