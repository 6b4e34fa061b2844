//! Running work items on all cores, their findings coming in the order of the items.
//!
//! Items are run in batches, and each item in pieces (starts with the same first positions),
//! all of them by one pool of threads. Findings are sums and minima over pieces: the number of
//! threads changes nothing but the time. Memory does not grow with the number of cases.

use std::sync::atomic::{AtomicU64, Ordering};

use cordon_spec::theorems::StartSet;
use num_bigint::BigUint;
use rayon::prelude::*;

use super::complete::complete;
use super::config::{Config, Item, StartSpace};
use super::exhaust::{Exhaust, Tally, Trial};
use super::finding::{Finding, Witness};
use super::grid::Grid;
use super::sample::{PIECE, sample};
use cordon_core::{Error, Evidence, Result};

/// Work done so far, in drone updates (in a complete sweep: in work items); other threads may
/// watch it.
#[derive(Debug, Default)]
pub struct Progress {
    covered: AtomicU64,
    executed: AtomicU64,
}

impl Progress {
    /// The work that is covered, mirror images included: the part of [`work`] that is done.
    pub fn covered(&self) -> u64 {
        self.covered.load(Ordering::Relaxed)
    }

    /// The work that was executed for it.
    pub fn executed(&self) -> u64 {
        self.executed.load(Ordering::Relaxed)
    }

    fn add(&self, covered: u64, executed: u64) {
        self.covered.fetch_add(covered, Ordering::Relaxed);
        self.executed.fetch_add(executed, Ordering::Relaxed);
    }
}

/// An upper bound of the work of these items, in the unit of [`Progress`].
///
/// # Errors
/// It cannot be counted in 64 bits: such a sweep would not end.
pub fn work(config: &Config, items: &[Item]) -> Result<u64> {
    if config.starts == StartSpace::Complete {
        return Ok(items.len() as u64);
    }
    let mut total = BigUint::ZERO;
    for item in items {
        total += work_of(config, item)?;
    }
    u64::try_from(&total).map_err(|_| {
        Error::input(
            "grid: the sweep has more than 2^64 drone updates: expected a coarser grid, fewer drones or `--sample`",
        )
    })
}

fn work_of(config: &Config, item: &Item) -> Result<BigUint> {
    let starts = match config.starts {
        StartSpace::Grid { resolution } => grid(item, resolution)?.size(),
        StartSpace::Sample { samples, .. } => samples.into(),
        StartSpace::Complete => return Ok(1u8.into()),
    };
    let span = item.theorem.span(item.form, item.drones);
    Ok(starts * (item.drones * (config.steps + span)))
}

/// Least work, in drone updates, that is worth a batch: what keeps every thread busy for a
/// while, and the longest time that a killed sweep loses short of one item.
const BATCH_WORK: u64 = 50_000_000;

/// Most items in a batch.
const BATCH_ITEMS: usize = 512;

/// Runs the items on `threads` threads (0: one for each core), handing every finding to `emit`
/// in the order of the items.
///
/// # Errors
/// What `emit` reports, a grid out of range, or threads that cannot be started.
pub fn run(
    config: &Config,
    items: &[Item],
    threads: usize,
    progress: &Progress,
    mut emit: impl FnMut(Finding) -> Result<()>,
) -> Result<()> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|e| Error::input(format!("threads: `{threads}`: {e}")))?;
    let mut rest = items;
    while !rest.is_empty() {
        let mut planned = BigUint::ZERO;
        let mut size = 0;
        for item in rest.iter().take(BATCH_ITEMS) {
            planned += work_of(config, item)?;
            size += 1;
            if planned >= BATCH_WORK.into() {
                break;
            }
        }
        let (batch, later) = rest.split_at(size);
        let found: Vec<Result<Finding>> = pool.install(|| {
            batch.par_iter().with_max_len(1).map(|item| find(config, item, progress)).collect()
        });
        for finding in found {
            emit(finding?)?;
        }
        rest = later;
    }
    Ok(())
}

/// In how many shares, at most, the pieces of a grid are run: each fills its last batch of
/// starts by itself.
const SHARES: usize = 512;

fn find(config: &Config, item: &Item, progress: &Progress) -> Result<Finding> {
    let done = |tally: Tally| {
        let covered = tally.counts.starts.saturating_mul(per_start(config, item));
        progress.add(covered, tally.counts.updates);
        tally
    };
    match config.starts {
        StartSpace::Complete => {
            let finding = complete(item, config.steps);
            progress.add(1, 1);
            Ok(finding)
        }
        StartSpace::Grid { resolution } => {
            let grid = grid(item, resolution)?;
            let engine = Exhaust::new(item, config.steps, grid.length);
            let mirrored = Grid::mirrored(item.theorem, starts(item));
            let pieces = grid.pieces();
            let tally = pieces
                .par_chunks(pieces.len().div_ceil(SHARES))
                .map(|pieces| {
                    let mut trial = Trial::new(&engine, mirrored);
                    pieces.iter().for_each(|piece| trial.sweep(&grid, piece));
                    done(trial.end())
                })
                .reduce(Tally::default, Tally::merge);
            finding(item, Evidence::ExhaustiveOnGrid, &grid, &tally)
        }
        StartSpace::Sample { resolution, samples, seed } => {
            let grid = grid(item, resolution)?;
            let engine = Exhaust::new(item, config.steps, grid.length);
            let tally = (0..samples.div_ceil(PIECE))
                .into_par_iter()
                .map(|piece| done(sample(&engine, &grid, samples, piece, seed, item.number)))
                .reduce(Tally::default, Tally::merge);
            finding(item, Evidence::Sampled, &grid, &tally)
        }
    }
}

/// The grid of a work item.
pub(super) fn grid(item: &Item, resolution: u32) -> Result<Grid> {
    let starts = starts(item);
    Grid::new(starts, item.drones, resolution).ok_or_else(|| {
        Error::input(format!("grid: `{resolution}`: the segment leaves the range of 64 bits"))
    })
}

/// The start set of a work item's hypothesis.
pub fn starts(item: &Item) -> StartSet {
    item.theorem.hypothesis(item.form).starts
}

/// Drone updates of one start, mirror images included.
pub(super) fn per_start(config: &Config, item: &Item) -> u64 {
    (item.drones * (config.steps + item.theorem.span(item.form, item.drones))) as u64
}

fn finding(item: &Item, evidence: Evidence, grid: &Grid, tally: &Tally) -> Result<Finding> {
    let undecided = tally.counts.undecided > 0;
    let counterexample = tally.counterexample(item);
    if counterexample.is_none() && tally.first.is_some() {
        return Err(Error::internal(format!(
            "work item {}: the spec does not confirm the violation that the sweep found",
            item.number
        )));
    }
    Ok(Finding {
        segment: Some(grid.length),
        counterexample: counterexample.as_ref().map(Witness::from),
        reason: undecided.then(|| "the predicate left a case open".to_owned()),
        ..Finding::new(item, evidence, tally.counts)
    })
}
