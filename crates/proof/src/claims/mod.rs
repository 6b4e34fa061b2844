//! The claims about a system: proved with a certificate, or refuted by a smallest run.

pub mod automaton;
mod bounds;
pub mod certificate;
pub mod converge;
pub(crate) mod doubles;
pub mod pinned;
pub mod readouts;
mod refute;
pub mod search;
pub mod settle;
pub mod sweep;
pub mod threshold;
mod words;

pub use refute::{
    MOST_COMBINATIONS, Run, Sought, WORK, constants, constants_up_to, follow, refute, refute_with,
    sought,
};

use cordon_core::Rational;
use cordon_core::linear::feasible::point_within;
use cordon_core::simplex::Work;
use cordon_core::system::{Parameter, ParameterKind, System};

use automaton::Automaton;
use search::{Answer, End, Limits, Proof, Search};

/// How far a proof is searched.
pub const PROOF: Limits = Limits { steps: 150, half_spaces: 300, work: 200_000_000 };

/// Whether no start meets the assumptions, so that there is nothing to prove; as far as that takes no
/// more work than a proof.
pub fn is_vacuous(system: &System) -> bool {
    let work = Work::limited(PROOF.work);
    let some = point_within(system.state.len(), &system.start_constraints(), &work);
    some.is_none() && work.left() > 0
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

/// Why there is no proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unproved {
    /// A claim fails, in this run.
    Fails(Box<Run>),
    /// The search ended before.
    Open(End),
}

/// A proof, if the search finds one: the claims hold in every run from every assumed start, for all
/// values of the parameters. None does not mean that a claim is false.
pub fn prove(system: &System) -> Option<Proved> {
    prove_within(system, &PROOF).ok()
}

/// As [`prove`], searching so far and no further, or why there is none: several attempts, each within
/// the limits.
///
/// # Errors
/// There is none: a claim fails, or the last search ended.
pub fn prove_within(system: &System, limits: &Limits) -> Result<Proved, Unproved> {
    prove_with(system, limits, &mut u64::MAX.clone())
}

/// As [`prove_within`], all attempts together with as much `work` as there is; what is left of it stays.
///
/// # Errors
/// As for [`prove_within`].
pub fn prove_with(system: &System, limits: &Limits, work: &mut u64) -> Result<Proved, Unproved> {
    let mut attempt = |system: &System, limits: &Limits| {
        let automaton = Automaton::of(system);
        let starts = system.start_constraints();
        let parameters = system.parameters.clone();
        let limits = Limits { work: limits.work.min(*work), ..*limits };
        let mut search = Search::new(system, &automaton, parameters, starts, &limits);
        let answer = search.run();
        *work -= limits.work - search.left().min(limits.work);
        match answer {
            Answer::Proved(proof) => Ok(Proved { system: system.clone(), proof }),
            Answer::Refuted(start, choices) => {
                let values = system.values(|p| p.low.clone());
                let run = follow(system, &values, &start, choices).map(Box::new);
                Err(run.map_or(Unproved::Open(End::Steps), Unproved::Fails))
            }
            Answer::Open(_, end) => Err(Unproved::Open(end)),
        }
    };
    // A first short attempt: pre-images of bounded claims are exhausted soon, others never.
    let short = Limits {
        steps: limits.steps.min(40),
        half_spaces: limits.half_spaces.min(200),
        work: limits.work / 4,
    };
    let first = attempt(system, &short);
    if first.is_ok() || matches!(first, Err(Unproved::Fails(_) | Unproved::Open(End::Varying))) {
        return first;
    }
    let bounded = bounds::bounded(system, &Work::limited(limits.work / 4));
    if let Some(proved) = bounded.and_then(|system| attempt(&system, limits).ok()) {
        return Ok(proved);
    }
    attempt(system, limits)
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
