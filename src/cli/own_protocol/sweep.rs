//! The claims of a protocol of one's own, from every start on a grid or from all.

use std::io::Write;

use serde_json::{Value, json};

use super::ProtocolArgs;
use super::page::Page;
use super::refute::{as_json, replay_line};
use super::show::{constants_text, constants_tried, when};
use crate::cli::select::OutputFormat;
use crate::cli::table::counted;
use cordon_core::exact::shortened;
use cordon_core::system::System;
use cordon_core::{Evidence, Outcome, Result, progress};
use cordon_proof::claims::sweep::{Tried, on_grid};
use cordon_proof::claims::{self, Run};

/// From which starts, at which constants and up to which step.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Parts into which the range of each variable is divided; none for all real starts.
    pub grid: Option<u32>,
    /// Of a range of constants, the fractions with denominators up to this, or less where those are too many.
    pub denominators: u32,
    /// Last step.
    pub steps: usize,
}

/// What is known of a claim as written.
struct Row<'s> {
    text: &'s str,
    /// The steps that it is about, in words.
    when: String,
    /// Why nothing was learnt.
    vacuous: Option<&'static str>,
    run: Option<Run>,
    /// Up to which step no run fails.
    steps: usize,
}

/// Tries each claim from every start on a grid, or decides it for all real starts.
///
/// # Errors
/// There are no claims, the start set has no bounds, or there is too much to try.
pub fn sweep(
    args: &ProtocolArgs,
    system: &System,
    extent: Extent,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    if system.claims.is_empty() {
        return Err(args.misses("claims", "`claims`, or `cordon prove`, which judges convergence"));
    }
    let constants = claims::constants_up_to(system, extent.denominators);
    let tried = match extent.grid {
        Some(parts) => Some(on_grid(system, &constants, parts, extent.steps)?),
        None => None,
    };
    let mut page = Page::new(args, system, None, format, out);
    page.headline(system)?;
    let mut rows = Vec::new();
    for (text, indices) in system.written_claims() {
        progress::tries(format!("claim `{}`", shortened(text)));
        let mut one = system.clone();
        one.claims = indices.iter().filter_map(|&j| system.claims.get(j).cloned()).collect();
        let (run, steps) = match &tried {
            Some(tried) => (first_failure(&one, tried, &indices), extent.steps),
            None => claims::refute(&one, &constants, None, extent.steps),
        };
        // The run's claim by its place among all.
        let run = run.map(|run| Run { claim: indices.get(run.claim).copied().unwrap_or(0), ..run });
        let first = one.claims.first();
        let is_later = first.is_some_and(|claim| claim.from > extent.steps);
        let no_start = tried.as_ref().is_some_and(|t| t.starts == 0);
        let vacuous = match (no_start, is_later) {
            (true, _) => Some("no start on the grid meets the assumptions"),
            (false, true) => Some("it is about later steps"),
            (false, false) => None,
        };
        rows.push(Row { text, when: first.map_or_else(String::new, when), vacuous, run, steps });
    }
    let (evidence, from) = match &tried {
        Some(tried) => {
            let grid = Evidence::ExhaustiveOnGrid;
            (grid, format!("{grid}, {}", counted(tried.starts, "start")))
        }
        None => (Evidence::CompleteForAllStarts, Evidence::CompleteForAllStarts.to_string()),
    };
    let at = constants_tried(system, &constants);
    for (row, number) in rows.iter().zip(1..) {
        let claim = format!("  claim {number}, `{}`{}", row.text, row.when);
        match (&row.run, row.vacuous) {
            (Some(run), _) => {
                let text = system.claims.get(run.claim).map_or("", |c| &c.predicate.text);
                let at = constants_text(system, &run.values);
                page.line(format_args!("{claim}, fails{at}: `{text}` at step {}", run.step))?;
                page.line(format_args!("    replay: {}", replay_line(args, system, run)))?;
            }
            (None, Some(why)) => page.line(format_args!("{claim}, is vacuous: {why}"))?,
            (None, None) => {
                page.line(format_args!("{claim}, holds up to step {}{at} ({from})", row.steps))?;
            }
        }
    }
    if system.converges.is_some() {
        page.line("  convergence is not for a sweep: `cordon prove` judges it")?;
    }
    if rows.iter().any(|r| r.run.is_none() && r.steps < extent.steps) {
        let last = extent.steps;
        page.line(format_args!("  (the search was too large to go on to step {last})"))?;
    }
    let row = |row: &Row<'_>| -> Value {
        json!({
            "claim": row.text,
            "holds": if row.vacuous.is_some() { Value::Null } else { json!(row.run.is_none()) },
            "steps": row.run.as_ref().map_or(row.steps, |run| run.step),
            "evidence": if row.run.is_some() { Evidence::ThisRunOnly } else { evidence },
            "counterexample": row.run.as_ref().map(|run| as_json(args, system, run)),
        })
    };
    page.field(
        "sweep",
        json!({
            "starts": tried.as_ref().map(|t| t.starts),
            "grid": extent.grid,
            "steps": extent.steps,
            "constants": constants.len(),
            "claims": rows.iter().map(row).collect::<Vec<_>>(),
        }),
    );
    page.end()?;
    let ended = |row: &Row<'_>| match &row.run {
        Some(_) => Outcome::Refuted,
        None if row.vacuous.is_some() || row.steps < extent.steps => Outcome::Inconclusive,
        None => Outcome::Holds,
    };
    Ok(rows.iter().map(ended).fold(Outcome::Holds, Outcome::worst))
}

/// The run in which the first of some claims fails.
fn first_failure(system: &System, tried: &Tried, indices: &[usize]) -> Option<Run> {
    let failures = indices.iter().filter_map(|index| tried.failures.get(index));
    let first = failures.min_by_key(|f| f.step)?;
    claims::refute(system, std::slice::from_ref(&first.values), Some(&first.start), first.step).0
}
