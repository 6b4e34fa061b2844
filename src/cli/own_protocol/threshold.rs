//! The critical value of a parameter of a protocol of one's own.

use std::io::Write;

use serde_json::json;

use super::show::{head, headline};
use crate::cli::select::OutputFormat;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::system::{Parameter, ParameterKind, System};
use cordon_core::{Error, Evidence, Outcome, Result};
use cordon_proof::claims::threshold::{Bracket, Known, Property, critical};

/// Brackets the value of a parameter at which a property is lost.
///
/// # Errors
/// There is no such parameter, or it has no range.
pub fn threshold(
    system: &System,
    name: Option<&str>,
    property: Property,
    digits: usize,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let (missing, expected) = match property {
        Property::Claims => (system.claims.is_empty(), "claims"),
        Property::Convergence => (system.converges.is_none(), "converges"),
    };
    if missing {
        return Err(Error::input(format!(
            "{expected}: none in the protocol file: expected `{expected}`"
        )));
    }
    let ranges = |p: &&Parameter| p.kind == ParameterKind::Constant && p.fixed().is_none();
    let names: Vec<&str> =
        system.parameters.iter().filter(ranges).map(|p| p.name.as_str()).collect();
    let wanted = match (name, names.as_slice()) {
        (Some(name), _) => name,
        (None, [only]) => only,
        (None, []) => {
            let varies = |p: &&Parameter| p.kind == ParameterKind::Varying;
            let varying =
                system.parameters.iter().find(varies).map_or_else(String::new, |p| {
                    format!(" (`{}` varies from step to step)", p.name)
                });
            return Err(Error::input(format!(
                "parameter: no constant has a range{varying}: expected one in the file, or `--set NAME=LO..HI`"
            )));
        }
        (None, _) => {
            return Err(Error::input(format!(
                "parameter: {} parameters have ranges: expected --parameter with one of them",
                names.len()
            )));
        }
    };
    let Some(index) = system.parameters.iter().position(|p| ranges(&p) && p.name == wanted) else {
        return Err(Error::input(format!(
            "parameter: `{wanted}`: expected a parameter with a range: {}",
            if names.is_empty() { "there is none".to_owned() } else { names.join(", ") }
        )));
    };
    if format == OutputFormat::Text {
        writeln!(out, "{}", headline(system))?;
        out.flush()?;
    }
    let (found, ends) = critical(system, index, property, digits)?;
    match format {
        OutputFormat::Text => match &found {
            Some(bracket) => bracketed(wanted, property, bracket, digits, out)?,
            None => {
                let word = |k| match k {
                    Known::Holds => "holds",
                    Known::Fails => "fails",
                    Known::Open => "is open",
                };
                writeln!(
                    out,
                    "  no bracket: it {} at the lower end of {wanted} and {} at the upper end",
                    word(ends[0]),
                    word(ends[1])
                )?;
            }
        },
        OutputFormat::Json => {
            let mut page = head(system);
            page.insert(
                "threshold",
                json!({
                    "parameter": wanted,
                    "property": match property {
                        Property::Claims => "claims",
                        Property::Convergence => "convergence",
                    },
                    "holds": found.as_ref().map(|b| fraction(&b.holds)),
                    "fails": found.as_ref().map(|b| fraction(&b.fails)),
                    "used_up": found.as_ref().is_some_and(|b| b.used_up),
                    "open": found.as_ref().and_then(|b| b.open.as_ref()).map(fraction),
                }),
            );
            writeln!(out, "{:#}", json!(page))?;
        }
    }
    Ok(match &found {
        Some(Bracket { open: None, used_up: false, .. }) => Outcome::Holds,
        _ => Outcome::Inconclusive,
    })
}

fn bracketed(
    name: &str,
    property: Property,
    found: &Bracket,
    digits: usize,
    out: &mut dyn Write,
) -> Result<()> {
    let places = digits + 2;
    let (what, by) = match property {
        Property::Claims => ("the claims", "an exact run"),
        Property::Convergence => ("convergence", "a form that never falls"),
    };
    writeln!(
        out,
        "  holds  at {name} = {} ({}): {what}, {}",
        fraction(&found.holds),
        decimal_string(&found.holds, places),
        Evidence::Certified
    )?;
    writeln!(
        out,
        "  fails  at {name} = {} ({}): {by}",
        fraction(&found.fails),
        decimal_string(&found.fails, places)
    )?;
    if let Some(open) = &found.open {
        writeln!(
            out,
            "  open   at {name} = {} ({}): neither was found there, so that the bracket stays as wide",
            fraction(open),
            decimal_string(open, places)
        )?;
    }
    if found.used_up {
        writeln!(
            out,
            "  (near the critical value searches are long: their work is used up, so that the bracket stays as wide)"
        )?;
    }
    Ok(())
}
