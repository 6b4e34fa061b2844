//! What loads FMUs in the place of units.

use std::fmt;
use std::sync::Arc;

use crate::unit::Unit;
use cordon_core::{Error, Result};
use cordon_run::scenario::Substitute;

/// Loads an FMU in the place of a unit: the answer has the unit's name and variables.
#[derive(Clone)]
pub struct Loader(Arc<Load>);

type Load = dyn Fn(&Substitute, Box<dyn Unit>) -> Result<Box<dyn Unit>> + Send + Sync;

impl Loader {
    /// A loader that puts what `load` answers in the place of a unit.
    pub fn new(
        load: impl Fn(&Substitute, Box<dyn Unit>) -> Result<Box<dyn Unit>> + Send + Sync + 'static,
    ) -> Self {
        Self(Arc::new(load))
    }

    /// Loads the FMU that takes the place of a unit.
    ///
    /// # Errors
    /// It cannot be loaded, or does not fit its place.
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
    /// Where nothing can load FMUs.
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
