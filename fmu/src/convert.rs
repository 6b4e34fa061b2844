//! C arguments as Rust values.

use std::ffi::{CStr, c_char};

use cordon_cosim::fmi::slave::Refusal;

/// A slice of `count` elements at `first`; an empty array may be null.
///
/// # Safety
/// Where `count > 0` and `first` is not null, that many elements live there, unchanged, for `'a`.
pub unsafe fn slice<'a, T>(first: *const T, count: usize) -> Result<&'a [T], Refusal> {
    match (first.is_null(), count) {
        (_, 0) => Ok(&[]),
        (true, _) => Err(Refusal::error("the importer passed a null pointer for an array")),
        // SAFETY: not null, and the caller guarantees the rest.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts(first, count) }),
    }
}

/// A mutable slice of `count` elements at `first`.
///
/// # Safety
/// As for [`slice`], and nobody else reads or writes them during `'a`.
pub unsafe fn slice_mut<'a, T>(first: *mut T, count: usize) -> Result<&'a mut [T], Refusal> {
    match (first.is_null(), count) {
        (_, 0) => Ok(&mut []),
        (true, _) => Err(Refusal::error("the importer passed a null pointer for an array")),
        // SAFETY: not null, and the caller guarantees the rest.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts_mut(first, count) }),
    }
}

/// The value at `out`, to be written.
///
/// # Safety
/// `out` is null or points to a value that nobody else reads or writes during `'a`.
pub unsafe fn place<'a, T>(out: *mut T) -> Result<&'a mut T, Refusal> {
    // SAFETY: as required of the caller.
    unsafe { out.as_mut() }
        .ok_or_else(|| Refusal::error("the importer passed a null pointer for a result"))
}

/// The string at `text`.
///
/// # Safety
/// `text` is null or points to a zero-terminated string that stays unchanged for `'a`.
pub unsafe fn text<'a>(text: *const c_char) -> Result<&'a str, Refusal> {
    if text.is_null() {
        return Err(Refusal::error("the importer passed a null pointer for a text"));
    }
    // SAFETY: not null, and the caller guarantees the rest.
    let bytes = unsafe { CStr::from_ptr(text) };
    bytes.to_str().map_err(|_| Refusal::error("the importer passed a string that is not UTF-8"))
}
