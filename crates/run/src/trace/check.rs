//! Checking theorems along a run.

use std::collections::BTreeMap;

use cordon_core::theorems;
use cordon_spec::theorems::{Form, Setting, Theorem, Truth, Verdict};
use num_bigint::BigInt;

use crate::fast::{Line, Motion, step};
use crate::scenario::Scenario;
use cordon_core::exact::Rational;
use cordon_core::{Error, Outcome, Result, progress, violation};

/// The result of checking one theorem along one run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checked {
    /// The theorem that was checked.
    pub theorem: Theorem,
    /// The form whose hypothesis and conclusion were used.
    pub form: Form,
    /// Whether the weight is in the theorem's range. A violation outside it does not refute the
    /// theorem; it shows why the range is needed.
    pub weight_in_range: bool,
    /// The verdict at every step from 0 to the last.
    pub verdicts: BTreeMap<u64, Verdict>,
    /// The first violation: its step, and what fails there in words with exact values.
    pub first_violation: Option<(u64, String)>,
}

impl Checked {
    /// Refuted where a step violates the conclusion.
    pub fn outcome(&self) -> Outcome {
        if self.first_violation.is_some() { Outcome::Refuted } else { Outcome::Holds }
    }

    /// The number of steps that meet the theorem's premise.
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
    let line = Motion::of(scenario, last)?.into_line("check")?;
    let mut window = Window::new(line, last.saturating_add(longest as u64));
    progress::expect(last.saturating_add(1));
    for step in 0..=last {
        progress::advance(1);
        window.extend_to(step, longest);
        let (integers, run) = window.scaled(&setting);
        for c in &mut checks {
            let verdict = c.theorem.conclusion(form, &integers, run);
            if let (Verdict::Violated(v), None) = (verdict, &c.first_violation) {
                let ends = [&setting.min, &setting.max];
                let run = window.placements();
                c.first_violation = Some((step, violation::in_words(ends, &run, step, v)));
            }
            c.verdicts.insert(step, verdict);
        }
    }
    Ok(checks)
}

/// Consecutive placements, as integers over one denominator: conclusions are homogeneous, so that they
/// can be evaluated on the numerators.
struct Window {
    run: step::Run,
    /// D Q^t, with t the last step.
    denominator: BigInt,
    den: BigInt,
    numerators: Vec<Vec<BigInt>>,
    next: u64,
}

impl Window {
    /// An empty window on the run of a line up to step `last`.
    fn new(line: Line, last: u64) -> Self {
        let (denominator, den) = (line.base.clone(), line.den.clone());
        let run = step::Run::new(line, last);
        Self { run, denominator, den, numerators: Vec::new(), next: 0 }
    }

    /// Advances to the placements `step ..= step + span`.
    fn extend_to(&mut self, step: u64, span: usize) {
        while self.next <= step + span as u64 {
            if self.numerators.len() > span {
                self.numerators.remove(0);
            }
            if self.next > 0 {
                self.denominator *= &self.den;
                self.numerators.iter_mut().flatten().for_each(|x| *x *= &self.den);
            }
            self.numerators.push(self.run.advance_to(self.next).answer().numerators);
            self.next += 1;
        }
    }

    /// The setting and the placements over the common denominator.
    fn scaled(&self, setting: &Setting<Rational>) -> (Setting<BigInt>, &[Vec<BigInt>]) {
        // D is a multiple of the denominators of the ends, where the end drones start.
        let whole = |x: &Rational| x.numer() * (&self.denominator / x.denom());
        let integers = Setting {
            min: whole(&setting.min),
            max: whole(&setting.max),
            eps_num: setting.eps_num.to_integer(),
            eps_den: setting.eps_den.to_integer(),
        };
        (integers, &self.numerators)
    }

    /// The placements in lowest terms.
    fn placements(&self) -> Vec<Vec<Rational>> {
        let lowest = |x: &BigInt| Rational::new(x.clone(), self.denominator.clone());
        self.numerators.iter().map(|x| x.iter().map(lowest).collect()).collect()
    }
}

/// A theorem about other starts, and a description of these.
pub type Foreign = (Theorem, &'static str);

/// The theorems that apply to the scenario's start; and the others, with their starts.
///
/// # Errors
/// The protocol is not coverage.
pub fn applicable(
    scenario: &Scenario,
    theorems: &[Theorem],
    form: Form,
) -> Result<(Vec<Theorem>, Vec<Foreign>)> {
    let Some(setting) = scenario.setting() else {
        return Ok((theorems.to_vec(), Vec::new()));
    };
    let starts = |t: &Theorem| t.hypothesis(form).starts;
    let (about, other): (Vec<Theorem>, Vec<Theorem>) =
        theorems.iter().partition(|t| starts(t).contains(&setting, &scenario.start).is_true());
    let other = other.into_iter().map(|t| (t, theorems::starts(starts(&t)))).collect();
    Ok((about, other))
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
