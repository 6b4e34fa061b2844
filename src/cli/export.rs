//! `cordon export`.

use std::io::Write;
use std::path::PathBuf;

use super::cosim::FlightArgs;
use super::fmu::{BinaryArg, VersionArg};
use super::scenario_args::ScenarioArgs;
use crate::fmi::interface::FmiVersion;
use crate::fmi::{binary, package};
use crate::interchange::{Assembly, into_cps, ssp};
use crate::{Error, Outcome, Result, files};

/// Arguments of `cordon export`.
#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand, Debug)]
enum Command {
    /// Write the co-simulation as an INTO-CPS multi-model (for Maestro), the FMUs beside it
    IntoCps(Box<ExportArgs>),
    /// Write the co-simulation as an SSP archive (for FMPy or OMSimulator), the FMUs in it
    Ssp(Box<ExportArgs>),
}

#[derive(clap::Args, Debug)]
struct ExportArgs {
    #[command(flatten)]
    scenario: ScenarioArgs,
    #[command(flatten)]
    flight: FlightArgs,
    /// What to write: a folder (multi-model) or a file (SSP)
    #[arg(long, value_name = "PATH")]
    out: PathBuf,
    /// Version of the FMI standard
    #[arg(long, value_enum, default_value_t = VersionArg::Two)]
    fmi: VersionArg,
    #[command(flatten)]
    binary: BinaryArg,
}

/// Writes a co-simulation for other tools.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    match &args.command {
        Command::IntoCps(args) => into_cps(args, out),
        Command::Ssp(args) => ssp(args, out),
    }
}

fn assembly(args: &ExportArgs) -> Result<(Assembly, FmiVersion, Vec<u8>)> {
    let swarm = args.flight.swarm(&args.scenario)?;
    let assembly = args.scenario.in_file(Assembly::of(&swarm))?;
    Ok((assembly, args.fmi.into(), binary::load(args.binary.binary.as_deref())?))
}

fn into_cps(args: &ExportArgs, out: &mut dyn Write) -> Result<Outcome> {
    let (assembly, version, binary) = assembly(args)?;
    let model = into_cps::multi_model(&assembly);
    let text = serde_json::to_vec_pretty(&model)
        .map_err(|e| Error::input(format!("the multi-model cannot be written: {e}")))?;
    let mut written = Vec::new();
    for m in assembly.models() {
        written.push((into_cps::fmu_file(m), package::fmu(m, version, &binary)?));
    }
    // The multi-model comes last: where it is, its FMUs are.
    written.push((into_cps::FILE_NAME.to_owned(), text));
    std::fs::create_dir_all(&args.out).map_err(|e| Error::file("create", &args.out, e))?;
    for (name, content) in &written {
        files::write_atomically(&args.out.join(name), content)?;
    }
    writeln!(
        out,
        "{}: INTO-CPS multi-model, FMI {version}, {}",
        args.out.join(into_cps::FILE_NAME).display(),
        size(&assembly)
    )?;
    Ok(Outcome::Holds)
}

fn ssp(args: &ExportArgs, out: &mut dyn Write) -> Result<Outcome> {
    let (assembly, version, binary) = assembly(args)?;
    let archive = ssp::archive(&assembly, version, &binary)?;
    files::write_atomically(&args.out, &archive)?;
    writeln!(out, "{}: SSP 1.0, FMI {version}, {}", args.out.display(), size(&assembly))?;
    Ok(Outcome::Holds)
}

fn size(assembly: &Assembly) -> String {
    format!(
        "{} units, {} connections, {} steps of {} s",
        assembly.instances.len(),
        assembly.connections.len(),
        assembly.steps,
        assembly.tau
    )
}
