//! Users' own linear protocols: proofs and counterexamples.
use std::cell::Cell;
use std::path::Path;

use crate::common::{for_cases, q, run};
use cordon_check::Verdict;
use cordon_check::number::{MAX_WORK, done};
use cordon_core::Rational;
use cordon_proof::own_protocol::prove::{is_vacuous, prove};
use cordon_proof::own_protocol::refute::{check, refute, weights};
use cordon_proof::own_protocol::{OwnProtocol, parse, read};
use proptest::prelude::*;

fn own(name: &str) -> OwnProtocol {
    read(Path::new(&format!("scenarios/own/{name}.toml"))).unwrap()
}

#[test]
fn examples_are_proved_with_valid_certificates_or_refuted() {
    let mut certificates = 0;
    for name in ["damped-pair", "leader-chain", "ring-consensus", "weighted-coverage"] {
        let protocol = own(name);
        let proof = prove(&protocol).unwrap_or_else(|| panic!("{name} is not proved"));
        let verdict = cordon_check::check(&proof.certificate.to_string());
        assert!(matches!(verdict, Verdict::Valid { .. }), "{name}: {verdict}");
        // Base case, both ends of eps and the claims are in it, as the checker's words say.
        let words = verdict.to_string();
        assert!(
            words.contains("assuming of the start: ")
                && words.contains("proved of every run, at every step: "),
            "{words}"
        );
        certificates += 1;
        assert_eq!(refute(&protocol, &weights(&protocol, 4), 5), None, "{name}");
    }
    assert_eq!(certificates, 4);
    let hasty = own("hasty-coverage");
    assert!(prove(&hasty).is_none());
    let found = refute(&hasty, &weights(&hasty, 8), 5).unwrap();
    assert_eq!((found.step, found.eps.clone()), (1, q("3/5")));
}

/// Lines of many drones: the checker's bound on its work does not refuse what the search proves. Two
/// hundred are the most that a file may have, and as many comparisons.
#[test]
fn long_lines_are_proved_and_their_certificates_are_accepted() {
    let drones: Vec<String> = (0..200).map(|i| format!("x{i}")).collect();
    let order = format!("\"{}\"", drones.join(" < "));
    let box_of: Vec<String> =
        drones.iter().take(100).map(|x| format!("\"0 <= {x} <= 1\"")).collect();
    let cases = [(200, order), (100, box_of.join(", "))];
    for (count, claims) in cases {
        let text = format!(
            "title = \"line\"\ndrones = {count}\ngraph = \"path\"\nweight = \"eps\"\neps = \"0..1/2\"\n\
             claim = [{claims}]\n"
        );
        let proof = prove(&parse("line", &text).unwrap()).unwrap();
        let verdict = cordon_check::check(&proof.certificate.to_string());
        assert!(matches!(verdict, Verdict::Valid { .. }), "{verdict}");
        assert!(done() < MAX_WORK / 2, "{}", done());
    }
}

#[test]
fn the_invariant_is_strengthened_only_where_it_has_to_be() {
    let proof = prove(&own("weighted-coverage")).unwrap();
    assert_eq!(proof.half_spaces, proof.claimed);
    let proof = prove(&own("damped-pair")).unwrap();
    assert!(proof.half_spaces > proof.claimed);
}

/// Two or three drones, small rational coefficients, a box of starts, one or two claims.
fn random_protocol() -> impl Strategy<Value = String> {
    (2usize..=3).prop_flat_map(|n| {
        let entry = (-2i32..=2, 4i32..=6);
        let row = prop::collection::vec(entry, n + 1);
        let claim = (prop::collection::vec(-2i32..=2, n), 0i32..=4, any::<bool>());
        (prop::collection::vec(row, n), prop::collection::vec(claim, 1..=2), any::<bool>())
            .prop_map(move |(rows, claims, with_eps)| text(&rows, &claims, with_eps))
    })
}

type Row = Vec<(i32, i32)>;

fn text(rows: &[Row], claims: &[(Vec<i32>, i32, bool)], with_eps: bool) -> String {
    let n = rows.len();
    let mut text = format!("drones = {n}\neps = \"1/4..1/2\"\nstart = [");
    for i in 0..n {
        text += &format!("\"-1 <= x{i} <= 1\", ");
    }
    text += "]\nclaim = [";
    for (normal, bound, strict) in claims {
        let sum: Vec<String> =
            normal.iter().enumerate().map(|(i, c)| format!("({c})*x{i}")).collect();
        let sign = if *strict { "<" } else { "<=" };
        text += &format!("\"{} {sign} {bound}\", ", sum.join(" + "));
    }
    text += "]\n[update]\n";
    for (i, row) in rows.iter().enumerate() {
        let mut terms: Vec<String> =
            row.iter().take(n).enumerate().map(|(j, (a, d))| format!("({a})/({d})*x{j}")).collect();
        let (a, d) = row[n];
        if with_eps {
            terms.push(format!("eps*({a})/({d})*x0"));
        } else {
            terms.push(format!("({a})/({})", 4 * d));
        }
        text += &format!("x{i} = \"{}\"\n", terms.join(" + "));
    }
    text
}

/// Starts on a grid of the box, ends included.
fn grid(n: usize) -> Vec<Vec<Rational>> {
    let values = ["-1", "-1/3", "0", "1/2", "1"].map(q);
    (0..5usize.pow(n as u32))
        .map(|code| (0..n).map(|i| values[code / 5usize.pow(i as u32) % 5].clone()).collect())
        .collect()
}

#[test]
fn what_is_proved_never_fails_and_what_is_refuted_replays() {
    let (proved, refuted, open) = (Cell::new(0), Cell::new(0), Cell::new(0));
    for_cases(150, random_protocol(), |text| {
        let protocol = parse("random", &text).map_err(|e| TestCaseError::fail(e.to_string()))?;
        prop_assert!(!is_vacuous(&protocol));
        let searched = weights(&protocol, 4);
        let proof = prove(&protocol);
        let found = refute(&protocol, &searched, 4);
        prop_assert!(proof.is_none() || found.is_none(), "both proved and refuted:\n{}", text);
        if let Some(proof) = proof {
            let verdict = cordon_check::check(&proof.certificate.to_string());
            prop_assert!(matches!(verdict, Verdict::Valid { .. }), "{}\n{}", verdict, text);
            // Weights of its own, starts of its own, steps beyond any search.
            for eps in ["1/4", "3/10", "5/13", "1/2"].map(q) {
                for start in grid(protocol.count) {
                    prop_assert_eq!(check(&protocol, &eps, &start, 6), None, "{}", text);
                }
            }
            proved.set(proved.get() + 1);
        } else if let Some(run) = found {
            // Executed anew: an assumed start, the claim kept before the step and broken at it.
            let again = protocol.run(&run.eps, &run.placements[0], run.step);
            prop_assert_eq!(&again, &run.placements);
            prop_assert!(protocol.starts.iter().all(|c| c.holds(&again[0])));
            prop_assert!(!protocol.claims[run.claim].holds(&again[run.step]));
            let earlier = &again[..run.step];
            prop_assert!(earlier.iter().all(|x| protocol.claims.iter().all(|c| c.holds(x))));
            refuted.set(refuted.get() + 1);
        } else {
            // Not refuted up to step 4 is complete for all starts: none on the grid fails.
            for eps in &searched {
                for start in grid(protocol.count) {
                    prop_assert_eq!(check(&protocol, eps, &start, 4), None, "{}", text);
                }
            }
            open.set(open.get() + 1);
        }
        Ok(())
    });
    assert_eq!(proved.get() + refuted.get() + open.get(), 150);
    assert!(proved.get() >= 20 && refuted.get() >= 20, "{proved:?} {refuted:?} {open:?}");
}

#[test]
fn a_counterexample_replays_from_the_command_line() {
    let file = "scenarios/own/hasty-coverage.toml";
    let (code, out, err) = run(&["refute", "--protocol", file]);
    assert_eq!((code, err.as_str()), (1, ""), "{out}");
    let replay = out.lines().find_map(|l| l.trim().strip_prefix("replay: cordon ")).unwrap();
    let words: Vec<&str> = replay.split(' ').collect();
    let (code, again, _) = run(&words);
    assert_eq!(code, 1);
    // The heading alone says that the weight is the given one.
    let below = |page: &str| page.split_once('\n').map(|(_, rest)| rest.to_owned());
    assert_eq!(below(&again), below(&out));
    let (code, out, _) = run(&["refute", "--protocol", "scenarios/own/leader-chain.toml"]);
    assert_eq!(code, 3);
    assert!(out.contains("complete for all starts"), "{out}");
}

#[test]
fn prove_ends_with_a_certificate_a_counterexample_or_neither() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path().to_str().unwrap();
    let prove = |file: &str| run(&["prove", "--protocol", file, "--out", dir]);
    let (code, out, err) = prove("scenarios/own/leader-chain.toml");
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("proved") && out.contains("inductive") && out.contains("base"), "{out}");
    let file = folder.path().join("leader-chain.json");
    assert_eq!(run(&["check", file.to_str().unwrap()]).0, 0);
    let (code, out, _) = prove("scenarios/own/hasty-coverage.toml");
    assert_eq!(code, 1, "{out}");
    assert!(!folder.path().join("hasty-coverage.json").exists());
    // An exact rotation: the disc is kept, no polygon is.
    let turning = folder.path().join("turning.toml");
    let text = "drones = 2\nstart = [\"-1 <= x0 <= 1\", \"-1 <= x1 <= 1\"]\nclaim = [\"x0 <= 3/2\"]\n\
                [update]\nx0 = \"3/5*x0 - 4/5*x1\"\nx1 = \"4/5*x0 + 3/5*x1\"\n";
    std::fs::write(&turning, text).unwrap();
    let (code, out, _) = prove(turning.to_str().unwrap());
    assert_eq!(code, 3);
    assert!(out.contains("not refuted") && out.contains("complete for all starts"), "{out}");
    let (code, out, _) =
        run(&["prove", "--protocol", "scenarios/own/ring-consensus.toml", "--format", "json"]);
    let page: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, &page["proved"]), (0, &serde_json::json!(true)));
    assert_eq!(page["schema"], "cordon-own-protocol/1");
    let (code, out, _) = run(&["prove", "--protocol", "no-such-file.toml"]);
    assert_eq!((code, out.as_str()), (74, ""));
}

#[test]
fn mistakes_are_named_with_file_line_column_and_key() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.toml");
    let good = "drones = 2\neps = 1\ngraph = \"path\"\nweight = \"eps\"\nclaim = [\"x0 < x1\"]\n";
    let cases = [
        (good.replace("drones = 2", "drones = 0"), "p.toml:1:10: drones: `0`"),
        (good.replace("eps = 1", "eps = \"1/0\""), "p.toml:2:7: eps: `1/0` divides by zero"),
        (good.replace("eps = 1", "eps = \"1..0\""), "p.toml:2:7: eps: `1..0`: expected a range"),
        (good.replace("eps = 1\n", ""), "p.toml:3:10: weight: expected no eps, or a key `eps`"),
        (good.replace("path", "star"), "p.toml:3:9: graph: `star` is unknown"),
        (good.replace("\"eps\"", "\"eps*eps\""), "weight: expected no higher power of eps"),
        (good.replace("\"eps\"", "\"x0\""), "p.toml:4:10: weight: expected no positions"),
        (good.replace("x0 < x1", "x0 < x2"), "p.toml:5:16: claim: `x2` is no drone"),
        (good.replace("x0 < x1", "x0 * x1 < 1"), "p.toml:5:10: claim: expected no product"),
        (good.replace("x0 < x1", "eps < x1"), "p.toml:5:10: claim: expected no eps"),
        (
            good.replace("x0 < x1", "x0"),
            "claim: expected `<`, `<=`, `=`, `>=` or `>`, found the end",
        ),
        (good.replace("x0 < x1", "x0 < 1/0"), "claim: a division by zero"),
        (good.replace("[\"x0 < x1\"]", "[]"), "p.toml:5:9: claim: expected at least one"),
        (good.replace("weight", "wieght"), "p.toml:4:1: unknown field `wieght`"),
        (format!("{good}[update]\nx7 = \"x0\"\n"), "p.toml:7:1: update: `x7` is no drone"),
        (format!("{good}[update]\nx1 = \"x0 +\"\n"), "p.toml:7:11: update.x1: expected a number"),
        (
            format!("{good}[update]\nx1 = \"x0*x1\"\n"),
            "update.x1: expected no product of positions",
        ),
        (good.replace("graph = \"path\"\n", ""), "drone 0 has no update"),
        (good.replace("x0 < x1", "x0 < x0"), "no start meets the assumptions"),
        (good.replace("x0 < x1", &"(".repeat(500)), "claim: is nested too deeply"),
    ];
    for (text, expected) in &cases {
        std::fs::write(&path, text).unwrap();
        let (code, out, err) = run(&["refute", "--protocol", path.to_str().unwrap()]);
        assert_eq!((code, out.as_str()), (2, ""), "{text}\n{err}");
        assert!(err.contains(expected), "expected `{expected}` in `{err}`");
    }
    assert_eq!(cases.len(), 20);
    std::fs::write(&path, good).unwrap();
    let with_start = |start| {
        let file = path.to_str().unwrap();
        run(&["refute", "--protocol", file, "--start", start, "--steps", "1"])
    };
    assert_eq!(with_start("0,1").0, 1, "they swap at eps = 1");
    assert_eq!(with_start("1,0").0, 2, "not an assumed start");
    assert_eq!(with_start("0").0, 2, "too short");
}
