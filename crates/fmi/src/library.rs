//! The shared library of an FMU.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ffi::c_void;
use std::path::Path;

use libloading::Library as Loaded;

/// A loaded library. It is never unloaded: many FMUs leave threads or handlers behind that would then
/// run unmapped code.
pub(crate) struct Library {
    loaded: &'static Loaded,
    /// Cached addresses of functions: looking one up costs as much as a short call.
    found: RefCell<BTreeMap<String, *mut c_void>>,
}

impl Library {
    pub(crate) fn load(path: &Path) -> Result<Self, String> {
        // SAFETY: the library's constructors run. Loading an FMU relies on foreign code behaving; if it
        // does not, the process ends: see `remote`.
        let loaded = unsafe { Loaded::new(path) };
        let loaded = loaded.map_err(|e| format!("loading `{}`: {e}", path.display()))?;
        Ok(Self { loaded: Box::leak(Box::new(loaded)), found: RefCell::default() })
    }

    /// A function by name.
    ///
    /// # Safety
    /// `F` is the function's type in the standard, a pointer.
    pub(crate) unsafe fn function<F: Copy>(&self, name: &str) -> Result<F, String> {
        let known = self.found.borrow().get(name).copied();
        let address = match known {
            Some(address) => address,
            None => {
                // SAFETY: only an address is read, of whatever type.
                let symbol = unsafe { self.loaded.get::<*mut c_void>(name.as_bytes()) };
                let found = symbol.ok().map(|symbol| *symbol).filter(|address| !address.is_null());
                let missing = || format!("loading: the binary has no function `{name}`");
                let address = found.ok_or_else(missing)?;
                self.found.borrow_mut().insert(name.to_owned(), address);
                address
            }
        };
        // SAFETY: the caller guarantees the type, which has the size of an address.
        Ok(unsafe { std::mem::transmute_copy::<*mut c_void, F>(&address) })
    }
}
