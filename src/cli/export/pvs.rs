//! `cordon export pvs`.

use std::io::Write;
use std::path::PathBuf;

use super::super::own_protocol::ProtocolArgs;
use cordon_core::system::System;
use cordon_core::{Error, Outcome, Result};

use cordon_proof::claims;
use cordon_proof::export::pvs::{File, Instance, files, own};
use cordon_run::scenario::{self, Scenario};

/// Arguments of `cordon export pvs`.
#[derive(clap::Args, Debug)]
#[command(
    after_help = "Writes coverage.pvs (Listings 3 and 4), coverage_theorems.pvs, fmu_coverage.pvs (Listings 5 and 6, \
projection theorem), consensus.pvs (with formation) and scenario.pvs, each with its proofs (.prf). `proveit` of PVS \
replays them. Without --out the theories follow one another on stdout. With --protocol: own_protocol.pvs, its step, \
the invariant that `cordon prove` finds, and the proofs that every step keeps it."
)]
pub struct Args {
    /// Scenario file (TOML) of the coverage protocol [default: the paper's run of Fig. 8]
    #[arg(long, value_name = "FILE", conflicts_with = "protocol")]
    pub scenario: Option<PathBuf>,
    #[command(flatten)]
    pub own: ProtocolArgs,
    /// Folder to write the files to; it is created where it is missing
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Most drones of a scenario theory, whose start is a chain of that many conditions.
const MAX_DRONES: usize = 1_000;

/// Writes the theory to a file or to stdout.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let files = match args.own.system()? {
        Some((_, system)) => vec![theory(&system)?],
        None => files(&instance(args)?),
    };
    match &args.out {
        None => {
            for file in &files {
                out.write_all(file.theories.as_bytes())?;
                writeln!(out)?;
            }
        }
        Some(folder) => {
            std::fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
            for file in &files {
                for (ending, text) in [("pvs", &file.theories), ("prf", &file.proofs)] {
                    let path = folder.join(file.name).with_extension(ending);
                    cordon_core::files::write_atomically(&path, text.as_bytes())?;
                    writeln!(out, "{}", path.display())?;
                }
            }
        }
    }
    Ok(Outcome::Holds)
}

/// The theory of a protocol file, with the invariant of a proof where one is found.
fn theory(system: &System) -> Result<File> {
    own(system, claims::prove(system).as_ref())
}

fn instance(args: &Args) -> Result<Instance> {
    let scenario = match &args.scenario {
        Some(path) => scenario::read(path)?.finish()?,
        None => scenario::parse("scenarios/paper.toml", PAPER)?.finish()?,
    };
    let of_file = |message: String| match &args.scenario {
        Some(path) => Error::input(format!("{}: {message}", path.display())),
        None => Error::input(message),
    };
    let Scenario { title, .. } = &scenario;
    let params = scenario.params().ok_or_else(|| {
        of_file(format!(
            "protocol: `{}`: expected `coverage`, the protocol of the paper's listings",
            scenario.protocol.name()
        ))
    })?;
    if scenario.count() > MAX_DRONES {
        let count = scenario.count();
        return Err(of_file(format!(
            "drones: `{count}`: expected at most {MAX_DRONES} in a PVS theory"
        )));
    }
    Ok(Instance { title: title.clone(), params, initial: scenario.initial() })
}

/// The shipped scenario of Fig. 8.
const PAPER: &str = include_str!("../../../scenarios/paper.toml");
