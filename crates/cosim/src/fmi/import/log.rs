//! What FMUs say through their loggers, kept until an error is to be explained.

use std::cell::RefCell;

use log::{LevelFilter, Log, Metadata, Record};

thread_local! {
    /// Messages on this thread since they were last taken. Every FMU has a thread of its own.
    static MESSAGES: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

/// Most messages that are kept: the first ones explain, the rest repeats.
const MOST: usize = 8;

struct Collector;

static COLLECTOR: Collector = Collector;

impl Log for Collector {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.level() <= log::Level::Warn
    }

    fn log(&self, record: &Record<'_>) {
        if self.enabled(record.metadata()) {
            MESSAGES.with_borrow_mut(|messages| {
                if messages.len() < MOST {
                    messages.push(record.args().to_string());
                }
            });
        }
    }

    fn flush(&self) {}
}

/// Listens from now on. A program that has another logger already keeps it.
pub(super) fn listen() {
    if log::set_logger(&COLLECTOR).is_ok() {
        log::set_max_level(LevelFilter::Warn);
    }
}

/// The messages on this thread since the last call.
pub(super) fn take() -> Vec<String> {
    MESSAGES.with_borrow_mut(std::mem::take)
}
