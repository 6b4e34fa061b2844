//! Hostile files are refused, or judged within the work allowed a file: it is work that is counted
//! here, and no time. Each file is the most expensive of its kind that was found. In debug builds too: there exact
//! arithmetic and the checker are optimised (`Cargo.toml`), with all their assertions.

use cordon_check::format::MAX_BYTES;
use cordon_check::number::{MAX_WORK, done};
use cordon_check::{Verdict, check};
use serde_json::{Value, json};

fn sealed(kind: &str, body: Value) -> String {
    json!({ "schema": "cordon-certificate/2", "certificate": { kind: body } }).to_string()
}

fn overworked(what: &str, text: &str) {
    let verdict = check(text);
    let said = verdict.to_string();
    assert!(matches!(verdict, Verdict::Invalid { rule: "work", .. }), "{what}: {said:.200}");
    assert_eq!(done(), MAX_WORK, "{what}");
}

/// An integer of that many digits.
fn long(digits: usize, seed: usize) -> String {
    (0..digits)
        .map(|i| char::from(b'1' + u8::try_from((i * i + seed * (i + 7)) % 9).unwrap()))
        .collect()
}

/// A fraction in lowest terms: n / (n + 1).
fn fraction(digits: usize, seed: usize) -> String {
    let n: num_bigint::BigInt = long(digits, seed).parse().unwrap();
    format!("{n}/{}", &n + 1)
}

/// A theorem with one conclusion.
fn theorem(goal: &str, proof: &Value) -> String {
    let statement = json!({
        "system": { "protocol": "coverage", "steps": "full" }, "constants": { "a": "real", "b": "real" },
        "conclusions": [{ "name": "GOAL", "goal": goal }],
    });
    sealed(
        "theorem",
        json!({ "statement": statement, "proof": { "conclusions": { "GOAL": proof } } }),
    )
}

#[test]
fn refused_before_anything_is_computed() {
    let gigantic = format!("{{\"schema\": \"{}", "9".repeat(MAX_BYTES));
    let numbers =
        json!({ "drones": 3, "eps": "9".repeat(2_000_000), "rate": "0", "vector": ["1"] });
    let cases = [
        ("a file of more than 4 MiB", gigantic),
        ("a number of 2,000,000 digits", sealed("contraction", numbers)),
        ("a million brackets", format!("{{\"schema\": {}", "[".repeat(1_000_000))),
        ("nested objects", format!("{{\"certificate\": {}", "{\"theorem\":".repeat(300_000))),
        ("a key 200,000 times", format!("{{{}", "\"schema\": \"x\",".repeat(200_000))),
        ("nothing but spaces", " ".repeat(MAX_BYTES)),
        ("zero bytes", "\0".repeat(MAX_BYTES)),
    ];
    for (what, text) in cases {
        assert_eq!(check(&text).label(), "unreadable", "{what}");
        assert!(done() < 10_000, "{what}: {}", done());
    }
}

#[test]
fn a_file_may_have_four_mebibytes() {
    let growth = sealed("growth", json!({ "drones": 3, "eps": "1", "vector": ["1"] }));
    let padded = |length: usize| growth.clone() + &" ".repeat(length - growth.len());
    assert_eq!(check(&padded(MAX_BYTES)).label(), "valid");
    let verdict = check(&padded(MAX_BYTES + 1)).to_string();
    assert!(verdict.contains("at most 4194304 are read"), "{verdict}");
}

#[test]
fn expressions_that_expand_are_given_up() {
    let sum = json!({ "positivity": { "sum": "0" } });
    let factor = "(a + b + last + eps + min + max + 1)";
    overworked("a power", &theorem(&format!("{}*0 >= 0", [factor; 16].join("*")), &sum));
    let wide: Vec<String> = (0..1_000).map(|i| format!("x(0,{i})")).collect();
    let wide = format!("({})", wide.join(" + "));
    overworked("a square", &theorem(&format!("{wide}*{wide}*0 >= 0"), &sum));
    let fractions: Vec<String> = (1..40).map(|k| format!("1/{}", long(1_000, k))).collect();
    let sum_of_fractions = theorem(&format!("{} >= 0", fractions.join(" + ")), &sum);
    assert!(matches!(check(&sum_of_fractions), Verdict::Invalid { .. }));
    assert!(done() > 1_000_000, "{}", done());
}

#[test]
fn proofs_that_repeat_are_given_up() {
    // Each branch of a proof copies its clause.
    let given: Vec<String> = (0..3_000).map(|i| format!("x(0,{i})")).collect();
    let leaf = json!({ "positivity": { "sum": "0" } });
    let mut proof = leaf.clone();
    for i in 0..40 {
        proof = json!({ "split": { "name": format!("s{i}"), "on": "a", "above": leaf, "equal": leaf, "below": proof } });
    }
    let goal = format!("0*({}) >= 0", given.join(" + "));
    assert_eq!(check(&theorem(&goal, &proof)).label(), "valid");
    let mut wide: Value = serde_json::from_str(&theorem("0 >= 0", &proof)).unwrap();
    let clause = json!([{ "name": "g", "holds": format!("{} >= 0", given.join(" + ")) }]);
    wide["certificate"]["theorem"]["statement"]["conclusions"][0]["given"] = clause;
    overworked("copies", &wide.to_string());
}

#[test]
fn long_vectors_are_judged_or_given_up() {
    let body = |drones: usize, digits: usize, seed: usize| json!({ "drones": drones, "eps": fraction(digits, seed), "rate": "1/2", "vector": vec!["1"; drones - 2] });
    // Two hundred drones with fractions of 1,000 digits are allowed.
    let verdict = check(&sealed("contraction", body(200, 1_000, 5)));
    assert!(matches!(verdict, Verdict::Invalid { rule: "contraction", .. }), "{verdict}");
    assert!(done() < MAX_WORK, "{}", done());
    overworked("five hundred", &sealed("contraction", body(500, 1_000, 5)));
    let mut rate = body(9_000, 3, 5);
    rate["rate"] = json!(format!("1/{}", long(2_000, 3)));
    rate["eps"] = json!("1/2");
    let verdict = check(&sealed("contraction", rate));
    assert_eq!(verdict.label(), "invalid", "{verdict}");
}

#[test]
fn long_runs_are_judged_or_given_up() {
    let run = |theorem: &str, drones: usize, step: usize, eps: &str| {
        let start: Vec<String> = (0..drones).map(|i| (i * i).to_string()).collect();
        let body = json!({
            "theorem": theorem, "form": "sharp", "weights": "any", "min": "0",
            "max": ((drones - 1) * (drones - 1)).to_string(), "eps": eps, "start": start, "step": step,
            "violation": { "step": 0, "subject": "pair", "at": 1 },
        });
        sealed("refutation", body)
    };
    for (drones, step, eps) in [(3, 300, "1/3"), (40, 30, "7/9")] {
        let verdict = check(&run("7.2", drones, step, eps));
        assert!(matches!(verdict, Verdict::Invalid { rule: "refutation", .. }), "{verdict}");
        assert!(done() < MAX_WORK, "{}", done());
    }
    overworked("a thousand steps", &run("7.2", 300, 1_000, "123456788/123456789"));
    // The hypothesis of 7.8 and its rate are work, too.
    let hypothesis = run("7.8", 400, 0, &fraction(100, 5)).replace(",\"weights\":\"any\"", "");
    overworked("the minors of the critical weight", &hypothesis);
    let verdict = check(&run("7.8", 700, 0, "1/3"));
    assert!(matches!(verdict, Verdict::Invalid { rule: "refutation", .. }), "{verdict}");
    assert!(done() > 1_000_000, "the rate of 7.8 is counted: {}", done());
}

#[test]
fn runs_have_a_largest_number_of_steps() {
    let still = |step: usize| {
        let body = json!({
            "theorem": "7.8", "form": "paper", "min": "0", "max": "4", "eps": "0", "start": ["0", "1", "4"], "step": step,
            "violation": { "step": 1, "subject": "energy" },
        });
        check(&sealed("refutation", body)).to_string()
    };
    assert!(still(10_000).starts_with("valid"), "{}", still(10_000));
    assert!(still(10_001).contains("at most 10000 steps"), "{}", still(10_001));
}

#[test]
fn large_systems_are_judged_or_given_up() {
    // Vertices double with each parameter in a row.
    let disturbed = |count: usize| {
        let names: Vec<String> = (0..count).map(|p| format!("d{p}")).collect();
        let ranges: Value = names.iter().map(|n| (n.clone(), json!(["0", "1/10"]))).collect();
        let rows = json!({ "m": { "x": format!("-x + {}", names.join(" + ")) } });
        let node = json!({ "centre": ["0"], "matrix": [["1"]] });
        sealed(
            "ellipsoid",
            json!({
                "system": { "state": ["x"], "parameters": ranges, "modes": rows }, "points": [["0"]], "start": ["a"],
                "nodes": { "a": node }, "claims": ["x + 1 >= 0"],
                "edges": [{ "from": "a", "by": "m", "to": "a", "decay": "1" }],
            }),
        )
    };
    assert_eq!(check(&disturbed(5)).label(), "valid");
    overworked("a thousand billion vertices", &disturbed(40));
    // A dense form of the most variables.
    let dense = |size: usize| {
        let names: Vec<String> = (0..size).map(|i| format!("x{i}")).collect();
        let triangle: Vec<Vec<String>> = (0..size)
            .map(|i| {
                (0..=i).map(|j| if i == j { "1000".into() } else { fraction(3, i + j) }).collect()
            })
            .collect();
        let update: Vec<String> =
            names.iter().enumerate().map(|(i, x)| format!("{}*{x}", fraction(3, i))).collect();
        let rows: Value = names.iter().map(|x| (x.clone(), json!(update.join(" + ")))).collect();
        let zero = vec!["0"; size];
        sealed(
            "ellipsoid",
            json!({
                "system": { "state": names, "modes": { "m": rows } }, "points": [zero], "start": ["a"],
                "nodes": { "a": { "centre": zero, "matrix": triangle } }, "claims": ["x0 + 1 >= 0"],
                "edges": [{ "from": "a", "by": "m", "to": "a", "decay": "1" }],
            }),
        )
    };
    assert!(matches!(check(&dense(8)), Verdict::Invalid { rule: "ellipsoid", .. }));
    overworked("two hundred variables", &dense(200));
}

/// An ellipsoid of the most variables is judged, one of more is not.
#[test]
fn ellipsoids_have_a_largest_number_of_variables() {
    let still = |size: usize| {
        let names: Vec<String> = (0..size).map(|i| format!("x{i}")).collect();
        let rows: Value = names.iter().map(|x| (x.clone(), json!(format!("-{x}")))).collect();
        let unit = |i: usize| (0..=i).map(|j| if i == j { "1" } else { "0" }).collect();
        let triangle: Vec<Vec<&str>> = (0..size).map(unit).collect();
        let zero = vec!["0"; size];
        sealed(
            "ellipsoid",
            json!({
                "system": { "state": names, "modes": { "m": rows } }, "points": [zero], "start": ["a"],
                "nodes": { "a": { "centre": zero, "matrix": triangle } }, "claims": ["x0 + 1 >= 0"],
                "edges": [{ "from": "a", "by": "m", "to": "a", "decay": "1" }],
            }),
        )
    };
    assert_eq!(check(&still(200)).label(), "valid");
    assert!(check(&still(201)).to_string().contains("201 variables: expected at most 200"));
}

#[test]
fn long_counterexamples_are_judged_or_given_up() {
    let run = |rows: Value, steps: usize| {
        let names: Vec<String> = rows.as_object().unwrap().keys().cloned().collect();
        let system = json!({ "state": names, "modes": { "m": rows } });
        sealed(
            "counterexample",
            json!({
                "system": system, "start": vec!["1"; names.len()], "claim": format!("{} < 0", names[0]),
                "steps": vec![json!({ "by": "m" }); steps],
            }),
        )
    };
    // Numbers that become longer, many rows, and steps that do nothing.
    let longer = |steps| run(json!({ "x": "3/7*x + 1/11*y", "y": "5/13*x - 1/3*y" }), steps);
    assert_eq!(check(&longer(100)).label(), "valid");
    assert!(done() > 100_000, "{}", done());
    overworked("numbers that grow", &longer(20_000));
    let names: Vec<String> = (0..10_000).map(|n| format!("x{n}")).collect();
    let still = |row: &str| names.iter().map(|n| (n.clone(), json!(row))).collect::<Value>();
    overworked("rows", &run(still("0"), 20_000));
    let idle = json!({ "system": { "state": names, "modes": { "m": {} } }, "start": vec!["1"; 10_000], "claim": "x0 < 0", "steps": vec![json!({ "by": "m" }); 100_000] });
    assert_eq!(check(&sealed("counterexample", idle)).label(), "valid");
}

#[test]
fn many_small_things_are_work_too() {
    let leaf = json!({ "positivity": { "sum": "0" } });
    let stated = |statement: Value| {
        sealed(
            "theorem",
            json!({ "statement": statement, "proof": { "conclusions": { "GOAL": leaf } } }),
        )
    };
    // Each new name is compared with those that are there.
    let vars: Vec<Value> =
        (0..100_000).map(|n| json!({ "name": format!("v{n}"), "sort": "real" })).collect();
    let system = json!({ "protocol": "coverage", "steps": "full" });
    let goal = json!([{ "name": "GOAL", "for": vars, "goal": "0 >= 0" }]);
    overworked("variables", &stated(json!({ "system": system, "conclusions": goal })));
}
