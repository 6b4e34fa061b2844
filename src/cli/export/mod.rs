//! `cordon export`.

mod assembly;
mod pvs;
mod smt2;

use std::io::Write;

use clap::Subcommand;

use cordon_core::{Outcome, Result};

/// Arguments of `cordon export`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The format to export to.
    #[command(subcommand)]
    pub target: Target,
}

/// Formats of other tools.
#[derive(Subcommand, Debug)]
pub enum Target {
    /// Inductive steps for a fixed number of drones as SMT-LIB 2
    Smt2(smt2::Args),
    /// Protocol, theorems and a scenario as PVS theories
    Pvs(pvs::Args),
    /// The co-simulation as an INTO-CPS multi-model (for Maestro), the FMUs beside it
    #[command(mut_arg("out", |out| out.value_name("DIR")))]
    IntoCps(Box<assembly::ExportArgs>),
    /// The co-simulation as an SSP archive (for FMPy or OMSimulator), the FMUs in it
    #[command(mut_arg("out", |out| out.value_name("FILE")))]
    Ssp(Box<assembly::ExportArgs>),
}

/// Writes the chosen format.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    match &args.target {
        Target::Smt2(args) => smt2::run(args, out),
        Target::Pvs(args) => pvs::run(args, out),
        Target::IntoCps(args) => assembly::into_cps(args, out),
        Target::Ssp(args) => assembly::ssp(args, out),
    }
}
