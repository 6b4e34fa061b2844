//! Evident counterexamples: where a proof is not found, a few extreme weights and coarse starts
//! are tried, smallest N first. (`cordon refute` searches in earnest.)

use cordon_spec::coverage::kth_step;
use cordon_spec::theorems::{Form, Setting, Subject, Theorem, Truth, Verdict};
use cordon_spec::{Params, Scalar, State};
use serde_json::{Value, json};

use super::certificate::sealed;
use super::goals::Scope;
use cordon_core::Rational;

/// Largest N tried: the printed 7.7 needs an off-target drone with index 3.
const MAX_DRONES: usize = 5;

/// Starts are tried on the grid of 1/4 of the spacing: it has the targets, points within the
/// first subsegment and points just before the targets.
const PER_SPACING: usize = 4;

/// Latest step X^k whose conclusion is evaluated.
const MAX_STEP: u64 = 2;

/// A refutation of the theorem in the scope, if one is evident.
pub fn refute(theorem: Theorem, scope: &Scope) -> Option<Value> {
    let hypothesis = theorem.hypothesis(scope.form);
    let drones = match scope.drones {
        Some(n) => n as usize..=(n as usize).min(MAX_DRONES),
        None => 3..=MAX_DRONES,
    };
    for count in drones {
        for eps in weights(scope) {
            let cells = (count - 1) * PER_SPACING;
            let params = Params {
                min: Rational::from_int(0),
                max: Rational::from_index(cells),
                eps: eps.clone(),
                n: 0,
            };
            let setting = Setting::from(&params);
            let within = scope.weights.is_some()
                || hypothesis.weights.contains(&eps, &Rational::from_int(1), count) == Truth::True;
            if !within {
                continue;
            }
            for start in starts(count, cells) {
                if hypothesis.starts.contains(&setting, &start) != Truth::True {
                    continue;
                }
                for step in 0..=MAX_STEP {
                    let found = violation(theorem, scope.form, &params, &start, step);
                    if let Some((at, subject)) = found {
                        let numbers: Vec<String> = start.iter().map(Rational::to_string).collect();
                        let mut body = json!({
                            "theorem": theorem.number(),
                            "form": scope.form.label(),
                            "min": "0",
                            "max": params.max.to_string(),
                            "eps": eps.to_string(),
                            "start": numbers,
                            "step": step,
                            "violation": { "step": at, "subject": subject },
                        });
                        let own = hypothesis.weights.contains(&eps, &Rational::from_int(1), count);
                        if own != Truth::True {
                            body["weights"] = json!("any");
                        }
                        return Some(sealed("refutation", body));
                    }
                }
            }
        }
    }
    None
}

/// The ends of the range and its middle.
fn weights(scope: &Scope) -> Vec<Rational> {
    let (from, to) =
        scope.weights.clone().unwrap_or((Rational::from_int(0), Rational::from_int(1)));
    let middle = (from.clone() + &to) / Rational::from_int(2);
    vec![from, to, middle]
}

/// Every placement of the inner drones on the grid, the ends in place.
fn starts(count: usize, cells: usize) -> impl Iterator<Item = Vec<Rational>> {
    let side = cells + 1;
    let inner = count - 2;
    (0..side.pow(inner as u32)).map(move |mut code| {
        let mut start = vec![Rational::from_int(0)];
        for _ in 0..inner {
            start.push(Rational::from_index(code % side));
            code /= side;
        }
        start.push(Rational::from_index(cells));
        start
    })
}

fn violation(
    theorem: Theorem,
    form: Form,
    params: &Params<Rational>,
    start: &[Rational],
    step: u64,
) -> Option<(usize, Value)> {
    let first = kth_step(params, State { drones: start.to_vec(), timesteps: 0 }, step);
    let run: Vec<Vec<Rational>> = (0..=theorem.span(form, start.len()) as u64)
        .map(|h| kth_step(params, first.clone(), h).drones)
        .collect();
    match theorem.conclusion(form, &Setting::from(params), &run) {
        Verdict::Violated(v) => {
            let subject = match v.subject {
                Subject::Pair(i) => json!({ "pair": i }),
                Subject::Drone(i) => json!({ "drone": i }),
                Subject::Sum => json!("sum"),
                Subject::Energy => json!("energy"),
            };
            Some((v.step, subject))
        }
        _ => None,
    }
}
