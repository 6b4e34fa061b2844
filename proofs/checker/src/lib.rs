//! The independent checker of Cordon's certificates.
//!
//! A theorem is a statement with a proof by the rules of a small [`kernel`]; what the protocol does, the
//! checker finds out by executing `cordon-spec` on polynomials. It shares no code with the search.
//! FORMAT.md describes the files, TRUST.md what an accepted one rests on.

#![forbid(unsafe_code)]

pub mod ellipsoid;
pub mod expr;
pub mod fault;
pub mod format;
pub mod kernel;
pub mod linear;
pub mod matrix;
pub mod number;
pub mod poly;
pub mod refutation;
pub mod system;
pub mod vector;

use std::collections::BTreeMap;
use std::fmt;

use cordon_spec::coverage::exec_coverage;
use fault::{Fault, Result, Shown, fault, shown};
use format::{Function, Kind, Statement, Theorem};
use kernel::Kernel;
use system::Step;

/// What the checker says of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The claim is proved.
    Valid {
        /// What is proved, in words that the checker makes from it.
        claim: String,
        /// How many clauses were proved; 1 for the kinds about one N.
        obligations: usize,
    },
    /// A proof is wrong, or the certificate contradicts itself.
    Invalid {
        /// The clause, where it is a theorem.
        step: String,
        /// The rule that failed.
        rule: &'static str,
        /// Why.
        reason: String,
    },
    /// No certificate in the format.
    Unreadable {
        /// Why not.
        reason: String,
    },
}

impl Verdict {
    /// The exit code of the program: 0 valid, 2 unreadable, 4 invalid.
    pub fn code(&self) -> u8 {
        match self {
            Self::Valid { .. } => 0,
            Self::Unreadable { .. } => 2,
            Self::Invalid { .. } => 4,
        }
    }

    /// The verdict in a word.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Valid { .. } => "valid",
            Self::Invalid { .. } => "invalid",
            Self::Unreadable { .. } => "unreadable",
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.label())?;
        match self {
            Self::Valid { claim, obligations: ..=1 } => f.write_str(claim),
            Self::Valid { claim, obligations } => write!(f, "{claim} ({obligations} obligations)"),
            Self::Invalid { step, rule, reason } => {
                write!(f, "{}: rule {rule}: {}", shown(step), shown(reason))
            }
            Self::Unreadable { reason } => f.write_str(&shown(reason)),
        }
    }
}

/// Checks the text of a certificate.
pub fn check(text: &str) -> Verdict {
    check_of(text, exec_coverage)
}

/// Checks the text of a certificate as if the protocol were another: what is proved of the right one
/// must not be of a wrong one. For steps in which everybody updates; refutations run the spec.
pub fn check_of(text: &str, step: Step) -> Verdict {
    number::refill();
    let kind = match format::read(text) {
        Ok(kind) => kind,
        Err(reason) => return Verdict::Unreadable { reason },
    };
    let mut clause = "certificate";
    let result = match &kind {
        Kind::Theorem(t) => prove(t, step, &mut clause),
        Kind::Contraction(c) => {
            let of = (c.drones, &c.eps, c.vector.as_slice());
            vector::vector("contraction", of, Some(&c.rate), step)
        }
        Kind::Growth(c) => vector::vector("growth", (c.drones, &c.eps, &c.vector), None, step),
        Kind::Refutation(c) => refutation::refutation(c),
        Kind::Counterexample(c) => refutation::counterexample(c),
        Kind::Ellipsoid(c) => ellipsoid::ellipsoid(c),
    };
    // Without work left numbers are not what they should be: neither is what was said of them.
    let result = number::spend(0).and(result);
    match result {
        Ok((claim, obligations)) => Verdict::Valid { claim, obligations },
        Err(Fault { rule, reason }) => Verdict::Invalid { step: clause.into(), rule, reason },
    }
}

/// Reads what a statement speaks of and assumes; what that is, in words.
///
/// # Errors
/// What is wrong with it.
pub fn assume(s: &Statement, kernel: &mut Kernel, protocol: Step) -> Result<Vec<String>> {
    let mut spoken: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for (name, Function { of, to }) in &s.functions.0 {
        kernel.function(name, *of, *to)?;
        let what = format!(
            "for all {to} functions of arity {of} that meet what is assumed, if there are such:"
        );
        spoken.entry(what).or_default().push(name);
    }
    let mut words = Vec::new();
    if let Some(system) = &s.system {
        words.push(system::install(system, kernel, protocol)?);
    }
    for (name, sort) in &s.constants.0 {
        kernel.constant(name, *sort)?;
        spoken.entry(format!("for all {sort}s")).or_default().push(name);
    }
    words.extend(spoken.iter().map(|(what, names)| format!("{what} {}", names.join(", "))));
    for d in &s.definitions {
        words.push(format!("where {}", kernel.define(d)?));
    }
    for assumption in &s.assumptions {
        let clause = kernel.clause(assumption)?;
        words.push(format!("assuming {clause}"));
        kernel.add(&assumption.name, clause)?;
    }
    Ok(words)
}

/// Kind `theorem`: what was proved and in how many clauses; `step` is the clause that is judged.
fn prove<'t>(t: &'t Theorem, protocol: Step, step: &mut &'t str) -> Result<Shown> {
    *step = "statement";
    let (mut kernel, s) = (Kernel::default(), &t.statement);
    let mut words = assume(s, &mut kernel, protocol)?;
    let goals = s.conclusions.iter().map(|c| (c, t.proof.conclusions.0.get(&c.name)));
    let lemmas = t.proof.lemmas.iter().map(|l| (&l.clause, Some(&l.proof)));
    for (place, (written, proof)) in lemmas.chain(goals).enumerate() {
        *step = &written.name;
        let clause = kernel.clause(written)?;
        let Some(proof) = proof else { return fault("conclusion", "not proved") };
        kernel.check(&clause, proof)?;
        if place >= t.proof.lemmas.len() {
            words.push(format!("proved: {clause}"));
        }
        kernel.add(&written.name, clause)?;
    }
    *step = "statement";
    if t.proof.conclusions.0.len() != s.conclusions.len() || s.conclusions.is_empty() {
        return fault("conclusion", "a proof of nothing that the statement says");
    }
    Ok((words.join("\n  "), t.proof.lemmas.len() + s.conclusions.len()))
}
