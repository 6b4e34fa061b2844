//! The program, run for what it prints.

#![allow(dead_code, unused_imports)] // each test file uses its part

#[path = "outputs.rs"]
mod outputs;

pub use outputs::{has_tool, missing};
use outputs::{stderr, stdout};
use std::process::{Command, Output};

/// The program `cordon`, run with these arguments.
pub fn cordon(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_cordon")).args(args).output().expect("cordon runs")
}

/// What a successful run printed.
pub fn stdout_of(args: &[&str]) -> String {
    stdout(args, cordon(args))
}

/// What a run that ended with `code` said on stderr.
pub fn stderr_of(args: &[&str], code: i32) -> String {
    stderr(args, code, cordon(args))
}
