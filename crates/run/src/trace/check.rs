//! Theorems checked along a run.

use std::collections::{BTreeMap, VecDeque};

use cordon_core::theorems;
use cordon_spec::State;
use cordon_spec::theorems::{Form, Setting, Theorem, Truth, Verdict};

use crate::scenario::Scenario;
use crate::simulate;
use cordon_core::exact::Rational;
use cordon_core::{Error, Outcome, Result, violation};

/// What a check found of one theorem along one run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checked {
    /// The theorem.
    pub theorem: Theorem,
    /// The form whose hypothesis and conclusion were used.
    pub form: Form,
    /// Whether the weight is in the theorem's range. A violation outside it refutes no
    /// theorem; it shows why the range is needed.
    pub weight_in_range: bool,
    /// Verdict at every step from 0 to the last.
    pub verdicts: BTreeMap<u64, Verdict>,
    /// The first violation: its step, and what fails there in words with exact values.
    pub first_violation: Option<(u64, String)>,
}

impl Checked {
    /// Refuted where a step violates the conclusion.
    pub fn outcome(&self) -> Outcome {
        if self.first_violation.is_some() { Outcome::Refuted } else { Outcome::Holds }
    }

    /// How many steps meet the theorem's premise.
    pub fn met(&self) -> usize {
        self.verdicts.values().filter(|v| **v == Verdict::Holds).count()
    }
}

/// Checks the theorems at every protocol step from 0 to `last`.
///
/// # Errors
/// The protocol is not coverage, or the start is not in a theorem's set of starts.
pub fn check(
    scenario: &Scenario,
    theorems: &[Theorem],
    form: Form,
    last: u64,
) -> Result<Vec<Checked>> {
    let Some(setting) = scenario.setting() else {
        return Err(Error::input(format!(
            "check: expected protocol `coverage`, which the theorems are about, found `{}`",
            scenario.protocol.name()
        )));
    };
    let mut checks = Vec::new();
    for &theorem in theorems {
        require_start(theorem, form, &setting, &scenario.start)?;
        let weights = theorem.hypothesis(form).weights;
        let in_range = weights.contains(&setting.eps_num, &setting.eps_den, scenario.count());
        checks.push(Checked {
            theorem,
            form,
            weight_in_range: in_range.is_true(),
            verdicts: BTreeMap::new(),
            first_violation: None,
        });
    }
    let span = |t: Theorem| t.span(form, scenario.count());
    let longest = theorems.iter().map(|&t| span(t)).max().unwrap_or(0);
    let mut window: VecDeque<Vec<Rational>> = VecDeque::new();
    let mut step = 0;
    for placement in placements(scenario) {
        window.push_back(placement);
        if window.len() <= longest {
            continue;
        }
        let run = window.make_contiguous();
        for c in &mut checks {
            let verdict = c.theorem.conclusion(form, &setting, run);
            if let (Verdict::Violated(v), None) = (verdict, &c.first_violation) {
                let ends = [&setting.min, &setting.max];
                c.first_violation = Some((step, violation::in_words(ends, run, step, v)));
            }
            c.verdicts.insert(step, verdict);
        }
        window.pop_front();
        if step == last {
            break;
        }
        step += 1;
    }
    Ok(checks)
}

/// Of the theorems, those that are about the scenario's start; and what the others are about.
///
/// # Errors
/// The protocol is not coverage.
pub fn applicable(
    scenario: &Scenario,
    theorems: &[Theorem],
    form: Form,
) -> Result<(Vec<Theorem>, Vec<(Theorem, &'static str)>)> {
    let Some(setting) = scenario.setting() else {
        return Ok((theorems.to_vec(), Vec::new()));
    };
    let starts = |t: &Theorem| t.hypothesis(form).starts;
    let (about, other): (Vec<Theorem>, Vec<Theorem>) =
        theorems.iter().partition(|t| starts(t).contains(&setting, &scenario.start).is_true());
    let other = other.into_iter().map(|t| (t, theorems::starts(starts(&t)))).collect();
    Ok((about, other))
}

/// X^0, X^1, ...: the placements without the ticks between.
fn placements(scenario: &Scenario) -> impl Iterator<Item = Vec<Rational>> {
    let mut last = None;
    simulate::run(scenario).filter_map(move |s| {
        let new = last != Some(s.step);
        last = Some(s.step);
        let State { drones, .. } = s.state;
        new.then_some(drones)
    })
}

fn require_start(
    theorem: Theorem,
    form: Form,
    setting: &Setting<Rational>,
    start: &[Rational],
) -> Result<()> {
    let starts = theorem.hypothesis(form).starts;
    if starts.contains(setting, start) == Truth::True {
        return Ok(());
    }
    let shown: Vec<_> = start.iter().take(12).map(ToString::to_string).collect();
    let dots = if start.len() > 12 { ", ..." } else { "" };
    Err(Error::input(format!(
        "start: `{}{dots}`: theorem {} in its {} form is about starts with {}",
        shown.join(", "),
        theorem.number(),
        form.label(),
        theorems::starts(starts)
    )))
}
