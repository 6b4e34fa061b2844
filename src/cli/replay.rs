//! `cordon replay`.

use std::io::Write;
use std::path::PathBuf;

use super::cosim::FlightArgs;
use super::scenario_args::ScenarioArgs;
use cordon_core::{Outcome, Result, files};
use cordon_cosim::replay;
use cordon_cosim::{run as engine, store};

/// Arguments of `cordon replay`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// A run file of `cordon cosim` (csv, json), or a scenario file (toml), which is flown
    #[arg(value_name = "RUN")]
    run: PathBuf,
    /// The page
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    #[command(flatten)]
    flight: FlightArgs,
}

/// Writes the page.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let is_run =
        matches!(args.run.extension().and_then(|e| e.to_str()), Some("csv" | "json" | "parquet"));
    let record = if is_run {
        args.flight.refuse_for(&args.run)?;
        store::load(&args.run)?
    } else {
        let scenario = ScenarioArgs { file: Some(args.run.clone()), ..ScenarioArgs::default() };
        engine::run(&args.flight.swarm(&scenario)?, |_| {})?
    };
    files::write_atomically(&args.out, replay::page(&record)?.as_bytes())?;
    writeln!(out, "{}", args.out.display())?;
    Ok(Outcome::Holds)
}
