//! The critical value of a parameter of a protocol of one's own.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::ProtocolArgs;
use super::page::Page;
use crate::cli::select::OutputFormat;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::system::{Parameter, ParameterKind, System};
use cordon_core::{Error, Evidence, Outcome, Rational, Result};
use cordon_proof::claims::threshold::{Bracket, Known, Property, WORK, critical};

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Asked<'a> {
    /// The parameter; `None` for the only one with a range.
    pub parameter: Option<&'a str>,
    /// What is lost at its critical value.
    pub property: Property,
    /// Decimal places of the bracket.
    pub digits: usize,
    /// Folder for the certificates of both sides.
    pub folder: Option<&'a Path>,
}

/// Brackets the value of a parameter at which a property is lost.
///
/// # Errors
/// There is no such parameter, or it has no range; a certificate cannot be written.
pub fn threshold(
    args: &ProtocolArgs,
    system: &System,
    asked: &Asked<'_>,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let &Asked { parameter: name, property, digits, folder } = asked;
    let (missing, expected) = match property {
        Property::Claims => (system.claims.is_empty(), "claims"),
        Property::Convergence => (system.converges.is_none(), "converges"),
    };
    if missing {
        return Err(args.misses(expected, &format!("`{expected}` for this property")));
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
    let mut page = Page::new(args, system, folder, format, out);
    page.headline(system)?;
    let (found, ends) = critical(system, index, property, digits, WORK)?;
    let mut files = Vec::new();
    match &found {
        Some(bracket) => {
            bracketed(wanted, property, bracket, digits, &mut page)?;
            for (side, certificate) in ["-holds", "-fails"].iter().zip(&bracket.certificates) {
                if let Some(certificate) = certificate {
                    files.extend(page.certificate(side, certificate)?);
                }
            }
        }
        None => {
            let [low, high] = ends.map(|known| match known {
                Known::Open => "is open",
                known => word(known),
            });
            page.line(format_args!(
                "  no bracket: it {low} at the lower end of {wanted} and {high} at the upper end"
            ))?;
        }
    }
    page.field(
        "threshold",
        json!({
            "parameter": wanted,
            "property": match property {
                Property::Claims => "claims",
                Property::Convergence => "convergence",
            },
            "holds": found.as_ref().map(|b| fraction(&b.holds)),
            "fails": found.as_ref().map(|b| fraction(&b.fails)),
            "ends": ends_json(system, index, ends),
            "used_up": found.as_ref().is_some_and(|b| b.used_up),
            "open": found.as_ref().and_then(|b| b.open.as_ref()).map(fraction),
            "files": files,
        }),
    );
    page.end()?;
    Ok(match &found {
        Some(Bracket { open: None, used_up: false, .. }) => Outcome::Holds,
        _ => Outcome::Inconclusive,
    })
}

/// What is known, in a word.
fn word(known: Known) -> &'static str {
    match known {
        Known::Holds => "holds",
        Known::Fails => "fails",
        Known::Open => "open",
    }
}

/// Both ends of the range, and what is known there.
fn ends_json(system: &System, index: usize, known: [Known; 2]) -> Value {
    let end = |x: &Rational, known| json!({ "value": fraction(x), "known": word(known) });
    let range = system.parameters.get(index);
    json!(range.map(|p| [end(&p.low, known[0]), end(&p.high, known[1])]))
}

fn bracketed(
    name: &str,
    property: Property,
    found: &Bracket,
    digits: usize,
    page: &mut Page<'_>,
) -> Result<()> {
    let (what, by) = match (property, &found.certificates[1]) {
        (Property::Claims, _) => ("the claims", "an exact run"),
        (Property::Convergence, Some(_)) => ("convergence", "a form that never falls"),
        (Property::Convergence, None) => ("convergence", "a step that moves the targets"),
    };
    let at = |x| format!("at {name} = {} ({})", fraction(x), decimal_string(x, digits + 2));
    page.line(format_args!("  holds  {}: {what}, {}", at(&found.holds), Evidence::Certified))?;
    page.line(format_args!("  fails  {}: {by}", at(&found.fails)))?;
    if let Some(open) = &found.open {
        page.line(format_args!(
            "  open   {}: neither was found there, so the bracket ends here",
            at(open)
        ))?;
    }
    if found.used_up {
        page.line(
            "  (near the critical value searches are long: the work allowed for them is used up)",
        )?;
    }
    Ok(())
}
