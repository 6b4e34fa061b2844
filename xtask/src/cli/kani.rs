//! `cargo xtask kani`.

use std::io::Write;
use std::path::PathBuf;

use serde_json::json;

use super::OutputFormat;
use crate::model_check::report::expectation;
use crate::model_check::tool::Kani;
use crate::model_check::{Limits, NotRun, run as check, selected};
use cordon_core::{Error, Outcome, Result, files};

/// Arguments of `cargo xtask kani`.
#[derive(clap::Args, Debug)]
#[command(
    after_help = "Needs Kani 0.67 or 0.68 (kani/README.md says how to install it). Exit code 0: every \
harness proved or its expected counterexample found, every cover met; 1 some harness refuted; 3 not run, or no \
verdict within the limits; 4 a harness missing or unexpected, or a cover not met."
)]
pub struct Args {
    /// Parts of the names of harnesses [default: all]
    #[arg(value_name = "NAMES")]
    pub names: Vec<String>,
    /// List the harnesses, and run none
    #[arg(long)]
    pub list: bool,
    /// Seconds for each harness
    #[arg(long, value_name = "SECONDS", default_value_t = 60, value_parser = clap::value_parser!(u64).range(1..))]
    pub timeout: u64,
    /// Memory for each harness, in MiB
    #[arg(long, value_name = "MIB", default_value_t = 4096, value_parser = clap::value_parser!(u64).range(256..=1_048_576))]
    pub memory: u64,
    /// Harnesses at a time [default: as many as processors and free memory allow]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// The repository
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub root: PathBuf,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub format: OutputFormat,
    /// Also write the run as JSON into this file
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Runs Kani on the harnesses, or lists them.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    if args.list {
        return list(args, out);
    }
    if !args.root.join("kani/Cargo.toml").is_file() {
        let root = args.root.display();
        return Err(Error::input(format!(
            "--root: `{root}`: expected the repository, with its folder `kani`"
        )));
    }
    let limits = Limits::allowed(args.jobs.map(usize::from), args.timeout, args.memory);
    let report = match Kani::find() {
        Ok(kani) => check(&args.root, &kani, &args.names, limits)?,
        Err(why) => Err(why),
    };
    let report = match report {
        Ok(report) => report,
        Err(NotRun(why)) => {
            // There is no result, so nothing may appear where results are read.
            writeln!(std::io::stderr(), "not run: {why}")?;
            return Ok(Outcome::Inconclusive);
        }
    };
    match args.format {
        OutputFormat::Text => report.text(out)?,
        OutputFormat::Json => report.json(out)?,
    }
    if let Some(path) = &args.out {
        files::write_whole(path, |file| report.json(file))?;
    }
    Ok(report.outcome())
}

fn list(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let harnesses = selected(&args.names);
    match args.format {
        OutputFormat::Text => {
            for h in &harnesses {
                writeln!(out, "{:<11} {}: {}", h.subject, h.name, (h.bounds)())?;
            }
            writeln!(out, "{} harnesses", harnesses.len())?;
        }
        OutputFormat::Json => {
            let rows = harnesses.iter().map(|h| {
                json!({
                    "name": h.name,
                    "subject": h.subject,
                    "claim": h.claim,
                    "bounds": (h.bounds)(),
                    "expected": expectation(h),
                    "functions": h.functions,
                })
            });
            let rows: Vec<_> = rows.collect();
            let page = json!({ "schema": "cordon-harnesses/1", "harnesses": rows });
            writeln!(out, "{page:#}")?;
        }
    }
    Ok(Outcome::Holds)
}
