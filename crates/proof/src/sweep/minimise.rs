//! The simplest counterexample of a sweep.

use super::config::Item;
use super::exhaust::{Exhaust, Trial};
use super::finding::{Finding, Witness};
use super::grid::Grid;
use super::range::degree;
use super::run::starts;
use crate::counterexample::Counterexample;
use cordon_core::{Error, Result};

/// Most drone updates that are spent on shorter segments; a counterexample stays as it was
/// found where these are not enough. Squares are slower.
const MOST_UPDATES: u64 = 100_000_000;
const MOST_UPDATES_OF_SQUARES: u64 = 5_000_000;

/// A counterexample of these findings, all of one theorem and form, that cannot be made simpler
/// within the sweep: fewest drones, then least k, then the weight with the least denominator
/// (then numerator), then the shortest segment, then the first start in lexicographic order.
///
/// # Errors
/// A finding whose counterexample the spec does not confirm.
pub fn simplest<'f>(
    findings: impl IntoIterator<Item = &'f Finding>,
) -> Result<Option<Counterexample>> {
    let refuted = findings.into_iter().filter_map(|f| f.counterexample.as_ref().map(|w| (f, w)));
    let order = |(f, w): &(&Finding, &Witness)| {
        (f.drones, w.step, f.eps.denom().clone(), f.eps.numer().clone())
    };
    let Some((finding, witness)) = refuted.min_by_key(order) else { return Ok(None) };
    let item = Item {
        number: finding.item,
        theorem: finding.theorem,
        form: finding.form,
        drones: finding.drones,
        eps: finding.eps.clone(),
    };
    match item.refuted_by(witness.start.clone(), witness.step) {
        Some(found) => Ok(Some(shortest(&item, &found).unwrap_or(found))),
        // Those of files were run again when they were read.
        None => Err(Error::internal(format!(
            "work item {}: start and step of its counterexample violate nothing",
            item.number
        ))),
    }
}

/// The first start on the shortest segment that fails no later.
fn shortest(item: &Item, found: &Counterexample) -> Option<Counterexample> {
    let longest = i64::try_from(found.start().last()?.to_integer()).ok()?;
    let mut left = match degree(item.theorem) {
        2 => MOST_UPDATES_OF_SQUARES,
        _ => MOST_UPDATES,
    };
    for length in 1..=longest {
        let grid = Grid::of_length(starts(item), item.drones, length)?;
        let engine = Exhaust::new(item, found.step, length);
        let mut trial = Trial::new(&engine, Grid::mirrored(item.theorem, starts(item)));
        grid.for_each(&grid.whole(), |start| {
            trial.start(start);
            trial.so_far().counts.updates < left
        });
        let tally = trial.end();
        if let Some(shorter) = tally.counterexample(item) {
            return Some(shorter);
        }
        left = left.checked_sub(tally.counts.updates.max(1)).filter(|left| *left > 0)?;
    }
    None
}
