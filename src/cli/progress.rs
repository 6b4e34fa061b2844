//! Progress of work that takes over two seconds: shown on a terminal only.

use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

use cordon_core::progress::{so_far, tried};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Time after which progress is shown.
const LONG: Duration = Duration::from_secs(2);

/// Refresh interval.
const REFRESH: Duration = Duration::from_millis(200);

static ELSEWHERE: AtomicBool = AtomicBool::new(false);
static AT_ONCE: AtomicBool = AtomicBool::new(false);

/// Announces on stderr that the work is going to be long.
pub fn announce(what: &str) {
    // If stderr is closed there is nothing left to do.
    let _ = writeln!(io::stderr(), "note: {what}");
}

/// Shows progress from now on, however short the work is.
pub fn at_once() {
    AT_ONCE.store(true, Relaxed);
}

/// Disables this display: the command shows its own progress.
pub fn shown_elsewhere() {
    ELSEWHERE.store(true, Relaxed);
}

/// Shows progress until it is dropped.
pub struct Heartbeat {
    bar: ProgressBar,
    ended: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Heartbeat {
    /// Starts the timer; `None` where stderr is not a terminal.
    pub fn start() -> Option<Self> {
        if !io::stderr().is_terminal() {
            return None;
        }
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let (ended, waiting) = channel::<()>();
        let drawn = bar.clone();
        let thread = std::thread::spawn(move || {
            let (mut waited, mut drawing) = (Duration::ZERO, false);
            while waiting.recv_timeout(REFRESH) == Err(RecvTimeoutError::Timeout) {
                waited += REFRESH;
                let wanted = waited >= LONG || AT_ONCE.load(Relaxed);
                if wanted && !drawing && !ELSEWHERE.load(Relaxed) {
                    drawn.set_draw_target(ProgressDrawTarget::stderr());
                    drawing = true;
                }
                draw(&drawn);
            }
        });
        Some(Self { bar, ended: Some(ended), thread: Some(thread) })
    }
}

fn draw(bar: &ProgressBar) {
    let (done, expected) = so_far();
    if expected > 1 {
        bar.set_length(expected);
        bar.set_position(done);
    }
    let tried = tried();
    let shown = template(expected, &tried);
    bar.set_message(tried);
    // If our own template did not parse, the default bar would be shown.
    if let Ok(style) = ProgressStyle::with_template(shown) {
        bar.set_style(style);
    }
    bar.tick();
}

/// The line for so many pieces of work, or for what is tried.
fn template(expected: u64, tried: &str) -> &'static str {
    match (expected > 1, tried.is_empty()) {
        (true, _) => "{wide_bar} {percent:>3}%, {per_sec}, {eta} left",
        (false, true) => "{spinner} at work for {elapsed}",
        // Cut at the end of the line.
        (false, false) => "{spinner} at work for {elapsed}: {wide_msg}",
    }
}

impl Drop for Heartbeat {
    fn drop(&mut self) {
        drop(self.ended.take());
        if let Some(thread) = self.thread.take() {
            // A thread that has panicked draws nothing more.
            let _ = thread.join();
        }
        self.bar.finish_and_clear();
    }
}

/// A stream that may share the terminal with the progress line, which is cleared while the stream is
/// written to.
pub struct Beside<'h, W> {
    /// The stream that is written.
    pub stream: W,
    /// The progress display, if any.
    pub heartbeat: Option<&'h Heartbeat>,
}

impl<W: Write> Write for Beside<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.heartbeat {
            Some(heartbeat) => heartbeat.bar.suspend(|| self.stream.write(bytes)),
            None => self.stream.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self.heartbeat {
            Some(heartbeat) => heartbeat.bar.suspend(|| self.stream.flush()),
            None => self.stream.flush(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_tried_is_shown_where_pieces_cannot_be_counted() {
        assert!(template(9, "eps = 1/2").contains("{wide_bar}"));
        assert_eq!(template(0, ""), "{spinner} at work for {elapsed}");
        assert!(template(0, "eps = 1/2").ends_with(": {wide_msg}"));
        cordon_core::progress::tries("eps = 1/2");
        assert_eq!(tried(), "eps = 1/2");
        let bar = ProgressBar::hidden();
        draw(&bar);
        assert_eq!(bar.message(), "eps = 1/2");
    }
}
