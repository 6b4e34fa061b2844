//! Parts of a sweep that machines run apart, of about the same cost.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use num_bigint::{BigInt, BigUint};
use serde::{Deserialize, Serialize};

use super::config::{Config, Item, StartSpace};
use super::grid::Grid;
use super::lanes::Lanes;
use super::machine::Wide;
use super::range::Range;
use super::run::{grid, starts};
use cordon_core::{Error, Result};

/// Which part of a sweep.
///
/// Work items are dealt out from the costliest to the cheapest, each to the part with the least
/// cost so far (the first of these): no part costs more than 4/3 of the largest of the best
/// division (Graham 1969).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Shard {
    /// From 1 to `of`.
    pub index: usize,
    /// Number of parts, at least 1.
    pub of: usize,
}

impl Shard {
    /// The whole sweep as its only part.
    pub const WHOLE: Self = Self { index: 1, of: 1 };

    /// Reads `i/n` with 1 <= i <= n.
    ///
    /// # Errors
    /// Anything else.
    pub fn parse(text: &str) -> Result<Self> {
        let bad =
            || Error::input(format!("shard: `{text}`: expected I/N with 1 <= I <= N, like 2/8"));
        let (index, of) = text.split_once('/').ok_or_else(bad)?;
        let index = index.trim().parse().map_err(|_| bad())?;
        let of = of.trim().parse().map_err(|_| bad())?;
        if index < 1 || index > of { Err(bad()) } else { Ok(Self { index, of }) }
    }

    /// Its items among those of the whole sweep, in their order.
    ///
    /// # Errors
    /// The sweep has fewer items than parts, or a grid is out of range.
    pub fn of_items(self, config: &Config, items: Vec<Item>) -> Result<Vec<Item>> {
        if self.of > items.len() {
            return Err(Error::input(format!(
                "shard: `{}/{}`: the sweep has fewer work items than that: expected at most {} parts",
                self.index,
                self.of,
                items.len()
            )));
        }
        Ok(parts(config, items, self.of)?.swap_remove(self.index - 1).items)
    }
}

/// A part of a sweep.
#[derive(Clone, Debug, Default)]
pub struct Part {
    /// Its work items, in the order of the sweep.
    pub items: Vec<Item>,
    /// About what they cost, in drone updates on 32-bit integers.
    pub cost: BigUint,
}

/// All parts of a sweep that is run in so many.
///
/// # Errors
/// A grid is out of range.
pub fn parts(config: &Config, items: Vec<Item>, of: usize) -> Result<Vec<Part>> {
    let mut costly = Vec::with_capacity(items.len());
    for item in items {
        costly.push((cost(config, &item)?, item));
    }
    costly.sort_by(|a, b| (&b.0, a.1.number).cmp(&(&a.0, b.1.number)));
    let mut parts = vec![Part::default(); of];
    let mut least: BinaryHeap<_> = (0..of).map(|part| Reverse((BigUint::ZERO, part))).collect();
    for (cost, item) in costly {
        let Some(Reverse((before, at))) = least.pop() else { break };
        let part = &mut parts[at];
        part.cost = before + cost;
        part.items.push(item);
        least.push(Reverse((part.cost.clone(), at)));
    }
    for part in &mut parts {
        part.items.sort_unstable_by_key(|item| item.number);
    }
    Ok(parts)
}

/// The largest cost of a part over the mean, to two places.
pub fn imbalance(parts: &[Part]) -> String {
    let total: BigUint = parts.iter().map(|p| &p.cost).sum();
    let largest = parts.iter().map(|p| &p.cost).max().cloned().unwrap_or_default();
    let hundredths = largest * parts.len() * 100u8 / total.max(1u8.into());
    format!("{}.{:02}", &hundredths / 100u8, hundredths % 100u8)
}

/// What a drone update costs on integers of 53, 64, 128 and 256 bits and on big ones, measured
/// against one of 32 bits (`cargo bench --bench sweep`).
const DEARER: [u64; 5] = [2, 3, 12, 60, 300];

/// About what an item costs.
fn cost(config: &Config, item: &Item) -> Result<BigUint> {
    let (resolution, drawn) = match config.starts {
        StartSpace::Grid { resolution } => (resolution, None),
        StartSpace::Sample { resolution, samples, .. } => (resolution, Some(samples)),
        // Each of about N generators, of N drones each.
        StartSpace::Complete => return Ok((item.drones * item.drones).into()),
    };
    let grid = grid(item, resolution)?;
    let run = match drawn {
        Some(samples) => samples.into(),
        None if Grid::mirrored(item.theorem, starts(item)) => grid.size() / 2u8,
        None => grid.size(),
    };
    let length = BigInt::from(grid.length);
    let range = Range::new(item.theorem, item.form, item.drones, &item.eps, &length);
    let last = config.steps;
    let held = [
        range.last_step::<Lanes<i32>>(last),
        range.last_step::<Lanes<f64>>(last),
        range.last_step::<Lanes<i64>>(last),
        range.last_step::<i128>(last),
        range.last_step::<Wide>(last),
    ];
    // Every step costs that of 32 bits, and more from where an integer is left.
    let mut steps = last as u64 + 1;
    let mut before = 1;
    for (held, dearer) in held.into_iter().zip(DEARER) {
        steps += (last + 1 - held.map_or(0, |k| k + 1)) as u64 * (dearer - before);
        before = dearer;
    }
    Ok((run + 1u8) * item.drones * steps)
}
