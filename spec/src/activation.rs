//! Steps in which only some drones update (PROTOCOL section 2, activation).

#[cfg(feature = "contracts")]
#[allow(unused_imports)] // the erased macros swallow each other's attributes
use creusot_contracts::prelude::{ensures, requires};

use crate::coverage::{getx, update};
use crate::{DroneMap, Params, Scalar, State};

/// A protocol step in which drone `i` moves where `active(i)` and keeps its position
/// otherwise. With every drone active this is `exec_coverage`.
#[cfg_attr(feature = "contracts", ensures(result.timesteps == s.timesteps))]
#[cfg_attr(feature = "contracts", ensures(result.drones.as_ref()@.len() == s.drones.as_ref()@.len()))]
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
