//! Counterexamples to the claims of a protocol file.

use std::io::Write;
use std::path::{Path, PathBuf};

use num_traits::Zero;
use serde_json::{Value, json};

use super::page::Page;
use super::show::{constants_text, constants_tried};
use super::{ProtocolArgs, assumed};
use crate::cli::select::OutputFormat;
use crate::cli::table;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::system::{Parameter, ParameterKind, System};
use cordon_core::{Error, Evidence, Outcome, Rational, Result, progress};
use cordon_proof::certificate;
use cordon_proof::claims::certificate::counterexample as sealed;
use cordon_proof::claims::search::Choice;
use cordon_proof::claims::{self, MOST_COMBINATIONS, Run};
use cordon_proof::counterexample::list;

/// Where to search for a counterexample.
#[derive(Clone, Debug)]
pub struct Search {
    /// Of a range of constants, the fractions with denominators up to this; else up to
    /// [`DENOMINATORS`], or less where those are too many.
    pub denominators: Option<u32>,
    /// Last step.
    pub steps: usize,
    /// Only the run from this start.
    pub start: Option<Vec<Rational>>,
    /// File for what is found, as a certificate.
    pub file: Option<PathBuf>,
    /// A counterexample that is known already, for where the search ends before one.
    pub known: Option<Run>,
}

/// Greatest denominators of constants that are searched, where nothing else is said and they are not too many.
pub const DENOMINATORS: u32 = 8;

impl Default for Search {
    /// What follows where no proof is found: constants with small denominators, some steps.
    fn default() -> Self {
        Self { denominators: None, steps: 8, start: None, file: None, known: None }
    }
}

/// Searches for a counterexample to the claims of a protocol file.
///
/// # Errors
/// The start is wrong, or there is too much to search. The certificate cannot be written, or is beyond the
/// checker's limits.
pub fn refute(
    args: &ProtocolArgs,
    system: &System,
    search: &Search,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    if system.claims.is_empty() {
        return Err(args.misses("claims", "`claims`, or `cordon prove`, which judges convergence"));
    }
    // What is wrong with the flags is said before anything else.
    constants_of(system, search.denominators)?;
    search.start.as_deref().map(|x| assumed(system, x)).transpose()?;
    let mut page = Page::new(args, system, None, format, out);
    page.headline(system)?;
    let (outcome, found) = refuted_claims(args, system, search, &mut page)?;
    page.field("claims", found);
    page.end()?;
    Ok(outcome)
}

/// The values of the constants that are tried.
///
/// # Errors
/// There are too many.
pub fn constants_of(system: &System, denominators: Option<u32>) -> Result<Vec<Vec<Rational>>> {
    let Some(denominators) = denominators else {
        return Ok(claims::constants_up_to(system, DENOMINATORS));
    };
    claims::constants(system, denominators).ok_or_else(|| {
        Error::input(format!(
            "denominators: `{denominators}`: more than {MOST_COMBINATIONS} combinations of constants: expected \
             smaller ones, or values for some constants"
        ))
    })
}

/// The search, said on a page; with its field.
///
/// # Errors
/// As for [`refute`].
pub fn refuted_claims(
    args: &ProtocolArgs,
    system: &System,
    search: &Search,
    page: &mut Page<'_>,
) -> Result<(Outcome, Value)> {
    let constants = constants_of(system, search.denominators)?;
    let start = search.start.as_deref().map(|x| assumed(system, x)).transpose()?;
    progress::tries(format!("a counterexample up to step {}", search.steps));
    let (found, complete) = claims::refute(system, &constants, start.as_deref(), search.steps);
    let found = found.or_else(|| search.known.clone());
    let file = match (&found, &search.file) {
        (Some(run), Some(file)) => Some(written(system, run, file)?),
        _ => None,
    };
    match &found {
        Some(run) => refuted(args, system, run, page)?,
        None => not_refuted(system, search, &constants, complete, page)?,
    }
    match (&file, &search.file) {
        (Some(file), _) => page.line(format_args!("  wrote {file}"))?,
        (None, Some(_)) => page.line("  (no file: there is nothing to certify)")?,
        (None, None) => {}
    }
    let field = json!({
        "proved": if found.is_some() { json!(false) } else { Value::Null },
        "counterexample": found.as_ref().map(|run| as_json(args, system, run)),
        "file": file,
        "searched": {
            "constants": constants.len(),
            "steps": complete,
            "starts": if search.start.is_some() { "given" } else { "every" },
        },
    });
    Ok((if found.is_some() { Outcome::Refuted } else { Outcome::Inconclusive }, field))
}

/// Writes the certificate of a run that the checker has judged.
fn written(system: &System, run: &Run, file: &Path) -> Result<String> {
    let certificate = sealed(system, run)
        .ok_or_else(|| Error::internal("a counterexample without a certificate"))?;
    certificate::judged(&certificate)?;
    certificate::write_file(file, &certificate)
}

fn refuted(args: &ProtocolArgs, system: &System, run: &Run, page: &mut Page<'_>) -> Result<()> {
    let (at, claim) = (constants_text(system, &run.values), claim_text(system, run));
    page.line(format_args!("  refuted{at}: `{claim}` fails at step {}", run.step))?;
    if let Some(out) = page.text() {
        shown(system, run, out)?;
    }
    let rounded = if is_short(run) { "" } else { "; shown rounded" };
    page.line(format_args!("  {}, exact{rounded}", Evidence::ThisRunOnly))?;
    page.line(format_args!("  replay: {}", replay_line(args, system, run)))
}

fn has_choices(system: &System) -> bool {
    !system.is_deterministic()
}

/// Decimal places of a run whose numbers are long.
const DIGITS: usize = 6;

/// Most characters of a number in a run that is shown exactly.
const MOST_CHARACTERS: usize = 16;

/// Whether all of a run's numbers are short.
fn is_short(run: &Run) -> bool {
    run.states.iter().flatten().all(|x| fraction(x).len() <= MOST_CHARACTERS)
}

/// Most characters of what is chosen in a step that are shown beside the state; more stand below the table.
const MOST_BESIDE: usize = 100;

/// The run as a table: a line a step, with what was chosen in it.
fn shown(system: &System, run: &Run, out: &mut dyn Write) -> Result<()> {
    let chosen: Vec<String> = run.choices.iter().map(|c| choice_text(system, c)).collect();
    let is_beside = has_choices(system) && chosen.iter().all(|c| c.len() <= MOST_BESIDE);
    let by = is_beside.then(|| "by".to_owned());
    let head = ["step".to_owned()].into_iter().chain(system.state.clone()).chain(by).collect();
    let is_short = is_short(run);
    let number = |x: &Rational| if is_short { fraction(x) } else { decimal_string(x, DIGITS) };
    let row = |(k, state): (usize, &Vec<Rational>)| {
        let choice = k.checked_sub(1).and_then(|before| chosen.get(before)).cloned();
        let choice = choice.filter(|_| is_beside);
        [k.to_string()].into_iter().chain(state.iter().map(number)).chain(choice).collect()
    };
    // What the claim speaks of, and what was chosen, is shown in any case.
    let by = system.state.len() + 1;
    let form = system.claims.get(run.claim).and_then(|c| c.predicate.is.form.parts());
    let spoken_of = form.iter().flat_map(|(_, coefficients)| coefficients.iter().enumerate());
    let spoken_of = spoken_of.filter(|(_, a)| !a.is_zero()).map(|(j, _)| j + 1);
    let kept: Vec<usize> = spoken_of.chain([by]).collect();
    let states = run.states.iter().enumerate().map(row).collect();
    table::run(head, states, &kept, |column| column == by, out)?;
    if has_choices(system) && !is_beside {
        for (choice, step) in chosen.iter().zip(1..) {
            writeln!(out, "  step {step} by {choice}")?;
        }
    }
    Ok(())
}

/// What is chosen in a step: `up, link0with1 = 0`.
pub(super) fn choice_text(system: &System, choice: &Choice) -> String {
    let mode = system.modes.get(choice.mode).filter(|_| system.modes.len() > 1);
    let varying =
        varying(system, &choice.values).map(|(p, v)| format!("{} = {}", p.name, fraction(v)));
    mode.map(|m| m.name.clone()).into_iter().chain(varying).collect::<Vec<_>>().join(", ")
}

/// What is chosen in steps, for programs.
pub(super) fn choices_json(system: &System, choices: &[Choice]) -> Vec<Value> {
    let step = |c: &Choice| {
        let values: serde_json::Map<_, _> =
            varying(system, &c.values).map(|(p, v)| (p.name.clone(), json!(fraction(v)))).collect();
        json!({ "mode": system.modes.get(c.mode).map(|m| &m.name), "values": values })
    };
    choices.iter().map(step).collect()
}

/// The parameters that may differ from step to step, with their values.
fn varying<'s>(
    system: &'s System,
    values: &'s [Rational],
) -> impl Iterator<Item = (&'s Parameter, &'s Rational)> {
    let varies =
        |(p, _): &(&Parameter, _)| p.kind != ParameterKind::Constant && p.fixed().is_none();
    system.parameters.iter().zip(values).filter(varies)
}

fn not_refuted(
    system: &System,
    search: &Search,
    constants: &[Vec<Rational>],
    complete: usize,
    page: &mut Page<'_>,
) -> Result<()> {
    let which = if search.start.is_some() {
        "from this start"
    } else {
        Evidence::CompleteForAllStarts.text()
    };
    let at = constants_tried(system, constants);
    page.line(format_args!("  not refuted: no counterexample up to step {complete}{at}: {which}"))?;
    if complete < search.steps {
        let last = search.steps;
        page.line(format_args!("  (the search was too large to go on to step {last})"))?;
    }
    Ok(())
}

fn claim_text<'p>(system: &'p System, run: &Run) -> &'p str {
    system.claims.get(run.claim).map_or("", |c| c.predicate.text.as_str())
}

/// The command that runs a counterexample again.
pub fn replay_line(args: &ProtocolArgs, system: &System, run: &Run) -> String {
    let now = system.state.len() - system.past.len();
    let start = run.states.first().and_then(|x| x.get(..now)).map_or_else(String::new, list);
    let constant = |(p, _): &(&Parameter, &Rational)| p.kind == ParameterKind::Constant;
    let sets = system.parameters.iter().zip(&run.values).filter(constant);
    let sets: String = sets.map(|(p, v)| format!(" --set {}={}", p.name, fraction(v))).collect();
    format!("cordon refute {}{sets} --steps {} --start={start}", args.flags(system), run.step)
}

/// A run for programs.
pub fn as_json(args: &ProtocolArgs, system: &System, run: &Run) -> Value {
    let states: Vec<Vec<String>> =
        run.states.iter().map(|x| x.iter().map(fraction).collect()).collect();
    let named = |(p, v): (&Parameter, &Rational)| (p.name.clone(), json!(fraction(v)));
    let constant = |(p, _): &(&Parameter, &Rational)| p.kind == ParameterKind::Constant;
    let constants: serde_json::Map<_, _> =
        system.parameters.iter().zip(&run.values).filter(constant).map(named).collect();
    json!({
        "constants": constants,
        "step": run.step,
        "claim": claim_text(system, run),
        "state": system.state,
        "run": states,
        "choices": choices_json(system, &run.choices),
        "replay": replay_line(args, system, run),
    })
}
