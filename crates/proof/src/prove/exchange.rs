//! The goals of the projection theorem: local machines against the global tick.

use std::num::NonZeroU32;

use cordon_spec::coverage::tick;
use cordon_spec::local::{LocalParams, SimState, TickRatio, project, swarm_tick};
use cordon_spec::{Params, State};

use super::symbols::{Goal, Sign, cell, int, named};
use cordon_core::scalar::Polynomial;

/// For 3, 4 and 5 drones, waiting and updating: the sum of all differences between machines
/// and projections. It is the zero polynomial if every difference is; the checker keeps the
/// differences apart with marks.
pub fn goals() -> Vec<Goal> {
    let ratio = TickRatio { num: 3, den: NonZeroU32::MIN.saturating_add(1) };
    let n = ratio.counter_limit();
    let mut goals = Vec::new();
    for count in 3..=5 {
        for (timesteps, label) in [(n - 1, "waiting"), (n, "updating")] {
            let p = Params { min: named("min"), max: named("max"), eps: named("eps"), n };
            let drones: Vec<Polynomial> = (0..).take(count).map(|i| cell("x", i)).collect();
            let state = State { drones, timesteps };
            let machines: Vec<_> = (0..count).map(|i| project(&p, &state, i)).collect();
            let local = LocalParams { protocol: p.clone(), count, ratio };
            let moved = swarm_tick(&local, &machines);
            let next = tick(&p, state);
            let marks =
                (0..).step_by(3).map(|k| [cell("y", k - 40), cell("y", k - 39), cell("y", k - 38)]);
            let poly = moved.iter().enumerate().zip(marks).fold(int(0), |sum, ((i, m), marks)| {
                sum + &difference(m, &project(&p, &next, i), marks)
            });
            let name = format!("drones-{count}/{label}");
            goals.push(Goal { name, facts: Vec::new(), poly, sign: Sign::Zero });
        }
    }
    goals
}

fn difference(
    a: &SimState<Polynomial>,
    b: &SimState<Polynomial>,
    [prec, own, foll]: [Polynomial; 3],
) -> Polynomial {
    prec * &(a.st.prec.clone() - &b.st.prec)
        + &(own * &(a.st.own.clone() - &b.st.own))
        + &(foll * &(a.st.foll.clone() - &b.st.foll))
}
