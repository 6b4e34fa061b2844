//! Progress on stderr with rate and time left; where stderr is not a terminal, only one line at the
//! end.

use std::io::Write;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressState, ProgressStyle};

use crate::cli::progress;
use cordon_core::Result;
use cordon_proof::sweep::run::Progress;
use cordon_proof::sweep::{Config, StartSpace};

/// The unit of progress.
#[derive(Clone, Copy, Debug)]
pub(super) enum WorkUnit {
    DroneUpdates,
    WorkItems,
}

impl WorkUnit {
    pub(super) fn of(config: &Config) -> Self {
        if config.starts == StartSpace::Complete { Self::WorkItems } else { Self::DroneUpdates }
    }

    fn name(self) -> &'static str {
        match self {
            Self::DroneUpdates => "drone updates",
            Self::WorkItems => "work items",
        }
    }
}

/// Refresh interval.
const REFRESH: Duration = Duration::from_millis(200);

/// Runs `job` with a progress bar.
pub(super) fn watched(
    progress: &Progress,
    total: u64,
    unit: WorkUnit,
    resumed: usize,
    job: impl FnOnce() -> Result<()>,
) -> Result<()> {
    if resumed > 0 {
        // If stderr is closed there is nothing left to do; likewise below.
        let _ = writeln!(std::io::stderr(), "resumed: {resumed} work items were finished before");
    }
    progress::shown_elsewhere();
    let began = Instant::now();
    let bar = ProgressBar::new(total);
    let template = format!(
        "{{wide_bar}} {{percent:>3}}% of {{human_len}} {}, {{rate}}, {{eta}} left",
        unit.name()
    );
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style.with_key("rate", shown_rate));
    }
    let (ended, waiting) = channel::<()>();
    let result = std::thread::scope(|scope| {
        let drawn = &bar;
        scope.spawn(move || {
            while waiting.recv_timeout(REFRESH) == Err(RecvTimeoutError::Timeout) {
                drawn.set_position(progress.covered());
            }
        });
        let result = job();
        drop(ended);
        result
    });
    bar.finish_and_clear();
    if result.is_ok() {
        let seconds = began.elapsed().as_secs_f64();
        let (done, covered) = (progress.executed(), progress.covered());
        let rate = per_second(done as f64 / seconds.max(1e-9));
        let mirrored = match covered - done {
            0 => String::new(),
            images => format!(" (and {images} by symmetry)"),
        };
        let _ = writeln!(
            std::io::stderr(),
            "{done} {}{mirrored} in {seconds:.2} s: {rate}",
            unit.name()
        );
    }
    result
}

/// A rate in readable form.
fn per_second(rate: f64) -> String {
    if rate >= 1e6 {
        format!("{:.0} million a second", rate / 1e6)
    } else {
        format!("{rate:.0} a second")
    }
}

/// The rate of covered work, for the bar.
fn shown_rate(state: &ProgressState, to: &mut dyn std::fmt::Write) {
    // Failing to draw the bar does not fail the sweep.
    let _ = write!(to, "{}", per_second(state.per_sec()));
}
