//! Checking claims of a protocol file along a run.

use std::collections::BTreeMap;

use super::{Counted, Selection, select};
use crate::scenario::{Own, Scenario};
use cordon_core::exact::fraction;
use cordon_core::system::{Claim, Parameter};
use cordon_core::{Error, Outcome, Rational, Result};

/// The result of checking one claim, as written in the file, along one run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CheckedClaim {
    /// Its number in the file, from 1.
    pub number: usize,
    /// The claim as written in the file.
    pub text: String,
    /// Whether it holds, for every step that it applies to.
    pub holds: BTreeMap<u64, bool>,
    /// The first violation: its step, and what fails there, in words.
    pub first_violation: Option<(u64, String)>,
}

impl CheckedClaim {
    /// Refuted where a step violates the claim.
    pub fn outcome(&self) -> Outcome {
        if self.first_violation.is_some() { Outcome::Refuted } else { Outcome::Holds }
    }
}

/// Checks claims at every protocol step from 0 to `last`: those with the given numbers, or all.
///
/// # Errors
/// No protocol file is run, it has no claims or none of that number, or the start does not meet the file's
/// assumptions.
pub fn check_claims(
    scenario: &Scenario,
    numbers: Option<&[usize]>,
    last: u64,
) -> Result<Vec<CheckedClaim>> {
    let own = scenario.own().ok_or_else(|| Error::internal("claims without a protocol file"))?;
    let system = &own.system;
    let start = scenario.whole_start();
    if let Some(broken) = system.starts.iter().find(|p| !p.holds(&start)) {
        return Err(Error::input(format!(
            "start: does not meet `{}`: expected a start that the protocol assumes",
            broken.text
        )));
    }
    let group = |(before, (text, indices)): (usize, (&str, Vec<usize>))| {
        let (number, text) = (before + 1, text.to_owned());
        let claims = indices.into_iter().filter_map(|index| system.claims.get(index));
        let found = CheckedClaim { number, text, holds: BTreeMap::new(), first_violation: None };
        (found, claims.collect())
    };
    let mut groups: Vec<(CheckedClaim, Vec<&Claim>)> =
        system.written_claims().into_iter().enumerate().map(group).collect();
    if groups.is_empty() {
        return Err(Error::input(
            "check: the protocol file has no `claims`: expected some to check",
        ));
    }
    if let Some(wrong) = numbers.iter().copied().flatten().find(|n| !(1..=groups.len()).contains(n))
    {
        return Err(Error::input(format!(
            "check: `{wrong}`: expected `all` or numbers of the file's claims, 1 to {}",
            groups.len()
        )));
    }
    groups.retain(|(found, _)| numbers.is_none_or(|numbers| numbers.contains(&found.number)));
    for row in select(scenario, Selection { unit: Counted::Steps, from: 0, to: last, every: 1 })? {
        let state = row.positions.lowest();
        let step = usize::try_from(row.step).unwrap_or(usize::MAX);
        for (found, group) in &mut groups {
            let about: Vec<_> = group.iter().filter(|c| c.is_about(step)).collect();
            if about.is_empty() {
                continue;
            }
            let broken = about.iter().find(|c| !c.predicate.holds(&state));
            found.holds.insert(row.step, broken.is_none());
            if let (Some(claim), None) = (broken, &found.first_violation) {
                found.first_violation = Some((row.step, violation(claim, row.step, &state)));
            }
        }
    }
    Ok(groups.into_iter().map(|(found, _)| found).collect())
}

fn violation(claim: &Claim, step: u64, state: &[Rational]) -> String {
    let by = match claim.predicate.is.form.at(state) {
        Some(difference) if difference == Rational::default() => "its sides are equal".to_owned(),
        Some(difference) if difference < Rational::default() => {
            format!("missed by {}", fraction(&-difference))
        }
        Some(difference) => format!("missed by {}", fraction(&difference)),
        None => "missed".to_owned(),
    };
    let agent = claim.predicate.text.rsplit_once(" (").map_or("", |(_, agent)| agent);
    let agent = agent.strip_suffix(')').map_or_else(String::new, |agent| format!(", {agent}"));
    format!("at step {step}{agent}: {by}")
}

/// The parameters whose values in a run are outside the file's ranges, for which the file claims
/// nothing.
pub fn out_of_range(own: &Own) -> impl Iterator<Item = &Parameter> {
    own.values().filter(|(p, value)| !(&p.low..=&p.high).contains(value)).map(|(p, _)| p)
}
