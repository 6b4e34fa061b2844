//! State variables that have one value in every run: the start gives it, and every step keeps it.

use std::collections::BTreeMap;

use num_traits::{One, Zero};

use cordon_core::exact::fraction;
use cordon_core::linear::feasible::Sign;
use cordon_core::scalar::Polynomial;
use cordon_core::system::{Mode, System};
use cordon_core::{Rational, Result};

/// The system with its pinned variables as numbers: its runs from assumed starts are the same ones.
///
/// # Errors
/// There is none: a step stays affine.
pub fn with_pinned(system: &System) -> Result<System> {
    let pinned = values(system);
    let mut with = system.clone();
    for mode in &mut with.modes {
        let variables = system.state.len();
        *mode = Mode::executed(&mode.name, variables, &system.parameters, |number, p, x| {
            let fixed = |x: &mut [Polynomial]| {
                for (j, value) in &pinned {
                    if let Some(slot) = x.get_mut(*j) {
                        *slot = number(value);
                    }
                }
            };
            let mut x = x.to_vec();
            fixed(&mut x);
            let mut next = mode.step(&number, p, &x);
            fixed(&mut next);
            next
        })?;
    }
    Ok(with)
}

/// `x0 = 0`: the pinned variables that are no past ones, for people.
pub fn texts(system: &System) -> Vec<String> {
    let now = system.state.len() - system.past.len();
    let text = |(j, value): (usize, Rational)| {
        Some(format!("{} = {}", system.state.get(j).filter(|_| j < now)?, fraction(&value)))
    };
    values(system).into_iter().filter_map(text).collect()
}

/// The values, by state variable.
fn values(system: &System) -> BTreeMap<usize, Rational> {
    let mut pinned = BTreeMap::new();
    for c in system.start_constraints().iter().filter(|c| c.sign == Sign::Zero) {
        let Some((constant, coefficients)) = c.form.parts() else { continue };
        let mut of = coefficients.iter().enumerate().filter(|(_, a)| !a.is_zero());
        if let (Some((j, a)), None) = (of.next(), of.next()) {
            pinned.insert(j, -constant / a);
        }
    }
    let one = Polynomial::constant(Rational::one());
    let stays = |mode: &Mode, j: usize| {
        mode.row(j).is_some_and(|(constant, entries)| {
            constant.is_zero() && entries.len() == 1 && entries.get(&j) == Some(&one)
        })
    };
    pinned.retain(|&j, _| system.modes.iter().all(|mode| stays(mode, j)));
    pinned
}
