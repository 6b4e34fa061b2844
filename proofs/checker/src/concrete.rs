//! Certificates about one N and one weight, and about one run.

use std::collections::BTreeMap;

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::coverage::{exec_coverage, getx};
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::{Setting, Subject, Theorem, Truth, Verdict, Violation};
use cordon_spec::{Params, Scalar, State};

use crate::fault::{Result, fault};
use crate::format::{Contraction, Delay, Growth, Refutation};
use crate::number::{Number, exhausted};
use crate::poly::{Atom, Poly};
use crate::system::{Step, named};

/// Most drones of a vector, most drones and steps of a run.
const MAX_DRONES: usize = 10_000;

/// The nonzero entries of A, row by row for drones 1 .. N-2.
pub type Rows = Vec<BTreeMap<usize, Number>>;

/// The linear part A of the spec's step on the inner drones' positions, hence of their errors: the targets are
/// a fixed point, x' = A x + b with T = A T + b gives T - x' = A (T - x). That is checked here too.
/// The vector has an entry an inner drone, each above 0.
fn errors(
    rule: &'static str,
    drones: u32,
    eps: &Number,
    vector: &[Number],
    exec: Step,
) -> Result<Rows> {
    let count = drones as usize;
    if !(3..=MAX_DRONES).contains(&count) {
        return fault(rule, format!("{drones} drones: expected 3 to {MAX_DRONES}"));
    }
    if vector.len() != count - 2 {
        return fault(rule, format!("vector of {} entries: expected {}", vector.len(), count - 2));
    }
    if let Some(i) = vector.iter().position(|w| !w.is_positive()) {
        return fault(rule, format!("entry {i} of the vector is not above 0"));
    }
    let last = Poly::from_index(count - 1);
    let params =
        Params { min: Poly::default(), max: last.clone(), eps: Poly::constant(eps.clone()), n: 0 };
    let step = |drones: Vec<Poly>| exec(&params, &State { drones, timesteps: 0 }).drones;
    let targets: Vec<Poly> = (0..count).map(Poly::from_index).collect();
    if step(targets.clone()) != targets {
        return fault(rule, "the targets are not a fixed point");
    }
    let name = |i: usize| Atom::App("x".into(), vec![Poly::from_index(i)]);
    let mut symbols: Vec<Poly> = (0..count).map(|i| Poly::atom(name(i))).collect();
    (symbols[0], symbols[count - 1]) = (Poly::default(), last);
    let mut rows = Rows::new();
    for (i, position) in step(symbols).iter().enumerate().take(count - 1).skip(1) {
        let mut row = BTreeMap::new();
        for (monomial, c) in position.terms() {
            let j =
                [i.saturating_sub(1), i, i + 1].into_iter().find(|&j| monomial[..] == [name(j)]);
            match j {
                Some(j) => _ = row.insert(j - 1, c.clone()),
                None if monomial.is_empty() => {}
                None => return fault(rule, "the step is not linear in the neighbours"),
            }
        }
        rows.push(row);
    }
    Ok(rows)
}

/// Row i of |A| w.
fn absolute(row: &BTreeMap<usize, Number>, w: &[Number]) -> Number {
    let products = row.iter().filter_map(|(&j, a)| Some(a.magnitude() * w.get(j)?));
    products.fold(Number::whole(0), |sum, p| sum + &p)
}

/// `contraction`: w > 0 and |A| w <= rate * w with 0 <= rate < 1. So max_i |e_i|/w_i falls by
/// that rate in every step, from every start.
pub fn contraction(c: &Contraction, step: Step) -> Result<String> {
    const RULE: &str = "contraction";
    let rows = errors(RULE, c.drones, &c.eps, &c.vector, step)?;
    if !(Number::whole(0)..Number::whole(1)).contains(&c.rate) {
        return fault(RULE, "the rate is not in [0, 1)");
    }
    for (i, row) in rows.iter().enumerate() {
        if absolute(row, &c.vector) > c.rate.clone() * &c.vector[i] {
            return fault(RULE, format!("drone {}: |A| w exceeds rate * w", i + 1));
        }
    }
    Ok(format!(
        "N = {}, eps = {}: from every start all drones converge to their targets",
        c.drones, c.eps
    ))
}

/// `growth`: w > 0 and |A| w >= w, and with s_i = 1 or s_i = (-1)^i no s_i s_j a_ij has another
/// sign than the rest. So from errors s_i w_i no cancellation occurs and |e_i^k| >= w_i for every k.
pub fn growth(c: &Growth, step: Step) -> Result<String> {
    const RULE: &str = "growth";
    let rows = errors(RULE, c.drones, &c.eps, &c.vector, step)?;
    for (i, row) in rows.iter().enumerate() {
        if absolute(row, &c.vector) < c.vector[i] {
            return fault(RULE, format!("drone {}: |A| w is below w", i + 1));
        }
    }
    if !one_sign(&rows, false) && !one_sign(&rows, true) {
        return fault(RULE, "the signs of A allow cancellation");
    }
    Ok(format!("N = {}, eps = {}: from some start the drones do not converge", c.drones, c.eps))
}

/// Whether all s_i s_j a_ij have one sign, s_i being (-1)^i or 1. True of every weight here; it
/// would not be of another protocol.
pub fn one_sign(rows: &Rows, alternating: bool) -> bool {
    let mut signs = rows.iter().enumerate().flat_map(|(i, row)| {
        row.iter().map(move |(j, a)| a.is_positive() == (alternating && (i + j) % 2 == 1))
    });
    let first = signs.next();
    signs.all(|s| Some(s) == first)
}

/// `refutation`: a run of the spec, on exact rationals, that meets the hypothesis and for which the
/// spec's own conclusion answers what is stated.
pub fn refutation(c: &Refutation) -> Result<String> {
    const RULE: &str = "refutation";
    let (theorem, form) = named(&c.theorem, &c.form)?;
    let (count, step) = (c.start.len(), c.step as usize);
    // Their finite conclusions say what the theorem says of full steps without delay only: the energy
    // stands for the limit, and a span of steps for all later ones, of one linear map.
    let finite = [Theorem::Limit, Theorem::ConstantSum, Theorem::GloballyIncreasing];
    if (c.activation.is_some() || c.delay.is_some()) && finite.contains(&theorem) {
        return fault(RULE, format!("a run of other steps decides nothing about {}", c.theorem));
    }
    if !(3..=MAX_DRONES).contains(&count) || step > MAX_DRONES {
        return fault(
            RULE,
            format!("expected 3 to {MAX_DRONES} drones and at most {MAX_DRONES} steps"),
        );
    }
    if c.min >= c.max {
        return fault(RULE, "min is not below max");
    }
    let params = Params { min: c.min.clone(), max: c.max.clone(), eps: c.eps.clone(), n: 0 };
    let setting = Setting::from(&params);
    let hypothesis = theorem.hypothesis(form);
    let met = match c.weights.as_deref() {
        None => hypothesis.met_by(&setting, &c.start),
        Some("any") => hypothesis.starts.contains(&setting, &c.start),
        Some(_) => return fault(RULE, "`weights`: expected `any`"),
    };
    if met != Truth::True {
        return fault(RULE, "the hypothesis is not met");
    }
    let run = run(c, &params, step + theorem.span(form, count))?;
    let subject = match (c.violation.subject.as_str(), c.violation.at) {
        ("pair", Some(i)) => Subject::Pair(i),
        ("drone", Some(i)) => Subject::Drone(i),
        ("sum", None) => Subject::Sum,
        ("energy", None) => Subject::Energy,
        _ => return fault(RULE, "no such subject"),
    };
    let stated = Verdict::Violated(Violation { step: c.violation.step, subject });
    if theorem.conclusion(form, &setting, run.get(step..).unwrap_or_default()) != stated {
        return fault(RULE, "the conclusion does not answer the stated violation");
    }
    let exempt = if c.weights.is_some() { ", any weight" } else { "" };
    let how = match (&c.activation, &c.delay) {
        (Some(_), _) => ", with drones skipping steps",
        (_, Some(_)) => ", with delayed messages",
        _ => "",
    };
    let (eps, at) = (&c.eps, step + c.violation.step);
    Ok(format!(
        "{} ({}{exempt}{how}) is false: N = {count}, eps = {eps}, step {at}",
        c.theorem, c.form
    ))
}

/// X^0 .. X^steps.
fn run(c: &Refutation, params: &Params<Number>, steps: usize) -> Result<Vec<Vec<Number>>> {
    const RULE: &str = "refutation";
    let count = c.start.len();
    let lengths = [c.activation.as_ref().map(Vec::len), c.delay.as_ref().map(Vec::len)];
    if lengths.iter().flatten().any(|l| *l != steps) || lengths.iter().all(Option::is_some) {
        return fault(RULE, format!("expected one schedule at most, of {steps} steps"));
    }
    let mut run = vec![c.start.clone()];
    for t in 0..steps {
        if exhausted() {
            break;
        }
        let state = State { drones: run[t].clone(), timesteps: 0 };
        let next = if let Some(active) = &c.activation {
            if !active[t].is_sorted_by(|a, b| a < b) || active[t].iter().any(|&i| i >= count) {
                return fault(RULE, format!("step {t}: expected ascending drones below {count}"));
            }
            exec_coverage_active(params, &state, |i| active[t].binary_search(&i).is_ok())
        } else if let Some(delays) = &c.delay {
            let pair = |d: &Delay| (d.drone, d.sees);
            let sound = |d: &Delay| d.drone < count && d.sees < count && (1..=t).contains(&d.age);
            if !delays[t].is_sorted_by(|a, b| pair(a) < pair(b)) || !delays[t].iter().all(sound) {
                return fault(RULE, format!("step {t}: expected ascending pairs, 1 <= age <= {t}"));
            }
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
