//! The projection theorem (PROTOCOL section 1): local machines that exchange positions after
//! every tick compute the global run.
//!
//! By induction over ticks: machines that are the projections of a global state are, one
//! `swarm_tick` later, the projections of the state one `tick` later. What a machine holds
//! then depends on the classes of drones i-1, i and i+1; swarms of 3, 4 and 5 drones have every
//! combination. Counters are below the limit or at it: `timesteps >= num/den` and `timesteps =
//! n` agree for every integer up to n, n being the quotient rounded up (Listing 6 against Listing 4).

use std::num::NonZeroU32;

use cordon_spec::coverage::tick;
use cordon_spec::local::{LocalParams, TickRatio, project, swarm_tick};
use cordon_spec::{Params, Scalar, State};

use crate::claims::{Refusal, Scope};
use crate::model::named;
use crate::poly::{Poly, Var};
use crate::rules::{Obligation, Relation};

/// A quotient that is no integer: the counter limit is 2.
const RATIO: (u32, u32) = (3, 2);

/// One equation for every N and counter: the differences of all fields of all machines, each
/// times its own indeterminate, add up to zero just if every one is zero.
pub fn obligations(_: &Scope<'_>) -> Result<Vec<Obligation>, Refusal> {
    let den = NonZeroU32::new(RATIO.1).ok_or_else(|| Refusal::Wrong("ratio".into()))?;
    let ratio = TickRatio { num: RATIO.0, den };
    let n = ratio.counter_limit();
    let mut all = Vec::new();
    for count in 3..=5_usize {
        for (timesteps, label) in [(n - 1, "waiting"), (n, "updating")] {
            let protocol = Params { min: named("min"), max: named("max"), eps: named("eps"), n };
            let drones: Vec<Poly> = (0..count as i32).map(|i| Poly::var(Var::At("x", i))).collect();
            let global = State { drones, timesteps };
            let machines = |s: &State<Vec<Poly>>| -> Vec<_> {
                (0..count).map(|i| project(&protocol, s, i)).collect()
            };
            let local = LocalParams { protocol: protocol.clone(), count, ratio };
            let moved = swarm_tick(&local, &machines(&global));
            let wanted = machines(&tick(&protocol, global));
            let mut goal = Poly::from_int(0);
            for (i, (m, w)) in moved.iter().zip(&wanted).enumerate() {
                if m.timesteps != w.timesteps || m.st.id != w.st.id {
                    return Err(Refusal::Wrong("counters or identifiers differ".into()));
                }
                let fields = [
                    ("prec", &m.st.prec, &w.st.prec),
                    ("own", &m.st.own, &w.st.own),
                    ("foll", &m.st.foll, &w.st.foll),
                ];
                for (field, left, right) in fields {
                    let mark = Poly::var(Var::At(field, i as i32));
                    goal = goal + &(mark * &(left.clone() - right));
                }
            }
            let name = format!("drones-{count}/{label}");
            all.push(Obligation { name, facts: Vec::new(), goal, relation: Relation::Zero });
        }
    }
    Ok(all)
}
