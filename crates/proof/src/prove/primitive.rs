//! Closed forms of sums: F with F(i+1) - F(i) = the summand, found by comparing coefficients.

use num_traits::Zero;
use std::collections::BTreeMap;

use super::claims::{Claim, Kind};
use super::goals::{Primitive, consensus_moves, moved};
use super::symbols::{cell, int, named, substitute};
use super::window::error;
use cordon_core::Rational;
use cordon_core::scalar::{Monomial, Polynomial};
use cordon_core::simplex::feasible;

/// The closed form that a claim needs, if it needs one and there is one.
pub fn find(claim: &Claim) -> Option<Primitive> {
    let name = claim.primitive()?;
    let lengths = || vec![cell("x", -1), cell("x", 0), named("min"), named("max")];
    let products = |a: &[Polynomial], b: &[Polynomial]| -> Vec<Polynomial> {
        a.iter().flat_map(|a| b.iter().map(move |b| a.clone() * b)).collect()
    };
    let poly = match name {
        "flux" => {
            let basis = products(&[int(1), named("eps")], &lengths());
            let equations: Vec<(Shift, Polynomial)> = if claim.kind == Kind::Consensus {
                let [first, inner, last] = consensus_moves();
                vec![
                    (Shift::Next, first),
                    (Shift::Difference, inner),
                    (Shift::Here, int(0) - &last),
                ]
            } else {
                vec![(Shift::Difference, moved())]
            };
            solve(&basis, &equations)?
        }
        _ => {
            let powers = [named("i"), named("i") * &named("i")];
            let scales = [int(1), named("last")];
            let basis = products(&products(&powers, &scales), &[named("min"), named("max")]);
            solve(&basis, &[(Shift::Difference, error(&named("i"), &int(0)))])?
        }
    };
    Some(Primitive { name, poly })
}

/// Which value of F is meant.
#[derive(Clone, Copy)]
enum Shift {
    /// F(i).
    Here,
    /// F(i+1).
    Next,
    /// F(i+1) - F(i).
    Difference,
}

impl Shift {
    fn of(self, f: &Polynomial) -> Polynomial {
        let values = [
            (named("i"), named("i") + &int(1)),
            (cell("x", -1), cell("x", 0)),
            (cell("x", 0), cell("x", 1)),
        ];
        match self {
            Self::Here => f.clone(),
            Self::Next => substitute(f, &values),
            Self::Difference => substitute(f, &values) - f,
        }
    }
}

/// The combination of the basis that meets all equations.
fn solve(basis: &[Polynomial], equations: &[(Shift, Polynomial)]) -> Option<Polynomial> {
    let (mut rows, mut constants): (Vec<Vec<Rational>>, Vec<Rational>) = Default::default();
    for (shift, wanted) in equations {
        let images: Vec<Polynomial> = basis.iter().map(|b| shift.of(b)).collect();
        let mut monomials: BTreeMap<&Monomial, ()> = BTreeMap::new();
        for p in images.iter().chain([wanted]) {
            monomials.extend(p.terms().map(|(m, _)| (m, ())));
        }
        for m in monomials.into_keys() {
            // A free coefficient is a difference of two that are not negative.
            let plus = images.iter().map(|p| p.coefficient(m));
            let minus = images.iter().map(|p| -p.coefficient(m));
            rows.push(plus.chain(minus).collect());
            constants.push(wanted.coefficient(m));
        }
    }
    let x = feasible(2 * basis.len(), &rows, &constants)?;
    let (plus, minus) = x.split_at(basis.len());
    let coefficients = plus.iter().zip(minus).map(|(p, m)| p - m);
    Some(
        basis
            .iter()
            .zip(coefficients)
            .filter(|(_, c)| !c.is_zero())
            .fold(int(0), |sum, (b, c)| sum + &(Polynomial::constant(c) * b)),
    )
}
