//! Findings put together: one summary for each theorem and form.

use cordon_core::theorems::words;
use cordon_spec::theorems::{Form, Theorem};
use serde_json::{Value, json};

use super::config::Config;
use super::finding::{Counts, Finding, Judgement};
use super::minimise::simplest;
use crate::counterexample::Counterexample;
use cordon_core::exact::fraction;
use cordon_core::{Evidence, Outcome, Result};

/// What a sweep has found of one theorem in one form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// The theorem that was swept.
    pub theorem: Theorem,
    /// As printed, or sharp.
    pub form: Form,
    /// Number of work items.
    pub items: usize,
    /// Number of work items with each judgement.
    pub holding: usize,
    /// Work items that no case said anything about.
    pub vacuous: usize,
    /// Work items with undecided cases and no violation.
    pub undecided: usize,
    /// Work items with violations.
    pub refuted: usize,
    /// Counts of all items.
    pub counts: Counts,
    /// The verdict that all its work items together amount to.
    pub verdict: Judgement,
    /// The kind of evidence, where there is any.
    pub evidence: Option<Evidence>,
    /// The simplest counterexample, where it is refuted.
    pub counterexample: Option<Counterexample>,
    /// Why the first undecided item is.
    pub reason: Option<String>,
}

/// What a sweep says of each theorem and form, in the order of its configuration. `part` says that the findings
/// are one part of several, in which a claim may have no item.
///
/// # Errors
/// A finding whose counterexample the spec does not confirm.
pub fn summaries(config: &Config, findings: &[Finding], part: bool) -> Result<Vec<Summary>> {
    let mut summaries = Vec::new();
    for &theorem in &config.theorems {
        for &form in &config.forms {
            let about = |f: &&Finding| f.theorem == theorem && f.form == form;
            let mine: Vec<&Finding> = findings.iter().filter(about).collect();
            if !(part && mine.is_empty()) {
                summaries.push(summary(theorem, form, &mine)?);
            }
        }
    }
    Ok(summaries)
}

fn summary(theorem: Theorem, form: Form, findings: &[&Finding]) -> Result<Summary> {
    let number = |j: Judgement| findings.iter().filter(|f| f.verdict == j).count();
    let (holding, vacuous) = (number(Judgement::Holds), number(Judgement::Vacuous));
    let (undecided, refuted) = (number(Judgement::Undecided), number(Judgement::Refuted));
    let verdict = if refuted > 0 {
        Judgement::Refuted
    } else if undecided > 0 {
        Judgement::Undecided
    } else if holding > 0 {
        Judgement::Holds
    } else {
        Judgement::Vacuous
    };
    Ok(Summary {
        theorem,
        form,
        items: findings.len(),
        holding,
        vacuous,
        undecided,
        refuted,
        counts: findings.iter().fold(Counts::default(), |sum, f| sum.plus(f.counts)),
        verdict,
        evidence: findings.first().map(|f| f.evidence),
        counterexample: simplest(findings.iter().copied())?,
        reason: findings
            .iter()
            .find(|f| f.verdict == Judgement::Undecided)
            .and_then(|f| f.reason.clone()),
    })
}

/// How a sweep with these summaries ends.
pub fn outcome(summaries: &[Summary]) -> Outcome {
    summaries.iter().fold(Outcome::Holds, |worst, s| worst.worst(s.verdict.outcome()))
}

impl Summary {
    /// The summary as reports in JSON have it.
    pub fn json(&self) -> Value {
        json!({
            "theorem": self.theorem.number(),
            "form": self.form.label(),
            "conclusion": words(self.theorem).conclusion(self.form),
            "verdict": self.verdict,
            "evidence": self.evidence,
            "items": self.items,
            "holding": self.holding,
            "vacuous": self.vacuous,
            "undecided": self.undecided,
            "refuted": self.refuted,
            "counts": self.counts,
            "reason": self.reason,
            "counterexample": self.counterexample.as_ref().map(|c| json!({
                "drones": c.start().len(),
                "eps": fraction(&c.eps),
                "step": c.step,
                "start": c.start().iter().map(fraction).collect::<Vec<_>>(),
                "violation": c.what_fails(),
                "replay": c.replay_line(),
            })),
        })
    }
}
