//! `cordon export`.

mod smt2;

use std::io::Write;

use clap::Subcommand;

use crate::{Outcome, Result};

/// Arguments of `cordon export`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// To what.
    #[command(subcommand)]
    pub target: Target,
}

/// The formats.
#[derive(Subcommand, Debug)]
pub enum Target {
    /// Inductive steps for a fixed number of drones as SMT-LIB 2
    Smt2(smt2::Args),
}

/// Exports.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    match &args.target {
        Target::Smt2(args) => smt2::run(args, out),
    }
}
