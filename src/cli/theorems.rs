//! `cordon theorems`.

use std::io::Write;

use cordon_spec::theorems::{Form, Theorem};
use serde_json::json;

use super::own_protocol;
use super::select::OutputFormat;
use cordon_core::theorems::{self, starts, weights, words};
use cordon_core::{Outcome, Result};

/// Arguments of `cordon theorems`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Which theorems: numbers like 7.2 or 7.4ii, separated by commas [default: all]
    #[arg(value_name = "NUMBERS", conflicts_with = "protocol")]
    pub numbers: Option<String>,
    #[command(flatten)]
    pub own: own_protocol::ProtocolArgs,
    /// With --protocol: prove or refute each claim, and say what is known of it
    #[arg(long = "check", help_heading = "Own protocol")]
    pub known: bool,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub format: OutputFormat,
}

/// Lists the theorems, or the claims of a protocol file.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    if let Some((file, system)) = args.own.system()? {
        return own_protocol::theorems(&args.own, &file, &system, args.known, args.format, out);
    }
    let theorems = theorems::named(args.numbers.as_deref().unwrap_or("all"))?;
    match args.format {
        OutputFormat::Text => theorems.iter().try_for_each(|&t| text(t, out))?,
        OutputFormat::Json => {
            let list: Vec<_> = theorems.iter().map(|&t| as_json(t)).collect();
            let page = json!({ "schema": "cordon-theorems/1", "theorems": list });
            writeln!(out, "{page:#}")?;
        }
    }
    Ok(Outcome::Holds)
}

fn text(theorem: Theorem, out: &mut dyn Write) -> Result<()> {
    let t = words(theorem);
    writeln!(out, "{} {}", theorem.number(), t.name)?;
    for form in Form::ALL {
        let (h, label) = (theorem.hypothesis(form), form.label());
        writeln!(out, "  {label:<6} if   {}; {}", weights(h.weights), starts(h.starts))?;
        writeln!(out, "         then {}", t.conclusion(form))?;
    }
    if let Some(erratum) = t.erratum {
        writeln!(out, "  erratum     {erratum}")?;
    }
    writeln!(out)?;
    Ok(())
}

fn as_json(theorem: Theorem) -> serde_json::Value {
    let t = words(theorem);
    let form = |f| {
        let h = theorem.hypothesis(f);
        json!({
            "weights": weights(h.weights),
            "starts": starts(h.starts),
            "conclusion": t.conclusion(f),
        })
    };
    json!({
        "number": theorem.number(),
        "name": t.name,
        "paper": form(Form::Paper),
        "sharp": form(Form::Sharp),
        "erratum": t.erratum,
    })
}
