//! From which step on a protocol of one's own is near where it converges to.

use std::io::Write;
use std::path::Path;

use serde_json::json;

use super::convergence::round_text;
use super::page::Page;
use super::show::headline;
use super::{ProtocolArgs, assumed};
use crate::cli::select::OutputFormat;
use cordon_core::exact::{decimal_string, fraction, shortened};
use cordon_core::system::{Convergence, System};
use cordon_core::{Error, Evidence, Outcome, Rational, Result, progress};
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
        return Err(args.misses("converges", "`agreement` or `target`"));
    }
    if *within <= Rational::default() {
        return Err(Error::input(format!("within: `{within}`: expected a positive distance")));
    }
    let state = start.map(|x| assumed(system, x)).transpose()?;
    progress::tries("a form that falls in every step");
    let found = converge::contraction(system)?;
    let step = found.as_ref().and_then(|c| settles(system, c, state.as_deref(), within));
    let mut page = Page::new(args, system, folder, format, out);
    page.line(headline(system))?;
    let from = if start.is_some() { "this start" } else { "every assumed start" };
    let of = match system.converges {
        Some(Convergence::Agreement) => "agent 0",
        _ => "its target",
    };
    let distance = fraction(within);
    match (&found, step) {
        (Some(c), Some(step)) => {
            page.line(format_args!(
                "  every agent within {} of {of} from step {step} on, from {from}",
                shortened(&distance)
            ))?;
            page.line(format_args!(
                "  {}: the root of a quadratic form falls to at most {} ({}) of what it was in every {}; the true step may be earlier",
                Evidence::Certified,
                fraction(&c.rate),
                decimal_string(&c.rate, 6),
                round_text(c)
            ))?;
        }
        (Some(_), None) => page.line(
            "  converges, but the assumed starts are not bounded: expected `start` in the file to \
             bound every variable, or --start",
        )?,
        (None, _) => {
            let why = converge::open(system, "no form that falls in every step was found");
            page.line(format_args!("  {why}"))?;
        }
    }
    let file = match &found {
        Some(found) => page.certificate("-converges", &found.certificate)?,
        None => None,
    };
    page.field(
        "settle",
        json!({
            "within": distance,
            "starts": if start.is_some() { "given" } else { "every" },
            "step": step,
            "rate": found.as_ref().map(|c| fraction(&c.rate)),
            "round": found.as_ref().map(|c| c.round),
            "file": file,
        }),
    );
    page.end()?;
    Ok(if step.is_some() { Outcome::Holds } else { Outcome::Inconclusive })
}
