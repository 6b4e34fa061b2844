//! Convergence and growth for one N and one weight, by a vector: an upper bound of all errors that falls, or
//! a lower bound of some that does not.

use std::collections::{BTreeMap, BTreeSet};

use cordon_spec::{Params, Scalar, State};

use crate::fault::{Result, Shown, ensure, fault};
use crate::number::Number;
use crate::poly::{Atom, Poly};
use crate::system::Step;

/// Most drones.
const MAX_DRONES: usize = 10_000;

/// `contraction`, with a rate: w > 0 and |A| w <= rate * w with 0 <= rate < 1. So max_i |e_i|/w_i falls by that rate in every
/// step, from every start. `growth`, without one: w > 0 and |A| w >= w, and with s_i = 1 or s_i = (-1)^i no s_i s_j a_ij has another
/// sign than the rest. So from errors s_i w_i no cancellation occurs and |e_i^k| >= w_i for every k.
///
/// A is the linear part of the spec's step on the inner drones' positions, hence of their errors: the targets are a fixed
/// point, x' = A x + b with T = A T + b gives T - x' = A (T - x). That is checked here too.
pub fn vector(
    rule: &'static str,
    (drones, eps, w): (u32, &Number, &[Number]),
    rate: Option<&Number>,
    step: Step,
) -> Result<Shown> {
    let falls = |rate| (Number::whole(0)..Number::whole(1)).contains(rate);
    ensure!(rate.is_none_or(falls), rule, "the rate is not in [0, 1)");
    let count = drones as usize;
    let few = (3..=MAX_DRONES).contains(&count);
    ensure!(few, rule, "{drones} drones: expected 3 to {MAX_DRONES}");
    ensure!(w.len() == count - 2, rule, "vector of {} entries: expected {}", w.len(), count - 2);
    for (i, entry) in w.iter().enumerate() {
        ensure!(entry.is_positive(), rule, "entry {i} of the vector is not above 0");
    }
    let last = Poly::from_index(count - 1);
    let params =
        Params { min: Poly::default(), max: last.clone(), eps: Poly::constant(eps.clone()), n: 0 };
    let after = |drones: Vec<Poly>| step(&params, &State { drones, timesteps: 0 }).drones;
    let targets: Vec<Poly> = (0..count).map(Poly::from_index).collect();
    ensure!(after(targets.clone()) == targets, rule, "the targets are not a fixed point");
    let name = |i: usize| Atom::App("x".into(), [Poly::from_index(i)].into());
    let mut symbols: Vec<Poly> = (0..count).map(|i| Poly::atom(name(i))).collect();
    (symbols[0], symbols[count - 1]) = (Poly::default(), last);
    let places: BTreeMap<Vec<Atom>, usize> = (1..count - 1).map(|j| (vec![name(j)], j)).collect();
    let (mut plain, mut alternating) = (BTreeSet::new(), BTreeSet::new());
    for (i, position) in after(symbols).iter().enumerate().take(count - 1).skip(1) {
        let mut sum = Number::whole(0);
        for (monomial, a) in position.terms().filter(|(monomial, _)| !monomial.is_empty()) {
            let Some(j) = places.get(monomial) else {
                return fault(rule, "the step is not linear in the drones");
            };
            sum = sum + &(a.magnitude() * &w[j - 1]);
            plain.insert(a.is_positive());
            alternating.insert(a.is_positive() == ((i + j) % 2 == 0));
        }
        let (within, how) = match rate {
            Some(rate) => (sum <= rate * &w[i - 1], "exceeds rate * w"),
            None => (sum >= w[i - 1], "is below w"),
        };
        ensure!(within, rule, "drone {i}: |A| w {how}");
    }
    // True of every weight here; it would not be of another protocol.
    let signs = rate.is_some() || plain.len() < 2 || alternating.len() < 2;
    ensure!(signs, rule, "the signs of A allow cancellation");
    let said = match rate {
        Some(_) => "from every start all drones converge to their targets",
        None => "from some start the drones do not converge",
    };
    Ok((format!("N = {drones}, eps = {eps}: {said}"), 1))
}
