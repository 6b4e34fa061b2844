//! `cargo xtask verify`.

use std::io::{IsTerminal, Write};
use std::path::PathBuf;

use crate::verify::matrix::collect;
use crate::verify::record::Records;
use crate::verify::show::{json, text};
use crate::verify::{Context, NAMES, Tier, tiers};
use cordon_core::theorems;
use cordon_core::{Error, Outcome, Result};

/// Arguments of `cargo xtask verify`.
#[derive(clap::Args, Debug)]
#[command(
    after_help = "Tiers: simulated, grid, complete, kani, smt, creusot, certificate, rocq, lean, pvs. Those that \
take minutes (kani, creusot, rocq, lean, pvs) run with --run only and are otherwise shown by record; a record whose sources have \
changed is stale. Exit code 0: nothing refuted and some tier ran; 1 refuted; 3 nothing ran; 4 rejected."
)]
pub struct Args {
    /// Which theorems: numbers like 7.2 or 7.4ii, separated by commas [default: all]
    #[arg(value_name = "THEOREMS")]
    pub theorems: Option<String>,
    /// Which tiers, separated by commas [default: all]
    #[arg(long, value_name = "TIERS")]
    pub tiers: Option<String>,
    /// Run these tiers as well: kani, creusot, rocq, lean, pvs, or all
    #[arg(long, value_name = "TIERS")]
    pub run: Option<String>,
    /// Run a tier on all theorems and write what it found into proofs/records.json
    #[arg(long, value_name = "TIER", conflicts_with_all = ["theorems", "tiers", "run"])]
    pub record: Option<String>,
    /// The repository: its certificates, developments and records
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub root: PathBuf,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// Form of the matrix.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// For people
    Text,
    /// JSON, schema cordon-verify/1
    Json,
}

/// Shows the matrix, or records a tier.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    if !args.root.is_dir() {
        let root = args.root.display();
        return Err(Error::input(format!("--root: `{root}`: expected a folder")));
    }
    let records = Records::read(&args.root)?;
    if let Some(name) = &args.record {
        return record(name, args, records, out);
    }
    let theorems = theorems::named(args.theorems.as_deref().unwrap_or("all"))?;
    let wanted = names("--tiers", args.tiers.as_deref().unwrap_or("all"))?;
    let requested = args.run.as_deref().map_or(Ok(Vec::new()), |list| names("--run", list))?;
    let tiers = chosen(&Context { root: &args.root, run: &requested }, &wanted);
    let matrix = collect(&args.root, &tiers, &records, &theorems, |tier| {
        if std::io::stderr().is_terminal() {
            // If stderr is closed nothing is lost.
            let _ = writeln!(std::io::stderr(), "verify: {tier}");
        }
    });
    match args.format {
        Format::Text => text(&matrix, out)?,
        Format::Json => out.write_all(json(&matrix).as_bytes())?,
    }
    Ok(matrix.outcome())
}

fn chosen(context: &Context<'_>, wanted: &[String]) -> Vec<Box<dyn Tier>> {
    let mut tiers = tiers(*context);
    tiers.retain(|t| wanted.iter().any(|name| name == t.name()));
    tiers
}

/// The tiers in a list.
fn names(flag: &str, list: &str) -> Result<Vec<String>> {
    if list.trim() == "all" {
        return Ok(NAMES.map(str::to_owned).to_vec());
    }
    list.split(',')
        .map(str::trim)
        .map(|name| {
            if NAMES.contains(&name) {
                Ok(name.to_owned())
            } else {
                let known = NAMES.join(", ");
                Err(Error::input(format!(
                    "{flag}: `{name}` is not a tier: expected `all` or some of {known}"
                )))
            }
        })
        .collect()
}

fn record(name: &str, args: &Args, records: Records, out: &mut dyn Write) -> Result<Outcome> {
    let name = names("--record", name)?;
    let tiers = chosen(&Context { root: &args.root, run: &name }, &name);
    let [tier] = tiers.as_slice() else {
        return Err(Error::input("--record: `all`: expected one tier"));
    };
    let path = records.record(&args.root, tier.as_ref(), &theorems::named("all")?)?;
    writeln!(out, "{}: recorded in {}", tier.name(), path.display())?;
    Ok(Outcome::Holds)
}
