//! `cordon errata`.

use std::io::Write;

use serde_json::json;

use super::select::OutputFormat;
use cordon_core::{Error, Outcome, Result};
use cordon_paper::errata::{self, Erratum, Recomputed};

/// Arguments of `cordon errata`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Only these numbers, separated by commas [default: all]
    #[arg(value_name = "NUMBERS", value_delimiter = ',')]
    numbers: Vec<u32>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
}

/// Establishes the errata and prints them; if one cannot be established, the outcome is a refutation.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let all = errata::all();
    if let Some(unknown) = args.numbers.iter().find(|n| !all.iter().any(|e| e.number == **n)) {
        return Err(Error::input(format!(
            "erratum: `{unknown}` is unknown: expected numbers from 1 to {}",
            all.len()
        )));
    }
    let wanted = |e: &&Erratum| args.numbers.is_empty() || args.numbers.contains(&e.number);
    let found: Vec<(&Erratum, Recomputed)> =
        all.iter().filter(wanted).map(|e| (e, e.establish())).collect();
    match args.format {
        OutputFormat::Text => found.iter().try_for_each(|(e, f)| text(e, f, out))?,
        OutputFormat::Json => {
            let list: Vec<_> = found
                .iter()
                .map(|(e, f)| {
                    json!({
                        "number": e.number,
                        "place": e.place,
                        "printed": e.printed,
                        "established": f.established,
                        "computed": f.computed,
                    })
                })
                .collect();
            writeln!(out, "{:#}", json!({ "schema": "cordon-errata/1", "errata": list }))?;
        }
    }
    let established = found.iter().all(|(_, f)| f.established);
    Ok(if established { Outcome::Holds } else { Outcome::Refuted })
}

fn text(e: &Erratum, f: &Recomputed, out: &mut dyn Write) -> Result<()> {
    let mark = if f.established { "" } else { "NOT ESTABLISHED: " };
    writeln!(out, "{:>2}. {}", e.number, e.place)?;
    writeln!(out, "    printed   {}", e.printed)?;
    writeln!(out, "    computed  {mark}{}", f.computed)?;
    Ok(())
}
