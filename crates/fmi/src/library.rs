//! The shared library of an FMU.

use std::path::Path;

use libloading::Library as Loaded;

/// A loaded library. It is never unloaded: many FMUs leave threads or handlers behind that would
/// run on into nothing.
pub(crate) struct Library {
    loaded: &'static Loaded,
}

impl Library {
    pub(crate) fn load(path: &Path) -> Result<Self, String> {
        // SAFETY: the library's constructors run. That foreign code does what it should is what
        // loading an FMU relies on; where it does not, the process ends: see `remote`.
        let loaded = unsafe { Loaded::new(path) };
        let loaded = loaded.map_err(|e| format!("loading `{}`: {e}", path.display()))?;
        Ok(Self { loaded: Box::leak(Box::new(loaded)) })
    }

    /// A function by name.
    ///
    /// # Safety
    /// `F` is the function's type, as the standard has it.
    pub(crate) unsafe fn function<F: Copy>(&self, name: &str) -> Result<F, String> {
        // SAFETY: the caller vouches for the type.
        unsafe { self.loaded.get::<F>(name.as_bytes()) }
            .map(|symbol| *symbol)
            .map_err(|_| format!("loading: the binary has no function `{name}`"))
    }
}
