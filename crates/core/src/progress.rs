//! Progress: engines count pieces of work, the command line reads the counts and draws them.
//!
//! A process works on one command at a time. No decision depends on these counts.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

static DONE: AtomicU64 = AtomicU64::new(0);
static EXPECTED: AtomicU64 = AtomicU64::new(0);
static TRIED: Mutex<String> = Mutex::new(String::new());

/// Announces more pieces of work.
pub fn expect(pieces: u64) {
    EXPECTED.fetch_add(pieces, Relaxed);
}

/// Reports pieces of work as done.
pub fn advance(pieces: u64) {
    DONE.fetch_add(pieces, Relaxed);
}

/// Pieces done and pieces announced; (0, 0) where no engine has announced any.
pub fn so_far() -> (u64, u64) {
    (DONE.load(Relaxed), EXPECTED.load(Relaxed))
}

/// Says what is tried from now on, where pieces cannot be counted.
pub fn tries(what: impl Into<String>) {
    *TRIED.lock().unwrap_or_else(PoisonError::into_inner) = what.into();
}

/// What is being tried; empty where nothing was said.
pub fn tried() -> String {
    TRIED.lock().unwrap_or_else(PoisonError::into_inner).clone()
}
