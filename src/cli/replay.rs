//! `cordon replay`.

use std::io::Write;
use std::path::PathBuf;

use super::cosim::FlightArgs;
use super::scenario_args::ScenarioArgs;
use cordon_core::{Outcome, Result, files};
use cordon_cosim::replay;
use cordon_cosim::{run as engine, store};
use cordon_formats::interchange::into_cps;

/// Arguments of `cordon replay`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// A run file of `cordon cosim` (csv, json), or a scenario (toml) or multi-model (json), which
    /// is flown
    #[arg(value_name = "RUN")]
    run: PathBuf,
    /// The page to write (HTML)
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    #[command(flatten)]
    flight: FlightArgs,
}

/// Writes the page for a recorded or a new run.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let is_run = match store::Format::of(&args.run) {
        Some(store::Format::Json) => !into_cps::holds_multi_model(&args.run)?,
        Some(_) => true,
        None => false,
    };
    let record = if is_run {
        args.flight.refuse_for(&args.run)?;
        store::load(&args.run)?
    } else {
        let scenario = ScenarioArgs { file: Some(args.run.clone()), ..ScenarioArgs::default() };
        let swarm = args.flight.swarm(&scenario)?;
        files::expect_writable(&args.out)?;
        engine::run(&swarm)?
    };
    files::write_atomically(&args.out, replay::page(&record)?.as_bytes())?;
    writeln!(out, "{}", args.out.display())?;
    Ok(Outcome::Holds)
}
