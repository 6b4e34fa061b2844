//! The claims of a protocol of one's own, and what is known of each.

use std::io::Write;

use serde_json::{Value, json};

use super::refute::{Search, as_json, constants_of, replay_line};
use super::show::{constants_text, head, headline, when};
use super::{ProtocolArgs, prove};
use crate::cli::select::OutputFormat;
use cordon_core::system::{Convergence, System};
use cordon_core::{Evidence, Outcome, Result};
use cordon_proof::claims::{self, Run, Unproved, converge};
use cordon_run::protocol::ProtocolFile;

/// What is known of a claim.
enum Known {
    /// A certificate for every number of agents from 3 on.
    EveryNumber,
    /// A certificate for this number.
    Certified,
    /// It fails in a run.
    Fails(Box<Run>),
    /// A certificate that it fails.
    CertifiedFailure,
    /// Neither; no counterexample up to that step.
    Open(Option<usize>),
}

impl Known {
    fn outcome(&self) -> Outcome {
        match self {
            Self::EveryNumber | Self::Certified => Outcome::Holds,
            Self::Fails(_) | Self::CertifiedFailure => Outcome::Refuted,
            Self::Open(_) => Outcome::Inconclusive,
        }
    }
}

/// Lists what is assumed and claimed; with `check` also what is known of each claim.
///
/// # Errors
/// The checker rejects what was found, or there are too many constants to try.
pub fn theorems(
    args: &ProtocolArgs,
    file: &ProtocolFile,
    system: &System,
    check: bool,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let text = format == OutputFormat::Text;
    let starts = system.written_starts();
    if text {
        writeln!(out, "{}", headline(system))?;
        for start in &starts {
            writeln!(out, "  if      {start}")?;
        }
        out.flush()?;
    }
    let known = if check { Some(known(args, file, system)?) } else { None };
    let mut rows: Vec<(String, String)> = Vec::new();
    for (claim, indices) in system.written_claims() {
        let first = indices.first().and_then(|&j| system.claims.get(j));
        rows.push((claim.to_owned(), first.map_or_else(String::new, when)));
    }
    if let Some(to) = &system.converges {
        let claim = match to {
            Convergence::Agreement => "the agents agree in the end",
            Convergence::To(_) => "every variable tends to its target",
        };
        rows.push((claim.to_owned(), String::new()));
    }
    let of = |index: usize| known.as_ref().and_then(|known| known.get(index));
    if text {
        for (index, (claim, about)) in rows.iter().enumerate() {
            writeln!(out, "  claim {}  {claim}{about}", index + 1)?;
            if let Some(known) = of(index) {
                known_text(args, system, known, out)?;
            }
        }
    } else {
        let row = |(index, (claim, about)): (usize, &(String, String))| -> Value {
            json!({
                "claim": claim,
                "when": about.trim_start_matches(", "),
                "known": of(index).map(|known| known_json(args, system, known)),
            })
        };
        let mut page = head(system);
        page.insert("starts", json!(starts));
        page.insert("theorems", rows.iter().enumerate().map(row).collect::<Vec<_>>().into());
        writeln!(out, "{:#}", json!(page))?;
    }
    let outcomes = known.iter().flatten().map(Known::outcome);
    Ok(outcomes.fold(Outcome::Holds, Outcome::worst))
}

/// What is known of each claim as written, and last of convergence.
fn known(args: &ProtocolArgs, file: &ProtocolFile, system: &System) -> Result<Vec<Known>> {
    let written = system.written_claims();
    let mut all = Vec::new();
    // What is proved of N >= 3 leaves smaller numbers.
    let for_every = match args.family(file)? {
        Some(family) if !written.is_empty() && system.agents >= 3 => {
            prove::every_number(args, family, None)?.claims
        }
        _ => Vec::new(),
    };
    let together = || -> Result<bool> {
        match claims::prove_within(system, &claims::PROOF) {
            Ok(found) => Ok(prove::certified(&found)?.is_ok()),
            Err(_) => Ok(false),
        }
    };
    let is_for_every = |claim: &str| for_every.iter().any(|c| c == claim);
    let is_left = written.iter().any(|(claim, _)| !is_for_every(claim));
    if !is_left || together()? {
        let known = |claim: &str| match is_for_every(claim) {
            true => Known::EveryNumber,
            false => Known::Certified,
        };
        all.extend(written.iter().map(|(claim, _)| known(claim)));
    } else {
        for (claim, indices) in &written {
            if is_for_every(claim) {
                all.push(Known::EveryNumber);
                continue;
            }
            let mut one = system.clone();
            one.claims = indices.iter().filter_map(|&j| system.claims.get(j).cloned()).collect();
            let (proved, failure) = match claims::prove_within(&one, &claims::PROOF) {
                Ok(found) => (prove::certified(&found)?.is_ok(), None),
                Err(Unproved::Fails(run)) => (false, Some(*run)),
                Err(Unproved::Open(_)) => (false, None),
            };
            if proved {
                all.push(Known::Certified);
                continue;
            }
            let search = Search::default();
            let constants = constants_of(&one, search.denominators)?;
            let (found, complete) = claims::refute(&one, &constants, None, search.steps);
            all.push(match found.or(failure) {
                Some(run) => {
                    let claim = indices.get(run.claim).copied().unwrap_or(0);
                    Known::Fails(Box::new(Run { claim, ..run }))
                }
                None => Known::Open(Some(complete)),
            });
        }
    }
    if system.converges.is_some() {
        all.push(if converge::contraction(system)?.is_some() {
            Known::Certified
        } else if converge::grows(system)?.is_some() || converge::unfixed(system).is_some() {
            Known::CertifiedFailure
        } else {
            Known::Open(None)
        });
    }
    Ok(all)
}

fn known_text(
    args: &ProtocolArgs,
    system: &System,
    known: &Known,
    out: &mut dyn Write,
) -> Result<()> {
    match known {
        Known::EveryNumber => {
            writeln!(
                out,
                "           {} for every number of agents from 3 on",
                Evidence::Certified
            )?;
        }
        Known::Certified => writeln!(
            out,
            "           {} for {} agent{}",
            Evidence::Certified,
            system.agents,
            if system.agents == 1 { "" } else { "s" }
        )?,
        Known::Fails(run) => {
            writeln!(
                out,
                "           fails{} at step {} ({}, exact)",
                constants_text(system, &run.values),
                run.step,
                Evidence::ThisRunOnly
            )?;
            writeln!(out, "           replay: {}", replay_line(args, system, run))?;
        }
        Known::CertifiedFailure => {
            writeln!(
                out,
                "           fails ({}: `cordon prove` has the start)",
                Evidence::Certified
            )?;
        }
        Known::Open(Some(steps)) => writeln!(
            out,
            "           open; no counterexample up to step {steps} ({})",
            Evidence::CompleteForAllStarts
        )?,
        Known::Open(None) => writeln!(out, "           open")?,
    }
    Ok(())
}

fn known_json(args: &ProtocolArgs, system: &System, known: &Known) -> Value {
    match known {
        Known::EveryNumber => {
            json!({ "holds": true, "evidence": Evidence::Certified, "agents": "every number from 3 on" })
        }
        Known::Certified => {
            json!({ "holds": true, "evidence": Evidence::Certified, "agents": system.agents.to_string() })
        }
        Known::Fails(run) => json!({
            "holds": false,
            "evidence": Evidence::ThisRunOnly,
            "counterexample": as_json(args, system, run),
        }),
        Known::CertifiedFailure => json!({ "holds": false, "evidence": Evidence::Certified }),
        Known::Open(steps) => json!({ "holds": Value::Null, "steps": steps }),
    }
}
