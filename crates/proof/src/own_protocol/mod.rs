//! A user's own linear protocol, on an own graph and with own linear invariants: a certificate
//! or a counterexample.
//!
//! The file is documented in `scenarios/own/README.md`. The default rule, pulls of neighbours,
//! is the spec's (equation 6 with a weight for every drone); single drones may have any update
//! that is affine in the positions and in eps.

mod expression;
mod file;
pub mod prove;
pub mod refute;

use cordon_spec::Scalar;
use cordon_spec::consensus::pull;
use num_traits::Zero;

pub use file::{parse, read};

use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_run::scenario::Topology;
use expression::{Comparison, Expression};

/// A checked protocol: every update is affine in the positions and affine in eps, every claim
/// affine in the positions.
#[derive(Clone, Debug)]
pub struct OwnProtocol {
    /// Title, for the output.
    pub title: String,
    /// Number of drones.
    pub count: usize,
    /// Least and largest weight, equal where the weight is one number; none where the protocol
    /// does not speak of eps.
    pub eps: Option<(Rational, Rational)>,
    graph: Option<Topology>,
    updates: Vec<Update>,
    /// What is assumed of the start, as written.
    pub starts: Vec<Predicate>,
    /// What is claimed of every step, as written.
    pub claims: Vec<Predicate>,
}

/// How a drone moves.
#[derive(Clone, Debug)]
enum Update {
    /// x_i' = x_i + weight * sum over neighbours (x_j - x_i).
    Pulled(Expression),
    /// x_i' = expression.
    Own(Expression),
}

/// One comparison with the text that it comes from.
#[derive(Clone, Debug)]
pub struct Predicate {
    /// As written.
    pub text: String,
    comparison: Comparison,
}

impl OwnProtocol {
    /// One step of all drones at once, on any scalars.
    pub fn step<S: Scalar>(&self, number: &impl Fn(&Rational) -> S, eps: &S, x: &[S]) -> Vec<S> {
        let moved = |(i, update): (usize, &Update)| match (update, &self.graph) {
            (Update::Own(expression), _) => expression.value(number, eps, x),
            (Update::Pulled(weight), Some(graph)) => {
                let weight = weight.value(number, eps, x);
                match x.get(i) {
                    Some(own) => own.clone() + &(weight * &pull(graph, x, i)),
                    None => S::from_int(0),
                }
            }
            (Update::Pulled(_), None) => x.get(i).cloned().unwrap_or_else(|| S::from_int(0)),
        };
        self.updates.iter().enumerate().map(moved).collect()
    }

    /// The step on forms in the start, at one weight.
    pub fn step_forms(&self, eps: &Rational, x: &[Affine]) -> Vec<Affine> {
        let number = |n: &Rational| Affine::constant(n.clone());
        self.step(&number, &Affine::constant(eps.clone()), x)
    }

    /// The run from a start, exact: `steps + 1` placements.
    pub fn run(&self, eps: &Rational, start: &[Rational], steps: usize) -> Vec<Vec<Rational>> {
        let mut run = vec![start.to_vec()];
        for _ in 0..steps {
            let next = self.step(&Rational::clone, eps, run.last().map_or(&[], Vec::as_slice));
            run.push(next);
        }
        run
    }

    /// The ends of the range of weights, once where they are equal or do not matter.
    pub fn extreme_weights(&self) -> Vec<Rational> {
        match &self.eps {
            None => vec![Rational::zero()],
            Some((lo, hi)) if lo == hi => vec![lo.clone()],
            Some((lo, hi)) => vec![lo.clone(), hi.clone()],
        }
    }

    /// The positions as the variables of forms.
    pub fn variables(&self) -> Vec<Affine> {
        (0..self.count).map(Affine::variable).collect()
    }
}

impl Predicate {
    /// The claim about positions that are forms, as a constraint on their variables.
    pub fn about(&self, x: &[Affine]) -> Constraint {
        let number = |n: &Rational| Affine::constant(n.clone());
        let none = Affine::from_int(0);
        let form = self.comparison.difference.value(&number, &none, x);
        Constraint { form, sign: self.comparison.relation }
    }

    /// Whether the claim holds of a placement.
    pub fn holds(&self, x: &[Rational]) -> bool {
        let value = self.comparison.difference.value(&Rational::clone, &Rational::zero(), x);
        self.comparison.relation.met_by(&value)
    }
}

/// An equation as two inequalities, anything else as it is: what a certificate is made of.
fn inequalities(c: &Constraint) -> Vec<Constraint> {
    match c.sign {
        Sign::Zero => {
            let negated = Affine::from_int(0) - &c.form;
            [c.form.clone(), negated]
                .map(|form| Constraint { form, sign: Sign::NonNegative })
                .to_vec()
        }
        Sign::Positive | Sign::NonNegative => vec![c.clone()],
    }
}
