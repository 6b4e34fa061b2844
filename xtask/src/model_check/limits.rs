//! Resource limits of a run of the model checker.

use std::num::NonZero;
use std::thread::available_parallelism;

/// The resource limits of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Number of harnesses in parallel.
    pub jobs: usize,
    /// Time limit of each harness, in seconds.
    pub seconds: u64,
    /// Memory limit of each harness, in MiB of address space.
    pub mebibytes: u64,
}

impl Limits {
    /// These limits; without a number of jobs, one job per processor as far as the free memory allows.
    pub fn allowed(jobs: Option<usize>, seconds: u64, mebibytes: u64) -> Self {
        let jobs = jobs.unwrap_or_else(|| {
            let processors = available_parallelism().map_or(1, NonZero::get);
            let free = std::fs::read_to_string("/proc/meminfo").ok().and_then(|t| available(&t));
            fitting(processors, free, mebibytes)
        });
        Self { jobs, seconds, mebibytes }
    }
}

/// One job per processor, as far as the free memory allows; one if that is unknown.
fn fitting(processors: usize, free_mebibytes: Option<u64>, mebibytes: u64) -> usize {
    let jobs = free_mebibytes.map_or(1, |free| free / mebibytes.max(1));
    usize::try_from(jobs).unwrap_or(usize::MAX).clamp(1, processors.max(1))
}

/// The available memory in MiB, as reported by Linux.
fn available(meminfo: &str) -> Option<u64> {
    let line = meminfo.lines().find_map(|l| l.strip_prefix("MemAvailable:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes / 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jobs_fit_processors_and_memory() {
        assert_eq!(fitting(2, Some(20_000), 4096), 2);
        assert_eq!(fitting(8, Some(20_000), 4096), 4);
        assert_eq!(fitting(8, Some(100), 4096), 1);
        assert_eq!(fitting(8, None, 4096), 1);
        assert_eq!(Limits::allowed(Some(3), 60, 4096).jobs, 3);
        assert!(Limits::allowed(None, 60, 4096).jobs >= 1);
    }

    #[test]
    fn the_free_memory_is_read() {
        let text = "MemTotal:       24627376 kB\nMemFree: 1 kB\nMemAvailable:   20480000 kB\n";
        assert_eq!(available(text), Some(20_000));
        assert_eq!(available("MemTotal: 1 kB\n"), None);
    }
}
