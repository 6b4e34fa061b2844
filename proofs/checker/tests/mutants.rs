//! Every number of every committed certificate is changed, in several ways; each mutant has to
//! be rejected unless it is a proof itself.
//!
//! A mutant is recognised as a proof without the checker's help:
//! * a sum in a proof by the kernel is an identity between polynomials, so that no change of a number in
//!   it leaves a proof;
//! * contraction, growth and invariance are decided by a formula written out here;
//! * a refutation is decided by running the protocol, written out here, and asking the
//!   theorem's predicates.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::fs;
use std::path::PathBuf;

use cordon_check::check;
use cordon_spec::theorems::{Form, Setting, Subject, Theorem, Truth, Verdict};
use num_rational::BigRational as Rational;
use num_traits::{One, Signed, Zero};
use serde_json::{Value, json};

/// Mutants that are no proofs, and mutants that are.
const REJECTED: usize = 467;
const PROOFS: usize = 73;

/// Mutants of sums.
const SUMS: usize = 274;

/// Paths to all numbers in a JSON page: integers, and strings that are exact numbers.
fn numbers(page: &Value, at: &str, found: &mut Vec<String>) {
    match page {
        Value::Number(_) => found.push(at.to_owned()),
        Value::String(s) if rational(s).is_some() => found.push(at.to_owned()),
        Value::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                numbers(item, &format!("{at}/{i}"), found);
            }
        }
        Value::Object(fields) => {
            // Theorems are named by number, too.
            let name =
                |key: &str, item: &Value| ["theorem", "claim"].contains(&key) && item.is_string();
            for (key, item) in fields.iter().filter(|(k, v)| !name(k, v)) {
                numbers(
                    item,
                    &format!("{at}/{}", key.replace('~', "~0").replace('/', "~1")),
                    found,
                );
            }
        }
        _ => {}
    }
}

fn rational(text: &str) -> Option<Rational> {
    let value: Rational = text.parse().ok()?;
    (value.to_string() == text).then_some(value)
}

fn mutations(number: &Value) -> Vec<Value> {
    let mut all = match number {
        Value::String(s) => {
            let x = rational(s).unwrap();
            let (one, two) = (Rational::one(), Rational::from_integer(2.into()));
            [&x + &one, &x - &one, -&x, &x * &two, &x / &two, Rational::zero()]
                .iter()
                .map(|y| json!(y.to_string()))
                .collect()
        }
        _ => {
            let n = number.as_u64().unwrap();
            vec![json!(n + 1), json!(n.saturating_sub(1)), json!(2 * n), json!(0)]
        }
    };
    let mut seen = vec![number.clone()];
    all.retain(|m| {
        let new = !seen.contains(m);
        seen.push(m.clone());
        new
    });
    all
}

#[test]
fn no_mutant_is_accepted_that_is_no_proof() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../certificates");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    let (mut rejected, mut proofs) = (0, 0);
    for path in files {
        let page: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        if page["certificate"].get("theorem").is_some() {
            continue;
        }
        let mut places = Vec::new();
        numbers(&page, "", &mut places);
        for place in places {
            for mutation in mutations(page.pointer(&place).unwrap()) {
                let mut mutant = page.clone();
                *mutant.pointer_mut(&place).unwrap() = mutation.clone();
                let accepted = check(&mutant.to_string()).code() == 0;
                let wanted = is_proof(&mutant);
                assert_eq!(accepted, wanted, "{}: {place} = {mutation}", path.display());
                if wanted {
                    proofs += 1;
                } else {
                    rejected += 1;
                }
            }
        }
    }
    assert_eq!((rejected, proofs), (REJECTED, PROOFS));
}

fn is_proof(page: &Value) -> bool {
    let (kind, body) = page["certificate"].as_object().unwrap().iter().next().unwrap();
    match kind.as_str() {
        "contraction" => {
            vector(body, |aw, w| aw <= q(&body["rate"]) * w) && {
                let rate = q(&body["rate"]);
                !rate.is_negative() && rate < Rational::one()
            }
        }
        "growth" => vector(body, |aw, w| aw >= w.clone()),
        "refutation" => refutation(body),
        "invariance" => invariance(body),
        _ => false,
    }
}

fn q(number: &Value) -> Rational {
    rational(number.as_str().unwrap()).unwrap()
}

fn qs(numbers: &Value) -> Vec<Rational> {
    numbers.as_array().unwrap().iter().map(q).collect()
}

/// |1-2eps| w_i + |eps| (w_{i-1} + w_{i+1}) against w_i.
fn vector(body: &Value, holds: impl Fn(Rational, &Rational) -> bool) -> bool {
    let (eps, w) = (q(&body["eps"]), qs(&body["vector"]));
    let two = Rational::from_integer(2.into());
    let at =
        |i: usize| i.checked_sub(1).and_then(|i| w.get(i)).cloned().unwrap_or_else(Rational::zero);
    body["drones"].as_u64().unwrap() == w.len() as u64 + 2
        && w.iter().all(Signed::is_positive)
        && (1..=w.len()).all(|i| {
            let own = (Rational::one() - &two * &eps).abs() * at(i);
            holds(own + eps.abs() * (at(i - 1) + at(i + 1)), &at(i))
        })
}

fn invariance(body: &Value) -> bool {
    let rows = |v: &Value| -> Vec<Vec<Rational>> { v.as_array().unwrap().iter().map(qs).collect() };
    let (a, b, m) = (rows(&body["matrix"]), qs(&body["offset"]), rows(&body["multipliers"]));
    let half_spaces = body["invariant"].as_array().unwrap();
    let normals: Vec<Vec<Rational>> = half_spaces.iter().map(|h| qs(&h["normal"])).collect();
    let bounds: Vec<Rational> = half_spaces.iter().map(|h| q(&h["bound"])).collect();
    let strict: Vec<bool> = half_spaces.iter().map(|h| h["strict"].as_bool().unwrap()).collect();
    let n = b.len();
    (0..normals.len()).all(|j| {
        let image = (0..n).all(|v| {
            let moved: Rational = (0..n).map(|u| &normals[j][u] * &a[u][v]).sum();
            moved == (0..normals.len()).map(|r| &m[j][r] * &normals[r][v]).sum()
        });
        let reached: Rational = (0..normals.len()).map(|r| &m[j][r] * &bounds[r]).sum();
        let offset: Rational = (0..n).map(|v| &normals[j][v] * &b[v]).sum();
        let slack = reached + offset - &bounds[j];
        let above = (0..normals.len()).any(|r| strict[r] && m[j][r].is_positive());
        m[j].iter().all(|m| !m.is_negative())
            && image
            && !slack.is_negative()
            && (!strict[j] || slack.is_positive() || above)
    })
}

fn refutation(body: &Value) -> bool {
    let named = |t: &Theorem| body["theorem"] == t.number();
    let theorem = *Theorem::ALL.iter().find(|t| named(t)).unwrap();
    let form = *Form::ALL.iter().find(|f| body["form"] == f.label()).unwrap();
    let (min, max, eps) = (q(&body["min"]), q(&body["max"]), q(&body["eps"]));
    let start = qs(&body["start"]);
    let setting = Setting {
        min: min.clone(),
        max: max.clone(),
        eps_num: eps.clone(),
        eps_den: Rational::one(),
    };
    let hypothesis = theorem.hypothesis(form);
    let met = match body.get("weights") {
        Some(_) => hypothesis.starts.contains(&setting, &start),
        None => hypothesis.met_by(&setting, &start),
    };
    let (n, step) = (start.len(), usize::try_from(body["step"].as_u64().unwrap()).unwrap());
    let steps = step + theorem.span(form, n);
    let schedules = ["activation", "delay"].map(|k| body.get(k).and_then(Value::as_array));
    if met != Truth::True || min >= max || schedules.iter().flatten().any(|s| s.len() != steps) {
        return false;
    }
    let mut run = vec![start];
    for t in 0..steps {
        let age = |i: usize, j: usize| -> Option<usize> {
            let all = schedules[1]?[t].as_array().unwrap();
            let entry = all.iter().find(|d| d["drone"] == i && d["sees"] == j)?;
            usize::try_from(entry["age"].as_u64().unwrap()).ok()
        };
        let active =
            |i: usize| schedules[0].is_none_or(|s| s[t].as_array().unwrap().contains(&json!(i)));
        if !sound(schedules, t, n) {
            return false;
        }
        let see = |i: usize, j: usize| run[t - age(i, j).unwrap_or(0)][j].clone();
        let two = Rational::from_integer(2.into());
        let next = (0..n)
            .map(|i| match i {
                _ if !active(i) => run[t][i].clone(),
                0 => min.clone(),
                _ if i + 1 == n => max.clone(),
                _ => {
                    &eps * (see(i, i - 1) + see(i, i + 1))
                        + (Rational::one() - &two * &eps) * &run[t][i]
                }
            })
            .collect();
        run.push(next);
    }
    let Verdict::Violated(v) = theorem.conclusion(form, &setting, &run[step..]) else {
        return false;
    };
    body["violation"]
        == match v.subject {
            Subject::Pair(i) => json!({ "step": v.step, "subject": "pair", "at": i }),
            Subject::Drone(i) => json!({ "step": v.step, "subject": "drone", "at": i }),
            Subject::Sum => json!({ "step": v.step, "subject": "sum" }),
            Subject::Energy => json!({ "step": v.step, "subject": "energy" }),
        }
}

/// Ascending entries about drones that there are, and messages that had been sent.
fn sound(schedules: [Option<&Vec<Value>>; 2], t: usize, n: usize) -> bool {
    let ascending = |rows: Vec<Vec<u64>>| rows.windows(2).all(|w| w[0] < w[1]);
    let whole = |v: &Value| v.as_u64().unwrap();
    let (n, t) = (n as u64, t);
    let active = schedules[0].is_none_or(|s| {
        let drones: Vec<u64> = s[t].as_array().unwrap().iter().map(whole).collect();
        drones.iter().all(|&i| i < n) && ascending(drones.iter().map(|&i| vec![i]).collect())
    });
    active
        && schedules[1].is_none_or(|s| {
            let entries: Vec<Vec<u64>> = s[t]
                .as_array()
                .unwrap()
                .iter()
                .map(|d| ["drone", "sees", "age"].iter().map(|f| whole(&d[f])).collect())
                .collect();
            let pairs = entries.iter().map(|d| d[..2].to_vec()).collect();
            ascending(pairs)
                && entries.iter().all(|d| d[0] < n && d[1] < n && (1..=t as u64).contains(&d[2]))
        })
}

/// The places of all sums: of goals, and of literals given of instances.
fn sums(page: &Value, at: &str, found: &mut Vec<String>) {
    if let Some(fields) = page.as_object() {
        for (key, item) in fields {
            let place = format!("{at}/{key}");
            let given = key == "given" && item.is_object();
            match item {
                Value::String(_) if key == "sum" => found.push(place),
                Value::Object(all) if given => {
                    found.extend(all.keys().map(|name| format!("{place}/{name}")));
                }
                _ => sums(item, &place, found),
            }
        }
    } else if let Some(items) = page.as_array() {
        items.iter().enumerate().for_each(|(i, item)| sums(item, &format!("{at}/{i}"), found));
    }
}

#[test]
fn no_other_sum_is_accepted() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../certificates");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    let mut tried = 0;
    for path in files {
        let page: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        let mut places = Vec::new();
        sums(&page["certificate"]["theorem"]["proof"], "/certificate/theorem/proof", &mut places);
        // Every tenth, with another constant.
        for place in places.iter().step_by(10) {
            let mut mutant = page.clone();
            let sum = mutant.pointer_mut(place).unwrap();
            *sum = json!(format!("{} + 1/3", sum.as_str().unwrap()));
            assert_eq!(check(&mutant.to_string()).code(), 4, "{}: {place}", path.display());
            tried += 1;
        }
    }
    assert_eq!(tried, SUMS);
}
