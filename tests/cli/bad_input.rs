//! Bad input is named, with its place.
use crate::common::run;

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
    assert!(err.contains("text of another encoding: expected a scenario, which is UTF-8 text"));
}
