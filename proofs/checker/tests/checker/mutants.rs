//! Every number of every committed certificate is changed, in several ways; each mutant has to
//! be rejected unless it is a proof itself.
//!
//! A mutant is recognised as a proof without the checker's help: a sum in a proof by the kernel is an identity
//! between polynomials, so that no change of a number in it leaves a proof; of the others see [`super::anew`].

use std::fs;
use std::path::PathBuf;

use super::anew::{ellipsoid, is_proof, rational};
use cordon_check::check;
use num_rational::BigRational as Rational;
use num_traits::{One, Zero};
use serde_json::{Value, json};

/// Mutants that are no proofs, and mutants that are.
const REJECTED: usize = 487;
const PROOFS: usize = 107;

/// Mutants of sums.
const SUMS: usize = 856;

/// Ellipsoids on their way that are refused at a node or an edge, that are proofs, and whose claim fails in between.
const ANSWERS: [i32; 3] = [719, 1101, 92];

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

/// Ellipsoids of one variable on their way between two nodes, small numbers that meet every bound exactly now and then: a claim that
/// holds at both may fail in between.
#[test]
fn claims_on_the_way_are_judged_as_by_their_roots() {
    let mut answers = [0, 0, 0];
    // In quarters and sixteenths: how far the claim is from the centre, how far that moves, and how wide the ends are.
    let part = |n: i64, of: i64| Rational::new(n.into(), of.into()).to_string();
    let node = |c: i64, q: i64| json!({ "centre": [part(c, 4)], "matrix": [[part(q, 16)]] });
    let cases = (1..=5i64).flat_map(|start| {
        let narrow = (start * start - 9).max(1)..=start * start + 1;
        (-3..=3i64).flat_map(move |shift| {
            let square = (start + shift) * (start + shift);
            let wide = (square - 7).max(1)..=square + 1;
            narrow.clone().flat_map(move |n| wide.clone().map(move |w| (start, shift, n, w)))
        })
    });
    for (case, (start, shift, narrow, wide)) in cases.enumerate() {
        let sign = if case % 2 == 0 { ">=" } else { ">" };
        let body = json!({
            "system": { "state": ["x"], "modes": { "m": { "x": format!("{} - 40*x", 5 * shift) } } },
            "nodes": { "a": node(0, narrow), "b": node(shift, wide) }, "start": ["a"], "points": [["0"]],
            "edges": [{ "from": "a", "by": "m", "to": "b", "decay": "40", "time": "1" }],
            "claims": [format!("x + {} {sign} 0", part(start, 4))],
        });
        let page =
            json!({ "schema": "cordon-certificate/2", "certificate": { "ellipsoid": body } });
        let verdict = check(&page.to_string());
        assert_eq!(verdict.code() == 0, ellipsoid(&body), "{body}: {verdict}");
        let on_the_way = verdict.to_string().contains("may fail along");
        answers[if on_the_way { 2 } else { usize::from(verdict.code() == 0) }] += 1;
    }
    assert_eq!(answers, ANSWERS);
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
