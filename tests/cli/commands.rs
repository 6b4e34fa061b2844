//! The commands as a new user runs them: results, errors, exit codes.
use crate::common::{cordon, run};
use serde_json::Value;

const PAPER: [&str; 5] = ["trace", "--start", "0,10,20,30,100", "--eps", "0.2"];

fn trace(more: &[&str]) -> (i32, String, String) {
    run(&[&PAPER, more].concat())
}

#[test]
fn flags_and_file_say_the_same() {
    let numbers = ["--numbers", "fraction", "--format", "csv", "--steps", "9"];
    let (code, by_flags, _) = trace(&[&["--period", "4", "--tau", "0.05"], &numbers[..]].concat());
    let (_, by_file, _) = run(&[&["trace", "scenarios/paper.toml"], &numbers[..]].concat());
    assert_eq!(code, 0);
    assert_eq!(by_flags, by_file);
    assert_eq!(by_flags.lines().count(), 11);
    assert!(
        by_flags.ends_with("9,33,1.6500,0,6565786/390625,14922644/390625,25978938/390625,100\n")
    );
}

#[test]
fn flags_replace_fields_of_the_file() {
    let (code, out, _) = run(&["trace", "scenarios/paper.toml", "--eps", "1/2", "--steps", "1"]);
    assert_eq!(code, 0);
    assert!(out.contains("eps = 1/2"), "{out}");
    assert!(out.contains("60.0000"), "{out}");
}

#[test]
fn rows_are_selected_by_steps_or_ticks() {
    let steps = |out: &str| -> Vec<String> {
        let field = |l: &str| l.split(',').take(2).collect::<Vec<_>>().join(":");
        out.lines().skip(1).map(field).collect()
    };
    let csv = ["--period", "4", "--format", "csv"];
    let (_, out, _) = trace(&[&csv, &["--from", "3", "--to", "9", "--every", "3"][..]].concat());
    assert_eq!(steps(&out), ["3:9", "6:21", "9:33"]);
    let (_, out, _) = trace(&[&csv, &["--ticks", "6"][..]].concat());
    assert_eq!(steps(&out), ["0:0", "1:1", "1:2", "1:3", "1:4", "2:5", "2:6"]);
    let (_, out, _) = trace(&[&csv, &["--ticks", "5", "--phase", "last"][..]].concat());
    assert_eq!(steps(&out), ["0:0", "0:1", "0:2", "0:3", "1:4", "1:5"]);
}

#[test]
fn json_and_itf_are_well_formed() {
    let (code, out, _) = trace(&["--steps", "2", "--format", "json", "--check", "7.2,7.4"]);
    assert_eq!(code, 0);
    let page: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(page["schema"], "cordon-trace/1");
    assert_eq!(page["rows"][2]["positions"][2], "112/5");
    assert_eq!(page["rows"][2]["decimals"][2], "22.4000");
    let checked: Vec<_> =
        page["checks"].as_array().unwrap().iter().map(|c| c["theorem"].as_str().unwrap()).collect();
    assert_eq!(checked, ["7.2", "7.4i", "7.4ii"]);
    assert_eq!(page["checks"][0]["steps"], 3);

    let (code, out, _) = trace(&["--steps", "2", "--format", "itf"]);
    assert_eq!(code, 0);
    let page: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(page["#meta"]["format"], "ITF");
    assert_eq!(page["states"].as_array().unwrap().len(), 3);
    assert_eq!(page["states"][2]["x"][2]["num"]["#bigint"], "112");
    assert_eq!(page["states"][2]["x"][2]["den"]["#bigint"], "5");
    for name in page["vars"].as_array().unwrap() {
        assert!(page["states"][0].get(name.as_str().unwrap()).is_some());
    }
}

#[test]
fn checks_mark_rows_and_name_the_first_violation() {
    let (code, out, _) = trace(&["--check", "all", "--steps", "30"]);
    assert_eq!(code, 0, "{out}");
    assert_eq!(out.matches("holds at all 31 steps checked (this run only)").count(), 6, "{out}");
    assert_eq!(out.matches("its premise is met at none of the 31 steps").count(), 4, "{out}");

    let (code, out, err) =
        run(&["trace", "scenarios/paper-unstable.toml", "--check", "7.2", "--steps", "4"]);
    assert_eq!((code, err.as_str()), (1, ""));
    assert!(
        out.contains("at step 3 drones 1 and 2: X_1 = 1529/50 is not below X_2 = 647/25"),
        "{out}"
    );
    assert!(out.contains("no contradiction: the theorem is about 0 <= eps <= 1/2"), "{out}");

    let (code, out, _) = run(&[
        "trace",
        "--start",
        "0,1,2,2,4,5",
        "--eps",
        "0",
        "--check",
        "7.7",
        "--form",
        "paper",
        "--steps",
        "0",
    ]);
    assert_eq!(code, 1);
    assert!(
        out.contains("7.7 (paper form) fails at step 5 the sum of the positions: c^0 = 14"),
        "{out}"
    );
    assert!(!out.contains("no contradiction"), "eps = 0 is in the paper's range: {out}");
}

#[test]
fn a_plot_has_a_line_for_every_drone_and_fits_a_terminal() {
    let (code, out, _) = trace(&["--plot"]);
    assert_eq!(code, 0);
    assert!(out.contains("position against step"));
    let widest = out.lines().map(|l| l.chars().count()).max().unwrap();
    assert!(widest <= 80, "{widest}");
    assert!(
        out.lines().filter(|l| l.chars().any(|c| ('\u{2801}'..='\u{28ff}').contains(&c))).count()
            >= 15
    );
}

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

/// Bad input: exit 2 (74 where a file is missing), nothing on stdout, one line that names the
/// field and what was given.
#[test]
fn bad_input_is_named() {
    let start = "0,10,20,30,100";
    let table: &[(&[&str], i32, &[&str])] = &[
        (&["trace", "--start", start, "--eps", "1/0"], 2, &["eps", "`1/0`", "divides by zero"]),
        (&["trace", "--start", start, "--eps", "abc"], 2, &["eps", "`abc`", "expected"]),
        (&["trace", "--start", start], 2, &["weight (eps) is missing"]),
        (&["trace", "--eps", "1/5"], 2, &["start is missing"]),
        (&["trace"], 2, &["start is missing"]),
        (&["trace", "--start", "0,100", "--eps", "1/5"], 2, &["drones", "`2`", "expected 3"]),
        (
            &["trace", "--drones", "4", "--start", start, "--eps", "1/5"],
            2,
            &["start", "5 positions", "4 drones"],
        ),
        (
            &["trace", "--drones", "9999999", "--spread-to", "4", "--max", "9", "--eps", "1"],
            2,
            &["drones", "`9999999`"],
        ),
        (&["trace", "--start", "0,NaN,100", "--eps", "1/5"], 2, &["start: drone 1", "`NaN`"]),
        (
            &["trace", "--start", "0,1,2", "--min", "5", "--eps", "1/5"],
            2,
            &["max", "more than min"],
        ),
        (
            &["trace", "--start", "0,1,2", "--max", "5", "--eps", "1/5"],
            2,
            &["start", "drone 2", "`2`", "max"],
        ),
        (&["trace", "--start", "2,1,0", "--eps", "1/5"], 2, &["--start: the last drone", "`0`"]),
        (
            &["trace", "--start", "0,30,20,100", "--eps", "1/5", "--check", "7.2"],
            2,
            &["start", "7.2", "X_0 < X_1"],
        ),
        (
            &["trace", "--start", start, "--eps", "1/5", "--check", "7.3", "--form", "paper"],
            2,
            &["7.3", "min + l"],
        ),
        (
            &["trace", "--start", start, "--eps", "1/5", "--check", "7.9"],
            2,
            &["`7.9`", "expected `all`"],
        ),
        (
            &["trace", "scenarios/consensus.toml", "--check", "7.2"],
            2,
            &["check", "`coverage`", "`consensus`"],
        ),
        (
            &["trace", "--start", start, "--eps", "1/5", "--steps", "100000000000"],
            2,
            &["steps", "`100000000000`", "bits"],
        ),
        (
            &["trace", "--start", start, "--eps", "1/5", "--ticks", "18446744073709551615"],
            2,
            &["ticks", "18446744073709551615"],
        ),
        (
            &["trace", "--start", start, "--eps", "1/5", "--from", "9", "--to", "3"],
            2,
            &["from", "`9`"],
        ),
        (&["trace", "--start", start, "--eps", "1/5", "--every", "0"], 2, &["every", "`0`"]),
        (&["trace", "--start", start, "--eps", "1/5", "--period", "0"], 2, &["period", "`0`"]),
        (
            &["trace", "--start", start, "--eps", "1/5", "--phase", "middle"],
            2,
            &["phase", "`middle`"],
        ),
        (&["trace", "--start", start, "--eps", "1/5", "--tau", "-1"], 2, &["tau", "`-1`"]),
        (
            &["trace", "--start", start, "--eps", "1/5", "--digits", "10001"],
            2,
            &["digits", "`10001`"],
        ),
        (
            &["trace", "--start", start, "--eps", "1/5", "--steps", "0", "--plot"],
            2,
            &["plot", "two rows"],
        ),
        (
            &["trace", "--start", start, "--eps", "1/5", "--protocol", "swarm"],
            2,
            &["protocol", "`swarm`"],
        ),
        (
            &["trace", "--start", start, "--eps", "1/5", "--graph", "ring"],
            2,
            &["graph", "`coverage`"],
        ),
        (
            &["trace", "scenarios/consensus.toml", "--min", "0"],
            2,
            &["--min: not a field of protocol `consensus`"],
        ),
        (
            &["trace", "scenarios/faults.toml"],
            2,
            &["scenarios/faults.toml:", "fault: expected none", "`cordon cosim`"],
        ),
        (
            &["cosim", "scenarios/paper.toml", "--tau", "1000"],
            2,
            &["--tau: `1000`: expected at most the length of the run"],
        ),
        (
            &["cosim", "scenarios/paper.toml", "--master", "slave"],
            2,
            &["error: --master: `slave`: expected"],
        ),
        (
            &["trace", "scenarios/paper.toml", "--drones", "7"],
            2,
            &["scenarios/paper.toml:", ": start: 5 positions given"],
        ),
        (&["trace", "no-such-file.toml"], 74, &["cannot read `no-such-file.toml`"]),
        (&["trace", "scenarios"], 74, &["cannot read `scenarios`"]),
        (
            &["local", "scenarios/paper.toml", "--exchange-every", "0"],
            2,
            &["exchange-every", "`0`"],
        ),
        (&["local", "scenarios/paper.toml", "--ratio", "-1"], 2, &["ratio", "`-1`"]),
        (&["local", "scenarios/paper.toml", "--ticks", "100001"], 2, &["ticks", "`100001`"]),
        (&["theorems", "8.1"], 2, &["`8.1`"]),
        (&["fly"], 2, &["fly"]),
        (&[], 2, &["Usage"]),
    ];
    for (args, code, words) in table {
        let (found, out, err) = run(args);
        assert_eq!(found, *code, "{args:?}: {err}");
        assert_eq!(out, "", "{args:?}");
        for word in *words {
            assert!(err.contains(word), "{args:?}: {err}");
        }
        assert!(!err.contains("panicked"), "{err}");
    }
    assert_eq!(table.len(), 40);
}

/// What does not apply is a result where all were asked for, and comes before any work where one
/// was named.
/// What the checker cannot read for its length is no fault of the search; and stdout has the result
/// or nothing.
#[test]
fn numbers_beyond_the_checkers_limits_are_named() {
    let long = |digits: usize| format!("1.{}1", "0".repeat(digits));
    for format in ["text", "json"] {
        let eps = long(2_200);
        let calls: [&[&str]; 2] = [
            &["refute", "7.2", "--drones", "4", "--eps", &eps, "--format", format],
            &["settle", "--drones", "5", "--within", "1", "--eps", &eps, "--format", format],
        ];
        for call in calls {
            let (code, out, err) = run(call);
            assert_eq!((code, out.as_str()), (2, ""), "{err}");
            assert!(err.contains("beyond the limits of the independent checker"), "{err}");
            assert!(err.contains("more than 2100 characters") && !err.contains("fault"), "{err}");
        }
        let eps = long(20);
        let (code, out, _) =
            run(&["refute", "7.2", "--drones", "4", "--eps", &eps, "--format", format]);
        assert!(code == 1 && !out.is_empty());
    }
    let (code, out, _) = run(&["prove", "7.2", "--eps", &format!("0..0.{}1", "0".repeat(2_200))]);
    assert_eq!(code, 3);
    assert!(out.contains("beyond the limits of the independent checker"), "{out}");
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

/// Scenario files: the message has file, line and column.
#[test]
fn bad_scenario_files_are_named_with_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.toml");
    let table = [
        ("start = [0, 1, 2]\nwieght = 0.2\n", ":2:1: unknown field `wieght`"),
        ("start = [0, 1, nan]\nweight = 0.2\n", ":1:16: start: `nan`"),
        ("start = [0, 1, 2]\nweight = \"1/0\"\n", ":2:10: weight: `1/0` divides by zero"),
        ("start = [0, 1, 2]\nweight = [1]\n", ":2:10: weight: expected a number, found array"),
        ("start = [0, 1, 2]\nweight = 0.2\nweight = 0.3\n", ":3:1: "),
        ("start = [0, 1, 2\n", ":"),
        ("start = [0, 1, 2]\nweight = 0.2\nphase = \"third\"\n", ":3:9: phase: `third`"),
        (
            "start = [0, 1, 2]\nweight = 0.2\nperiod = -1\n",
            ":3:10: period: `-1`: expected a whole number",
        ),
        (
            "start = [0, 1, 2]\nweight = 0.2\ndrones = \"3\"\n",
            ":3:10: drones: `3`: expected a whole number",
        ),
        ("start = [0, 1, 2]\nweight = 0.2\nperiod = 0\n", ":3:10: period: `0`"),
        (
            "start = [0, 1, 2]\nweight = 0.2\n[flight]\nmaster = 3\n",
            ":4:10: flight.master: `3`: expected a text in quotes",
        ),
        ("start = [0, 1, 2]\nspread_to = 1\nweight = 0.2\n", "expected one of them"),
        ("start = [0, 1]\nweight = 0.2\n", "drones: `2`"),
        (
            "protocol = \"consensus\"\ngraph = [[0, 3]]\nstart = [0, 1, 2]\nweight = 0.2\n",
            "edge `[0, 3]`",
        ),
        (
            "protocol = \"consensus\"\ngraph = [[0]]\nstart = [0, 1, 2]\nweight = 0.2\n",
            ":2:9: graph",
        ),
        ("protocol = \"consensus\"\ngraph = \"star\"\nstart = [0, 1, 2]\nweight = 0.2\n", "`star`"),
        ("protocol = \"formation\"\nstart = [0, 1, 2]\nweight = 0.2\n", "displacement is missing"),
        (
            "displacement = [1]\nstart = [0, 1, 2]\nweight = 0.2\n",
            "not a field of protocol `coverage`",
        ),
        ("not toml at all", ":1:"),
    ];
    for (text, words) in table {
        std::fs::write(&path, text).unwrap();
        let (code, out, err) = run(&["trace", path.to_str().unwrap()]);
        assert_eq!((code, out.as_str()), (2, ""), "{text}");
        assert!(err.contains("bad.toml") && err.contains(words), "{text}: {err}");
    }
    std::fs::write(&path, b"start = [0, 1, \xff]").unwrap();
    let (code, _, err) = run(&["trace", path.to_str().unwrap()]);
    assert_eq!(code, 2);
    assert!(err.contains("expected UTF-8 text"));
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
fn every_command_has_an_example_and_completions_offer_numbers_and_files() {
    let commands = [
        "trace",
        "local",
        "swarm",
        "cosim",
        "figures",
        "replay",
        "fmu",
        "fmu export",
        "theorems",
        "errata",
        "sweep",
        "sweep merge",
        "sweep status",
        "refute",
        "prove",
        "check",
        "separation",
        "threshold",
        "settle",
        "export",
        "export smt2",
        "export pvs",
        "export into-cps",
        "export ssp",
        "completions",
    ];
    for command in commands {
        let args: Vec<&str> = command.split(' ').chain(["--help"]).collect();
        let (code, out, _) = run(&args);
        assert_eq!(code, 0, "{command}");
        let examples = out.split("Example").nth(1).unwrap_or_else(|| panic!("{command}: {out}"));
        assert!(examples.contains(&format!("cordon {command}")) || command == "export", "{out}");
    }
    // What has a limit says so, and is held to it.
    for (command, limit, beyond) in [
        ("trace", "10,000 decimal places", "trace scenarios/paper.toml --digits 10001"),
        ("trace", "10,000,000 rows", "trace scenarios/paper.toml --steps 10000001"),
        ("local", "100,000 ticks", "local scenarios/paper.toml --ticks 100001"),
        ("swarm", "100,000,000 drones", "swarm --drones 100000001"),
        ("swarm", "1,000,000,000,000 drone", "swarm --drones 1000 --steps 1000000001"),
        ("cosim", "67,108,864 positions", "cosim scenarios/paper.toml --duration 400000"),
        ("sweep", "3 to 64 drones", "sweep 7.2 --drones 65"),
        ("sweep", "100,000 steps", "sweep 7.2 --steps 100001"),
        ("sweep", "1,000,000 weights", "sweep 7.2 --max-denominator 2000"),
        ("sweep", "1,024 threads", "sweep 7.2 --threads 1025"),
        ("refute", "3 to 50 drones", "refute 7.2 --drones 51"),
        ("refute", "600 positions", "refute 7.2 --drones 50 --delay 12"),
        ("refute", "1,000 steps", "refute 7.2 --steps 1001"),
        ("refute", "denominators up to 100", "refute 7.2 --denominators 101"),
        ("prove", "one N up to 1,000,000", "prove 7.2 --drones 1000001"),
        ("threshold", "3 to 1,000 drones", "threshold --property bound --drones 1001"),
        ("threshold", "1,000 decimal", "threshold --property bound --drones 5 --digits 1001"),
        ("settle", "3 to 10,000 drones", "settle --drones 10001 --eps 1/4 --within 1"),
        ("export smt2", "3 to 9 drones", "export smt2 7.2 --drones 10"),
        ("export smt2", "8 steps", "export smt2 7.2 --drones 4 --negate --steps 9"),
    ] {
        let args: Vec<&str> = command.split(' ').chain(["--help"]).collect();
        let (_, help, _) = run(&args);
        let words = help.split_whitespace().collect::<Vec<_>>().join(" ");
        let limits = words.split("Limits: ").nth(1).unwrap_or_else(|| panic!("{command}"));
        assert!(limits.contains(limit), "{command}: {limits}");
        let (code, out, err) = run(&beyond.split(' ').collect::<Vec<_>>());
        assert_eq!((code, out.as_str()), (2, ""), "{beyond}: {err}");
    }
    // All there are, but those that moved and those about the program itself.
    let (_, help, _) = run(&["--help"]);
    let listed = help.split("Commands:").nth(1).unwrap().split("Options:").next().unwrap();
    let names = listed.lines().filter(|l| l.starts_with("  ") && !l.starts_with("   "));
    let names: Vec<_> = names.filter_map(|l| l.split_whitespace().next()).collect();
    for name in names {
        assert!(commands.contains(&name) || ["man", "help"].contains(&name), "{name}");
    }
    let (code, fish, _) = run(&["completions", "fish"]);
    assert_eq!(code, 0);
    assert!(fish.lines().any(|l| l.starts_with("7.4ii")), "numbers of theorems");
    let (_, zsh, _) = run(&["completions", "zsh"]);
    assert!(zsh.contains("_files"), "files where files are meant");
    assert!(zsh.contains("7.4ii"));
}

#[test]
fn completions_and_manual_are_printed() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let (code, out, _) = run(&["completions", shell]);
        assert!(code == 0 && out.contains("trace"), "{shell}");
    }
    let (code, out, _) = run(&["man"]);
    assert_eq!(code, 0);
    for command in ["trace", "local", "errata", "theorems"] {
        assert!(
            out.contains(&format!("cordon\\-{command}"))
                || out.contains(&format!("cordon-{command}"))
        );
    }
    assert!(out.contains("Exit codes"));
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

/// clap waives `requires` where the other flag conflicts with a third that is given, and says nothing of the
/// flag that is ignored: the program keeps a table of its own (`src/cli/edge.rs`).
#[test]
fn no_flag_leaves_what_it_needs_to_clap() {
    let mut folders = vec![std::path::PathBuf::from("src/cli")];
    let mut read = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                assert!(
                    !std::fs::read_to_string(&path).unwrap().contains("requires = "),
                    "{path:?}"
                );
                read += 1;
            }
        }
    }
    assert!(read >= 40, "{read} files");
}
