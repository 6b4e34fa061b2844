//! What both versions of the interface share: an instance, its log, and a guard around calls.

use std::ffi::{CStr, CString, c_char, c_uint, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};

use cordon_cosim::fmi::slave::{Refusal, Severity, Slave};
use cordon_cosim::fmi::snapshot::Snapshot;
use cordon_cosim::unit::Value;

use crate::convert;

/// The status codes used here, which have the same values in FMI 2.0 and FMI 3.0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// The call did what was asked.
    Ok = 0,
    /// The call was refused; the instance is unchanged.
    Error = 3,
    /// The instance can no longer be used.
    Fatal = 4,
}

/// The only category of log messages.
pub const LOG_CATEGORY: &CStr = c"logStatusError";

/// The destination of an instance's log messages.
pub trait Log {
    /// Hands a message to the importer.
    fn log(&self, instance: &CStr, status: Status, message: &CStr);
}

/// An instance of an FMU.
pub struct Component<L> {
    /// The name that the importer gave it.
    pub name: CString,
    /// The unit under the rules of the standard.
    pub slave: Slave,
    /// The importer's logger.
    pub log: L,
    /// Strings handed out; valid until the next call.
    pub texts: Vec<CString>,
}

impl<L: Log> Component<L> {
    /// Logs a refusal and returns its status.
    fn report(&self, refusal: &Refusal) -> Status {
        let status = status_of(refusal);
        self.log.log(&self.name, status, &c_text(&refusal.message));
        status
    }
}

/// The status for a refusal.
pub fn status_of(refusal: &Refusal) -> Status {
    match refusal.severity {
        Severity::Error => Status::Error,
        Severity::Fatal => Status::Fatal,
    }
}

/// A C string; zero bytes, which C strings cannot contain, are left out.
pub fn c_text(text: &str) -> CString {
    let bytes: Vec<u8> = text.bytes().filter(|b| *b != 0).collect();
    CString::new(bytes).unwrap_or_default()
}

/// Hands an instance to the importer.
pub fn hand_out<L>(component: Component<L>) -> *mut c_void {
    Box::into_raw(Box::new(component)).cast()
}

/// Frees an instance; does nothing for a null pointer, as the standards require.
///
/// # Safety
/// `instance` is null or came from [`hand_out`] with the same `L` and was not freed.
pub unsafe fn free<L>(instance: *mut c_void) {
    if !instance.is_null() {
        // SAFETY: it came out of `Box::into_raw` in `hand_out`, once.
        drop(unsafe { Box::from_raw(instance.cast::<Component<L>>()) });
    }
}

/// Runs `body` on an instance: a refusal is logged and returned as a status, a panic makes the instance
/// fatal.
///
/// # Safety
/// `instance` is null or came from [`hand_out`] with the same `L`, was not freed, and is used by no
/// other thread during the call.
pub unsafe fn with<L: Log>(
    instance: *mut c_void,
    body: impl FnOnce(&mut Component<L>) -> Result<(), Refusal>,
) -> Status {
    // SAFETY: as required of the caller.
    let Some(component) = (unsafe { instance.cast::<Component<L>>().as_mut() }) else {
        return Status::Error;
    };
    let ended = catch_unwind(AssertUnwindSafe(|| body(component)));
    match ended {
        Ok(Ok(())) => Status::Ok,
        Ok(Err(refusal)) => component.report(&refusal),
        Err(_) => {
            component.slave.give_up();
            component
                .report(&Refusal::fatal("internal fault: the instance cannot be used any more"))
        }
    }
}

/// Saves the current state at `*state`: into the snapshot there, or into a new one.
///
/// # Safety
/// `state` is null or points to null or to a snapshot made here and not freed.
pub unsafe fn save<L>(c: &Component<L>, state: *mut *mut c_void) -> Result<(), Refusal> {
    // SAFETY: as required of the caller.
    let state = unsafe { convert::place(state) }?;
    let snapshot = c.slave.save()?;
    // SAFETY: null or a snapshot of ours, by the caller.
    match unsafe { state.cast::<Snapshot>().as_mut() } {
        Some(old) => *old = snapshot,
        None => *state = Box::into_raw(Box::new(snapshot)).cast(),
    }
    Ok(())
}

/// The snapshot at `state`.
///
/// # Safety
/// `state` is null or a snapshot made here and not freed during `'a`.
pub unsafe fn snapshot<'a>(state: *mut c_void) -> Result<&'a Snapshot, Refusal> {
    // SAFETY: as required of the caller.
    unsafe { state.cast::<Snapshot>().as_ref() }
        .ok_or_else(|| Refusal::error("the importer passed a null pointer for a state"))
}

/// Frees the snapshot at `*state` and leaves null there.
///
/// # Safety
/// `state` is null or points to null or to a snapshot made here and not freed.
pub unsafe fn free_snapshot(state: *mut *mut c_void) -> Result<(), Refusal> {
    // SAFETY: as required of the caller.
    let state = unsafe { convert::place(state) }?;
    if !state.is_null() {
        // SAFETY: it came out of `Box::into_raw` here, once.
        drop(unsafe { Box::from_raw(state.cast::<Snapshot>()) });
        *state = std::ptr::null_mut();
    }
    Ok(())
}

/// Writes the bytes of the snapshot at `state` to the `size` bytes at `bytes`.
///
/// # Safety
/// `state` as for [`snapshot`]; at `bytes` there is room for `size` bytes.
pub unsafe fn serialize(state: *mut c_void, bytes: *mut u8, size: usize) -> Result<(), Refusal> {
    // SAFETY: as required of the caller.
    let snapshot = unsafe { snapshot(state) }?;
    // SAFETY: as required of the caller.
    let room = unsafe { convert::slice_mut(bytes, size) }?;
    let written = snapshot.to_bytes();
    match room.get_mut(..written.len()) {
        Some(room) => {
            room.copy_from_slice(&written);
            Ok(())
        }
        None => Err(Refusal::error(format!(
            "a serialised state needs {} bytes: the importer gave room for {size}",
            written.len()
        ))),
    }
}

/// Makes a snapshot from the `size` bytes at `bytes` and puts it at `*state`.
///
/// # Safety
/// `size` bytes are at `bytes`; `state` as for [`save`].
pub unsafe fn deserialize<L>(
    c: &Component<L>,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> Result<(), Refusal> {
    // SAFETY: as required of the caller.
    let bytes = unsafe { convert::slice(bytes, size) }?;
    // SAFETY: as required of the caller.
    let state = unsafe { convert::place(state) }?;
    let snapshot = c.slave.snapshot_from_bytes(bytes)?;
    *state = Box::into_raw(Box::new(snapshot)).cast();
    Ok(())
}

/// The size in bytes of the serialised snapshot at `state`.
///
/// # Safety
/// `state` as for [`snapshot`]; `size` is null or can be written.
pub unsafe fn serialized_size(state: *mut c_void, size: *mut usize) -> Result<(), Refusal> {
    // SAFETY: as required of the caller.
    let size = unsafe { convert::place(size) }?;
    // SAFETY: as required of the caller.
    *size = unsafe { snapshot(state) }?.to_bytes().len();
    Ok(())
}

/// Reads strings into `values`; they are valid until the next call.
///
/// # Safety
/// `references` and `values` have `count` elements.
pub unsafe fn get_texts<L>(
    c: &mut Component<L>,
    references: *const c_uint,
    values: *mut *const c_char,
    count: usize,
) -> Result<(), Refusal> {
    // SAFETY: as required of the caller.
    let references = unsafe { convert::slice(references, count) }?;
    // SAFETY: as required of the caller.
    let values = unsafe { convert::slice_mut(values, count) }?;
    let read = |r: &c_uint| c.slave.text(*r).map(|t| c_text(&t));
    c.texts = references.iter().map(read).collect::<Result<_, _>>()?;
    for (place, text) in values.iter_mut().zip(&c.texts) {
        *place = text.as_ptr();
    }
    Ok(())
}

/// Sets strings.
///
/// # Safety
/// `references` and `values` have `count` elements; the values are strings.
pub unsafe fn set_texts<L>(
    c: &mut Component<L>,
    references: *const c_uint,
    values: *const *const c_char,
    count: usize,
) -> Result<(), Refusal> {
    // SAFETY: as required of the caller.
    let references = unsafe { convert::slice(references, count) }?;
    // SAFETY: as required of the caller.
    let values = unsafe { convert::slice(values, count) }?;
    for (reference, value) in references.iter().zip(values) {
        // SAFETY: as required of the caller.
        let text = unsafe { convert::text(*value) }?;
        c.slave.set(*reference, &Value::Text(text.into()))?;
    }
    Ok(())
}

/// Checks that the requested categories of messages exist.
///
/// # Safety
/// `categories` are `count` strings.
pub unsafe fn known_categories(
    categories: *const *const c_char,
    count: usize,
) -> Result<(), Refusal> {
    // SAFETY: as required of the caller.
    for category in unsafe { convert::slice(categories, count) }? {
        // SAFETY: as required of the caller.
        let category = unsafe { convert::text(*category) }?;
        if category.as_bytes() != LOG_CATEGORY.to_bytes() {
            return Err(Refusal::error(format!(
                "log category `{category}`: expected `logStatusError`, the only one"
            )));
        }
    }
    Ok(())
}
