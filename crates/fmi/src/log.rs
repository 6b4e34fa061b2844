//! The log messages of FMUs.
//!
//! Loggers get a number as their environment instead of a pointer: a message that arrives after its
//! instance is gone is not found and dropped.

use std::collections::BTreeMap;
use std::ffi::{CStr, c_char, c_int, c_void};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Most messages kept per call: the first ones explain, the rest repeat.
const MOST: usize = 8;

/// Lowest status of the messages kept: warnings.
const WARNING: c_int = 1;

#[derive(Default)]
struct Said {
    messages: Vec<String>,
    more: u64,
}

static SAID: Mutex<BTreeMap<usize, Said>> = Mutex::new(BTreeMap::new());

fn said() -> MutexGuard<'static, BTreeMap<usize, Said>> {
    SAID.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The log of an instance, open while this value lives.
pub(crate) struct Log(usize);

impl Log {
    pub(crate) fn open() -> Self {
        let mut all = said();
        let number = all.last_key_value().map_or(1, |(last, _)| last + 1);
        all.insert(number, Said::default());
        Self(number)
    }

    /// The environment passed to loggers.
    pub(crate) fn environment(&self) -> *mut c_void {
        std::ptr::without_provenance_mut(self.0)
    }

    /// The messages since the last call.
    pub(crate) fn take(&self) -> Vec<String> {
        let Said { mut messages, more } =
            said().get_mut(&self.0).map(std::mem::take).unwrap_or_default();
        if more > 0 {
            messages.push(format!("and {more} more messages"));
        }
        messages
    }
}

impl Drop for Log {
    fn drop(&mut self) {
        said().remove(&self.0);
    }
}

/// Records a message. Called from C with arguments from the FMU.
///
/// # Safety
/// `message` is null or a string that ends in a zero byte.
#[unsafe(no_mangle)]
unsafe extern "C" fn cordon_fmi_log(
    environment: *mut c_void,
    status: c_int,
    message: *const c_char,
) {
    if status < WARNING {
        return;
    }
    let text = match message.is_null() {
        true => "a message without text".into(),
        // SAFETY: not null, and the caller guarantees the rest.
        false => unsafe { CStr::from_ptr(message) }.to_string_lossy(),
    };
    if let Some(said) = said().get_mut(&environment.addr()) {
        if said.messages.len() < MOST {
            said.messages.push(text.trim().to_owned());
        } else {
            said.more += 1;
        }
    }
}

/// `fmi3LogMessageCallback`.
///
/// # Safety
/// As for [`cordon_fmi_log`].
pub(crate) unsafe extern "C" fn logger_3(
    environment: *mut c_void,
    status: c_int,
    _category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: as required of the caller.
    unsafe { cordon_fmi_log(environment, status, message) };
}
