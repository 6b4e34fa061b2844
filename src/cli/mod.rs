//! The command line: one file a command, each a thin face over the library.
//!
//! stdout carries the result only; progress and diagnostics go to stderr.

mod export;
pub mod select;
mod theorems;

use std::io::Write;

use clap::{Parser, Subcommand};

use crate::{Outcome, Result};

/// Verification toolkit for a drone coverage protocol: one executable spec, simulated, swept
/// and proved.
#[derive(Parser, Debug)]
#[command(name = "cordon", version, about, long_about = None, after_help = EXIT_CODES)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

const EXIT_CODES: &str = "Exit codes: 0 holds or done, 1 refuted, 2 bad usage or input, \
                          3 inconclusive or not run, 4 certificate rejected, 74 I/O error";

/// The commands.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// List the theorems: hypotheses and conclusions, in the paper's form and the sharp form
    Theorems(theorems::Args),
    /// Write the protocol and its theorems for other tools
    Export(export::Args),
}

impl Cli {
    /// Runs the command, its result going to `out` and everything else to stderr.
    ///
    /// # Errors
    /// Bad input, or a file or stream that cannot be read or written.
    pub fn run(self, out: &mut dyn Write) -> Result<Outcome> {
        match self.command {
            Command::Theorems(args) => theorems::run(&args, out),
            Command::Export(args) => export::run(&args, out),
        }
    }
}
