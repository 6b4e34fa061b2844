//! How far work has come: engines count, whoever watches reads.
//!
//! A process has one piece of work at a time, a command's. Nothing is decided by these counts.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

static DONE: AtomicU64 = AtomicU64::new(0);
static EXPECTED: AtomicU64 = AtomicU64::new(0);

/// So many more pieces of work are to be done.
pub fn expect(pieces: u64) {
    EXPECTED.fetch_add(pieces, Relaxed);
}

/// So many more pieces are done.
pub fn advance(pieces: u64) {
    DONE.fetch_add(pieces, Relaxed);
}

/// Pieces done, and pieces expected in all: 0 where nobody has said.
pub fn so_far() -> (u64, u64) {
    (DONE.load(Relaxed), EXPECTED.load(Relaxed))
}
