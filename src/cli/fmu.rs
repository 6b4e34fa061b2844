//! `cordon fmu`.

use std::io::Write;
use std::path::PathBuf;

use crate::cli::scenario_args::ScenarioArgs;
use cordon_core::{Error, Outcome, Result, files};
use cordon_cosim::fmi::interface::{FmiVersion, Model, Positions};
use cordon_formats::fmi::{binary, import, package};

/// Arguments of `cordon fmu`.
#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand, Debug)]
enum Command {
    /// Write a unit of the co-simulation as an FMU, which other tools run
    Export(Box<ExportArgs>),
    /// Serve an FMU to the parent process
    #[command(hide = true)]
    Host,
}

/// The arguments that make this program serve an FMU to its parent process.
pub(super) const HOST: [&str; 2] = ["fmu", "host"];

#[derive(clap::Args, Debug)]
struct ExportArgs {
    /// The unit to write
    #[arg(value_enum)]
    unit: UnitArg,
    #[command(flatten)]
    scenario: ScenarioArgs,
    /// Version of the FMI standard
    #[arg(long, value_enum, default_value_t = VersionArg::Two)]
    fmi: VersionArg,
    /// The FMU to write
    #[arg(long, value_name = "FILE.fmu")]
    out: PathBuf,
    /// How positions travel between coordination units
    #[arg(long, value_enum, default_value_t = PositionsArg::Exact)]
    positions: PositionsArg,
    #[command(flatten)]
    binary: BinaryArg,
}

/// Where the commands that write FMUs find the binary.
#[derive(clap::Args, Debug)]
pub(super) struct BinaryArg {
    /// The compiled crate `cordon-fmu` [default: the one beside this program]
    #[arg(long, value_name = "FILE")]
    pub binary: Option<PathBuf>,
}

#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum UnitArg {
    /// One drone's part of the coverage protocol (the spec, exact inside), or of the protocol file that
    /// `--protocol` or a scenario names
    Coordination,
    /// The cascaded controller
    Control,
    /// The quadcopter
    Plant,
}

/// A version of FMI on the command line.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum VersionArg {
    /// FMI 2.0
    #[value(name = "2")]
    Two,
    /// FMI 3.0
    #[value(name = "3")]
    Three,
}

impl From<VersionArg> for FmiVersion {
    fn from(arg: VersionArg) -> Self {
        match arg {
            VersionArg::Two => Self::V2,
            VersionArg::Three => Self::V3,
        }
    }
}

/// How positions travel, on the command line.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum PositionsArg {
    /// As text p/q: the run is the spec's run
    Exact,
    /// As doubles, for tools that connect no texts
    Double,
    /// As doubles read with six significant digits, as in the recorded runs
    SixDigits,
}

impl From<PositionsArg> for Positions {
    fn from(arg: PositionsArg) -> Self {
        match arg {
            PositionsArg::Exact => Self::Exact,
            PositionsArg::Double => Self::Double,
            PositionsArg::SixDigits => Self::SixDigits,
        }
    }
}

/// Runs a command about FMUs.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    match &args.command {
        Command::Export(args) => export(args, out),
        Command::Host => import::serve().map(|()| Outcome::Holds),
    }
}

fn export(args: &ExportArgs, out: &mut dyn Write) -> Result<Outcome> {
    let model = match args.unit {
        UnitArg::Coordination => coordination(args)?,
        UnitArg::Control => Model::Control,
        UnitArg::Plant => Model::Plant,
    };
    if args.scenario != ScenarioArgs::default() && !matches!(model, Model::Protocol(..)) {
        return Err(Error::input(
            "protocol: expected a protocol file, of which an FMU carries the scenario: other units \
             have parameters for all of it",
        ));
    }
    let version = args.fmi.into();
    let binary = binary::load(args.binary.binary.as_deref())?;
    let archive = package::fmu(&model, version, &binary)?;
    files::write_atomically(&args.out, &archive)?;
    writeln!(
        out,
        "{}: {}, FMI {version} for co-simulation, {} variables, {} bytes",
        args.out.display(),
        model.identifier(),
        model.variables().len(),
        archive.len()
    )?;
    Ok(Outcome::Holds)
}

/// The coordination unit of coverage, or of a protocol file.
fn coordination(args: &ExportArgs) -> Result<Model> {
    let positions = args.positions.into();
    if args.scenario == ScenarioArgs::default() {
        return Ok(Model::Coordination(positions));
    }
    let scenario = args.scenario.scenario_at_rest()?;
    let protocol = scenario.protocol.name();
    Model::coordination(positions, &scenario).ok_or_else(|| {
        Error::input(format!("protocol: `{protocol}`: expected `coverage` or a protocol file"))
    })
}
