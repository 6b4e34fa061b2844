//! What programs print, and tools that a test tier needs and a machine may lack.

use std::process::{Command, Output};

/// What a successful run printed.
pub fn stdout(args: &[&str], out: Output) -> String {
    assert!(out.status.success(), "{args:?}: {}", String::from_utf8_lossy(&out.stderr));
    String::from_utf8(out.stdout).expect("UTF-8")
}

/// What a run that ended with `code` said on stderr.
pub fn stderr(args: &[&str], code: i32, out: Output) -> String {
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
