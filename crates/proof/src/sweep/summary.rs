//! Findings put together: one claim for each theorem and form.

use cordon_core::theorems::words;
use cordon_spec::theorems::{Form, Theorem};
use serde_json::{Value, json};

use super::config::{Config, form_of, theorem_of};
use super::finding::{Counts, Evidence, Finding, Judgement};
use super::minimise::Minimal;
use cordon_core::{Outcome, Result};

/// What a sweep has found of one theorem in one form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Claim {
    /// The theorem.
    pub theorem: Theorem,
    /// Its form.
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
    /// What they say.
    pub verdict: Judgement,
    /// The kind of evidence, where there is any.
    pub evidence: Option<Evidence>,
    /// The simplest counterexample.
    pub counterexample: Option<Minimal>,
    /// Why the first undecided item is.
    pub reason: Option<String>,
}

/// The claims of a sweep, in the order of its configuration. `part` says that the findings
/// are one part of several, in which a claim may have no item.
///
/// # Errors
/// A finding that names no theorem, form or weight.
pub fn claims(config: &Config, findings: &[Finding], part: bool) -> Result<Vec<Claim>> {
    let mut claims = Vec::new();
    for theorem in &config.theorems {
        for form in &config.forms {
            let about = |f: &&Finding| f.theorem == *theorem && f.form == *form;
            let mine: Vec<&Finding> = findings.iter().filter(about).collect();
            if !(part && mine.is_empty()) {
                claims.push(claim(theorem_of(theorem)?, form_of(form)?, &mine)?);
            }
        }
    }
    Ok(claims)
}

fn claim(theorem: Theorem, form: Form, findings: &[&Finding]) -> Result<Claim> {
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
    Ok(Claim {
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
        counterexample: Minimal::of(findings.iter().copied())?,
        reason: findings
            .iter()
            .find(|f| f.verdict == Judgement::Undecided)
            .and_then(|f| f.reason.clone()),
    })
}

/// How a sweep with these claims ends.
pub fn outcome(claims: &[Claim]) -> Outcome {
    claims.iter().fold(Outcome::Holds, |worst, c| worst.worst(c.verdict.outcome()))
}

impl Claim {
    /// The claim for programs.
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
                "drones": c.drones,
                "eps": c.eps.to_string(),
                "step": c.step,
                "start": c.start,
                "violation": c.violation,
                "replay": c.replay(),
            })),
        })
    }
}
