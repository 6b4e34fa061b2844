//! Proofs of the claims of a protocol file.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::ProtocolArgs;
use super::convergence::convergence;
use super::every_number::{self, every_number};
use super::page::Page;
use super::refute::{Search, constants_of, refuted_claims};
use super::show::claimed_steps;
use crate::cli::select::OutputFormat;
use crate::cli::table::counted;
use cordon_core::system::System;
use cordon_core::{Evidence, Outcome, Result, progress};
use cordon_proof::claims::certificate::certified;
use cordon_proof::claims::{self, Proved, Unproved};
use cordon_run::protocol::ProtocolFile;

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
    let mut page = Page::new(args, system, folder, format, out);
    let outcome = proved_on(args, file, system, &mut page)?;
    page.end()?;
    Ok(outcome)
}

fn proved_on(
    args: &ProtocolArgs,
    file: &ProtocolFile,
    system: &System,
    page: &mut Page<'_>,
) -> Result<Outcome> {
    let mut outcome = Outcome::Holds;
    progress::tries("a proof for every number of agents");
    let for_every = args.family(file)?.map(every_number).transpose()?;
    if let Some(found) = &for_every {
        every_number::say(system, found, page)?;
    }
    let is_proved = for_every.as_ref().is_some_and(|f| f.proved);
    if for_every.is_some() && !is_proved {
        if let Some((args, system)) = refuted_above(args, file, system.agents)? {
            page.headline(&system)?;
            let (ended, found) = refuted_claims(&args, &system, &search(&system, page), page)?;
            page.field("claims", found);
            return Ok(ended);
        }
        // Asked of every number, and shown for some.
        outcome = Outcome::Inconclusive;
    }
    // What the kernel proves of N >= 3 leaves smaller numbers, and convergence.
    let are_left = !is_proved || system.agents < 3;
    if are_left || system.converges.is_some() {
        page.headline(system)?;
    }
    if !system.claims.is_empty() && are_left {
        let (ended, found) = decided(args, system, page)?;
        outcome = outcome.worst(ended);
        page.field("claims", found);
    }
    if system.converges.is_some() {
        let (ended, found) = convergence(system, page)?;
        outcome = outcome.worst(ended);
        page.field("convergence", found);
    }
    Ok(outcome)
}

/// Proves the claims, or refutes them, or says that it can do neither; with what goes into the page.
fn decided(args: &ProtocolArgs, system: &System, page: &mut Page<'_>) -> Result<(Outcome, Value)> {
    progress::tries(format!("an invariant for {}", counted(system.agents, "agent")));
    let (known, reason) = match claims::prove_within(system, &claims::PROOF) {
        Ok(found) => match certified(&found)? {
            Ok(certificate) => return Ok((Outcome::Holds, proved(&found, &certificate, page)?)),
            Err(beyond) => (None, beyond),
        },
        Err(Unproved::Fails(run)) => (Some(*run), String::new()),
        Err(Unproved::Open(end)) => (None, end.to_string()),
    };
    let search = Search { known, ..search(system, page) };
    let (ended, mut searched) = refuted_claims(args, system, &search, page)?;
    if ended == Outcome::Inconclusive {
        page.line(format_args!("  not proved: {reason}"))?;
        searched["reason"] = json!(reason);
    }
    Ok((ended, searched))
}

/// Says that the claims are proved; with what goes into the page.
fn proved(found: &Proved, certificate: &Value, page: &mut Page<'_>) -> Result<Value> {
    let rows = found.proof.rows.len();
    let claimed = found.proof.rows.iter().filter(|r| r.claim.is_some()).count();
    let steps = claimed_steps(&found.system);
    page.line(format_args!("  proved: the claims hold at {steps} from every assumed start"))?;
    let last = found.system.claims.iter().map(|claim| claim.until).max().flatten();
    let kept = match last.filter(|_| found.system.claims.iter().all(|c| c.until.is_some())) {
        Some(0) => String::new(),
        Some(last) => format!(", every step up to step {last} keeps them"),
        None => ", every step keeps them".to_owned(),
    };
    page.line(format_args!(
        "  {}: {}, {claimed} of them claimed; the start meets them{kept}, at the ends of all ranges and so between",
        Evidence::Certified,
        counted(rows, "half-space"),
    ))?;
    let file = page.certificate("", certificate)?;
    Ok(json!({
        "proved": true,
        "evidence": Evidence::Certified,
        "half_spaces": rows,
        "claimed": claimed,
        "file": file,
    }))
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
        progress::tries(format!("a counterexample with {agents} agents"));
        let system = args.sized(file, agents)?;
        let constants = constants_of(&system, search.denominators)?;
        if claims::refute(&system, &constants, None, search.steps).0.is_some() {
            return Ok(Some((ProtocolArgs { agents: Some(agents), ..args.clone() }, system)));
        }
    }
    Ok(None)
}

/// What is searched for a counterexample where no proof was found: as far as claims go, where all end.
fn search(system: &System, page: &Page<'_>) -> Search {
    let some = Search::default();
    let last = system.claims.iter().map(|c| c.until).max_by_key(|last| last.unwrap_or(usize::MAX));
    let steps = last.flatten().unwrap_or(some.steps);
    Search { file: page.file("-refuted"), steps, ..some }
}
