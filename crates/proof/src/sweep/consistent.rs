//! Lines of result files that contradict their sweep or themselves.

use num_bigint::BigUint;

use super::config::{Config, Item, StartSpace};
use super::finding::{Finding, Witness};
use super::run::{grid, per_start};
use cordon_core::{Evidence, Result};

/// What in a finding cannot be so, whatever the sweep has found: `None` where nothing is.
///
/// A counterexample is run again; what a line says of starts without one is not. That is
/// what [`audit`](super::merge::audit) is for.
///
/// # Errors
/// The grid of the configuration is out of range.
pub fn contradiction(config: &Config, item: &Item, found: &Finding) -> Result<Option<String>> {
    let counts = &found.counts;
    let (evidence, segment, starts) = match config.starts {
        StartSpace::Complete => (Evidence::CompleteForAllStarts, None, None),
        StartSpace::Grid { resolution } => {
            let grid = grid(item, resolution)?;
            (Evidence::ExhaustiveOnGrid, Some(grid.length), Some(grid.size()))
        }
        StartSpace::Sample { resolution, samples, .. } => {
            let grid = grid(item, resolution)?;
            (Evidence::Sampled, Some(grid.length), Some(samples.into()))
        }
    };
    let steps = config.steps as u64 + 1;
    let cases = match starts {
        None => steps.into(),
        Some(_) => BigUint::from(counts.starts) * steps,
    };
    let most_updates = BigUint::from(counts.starts) * per_start(config, item);
    let fault = if found.evidence != evidence {
        format!("evidence `{}`: expected `{}`", found.evidence.text(), evidence.text())
    } else if found.segment != segment {
        let shown = |s: Option<i64>| s.map_or("none".to_owned(), |s| s.to_string());
        format!("segment {}: expected {}", shown(found.segment), shown(segment))
    } else if let Some(starts) = starts.filter(|s| *s != counts.starts.into()) {
        format!("{} starts: expected {starts}", counts.starts)
    } else if cases != counts.cases.into() {
        format!("{} cases: expected {cases}", counts.cases)
    } else if counts.non_vacuous.saturating_add(counts.undecided) > counts.cases {
        format!(
            "{} non-vacuous and {} undecided cases: expected at most {} together",
            counts.non_vacuous, counts.undecided, counts.cases
        )
    } else if counts.violations > counts.non_vacuous {
        format!(
            "{} violations: expected at most as many as non-vacuous cases, {}",
            counts.violations, counts.non_vacuous
        )
    } else if segment.is_some() && most_updates < counts.updates.into() {
        format!("{} updates: expected at most {most_updates}", counts.updates)
    } else if found.verdict != counts.judgement() {
        format!(
            "verdict `{}`: expected `{}`, which the counts say",
            found.verdict.text(),
            counts.judgement().text()
        )
    } else if counts.undecided > 0 && found.reason.is_none() {
        format!("{} undecided cases: expected a reason", counts.undecided)
    } else {
        return Ok(example(config, item, found));
    };
    Ok(Some(fault))
}

/// What is wrong with the counterexample.
fn example(config: &Config, item: &Item, found: &Finding) -> Option<String> {
    match (&found.counterexample, found.counts.violations) {
        (None, 0) => None,
        (None, violations) => Some(format!("{violations} violations: expected a counterexample")),
        (Some(_), 0) => Some("a counterexample: expected none without a violation".to_owned()),
        (Some(witness), _) => {
            let sized = witness.start.len() == item.drones && witness.step <= config.steps;
            let again = sized.then(|| item.refuted_by(witness.start.clone(), witness.step));
            match again.flatten() {
                None => Some("counterexample: the spec does not confirm it".to_owned()),
                Some(again) if Witness::from(&again) != *witness => {
                    Some(format!("counterexample: expected `{}`", again.what_fails()))
                }
                Some(_) => None,
            }
        }
    }
}
