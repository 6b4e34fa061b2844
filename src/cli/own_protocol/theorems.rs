//! The claims of a protocol of one's own, and what is known of each.

use std::io::Write;

use serde_json::{Value, json};

use super::ProtocolArgs;
use super::every_number::every_number;
use super::page::Page;
use super::refute::{Search, as_json, constants_of, replay_line};
use super::show::{constants_text, headline, when};
use crate::cli::select::OutputFormat;
use crate::cli::table::counted;
use cordon_core::exact::shortened;
use cordon_core::system::{Convergence, System};
use cordon_core::{Evidence, Outcome, Result, progress};
use cordon_proof::claims::certificate::certified;
use cordon_proof::claims::threshold::{self, Property, decided};
use cordon_proof::claims::{self, Run, Unproved};
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
    /// A step moves the targets.
    MovesTargets,
    /// Neither; no counterexample up to that step.
    Open(Option<usize>),
}

impl Known {
    fn outcome(&self) -> Outcome {
        match self {
            Self::EveryNumber | Self::Certified => Outcome::Holds,
            Self::Fails(_) | Self::CertifiedFailure | Self::MovesTargets => Outcome::Refuted,
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
    let starts = system.written_starts();
    let mut page = Page::new(args, system, None, format, out);
    page.line(headline(system))?;
    for start in &starts {
        page.line(format_args!("  if      {start}"))?;
    }
    page.flush()?;
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
    let mut fields = Vec::new();
    for (index, (claim, about)) in rows.iter().enumerate() {
        page.line(format_args!("  claim {}  {claim}{about}", index + 1))?;
        let known = known.as_ref().and_then(|known| known.get(index));
        for line in known.iter().flat_map(|known| known_lines(args, system, known)) {
            page.line(format_args!("           {line}"))?;
        }
        fields.push(json!({
            "claim": claim,
            "when": about.trim_start_matches(", "),
            "known": known.map(|known| known_json(args, system, known)),
        }));
    }
    page.field("starts", json!(starts));
    page.field("theorems", json!(fields));
    page.end()?;
    let outcomes = known.iter().flatten().map(Known::outcome);
    Ok(outcomes.fold(Outcome::Holds, Outcome::worst))
}

/// What is known of each claim as written, and last of convergence.
fn known(args: &ProtocolArgs, file: &ProtocolFile, system: &System) -> Result<Vec<Known>> {
    let written = system.written_claims();
    let mut all = Vec::new();
    // What is proved of N >= 3 leaves smaller numbers.
    let for_every = match args.family(file)? {
        Some(family) if !written.is_empty() && system.agents >= 3 => every_number(family)?.claims,
        _ => Vec::new(),
    };
    let together = || -> Result<bool> {
        progress::tries(format!("an invariant for {}", counted(system.agents, "agent")));
        match claims::prove_within(system, &claims::PROOF) {
            Ok(found) => Ok(certified(&found)?.is_ok()),
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
            progress::tries(format!("claim `{}`", shortened(claim)));
            let mut one = system.clone();
            one.claims = indices.iter().filter_map(|&j| system.claims.get(j).cloned()).collect();
            let (proved, failure) = match claims::prove_within(&one, &claims::PROOF) {
                Ok(found) => (certified(&found)?.is_ok(), None),
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
        progress::tries("whether it converges");
        let found = decided(system, Property::Convergence, &mut 0)?;
        all.push(match found.known {
            threshold::Known::Holds => Known::Certified,
            threshold::Known::Fails if found.certificate.is_none() => Known::MovesTargets,
            threshold::Known::Fails => Known::CertifiedFailure,
            threshold::Known::Open => Known::Open(None),
        });
    }
    Ok(all)
}

fn known_lines(args: &ProtocolArgs, system: &System, known: &Known) -> Vec<String> {
    let certified = Evidence::Certified;
    match known {
        Known::EveryNumber => vec![format!("{certified} for every number of agents from 3 on")],
        Known::Certified => vec![format!("{certified} for {}", counted(system.agents, "agent"))],
        Known::Fails(run) => {
            let at = constants_text(system, &run.values);
            vec![
                format!("fails{at} at step {} ({}, exact)", run.step, Evidence::ThisRunOnly),
                format!("replay: {}", replay_line(args, system, run)),
            ]
        }
        Known::CertifiedFailure => {
            vec![format!("fails ({certified}: `cordon prove` has the start)")]
        }
        Known::MovesTargets => {
            vec![format!("fails ({}: a step moves the targets)", Evidence::CompleteForAllStarts)]
        }
        Known::Open(Some(steps)) => vec![format!(
            "open; no counterexample up to step {steps} ({})",
            Evidence::CompleteForAllStarts
        )],
        Known::Open(None) => vec!["open".to_owned()],
    }
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
        Known::MovesTargets => {
            json!({ "holds": false, "evidence": Evidence::CompleteForAllStarts })
        }
        Known::Open(steps) => json!({ "holds": Value::Null, "steps": steps }),
    }
}
