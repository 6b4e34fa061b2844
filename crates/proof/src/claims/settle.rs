//! From which step on a system is near where it converges to, by its quadratic form.
//!
//! `|y^k|^2 <= rate^(2k) * y0'P y0 / floor` after k rounds, where `P - floor * 1` is positive definite.

use num_traits::{One, Signed, Zero};

use super::bounds::greatest;
use super::converge::Contraction;
use crate::settle::{Rounding, least_power_at_most};
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::definite::is_positive_definite;
use cordon_core::simplex::Work;
use cordon_core::system::System;

/// The step from which on every readout is at most `within`, from `start` or from every assumed start;
/// `None` where the starts have no bound, or the step is beyond 63 bits.
pub fn settles(
    system: &System,
    by: &Contraction,
    start: Option<&[Rational]>,
    within: &Rational,
) -> Option<u64> {
    let y = match start {
        Some(state) => by.readouts.at(state)?,
        None => {
            // Each readout by itself: no start has them all at their greatest.
            let starts = system.start_constraints();
            let work = Work::limited(super::PROOF.work);
            let bound = |form: Affine| {
                let negated = Affine::constant(Rational::zero()) - &form;
                let most = |form| greatest(form, &starts, system.state.len(), &work);
                Some(most(&form)?.max(most(&negated)?))
            };
            by.readouts.forms().into_iter().map(bound).collect::<Option<Vec<_>>>()?
        }
    };
    let value = |form: &Vec<Vec<Rational>>| {
        let terms = form.iter().zip(&y).flat_map(|(row, a)| {
            let signed = move |p: &Rational| if start.is_some() { p.clone() } else { p.abs() };
            row.iter().zip(&y).map(move |(p, b)| signed(p) * a * b)
        });
        terms.fold(Rational::zero(), |sum, t| sum + t)
    };
    // Whichever mode acts first, and whichever would act in the end.
    let measured = by.forms.iter().map(value).max()?;
    let floors = by.forms.iter().map(|form| floor(form)).collect::<Option<Vec<_>>>()?;
    let within = within / &by.swing;
    let wanted = &within * &within * floors.into_iter().min()?;
    if measured <= wanted {
        return Some(0);
    }
    let rounds = least_power_at_most(&(&by.rate * &by.rate), &(wanted / measured), Rounding::Up)?;
    rounds.checked_mul(by.round)
}

/// A number that the form is at least on every vector of length 1.
fn floor(form: &[Vec<Rational>]) -> Option<Rational> {
    let mut floor = Rational::one();
    let half = Rational::new(1.into(), 2.into());
    for _ in 0..60 {
        let lowered: Vec<Vec<Rational>> = form
            .iter()
            .enumerate()
            .map(|(i, row)| {
                row.iter()
                    .enumerate()
                    .map(|(j, p)| if i == j { p - &floor } else { p.clone() })
                    .collect()
            })
            .collect();
        if is_positive_definite(&lowered) {
            return Some(floor);
        }
        floor *= &half;
    }
    None
}
