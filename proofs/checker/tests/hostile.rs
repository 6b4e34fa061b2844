//! Hostile files are refused, or at worst judged, within bounded time and memory: each limit of
//! the checker is approached from below with the most expensive content found.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::time::{Duration, Instant};

use cordon_check::format::{MAX_BYTES, MAX_NUMBER};
use cordon_check::{Verdict, check};
use serde_json::{Value, json};

/// Time for any file; unoptimised builds are some 30 times slower than the program.
const PATIENCE: Duration =
    if cfg!(debug_assertions) { Duration::from_secs(600) } else { Duration::from_secs(20) };

fn sealed(kind: &str, body: Value) -> String {
    json!({ "schema": "cordon-certificate/1", "certificate": { kind: body } }).to_string()
}

fn in_time(what: &str, text: &str) -> Verdict {
    let start = Instant::now();
    let verdict = check(text);
    let took = start.elapsed();
    assert!(took < PATIENCE, "{what}: {took:?}");
    eprintln!("{what}: {took:?}, {}", verdict.label());
    verdict
}

/// An integer of that many digits that no common divisor shortens.
fn long(digits: usize, seed: usize) -> String {
    (0..digits)
        .map(|i| char::from(b'1' + u8::try_from((i * i + seed * (i + 7)) % 9).unwrap()))
        .collect()
}

#[test]
fn refused_before_anything_is_computed() {
    let gigantic = format!("{{\"schema\": \"{}", "9".repeat(MAX_BYTES));
    let long_number = sealed(
        "contraction",
        json!({ "drones": 3, "eps": "9".repeat(2_000_000), "rate": "0", "vector": ["1"] }),
    );
    let deep = format!("{{\"schema\": {}", "[".repeat(1_000_000));
    let deep_unknown = sealed("theorem", json!({}))
        .replace("{}", &format!("{{\"claim\": {}", "{\"a\":".repeat(500_000)));
    let many_keys = format!("{{{}", "\"schema\": \"x\",".repeat(200_000));
    let cases = [
        ("a file of more than 4 MiB", gigantic),
        ("a number of 2,000,000 digits", long_number),
        ("a million brackets", deep),
        ("nested objects", deep_unknown),
        ("a key 200,000 times", many_keys),
        ("nothing but spaces", " ".repeat(MAX_BYTES)),
        ("zero bytes", "\0".repeat(MAX_BYTES)),
    ];
    for (what, text) in cases {
        let start = Instant::now();
        assert_eq!(check(&text).label(), "unreadable", "{what}");
        assert!(start.elapsed() < Duration::from_secs(5), "{what}");
    }
}

#[test]
fn the_most_expensive_proofs_are_judged_in_time() {
    let facts: Vec<String> = ["-", "+"]
        .iter()
        .flat_map(|s| (-1..=1).map(move |o| format!("M*w{s}error[{o}] >= 0")))
        .collect();
    // As many terms as the limit on expansion allows, with denominators that have nothing in
    // common, in both leaves of nested splits; the first leaf that fails ends the check, so
    // that each but the last has to be a proof: that is not to be had, one leaf has to do.
    let term =
        |k: usize| json!({ "c": format!("{}/{}", 2 * k + 1, long(4, k)), "of": &facts[..3] });
    let mut number = 0;
    let terms: Vec<Value> = std::iter::from_fn(|| {
        number += 1;
        Some(term(number))
    })
    .filter(|t| {
        Value::as_str(&t["c"]).unwrap().parse::<cordon_check::poly::Rational>().unwrap().to_string()
            == t["c"]
    })
    .take(40)
    .collect();
    let proofs =
        json!([{ "obligation": "step/upper", "proof": { "rule": "positivity", "terms": terms } }]);
    let text = sealed("theorem", json!({ "claim": "7.8", "form": "sharp", "proofs": proofs }));
    assert_eq!(in_time("40 products of 3 facts", &text).label(), "invalid");
    // Nested splits double the leaves; a branch that is a proof lets the next be looked at.
    let mut proof = json!({ "rule": "positivity" });
    for _ in 0..8 {
        proof = json!({ "rule": "split", "on": [{ "c": "1", "of": ["eps"] }], "branches": [proof.clone(), proof] });
    }
    let proofs = json!([{ "obligation": "step/error/first", "proof": proof }]);
    let text = sealed("theorem", json!({ "claim": "7.3", "form": "sharp", "proofs": proofs }));
    assert_eq!(in_time("256 leaves", &text).label(), "incomplete");
    // A datum of the highest degree, shifted.
    let of = vec!["i"; 8];
    let polynomial: Vec<Value> =
        (1..=100).map(|k| json!({ "c": format!("{}/7", 7 * k + 1), "of": of })).collect();
    let data = json!([{ "name": "flux", "polynomial": polynomial }]);
    let text = sealed("theorem", json!({ "claim": "7.5-identity", "data": data, "proofs": [] }));
    assert_eq!(in_time("a datum of degree 8", &text).label(), "incomplete");
}

#[test]
fn the_largest_vectors_are_judged_in_time() {
    let body = |drones: usize, digits: usize| {
        let eps = format!("{}/{}", long(digits / 2, 3), long(digits / 2, 5));
        let eps = eps.parse::<cordon_check::poly::Rational>().unwrap().to_string();
        assert!(eps.len() > digits - 10 && eps.len() <= MAX_NUMBER);
        let vector = vec!["1"; drones - 2];
        let body = json!({ "drones": drones, "eps": eps, "rate": "1/2", "vector": vector });
        sealed("contraction", body)
    };
    let largest = if cfg!(debug_assertions) { (1_000, 300) } else { (10_000, 300) };
    for (drones, digits) in [largest, (100, 980)] {
        let verdict = in_time("a long eps", &body(drones, digits));
        assert!(verdict.to_string().contains("exceeds rate * w"), "{verdict}");
    }
    let verdict = in_time("a long eps and many drones", &body(10_000, 980));
    assert!(verdict.to_string().contains("too long for so many drones"), "{verdict}");
    let vector: Vec<String> = (0..998).map(|k| long(980, k)).collect();
    let body = json!({ "drones": 1_000, "eps": "1/2", "vector": vector });
    assert_eq!(in_time("998 long entries", &sealed("growth", body)).label(), "invalid");
}

#[test]
fn the_longest_runs_are_judged_in_time() {
    let run = |drones: usize, step: usize, eps: &str| {
        let start: Vec<String> = (0..drones).map(|i| (i * i).to_string()).collect();
        sealed(
            "refutation",
            json!({
                "theorem": "7.2", "form": "sharp", "weights": "any",
                "min": "0", "max": ((drones - 1) * (drones - 1)).to_string(), "eps": eps,
                "start": start, "step": step,
                "violation": { "step": 0, "subject": { "pair": 1 } },
            }),
        )
    };
    // Placements that do not move would be cheap: eps is what makes the numbers long.
    for (drones, step, eps) in [(3, 1_000, "1/3"), (3, 260, "123456788/123456789"), (40, 60, "7/9")]
    {
        let verdict = in_time("a long run", &run(drones, step, eps));
        assert_eq!(verdict.label(), "invalid", "{verdict}");
    }
    let verdict = check(&run(1_000, 1_000, "123456788/123456789"));
    assert!(verdict.to_string().contains("too long for its numbers"), "{verdict}");
}
