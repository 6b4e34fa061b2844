//! The claims about a system: proved with a certificate, or refuted by a smallest run.

pub mod any_size;
pub mod automaton;
mod bounds;
pub mod certificate;
pub mod converge;
mod doubles;
pub mod readouts;
mod refute;
pub mod search;
pub mod settle;
pub mod threshold;

pub use refute::{MOST_COMBINATIONS, Run, constants, follow, refute};

use cordon_core::Rational;
use cordon_core::linear::feasible::point;
use cordon_core::system::{Parameter, ParameterKind, System};

use automaton::Automaton;
use search::{Answer, Limits, Proof, Search};

/// How far a proof is searched.
pub const PROOF: Limits = Limits { steps: 150, half_spaces: 300, work: 100_000_000 };

/// Whether no start meets the assumptions, so that there is nothing to prove.
pub fn is_vacuous(system: &System) -> bool {
    point(system.state.len(), &system.start_constraints()).is_none()
}

/// The claims about a system, proved.
#[derive(Clone, Debug)]
pub struct Proved {
    /// The system with the claims that were proved: its own, and where those have no bounded invariant
    /// by themselves, bounds on every state variable.
    pub system: System,
    /// The proof.
    pub proof: Proof,
}

/// A proof, if the search finds one: the claims hold in every run from every assumed start, for all
/// values of the parameters. None does not mean that a claim is false.
pub fn prove(system: &System) -> Option<Proved> {
    prove_within(system, &PROOF)
}

/// As [`prove`], searching so far and no further.
pub fn prove_within(system: &System, limits: &Limits) -> Option<Proved> {
    let attempt = |system: &System, limits: &Limits| {
        let automaton = Automaton::of(system);
        let starts = system.start_constraints();
        let parameters = system.parameters.clone();
        match Search::new(system, &automaton, parameters, starts, *limits).run() {
            Answer::Proved(proof) => Some(Proved { system: system.clone(), proof }),
            Answer::Refuted(..) | Answer::Open(..) => None,
        }
    };
    // A first short attempt: pre-images of bounded claims are exhausted soon, others never.
    let short = Limits {
        steps: limits.steps.min(40),
        half_spaces: limits.half_spaces.min(200),
        work: limits.work / 3,
    };
    attempt(system, &short)
        .or_else(|| attempt(&bounds::bounded(system)?, limits))
        .or_else(|| if short == *limits { None } else { attempt(system, limits) })
}

/// The parameters with single values in the place of the constants' ranges.
fn at(system: &System, values: &[Rational]) -> Vec<Parameter> {
    let fixed = |(p, value): (&Parameter, &Rational)| match p.kind {
        ParameterKind::Constant => {
            Parameter { low: value.clone(), high: value.clone(), ..p.clone() }
        }
        ParameterKind::Varying | ParameterKind::Choice => p.clone(),
    };
    system.parameters.iter().zip(values).map(fixed).collect()
}
