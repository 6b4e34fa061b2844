//! The program `xtask`, run for what it prints.

#![allow(dead_code, unused_imports, clippy::unwrap_used, clippy::expect_used, clippy::panic)] // each test file uses its part

#[path = "../../../tests/common/outputs.rs"]
mod outputs;

pub use outputs::{has_tool, missing};
use outputs::{stderr, stdout};
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
    stdout(args, xtask(args))
}

/// What a run that ended with `code` said on stderr.
pub fn stderr_of(args: &[&str], code: i32) -> String {
    stderr(args, code, xtask(args))
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
