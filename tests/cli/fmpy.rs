//! Exported FMUs in FMPy: they validate, behave, and a swarm of them flies as `cordon cosim`
//! does, every double. Runs where Python can import `fmpy` (`pip install fmpy`; another
//! interpreter: CORDON_PYTHON); with CORDON_REQUIRE_TOOLS=1 its absence is a failure.
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use crate::common::run;

const UNITS: [(&str, &str, &str); 5] = [
    ("coordination", "exact", "cordon_coordination"),
    ("coordination", "double", "cordon_coordination_double"),
    ("coordination", "six-digits", "cordon_coordination_six_digits"),
    ("control", "exact", "cordon_control"),
    ("plant", "exact", "cordon_plant"),
];

/// A protocol file with two variables an agent.
const PLATOON: &str = "scenarios/own/platoon.toml";

/// A scenario of it, in which drones fly to their desired places first.
fn platoon(folder: &Path) -> String {
    let protocol = Path::new(env!("CARGO_MANIFEST_DIR")).join(PLATOON);
    let text = format!(
        "protocol = '{}'\nstart = [0, 0, 0.25, 0, -0.25, 0.1, 0.25, 0, 0, 0]\nperiod = 4\ntau = 0.05\n\
         [flight]\nstart = [0, 1, 2, 3, 4]\n",
        protocol.display()
    );
    let path = folder.join("platoon.toml");
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// A Python that has FMPy, or `None` after saying that the test was not run.
fn python(test: &str) -> Option<String> {
    python_with(test, "fmpy")
}

/// As [`python`], for other packages.
fn python_with(test: &str, package: &str) -> Option<String> {
    let python = std::env::var("CORDON_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let found = Command::new(&python).args(["-c", &format!("import {package}")]).output();
    if found.is_ok_and(|o| o.status.success()) {
        crate::common::fmu_binary();
        return Some(python);
    }
    let required = std::env::var("CORDON_REQUIRE_TOOLS").is_ok_and(|v| v == "1");
    assert!(!required, "{test}: `{python}` cannot import {package}, and tools are required");
    eprintln!("{test}: NOT RUN: `{python}` cannot import {package}");
    None
}

fn call(python: &str, args: &[&str]) -> (bool, String, String) {
    let out = Command::new(python).args(args).output().unwrap();
    let text = |b: &[u8]| String::from_utf8_lossy(b).into_owned();
    (out.status.success(), text(&out.stdout), text(&out.stderr))
}

fn export(unit: &str, positions: &str, version: &str, out: &Path) {
    let out = out.to_str().unwrap();
    let (code, said, err) =
        run(&["fmu", "export", unit, "--positions", positions, "--fmi", version, "--out", out]);
    assert_eq!(code, 0, "{err}");
    assert!(said.contains("for co-simulation"), "{said}");
}

#[test]
fn fmpy_finds_no_problem_in_any_exported_fmu() {
    let Some(python) = python("validation") else { return };
    let dir = tempfile::tempdir().unwrap();
    let mut validated = 0;
    for (unit, positions, name) in UNITS {
        for version in ["2", "3"] {
            let fmu = dir.path().join(format!("{name}{version}.fmu"));
            export(unit, positions, version, &fmu);
            let (_, said, err) = call(&python, &["-m", "fmpy", "validate", fmu.to_str().unwrap()]);
            // The exit code counts problems and wraps around: the text decides.
            assert_eq!(said.trim(), "No problems found.", "{name} {version}: {err}");
            validated += 1;
        }
    }
    for positions in ["exact", "double"] {
        for version in ["2", "3"] {
            let fmu = dir.path().join("own.fmu").to_str().unwrap().to_owned();
            let args = ["fmu", "export", "coordination", "--protocol", PLATOON, "--fmi", version];
            let said = run(&[&args[..], &["--positions", positions, "--out", &fmu]].concat());
            assert_eq!(said.0, 0, "{}", said.2);
            let (_, said, err) = call(&python, &["-m", "fmpy", "validate", &fmu]);
            assert_eq!(said.trim(), "No problems found.", "own protocol {version}: {err}");
            validated += 1;
        }
    }
    assert_eq!(validated, 14);
}

#[test]
fn instances_states_and_errors_are_as_the_standards_want() {
    let Some(python) = python("instances") else { return };
    let dir = tempfile::tempdir().unwrap();
    for version in ["2", "3"] {
        let [plant, coordination] = ["plant", "coordination"].map(|unit| {
            let fmu = dir.path().join(format!("{unit}{version}.fmu"));
            export(unit, "exact", version, &fmu);
            fmu.to_str().unwrap().to_owned()
        });
        let (ok, said, err) = call(&python, &["tests/fmpy/one_unit.py", &plant, &coordination]);
        assert!(ok, "FMI {version}: {said}{err}");
        assert_eq!(said.lines().last(), Some("ok: 19 checks"), "{said}");
        let logged = said + &err;
        for message in [
            "a step of `0.07` s: expected a whole multiple of the parameter `tau`, `1/20` s",
            "variable `w1`: `NaN`: expected a finite number",
            "identifier `another-identifier`: no unit of this binary has it",
            "`9`: expected less than the number of drones, `5`",
        ] {
            assert!(logged.contains(message), "FMI {version}: {message} is not in the log");
        }
    }
}

/// Columns `xd0`, `x0`, ... of a run: by `cordon cosim`, or by the script, whose columns are
/// named after instances.
fn columns(text: &str) -> BTreeMap<String, Vec<f64>> {
    let mut lines = text.lines();
    let names: Vec<String> = lines
        .next()
        .unwrap()
        .split(',')
        .map(|name| match name.split('.').nth(1) {
            Some(i) if i.starts_with("coordination") => i.replace("coordination", "xd"),
            Some(i) => i.replace("plant", "x"),
            None => name.to_owned(),
        })
        .collect();
    let mut columns: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for line in lines {
        for (name, field) in names.iter().zip(line.split(',')) {
            columns.entry(name.clone()).or_default().push(field.parse().unwrap());
        }
    }
    columns.remove("time");
    columns
}

/// Flies an exported system in FMPy and compares every double with `cordon cosim`.
fn flies_the_same(python: &str, scenario: &str, flags: &[&str], version: &str, ssp: bool) {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (here, there) = (path("here.csv"), path("there.csv"));
    let (code, _, err) = run(&[&["cosim", scenario, "--out", &here], flags].concat());
    assert_eq!(code, 0, "{err}");
    let system = if ssp { path("swarm.ssp") } else { path("") };
    let kind = if ssp { "ssp" } else { "into-cps" };
    let export = ["export", kind, scenario, "--fmi", version, "--out", &system];
    let (code, said, err) = run(&[&export, flags].concat());
    assert_eq!(code, 0, "{err}");
    assert!(said.contains("15 units, 93 connections, 500 steps of 1/20 s"), "{said}");
    let system = if ssp { system } else { path("multi-model.json") };
    let (ok, said, err) = call(python, &["tests/fmpy/multi_model.py", &system, "--out", &there]);
    assert!(ok, "{scenario}, FMI {version}: {said}{err}");
    let [here, there] = [&here, &there].map(|f| columns(&std::fs::read_to_string(f).unwrap()));
    assert_eq!(here.len(), 10);
    let mut compared = 0;
    for (name, ours) in &here {
        let theirs = &there[name];
        assert_eq!(ours.len(), theirs.len(), "{name}");
        for (k, (a, b)) in ours.iter().zip(theirs).enumerate() {
            assert!(
                a.to_bits() == b.to_bits(),
                "{scenario}, FMI {version}: {name}, row {k}: {a} {b}"
            );
            compared += 1;
        }
    }
    assert_eq!(compared, 10 * 501, "doubles that were compared");
}

#[test]
fn fifteen_fmus_fly_as_the_cosimulation_does_every_double() {
    let Some(python) = python("fifteen units") else { return };
    for version in ["2", "3"] {
        let exact = ["--exchange", "exact"];
        flies_the_same(&python, "scenarios/paper.toml", &exact, version, false);
    }
    let unstable = "scenarios/paper-unstable.toml";
    flies_the_same(&python, unstable, &["--exchange", "double"], "2", false);
    flies_the_same(&python, "scenarios/recorded.toml", &["--compat", "recorded"], "2", false);
}

#[test]
fn own_protocols_fly_in_other_tools_as_they_do_here_every_double() {
    let Some(python) = python("own protocols") else { return };
    let dir = tempfile::tempdir().unwrap();
    let scenario = platoon(dir.path());
    flies_the_same(&python, &scenario, &["--exchange", "exact"], "3", false);
    flies_the_same(&python, &scenario, &["--exchange", "double"], "2", true);
}

/// Twelve drones, of which one is far from its desired place.
const TWELVE: &str = "start = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 42]\nweight = \"1/3\"\nperiod = 4\n\
                      tau = 0.05\n[flight]\nduration = 5\nexchange = \"double\"\n\
                      start = [0, 1, 2, 3, 7, 5, 6, 7, 8, 9, 10, 42]\n";

/// Flies an exported archive in another tool by its own way with archives; every double after every
/// step has to be that of `cordon cosim`.
fn flies_its_own_way(
    python: &str,
    scenario: &str,
    flags: &[&str],
    script: impl Fn(&str, &str) -> Vec<String>,
) -> usize {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (here, there, ssp) = (path("here.csv"), path("there.csv"), path("swarm.ssp"));
    let flags = [flags, &["--duration", "5", "--exchange", "double"]].concat();
    let flown = run(&[&["cosim", scenario, "--out", &here], &flags[..]].concat());
    assert_eq!(flown.0, 0, "{}", flown.2);
    let exported = run(&[&["export", "ssp", scenario, "--out", &ssp], &flags[..]].concat());
    assert_eq!(exported.0, 0, "{}", exported.2);
    let args = script(&ssp, &there);
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let (ok, said, err) = call(python, &args);
    assert!(ok, "{said}{err}");
    let [here, there] = [&here, &there].map(|f| columns(&std::fs::read_to_string(f).unwrap()));
    let mut compared = 0;
    for (name, theirs) in &there {
        // Names of components have numbers of equal length: `xd03` is `xd3`.
        let digits = name.find(|c: char| c.is_ascii_digit()).unwrap();
        let (letters, number) = name.split_at(digits);
        let ours = &here[&format!("{letters}{}", number.parse::<usize>().unwrap())];
        for (k, (a, b)) in ours.iter().skip(1).zip(theirs).enumerate() {
            assert!(a.to_bits() == b.to_bits(), "{flags:?}: {name}, row {k}: {a} {b}");
            compared += 1;
        }
    }
    compared
}

fn twelve(folder: &Path) -> String {
    let path = folder.join("twelve.toml");
    std::fs::write(&path, TWELVE).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Applies the one set of parameters, and sends zeros in the first step, whatever the outputs are.
#[test]
fn fmpys_own_way_with_ssp_archives_flies_them_right() {
    let Some(python) = python("simulate_ssp") else { return };
    let dir = tempfile::tempdir().unwrap();
    let script = |ssp: &str, out: &str| {
        ["tests/fmpy/simulate_ssp.py", ssp, "5", "0.05", "--out", out].map(str::to_owned).to_vec()
    };
    for phase in ["first", "last"] {
        let flags = ["--phase", phase];
        let compared = flies_its_own_way(&python, &twelve(dir.path()), &flags, script);
        assert_eq!(compared, 24 * 100, "doubles that were compared");
        let compared = flies_its_own_way(&python, &platoon(dir.path()), &flags, script);
        assert_eq!(compared, 10 * 100, "doubles of the platoon that were compared");
    }
}

#[test]
fn libcosim_and_ecos_fly_exported_archives_as_we_do_every_double() {
    for (tool, package) in
        [("libcosim", "libcosimpy"), ("ecos", "fmpy, importlib.metadata as m; m.version('ecospy')")]
    {
        let Some(python) = python_with(tool, package) else { continue };
        let dir = tempfile::tempdir().unwrap();
        let script = |ssp: &str, out: &str| {
            let args = ["tests/fmpy/other_masters.py", tool, ssp, "100", "0.05", "--out", out];
            args.map(str::to_owned).to_vec()
        };
        let compared = flies_its_own_way(&python, &twelve(dir.path()), &[], script);
        assert_eq!(compared, 24 * 100, "{tool}: doubles that were compared");
        let compared = flies_its_own_way(&python, &platoon(dir.path()), &[], script);
        assert_eq!(compared, 10 * 100, "{tool}: doubles of the platoon that were compared");
    }
}

#[test]
fn ssp_archives_are_whole_and_fly_the_same() {
    let Some(python) = python("ssp") else { return };
    let exact = ["--integrator", "exact", "--exchange", "exact"];
    flies_the_same(&python, "scenarios/paper.toml", &exact, "2", true);
    let doubles = ["--exchange", "double", "--tau", "1/20"];
    flies_the_same(&python, "scenarios/paper.toml", &doubles, "3", true);
    flies_the_same(&python, "scenarios/recorded.toml", &["--compat", "recorded"], "3", true);
}
