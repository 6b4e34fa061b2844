//! The coverage protocol of one drone that knows only its neighbours (Listings 5 and 6).
//!
//! Projection theorem (PROTOCOL section 1): N local machines that [`exchange`] their positions
//! after every [`fmu_tick`] compute exactly the global `kth_step`.

use core::num::NonZeroU32;

#[cfg(feature = "contracts")]
use creusot_std::prelude::Clone;

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::coverage::{exec_cvg, getx};
use crate::{DroneMap, Params, Scalar, State};

/// The quotient `eps/stepsize` of Listing 6 (period over step size, both in seconds), which
/// need not be an integer.
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct TickRatio {
    /// Numerator; 0 means an update in every tick.
    pub num: u32,
    /// Denominator, by its type not 0.
    pub den: NonZeroU32,
}

impl TickRatio {
    /// The whole number `num`.
    #[cfg_attr(feature = "contracts", trusted, ensures(result.num == num && whole(result.den) == 1))]
    pub fn whole(num: u32) -> Self {
        Self { num, den: NonZeroU32::MIN }
    }

    // Trusted: Creusot has no model of `NonZeroU32`.
    #[cfg_attr(feature = "contracts", trusted, ensures(result@ == whole(self.den)))]
    fn denominator(self) -> u32 {
        self.den.get()
    }

    /// Whether `timesteps >= num/den`, decided on integers.
    #[cfg_attr(feature = "contracts", ensures(result == (timesteps@ * whole(self.den) >= self.num@)))]
    pub fn reached_by(self, timesteps: u32) -> bool {
        u64::from(timesteps) * u64::from(self.denominator()) >= u64::from(self.num)
    }

    /// The global counter limit that behaves the same: the quotient rounded up. (Listing 6's
    /// `>=` rounds up where Listing 4's `=` would never fire.)
    #[cfg_attr(feature = "contracts", ensures(result@ * whole(self.den) >= self.num@))]
    #[cfg_attr(feature = "contracts", ensures(result@ > 0 ==> (result@ - 1) * whole(self.den) < self.num@))]
    pub fn counter_limit(self) -> u32 {
        self.num.div_ceil(self.denominator())
    }
}

/// What one local machine is told before the run.
#[derive(Clone)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct LocalParams<S> {
    /// Ends of the segment, weight, and `n`, which the local form does not read: it counts
    /// against `ratio`.
    pub protocol: Params<S>,
    /// The number of drones N.
    pub count: usize,
    /// Ticks between updates, as the quotient `eps/stepsize`.
    pub ratio: TickRatio,
}

/// What a drone knows: its own position, those of its neighbours, and its identifier
/// (Listing 5, `state`).
#[derive(Clone)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct LocalState<S> {
    /// Position of the preceding drone as last received (drone 0 ignores it).
    pub prec: S,
    /// Own position (the paper's `self`, a keyword here).
    pub own: S,
    /// Position of the following drone as last received (drone N-1 ignores it).
    pub foll: S,
    /// Identifier in `0 .. N-1`.
    pub id: usize,
}

/// State of one local machine (Listing 5, `simstate`).
#[derive(Clone)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct SimState<S> {
    /// Ticks since the last update.
    pub timesteps: u32,
    /// What the drone knows.
    pub st: LocalState<S>,
}

/// [`exec_cvg`] under its name of Listing 6. The paper has two copies of the formula; here
/// the second name is a call of the first.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && i@ < p.count@))]
#[cfg_attr(feature = "contracts", ensures(result.model() == next(p.protocol.model(), p.count@, a.model(), b.model(), c.model(), i@)))]
pub fn fmu_exec_cvg<S: Scalar>(p: &LocalParams<S>, a: &S, b: &S, c: &S, i: usize) -> S {
    exec_cvg(&p.protocol, p.count, a, b, c, i)
}

/// One tick of one local machine (Listing 6, `fmu_tick`).
#[cfg_attr(feature = "contracts", requires(exact::<S>() && s.st.id@ < p.count@))]
#[cfg_attr(feature = "contracts", ensures(local_tick(*p, s, result)))]
pub fn fmu_tick<S: Scalar>(p: &LocalParams<S>, s: SimState<S>) -> SimState<S> {
    if p.ratio.reached_by(s.timesteps) {
        let st = &s.st;
        let xp = if st.id > 0 { &st.prec } else { &p.protocol.min };
        let xf = if st.id + 1 < p.count { &st.foll } else { &p.protocol.max };
        let own = fmu_exec_cvg(p, xp, &st.own, xf, st.id);
        SimState { timesteps: 0, st: LocalState { own, ..s.st } }
    } else {
        // Never saturates: a counter below the quotient is below u32::MAX.
        SimState { timesteps: s.timesteps.saturating_add(1), ..s }
    }
}

/// `fmu_tick` applied `k` times (Listing 6, `fmu_kth_step`), with the neighbours' positions
/// staying as they were received.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && initial.st.id@ < p.count@))]
#[cfg_attr(feature = "contracts", ensures(result.st.id == initial.st.id))]
#[cfg_attr(feature = "contracts", ensures(result.st.prec == initial.st.prec && result.st.foll == initial.st.foll))]
pub fn fmu_kth_step<S: Scalar>(p: &LocalParams<S>, initial: SimState<S>, k: u64) -> SimState<S> {
    #[cfg(creusot)]
    let start = snapshot!(initial);
    let mut s = initial;
    #[cfg_attr(creusot, invariant(s.st.id == start.st.id && s.st.prec == start.st.prec && s.st.foll == start.st.foll))]
    for _ in 0..k {
        s = fmu_tick(p, s);
    }
    s
}

/// The local machine of drone `i` that agrees with the global state `s`: its projection.
/// `i` is below N.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && i@ < s.drones.seq().len()))]
#[cfg_attr(feature = "contracts", ensures(knows(result, positions(*s), i@) && result.timesteps == s.timesteps))]
pub fn project<S: Scalar, M: DroneMap<S>>(p: &Params<S>, s: &State<M>, i: usize) -> SimState<S> {
    let prec = if i > 0 { getx(s, i - 1) } else { &p.min };
    let foll = if i + 1 < s.drones.count() { getx(s, i + 1) } else { &p.max };
    SimState {
        timesteps: s.timesteps,
        st: LocalState { prec: prec.clone(), own: getx(s, i).clone(), foll: foll.clone(), id: i },
    }
}

/// Every machine receives its neighbours' present positions: what the co-simulation master
/// does between two ticks.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(result.seq().len() == machines.seq().len()))]
#[cfg_attr(feature = "contracts", ensures(exchanged(machines.seq(), result.seq())))]
pub fn exchange<S: Scalar, L: DroneMap<SimState<S>>>(machines: &L) -> L {
    let m = machines.as_ref();
    machines.lambda(|i| {
        let mut s = m[i].clone();
        if i > 0 {
            s.st.prec = m[i - 1].st.own.clone();
        }
        if i + 1 < m.len() {
            s.st.foll = m[i + 1].st.own.clone();
        }
        s
    })
}

/// One tick of all local machines, then one [`exchange`]: the local counterpart of the global
/// `tick`.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && p.count@ == machines.seq().len()))]
#[cfg_attr(feature = "contracts", requires(forall<i> 0 <= i && i < p.count@ ==> machines.seq()[i].st.id@ == i))]
#[cfg_attr(feature = "contracts", ensures(refines_tick(*p, machines.seq(), result.seq())))]
pub fn swarm_tick<S: Scalar, L: DroneMap<SimState<S>>>(p: &LocalParams<S>, machines: &L) -> L {
    let moved = machines.lambda(|i| fmu_tick(p, machines.as_ref()[i].clone()));
    #[cfg(creusot)]
    proof_assert!(forall<i> 0 <= i && i < p.count@ ==> copy_updated(*p, machines.seq()[i], moved.seq()[i]));
    #[cfg(creusot)]
    proof_assert!({
        local_is_global(*p, machines.seq(), moved.seq());
        moves_on(*p, machines.seq(), moved.seq())
    });
    exchange(&moved)
}
