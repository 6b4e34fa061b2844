//! The commands of `cargo xtask`, one file each.

mod kani;
mod vectors;
mod verify;

use std::io::Write;

use clap::{Parser, Subcommand};
use cordon_core::{Outcome, Result};

/// What works inside Cordon's repository only: evidence, the model checker, test vectors.
#[derive(Parser, Debug)]
#[command(name = "cargo xtask", version, about, long_about = None, after_help = EXIT_CODES)]
pub struct Cli {
    /// The task to run.
    #[command(subcommand)]
    pub command: Command,
}

const EXIT_CODES: &str = "Exit codes: 0 done, 1 refuted, 2 bad usage or input, \
                          3 inconclusive or not run, 4 rejected, 70 internal fault, 74 I/O error";

/// Tasks that need the repository.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Show what is known of each theorem: run now, verified by record, or not run
    Verify(verify::Args),
    /// Run the model checker Kani on the harnesses of kani/, and read the results
    Kani(kani::Args),
    /// Write the test vectors of the mechanised mirrors, computed by the spec
    Vectors(vectors::Args),
}

/// Form of a command's output.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutputFormat {
    /// For people.
    Text,
    /// For programs, with a versioned schema.
    Json,
}

impl Cli {
    /// Runs the command, its result going to `out` and everything else to stderr.
    ///
    /// # Errors
    /// Bad input, or a file or stream that cannot be read or written.
    pub fn run(self, out: &mut dyn Write) -> Result<Outcome> {
        match self.command {
            Command::Verify(args) => verify::run(&args, out),
            Command::Kani(args) => kani::run(&args, out),
            Command::Vectors(args) => vectors::run(&args, out),
        }
    }
}
