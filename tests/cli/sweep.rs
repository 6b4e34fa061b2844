//! `cordon sweep` and `cordon sweep merge` as a user runs them.
use std::fs;

use super::sweep_files::text;
use crate::common::run;
use serde_json::Value;

/// Runs `cordon sweep ARGS`, the arguments in one line.
pub(super) fn sweep(args: &str) -> (i32, String, String) {
    let args: Vec<_> = std::iter::once("sweep").chain(args.split_whitespace()).collect();
    run(&args)
}

/// Bad input: exit code 2, nothing on stdout, one error that says this.
#[track_caller]
pub(super) fn refused(args: &str, says: &str) {
    let (code, out, err) = sweep(args);
    assert_eq!((code, out.as_str()), (2, ""), "{args}: {err}");
    assert!(err.contains(says), "{args}: {err}");
    assert!(err.starts_with("error: "), "{args}: {err}");
}

pub(super) const SMALL: &str =
    "7.2,7.3,7.6ii --form both --drones 3..5 --max-denominator 4 --grid 6 --steps 5";

#[test]
fn a_theorem_that_holds() {
    let (code, out, err) = sweep("7.2 --form sharp --drones 3..4 --eps 1/3,0.5 --grid 6 --steps 9");
    assert_eq!(code, 0);
    let expected = "\
N = 3..4, eps = 1/3, 1/2, k = 0..9
every start on a grid of 6 units; each theorem in its own range of eps

theorem  form   verdict  items  vacuous  starts  cases  non-vacuous  violations  evidence
7.2      sharp  holds        4        0      30    300          300           0  exhaustive on a grid
";
    assert_eq!(out, expected);
    assert!(err.starts_with("594 drone updates (and 396 by symmetry) in "), "{err}");
    assert!(!err.contains("reproduce"), "{err}");
}

/// A golden counterexample, and the replay that the program prints for it.
#[test]
fn a_theorem_that_fails_beyond_its_range() {
    let (code, out, _) =
        sweep("7.2 --form sharp --drones 3..6 --eps 3/5 --any-weight --grid 12 --steps 4");
    assert_eq!(code, 1);
    let expected = "\
7.2 (sharp form) is refuted in 3 of 4 work items; the simplest counterexample:
  N = 4, eps = 3/5, start (0, 1, 7, 8): at step 1 drones 1 and 2: X_1 = 4 is not below X_2 = 4
  cordon trace --drones 4 --start 0,1,7,8 --eps 3/5 --steps 1 --check 7.2
";
    assert!(out.ends_with(expected), "{out}");
    let replay: Vec<_> = expected.lines().last().unwrap().split_whitespace().skip(1).collect();
    let (code, out, _) = run(&replay);
    assert_eq!(code, 1, "{out}");
    assert!(out.contains("drones 1 and 2: X_1 = 4 is not below X_2 = 4"), "{out}");
}

/// The counterexample of a complete sweep is found on rays, then made as short as it can be:
/// with gaps 1, g, 1 drones 1 and 2 meet when 2 * 501 <= 2 g, so that g = 501.
#[test]
fn counterexamples_are_minimal() {
    let (code, out, _) =
        sweep("7.2 --form sharp --drones 3..6 --eps 0.501 --any-weight --complete");
    assert_eq!(code, 1);
    assert!(out.contains("N = 4, eps = 501/1000, start (0, 1, 502, 503): at step 1 "), "{out}");
}

/// Every counterexample that a sweep prints is one to `cordon trace`.
#[test]
fn counterexamples_are_replayable() {
    let mut replayed = 0;
    for args in [
        "--form both --drones 3..6 --max-denominator 5 --any-weight --grid 6 --steps 6",
        "--form both --drones 3..6 --max-denominator 5 --any-weight --complete --steps 6",
    ] {
        let (code, out, _) = sweep(args);
        assert_eq!(code, 1);
        let before = replayed;
        for line in out.lines().filter_map(|l| l.strip_prefix("  cordon ")) {
            let (code, out, err) = run(&line.split_whitespace().collect::<Vec<_>>());
            assert_eq!(code, 1, "{line}\n{out}{err}");
            assert!(out.contains("fails at step"), "{line}\n{out}");
            replayed += 1;
        }
        assert_eq!(replayed - before, out.matches(") is refuted in ").count());
    }
    assert_eq!(replayed, 32);
}

#[test]
fn vacuous_claims_are_not_called_true() {
    let (code, out, _) = sweep("7.4ii --form paper --drones 3..4 --eps 1/3");
    assert_eq!(code, 3);
    assert!(out.contains("7.4ii    paper  vacuous"), "{out}");
    assert!(out.ends_with("is vacuous: no case met its premise, nothing was learnt\n"), "{out}");
    // One theorem without a weight in its range, beside one that has some.
    let (code, out, _) = sweep("7.2,7.8 --form sharp --drones 4 --eps 3/5 --steps 3");
    assert_eq!(code, 3);
    assert!(out.contains("7.2 (sharp form): no weight of the sweep is in its range"), "{out}");
    assert!(out.contains("7.8      sharp  holds"), "{out}");
}

#[test]
fn undecided_claims_say_why() {
    let (code, out, _) = sweep("7.8 --form paper --drones 4 --eps 2/3 --complete --steps 3");
    assert_eq!(code, 3);
    assert!(out.contains("7.8      paper  undecided"), "{out}");
    assert!(out.contains("I - A^2 is not positive definite"), "{out}");
}

#[test]
fn complete_sweeps_say_so() {
    let (code, out, err) = sweep("7.2,7.8 --form sharp --complete --drones 3..8 --steps 12");
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("all real starts"), "{out}");
    assert_eq!(out.matches("complete for all starts").count(), 2, "{out}");
    assert!(err.contains("work items in "), "{err}");
}

#[test]
fn samples_end_with_the_line_that_repeats_them() {
    let (code, out, err) = sweep("7.3 --drones 9 --eps 2/5 --sample 50 --grid 40 --form sharp");
    assert_eq!(code, 0);
    assert!(out.contains("sampled"), "{out}");
    let line = err.lines().last().unwrap().strip_prefix("reproduce: cordon sweep ").unwrap();
    assert!(line.contains("--sample 50 --seed "), "{line}");
    let (code, again, err) = sweep(line);
    assert_eq!((code, again), (0, out));
    assert!(err.ends_with(&format!("reproduce: cordon sweep {line}\n")), "{err}");
    let (_, other, _) = sweep("7.3 --drones 9 --eps 2/5 --sample 50 --seed 7 --grid 40");
    assert!(other.contains("seed 7"), "{other}");
}

#[test]
fn json_has_a_schema() {
    let (code, out, _) = sweep(&format!("{SMALL} --format json"));
    assert_eq!(code, 1);
    let page: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(page["schema"], "cordon-sweep-report/1");
    assert_eq!(page["claims"].as_array().unwrap().len(), 6);
    assert_eq!(page["claims"][4]["theorem"], "7.6ii");
    assert_eq!(page["claims"][4]["verdict"], "refuted");
    assert_eq!(
        page["claims"][4]["counterexample"]["replay"],
        "cordon trace --drones 3 --start 0,1,3 --eps 0 --steps 1 --check 7.6ii --form paper"
    );
    let findings = page["findings"].as_array().unwrap();
    let cases: u64 = findings.iter().map(|f| f["cases"].as_u64().unwrap()).sum();
    let claimed: u64 = page["claims"]
        .as_array()
        .unwrap()
        .iter()
        .map(|c| c["counts"]["cases"].as_u64().unwrap())
        .sum();
    assert_eq!(cases, claimed);
    assert!(cases > 5_000, "{cases}");
}

#[test]
fn threads_change_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let mut seen = Vec::new();
    for threads in [1, 2, 5] {
        let path = folder.path().join(format!("{threads}.jsonl"));
        let args = "--drones 3..6 --max-denominator 5 --any-weight --grid 16 --steps 3";
        let (code, out, _) = sweep(&format!(
            "7.2,7.3,7.5i --form sharp {args} --threads {threads} --out {}",
            path.display()
        ));
        assert_eq!(code, 1);
        seen.push((out, text(&path)));
    }
    assert!(seen.iter().all(|s| *s == seen[0]));
    assert!(seen[0].1.lines().count() > 100);
}

#[test]
fn shards_partition_the_sweep_and_merge_to_it() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let (code, whole, _) = sweep(&format!("{SMALL} --out {}", at("whole").display()));
    assert_eq!(code, 1);
    let mut lines = 0;
    for i in 1..=3 {
        let (_, out, _) =
            sweep(&format!("{SMALL} --shard {i}/3 --out {}", at(&i.to_string()).display()));
        assert!(out.contains(&format!("part {i} of 3: ")), "{out}");
        lines += text(&at(&i.to_string())).lines().count() - 1;
    }
    assert_eq!(lines, text(&at("whole")).lines().count() - 1);
    let merge = |names: &[&str]| {
        let files: Vec<_> = names.iter().map(|n| at(n).display().to_string()).collect();
        sweep(&format!("merge {} --out {}", files.join(" "), at("merged").display()))
    };
    // The order of the files does not matter.
    let (code, out, err) = merge(&["2", "3", "1"]);
    assert_eq!((code, &out), (1, &whole), "{err}");
    assert_eq!(text(&at("merged")), text(&at("whole")));
    let refused = |names: &[&str], says: &str| {
        fs::remove_file(at("merged")).ok();
        let (code, out, err) = merge(names);
        assert_eq!((code, out.as_str()), (2, ""), "{err}");
        assert!(err.contains(says), "{err}");
        assert!(!at("merged").exists());
    };
    refused(&["1", "3"], "work items are in no file, the first of them item 0 (7.2 paper, N = 3");
    refused(&["1", "2", "3", "2"], "work item 0 (7.2 paper, N = 3, eps = 0) is in `");
    refused(&["whole", "1"], "work item 1 (7.2 paper, N = 3, eps = 1/4) is in `");
    // Another sweep.
    sweep(&format!("{SMALL} --shard 3/3 --any-weight --out {}", at("other").display()));
    refused(&["1", "2", "other"], "are parts of different sweeps: ");
    // An unfinished part.
    let part = text(&at("3"));
    fs::write(at("torn"), &part[..part.len() - 5]).unwrap();
    refused(
        &["1", "2", "torn"],
        "1 of 57 work items are in no file, the first of them item 55 (7.6ii sharp, N = 5",
    );
    // A finding in the place of another.
    let moved = part.replace("\"drones\":3", "\"drones\":4");
    fs::write(at("moved"), moved).unwrap();
    refused(&["1", "2", "moved"], "is about something else: expected (7.2 sharp, N = 3, eps = 0)");
}

#[test]
fn a_first_try_says_that_its_refutations_were_expected() {
    let (code, out, _) = sweep("7.2,7.6ii --drones 3 --grid 4 --steps 5");
    assert_eq!((code, out.contains("refuted")), (0, false), "sharp forms: {out}");
    let (code, out, _) = sweep("7.2,7.6ii --drones 3 --grid 4 --steps 5 --form both");
    assert_eq!(code, 1);
    assert!(
        out.contains("expected: as printed, 7.6ii fails beyond the range in which it is true"),
        "{out}"
    );
    assert!(out.ends_with("`cordon sweep 7.6ii` sweeps the sharp forms, which hold\n"), "{out}");
    let (code, out, _) = sweep("7.2 --form sharp --eps 3/5 --any-weight --drones 4");
    assert_eq!((code, out.contains("expected:")), (1, false));
    let (code, _, err) = sweep("7.2 7.3");
    assert_eq!(code, 2);
    assert!(err.contains("tip: numbers of theorems are separated by commas: 7.2,7.3"), "{err}");
}

#[test]
fn bad_input_is_refused() {
    refused("9.9", "theorem: `9.9` is unknown");
    refused(
        "7.2 --drones 2..4",
        "drones: `2..4`: expected a number from 3 to 64, or a range like 3..7",
    );
    refused("7.2 --drones 5..4", "drones: `5..4`");
    refused("7.2 --drones 3..65", "drones: `3..65`");
    refused("7.2 --drones many", "drones: `many`: expected a number from 3 to 64");
    refused("7.2 --eps 1/0", "eps: `1/0` divides by zero");
    refused("7.2 --eps abc", "eps: `abc` is not a number");
    refused("7.2 --eps nan", "eps: `nan` is not a number");
    refused("7.2 --eps-range 1/2,1", "eps-range: `1/2,1` is not a number");
    refused("7.2 --eps-range 1..0", "eps-range: `1..0`: expected a range that is not empty");
    refused("7.2 --eps-range 1/7..1/7 --max-denominator 5", "eps: no weight is in the range");
    refused("7.2 --max-denominator 0", "max-denominator: `0`: expected at least 1");
    refused("7.2 --max-denominator 4000000", "max-denominator: `4000000`: expected at most");
    refused("7.2 --eps 1/3 --max-denominator 3", "cannot be used with");
    refused("7.2 --form paper --eps 2/5", "eps: no weight is in the range of 7.2");
    refused("7.2 --grid 0", "grid: `0`: expected at least 1");
    refused("7.2 --grid 5 --complete", "cannot be used with");
    refused("7.2 --sample 5 --complete", "cannot be used with");
    refused("7.2 --sample 0", "sample: `0`: expected at least 1");
    refused("7.2 --seed 5", "--sample");
    refused(
        "7.2 --drones 20 --grid 4000000000",
        "grid: the sweep has more than 2^64 drone updates",
    );
    refused("7.2 --steps 100001", "steps: `100001`: expected at most 100000");
    refused("7.2 --steps=-1", "--steps");
    refused("7.2 --threads 0", "threads: `0`: expected 1 to 1024");
    refused("7.2 --threads 99999", "threads: `99999`");
    for shard in ["0/3", "4/3", "1", "x/2", "1/0", "-1/2"] {
        refused(&format!("7.2 --shard={shard}"), &format!("shard: `{shard}`: expected I/N"));
    }
    refused("7.2 --eps 1/3 --shard 7/9", "shard: `7/9`: the sweep has fewer work items");
    refused("merge", "required");
    refused("merge Cargo.toml", "`Cargo.toml`, line 1: expected the header of a result file");
}
