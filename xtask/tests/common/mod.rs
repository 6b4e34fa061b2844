//! Tools that a test tier needs and a machine may lack.

#![allow(dead_code, clippy::unwrap_used, clippy::expect_used, clippy::panic)] // each test file uses its part

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The repository's root.
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// The program `xtask`, to be run in the repository's root.
pub fn command() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
    command.current_dir(root());
    command
}

/// The program run with these arguments.
pub fn xtask(args: &[&str]) -> Output {
    command().args(args).output().expect("xtask runs")
}

/// Exit code, stdout and stderr of a run.
pub fn run(args: &[&str]) -> (i32, String, String) {
    let out = xtask(args);
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (out.status.code().expect("no signal"), text(out.stdout), text(out.stderr))
}

/// What a successful run printed.
pub fn stdout_of(args: &[&str]) -> String {
    let out = xtask(args);
    assert!(out.status.success(), "{args:?}: {}", String::from_utf8_lossy(&out.stderr));
    String::from_utf8(out.stdout).expect("UTF-8")
}

/// What a run that ended with `code` said on stderr.
pub fn stderr_of(args: &[&str], code: i32) -> String {
    let out = xtask(args);
    assert_eq!(out.status.code(), Some(code), "{args:?}: {}", String::from_utf8_lossy(&out.stdout));
    assert!(out.stdout.is_empty(), "{args:?}: stdout carries the result only");
    String::from_utf8(out.stderr).expect("UTF-8")
}

/// Whether `tool` answers `--version`. Where it does not, the tier is not run, and says so.
pub fn has_tool(tool: &str, tier: &str) -> bool {
    let found = Command::new(tool).arg("--version").output().is_ok_and(|o| o.status.success());
    if !found {
        missing(tier, tool);
    }
    found
}

/// Says that a part of a test did not run for want of `what`. With CORDON_REQUIRE_TOOLS=1 (set
/// in CI) that is a failure.
pub fn missing(tier: &str, what: &str) {
    let required = std::env::var_os("CORDON_REQUIRE_TOOLS").is_some_and(|v| v == "1");
    assert!(!required, "{tier}: `{what}` is missing, and CORDON_REQUIRE_TOOLS=1");
    eprintln!("{tier}: NOT RUN: `{what}` is missing");
}

/// The files with this ending in a folder and the folders below it, sorted.
pub fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let Ok(entries) = std::fs::read_dir(folder) else { return found };
    for path in entries.map(|e| e.expect("a readable folder").path()) {
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|e| e == ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}
