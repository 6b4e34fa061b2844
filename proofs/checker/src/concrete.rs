//! Certificates about one N and one weight, and about one run.

use std::collections::BTreeMap;

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::coverage::{exec_coverage, getx};
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::{Form, Setting, Subject, Theorem, Truth, Verdict, Violation};
use cordon_spec::{Params, State};
use num_traits::{Signed, Zero};

use crate::format::{
    ContractionCert, GrowthCert, HalfSpace, InvarianceCert, Number, RefutationCert, SubjectName,
};
use crate::poly::{Poly, Rational, Var};
use crate::rules::Fault;

/// Most drones of a contraction or growth vector: the file has room for no more.
const MAX_DRONES: u32 = 10_000;

/// Most work of a vector: drones * (digits of eps and of the longest entry)^2. About 3 seconds; allows N =
/// 1,000 with numbers of 1,000 digits.
const MAX_VECTOR_WORK: u64 = 1_000_000_000;

/// Most drones, and most steps, of a refutation.
const MAX_RUN: usize = 1_000;

/// Most work of a refutation: steps * drones * (steps * longest number)^2, since a step adds
/// the digits of eps to each position and products cost the square. About 10 seconds.
const MAX_WORK: u64 = 300_000_000_000;

/// Most variables and half-spaces of an invariance certificate: checking is cubic. Its work is
/// also bounded by [`MAX_WORK`], as products * (longest number * summands)^2.
const MAX_INVARIANCE: (usize, usize) = (100, 200);

/// The nonzero entries of A, row by row for drones 1 .. N-2.
pub type Rows = Vec<BTreeMap<usize, Rational>>;

/// The linear part A of the spec's step on the inner drones' positions, hence of their errors.
///
/// The targets are a fixed point: x' = A x + b with T = A T + b gives T - x' = A (T - x). That
/// is checked here too.
fn errors(
    rule: &'static str,
    drones: u32,
    numbers: [&Number; 2],
    vector: &[Number],
) -> Result<Rows, Fault> {
    let fault = |reason: String| Fault { rule, reason };
    if !(3..=MAX_DRONES).contains(&drones) {
        return Err(fault(format!("{drones} drones: expected 3 to {MAX_DRONES}")));
    }
    let [eps, _] = numbers;
    let digits = vector.iter().chain(numbers).map(Number::size).fold(1, u64::max);
    if u64::from(drones).saturating_mul(digits * digits) > MAX_VECTOR_WORK {
        return Err(fault("the numbers are too long for so many drones".into()));
    }
    let count = drones as usize;
    let last = Poly::from(count - 1);
    let params = Params {
        min: Poly::default(),
        max: last.clone(),
        eps: Poly::constant(eps.0.clone()),
        n: 0,
    };
    let step = |drones: Vec<Poly>| exec_coverage(&params, &State { drones, timesteps: 0 }).drones;
    let targets: Vec<Poly> = (0..count).map(Poly::from).collect();
    if step(targets.clone()) != targets {
        return Err(fault("the targets are not a fixed point".into()));
    }
    let mut symbols: Vec<Poly> = (0..drones as i32).map(|i| Poly::var(Var::At("x", i))).collect();
    symbols[0] = Poly::default();
    symbols[count - 1] = last;
    let mut rows = Rows::new();
    for position in step(symbols).get(1..count - 1).unwrap_or_default() {
        let mut row = BTreeMap::new();
        for (monomial, c) in position.terms() {
            match monomial.as_slice() {
                [] => {}
                [Var::At(_, j)] => {
                    row.insert(*j as usize - 1, c.clone());
                }
                _ => return Err(fault("the step is not linear".into())),
            }
        }
        rows.push(row);
    }
    Ok(rows)
}

/// Whether w has an entry an inner drone, each above zero.
fn positive_vector(rule: &'static str, vector: &[Number], count: usize) -> Result<(), Fault> {
    let fault = |reason: String| Err(Fault { rule, reason });
    if vector.len() != count {
        return fault(format!("vector of {} entries: expected {count}", vector.len()));
    }
    match vector.iter().position(|w| !w.0.is_positive()) {
        Some(i) => fault(format!("entry {i} of the vector is not above 0")),
        None => Ok(()),
    }
}

/// Row i of |A| w.
fn absolute(row: &BTreeMap<usize, Rational>, w: &[Number]) -> Rational {
    row.iter().filter_map(|(&j, a)| Some(a.abs() * &w.get(j)?.0)).sum()
}

/// `contraction`: w > 0 and |A| w <= rate * w with 0 <= rate < 1. So max_i |e_i|/w_i falls by
/// that rate in every step, from every start.
pub fn contraction(cert: &ContractionCert) -> Result<String, Fault> {
    const RULE: &str = "contraction";
    let fault = |reason: String| Fault { rule: RULE, reason };
    let (rate, w) = (&cert.rate.0, &cert.vector);
    let rows = errors(RULE, cert.drones, [&cert.eps, &cert.rate], &cert.vector)?;
    positive_vector(RULE, w, rows.len())?;
    if rate.is_negative() || *rate >= Rational::from_integer(1.into()) {
        return Err(fault("the rate is not in [0, 1)".into()));
    }
    for (i, row) in rows.iter().enumerate() {
        if absolute(row, w) > rate * &w[i].0 {
            return Err(fault(format!("drone {}: |A| w exceeds rate * w", i + 1)));
        }
    }
    Ok(format!(
        "7.8 for N = {}, eps = {}: from every start all drones converge to their targets",
        cert.drones, cert.eps.0
    ))
}

/// `growth`: w > 0 and |A| w >= w, and with s_i = 1 or s_i = (-1)^i no s_i s_j a_ij has another
/// sign than the rest. So from errors s_i w_i no cancellation occurs and |e_i^k| >= w_i for every k.
pub fn growth(cert: &GrowthCert) -> Result<String, Fault> {
    const RULE: &str = "growth";
    let fault = |reason: String| Fault { rule: RULE, reason };
    let (rows, w) = (errors(RULE, cert.drones, [&cert.eps; 2], &cert.vector)?, &cert.vector);
    positive_vector(RULE, w, rows.len())?;
    for (i, row) in rows.iter().enumerate() {
        if absolute(row, w) < w[i].0 {
            return Err(fault(format!("drone {}: |A| w is below w", i + 1)));
        }
    }
    if !one_sign(&rows, false) && !one_sign(&rows, true) {
        return Err(fault("the signs of A allow cancellation".into()));
    }
    Ok(format!(
        "7.8 fails for N = {}, eps = {}: from some start the drones do not converge",
        cert.drones, cert.eps.0
    ))
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

/// The theorem of that number.
pub fn theorem_named(number: &str) -> Option<Theorem> {
    Theorem::ALL.into_iter().find(|t| t.number() == number)
}

/// The form of that name.
pub fn form_named(name: &str) -> Option<Form> {
    Form::ALL.into_iter().find(|f| f.label() == name)
}

/// `refutation`: a run of the spec, on exact rationals, that meets the hypothesis and for which the
/// spec's own conclusion answers what is stated.
pub fn refutation(cert: &RefutationCert) -> Result<String, Fault> {
    let fault = |reason: String| Fault { rule: "refutation", reason };
    let theorem = theorem_named(&cert.theorem)
        .ok_or_else(|| fault(format!("no theorem `{}`", cert.theorem)))?;
    let form = form_named(&cert.form).ok_or_else(|| fault(format!("no form `{}`", cert.form)))?;
    // Their finite conclusions say what the theorem says of full steps without delay only: the
    // energy stands for the limit, and a span of steps for all later ones, of one linear map.
    let finite = [Theorem::Limit, Theorem::ConstantSum, Theorem::GloballyIncreasing];
    if (cert.activation.is_some() || cert.delay.is_some()) && finite.contains(&theorem) {
        let number = &cert.theorem;
        return Err(fault(format!("a run of other steps decides nothing about {number}")));
    }
    let (count, step) = (cert.start.len(), cert.step as usize);
    if !(3..=MAX_RUN).contains(&count) || step > MAX_RUN {
        return Err(fault(format!("expected 3 to {MAX_RUN} drones and at most {MAX_RUN} steps")));
    }
    let steps = step + theorem.span(form, count);
    let numbers = cert.start.iter().chain([&cert.min, &cert.max, &cert.eps]);
    let mut digits = numbers.map(Number::size).sum::<u64>().saturating_mul(steps as u64 + 1);
    if theorem == Theorem::Limit {
        // The minors that decide on the weight grow by the digits of eps, drone by drone.
        digits = digits.saturating_add(cert.eps.size().saturating_mul(count as u64));
    }
    if digits.saturating_mul(digits).saturating_mul((count * (steps + 1)) as u64) > MAX_WORK {
        return Err(fault("the run is too long for its numbers".into()));
    }
    if cert.min.0 >= cert.max.0 {
        return Err(fault("min is not below max".into()));
    }
    let params =
        Params { min: cert.min.0.clone(), max: cert.max.0.clone(), eps: cert.eps.0.clone(), n: 0 };
    let setting = Setting::from(&params);
    let start: Vec<Rational> = cert.start.iter().map(|x| x.0.clone()).collect();
    let hypothesis = theorem.hypothesis(form);
    let met = if cert.weights.is_some() {
        hypothesis.starts.contains(&setting, &start)
    } else {
        hypothesis.met_by(&setting, &start)
    };
    if met != Truth::True {
        return Err(fault("the hypothesis is not met".into()));
    }
    let run = run(cert, &params, start, steps).map_err(fault)?;
    let subject = match cert.violation.subject {
        SubjectName::Pair(i) => Subject::Pair(i),
        SubjectName::Drone(i) => Subject::Drone(i),
        SubjectName::Sum => Subject::Sum,
        SubjectName::Energy => Subject::Energy,
    };
    let stated = Verdict::Violated(Violation { step: cert.violation.step, subject });
    let found = theorem.conclusion(form, &setting, run.get(step..).unwrap_or_default());
    if found != stated {
        return Err(fault("the conclusion does not answer the stated violation".into()));
    }
    let exempt = if cert.weights.is_some() { ", any weight" } else { "" };
    let how = match (&cert.activation, &cert.delay) {
        (Some(_), _) => ", with drones skipping steps",
        (_, Some(_)) => ", with delayed messages",
        _ => "",
    };
    Ok(format!(
        "{} ({}{exempt}{how}) is false: N = {count}, eps = {}, step {}",
        cert.theorem,
        cert.form,
        cert.eps.0,
        step + cert.violation.step
    ))
}

/// X^0 .. X^steps.
fn run(
    cert: &RefutationCert,
    params: &Params<Rational>,
    start: Vec<Rational>,
    steps: usize,
) -> Result<Vec<Vec<Rational>>, String> {
    let count = start.len();
    let schedule = |len: usize| match len == steps {
        true => Ok(()),
        false => Err(format!("a schedule of {len} steps: expected {steps}")),
    };
    let mut run = vec![start];
    match (&cert.activation, &cert.delay) {
        (None, None) => {}
        (Some(active), None) => schedule(active.len())?,
        (None, Some(delays)) => schedule(delays.len())?,
        (Some(_), Some(_)) => return Err("both `activation` and `delay`".into()),
    }
    for t in 0..steps {
        let state = State { drones: run[t].clone(), timesteps: 0 };
        let next = if let Some(active) = &cert.activation {
            if !active[t].is_sorted_by(|a, b| a < b) || active[t].iter().any(|&i| i >= count) {
                return Err(format!("step {t}: expected ascending drones below {count}"));
            }
            exec_coverage_active(params, &state, |i| active[t].binary_search(&i).is_ok())
        } else if let Some(delays) = &cert.delay {
            let pair = |d: &(usize, usize, usize)| (d.0, d.1);
            let sound = |&(i, j, age): &(usize, usize, usize)| {
                i < count && j < count && (1..=t).contains(&age)
            };
            if !delays[t].is_sorted_by(|a, b| pair(a) < pair(b)) || !delays[t].iter().all(sound) {
                return Err(format!("step {t}: expected ascending [i, j, age], 1 <= age <= {t}"));
            }
            exec_coverage_delayed(params, &state, |i, j| {
                match delays[t].binary_search_by_key(&(i, j), pair) {
                    Ok(at) => &run[t - delays[t][at].2][j],
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

/// `invariance`: Farkas' lemma, row by row. For x in the invariant, `normal_j . x' - bound_j` is the
/// sum of m_r (normal_r . x - bound_r) >= 0 and of the constant that is left.
pub fn invariance(cert: &InvarianceCert) -> Result<String, Fault> {
    let fault = |reason: String| Fault { rule: "invariance", reason };
    let (rows, variables) = (&cert.invariant, cert.offset.len());
    let square = cert.matrix.len() == variables && cert.matrix.iter().all(|r| r.len() == variables);
    let fits = rows.iter().all(|h| h.normal.len() == variables)
        && cert.multipliers.len() == rows.len()
        && cert.multipliers.iter().all(|m| m.len() == rows.len());
    let (most_variables, most_rows) = MAX_INVARIANCE;
    if !square
        || !fits
        || variables == 0
        || variables > most_variables
        || rows.is_empty()
        || rows.len() > most_rows
    {
        return Err(fault("the sizes do not fit".into()));
    }
    let numbers = cert.matrix.iter().chain(&cert.multipliers).flatten();
    let digits = numbers.chain(rows.iter().flat_map(|h| &h.normal)).map(Number::size).max();
    let dense = |m: &[Vec<Number>]| {
        m.iter().map(|r| r.iter().filter(|x| !x.0.is_zero()).count()).max().unwrap_or(0) as u64
    };
    let summands = dense(&cert.multipliers) + variables as u64;
    let length = digits.unwrap_or(1).saturating_mul(summands);
    let products = (rows.len() * variables) as u64 * summands;
    if products.saturating_mul(length.saturating_mul(length)) > MAX_WORK {
        return Err(fault("the numbers are too long for its size".into()));
    }
    let dot = |a: &mut dyn Iterator<Item = (&Number, &Number)>| -> Rational {
        a.filter(|(x, y)| !x.0.is_zero() && !y.0.is_zero()).map(|(x, y)| &x.0 * &y.0).sum()
    };
    for (j, (goal, m)) in rows.iter().zip(&cert.multipliers).enumerate() {
        let bad = |why: &str| Err(fault(format!("row {j}: {why}")));
        if m.iter().any(|m| m.0.is_negative()) {
            return bad("a multiplier is negative");
        }
        for v in 0..variables {
            let combined = dot(&mut m.iter().zip(rows.iter().map(|h| &h.normal[v])));
            let moved = dot(&mut goal.normal.iter().zip(cert.matrix.iter().map(|r| &r[v])));
            if combined != moved {
                return bad("the multipliers do not give the row's image");
            }
        }
        let bounds = dot(&mut m.iter().zip(rows.iter().map(|h| &h.bound)));
        let slack = bounds + dot(&mut goal.normal.iter().zip(&cert.offset)) - &goal.bound.0;
        let strict = |(m, h): (&Number, &HalfSpace)| h.strict && m.0.is_positive();
        if slack.is_negative() {
            return bad("the bound is not reached");
        }
        if goal.strict && slack.is_zero() && !m.iter().zip(rows).any(strict) {
            return bad("the bound is reached, but not strictly");
        }
    }
    Ok(format!("an invariant of {} half-spaces of a protocol in {variables} variables", rows.len()))
}
