//! FMUs that do what FMUs should not: `tests/data/fmi/plant.c`, compiled with one fault each, flies
//! among our drones or fails by name.
mod faults;
mod parameters;
mod processes;
mod variables;

use std::collections::BTreeMap;
use std::fs;
use std::io::{Cursor, Write};
use std::path::PathBuf;
use std::process::Command;

use tempfile::TempDir;
use zip::{ZipWriter, write::SimpleFileOptions};

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
