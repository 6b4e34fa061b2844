//! Counterexamples: runs of the spec that violate a theorem, and runs of a user's system that violate a claim.

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::coverage::{exec_coverage, getx};
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::{Form, Setting, Subject, Theorem, Truth, Verdict, Violation};
use cordon_spec::{Params, State};

use crate::expr::{Literal, joined};
use crate::fault::{Result, Shown, ensure, fault};
use crate::format::{Counterexample, Delay, Named, Refutation};
use crate::linear::{System, Values, at};
use crate::number::{Number, charge, exhausted};
use crate::poly::Poly;

const RULE: &str = "refutation";

/// Most drones and most steps of a run of the spec.
const MAX_DRONES: usize = 10_000;

/// `counterexample`: a run of a linear system, from a start that meets what is assumed to a state in which what is
/// claimed fails. A parameter has one value in the whole run, or one in each step.
pub fn counterexample(c: &Counterexample) -> Result<Shown> {
    const RULE: &str = "counterexample";
    let (system, ranges) = (System::read(&c.system)?, &c.system.parameters.0);
    let assumed = c.assumptions.iter().map(|l| system.literal(l)).collect::<Result<Vec<_>>>()?;
    let claim = system.literal(&c.claim)?;
    let (found, expected) = (c.start.len(), c.system.state.len());
    ensure!(found == expected, RULE, "a start of {found} numbers: expected {expected}");
    let named = || c.system.state.iter().map(String::as_str).zip(&c.start);
    let mut state: Values<'_> = named().map(|(v, x)| (v, Poly::constant(x.clone()))).collect();
    let holds = |l: &Literal, state: &Values<'_>| l.map(|p| at(p, state)).decided() == Some(true);
    for literal in &assumed {
        ensure!(holds(literal, &state), RULE, "the start does not meet {literal}");
    }
    let values = |given| -> Result<Values<'_>> {
        let Named(given): &Named<Number> = given;
        for (name, value) in given {
            let within = ranges.get(name).is_some_and(|[low, high]| low <= value && value <= high);
            ensure!(
                within,
                RULE,
                "`{name:.40}` = {value:.40} is out of its range, or no parameter"
            );
        }
        Ok(given.iter().map(|(n, v)| (n.as_str(), Poly::constant(v.clone()))).collect())
    };
    let constant = values(&c.with)?;
    for (k, step) in c.steps.iter().enumerate().take_while(|_| !exhausted()) {
        let chosen = values(&step.with)?;
        let once = chosen.keys().all(|name| !constant.contains_key(name));
        let each = once && chosen.len() + constant.len() == ranges.len();
        ensure!(each, RULE, "step {k}: each parameter needs one value");
        let rows = system.rows(&step.by)?;
        charge(128 * rows.len() as u64);
        let value = |v: &str| [&state, &chosen, &constant].into_iter().find_map(|all| all.get(v));
        let after: Vec<_> =
            rows.iter().map(|(name, row)| (*name, row.with(&|v| value(v).cloned()))).collect();
        state.extend(after);
    }
    let step = c.steps.len();
    ensure!(!holds(&claim, &state), RULE, "at step {step} the claim holds");
    let start = joined(named().map(|(v, x)| format!("{v} = {x}")), ", ");
    let words = system.words(["a linear system of", "in each step"], &c.with, &assumed);
    Ok((format!("{words}\n  refuted at step {step}: {claim}, by a run from {start}"), 1))
}

/// `refutation`: a run of the spec, on exact rationals, that meets the hypothesis and for which the
/// spec's own conclusion answers what is stated.
pub fn refutation(c: &Refutation) -> Result<Shown> {
    let theorem = Theorem::ALL.into_iter().find(|t| t.number() == c.theorem);
    let form = Form::ALL.into_iter().find(|f| f.label() == c.form);
    let (Some(theorem), Some(form)) = (theorem, form) else {
        return fault(RULE, "no such theorem or form");
    };
    let (count, step) = (c.start.len(), c.step as usize);
    // Their finite conclusions say what the theorem says of full steps without delay only: the energy
    // stands for the limit, and a span of steps for all later ones, of one linear map.
    let finite = [Theorem::Limit, Theorem::ConstantSum, Theorem::GloballyIncreasing];
    let full = c.activation.is_none() && c.delay.is_none();
    let decides = full || !finite.contains(&theorem);
    ensure!(decides, RULE, "a run of other steps decides nothing about {}", c.theorem);
    let few = (3..=MAX_DRONES).contains(&count) && step <= MAX_DRONES;
    ensure!(few, RULE, "expected 3 to {MAX_DRONES} drones and at most {MAX_DRONES} steps");
    ensure!(c.min < c.max, RULE, "min is not below max");
    let params = Params { min: c.min.clone(), max: c.max.clone(), eps: c.eps.clone(), n: 0 };
    let setting = Setting::from(&params);
    let hypothesis = theorem.hypothesis(form);
    let met = match c.weights.as_deref() {
        None => hypothesis.met_by(&setting, &c.start),
        Some("any") => hypothesis.starts.contains(&setting, &c.start),
        Some(_) => return fault(RULE, "`weights`: expected `any`"),
    };
    ensure!(met == Truth::True, RULE, "the hypothesis is not met");
    let run = run(c, &params, step + theorem.span(form, count))?;
    let subject = match (c.violation.subject.as_str(), c.violation.at) {
        ("pair", Some(i)) => Subject::Pair(i),
        ("drone", Some(i)) => Subject::Drone(i),
        ("sum", None) => Subject::Sum,
        ("energy", None) => Subject::Energy,
        _ => return fault(RULE, "no such subject"),
    };
    let stated = Verdict::Violated(Violation { step: c.violation.step, subject });
    let answer = theorem.conclusion(form, &setting, run.get(step..).unwrap_or_default());
    ensure!(answer == stated, RULE, "the conclusion does not answer the stated violation");
    let exempt = if c.weights.is_some() { ", any weight" } else { "" };
    let how = match (&c.activation, &c.delay) {
        (Some(_), _) => ", with drones skipping steps",
        (_, Some(_)) => ", with delayed messages",
        _ => "",
    };
    let (eps, at) = (&c.eps, step + c.violation.step);
    let what = format!("{} ({}{exempt}{how})", c.theorem, c.form);
    Ok((format!("{what} is violated: N = {count}, eps = {eps}, step {at}"), 1))
}

/// X^0 .. X^steps.
fn run(c: &Refutation, params: &Params<Number>, steps: usize) -> Result<Vec<Vec<Number>>> {
    let count = c.start.len();
    let lengths = [c.activation.as_ref().map(Vec::len), c.delay.as_ref().map(Vec::len)];
    let fits = lengths.iter().flatten().all(|l| *l == steps) && lengths.contains(&None);
    ensure!(fits, RULE, "expected one schedule at most, of {steps} steps");
    let mut run = vec![c.start.clone()];
    for t in 0..steps {
        if exhausted() {
            break;
        }
        let state = State { drones: run[t].clone(), timesteps: 0 };
        let next = if let Some(active) = &c.activation {
            let sound =
                active[t].is_sorted_by(|a, b| a < b) && active[t].iter().all(|i| *i < count);
            ensure!(sound, RULE, "step {t}: expected ascending drones below {count}");
            exec_coverage_active(params, &state, |i| active[t].binary_search(&i).is_ok())
        } else if let Some(delays) = &c.delay {
            let pair = |d: &Delay| (d.drone, d.sees);
            let sound = |d: &Delay| d.drone < count && d.sees < count && (1..=t).contains(&d.age);
            let all =
                delays[t].is_sorted_by(|a, b| pair(a) < pair(b)) && delays[t].iter().all(sound);
            ensure!(all, RULE, "step {t}: expected ascending pairs, 1 <= age <= {t}");
            exec_coverage_delayed(params, &state, |i, j| {
                match delays[t].binary_search_by_key(&(i, j), pair) {
                    Ok(at) => &run[t - delays[t][at].age][j],
                    Err(_) => getx(&state, j),
                }
            })
        } else {
            exec_coverage(params, &state)
        };
        run.push(next.drones);
    }
    Ok(run)
}
