//! `cordon trace` as a new user runs it.
use crate::common::run;
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
