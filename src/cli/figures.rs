//! `cordon figures`.

use std::io::Write;

use super::choice::{Choice, choice};
use std::path::PathBuf;

use cordon_core::{Error, Outcome, Result};
use cordon_paper::figures::{FIGURES, Format, drawable};

/// Arguments of `cordon figures`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Only these numbers, separated by commas [default: all, 8 to 16]
    #[arg(value_name = "NUMBERS", value_delimiter = ',')]
    numbers: Vec<u32>,
    /// Folder for the figures, created if missing
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
    /// Form of the figures
    #[arg(long, value_parser = choice::<Format>(), default_value = "svg")]
    format: Format,
}

/// Runs and draws the figures, and prints the names of the files.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    drawable()?;
    let known = |n: &u32| FIGURES.iter().any(|f| f.number == *n);
    if let Some(unknown) = args.numbers.iter().find(|n| !known(n)) {
        let numbers: Vec<_> = FIGURES.iter().map(|f| f.number.to_string()).collect();
        return Err(Error::input(format!(
            "figure: `{unknown}` is unknown: expected some of {}",
            numbers.join(", ")
        )));
    }
    std::fs::create_dir_all(&args.out).map_err(|e| Error::file("make", &args.out, e))?;
    for figure in
        FIGURES.iter().filter(|f| args.numbers.is_empty() || args.numbers.contains(&f.number))
    {
        let path = figure.save(args.format, &args.out)?;
        writeln!(out, "{}", path.display())?;
    }
    Ok(Outcome::Holds)
}

impl Choice for Format {
    const ALL: &'static [(&'static str, Self, &'static str)] = &[
        ("svg", Self::Svg, "Scalable Vector Graphics"),
        ("png", Self::Png, "Portable Network Graphics"),
    ];
}
