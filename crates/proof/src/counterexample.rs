//! A concrete run that violates a theorem, established by the spec alone.

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::coverage::{exec_coverage, getx};
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::{Form, Setting, Theorem, Truth, Verdict, Violation};
use cordon_spec::{Params, State};
use serde_json::{Value, json};

use crate::certificate::Departure;
use cordon_core::exact::fraction;
use cordon_core::{Rational, violation};

/// A start in a theorem's start set whose run violates the conclusion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counterexample {
    /// The theorem that is violated.
    pub theorem: Theorem,
    /// Which form of it.
    pub form: Form,
    /// The weight eps of the run, in the theorem's range or not.
    pub eps: Rational,
    /// The step k about which the conclusion fails.
    pub step: usize,
    /// What fails, its step counted from k.
    pub violation: Violation,
    /// The placements X^0, X^1, ... up to the last one that the conclusion reads.
    pub run: Vec<Vec<Rational>>,
    /// In what the steps differ from the protocol as written.
    pub departure: Departure,
}

impl Counterexample {
    /// Runs the spec from `start` and asks it whether the start is in the theorem's start set
    /// and the conclusion about step `step` is violated. `None` where it is not so.
    pub fn replay(
        theorem: Theorem,
        form: Form,
        eps: &Rational,
        start: Vec<Rational>,
        step: usize,
    ) -> Option<Self> {
        Self::replay_departing(theorem, form, eps, start, step, Departure::None)
    }

    /// [`replay`](Self::replay) with steps in which drones skip their update or see stale
    /// positions: one list a step, as many as steps are made.
    pub fn replay_departing(
        theorem: Theorem,
        form: Form,
        eps: &Rational,
        start: Vec<Rational>,
        step: usize,
        departure: Departure,
    ) -> Option<Self> {
        let params = Params {
            min: start.first()?.clone(),
            max: start.last()?.clone(),
            eps: eps.clone(),
            n: 0,
        };
        let setting = Setting::from(&params);
        if theorem.hypothesis(form).starts.contains(&setting, &start) != Truth::True {
            return None;
        }
        let last = step + theorem.span(form, start.len());
        let run = departing_run(&params, start, last, &departure)?;
        match theorem.conclusion(form, &setting, run.get(step..)?) {
            Verdict::Violated(violation) => {
                Some(Self { theorem, form, eps: eps.clone(), step, violation, run, departure })
            }
            _ => None,
        }
    }

    /// The placement X^0, one position a drone.
    pub fn start(&self) -> &[Rational] {
        self.run.first().map_or(&[], Vec::as_slice)
    }

    /// Whether the weight is one the theorem speaks about.
    pub fn weight_is_in_range(&self) -> bool {
        let one = Rational::from_integer(1.into());
        let weights = self.theorem.hypothesis(self.form).weights;
        let den = Rational::from_integer(self.eps.denom().clone());
        let num = &self.eps * &den;
        debug_assert!(den >= one);
        weights.contains(&num, &den, self.start().len()).is_true()
    }

    /// What fails, in words with exact values.
    pub fn what_fails(&self) -> String {
        let start = self.start();
        let (Some(min), Some(max)) = (start.first(), start.last()) else { return String::new() };
        let read = self.run.get(self.step..).unwrap_or_default();
        violation::in_words([min, max], read, self.step as u64, self.violation)
    }

    /// The command that replays it.
    pub fn replay_line(&self) -> String {
        let form = match self.form {
            Form::Paper => " --form paper",
            Form::Sharp => "",
        };
        format!(
            "cordon trace --drones {} --start {} --eps {} --steps {} --check {}{form}",
            self.start().len(),
            list(self.start()),
            fraction(&self.eps),
            self.run.len().saturating_sub(1),
            self.theorem.number(),
        )
    }

    /// The counterexample as outputs in JSON have it.
    pub fn to_json(&self) -> Value {
        json!({
            "theorem": self.theorem.number(),
            "form": self.form.label(),
            "drones": self.start().len(),
            "eps": fraction(&self.eps),
            "weight_in_range": self.weight_is_in_range(),
            "step": self.step,
            "fails": self.what_fails(),
            "run": self.run.iter().map(|x| x.iter().map(fraction).collect()).collect::<Vec<Vec<_>>>(),
            "replay": matches!(self.departure, Departure::None).then(|| self.replay_line()),
        })
    }
}

/// The placements X^0 .. X^last. `None` where the departure has no list for some step, or an
/// age that reaches back before the start.
fn departing_run(
    params: &Params<Rational>,
    start: Vec<Rational>,
    last: usize,
    departure: &Departure,
) -> Option<Vec<Vec<Rational>>> {
    let mut run = vec![start];
    for t in 0..last {
        let state = State { drones: run.get(t)?.clone(), timesteps: 0 };
        let next = match departure {
            Departure::None => exec_coverage(params, &state),
            Departure::Activation(steps) => {
                let active = steps.get(t)?;
                exec_coverage_active(params, &state, |i| active.contains(&i))
            }
            Departure::Delay(steps) => {
                let stale = steps.get(t)?;
                let possible = |&(_, j, age): &(usize, usize, usize)| {
                    j < state.drones.len() && (1..=t).contains(&age)
                };
                if !stale.iter().all(possible) {
                    return None;
                }
                let seen = |i: usize, j: usize| {
                    let age = stale.iter().find(|&&(a, b, _)| (a, b) == (i, j)).map(|s| s.2);
                    age.map_or_else(|| getx(&state, j), |age| &run[t - age][j])
                };
                exec_coverage_delayed(params, &state, seen)
            }
        };
        run.push(next.drones);
    }
    Some(run)
}

/// Positions as the command line takes them: fractions with commas between.
pub fn list(x: &[Rational]) -> String {
    x.iter().map(fraction).collect::<Vec<_>>().join(",")
}
