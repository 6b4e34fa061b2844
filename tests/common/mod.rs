//! What several test files share.
#![allow(dead_code, unused_imports, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod placements;
pub mod schema;
pub mod tools;

use std::sync::Once;

use assert_cmd::Command;

pub use placements::*;

/// The program.
pub fn cordon() -> Command {
    Command::cargo_bin("cordon").unwrap()
}

/// Runs the program in the repository's root; exit code, stdout, stderr.
///
/// Without cargo's variables: under cargo the program would build the binary for FMUs each time
/// it exports one; see [`fmu_binary`].
pub fn run(args: &[&str]) -> (i32, String, String) {
    let out = cordon().env_remove("CARGO").args(args).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (out.status.code().unwrap(), text(out.stdout), text(out.stderr))
}

/// Builds the binary for FMUs beside the program, once, as `cargo run -- fmu export` does.
pub fn fmu_binary() {
    static BUILT: Once = Once::new();
    BUILT.call_once(|| {
        let out = tempfile::tempdir().unwrap();
        let fmu = out.path().join("plant.fmu");
        let built = cordon().args(["fmu", "export", "plant", "--out"]).arg(fmu).output().unwrap();
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    });
}
