//! `cordon prove` and `cordon check`; and that no false claim is ever certified.
use std::fs;

use assert_cmd::Command;
use cordon_core::Rational;
use cordon_core::simplex::{Solution, Work, maximise};
use cordon_proof::certificate;
use cordon_proof::certificate::linear::{self, Edge, Invariance, LinearSystem, NodeClaim, form};
use cordon_proof::prove::{CLAIMS, Claim, Scope, stated};
use cordon_proof::refute::evident;
use cordon_spec::activation::exec_coverage_active;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::{Form, Setting, StartSet, Theorem, Verdict, above_targets, in_box};
use cordon_spec::{Params, State};
use num_traits::Signed;
use serde_json::{Value, json};

fn cordon(arguments: &[&str]) -> (i32, String, String) {
    let output = Command::cargo_bin("cordon").unwrap().args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn committed(name: &str) -> String {
    format!("{}/proofs/certificates/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn bad(name: &str) -> String {
    format!("{}/proofs/must-not-prove/{name}", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn the_search_finds_the_committed_certificates_again() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let claims = CLAIMS.map(|c| c.name).join(",");
    let (status, _, err) = cordon(&["prove", &claims, "--form", "sharp", "--out", out]);
    assert_eq!(status, 0, "{err}");
    let theorems: Vec<_> = CLAIMS.iter().filter(|c| c.theorem.is_some()).map(|c| c.name).collect();
    let (status, ..) = cordon(&["prove", &theorems.join(","), "--form", "paper", "--out", out]);
    assert_eq!(status, 1, "7.6ii, 7.7 and 7.8 as printed are refuted");
    let mut compared = 0;
    for file in fs::read_dir(folder.path()).unwrap() {
        let (path, name) = {
            let f = file.unwrap();
            (f.path(), f.file_name())
        };
        let there = fs::read_to_string(committed(name.to_str().unwrap())).unwrap();
        assert!(fs::read_to_string(&path).unwrap() == there, "{}", path.display());
        compared += 1;
    }
    assert_eq!(compared, 57);
}

#[test]
fn check_has_one_exit_code_a_verdict() {
    let good = committed("7.2-sharp.json");
    let (status, out, err) = cordon(&["check", &good]);
    assert_eq!((status, err.as_str()), (0, ""));
    assert!(out.contains("valid: coverage with full steps, every N >= 3"), "{out}");
    let cases = [
        ("format-schema.json", 2),
        ("statement-not-proved.json", 4),
        ("contraction-rate-one.json", 4),
    ];
    for (file, code) in cases {
        assert_eq!(cordon(&["check", &good, &bad(file)]).0, code, "{file}");
    }
    let (status, out, err) = cordon(&["check", "no-such-file.json"]);
    assert_eq!((status, out.as_str()), (74, "no-such-file.json: not read\n"));
    assert!(err.contains("cannot read `no-such-file.json`"), "{err}");
    assert_eq!(cordon(&["check"]).0, 2);
}

#[test]
fn check_speaks_json() {
    let (_, out, _) = cordon(&[
        "check",
        "--format",
        "json",
        &committed("7.2-sharp.json"),
        &bad("growth-zero-entry.json"),
    ]);
    let page: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(page["schema"], "cordon-verdicts/1");
    let verdicts: Vec<_> = (0..2).map(|i| page["verdicts"][i]["verdict"].clone()).collect();
    assert_eq!(verdicts, ["valid", "invalid"]);
}

#[test]
fn prove_ends_with_the_verdict_it_found() {
    let cases: [(&[&str], i32, &str); 7] = [
        (&["7.3"], 0, "7.3-sharp: proved: coverage with full steps, every N >= 3"),
        (&["7.4"], 0, "7.4ii-sharp: proved"),
        (&["7.2", "--drones", "3", "--eps", "0..1"], 0, "\n  assuming last = 2\n"),
        (
            &["7.2", "--eps", "0..3/5"],
            1,
            "refuted: 7.2 (sharp, any weight) is violated: N = 4, eps = 3/5",
        ),
        (&["7.8", "--form", "paper"], 1, "refuted: 7.8 (paper) is violated: N = 3, eps = 0"),
        (&["7.3-delay", "--eps", "0..3/5"], 3, "inconclusive: no strategy for this claim"),
        (&["7.3-delay", "--eps", "1/5..2/5", "--format", "json"], 0, "\"cordon-prove/1\""),
    ];
    for (arguments, code, shown) in cases {
        let (status, out, err) = cordon(&[&["prove"], arguments].concat());
        assert_eq!(status, code, "{arguments:?}: {out}{err}");
        assert!(out.contains(shown), "{arguments:?}: {out}");
    }
}

#[test]
fn prove_says_what_is_wrong_with_its_input() {
    let cases: [(&[&str], &str); 6] = [
        (&["7.9"], "claim: `7.9` is unknown: expected `all` or some of 7.2"),
        (&["7.3", "--eps", "(0,1/2]"], "--eps: `(0,1/2]`: expected a range with both ends"),
        (&["7.3", "--eps", "1/2..0"], "--eps: `1/2..0`: expected a range that is not empty"),
        (&["7.3", "--eps", "0..1/0"], "--eps: `1/0` divides by zero"),
        (&["7.3", "--drones", "2"], "--drones: `2`: expected `any` or a number from 3"),
        (&["7.3", "--drones", "few"], "--drones: `few`: expected `any`"),
    ];
    for (arguments, shown) in cases {
        let (status, out, err) = cordon(&[&["prove"], arguments].concat());
        assert_eq!((status, out.as_str()), (2, ""), "{arguments:?}");
        assert!(err.contains(shown), "{arguments:?}: {err}");
    }
    let (status, ..) = cordon(&["prove", "7.3", "--out", "/dev/null/x"]);
    assert_eq!(status, 74);
}

/// Numbers of SplitMix64: the same in every run.
pub(super) struct Source(pub(super) u64);

impl Source {
    /// A number below `n`.
    pub(super) fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        usize::try_from((z ^ (z >> 31)) >> 32).unwrap() % n
    }

    /// A quotient between `from` and `to`, both in units of 1/60.
    fn quotient(&mut self, from: i64, to: i64) -> Rational {
        let span = usize::try_from(to - from + 1).unwrap();
        q(from + i64::try_from(self.below(span)).unwrap(), 60)
    }
}

fn q(n: i64, d: i64) -> Rational {
    Rational::new(n.into(), d.into())
}

/// The theorem that a claim is, or extends.
fn of(claim: &Claim) -> Theorem {
    let number = claim.name.split('-').next().unwrap();
    *Theorem::ALL.iter().find(|t| t.number() == number).unwrap()
}

/// Runs the spec from a random start of the claim's kind and asks the spec's predicates.
fn violates(claim: &Claim, form: Form, eps: &Rational, drones: usize, source: &mut Source) -> bool {
    let last = i64::try_from(drones - 1).unwrap();
    let params = Params { min: q(0, 1), max: q(last, 1), eps: eps.clone(), n: 0 };
    let setting = Setting::from(&params);
    let (lower, boxed) = (claim.name.contains("mirror"), claim.name.contains("box"));
    let theorem = of(claim);
    let starts = theorem.hypothesis(form).starts;
    let mut run: Vec<Vec<Rational>> = vec![
        (0..last + 1)
            .map(|i| match i {
                0 => q(0, 1),
                _ if i == last => q(last, 1),
                _ if lower => q(i, 1) + source.quotient(0, 60),
                _ if boxed => source.quotient(0, 60 * last),
                _ if starts == StartSet::UpperBounded => q(i, 1) - source.quotient(0, 60),
                _ if starts == StartSet::FirstSubsegment => q(i, last + 1) * q(59, 60),
                _ => q(i, 1) + source.quotient(-29, 29),
            })
            .collect(),
    ];
    for t in 0..12 {
        let state = State { drones: run[t].clone(), timesteps: 0 };
        let next = if claim.name.contains("activation") {
            let mask = source.below(1 << drones);
            exec_coverage_active(&params, &state, |i| mask >> i & 1 == 1)
        } else if claim.name.contains("delay") {
            let ages: Vec<usize> = (0..drones * drones).map(|_| source.below(t + 1)).collect();
            exec_coverage_delayed(&params, &state, |i, j| &run[t - ages[i * drones + j]][j])
        } else {
            exec_coverage(&params, &state)
        };
        run.push(next.drones);
    }
    (0..5).any(|k| {
        let verdict = match (lower, boxed) {
            (true, _) => above_targets(&setting, &run[k]),
            (_, true) => in_box(&setting, &run[k]),
            _ => theorem.conclusion(form, &setting, &run[k..]),
        };
        assert_ne!(verdict, Verdict::Undecided);
        matches!(verdict, Verdict::Violated(_))
    })
}

#[test]
fn no_false_claim_is_certified() {
    let mut source = Source(7);
    // The limit has no strategy for an interval, and other claims no theorem.
    let claims: Vec<Claim> = CLAIMS
        .into_iter()
        .filter(|c| {
            c.theorem.is_some()
                || ["activation", "delay", "mirror", "box"].iter().any(|n| c.name.contains(n))
        })
        .filter(|c| c.theorem != Some(Theorem::Limit))
        // Not theorems with other steps, but statements of their own (see `departing`).
        .filter(|c| !["7.8-", "gaps", "cells"].iter().any(|n| c.name.contains(n)))
        .collect();
    let (mut proved, mut not_proved, mut seen_false) = (0, 0, 0);
    for case in 0..112 {
        let claim = &claims[case % claims.len()];
        let (a, b) = (source.quotient(-6, 66), source.quotient(-6, 66));
        let (from, to) = if a <= b { (a, b) } else { (b, a) };
        let one = [None, Some(3), Some(4), Some(6)][source.below(4)];
        let scope =
            Scope { form: Form::Sharp, weights: Some((from.clone(), to.clone())), drones: one };
        let certified = claim
            .prove(&scope)
            .is_some_and(|page| cordon_check::check(&page.to_string()).code() == 0);
        let mut falsified = false;
        for trial in 0..24 {
            let drones = one.map_or(3 + trial % 5, |n| usize::try_from(n).unwrap());
            let share = source.quotient(0, 60);
            let eps = match trial % 3 {
                0 => to.clone(),
                1 => from.clone(),
                _ => &from + (&to - &from) * share,
            };
            falsified |= violates(claim, Form::Sharp, &eps, drones, &mut source);
        }
        assert!(!(certified && falsified), "{} for {from}..{to}, {one:?}", claim.name);
        match certified {
            true => proved += 1,
            false => not_proved += 1,
        }
        seen_false += u32::from(falsified);
    }
    // All three happen, or this test says nothing.
    assert!(
        proved > 15 && not_proved > 15 && seen_false > 15,
        "{proved} {not_proved} {seen_false}"
    );
}

#[test]
fn a_certificate_is_good_for_its_own_scope_only() {
    let mut source = Source(11);
    let names = [
        "7.2-sharp",
        "7.3-sharp",
        "7.5i-sharp",
        "7.6ii-sharp",
        "7.7-sharp",
        "7.2-activation",
        "7.3-delay",
    ];
    let mut accepted = 0;
    for case in 0..210 {
        let name = names[case % names.len()];
        let text = fs::read_to_string(committed(&format!("{name}.json"))).unwrap();
        let mut page: Value = serde_json::from_str(&text).unwrap();
        let body = &mut page["certificate"]["theorem"]["statement"];
        let to = source.quotient(0, 66);
        let assumptions = body["assumptions"].as_array_mut().unwrap();
        assumptions.retain(|a| !a["name"].as_str().unwrap().starts_with("weight."));
        assumptions.push(json!({ "name": "weight.from", "goal": "eps >= 0" }));
        assumptions.push(json!({ "name": "weight.to", "goal": format!("{to} - eps >= 0") }));
        if source.below(2) == 0 {
            let count = format!("last + 1 = {}", 3 + source.below(3));
            assumptions.push(json!({ "name": "drones", "goal": count }));
        }
        accepted += u32::from(cordon_check::check(&page.to_string()).code() == 0);
    }
    // The proofs cite the facts of the range that they were found for.
    assert_eq!(accepted, 0);
}

#[test]
fn what_a_certificate_states_says_which_claim_it_is() {
    let mut known = 0;
    for file in fs::read_dir(committed("")).unwrap() {
        let path = file.unwrap().path();
        let page: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        let statement = &page["certificate"]["theorem"]["statement"];
        let found = stated(statement).map(|(claim, form)| claim.label(form));
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        // A user's protocol has no name here.
        let is_theorem = statement.is_object();
        let is_named = statement["system"].is_object() || (is_theorem && name.starts_with("7."));
        assert_eq!(found, is_named.then_some(name));
        known += u32::from(found.is_some());
    }
    assert_eq!(known, 54);
}

#[test]
fn evident_counterexamples_are_accepted_by_the_checker() {
    let mut found = 0;
    for theorem in Theorem::ALL {
        for form in Form::ALL {
            if let Some(counterexample) = evident(theorem, form, None, None) {
                assert_eq!(form, Form::Paper, "{theorem:?}");
                let page = certificate::refutation(&counterexample);
                assert_eq!(cordon_check::check(&page.to_string()).code(), 0, "{page}");
                found += 1;
            }
        }
    }
    assert_eq!(found, 3);
}

#[test]
fn invariants_of_random_protocols_hold_when_certified() {
    let mut source = Source(13);
    let (mut certified, mut refused) = (0, 0);
    for _ in 0..1_000 {
        let mut small = |n: i64| source.quotient(-n * 15, n * 15);
        let a: Vec<Vec<Rational>> = (0..2).map(|_| (0..2).map(|_| small(1)).collect()).collect();
        let offset: Vec<Rational> = (0..2).map(|_| small(1)).collect();
        let rows: Vec<(Vec<Rational>, Rational)> =
            (0..4).map(|_| (vec![small(3), small(3)], small(3) - q(1, 1))).collect();
        let mut multipliers = Vec::new();
        for (normal, bound) in &rows {
            // m >= 0 with m * normals = normal * A, and slack = m * bounds + normal * b - bound >= 0.
            let moved: Vec<Rational> =
                (0..2).map(|v| (0..2).map(|u| &normal[u] * &a[u][v]).sum()).collect();
            let mut equations: Vec<Vec<Rational>> =
                (0..2).map(|v| rows.iter().map(|(n, _)| n[v].clone()).collect()).collect();
            let mut last: Vec<Rational> = rows.iter().map(|(_, b)| b.clone()).collect();
            last.push(q(-1, 1));
            equations.push(last);
            let shift: Rational = (0..2).map(|u| &normal[u] * &offset[u]).sum();
            let constants = [moved, vec![bound - shift]].concat();
            let terms = |row: Vec<Rational>| row.into_iter().enumerate().collect::<Vec<_>>();
            let equations: Vec<_> = equations.into_iter().map(terms).collect();
            let equations: Vec<_> = equations.iter().map(Vec::as_slice).zip(&constants).collect();
            let work = Work::limited(1_000_000);
            if let Some(Solution::Optimal(mut m)) = maximise(5, &[], &equations, &work) {
                m.truncate(4);
                multipliers.push(m);
            }
        }
        if multipliers.len() < 4 {
            refused += 1;
            continue;
        }
        let names = ["x0", "x1"];
        let text =
            |constant: &Rational, row: &[Rational]| form(constant, names.into_iter().zip(row));
        let literal = |(n, b): &(Vec<Rational>, Rational)| format!("{} >= 0", text(&-b, n));
        let step = names.iter().zip(a.iter().zip(&offset));
        let invariance = Invariance {
            system: LinearSystem {
                state: names.map(str::to_owned).to_vec(),
                modes: [(
                    "step".into(),
                    step.map(|(n, (row, c))| ((*n).into(), text(c, row))).collect(),
                )]
                .into(),
                ..LinearSystem::default()
            },
            nodes: [("kept".into(), rows.iter().map(literal).collect())].into(),
            start: "kept".into(),
            edges: vec![Edge {
                from: "kept".into(),
                by: Some("step".into()),
                to: "kept".into(),
                multipliers: multipliers.iter().map(|m| vec![linear::multipliers(m)]).collect(),
            }],
            claims: vec![NodeClaim {
                at: "kept".into(),
                holds: literal(&rows[0]),
                multipliers: [(0, "1".to_owned())].into(),
            }],
        };
        let page = invariance.certificate().unwrap();
        let verdict = cordon_check::check(&page.to_string());
        assert_eq!(verdict.code(), 0, "{verdict}");
        certified += 1;
        let inside = |x: &[Rational]| {
            rows.iter().all(|(n, b)| !(&n[0] * &x[0] + &n[1] * &x[1] - b).is_negative())
        };
        for _ in 0..40 {
            let x = [source.quotient(-120, 120), source.quotient(-120, 120)];
            if inside(&x) {
                let next: Vec<Rational> =
                    (0..2).map(|u| &a[u][0] * &x[0] + &a[u][1] * &x[1] + &offset[u]).collect();
                assert!(inside(&next));
            }
        }
    }
    assert!(certified > 20 && refused > 20, "{certified} {refused}");
}
