//! Kani in the version that this crate is written for, as its lock file has it:
//!
//! ```sh
//! cargo run -p cordon-kani --example kani -- setup   # once: downloads Kani's release
//! cargo run -p cordon-kani --example kani            # as `cargo kani` in the root
//! ```

use std::process::ExitCode;

fn main() -> ExitCode {
    match kani_verifier::proxy("cargo-kani") {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("error: {why:#}");
            ExitCode::FAILURE
        }
    }
}
