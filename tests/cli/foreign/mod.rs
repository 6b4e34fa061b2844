//! FMUs that do what FMUs should not: `tests/data/fmi/plant.c`, compiled with one fault each, flies
//! among our drones or fails by name.
use std::collections::BTreeMap;
use std::fs;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;
use zip::{ZipWriter, write::SimpleFileOptions};

use crate::common::run;

const OUTPUTS: [&str; 12] =
    ["x", "y", "z", "vx", "vy", "vz", "phi", "theta", "psi", "vphi", "vtheta", "vpsi"];

/// A folder for FMUs and scenarios.
struct Bench {
    folder: TempDir,
}

/// A model description, part by part.
struct Description {
    version: &'static str,
    /// Between the root's start and the list of variables.
    head: String,
    /// Attributes of the values of variables, by their names.
    attributes: BTreeMap<&'static str, String>,
    /// More variables.
    more: String,
}

impl Description {
    fn of(version: &'static str) -> Self {
        let (attributes, more) = (BTreeMap::new(), String::new());
        Self { version, head: String::new(), attributes, more }
    }

    fn with(mut self, variable: &'static str, attributes: &str) -> Self {
        self.attributes.insert(variable, attributes.to_owned());
        self
    }

    fn variable(&self, name: &str, reference: usize, causality: &str) -> String {
        let extra = self.attributes.get(name).map(String::as_str).unwrap_or_default();
        let start = if causality == "output" { "" } else { r#"start="0""# };
        match self.version {
            "2.0" => format!(
                r#"<ScalarVariable name="{name}" valueReference="{reference}" causality="{causality}"><Real {start} {extra}/></ScalarVariable>"#
            ),
            _ => format!(
                r#"<Float64 name="{name}" valueReference="{reference}" causality="{causality}" {start} {extra}/>"#
            ),
        }
    }

    fn text(&self) -> String {
        let token = if self.version == "2.0" { "guid" } else { "instantiationToken" };
        let inputs = (0..4).map(|k| self.variable(&format!("w{}", k + 1), k, "input"));
        let outputs = OUTPUTS.iter().zip(4..).map(|(name, r)| self.variable(name, r, "output"));
        let starts = ["x0", "y0", "z0"].iter().zip(100..);
        let starts = starts.map(|(name, r)| self.variable(name, r, "parameter"));
        let variables: String = inputs.chain(outputs).chain(starts).collect();
        format!(
            r#"<fmiModelDescription fmiVersion="{}" modelName="test" {token}="t"><CoSimulation modelIdentifier="plant"/>{}<ModelVariables>{variables}{}</ModelVariables><ModelStructure/></fmiModelDescription>"#,
            self.version, self.head, self.more
        )
    }
}

impl Bench {
    fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn text(&self, name: &str) -> String {
        self.path(name).to_str().unwrap().to_owned()
    }

    /// The plant, compiled.
    fn library(&self, fault: &str, version: &str, flags: &[&str]) -> Vec<u8> {
        let out = self.path("plant.so");
        let built = Command::new("cc")
            .args(["-shared", "-fPIC", "-w", "-o", out.to_str().unwrap()])
            .arg(format!("-DFAULT={fault}"))
            .arg(format!("-DFMI={}", version.split('.').next().unwrap()))
            .args(flags)
            .args(["tests/data/fmi/plant.c", "-lm"])
            .output()
            .unwrap();
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        fs::read(out).unwrap()
    }

    fn fmu(&self, name: &str, description: &Description, library: &[u8]) {
        let folder = if description.version == "2.0" { "linux64" } else { "x86_64-linux" };
        let binary = format!("binaries/{folder}/plant.so");
        let text = description.text();
        self.archive(name, &[("modelDescription.xml", text.as_bytes()), (&binary, library)]);
    }

    fn archive(&self, name: &str, files: &[(&str, &[u8])]) {
        let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
        for (path, content) in files {
            zip.start_file(*path, SimpleFileOptions::default()).unwrap();
            zip.write_all(content).unwrap();
        }
        fs::write(self.path(name), zip.finish().unwrap().into_inner()).unwrap();
    }

    /// A scenario with these FMUs as plants, and `more` after each.
    fn scenario(&self, plants: &[(usize, &str)], more: &str) -> String {
        let mut text = "start = [0, 10, 20, 30, 100]\nweight = 0.2\nperiod = 4\ntau = 0.05\n\
                        [flight]\nduration = 2\n"
            .to_owned();
        for (drone, fmu) in plants {
            text.push_str(&format!(
                "[[unit]]\ndrone = {drone}\nunit = \"plant\"\nfmu = \"{fmu}\"\n{more}\n"
            ));
        }
        fs::write(self.path("s.toml"), text).unwrap();
        self.text("s.toml")
    }

    /// Flies a plant with this fault as drone 2: exit code, stdout, stderr, the run's lines.
    fn fly(&self, fault: &str, version: &'static str, flags: &[&str]) -> Flown {
        let library = self.library(fault, version, &[]);
        self.fmu("plant.fmu", &Description::of(version), &library);
        self.fly_scenario(&self.scenario(&[(2, "plant.fmu")], ""), flags)
    }

    fn fly_scenario(&self, scenario: &str, flags: &[&str]) -> Flown {
        let csv = self.path("run.csv");
        let _ = fs::remove_file(&csv);
        let args = [&["cosim", scenario, "--out", csv.to_str().unwrap()], flags].concat();
        let (code, out, err) = self.run(&args);
        let rows = fs::read_to_string(csv).unwrap_or_default();
        let rows = rows.lines().map(|l| l.split(',').map(str::to_owned).collect()).collect();
        Flown { code, out, err, rows }
    }

    /// Runs the program with temporary files and the plant's trace in this folder.
    fn run(&self, args: &[&str]) -> (i32, String, String) {
        fs::create_dir_all(self.path("tmp")).unwrap();
        let ended = crate::common::cordon()
            .env_remove("CARGO")
            .env("TMPDIR", self.path("tmp"))
            .env("CORDON_TEST_TRACE", self.path("trace"))
            .args(args)
            .output()
            .unwrap();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (ended.status.code().unwrap_or(-1), text(&ended.stdout), text(&ended.stderr))
    }

    /// The plant's calls since the last time.
    fn trace(&self) -> Vec<String> {
        let text = fs::read_to_string(self.path("trace")).unwrap_or_default();
        let _ = fs::remove_file(self.path("trace"));
        text.lines().map(str::to_owned).collect()
    }

    fn expect_no_leftovers(&self) {
        let left: Vec<_> = fs::read_dir(self.path("tmp")).unwrap().collect();
        assert!(left.is_empty(), "{left:?}");
    }
}

struct Flown {
    code: i32,
    out: String,
    err: String,
    rows: Vec<Vec<String>>,
}

impl Flown {
    /// The position of drone 2 in the last row.
    fn last(&self) -> f64 {
        self.rows.last().unwrap()[8].parse().unwrap()
    }
}

const MODES: [&[&str]; 2] = [&[], &["--in-process"]];

#[test]
fn a_plant_without_fault_is_called_in_the_order_of_the_standard() {
    let bench = Bench::new();
    for version in ["2.0", "3.0"] {
        for mode in MODES {
            let flown = bench.fly("NONE", version, mode);
            assert_eq!((flown.code, flown.err.as_str()), (0, ""), "{version} {mode:?}");
            assert!(flown.out.contains("plant2 is `plant.fmu`"), "{}", flown.out);
            assert_eq!(flown.rows[1][8], "20.0");
            assert!((flown.last() - 22.0).abs() < 1e-9);
            let calls = bench.trace();
            let (early, late) = (["parameter early"; 3], ["parameter late"; 3]);
            let mut expected = vec!["resources right"];
            if version == "2.0" {
                expected.push("set up");
            }
            expected.extend(early);
            expected.push("enter");
            expected.extend(late);
            expected.extend(["leave", "terminate", "free"]);
            let names: Vec<&str> = calls.iter().map(|c| c.rsplit_once(' ').unwrap().0).collect();
            assert_eq!(names, expected, "{version} {mode:?}");
            assert!(version == "3.0" || calls.contains(&"set up 2".to_owned()), "{calls:?}");
            bench.expect_no_leftovers();
        }
    }
}

#[test]
fn start_values_reach_tools_that_take_them_early_and_tools_that_take_them_late() {
    let bench = Bench::new();
    for version in ["2.0", "3.0"] {
        for fault in ["EARLY_ONLY", "LATE_ONLY"] {
            let flown = bench.fly(fault, version, &[]);
            assert_eq!((flown.code, flown.rows[1][8].as_str()), (0, "20.0"), "{fault} {version}");
        }
        let flown = bench.fly("FORGETFUL", version, &[]);
        assert_eq!((flown.code, flown.rows[1][8].as_str()), (0, "0.0"));
        let expected = "warning: unit `plant2`: `";
        assert!(flown.err.starts_with(expected), "{}", flown.err);
        assert!(
            flown.err.contains("parameter `x0` was set to `20` and reads back as `0`"),
            "{}",
            flown.err
        );
    }
}

#[test]
fn what_goes_wrong_in_an_fmu_is_an_error_of_its_unit_and_the_run_until_then_is_kept() {
    let bench = Bench::new();
    let died = |how: &str| format!("its process was killed by signal {how}");
    let cases: [(&str, &str, String); 9] = [
        ("ERROR", "2.0", "stepping: error: engine number 42 is cold, 2.5%".to_owned()),
        ("DISCARD", "2.0", "stepping: discarded, without a message".to_owned()),
        ("FATAL", "3.0", "stepping: fatal: out of fuel".to_owned()),
        ("FATAL", "2.0", "stepping: fatal: out of fuel".to_owned()),
        ("SEGFAULT", "2.0", died("11 (SIGSEGV)")),
        ("SEGFAULT", "3.0", died("11 (SIGSEGV)")),
        ("ABORT", "2.0", died("6 (SIGABRT)")),
        ("EXIT", "2.0", "it ended its process (exit code 0)".to_owned()),
        ("HANG", "2.0", "no answer within 1 s: its process was ended".to_owned()),
    ];
    for (fault, version, part) in &cases {
        let flags: &[&str] = if *fault == "HANG" { &["--step-limit", "1"] } else { &[] };
        let flown = bench.fly(fault, version, flags);
        assert_eq!(flown.code, 2, "{fault}: {}", flown.err);
        assert!(flown.err.contains("error: unit `plant2`: `"), "{fault}: {}", flown.err);
        assert!(
            flown.err.contains(&format!("step 19, from 0.95 s: {part}")),
            "{fault}: {}",
            flown.err
        );
        // A head line and the grid points 0 to 19.
        assert_eq!(flown.rows.len(), 21, "{fault}");
        assert!(flown.out.contains("the run broke off: unit `plant2`"), "{fault}: {}", flown.out);
        let companion = fs::read_to_string(bench.path("run.csv.json")).unwrap();
        assert!(companion.contains("\"broken_off\": \"unit `plant2`"), "{companion}");
        bench.expect_no_leftovers();
    }
    // What is no crash is the same error without a process in between.
    for (fault, version, part) in &cases[..4] {
        let flown = bench.fly(fault, version, &["--in-process"]);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains(part), "{fault}: {}", flown.err);
        bench.expect_no_leftovers();
    }
}

#[test]
fn loggers_may_say_anything_at_any_time() {
    let bench = Bench::new();
    for version in ["2.0", "3.0"] {
        for mode in MODES {
            let cases = [
                ("NULL_CATEGORY", "no category"),
                ("NULL_MESSAGE", "a message without text"),
                ("PENDING", "still at it"),
                ("WARNING", "stepping: warning: low battery"),
                ("SPAM", "and 99992 more messages"),
                ("LATE_LOG", ""),
            ];
            for (fault, part) in cases {
                let flown = bench.fly(fault, version, mode);
                assert_eq!(flown.code, 0, "{fault} {version} {mode:?}: {}", flown.err);
                assert!(flown.err.contains(part), "{fault} {version} {mode:?}: {}", flown.err);
                assert!((flown.last() - 22.0).abs() < 1e-9, "it flies on");
            }
        }
    }
}

#[test]
fn an_fmu_that_makes_no_instance_or_lacks_functions_is_named() {
    let bench = Bench::new();
    for mode in MODES {
        let flown = bench.fly("NO_INSTANCE", "2.0", mode);
        assert_eq!((flown.code, flown.out.as_str()), (2, ""));
        let part = "plant.fmu`: making an instance: it made none: no licence for `t`";
        assert!(flown.err.contains(part), "{}", flown.err);
        let library = bench.library("NONE", "2.0", &["-DINCOMPLETE"]);
        bench.fmu("plant.fmu", &Description::of("2.0"), &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), mode);
        assert_eq!(flown.code, 2);
        let part = "the binary has no function `fmi2ExitInitializationMode`";
        assert!(flown.err.contains(part), "{}", flown.err);
        bench.fmu("plant.fmu", &Description::of("2.0"), b"no library");
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), mode);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains("plant.fmu`: loading `"), "{}", flown.err);
        bench.expect_no_leftovers();
    }
}

#[test]
fn fmus_fly_side_by_side_each_alone_in_its_process() {
    let bench = Bench::new();
    // Its second instance in a process would be none.
    let library = bench.library("ONCE", "2.0", &[]);
    bench.fmu("plant.fmu", &Description::of("2.0"), &library);
    let scenario = bench.scenario(&[(1, "plant.fmu"), (2, "plant.fmu"), (3, "plant.fmu")], "");
    let flown = bench.fly_scenario(&scenario, &[]);
    assert_eq!(flown.code, 0, "{}", flown.err);
    for (drone, column) in [(1, 7), (2, 8), (3, 9)] {
        let x: f64 = flown.rows.last().unwrap()[column].parse().unwrap();
        assert!((x - (10.0 * f64::from(drone) + 2.0)).abs() < 1e-9, "drone {drone}: {x}");
    }
    bench.expect_no_leftovers();
}

#[test]
fn units_are_compared_by_their_base_units_and_values_converted() {
    let bench = Bench::new();
    let millimetres = r#"<UnitDefinitions><Unit name="mm"><BaseUnit m="1" factor="0.001"/></Unit></UnitDefinitions>"#;
    let types_2 = r#"<TypeDefinitions><SimpleType name="Length"><Real unit="mm"/></SimpleType></TypeDefinitions>"#;
    let types_3 = r#"<TypeDefinitions><Float64Type name="Length" unit="mm"/></TypeDefinitions>"#;
    let mut flown_units = 0;
    for (version, types) in [("2.0", types_2), ("3.0", types_3)] {
        let library = bench.library("NONE", version, &[]);
        for unit in [r#"unit="mm""#, r#"declaredType="Length""#] {
            let mut description = Description::of(version).with("x", unit).with("x0", unit);
            description.head = format!("{millimetres}{types}");
            bench.fmu("plant.fmu", &description, &library);
            let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
            assert_eq!(flown.code, 0, "{}", flown.err);
            // 20 m are 20,000 mm; 40 steps of 0.05 are 2 mm more.
            assert_eq!(flown.rows[1][8], "20.0");
            assert!((flown.last() - 20.002).abs() < 1e-9, "{}", flown.last());
            assert!(flown.err.contains("`x` is in `mm`: converted to `m`"), "{}", flown.err);
            flown_units += 1;
        }
        let same = Description::of(version).with("vx", r#"unit="m.s-1""#);
        bench.fmu("plant.fmu", &same, &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!((flown.code, flown.err.as_str()), (0, ""));
        let other = Description::of(version).with("vx", r#"unit="m.s-2""#);
        bench.fmu("plant.fmu", &other, &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains("`vx` is in `m.s-2`: expected `m/s`"), "{}", flown.err);
    }
    assert_eq!(flown_units, 4);
}

/// Units with an offset, as degrees Celsius have it: marks are half a metre long and begin at 100 m.
#[test]
fn values_in_units_with_an_offset_are_converted_both_ways() {
    let bench = Bench::new();
    let unit = r#"unit="mark""#;
    for version in ["2.0", "3.0"] {
        let library = bench.library("NONE", version, &[]);
        let mut description = Description::of(version).with("x", unit).with("x0", unit);
        description.head = r#"<UnitDefinitions><Unit name="mark"><BaseUnit m="1" factor="0.5" offset="100"/></Unit></UnitDefinitions>"#.to_owned();
        bench.fmu("plant.fmu", &description, &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!(flown.code, 0, "{}", flown.err);
        assert!(bench.trace().contains(&"parameter early -160".to_owned()), "20 m is mark -160");
        // 40 steps of 0.05 are 2 marks more.
        assert_eq!(flown.rows[1][8], "20.0");
        assert!((flown.last() - 21.0).abs() < 1e-9, "{}", flown.last());
        assert!(flown.err.contains("`x` is in `mark`: converted to `m`"), "{}", flown.err);
        // A unit that measures something else is none the better for its offset.
        description.head = description.head.replace("m=\"1\"", "K=\"1\"");
        bench.fmu("plant.fmu", &description, &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains("is in `mark`: expected `m`"), "{}", flown.err);
    }
}

/// Parameters of every type are set, and read back: what an FMU does not keep is a warning.
#[test]
fn integers_booleans_and_texts_are_set_and_read_back() {
    let bench = Bench::new();
    let parameter = |version: &str, kind: &str, name: &str, reference: usize| match version {
        "2.0" => format!(
            r#"<ScalarVariable name="{name}" valueReference="{reference}" causality="parameter"><{kind} start="0"/></ScalarVariable>"#
        ),
        _ => {
            format!(r#"<{kind} name="{name}" valueReference="{reference}" causality="parameter"/>"#)
        }
    };
    let mut set = 0;
    for (version, whole) in [("2.0", "Integer"), ("3.0", "Int8"), ("3.0", "UInt64")] {
        let kinds = [(whole, "gear"), ("Boolean", "armed"), ("String", "label")];
        let mut description = Description::of(version);
        let parameters = kinds.iter().zip(103..);
        description.more =
            parameters.map(|((kind, name), r)| parameter(version, kind, name, r)).collect();
        let more = "[unit.parameters]\ngear = 5\narmed = true\nlabel = \"north\"\n";
        for fault in ["NONE", "FORGETFUL"] {
            bench.fmu("plant.fmu", &description, &bench.library(fault, version, &[]));
            let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], more), &[]);
            assert_eq!(flown.code, 0, "{}", flown.err);
            let calls = bench.trace();
            for call in ["integer 5", "boolean 1", "north 5"] {
                assert!(calls.iter().any(|c| c == call), "{version} {whole}: {call} in {calls:?}");
                set += 1;
            }
            for (name, value, back) in
                [("gear", "5", "0"), ("armed", "true", "false"), ("label", "north", "")]
            {
                let warning =
                    format!("parameter `{name}` was set to `{value}` and reads back as `{back}`");
                assert_eq!(flown.err.contains(&warning), fault == "FORGETFUL", "{}", flown.err);
            }
        }
        // More than the type holds.
        bench.fmu("plant.fmu", &description, &bench.library("NONE", version, &[]));
        let more = more.replace('5', if whole == "UInt64" { "-1" } else { "5000000000" });
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], &more), &[]);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains("setting `gear`: `"), "{}", flown.err);
    }
    assert_eq!(set, 3 * 2 * 3);
}

/// A range or a list of values makes a run for each combination, in an order that is always the same.
#[test]
fn parameters_with_several_values_make_a_batch() {
    let bench = Bench::new();
    let mut description = Description::of("3.0");
    description.more =
        r#"<Int8 name="gear" valueReference="103" causality="parameter" start="0"/>"#.into();
    bench.fmu("plant.fmu", &description, &bench.library("NONE", "3.0", &[]));
    let with = |parameters: &str| {
        let more = format!("[unit.parameters]\n{parameters}");
        bench.scenario(&[(2, "plant.fmu")], &more)
    };
    let scenario = with("gear = [1, 2]\nx0 = { from = 20, to = 21, runs = 3 }");
    let csv = bench.text("table.csv");
    let (code, out, err) = bench.run(&["cosim", &scenario, "--out", &csv]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let table = fs::read_to_string(&csv).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|l| l.split(',').collect()).collect();
    assert_eq!(rows[0][..4], ["run", "plant2.gear", "plant2.x0", "collisions"]);
    let values: Vec<String> = rows[1..].iter().map(|r| r[..3].join(" ")).collect();
    assert_eq!(values, ["1 1 20", "2 1 41/2", "3 1 21", "4 2 20", "5 2 41/2", "6 2 21"]);
    // It glides on from where it starts: 9 m, 8.5 m and 8 m from drone 3 to the right, and 2 m on.
    let gaps: Vec<f64> = rows[1..].iter().map(|r| r[5].parse().unwrap()).collect();
    assert_eq!(gaps[..3], gaps[3..]);
    assert!(gaps[0] > gaps[1] && gaps[1] > gaps[2], "{gaps:?}");
    assert!(bench.trace().contains(&"integer 2".to_owned()));
    let again = bench.run(&["cosim", &scenario]);
    assert_eq!((again.0, again.1.as_str()), (0, out.as_str()), "the same table");
    for (parameters, part) in [
        ("x0 = []", "s.toml:12:6: unit.parameters.x0: expected at least one value"),
        ("x0 = [1, true]", "unit.parameters.x0: expected numbers"),
        ("x0 = { from = 1, runs = 3 }", "unit.parameters.x0: to is missing"),
        ("x0 = { from = 1, to = 2, runs = 1 }", "runs: expected 2 to 10000"),
        ("x0 = { from = 1, to = 2, step = 1 }", "expected `from`, `to` and `runs`"),
        ("gear = [0.5, 1]", "`1/2`: expected a whole number"),
        (
            "x0 = { from = 0, to = 1, runs = 101 }\ny0 = { from = 0, to = 1, runs = 101 }",
            "too many runs",
        ),
    ] {
        let (code, out, err) = bench.run(&["cosim", &with(parameters)]);
        assert_eq!((code, out.as_str()), (2, ""), "{parameters}");
        assert!(err.contains(part), "{parameters}: {err}");
    }
    let scenario = with("x0 = [20, 21]");
    for (args, part) in [
        (
            &["replay", &scenario, "--out", &bench.text("page.html")][..],
            "2 values: expected one in a run",
        ),
        (&["cosim", &scenario, "--exact"], "exact: expected one run"),
        (&["cosim", &scenario, "--variables", "*.x"], "variables: expected one run"),
        (&["cosim", &scenario, "--format", "json"], "format: expected `csv`"),
    ] {
        let (code, out, err) = bench.run(args);
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
        assert!(err.contains(part), "{args:?}: {err}");
    }
    bench.expect_no_leftovers();
}

/// Killed with an FMU inside the process, the program leaves a folder that the next run removes.
#[test]
fn what_a_killed_process_leaves_the_next_one_removes() {
    let bench = Bench::new();
    bench.fmu("plant.fmu", &Description::of("2.0"), &bench.library("SEGFAULT", "2.0", &[]));
    let scenario = bench.scenario(&[(2, "plant.fmu")], "");
    let (code, _, _) = bench.run(&["cosim", &scenario, "--in-process"]);
    assert_eq!(code, -1, "a signal");
    let left = || fs::read_dir(bench.path("tmp")).unwrap().count();
    assert_eq!(left(), 1);
    bench.fmu("plant.fmu", &Description::of("2.0"), &bench.library("NONE", "2.0", &[]));
    for mode in MODES {
        assert_eq!(bench.run(&[&["cosim", &scenario], mode].concat()).0, 0);
        bench.expect_no_leftovers();
    }
}

#[test]
fn variables_that_do_not_fit_are_refused_before_the_run() {
    let bench = Bench::new();
    let refused = |names: &str, part: &str| {
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], names), &[]);
        assert_eq!((flown.code, flown.out.as_str()), (2, ""), "{part}: {}", flown.err);
        assert!(flown.err.contains(part), "{}", flown.err);
    };
    let library = bench.library("NONE", "3.0", &[]);
    bench.fmu("plant.fmu", &Description::of("3.0"), &library);
    refused("[unit.names]\ny = \"x\"", "variable `y`: `");
    refused("[unit.names]\ny = \"x\"", "`x` stands for `x` already: expected one for each");
    let mut integer = Description::of("3.0");
    integer.more =
        r#"<Int32 name="arm" valueReference="200" causality="parameter" start="1"/>"#.into();
    bench.fmu("plant.fmu", &integer, &library);
    refused("", "variable `arm`: `");
    refused("", "`arm` has type Int32: expected Real or Float64 or Float32");
    let mut array = Description::of("3.0");
    array.more = r#"<Float64 name="arm" valueReference="200" causality="parameter" start="1 2 3"><Dimension start="3"/></Float64>"#.into();
    bench.fmu("plant.fmu", &array, &library);
    refused("", "`arm` is an array: expected a single value");
    let mut local = Description::of("3.0");
    local.more = r#"<Float64 name="arm" valueReference="200" causality="local"/>"#.into();
    bench.fmu("plant.fmu", &local, &library);
    let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
    assert_eq!(flown.code, 0, "{}", flown.err);
    assert!(flown.err.contains("`arm` is local, no parameter: it is not set"), "{}", flown.err);
}

#[test]
fn archives_beyond_the_limits_are_refused_before_they_are_unpacked() {
    let bench = Bench::new();
    let refused = |part: &str| {
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!((flown.code, flown.out.as_str()), (2, ""), "{part}: {}", flown.err);
        assert!(flown.err.contains(part), "{}", flown.err);
    };
    let huge = " ".repeat((1 << 26) + 1);
    bench.archive("plant.fmu", &[("modelDescription.xml", huge.as_bytes())]);
    refused("its `modelDescription.xml` is too large: expected at most 67108864 bytes");
    // Seventeen times 64 MiB of nothing.
    let names: Vec<String> = (0..17).map(|k| format!("resources/{k}")).collect();
    let files: Vec<(&str, &[u8])> = names.iter().map(|n| (n.as_str(), huge.as_bytes())).collect();
    bench.archive("plant.fmu", &files);
    refused("bytes: expected at most 1073741824");
    let library = bench.library("NONE", "2.0", &[]);
    let text = Description::of("2.0").text();
    let files: [(&str, &[u8]); 3] = [
        ("modelDescription.xml", text.as_bytes()),
        ("binaries/linux64/plant.so", &library),
        ("../outside", b"out"),
    ];
    bench.archive("plant.fmu", &files);
    refused("`../outside`: expected a path inside the archive");
    assert!(!bench.path("outside").exists() && !Path::new("outside").exists());
    bench.expect_no_leftovers();
}

/// Killed in the middle of a hanging step, the program leaves no folder and no process behind.
#[test]
fn nothing_is_left_where_the_program_is_killed() {
    let bench = Bench::new();
    let library = bench.library("HANG", "2.0", &[]);
    bench.fmu("plant.fmu", &Description::of("2.0"), &library);
    let scenario = bench.scenario(&[(2, "plant.fmu")], "");
    fs::create_dir_all(bench.path("tmp")).unwrap();
    let mut flying = Command::new(env!("CARGO_BIN_EXE_cordon"))
        .args(["cosim", &scenario])
        .env("TMPDIR", bench.path("tmp"))
        .env("CORDON_TEST_TRACE", bench.path("trace"))
        .spawn()
        .unwrap();
    // Long enough to be a failure; none of it passes where all is well.
    let wait = |what: &str, done: &dyn Fn() -> bool| {
        let came = (0..3000).any(|_| {
            std::thread::sleep(std::time::Duration::from_millis(20));
            done()
        });
        assert!(came, "{what}");
    };
    let begun = || fs::read_to_string(bench.path("trace")).is_ok_and(|t| t.contains("leave"));
    wait("the plant is initialised", &begun);
    assert_eq!(fs::read_dir(bench.path("tmp")).unwrap().count(), 1);
    flying.kill().unwrap();
    flying.wait().unwrap();
    wait("the unpacked archive is removed", &|| {
        fs::read_dir(bench.path("tmp")).unwrap().count() == 0
    });
}

/// A project as the INTO-CPS application lays it out, with a plant of another tool whose variables
/// have other names: the connections tell which are which.
#[test]
fn a_multi_model_with_a_foreign_plant_its_configuration_and_uris_flies() {
    crate::common::fmu_binary();
    let bench = Bench::new();
    let project = bench.path("my project");
    let (exported, models) = (bench.path("exported"), project.join("Multi-models/mm"));
    fs::create_dir_all(models.join("co-sim")).unwrap();
    fs::create_dir_all(project.join("FMUs")).unwrap();
    let export = ["export", "into-cps", "scenarios/paper.toml", "--duration", "2", "--out"];
    let args = [&export[..], &[exported.to_str().unwrap()]].concat();
    assert_eq!(run(&args).0, 0);
    let text = fs::read_to_string(exported.join("multi-model.json")).unwrap();
    let mut model: serde_json::Value = serde_json::from_str(&text).unwrap();
    for (place, file) in ["coordination_double", "control", "plant"].iter().enumerate() {
        let name = format!("cordon_{file}.fmu");
        fs::rename(exported.join(&name), project.join("FMUs").join(&name)).unwrap();
        // By its name, by URIs with three and four slashes.
        let path = project.join("FMUs").join(&name).display().to_string().replace(' ', "%20");
        let uri = [name, format!("file://{path}"), format!("file:///{path}")][place].clone();
        model["fmus"][format!("{{cordon_{file}}}")] = uri.into();
    }
    // Drone 2 gets the other plant.
    let mut description = Description::of("2.0");
    let renamed = |d: &Description| {
        d.text().replace("name=\"x\"", "name=\"pos.x\"").replace("name=\"w1\"", "name=\"front\"")
    };
    description.head.clear();
    let library = bench.library("EARLY_ONLY", "2.0", &[]);
    let xml = renamed(&description);
    let files: [(&str, &[u8]); 2] =
        [("modelDescription.xml", xml.as_bytes()), ("binaries/linux64/plant.so", &library)];
    bench.archive("my project/FMUs/other.fmu", &files);
    let text = serde_json::to_string(&model).unwrap();
    let text = text
        .replace("{cordon_plant}.plant2.x\"", "{other}.plant2.pos.x\"")
        .replace("{cordon_plant}.plant2.w1\"", "{other}.plant2.front\"")
        .replace("{cordon_plant}.plant2", "{other}.plant2");
    let mut model: serde_json::Value = serde_json::from_str(&text).unwrap();
    model["fmus"]["{other}"] = "other.fmu".into();
    model["parameters"]["{other}.plant2.x0"] = 17.5.into();
    let mut configuration = serde_json::json!({ "multimodel_path": "Multi-models/mm/mm.json" });
    for key in ["algorithm", "endTime", "startTime"] {
        configuration[key] = model[key].take();
        model.as_object_mut().unwrap().remove(key);
    }
    fs::write(models.join("mm.json"), model.to_string()).unwrap();
    let coe = models.join("co-sim/co-sim.coe.json");
    fs::write(&coe, configuration.to_string()).unwrap();
    let flown = bench.fly_scenario(coe.to_str().unwrap(), &[]);
    assert_eq!(flown.code, 0, "{}", flown.err);
    assert_eq!(flown.rows.len(), 42);
    assert_eq!(flown.rows[1][8], "17.5");
    assert!((flown.last() - 19.5).abs() < 1e-9, "{}", flown.last());
    assert!(flown.out.contains("plant2 is `other.fmu`"), "{}", flown.out);
    // The multi-model alone does not say how it is stepped.
    let mm = models.join("mm.json");
    let flown = bench.fly_scenario(mm.to_str().unwrap(), &[]);
    assert_eq!(flown.code, 2);
    assert!(flown.err.contains("algorithm is missing"), "{}", flown.err);
    model["fmus"]["{other}"] = "file:///no%20such.fmu".into();
    fs::write(&mm, model.to_string()).unwrap();
    let flown = bench.fly_scenario(coe.to_str().unwrap(), &[]);
    assert_eq!(flown.code, 74);
    assert!(flown.err.contains("cannot read `/no such.fmu`"), "{}", flown.err);
}

#[test]
fn parameters_of_an_fmu_are_set_by_its_own_names_and_checked() {
    let bench = Bench::new();
    let library = bench.library("NONE", "3.0", &[]);
    let mut description = Description::of("3.0");
    description.more =
        r#"<Int32 name="mode" valueReference="102" causality="parameter" start="0"/>"#.into();
    bench.fmu("plant.fmu", &description, &library);
    let with = |parameters: &str| {
        let more = format!("[unit.parameters]\n{parameters}");
        bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], &more), &[])
    };
    let flown = with("x0 = 21.25");
    assert_eq!((flown.code, flown.rows[1][8].as_str()), (0, "21.25"), "{}", flown.err);
    for (parameters, part) in [
        ("speed = 1", "variable `speed`: `"),
        ("x = 1", "it is output: expected a parameter"),
        ("x0 = true", "it has type Float64: expected a value of that type"),
        ("mode = 1.5", "`3/2`: expected a whole number"),
    ] {
        let flown = with(parameters);
        assert_eq!((flown.code, flown.out.as_str()), (2, ""), "{parameters}");
        assert!(flown.err.contains(part), "{parameters}: {}", flown.err);
    }
}

#[test]
fn flags_about_processes_are_checked() {
    for (flags, part) in [
        (&["--step-limit", "0"][..], "step-limit: `0`: expected a positive number of seconds"),
        (&["--step-limit", "-1"][..], "step-limit"),
    ] {
        let (code, _, err) = run(&[&["cosim", "scenarios/paper.toml"], flags].concat());
        assert_eq!(code, 2);
        assert!(err.contains(part), "{err}");
    }
}
