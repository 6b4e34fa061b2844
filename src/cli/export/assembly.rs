//! `cordon export into-cps` and `cordon export ssp`: a co-simulation with its FMUs.

use std::io::Write;
use std::path::PathBuf;

use crate::cli::cosim::FlightArgs;
use crate::cli::fmu::{BinaryArg, VersionArg};
use crate::cli::scenario_args::ScenarioArgs;
use cordon_core::{Error, Outcome, Result, files};
use cordon_cosim::fmi::interface::FmiVersion;
use cordon_formats::fmi::{binary, package};
use cordon_formats::interchange::{Assembly, into_cps, ssp};

/// Arguments of both. Positions and parameters are doubles unless the scenario or `--exchange exact`
/// says otherwise.
#[derive(clap::Args, Debug)]
pub struct ExportArgs {
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

fn assembly(args: &ExportArgs, format: Format) -> Result<(Assembly, FmiVersion, Vec<u8>)> {
    // Not every tool can connect strings, and some silently read them as empty.
    let (swarm, places) = args.flight.swarm_exchanging(&args.scenario, "double")?;
    if let Format::Ssp = format {
        files::expect_writable(&args.out)?;
    }
    let assembly = Assembly::of(&swarm).and_then(|assembly| match format {
        Format::IntoCps => Ok(assembly),
        Format::Ssp => assembly.with_first_inputs(&swarm),
    });
    let assembly = assembly.map_err(|e| places.point(e))?;
    Ok((assembly, args.fmi.into(), binary::load(args.binary.binary.as_deref())?))
}

/// The target format.
#[derive(Clone, Copy)]
enum Format {
    IntoCps,
    /// Some importers do not send the initial outputs in the first step.
    Ssp,
}

/// Writes an INTO-CPS multi-model.
pub(super) fn into_cps(args: &ExportArgs, out: &mut dyn Write) -> Result<Outcome> {
    let (assembly, version, binary) = assembly(args, Format::IntoCps)?;
    let model = into_cps::multi_model(&assembly);
    let text = serde_json::to_vec_pretty(&model)
        .map_err(|e| Error::internal(format!("the multi-model cannot be written: {e}")))?;
    let mut written = Vec::new();
    for m in assembly.models() {
        written.push((into_cps::fmu_file(m), package::fmu(m, version, &binary)?));
    }
    // The multi-model is written last: if it exists, its FMUs do.
    written.push((into_cps::FILE_NAME.to_owned(), text));
    std::fs::create_dir_all(&args.out).map_err(|e| Error::file("create", &args.out, e))?;
    // Checked before the first file is written: none may replace a file named by the scenario.
    written.iter().try_for_each(|(name, _)| files::expect_writable(&args.out.join(name)))?;
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

/// Writes an SSP archive.
pub(super) fn ssp(args: &ExportArgs, out: &mut dyn Write) -> Result<Outcome> {
    let (assembly, version, binary) = assembly(args, Format::Ssp)?;
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
