//! Steps that read stale messages (PROTOCOL section 2, stale messages).

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::coverage::{getx, update};
use crate::{DroneMap, Params, Scalar, State};

/// A protocol step in which drone `i` sees drone `j` at `seen(i, j)`, typically where `j` was
/// some steps ago; its own position it knows. With `seen(i, j) = getx(s, j)` this is
/// `exec_coverage`.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", requires(forall<i: usize, j: usize> i@ < s.drones.seq().len() && j@ < s.drones.seq().len() ==> seen.precondition((i, j))))]
#[cfg_attr(feature = "contracts", ensures(result.timesteps == s.timesteps && result.drones.seq().len() == s.drones.seq().len()))]
#[cfg_attr(feature = "contracts", ensures(forall<i, x: Seq<Real>> 0 <= i && i < s.drones.seq().len() && sees(seen, positions(*s), i, x)
    ==> positions(result)[i] == next_of(p.model(), x, i)))]
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
