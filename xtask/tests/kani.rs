//! `cargo xtask kani`: what it makes of an installed Kani and of its reports. A script stands for Kani,
//! so that every way in which a run can go wrong is tried; what Kani itself says of the harnesses
//! is not asked here.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::PathBuf;
use std::process::Output;

use cordon_kani::{Expected, Harness, all};
use serde_json::Value;

/// Answers `--version`, else copies the prepared reports to where Kani would write them.
const SCRIPT: &str = r#"#!/bin/sh
here=$(dirname "$0")
case "$*" in *--version*) cat "$here/version"; exit 0;; esac
echo "arguments: $*" > "$here/arguments"
echo "memory: $(ulimit -v)" >> "$here/arguments"
echo "Checking harness, it says"
while [ $# -gt 0 ]; do [ "$1" = --target-dir ] && target=$2; shift; done
mkdir -p "$target"
[ -d "$here/reports" ] && cp -r "$here/reports" "$target/result_output_dir"
exit "$(cat "$here/status")"
"#;

/// What Kani writes about a harness that came to what it has to.
fn report(harness: &Harness) -> String {
    let (status, closing) = match harness.expected {
        Expected::Holds => ("SUCCESS", "SUCCESSFUL"),
        Expected::Fails => ("FAILURE", "SUCCESSFUL (encountered one or more panics as expected)"),
    };
    format!(
        "RESULTS:\nCheck 1: x.assertion.1\n\t - Status: {status}\n\t - Description: \"it holds\"\n\n\
         Check 2: {}.cover.1\n\t - Status: SATISFIED\n\t - Description: \"the witness is reached\"\n\n\
         VERIFICATION:- {closing}\nVerification Time: 1.5s\n",
        harness.name
    )
}

/// A folder that is taken for the repository, and a script that is taken for Kani.
struct Stage(tempfile::TempDir);

impl Stage {
    fn new() -> Self {
        let stage = Self(tempfile::tempdir().unwrap());
        stage.write("repository/kani/Cargo.toml", "");
        stage.write("bin/version", "cargo-kani 0.67.0\n");
        stage.write("bin/status", "0");
        stage.write("bin/cargo-kani", SCRIPT);
        let script = stage.path("bin/cargo-kani");
        fs::set_permissions(script, fs::Permissions::from_mode(0o755)).unwrap();
        for harness in all() {
            stage.write(&format!("bin/reports/{}", harness.name), &report(harness));
        }
        stage
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// Changes the report of a harness.
    fn edit(&self, harness: &str, from: &str, to: &str) {
        let name = format!("bin/reports/{harness}");
        let text = fs::read_to_string(self.path(&name)).unwrap();
        assert!(text.contains(from), "{text}");
        self.write(&name, &text.replace(from, to));
    }

    fn run(&self, args: &[&str]) -> Output {
        let path = format!("{}:{}", self.path("bin").display(), std::env::var("PATH").unwrap());
        common::command()
            .env("PATH", path)
            // Where cargo would look for `cargo-kani` too.
            .env("CARGO_HOME", self.path("home"))
            .args(["kani", "--root"])
            .arg(self.path("repository"))
            .args(args)
            .output()
            .unwrap()
    }

    /// Runs it; exit code, stdout and stderr have to be text.
    fn ends(&self, args: &[&str], code: i32) -> (String, String) {
        let out = self.run(args);
        let text = |bytes| String::from_utf8(bytes).unwrap();
        let (stdout, stderr) = (text(out.stdout), text(out.stderr));
        assert_eq!(out.status.code(), Some(code), "{stdout}\n{stderr}");
        (stdout, stderr)
    }

    fn json(&self, args: &[&str], code: i32) -> Value {
        let args = [args, &["--format", "json"]].concat();
        serde_json::from_str(&self.ends(&args, code).0).unwrap()
    }
}

fn named<'v>(page: &'v Value, name: &str) -> &'v Value {
    let rows = page["harnesses"].as_array().unwrap();
    rows.iter().find(|row| row["name"] == name).unwrap()
}

const STEP: &str = "harnesses::ordering::step_4";
const CROSSING: &str = "harnesses::exactness::ordering_fails_at_7_10";

#[test]
fn a_run_in_which_all_is_well_is_reported_whole() {
    let stage = Stage::new();
    let json = stage.path("run.json");
    let (said, progress) = stage.ends(&["--out", json.to_str().unwrap(), "--jobs", "2"], 0);
    let count = all().count();
    assert_eq!(said.lines().count(), count + 1);
    assert!(said.contains("7.2         harnesses::ordering::step_4: N = 4, one step"), "{said}");
    assert!(said.contains("found           1.5 s  7.2"), "{said}");
    let fails = all().filter(|h| h.expected == Expected::Fails).count();
    let closing = format!(
        "Kani 0.67.0: {count} harnesses expected, {} proved within their bounds, {fails} expected \
         counterexamples found, 0 not\n",
        count - fails
    );
    assert!(said.ends_with(&closing), "{said}");
    assert!(progress.contains("Checking harness, it says"), "progress goes to stderr: {progress}");
    let page: Value = serde_json::from_str(&fs::read_to_string(json).unwrap()).unwrap();
    assert_eq!(page["schema"], "cordon-kani/1");
    assert_eq!((&page["expected"], &page["proved"]), (&count.into(), &count.into()));
    assert_eq!(named(&page, STEP)["verdict"], "proved");
    assert_eq!(named(&page, STEP)["seconds"], 1.5);
    assert_eq!(named(&page, CROSSING)["expected"], "counterexample");
    // What it was asked for.
    let asked = fs::read_to_string(stage.path("bin/arguments")).unwrap();
    assert!(asked.contains("--harness-timeout 60 --jobs 2 --target-dir"), "{asked}");
    assert!(asked.contains("memory: 4194304"), "{asked}");
}

#[test]
fn what_is_not_proved_is_never_green() {
    for (from, to, code, verdict) in [
        ("Status: SUCCESS", "Status: FAILURE", 1, "refuted"),
        ("VERIFICATION:- SUCCESSFUL", "VERIFICATION:- FAILED", 1, "refuted"),
        ("SATISFIED", "UNSATISFIABLE", 4, "cover not met"),
        (".cover.1", ".other.1", 0, "proved"),
        ("RESULTS", "CBMC timed out. You may\nRESULTS", 3, "timed out"),
        ("RESULTS", "CBMC ran out of memory\nRESULTS", 3, "out of memory"),
        ("VERIFICATION:- SUCCESSFUL", "", 3, "no verdict"),
    ] {
        let stage = Stage::new();
        stage.edit(STEP, from, to);
        let page = stage.json(&[], code);
        assert_eq!(named(&page, STEP)["verdict"], verdict, "{to}");
        let others = page["harnesses"].as_array().unwrap();
        let proved = others.iter().filter(|row| row["verdict"] == "proved").count();
        assert_eq!(proved, all().count() - usize::from(code != 0), "{to}");
    }
}

#[test]
fn a_counterexample_that_is_not_found_is_a_failure() {
    let stage = Stage::new();
    stage.edit(CROSSING, "FAILURE", "SUCCESS");
    let page = stage.json(&[], 1);
    let detail = &named(&page, CROSSING)["detail"];
    assert_eq!(detail, "no counterexample where one was expected");
}

#[test]
fn missing_and_unexpected_harnesses_are_failures() {
    let stage = Stage::new();
    fs::remove_file(stage.path("bin/reports").join(STEP)).unwrap();
    let page = stage.json(&[], 4);
    assert_eq!(named(&page, STEP)["verdict"], "missing");

    let stage = Stage::new();
    stage.write("bin/reports/harnesses::another", "VERIFICATION:- SUCCESSFUL\n");
    let (said, _) = stage.ends(&[], 4);
    assert!(said.contains("unexpected          -  harnesses::another: reported"), "{said}");

    // None at all, though Kani says that all is well.
    let stage = Stage::new();
    fs::remove_dir_all(stage.path("bin/reports")).unwrap();
    let page = stage.json(&[], 4);
    assert_eq!(page["proved"], 0);

    // None at all, and Kani failed: nothing was run.
    stage.write("bin/status", "101");
    let (said, why) = stage.ends(&[], 3);
    assert!(said.is_empty(), "{said}");
    assert!(why.contains("not run: `cargo kani` ended with exit status: 101"), "{why}");
}

#[test]
fn results_of_an_earlier_run_do_not_count() {
    let stage = Stage::new();
    stage.ends(&[], 0);
    fs::remove_file(stage.path("bin/reports").join(STEP)).unwrap();
    let page = stage.json(&[], 4);
    assert_eq!(named(&page, STEP)["verdict"], "missing");
}

#[test]
fn a_selection_expects_what_it_selects() {
    let stage = Stage::new();
    for entry in fs::read_dir(stage.path("bin/reports")).unwrap() {
        let path = entry.unwrap().path();
        if !path.to_str().unwrap().contains("ordering::step_free") {
            fs::remove_file(path).unwrap();
        }
    }
    let page = stage.json(&["ordering::step_free"], 0);
    assert_eq!(page["expected"], 4);
    let asked = fs::read_to_string(stage.path("bin/arguments")).unwrap();
    assert!(asked.contains("--harness ordering::step_free"), "{asked}");
    let (_, why) = stage.ends(&["no_such"], 2);
    assert!(why.starts_with("error: `no_such`: expected parts of the names"), "{why}");
}

#[test]
fn without_kani_nothing_is_run() {
    let stage = Stage::new();
    fs::remove_file(stage.path("bin/cargo-kani")).unwrap();
    // A search path without any Kani: cargo's own folder and the system's.
    let cargo = PathBuf::from(std::env::var("CARGO").unwrap());
    let path = format!("{}:/usr/bin:/bin", cargo.parent().unwrap().display());
    let out = common::command()
        .env("PATH", path)
        .env("CARGO_HOME", stage.path("home"))
        .args(["kani", "--root"])
        .arg(stage.path("repository"))
        .output()
        .unwrap();
    let why = String::from_utf8(out.stderr).unwrap();
    assert_eq!(out.status.code(), Some(3), "{why}");
    assert!(out.stdout.is_empty());
    assert!(why.starts_with("not run: Kani is not installed: install it with `cargo"), "{why}");
}

#[test]
fn another_version_is_refused() {
    let stage = Stage::new();
    for (version, said) in [
        ("cargo-kani 0.66.0", "not run: Kani 0.66.0: the harnesses are written for 0.67 or 0.68"),
        ("cargo-kani 1.2.3", "not run: Kani 1.2.3: the harnesses are written for 0.67 or 0.68"),
        ("what?", "not run: `what?` is not a version of Kani: expected 0.67 or 0.68"),
    ] {
        stage.write("bin/version", version);
        let (out, why) = stage.ends(&[], 3);
        assert!(out.is_empty() && why.starts_with(said), "{why}");
    }
    assert!(!stage.path("bin/arguments").exists(), "nothing was run");
}

#[test]
fn the_pinned_version_is_a_supported_one() {
    let lock = fs::read_to_string(common::root().join("Cargo.lock")).unwrap();
    let after = lock.split("name = \"kani-verifier\"\nversion = \"").nth(1).unwrap();
    let version = after.split('"').next().unwrap();
    let mut parts = version.split('.').map(|p| p.parse::<u32>().unwrap());
    let pinned = (parts.next().unwrap(), parts.next().unwrap());
    assert!(xtask::model_check::tool::SUPPORTED.contains(&pinned), "{version}");
}

#[test]
fn harnesses_are_listed() {
    let (code, said, _) = common::run(&["kani", "--list", "ordering::step_4"]);
    assert_eq!(code, 0);
    assert_eq!(
        said,
        "7.2         harnesses::ordering::step_4: N = 4, one step, positions 0..=255, eps 0, 1/10, \
         1/5, 1/4, 3/10, 1/3, 2/5, 1/2\n1 harnesses\n"
    );
    let (code, said, _) = common::run(&["kani", "--list", "--format", "json"]);
    assert_eq!(code, 0);
    let page: Value = serde_json::from_str(&said).unwrap();
    assert_eq!(page["schema"], "cordon-harnesses/1");
    assert_eq!(page["harnesses"].as_array().unwrap().len(), all().count());
    let step = named(&page, STEP);
    assert_eq!(step["claim"], "One step keeps four drones in order.");
    assert!(step["functions"].as_array().unwrap().iter().any(|f| f == "coverage::exec_cvg"));
}

#[test]
fn bad_input_is_named() {
    let (code, _, why) = common::run(&["kani", "--root", "tests"]);
    assert_eq!(code, 2);
    assert_eq!(why, "error: --root: `tests`: expected the repository, with its folder `kani`\n");
    let (code, _, why) = common::run(&["kani", "--timeout", "0"]);
    assert_eq!(code, 2);
    assert!(why.contains("'--timeout <SECONDS>'"), "{why}");
    assert!(common::root().join("kani/Cargo.toml").is_file());
}

#[test]
fn verify_runs_the_harnesses_on_request() {
    let stage = Stage::new();
    let path = format!("{}:{}", stage.path("bin").display(), std::env::var("PATH").unwrap());
    let verify = |args: &[&str], code: i32| -> Value {
        let out = common::command()
            .env("PATH", &path)
            .env("CARGO_HOME", stage.path("home"))
            .args(["verify", "--tiers", "kani", "--format", "json", "--root"])
            .arg(stage.path("repository"))
            .args(args)
            .output()
            .unwrap();
        assert_eq!(out.status.code(), Some(code), "{}", String::from_utf8_lossy(&out.stderr));
        serde_json::from_slice(&out.stdout).unwrap()
    };
    let text = verify(&[], 3).to_string();
    assert!(text.contains("on request only: `--run kani`"), "{text}");
    let text = verify(&["--run", "kani"], 0).to_string();
    assert!(text.contains("harnesses within their bounds"), "{text}");
    stage.edit(STEP, "Status: SUCCESS", "Status: FAILURE");
    let text = verify(&["--run", "kani"], 1).to_string();
    assert!(text.contains("harnesses::ordering::step_4: refuted: it holds"), "{text}");
    stage.edit(STEP, "Status: FAILURE", "Status: SUCCESS");
    // About no theorem, and still a failure.
    stage.edit("harnesses::ticks::one_tick", "SATISFIED", "UNSATISFIABLE");
    let text = verify(&["--run", "kani"], 4).to_string();
    assert!(text.contains("harnesses::ticks::one_tick: cover not met"), "{text}");
}
