//! From which step on a protocol of one's own is near where it converges to.

use std::io::Write;
use std::path::Path;

use serde_json::json;

use super::prove::{round_text, written};
use super::show::{head, headline};
use super::{ProtocolArgs, assumed};
use crate::cli::select::OutputFormat;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::system::{Convergence, System};
use cordon_core::{Error, Evidence, Outcome, Rational, Result};
use cordon_proof::claims::converge;
use cordon_proof::claims::settle::settles;

/// The step from which on everything that has to vanish is at most `within`.
///
/// # Errors
/// The file does not say where the system converges to; the distance is not positive.
pub fn settle(
    args: &ProtocolArgs,
    system: &System,
    start: Option<&[Rational]>,
    within: &Rational,
    folder: Option<&Path>,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    if system.converges.is_none() {
        return Err(Error::input(
            "converges: is missing in the protocol file: expected `agreement` or `target`",
        ));
    }
    if *within <= Rational::default() {
        return Err(Error::input(format!("within: `{within}`: expected a positive distance")));
    }
    let state = start.map(|x| assumed(system, x)).transpose()?;
    let found = converge::contraction(system)?;
    let step = found.as_ref().and_then(|c| settles(system, c, state.as_deref(), within));
    let file = match &found {
        Some(found) => written(args, folder, "-converges", &found.certificate)?,
        None => None,
    };
    match format {
        OutputFormat::Text => {
            writeln!(out, "{}", headline(system))?;
            let from = if start.is_some() { "this start" } else { "every assumed start" };
            let of = match system.converges {
                Some(Convergence::Agreement) => "agent 0",
                _ => "its target",
            };
            match (&found, step) {
                (Some(c), Some(step)) => {
                    writeln!(
                        out,
                        "  every agent within {} of {of} from step {step} on, from {from}",
                        fraction(within)
                    )?;
                    writeln!(
                        out,
                        "  {}: a quadratic form falls by {} ({}) in every {}; the true step may be earlier",
                        Evidence::Certified,
                        fraction(&c.rate),
                        decimal_string(&c.rate, 6),
                        round_text(c)
                    )?;
                }
                (Some(_), None) => writeln!(
                    out,
                    "  converges, but the assumed starts are not bounded: expected `start` in the file to \
                     bound every variable, or --start"
                )?,
                (None, _) => {
                    let why = converge::open(system, "no form that falls in every step was found");
                    writeln!(out, "  {why}")?;
                }
            }
            if let Some(file) = &file {
                writeln!(out, "  wrote {file}")?;
            }
        }
        OutputFormat::Json => {
            let mut page = head(system);
            page.insert(
                "settle",
                json!({
                    "within": fraction(within),
                    "starts": if start.is_some() { "given" } else { "every" },
                    "step": step,
                    "rate": found.as_ref().map(|c| fraction(&c.rate)),
                    "round": found.as_ref().map(|c| c.round),
                    "file": file,
                }),
            );
            writeln!(out, "{:#}", json!(page))?;
        }
    }
    Ok(if step.is_some() { Outcome::Holds } else { Outcome::Inconclusive })
}
