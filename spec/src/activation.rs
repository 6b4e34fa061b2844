//! Steps in which only some drones update (PROTOCOL section 2, activation).

use crate::coverage::{getx, update};
use crate::{DroneMap, Params, Scalar, State};

/// A protocol step in which drone `i` moves where `active(i)` and keeps its position
/// otherwise. With every drone active this is `exec_coverage`.
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
