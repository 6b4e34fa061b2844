//! Steps that read stale messages (PROTOCOL section 2, stale messages).

#[cfg(feature = "contracts")]
#[allow(unused_imports)] // the erased macros swallow each other's attributes
use creusot_contracts::prelude::{ensures, requires};

use crate::coverage::{getx, update};
use crate::{DroneMap, Params, Scalar, State};

/// A protocol step in which drone `i` sees drone `j` at `seen(i, j)`, typically where `j` was
/// some steps ago; its own position it knows. With `seen(i, j) = getx(s, j)` this is
/// `exec_coverage`.
#[cfg_attr(feature = "contracts", ensures(result.timesteps == s.timesteps))]
#[cfg_attr(feature = "contracts", ensures(result.drones.as_ref()@.len() == s.drones.as_ref()@.len()))]
pub fn exec_coverage_delayed<'s, S: Scalar + 's, M: DroneMap<S>>(
    p: &'s Params<S>,
    s: &'s State<M>,
    seen: impl Fn(usize, usize) -> &'s S,
) -> State<M> {
    let count = s.drones.count();
    State {
        drones: s
            .drones
            .lambda(|i| update(p, count, i, |j| if j == i { getx(s, i) } else { seen(i, j) })),
        timesteps: s.timesteps,
    }
}
