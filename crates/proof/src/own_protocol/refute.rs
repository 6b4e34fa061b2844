//! Counterexamples to the claims about a user's protocol: by step, the smallest first, then by
//! the simplicity of the weight.

use num_traits::Zero;

use super::{OwnProtocol, inequalities};
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign, point};
use cordon_core::linear::simplest::fractions_within;

/// A run from an assumed start in which a claim fails.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// The weight.
    pub eps: Rational,
    /// The step at which the claim fails, the last of the run.
    pub step: usize,
    /// The claim, by its place among the comparisons claimed.
    pub claim: usize,
    /// The placements.
    pub placements: Vec<Vec<Rational>>,
}

/// The weights searched: both ends of the range, and the fractions between with denominators
/// up to `denominators`.
pub fn weights(protocol: &OwnProtocol, denominators: u32) -> Vec<Rational> {
    let mut weights = match &protocol.eps {
        None => Vec::new(),
        Some((lo, hi)) => fractions_within(lo, hi, denominators),
    };
    for end in protocol.extreme_weights() {
        if !weights.contains(&end) {
            weights.push(end);
        }
    }
    weights
}

/// The first counterexample up to step `steps`. None at a weight means that there is none from
/// any start up to that step: for each step and claim a linear program decides.
pub fn refute(protocol: &OwnProtocol, weights: &[Rational], steps: usize) -> Option<Run> {
    let x = protocol.variables();
    let starts: Vec<Constraint> = protocol.starts.iter().map(|c| c.about(&x)).collect();
    let mut placements: Vec<Vec<Affine>> = vec![x; weights.len()];
    for k in 0..=steps {
        for (eps, placement) in weights.iter().zip(&mut placements) {
            if k > 0 {
                *placement = protocol.step_forms(eps, placement);
            }
            for claim in 0..protocol.claims.len() {
                let found = violating_start(protocol, &starts, placement, claim)
                    .and_then(|start| check(protocol, eps, &start, k))
                    .filter(|run| run.step == k);
                if found.is_some() {
                    return found;
                }
            }
        }
    }
    None
}

/// A start that meets the assumptions and from which the claim fails of the placement.
fn violating_start(
    protocol: &OwnProtocol,
    starts: &[Constraint],
    placement: &[Affine],
    claim: usize,
) -> Option<Vec<Rational>> {
    let claim = protocol.claims.get(claim)?.about(placement);
    inequalities(&claim).iter().find_map(|c| {
        // The negation of form > 0 is -form >= 0, and of form >= 0 it is -form > 0.
        let sign = match c.sign {
            Sign::Positive => Sign::NonNegative,
            Sign::NonNegative | Sign::Zero => Sign::Positive,
        };
        let negated = Constraint { form: Affine::constant(Rational::zero()) - &c.form, sign };
        // A real violation first, then one that only touches the bound.
        let beyond = Constraint { sign: Sign::Positive, ..negated.clone() };
        let with = |last: Constraint| {
            let all: Vec<Constraint> = starts.iter().cloned().chain([last]).collect();
            point(protocol.count, &all)
        };
        with(beyond).or_else(|| (sign == Sign::NonNegative).then(|| with(negated)).flatten())
    })
}

/// Runs the protocol from a start and returns the run up to the first step at which a claim
/// fails, if one does so up to step `steps`. `None` too where the start is not an assumed one.
pub fn check(
    protocol: &OwnProtocol,
    eps: &Rational,
    start: &[Rational],
    steps: usize,
) -> Option<Run> {
    if start.len() != protocol.count || !protocol.starts.iter().all(|c| c.holds(start)) {
        return None;
    }
    let mut placements = protocol.run(eps, start, steps);
    let fails = |x: &Vec<Rational>| protocol.claims.iter().position(|c| !c.holds(x));
    let (step, claim) =
        placements.iter().enumerate().find_map(|(k, x)| fails(x).map(|claim| (k, claim)))?;
    placements.truncate(step + 1);
    Some(Run { eps: eps.clone(), step, claim, placements })
}
