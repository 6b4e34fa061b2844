//! Protocol files in the commands that run a protocol.
use std::fs;

use crate::common::run;
use crate::common::schema::{meets, parsed};
use crate::common::tools::has_tool;

fn call(line: &str) -> (i32, String, String) {
    let args: Vec<&str> = line.split(' ').collect();
    run(&args)
}

const COVERAGE: &str = "--protocol scenarios/own/coverage.toml --start 0,1/10,1/5,3/10,1 --eps 1/5";
const LATE: &str = "--protocol scenarios/own/coverage-late.toml --start 0,1/10,1/5,1";
const PLATOON: &str = "--protocol scenarios/own/platoon.toml --start 0,0,1/4,0,0,0,1/4,0,0,0";

#[test]
fn traces_are_those_of_the_built_in_protocol() {
    let mut compared = 0;
    let built_in = COVERAGE.replace("scenarios/own/coverage.toml", "coverage");
    for rest in ["--steps 9", "--ticks 9 --period 3", "--at 5,3000", "--at 7 --engine digits"] {
        for format in ["csv", "csv --numbers fraction"] {
            if rest.contains("digits") && format.contains("fraction") {
                continue;
            }
            let own = call(&format!("trace {COVERAGE} {rest} --format {format}"));
            let wanted = call(&format!("trace {built_in} {rest} --format {format}"));
            assert_eq!(own.0, 0, "{}", own.2);
            assert_eq!(own.1, wanted.1, "{rest} {format}");
            compared += 1;
        }
    }
    assert_eq!(compared, 7);
}

#[test]
fn choices_are_said_on_stderr_and_drawn_from_the_seed_that_is_named() {
    let (code, usual, said) = call(&format!("trace {LATE} --steps 6"));
    assert_eq!((code, said.trim()), (0, "scenarios/own/coverage-late.toml: no message is late"));
    let (_, drawn, said) = call(&format!("trace {LATE} --steps 6 --seed 7"));
    assert!(said.contains("choices drawn from --seed 7"), "{said}");
    assert!(drawn.contains("choices drawn from --seed 7"), "{drawn}");
    assert_eq!(call(&format!("trace {LATE} --steps 6 --seed 7")).1, drawn);
    let rows = |text: &str| text.lines().skip(3).map(str::to_owned).collect::<Vec<_>>();
    assert_ne!(rows(&usual), rows(&drawn));
    let (code, _, said) = call(&format!("trace {COVERAGE} --steps 2 --seed 7"));
    assert_eq!(code, 2);
    assert!(said.contains("a protocol file that leaves choices"), "{said}");
}

#[test]
fn claims_are_checked_at_every_step() {
    let (code, out, _) = call(&format!("trace {COVERAGE} --steps 9 --check all"));
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("claim 2, `0 <= x[i] <= 1`, holds at all 10 steps checked"), "{out}");
    let hasty = "--protocol scenarios/own/hasty-coverage.toml --start 0,1/10,9/10,19/20,1";
    let (code, out, _) = call(&format!("trace {hasty} --set eps=7/10 --steps 2 --check 3"));
    assert_eq!(code, 1, "{out}");
    assert!(out.contains("claim 3, `x[i] < x[i+1]`, fails at step 1, i = 1: missed by"), "{out}");
    assert!(out.contains("the file is about eps from 0 to 3/5"), "{out}");
    let refused = [
        (format!("trace {hasty} --set eps=3/5 --check 4"), "numbers of the file's claims, 1 to 3"),
        (format!("trace {hasty} --set eps=3/5 --check 7.2"), "numbers of the file's claims"),
        (
            format!("trace {PLATOON} --check all --steps 1").replace("0,0,1/4", "0,1,1/4"),
            "expected a start that the protocol assumes",
        ),
    ];
    for (line, wanted) in &refused {
        let (code, _, said) = call(line);
        assert_eq!(code, 2, "{line}");
        assert!(said.contains(wanted), "{line}: {said}");
    }
}

#[test]
fn all_forms_name_all_state_variables() {
    let (_, csv, _) = call(&format!("trace {PLATOON} --steps 1 --format csv --numbers fraction"));
    assert!(csv.starts_with("step,tick,x0,v0,x1,v1,"), "{csv}");
    let mut pages = 0;
    for rest in ["--steps 3 --check all", "--at 50 --verify 2 --seed 3"] {
        let (code, json, said) = call(&format!("trace {PLATOON} {rest} --format json"));
        assert_eq!(code, 0, "{said}");
        let page = parsed(&json);
        meets("cordon-trace/1", &page, rest);
        assert_eq!(page["scenario"]["state"][1], "v0");
        pages += 1;
    }
    assert_eq!(pages, 2);
    let itf = parsed(&call(&format!("trace {PLATOON} --steps 1 --format itf")).1);
    assert_eq!(itf["vars"], serde_json::json!(["step", "tick", "timesteps", "x", "v"]));
    assert_eq!(itf["states"][1]["v"].as_array().unwrap().len(), 5);
}

#[test]
fn local_machines_and_flights_run_the_file() {
    let (code, out, said) = call(&format!("local {PLATOON} --ticks 12"));
    assert_eq!(code, 0, "{said}");
    assert!(out.contains("5 local machines compute the global kth_step exactly"), "{out}");
    assert_eq!(call(&format!("local {PLATOON} --ticks 12 --exchange-every 5")).0, 1);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("flight.toml");
    let own = fs::canonicalize("scenarios/own/coverage.toml").unwrap();
    fs::copy(own, folder.path().join("mine.toml")).unwrap();
    let text = "protocol = \"mine.toml\"\nstart = [0, 0.1, 0.2, 0.3, 1]\nperiod = 4\n\
                [parameters]\neps = \"1/5\"\n";
    fs::write(&file, text).unwrap();
    let scenario = file.display().to_string();
    let (code, out, said) = call(&format!("cosim {scenario} --duration 2 --exact"));
    assert_eq!(code, 0, "{said}");
    assert!(out.contains("mine.toml, N = 5, eps = 1/5"), "{out}");
    let page = folder.path().join("page.html").display().to_string();
    assert_eq!(call(&format!("replay {scenario} --duration 2 --out {page}")).0, 0);
    let run = folder.path().join("run.json").display().to_string();
    assert_eq!(call(&format!("cosim {scenario} --duration 2 --out {run}")).0, 0);
    meets("cordon-cosim/1", &parsed(&fs::read_to_string(&run).unwrap()), "own flight");
    // The exported unit has the file inside.
    let archive = folder.path().join("mine.ssp").display().to_string();
    assert_eq!(call(&format!("export ssp {scenario} --out {archive}")).0, 0);
    let (code, flown, said) = call(&format!("cosim {archive} --duration 2"));
    assert_eq!(code, 0, "{said}");
    assert!(flown.contains("smallest gap"), "{flown}");
}

/// A swarm in the plane that is exported and read again flies the same run.
#[test]
fn planar_exports_fly_as_the_file_does() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let start: Vec<String> = (0..16).map(|i| format!("{},{}", i % 4 * 3, i / 4 * 2)).collect();
    let flags =
        format!("--protocol scenarios/own/grid.toml --set eps=1/5 --start {}", start.join(","));
    let flown = |what: &str| {
        let file = at("run.csv");
        let (code, _, said) = call(&format!("cosim {what} --duration 2 --out {file}"));
        assert_eq!(code, 0, "{said}");
        fs::read_to_string(file).unwrap()
    };
    let wanted = flown(&format!("{flags} --exchange double"));
    assert!(wanted.starts_with("time,xd0,") && wanted.contains(",yd15,"), "{wanted}");
    for (kind, to, read) in
        [("ssp", "grid.ssp", "grid.ssp"), ("into-cps", "grid", "grid/multi-model.json")]
    {
        let (code, _, said) = call(&format!("export {kind} {flags} --out {}", at(to)));
        assert_eq!(code, 0, "{said}");
        assert_eq!(flown(&at(read)), wanted, "{kind}");
    }
}

/// What z3 says of an exported script, a word a query.
fn answers(line: &str) -> Vec<String> {
    let (code, script, said) = call(line);
    assert_eq!(code, 0, "{said}");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("query.smt2");
    fs::write(&file, script).unwrap();
    let out = std::process::Command::new("z3").arg(&file).output().unwrap();
    String::from_utf8(out.stdout).unwrap().lines().map(str::to_owned).collect()
}

#[test]
fn solvers_agree_about_the_claims_of_files() {
    if !has_tool("z3", "SMT tier") {
        return;
    }
    let mut asked = 0;
    let inductive = ["ring-pulls", "coverage", "leader-chain", "digraph", "coverage-with-losses"];
    for name in inductive {
        let found = answers(&format!("export smt2 --protocol scenarios/own/{name}.toml"));
        assert_eq!(found, ["unsat", "unsat"], "{name}");
        asked += 1;
    }
    for (rest, wanted) in [
        ("hasty-coverage.toml", ["sat"]),
        ("hasty-coverage.toml --set eps=1/2", ["unsat"]),
        ("coverage-with-losses.toml --set eps=3/5", ["sat"]),
        ("coverage-late.toml", ["unsat"]),
        ("platoon.toml --steps 3", ["unsat"]),
    ] {
        let found = answers(&format!("export smt2 --negate --protocol scenarios/own/{rest}"));
        assert_eq!(found, wanted, "{rest}");
        asked += 1;
    }
    assert_eq!(asked, 10);
}
