//! Proofs of the claims of a protocol file.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::ProtocolArgs;
use super::refute::{Search, choice_text, choices_json, refuted_claims};
use super::show::{claimed_steps, constants_text, head, headline};
use crate::cli::select::OutputFormat;
use cordon_core::exact::{decimal_string, fraction, shortened};
use cordon_core::system::System;
use cordon_core::{Error, Evidence, Outcome, Result};
use cordon_proof::certificate;
use cordon_proof::claims::certificate::certificate as sealed;
use cordon_proof::claims::converge::{self, Contraction, Growth, Unfixed};
use cordon_proof::claims::{self, Proved, Unproved, pinned};
use cordon_proof::counterexample::list;
use cordon_proof::prove::any_size::any_size;
use cordon_run::protocol::{Family, ProtocolFile};

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
    let for_every = match args.family(file)? {
        None => None,
        Some(family) => Some(every_number(args, family, folder)?),
    };
    if let Some(found) = &for_every {
        if text {
            every_number_text(system, found, out)?;
            out.flush()?;
        }
        page.insert(
            "every_number",
            json!({
                "proved": found.proved,
                "claims": found.claims,
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
            let search = search(&args, folder);
            let (ended, found) = refuted_claims(&args, &system, &search, text, out)?;
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
        out.flush()?;
    }
    if !system.claims.is_empty() && (!is_proved || system.agents < 3) {
        let found = claims::prove_within(system, &claims::PROOF);
        let certificate = found.as_ref().ok().map(certified).transpose()?;
        match (found, certificate) {
            (Ok(found), Some(Ok(certificate))) => {
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
            (found, certificate) => {
                let (known, reason) = match found {
                    Ok(_) => (None, None),
                    Err(Unproved::Fails(run)) => (Some(*run), None),
                    Err(Unproved::Open(end)) => (None, Some(end.to_string())),
                };
                let search = Search { known, ..search(args, folder) };
                let (ended, mut searched) = refuted_claims(args, system, &search, text, out)?;
                if ended == Outcome::Inconclusive {
                    let beyond = certificate.and_then(std::result::Result::err);
                    let reason = beyond.or(reason).unwrap_or_default();
                    if text {
                        writeln!(out, "  not proved: {reason}")?;
                    }
                    if let Some(fields) = searched.as_object_mut() {
                        fields.insert("reason".to_owned(), json!(reason));
                    }
                }
                outcome = outcome.worst(ended);
                page.insert("claims", searched);
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
pub(super) struct EveryNumber {
    pub proved: bool,
    /// The claims that are proved, as they stand in the file.
    pub claims: Vec<String>,
    /// Why not all.
    reason: Option<String>,
    /// Clauses of the invariant.
    clauses: Option<usize>,
    file: Option<String>,
}

/// Proofs for every number of agents, or why there are none.
pub(super) fn every_number(
    args: &ProtocolArgs,
    family: std::result::Result<Family, String>,
    folder: Option<&Path>,
) -> Result<EveryNumber> {
    let none = |reason: String| EveryNumber {
        proved: false,
        claims: Vec::new(),
        reason: Some(reason),
        clauses: None,
        file: None,
    };
    let found =
        family.and_then(|f| any_size(&f).map(|found| (f, found)).map_err(|e| e.to_string()));
    let (family, found) = match found {
        Ok(found) => found,
        Err(reason) => return Ok(none(reason)),
    };
    let text = |index: usize| family.claims.get(index).map_or("", |c| c.text.as_str());
    let reason = found.open.first().map(|(index, why)| match family.claims.len() {
        1 => why.clone(),
        _ => format!("`{}`: {why}", shortened(text(*index))),
    });
    let Some(certificate) = &found.certificate else {
        return Ok(none(reason.unwrap_or_default()));
    };
    if let Some(reason) = beyond_the_checker(certificate)? {
        return Ok(none(reason));
    }
    let is_open = |index: usize| found.open.iter().any(|(open, _)| *open == index);
    let proved = (0..family.claims.len()).filter(|&index| !is_open(index));
    Ok(EveryNumber {
        proved: found.open.is_empty(),
        claims: proved.map(|index| text(index).to_owned()).collect(),
        reason,
        clauses: Some(found.invariant),
        file: written(args, folder, "-every-n", certificate)?,
    })
}

/// Why the checker cannot judge a certificate, where it cannot: it is too large.
///
/// # Errors
/// The checker rejects it.
fn beyond_the_checker(certificate: &Value) -> Result<Option<String>> {
    match certificate::judged(certificate) {
        Ok(_) => Ok(None),
        Err(Error::Input(reason)) => Ok(Some(reason)),
        Err(e) => Err(e),
    }
}

fn every_number_text(system: &System, found: &EveryNumber, out: &mut dyn Write) -> Result<()> {
    if let Some(reason) = &found.reason {
        writeln!(out, "{}: not proved for every number of agents: {reason}", system.title)?;
    }
    if let Some(clauses) = found.clauses {
        let claims = if found.proved {
            writeln!(out, "{}: every number of agents from 3 on", system.title)?;
            "the claims hold".to_owned()
        } else {
            let texts: Vec<String> = found.claims.iter().map(|c| format!("`{c}`")).collect();
            format!("for every number of agents from 3 on, {}", texts.join(", "))
        };
        writeln!(out, "  proved: {claims} at every step from every assumed start")?;
        writeln!(
            out,
            "  {}: by induction over the steps, with cases over the agents; {clauses} clause{} in the \
             invariant",
            Evidence::Certified,
            if clauses == 1 { "" } else { "s" }
        )?;
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
            converges(system, &found, out)?;
        }
        let file = written(args, folder, "-converges", &found.certificate)?;
        let rate = fraction(&found.rate);
        (
            Outcome::Holds,
            json!({ "proved": true, "evidence": Evidence::Certified, "rate": rate, "round": found.round }),
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
            json!({
                "proved": false,
                "evidence": Evidence::Certified,
                "start": start,
                "word": choices_json(system, &found.word),
            }),
            file,
        )
    } else if let Some(found) = converge::unfixed(system) {
        if text {
            moves_the_targets(system, &found, out)?;
        }
        let image: Vec<String> = found.image.iter().map(fraction).collect();
        (
            Outcome::Refuted,
            json!({
                "proved": false,
                "evidence": Evidence::CompleteForAllStarts,
                "targets_become": image,
                "word": choices_json(system, std::slice::from_ref(&found.step)),
            }),
            None,
        )
    } else {
        if text {
            let nothing =
                "neither a form that falls in every step was found, nor one that does not";
            let why = converge::open(system, nothing);
            writeln!(out, "  convergence: {why}")?;
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

/// What is searched for a counterexample where no proof was found.
fn search(args: &ProtocolArgs, folder: Option<&Path>) -> Search {
    let file = folder.map(|folder| folder.join(format!("{}-refuted.json", stem(args))));
    Search { file, ..Search::default() }
}

/// What certificates about a protocol file are named after.
fn stem(args: &ProtocolArgs) -> String {
    args.path().file_stem().map_or_else(|| "own".into(), |s| s.to_string_lossy().into_owned())
}

pub(super) fn written(
    args: &ProtocolArgs,
    folder: Option<&Path>,
    what: &str,
    certificate: &Value,
) -> Result<Option<String>> {
    let Some(folder) = folder else { return Ok(None) };
    let path = certificate::write(folder, &format!("{}{what}", stem(args)), certificate)?;
    Ok(Some(path.display().to_string()))
}

/// The certificate of a proof, accepted by the checker; or why that cannot judge it.
///
/// # Errors
/// The checker rejects it.
pub(super) fn certified(found: &Proved) -> Result<std::result::Result<Value, String>> {
    let certificate = sealed(&found.system, &found.proof)
        .ok_or_else(|| Error::internal("a proof without a certificate"))?;
    Ok(beyond_the_checker(&certificate)?.map_or(Ok(certificate), Err))
}

fn claimed(found: &Proved) -> usize {
    found.proof.rows.iter().filter(|r| r.claim.is_some()).count()
}

fn proved(found: &Proved, file: Option<&str>, out: &mut dyn Write) -> Result<()> {
    let rows = found.proof.rows.len();
    let steps = claimed_steps(&found.system);
    writeln!(out, "  proved: the claims hold at {steps} from every assumed start")?;
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

fn converges(system: &System, found: &Contraction, out: &mut dyn Write) -> Result<()> {
    let (forms, roots) = match found.forms.len() {
        1 => ("a quadratic form of what has to vanish falls", "its root"),
        _ => ("quadratic forms of what has to vanish, one for each mode, fall", "their roots"),
    };
    writeln!(
        out,
        "  converges: {forms} in every {}, {roots} by {} ({}) at least",
        round_text(found),
        fraction(&found.rate),
        decimal_string(&found.rate, 6)
    )?;
    let pinned = pinned::texts(system);
    let starts = match pinned.as_slice() {
        [] => "every start".to_owned(),
        all => format!("every start with {}", all.join(", ")),
    };
    writeln!(
        out,
        "  {}: from {starts}, whatever the parameters are in their ranges, the same in all steps or not",
        Evidence::Certified
    )?;
    Ok(())
}

/// `step`, or `round of 2 steps` of modes in turn.
pub(super) fn round_text(found: &Contraction) -> String {
    match found.round {
        1 => "step".to_owned(),
        n => format!("round of {n} steps"),
    }
}

fn moves_the_targets(system: &System, found: &Unfixed, out: &mut dyn Write) -> Result<()> {
    let at = constants_text(system, &found.step.values);
    let now = system.state.len() - system.past.len();
    let image = list(found.image.get(..now).unwrap_or_default());
    let with = match choice_text(system, &found.step) {
        choice if choice.is_empty() => String::new(),
        choice => format!(" ({choice})"),
    };
    writeln!(out, "  does not converge{at}: a step{with} takes the targets to {image}")?;
    writeln!(
        out,
        "  {}: no run that goes on like that ends there",
        Evidence::CompleteForAllStarts
    )?;
    Ok(())
}

fn does_not_converge(system: &System, found: &Growth, out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "  does not converge{}: a quadratic form that is positive at the start never falls",
        constants_text(system, &found.values)
    )?;
    if !system.is_deterministic() {
        let steps: Vec<String> = found.word.iter().map(|c| choice_text(system, c)).collect();
        writeln!(out, "  with these steps, over and over: {}", steps.join("; "))?;
    }
    writeln!(out, "  {}: start {}", Evidence::Certified, list(&found.start))?;
    Ok(())
}
