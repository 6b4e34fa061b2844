//! Putting the parts of a sweep together.

use std::path::{Path, PathBuf};

use super::config::{Config, Item};
use super::finding::Finding;
use super::run::{Progress, run};
use super::shard::Shard;
use super::store::{Header, belongs, consistent, difference, read};
use cordon_core::random::SplitMix;
use cordon_core::{Error, Result};

/// The whole sweep whose parts these files hold, item by item.
///
/// # Errors
/// A file that cannot be read or is damaged, files of different configurations, a work item
/// that no file or more than one file holds, a line that contradicts its sweep or itself.
pub fn merge(paths: &[PathBuf]) -> Result<(Config, Vec<Finding>)> {
    let mut parts = Vec::new();
    for path in paths {
        let part = read(path)?;
        parts.push((path.as_path(), part));
    }
    let Some((first_path, first)) = parts.first() else {
        return Err(Error::input("files: expected at least one result file"));
    };
    let config = first.header.config.clone();
    for (path, part) in &parts {
        let here = Header { shard: Shard::WHOLE, ..part.header.clone() };
        let there = Header { shard: Shard::WHOLE, ..first.header.clone() };
        if let Some((field, a, b)) = difference(&here, &there)? {
            return Err(Error::input(format!(
                "`{}` and `{}` are parts of different sweeps: {field} is {a} and {b}",
                first_path.display(),
                path.display()
            )));
        }
    }
    let items = config.items()?;
    let mut slots: Vec<Option<(&Path, Finding)>> = vec![None; items.len()];
    for (path, part) in parts {
        for (i, finding) in part.findings.into_iter().enumerate() {
            let number = finding.item;
            place(path, finding, &items, &mut slots)?;
            if let (Some(item), Some(Some((_, finding)))) = (items.get(number), slots.get(number)) {
                consistent(path, i + 2, &config, item, finding)?;
            }
        }
    }
    let missing: Vec<usize> = (0..slots.len()).filter(|i| slots[*i].is_none()).collect();
    if let Some(first) = missing.first() {
        return Err(Error::input(format!(
            "{} of {} work items are in no file, the first of them item {first}{}",
            missing.len(),
            items.len(),
            items.get(*first).map_or_else(String::new, described)
        )));
    }
    Ok((config, slots.into_iter().flatten().map(|(_, finding)| finding).collect()))
}

/// Computes `count` of the findings anew, drawn with a seed, and compares. Answers with the work
/// items that were drawn, ascending.
///
/// # Errors
/// A finding is another one than this program finds.
pub fn audit(config: &Config, findings: &[Finding], count: usize, seed: u64) -> Result<Vec<usize>> {
    let items = config.items()?;
    let mut random = SplitMix::new(seed);
    let mut left: Vec<usize> = (0..findings.len()).collect();
    let mut drawn = Vec::new();
    while drawn.len() < count && !left.is_empty() {
        let place = random.below(left.len() as u64);
        drawn.push(left.swap_remove(usize::try_from(place).unwrap_or_default()));
    }
    drawn.sort_unstable();
    let chosen: Vec<Item> = drawn.iter().filter_map(|&i| items.get(i).cloned()).collect();
    run(config, &chosen, 0, &Progress::default(), |found| match findings.get(found.item) {
        Some(recorded) if *recorded == found => Ok(()),
        _ => Err(Error::input(format!(
            "audit: work item {}{}: this program finds something else: expected {} of {} cases violated, {} of them not vacuous",
            found.item,
            items.get(found.item).map_or_else(String::new, described),
            found.counts.violations,
            found.counts.cases,
            found.counts.non_vacuous
        ))),
    })?;
    Ok(drawn)
}

fn place<'p>(
    path: &'p Path,
    finding: Finding,
    items: &[Item],
    slots: &mut [Option<(&'p Path, Finding)>],
) -> Result<()> {
    let number = finding.item;
    let (Some(item), Some(slot)) = (items.get(number), slots.get_mut(number)) else {
        return Err(Error::input(format!(
            "`{}`: work item {number}: expected fewer than {}",
            path.display(),
            items.len()
        )));
    };
    if !belongs(&finding, item) {
        return Err(Error::input(format!(
            "`{}`: work item {number} is about something else: expected{}",
            path.display(),
            described(item)
        )));
    }
    if let Some((other, _)) = slot {
        return Err(Error::input(format!(
            "work item {number}{} is in `{}` and again in `{}`",
            described(item),
            other.display(),
            path.display()
        )));
    }
    *slot = Some((path, finding));
    Ok(())
}

fn described(item: &Item) -> String {
    format!(
        " ({} {}, N = {}, eps = {})",
        item.theorem.number(),
        item.form.label(),
        item.drones,
        item.eps
    )
}
