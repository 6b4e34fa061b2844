//! Whether a protocol of one's own converges.

use serde_json::{Value, json};

use super::page::Page;
use super::refute::{choice_text, choices_json};
use super::show::constants_text;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::system::System;
use cordon_core::{Evidence, Outcome, Result, progress};
use cordon_proof::claims::converge::{self, Contraction, Growth, Unfixed};
use cordon_proof::claims::pinned;
use cordon_proof::counterexample::list;

/// Proves or refutes convergence, and says so; with what goes into the page.
///
/// # Errors
/// The checker rejects what was found, or a certificate cannot be written.
pub(super) fn convergence(system: &System, page: &mut Page<'_>) -> Result<(Outcome, Value)> {
    progress::tries("whether it converges");
    let (outcome, mut field, certificate) = if let Some(found) = converge::contraction(system)? {
        converges(system, &found, page)?;
        let rate = fraction(&found.rate);
        (
            Outcome::Holds,
            json!({ "proved": true, "evidence": Evidence::Certified, "rate": rate, "round": found.round }),
            Some(("-converges", found.certificate)),
        )
    } else if let Some(found) = converge::grows(system)? {
        does_not_converge(system, &found, page)?;
        let start: Vec<String> = found.start.iter().map(fraction).collect();
        (
            Outcome::Refuted,
            json!({
                "proved": false,
                "evidence": Evidence::Certified,
                "start": start,
                "word": choices_json(system, &found.word),
            }),
            Some(("-grows", found.certificate)),
        )
    } else if let Some(found) = converge::unfixed(system) {
        moves_the_targets(system, &found, page)?;
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
        let nothing = "neither a form that falls in every step was found, nor one that does not";
        page.line(format_args!("  convergence: {}", converge::open(system, nothing)))?;
        (Outcome::Inconclusive, json!({ "proved": Value::Null }), None)
    };
    let file = match certificate {
        Some((what, certificate)) => page.certificate(what, &certificate)?,
        None => None,
    };
    field["file"] = json!(file);
    Ok((outcome, field))
}

fn converges(system: &System, found: &Contraction, page: &mut Page<'_>) -> Result<()> {
    let (forms, roots) = match found.forms.len() {
        1 => ("a quadratic form of what has to vanish falls", "its root"),
        _ => ("quadratic forms of what has to vanish, one for each mode, fall", "their roots"),
    };
    page.line(format_args!(
        "  converges: {forms} in every {}, {roots} to at most {} ({}) of what it was",
        round_text(found),
        fraction(&found.rate),
        decimal_string(&found.rate, 6)
    ))?;
    let pinned = pinned::texts(system);
    let starts = match pinned.as_slice() {
        [] => "every start".to_owned(),
        all => format!("every start with {}", all.join(", ")),
    };
    page.line(format_args!(
        "  {}: from {starts}, whatever the parameters are in their ranges, the same in all steps or not",
        Evidence::Certified
    ))
}

/// `step`, or `round of 2 steps` of modes in turn.
pub(super) fn round_text(found: &Contraction) -> String {
    match found.round {
        1 => "step".to_owned(),
        n => format!("round of {n} steps"),
    }
}

fn moves_the_targets(system: &System, found: &Unfixed, page: &mut Page<'_>) -> Result<()> {
    let at = constants_text(system, &found.step.values);
    let now = system.state.len() - system.past.len();
    let image = list(found.image.get(..now).unwrap_or_default());
    let with = match choice_text(system, &found.step) {
        choice if choice.is_empty() => String::new(),
        choice => format!(" ({choice})"),
    };
    page.line(format_args!("  does not converge{at}: a step{with} takes the targets to {image}"))?;
    page.line(format_args!(
        "  {}: no run that goes on like that ends there",
        Evidence::CompleteForAllStarts
    ))
}

fn does_not_converge(system: &System, found: &Growth, page: &mut Page<'_>) -> Result<()> {
    page.line(format_args!(
        "  does not converge{}: a quadratic form that is positive at the start never falls",
        constants_text(system, &found.values)
    ))?;
    if !system.is_deterministic() {
        let steps: Vec<String> = found.word.iter().map(|c| choice_text(system, c)).collect();
        page.line(format_args!("  with these steps, over and over: {}", steps.join("; ")))?;
    }
    page.line(format_args!("  {}: start {}", Evidence::Certified, list(&found.start)))
}
