//! Bounds on every state variable as further claims.
//!
//! The pre-images of a claim are exhausted after finitely many steps where the system is stable and the
//! claims bound the state. Claims that do not, an order for one, are helped by bounds that are claimed
//! beside them: twice what the state reaches in the first steps. They are guessed here and proved with
//! the rest.

use num_traits::{One, Signed, Zero};

use super::search::is_short;
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::simplex::{Solution, Term, Work, maximise};
use cordon_core::system::{Claim, Predicate, System};

/// Steps in which the state is watched.
const STEPS: usize = 30;

/// The system with bounds claimed on every state variable. `None` where the starts have none, claims
/// are about certain steps only, or that is more work than it may be.
pub fn bounded(system: &System, work: &Work) -> Option<System> {
    if system.claims.iter().any(|c| c.from > 0 || c.until.is_some()) {
        return None;
    }
    let starts = system.start_constraints();
    let ends = [
        system.parameters.iter().map(|p| p.low.clone()).collect::<Vec<_>>(),
        system.parameters.iter().map(|p| p.high.clone()).collect(),
    ];
    let mut bounded = system.clone();
    for (v, name) in system.state.iter().enumerate() {
        let mut reached = Rational::zero();
        for (mode, values) in system.modes.iter().flat_map(|m| ends.iter().map(move |e| (m, e))) {
            let map = mode.at(values);
            let mut form = Affine::variable(v);
            for k in 0..=STEPS {
                // Not every step: programs are what costs.
                if k % 3 == 0 {
                    let negated = Affine::constant(Rational::zero()) - &form;
                    for side in [&form, &negated] {
                        let most = greatest(side, &starts, system.state.len(), work)?;
                        reached = reached.max(most.abs());
                    }
                }
                form = map.pulled_back(&form).filter(is_short)?;
            }
        }
        let bound = (reached * Rational::from_integer(2.into()) + Rational::one()).ceil();
        for sign in [Rational::one(), -Rational::one()] {
            let mut coefficients = vec![Rational::zero(); v];
            coefficients.push(-sign);
            let form = Affine::new(bound.clone(), coefficients);
            let text = format!("|{name}| <= {bound} (found by the search)");
            let predicate = Predicate { text, is: Constraint { form, sign: Sign::NonNegative } };
            bounded.claims.push(Claim { predicate, from: 0, until: None });
        }
    }
    Some(bounded)
}

/// The greatest value of a form under the constraints, strict ones with their bounds; `None` where there
/// is none, or that is more work than it may be.
pub fn greatest(
    form: &Affine,
    constraints: &[Constraint],
    variables: usize,
    work: &Work,
) -> Option<Rational> {
    form.at(&extreme(form, constraints, variables, work)?)
}

/// A point at which the form has that value.
pub fn extreme(
    form: &Affine,
    constraints: &[Constraint],
    variables: usize,
    work: &Work,
) -> Option<Vec<Rational>> {
    // Columns: positive and negative part of every variable, the slacks.
    let signed = |coefficients: &[Rational]| -> Vec<Term> {
        let nonzero = coefficients.iter().enumerate().filter(|(_, a)| !a.is_zero());
        nonzero.flat_map(|(j, a)| [(j, a.clone()), (variables + j, -a)]).collect()
    };
    let mut rows = Vec::new();
    let mut constants = Vec::new();
    for (i, c) in constraints.iter().enumerate() {
        let (constant, coefficients) = c.form.parts()?;
        let mut row = signed(coefficients);
        if c.sign != Sign::Zero {
            row.push((2 * variables + i, -Rational::one()));
        }
        rows.push(row);
        constants.push(-constant);
    }
    let equations: Vec<_> = rows.iter().map(Vec::as_slice).zip(&constants).collect();
    let (_, coefficients) = form.parts()?;
    let columns = 2 * variables + constraints.len();
    match maximise(columns, &signed(coefficients), &equations, work)? {
        Solution::Optimal(x) => Some((0..variables).map(|j| &x[j] - &x[variables + j]).collect()),
        _ => None,
    }
}
