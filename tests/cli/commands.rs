//! The commands as a new user runs them: results, errors, exit codes.
use crate::common::{cordon, run};
use serde_json::Value;

#[test]
fn local_machines_agree_and_stop_agreeing_when_they_exchange_too_rarely() {
    let (code, out, _) = run(&["local", "scenarios/paper.toml"]);
    assert_eq!(code, 0);
    let last = out.lines().last().unwrap();
    assert_eq!(
        last,
        "5 local machines compute the global kth_step exactly, at the start and after each of 77 ticks (this run only)"
    );
    let (code, out, _) =
        run(&["local", "scenarios/paper.toml", "--exchange-every", "5", "--ticks", "9"]);
    assert_eq!(code, 1);
    assert!(
        out.ends_with("first difference at tick 5, drone 2: local 20, global 112/5\n"),
        "{out}"
    );
    // A quotient of 5/2 rounds up to 3, the paper run's counter limit; 7/2 does not.
    let ratio = |r| run(&["local", "scenarios/paper.toml", "--ratio", r, "--format", "json"]);
    let (code, out, _) = ratio("5/2");
    assert_eq!(code, 0);
    assert_eq!(serde_json::from_str::<Value>(&out).unwrap()["equal"], true);
    let (code, out, _) = ratio("7/2");
    assert_eq!(code, 1);
    let page: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(page["first_difference"]["tick"], 5);
    assert_eq!(run(&["local", "scenarios/consensus.toml"]).0, 2);
}

#[test]
fn every_erratum_is_established() {
    let (code, out, err) = run(&["errata"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(!out.contains("NOT ESTABLISHED"), "{out}");
    let (_, json, _) = run(&["errata", "--format", "json"]);
    let page: Value = serde_json::from_str(&json).unwrap();
    let list = page["errata"].as_array().unwrap();
    let numbers: Vec<_> = list.iter().map(|e| e["number"].as_u64().unwrap()).collect();
    assert_eq!(numbers, (1..=17).collect::<Vec<_>>());
    assert!(list.iter().all(|e| e["established"] == true));
    assert!(run(&["errata", "11,3"]).1.contains("from 10 to 8.2"));
    let (code, out, err) = run(&["errata", "18"]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("`18` is unknown"));
}

#[test]
fn theorems_are_listed_in_both_forms() {
    let (code, out, _) = run(&["theorems"]);
    assert_eq!(code, 0);
    for number in ["7.2", "7.3", "7.4i", "7.4ii", "7.5i", "7.5ii", "7.6i", "7.6ii", "7.7", "7.8"] {
        assert!(out.lines().any(|l| l.starts_with(&format!("{number} "))), "{number}");
    }
    assert_eq!(out.matches("  paper  if ").count(), 10);
    assert_eq!(out.matches("  sharp  if ").count(), 10);
    let (_, json, _) = run(&["theorems", "7.8", "--format", "json"]);
    let page: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(page["theorems"][0]["sharp"]["weights"], "0 < eps < 1/(1 + cos(pi/(N-1)))");
    assert!(page["theorems"][0]["erratum"].as_str().unwrap().contains("8.2"));
}

#[test]
fn a_long_refutation_is_shown_by_its_ends() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("slow.toml");
    let text =
        "agents = 1\nstart = [\"x0 = 0\"]\nclaims = [\"x0 < 300\"]\n[rules]\n0 = \"x0 + 1\"\n";
    std::fs::write(&file, text).unwrap();
    let file = file.display().to_string();
    let start = ["refute", "--protocol", &file, "--steps", "400", "--start", "0"];
    let (code, out, err) = run(&start);
    assert_eq!(code, 1, "{err}");
    assert!(out.contains("fails at step 300") && out.contains("\n   ...\n"), "{out}");
    assert!(out.lines().count() < 50, "{out}");
}

#[test]
fn long_work_is_announced_before_it_begins() {
    let refute =
        |drones| run(&["refute", "7.4ii", "--eps", "1/4", "--steps", "1", "--drones", drones]).2;
    assert_eq!(refute("12"), "note: 7.4ii with up to 12 drones: this may take some minutes\n");
    assert_eq!(refute("4"), "");
    let (code, out, err) =
        run(&["settle", "--drones", "4", "--eps", "1e-8", "--within", "0.5", "--start", "0,0,0,1"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("proved  step 28768208 ") && out.contains(", c <= 1 - 10^-9"), "{out}");
    assert!(out.contains("true    step 20122103 the run itself"), "{out}");
}

#[test]
fn an_inconclusive_proof_names_the_flag_that_is_in_the_way() {
    let (code, out, _) = run(&["prove", "projection", "--eps", "0..1/2"]);
    assert_eq!(code, 3);
    assert!(out.contains("no strategy for this claim with --eps: without there is one"), "{out}");
    assert_eq!(run(&["prove", "projection"]).0, 0);
}

#[test]
fn not_applicable_is_a_result() {
    let (code, out, err) =
        run(&["trace", "scenarios/paper.toml", "--check", "all", "--form", "paper"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("7.2 (paper form) holds"), "{out}");
    assert!(out.contains("7.3 (paper form) is not applicable: it is about starts with "), "{out}");
    let refute = ["--activation", "--drones", "3", "--steps", "2"];
    let (code, out, err) = run(&[&["refute", "all"], &refute[..]].concat());
    assert_eq!((code, err.as_str()), (3, ""));
    assert!(out.contains("7.4i "), "{out}");
    assert!(
        out.contains("not applicable where drones skip updates") && out.contains(": 7.4ii, "),
        "{out}"
    );
    let (code, out, err) = run(&[&["refute", "7.2,7.5i"], &refute[..]].concat());
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("theorem: `7.5i` reads several placements"), "{err}");
}

#[test]
fn a_missing_file_keeps_no_other_from_being_checked() {
    let valid = "proofs/certificates/7.2-sharp.json";
    let (code, out, err) = run(&["check", "missing.json", valid]);
    assert_eq!(code, 74);
    assert!(
        out.contains("missing.json: not read\n") && out.contains(&format!("{valid}: valid")),
        "{out}"
    );
    assert!(err.contains("cannot read `missing.json`"), "{err}");
    let (code, out, _) = run(&["check", "missing.json", valid, "--format", "json"]);
    assert_eq!(code, 74);
    let page: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(page["verdicts"][0]["verdict"], "not read");
    assert_eq!(page["verdicts"][1]["verdict"], "valid");
}

#[test]
fn decimals_in_files_are_read_from_their_digits() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("digits.toml");
    std::fs::write(&path, "start = [0, 0.1000000000000000000001, 2]\neps = 1_0.5e-1\n").unwrap();
    let args = ["--steps", "0", "--format", "csv", "--numbers", "fraction"];
    let (code, out, err) = run(&[&["trace", path.to_str().unwrap()], &args[..]].concat());
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("1000000000000000000001/10000000000000000000000"), "{out}");
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    use std::io::Read;
    use std::process::{Command, Stdio};
    let program = cordon().get_program().to_owned();
    let mut child = Command::new(program)
        .args(["trace", "scenarios/long-line.toml", "--steps", "60", "--format", "csv"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut first = [0; 10];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    let ended = child.wait_with_output().unwrap();
    assert!(ended.status.success());
    assert_eq!(String::from_utf8(ended.stderr).unwrap(), "");
}
