//! The independent checker of Cordon's certificates.
//!
//! A certificate says which claim it proves; the checker derives what has to be proved, by
//! executing `cordon-spec` on polynomials, and then checks each proof. It shares no code with
//! the search that found them. FORMAT.md describes the files, TRUST.md what an accepted one rests on.

#![forbid(unsafe_code)]

pub mod claims;
pub mod concrete;
pub mod exactness;
pub mod format;
pub mod model;
pub mod poly;
pub mod projection;
pub mod rules;

use std::collections::BTreeSet;
use std::fmt;

use claims::{Claim, Refusal, Scope};
use cordon_spec::theorems::Form;
use format::{Certificate, Discharge, ExactnessCert, TheoremCert};
use model::Weights;
use rules::{Fault, Obligation};

/// What the checker says of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The claim is proved.
    Valid {
        /// The claim in words, with its range.
        claim: String,
        /// How many obligations were derived and discharged; 1 for the kinds about one N.
        obligations: usize,
    },
    /// A proof is wrong, or the certificate contradicts itself.
    Invalid {
        /// The obligation, or the kind.
        step: String,
        /// The rule that failed.
        rule: &'static str,
        /// Why.
        reason: String,
    },
    /// Something is not proved.
    Incomplete {
        /// What lacks: obligations without proof, data.
        missing: Vec<String>,
    },
    /// No certificate in the format.
    Unreadable {
        /// Why not.
        reason: String,
    },
}

impl Verdict {
    /// The exit code of the program: 0 valid, 4 invalid, 3 incomplete, 2 unreadable.
    pub fn code(&self) -> u8 {
        match self {
            Self::Valid { .. } => 0,
            Self::Unreadable { .. } => 2,
            Self::Incomplete { .. } => 3,
            Self::Invalid { .. } => 4,
        }
    }

    /// The verdict in a word.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Valid { .. } => "valid",
            Self::Invalid { .. } => "invalid",
            Self::Incomplete { .. } => "incomplete",
            Self::Unreadable { .. } => "unreadable",
        }
    }

    fn invalid(step: &str, rule: &'static str, reason: impl Into<String>) -> Self {
        Self::Invalid { step: step.to_owned(), rule, reason: reason.into() }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Valid { claim, obligations: 1 } => write!(f, "valid: {claim}"),
            Self::Valid { claim, obligations } => {
                write!(f, "valid: {claim} ({obligations} obligations)")
            }
            Self::Invalid { step, rule, reason } => {
                write!(f, "invalid: {step}: rule {rule}: {reason}")
            }
            Self::Incomplete { missing } => {
                write!(f, "incomplete: not proved: {}", missing.join(", "))
            }
            Self::Unreadable { reason } => write!(f, "unreadable: {reason}"),
        }
    }
}

/// Checks the text of a certificate.
pub fn check(text: &str) -> Verdict {
    let concrete = |step: &str, result: Result<String, Fault>| match result {
        Ok(claim) => Verdict::Valid { claim, obligations: 1 },
        Err(Fault { rule, reason }) => Verdict::invalid(step, rule, reason),
    };
    match format::read(text) {
        Err(reason) => Verdict::Unreadable { reason },
        Ok(Certificate::Theorem(_) | Certificate::Exactness(_)) if text.len() > MAX_SYMBOLIC => {
            Verdict::Unreadable { reason: format!("{} bytes: at most {MAX_SYMBOLIC}", text.len()) }
        }
        Ok(Certificate::Theorem(c)) => theorem(&c),
        Ok(Certificate::Exactness(c)) => exactness(&c),
        Ok(Certificate::Contraction(c)) => concrete("contraction", concrete::contraction(&c)),
        Ok(Certificate::Growth(c)) => concrete("growth", concrete::growth(&c)),
        Ok(Certificate::Refutation(c)) => concrete("refutation", concrete::refutation(&c)),
        Ok(Certificate::Invariance(c)) => concrete("invariance", concrete::invariance(&c)),
    }
}

/// Largest certificate with proofs by symbols, in bytes: with the limits on each proof it
/// bounds the time to some seconds. The theorems need 20,000.
const MAX_SYMBOLIC: usize = 256 << 10;

/// Kind `theorem`.
fn theorem(cert: &TheoremCert) -> Verdict {
    const KIND: &str = "theorem";
    let invalid = |reason: String| Verdict::invalid(&cert.claim, KIND, reason);
    let Some(claim) = Claim::named(&cert.claim) else {
        return invalid("no such claim".into());
    };
    let form = match (&cert.form, claim.has_forms()) {
        (None, false) => Form::Sharp,
        (Some(name), true) => match concrete::form_named(name) {
            Some(form) => form,
            None => return invalid(format!("no form `{name}`")),
        },
        (None, true) => return invalid("expected a form: `paper` or `sharp`".into()),
        (Some(_), false) => return invalid("this claim has no forms".into()),
    };
    let names: Vec<&str> = cert.data.iter().map(|d| d.name.as_str()).collect();
    if let Some(name) = names.iter().find(|n| !claim.data.contains(n)) {
        return invalid(format!("datum `{name}` belongs to no obligation"));
    }
    if names.iter().collect::<BTreeSet<_>>().len() < names.len() {
        return invalid("a datum is given twice".into());
    }
    if let Some(n) = cert.drones.filter(|&n| n < 3) {
        return invalid(format!("{n} drones: expected 3 or more"));
    }
    let weights = match &cert.weights {
        None => Weights::Range(claim.weights(form)),
        Some(i) if i.from.0 <= i.to.0 => Weights::Interval(i.from.0.clone(), i.to.0.clone()),
        Some(_) => return invalid("the interval of weights is empty".into()),
    };
    let range = match &weights {
        Weights::Range(range) => claims::range(*range).to_owned(),
        Weights::Interval(from, to) => format!("{from} <= eps <= {to}"),
    };
    let drones = cert.drones.map_or("every N >= 3".to_owned(), |n| format!("N = {n}"));
    let form_name = if claim.has_forms() { format!(" ({})", form.label()) } else { String::new() };
    let text = format!("{}{form_name} for {drones}, {range}: {}", claim.name, claim.text);
    let scope = Scope { form, weights, drones: cert.drones, cert };
    discharge(&cert.claim, KIND, text, claim.obligations(&scope), &cert.proofs)
}

/// Kind `exactness`.
fn exactness(cert: &ExactnessCert) -> Verdict {
    let text = format!(
        "{} fails for every N >= {} and every eps > {}: some start of its start set violates it at step 1",
        cert.theorem, cert.drones_from, cert.above.0
    );
    discharge(&cert.theorem, "exactness", text, exactness::obligations(cert), &cert.proofs)
}

/// Checks that every obligation has its proof, and that there is no other proof.
fn discharge(
    step: &str,
    kind: &'static str,
    claim: String,
    obligations: Result<Vec<Obligation>, Refusal>,
    proofs: &[Discharge],
) -> Verdict {
    let obligations = match obligations {
        Ok(obligations) => obligations,
        Err(Refusal::Missing(what)) => return Verdict::Incomplete { missing: vec![what] },
        Err(Refusal::Wrong(reason)) => return Verdict::invalid(step, kind, reason),
    };
    let mut seen = BTreeSet::new();
    for proof in proofs {
        if !seen.insert(&proof.obligation) {
            return Verdict::invalid(&proof.obligation, kind, "proved twice");
        }
        let Some(obligation) = obligations.iter().find(|o| o.name == proof.obligation) else {
            return Verdict::invalid(&proof.obligation, kind, "no such obligation");
        };
        if let Err(Fault { rule, reason }) = rules::check(obligation, &proof.proof, 0) {
            return Verdict::invalid(&proof.obligation, rule, reason);
        }
    }
    let missing: Vec<String> =
        obligations.iter().map(|o| o.name.clone()).filter(|name| !seen.contains(name)).collect();
    if missing.is_empty() {
        Verdict::Valid { claim, obligations: obligations.len() }
    } else {
        Verdict::Incomplete { missing }
    }
}
