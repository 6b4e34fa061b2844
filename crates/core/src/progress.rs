//! Progress: engines count pieces of work, the command line reads the counts and draws them.
//!
//! A process works on one command at a time. No decision depends on these counts.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

static DONE: AtomicU64 = AtomicU64::new(0);
static EXPECTED: AtomicU64 = AtomicU64::new(0);

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
