//! The answers of solvers to `cordon export smt2 --negate`, replayed.

use std::io::Write as _;
use std::process::{Command, Stdio};

pub(super) fn answered(args: &[&str], answer: &str) -> (Option<i32>, String, String) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_cordon"))
        .args(args)
        .args(["--answer", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A run that refuses its arguments does not read on.
    let _ = child.stdin.take().unwrap().write_all(answer.as_bytes());
    let out = child.wait_with_output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (out.status.code(), text(out.stdout), text(out.stderr))
}

const NEGATED: [&str; 6] = ["export", "smt2", "7.2", "--drones", "4", "--negate"];

fn model(eps: &str, x1: &str, x2: &str) -> String {
    format!(
        "sat\n((min 0.0)\n (max 3.0) (eps {eps})\n (x0_0 0.0) (x1_0 {x1}) (x2_0 {x2}) (x3_0 3.0))\n"
    )
}

#[test]
fn a_true_model_is_replayed() {
    let (code, out, _) = answered(&NEGATED, &model("(/ 3.0 4.0)", "(/ 1.0 8.0)", "2.0"));
    assert_eq!(code, Some(1));
    assert_eq!(
        out,
        "refuted: 7.2 (sharp form) fails at step 1 drones 1 and 2: X_1 = 23/16 is not below X_2 = 43/32 (by exact replay)\n\
         replay: cordon trace --min=0 --max=3 --eps=3/4 --start=0,1/8,2,3 --steps=1 --check=7.2 --form=sharp\n"
    );
}

#[test]
fn a_false_model_is_not_believed() {
    for (answer, why) in [
        (model("(/ 1.0 2.0)", "1.0", "2.0"), "its weight is none of those asked about"),
        (model("1.0", "2.0", "1.0"), "its start does not meet the hypothesis"),
        (model("(/ 3.0 4.0)", "1.0", "2.0"), "the conclusion holds at every step looked at"),
    ] {
        let (code, out, _) = answered(&NEGATED, &answer);
        assert_eq!(code, Some(3));
        assert_eq!(out, format!("the solver's model is not a counterexample: {why}\n"));
    }
    assert_eq!(answered(&NEGATED, "unsat\n").0, Some(0));
    assert_eq!(answered(&NEGATED, "unknown\n").0, Some(3));
    assert_eq!(answered(&NEGATED, "timeout\n").0, Some(3));
}

#[test]
fn hostile_answers_are_refused() {
    let deep = format!("sat\n{}", "(".repeat(100_000));
    let unsolved = model("(root-obj (+ (^ x 2) (- 2)) 1)", "1.0", "2.0");
    let zero = model("(/ 1.0 0.0)", "1.0", "2.0");
    let huge = model("1e999999999", "1.0", "2.0");
    for (answer, said) in [
        ("", "error: solver's answer: ``: expected `sat`, `unsat` or `unknown` first\n"),
        ("(error \"x\")", "error: solver's answer: `(error`: expected"),
        ("sat", "error: solver's model: expected values after `sat`"),
        ("sat ((min 0.0))", "error: solver's model: expected a value of `max`"),
        ("sat ((min", "error: solver's model: expected a closing parenthesis"),
        ("sat )", "error: solver's model: expected a value"),
        (&deep, "error: solver's model: expected a value nested less deeply"),
        (&unsolved, "error: solver's model: expected a rational value (an irrational one"),
        (&zero, "error: solver's model: expected a quotient by other than zero"),
        (&huge, "error: solver's value: `1e999999999` has an exponent beyond 10000"),
    ] {
        let (code, out, error) = answered(&NEGATED, answer);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{error}");
        assert!(error.starts_with(said), "{error}");
    }
    let (code, _, error) =
        answered(&["export", "smt2", "7.2", "--drones", "4..5", "--negate"], "unsat");
    assert_eq!(code, Some(2));
    assert!(error.starts_with("error: --answer: expected one claim and one number of drones"));
}
