//! Steps in which only some drones update (PROTOCOL section 2, activation).

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::coverage::{getx, update};
use crate::{DroneMap, Params, Scalar, State};

/// A protocol step in which drone `i` moves where `active(i)` and keeps its position
/// otherwise. With every drone active this is `exec_coverage`.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", requires(forall<i: usize> i@ < s.drones.seq().len() ==> active.precondition((i,))))]
#[cfg_attr(feature = "contracts", ensures(result.timesteps == s.timesteps && result.drones.seq().len() == s.drones.seq().len()))]
#[cfg_attr(feature = "contracts", ensures(forall<i> 0 <= i && i < s.drones.seq().len()
    ==> reals(result.drones.seq())[i] == next_of(p.model(), positions(*s), i) || reals(result.drones.seq())[i] == positions(*s)[i]))]
pub fn exec_coverage_active<S: Scalar, M: DroneMap<S>>(
    p: &Params<S>,
    s: &State<M>,
    active: impl Fn(usize) -> bool,
) -> State<M> {
    let count = s.drones.count();
    State {
        drones: s.drones.lambda(|i| {
            if active(i) { update(p, count, i, |j| getx(s, j)) } else { getx(s, i).clone() }
        }),
        timesteps: s.timesteps,
    }
}
