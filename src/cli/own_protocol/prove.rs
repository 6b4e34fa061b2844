//! Proofs of the claims of a protocol file.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::ProtocolArgs;
use super::refute::{Search, refuted_claims};
use super::show::{constants_text, head, headline};
use crate::cli::select::OutputFormat;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::system::System;
use cordon_core::{Error, Evidence, Outcome, Result};
use cordon_proof::certificate;
use cordon_proof::claims::any_size::any_size;
use cordon_proof::claims::certificate::certificate as sealed;
use cordon_proof::claims::converge::{self, Contraction, Growth};
use cordon_proof::claims::{self, Proved};
use cordon_proof::counterexample::list;
use cordon_run::protocol::{Classes, ProtocolFile};

/// Proves what a protocol file claims, or refutes it, or says that it can do neither: first the claims
/// about every step, then convergence.
///
/// # Errors
/// A certificate cannot be written, or is beyond the checker's limits.
pub fn prove(
    args: &ProtocolArgs,
    file: &ProtocolFile,
    system: &System,
    folder: Option<&Path>,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let mut page = head(system);
    let mut outcome = Outcome::Holds;
    let text = format == OutputFormat::Text;
    let for_every = match args.classes(file)? {
        None => None,
        Some(classes) => Some(every_number(args, classes, folder)?),
    };
    if let Some(found) = &for_every {
        if text {
            every_number_text(system, found, out)?;
        }
        page.insert(
            "every_number",
            json!({
                "proved": found.proved,
                "reason": found.reason,
                "clauses": found.clauses,
                "file": found.file,
            }),
        );
    }
    let is_proved = for_every.as_ref().is_some_and(|f| f.proved);
    if for_every.is_some() && !is_proved {
        if let Some((args, system)) = refuted_above(args, file, system.agents)? {
            if text {
                writeln!(out, "{}", headline(&system))?;
            }
            let (ended, found) = refuted_claims(&args, &system, &Search::default(), text, out)?;
            page.insert("claims", found);
            if !text {
                writeln!(out, "{:#}", json!(page))?;
            }
            return Ok(ended);
        }
        // Asked of every number, and shown for some.
        outcome = Outcome::Inconclusive;
    }
    // What the kernel proves of N >= 3 leaves smaller numbers, and convergence.
    let is_left = !is_proved || system.agents < 3 || system.converges.is_some();
    if text && is_left {
        writeln!(out, "{}", headline(system))?;
    }
    if !system.claims.is_empty() && (!is_proved || system.agents < 3) {
        match claims::prove(system) {
            Some(found) => {
                let certificate = sealed(&found.system, &found.proof)
                    .ok_or_else(|| Error::internal("a proof without a certificate"))?;
                certificate::judged(&certificate)?;
                let file = written(args, folder, "", &certificate)?;
                if text {
                    proved(&found, file.as_deref(), out)?;
                }
                page.insert(
                    "claims",
                    json!({
                        "proved": true,
                        "evidence": Evidence::Certified,
                        "half_spaces": found.proof.rows.len(),
                        "claimed": claimed(&found),
                        "file": file,
                    }),
                );
            }
            None => {
                let (ended, found) = refuted_claims(args, system, &Search::default(), text, out)?;
                outcome = outcome.worst(ended);
                page.insert("claims", found);
            }
        }
    }
    if system.converges.is_some() {
        let (ended, found) = convergence(args, system, folder, text, out)?;
        outcome = outcome.worst(ended);
        page.insert("convergence", found);
    }
    if !text {
        writeln!(out, "{:#}", json!(page))?;
    }
    Ok(outcome)
}

/// Numbers of agents above the fewest that are tried for a counterexample.
const MORE_AGENTS: usize = 2;

/// The system with a few agents more than the fewest, where its claims fail of some start.
fn refuted_above(
    args: &ProtocolArgs,
    file: &ProtocolFile,
    fewest: usize,
) -> Result<Option<(ProtocolArgs, System)>> {
    let search = Search::default();
    for agents in fewest + 1..=fewest + MORE_AGENTS {
        let system = args.sized(file, agents)?;
        let constants = claims::constants(&system, search.denominators).unwrap_or_default();
        if claims::refute(&system, &constants, None, search.steps).0.is_some() {
            return Ok(Some((ProtocolArgs { agents: Some(agents), ..args.clone() }, system)));
        }
    }
    Ok(None)
}

/// What is known for every number of agents.
struct EveryNumber {
    proved: bool,
    /// Why not.
    reason: Option<String>,
    /// Clauses of the invariant.
    clauses: Option<usize>,
    file: Option<String>,
}

fn every_number(
    args: &ProtocolArgs,
    classes: std::result::Result<Classes, String>,
    folder: Option<&Path>,
) -> Result<EveryNumber> {
    match classes.and_then(|classes| any_size(&classes)) {
        Ok((certificate, clauses)) => {
            certificate::judged(&certificate)?;
            let file = written(args, folder, "-every-n", &certificate)?;
            Ok(EveryNumber { proved: true, reason: None, clauses: Some(clauses), file })
        }
        Err(reason) => {
            Ok(EveryNumber { proved: false, reason: Some(reason), clauses: None, file: None })
        }
    }
}

fn every_number_text(system: &System, found: &EveryNumber, out: &mut dyn Write) -> Result<()> {
    match (&found.reason, found.clauses) {
        (None, Some(clauses)) => {
            writeln!(out, "{}: every number of agents from 3 on", system.title)?;
            writeln!(out, "  proved: the claims hold at every step from every assumed start")?;
            writeln!(
                out,
                "  {}: by induction over the steps, with cases over the agents; {clauses} clause{} in the \
                 invariant",
                Evidence::Certified,
                if clauses == 1 { "" } else { "s" }
            )?;
        }
        (reason, _) => writeln!(
            out,
            "{}: not proved for every number of agents: {}",
            system.title,
            reason.as_deref().unwrap_or("")
        )?,
    }
    if let Some(file) = &found.file {
        writeln!(out, "  wrote {file}")?;
    }
    Ok(())
}

fn convergence(
    args: &ProtocolArgs,
    system: &System,
    folder: Option<&Path>,
    text: bool,
    out: &mut dyn Write,
) -> Result<(Outcome, Value)> {
    let (outcome, page, file) = if let Some(found) = converge::contraction(system)? {
        if text {
            converges(&found, out)?;
        }
        let file = written(args, folder, "-converges", &found.certificate)?;
        let rate = fraction(&found.rate);
        (
            Outcome::Holds,
            json!({ "proved": true, "evidence": Evidence::Certified, "rate": rate }),
            file,
        )
    } else if let Some(found) = converge::grows(system)? {
        if text {
            does_not_converge(system, &found, out)?;
        }
        let file = written(args, folder, "-grows", &found.certificate)?;
        let start: Vec<String> = found.start.iter().map(fraction).collect();
        (
            Outcome::Refuted,
            json!({ "proved": false, "evidence": Evidence::Certified, "start": start }),
            file,
        )
    } else {
        if text {
            writeln!(
                out,
                "  convergence: neither a form that falls in every step was found, nor one that does not"
            )?;
        }
        (Outcome::Inconclusive, json!({ "proved": Value::Null }), None)
    };
    if let (true, Some(file)) = (text, &file) {
        writeln!(out, "  wrote {file}")?;
    }
    let mut page = page;
    if let Some(fields) = page.as_object_mut() {
        fields.insert("file".to_owned(), json!(file));
    }
    Ok((outcome, page))
}

fn written(
    args: &ProtocolArgs,
    folder: Option<&Path>,
    what: &str,
    certificate: &Value,
) -> Result<Option<String>> {
    let Some(folder) = folder else { return Ok(None) };
    let stem = args.path().file_stem().map_or_else(|| "own".into(), |s| s.to_string_lossy());
    let path = certificate::write(folder, &format!("{stem}{what}"), certificate)?;
    Ok(Some(path.display().to_string()))
}

fn claimed(found: &Proved) -> usize {
    found.proof.rows.iter().filter(|r| r.claim.is_some()).count()
}

fn proved(found: &Proved, file: Option<&str>, out: &mut dyn Write) -> Result<()> {
    let rows = found.proof.rows.len();
    writeln!(out, "  proved: the claims hold at every step from every assumed start")?;
    writeln!(
        out,
        "  {}: {rows} half-space{}, {} of them claimed; the start meets them, every step keeps them, at \
         the ends of all ranges and so between",
        Evidence::Certified,
        if rows == 1 { "" } else { "s" },
        claimed(found)
    )?;
    if let Some(file) = file {
        writeln!(out, "  wrote {file}")?;
    }
    Ok(())
}

fn converges(found: &Contraction, out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "  converges: a quadratic form of what has to vanish falls in every step, its root by {} ({}) at \
         least",
        fraction(&found.rate),
        decimal_string(&found.rate, 6)
    )?;
    writeln!(
        out,
        "  {}: from every start, whatever the parameters are in their ranges, the same in all steps or not",
        Evidence::Certified
    )?;
    Ok(())
}

fn does_not_converge(system: &System, found: &Growth, out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "  does not converge{}: a quadratic form that is positive at the start never falls",
        constants_text(system, &found.values)
    )?;
    writeln!(out, "  {}: start {}", Evidence::Certified, list(&found.start))?;
    Ok(())
}
