//! The coverage protocol of the whole swarm (equation 10, Listing 4).

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::{DroneMap, Params, Scalar, State};

/// The next position of drone `i` of `count` from its predecessor's position `a`, its own `b`
/// and its successor's `c` (equation 10; Listing 4, `exec_cvg`).
///
/// ```text
/// exec_cvg(a, b, c, i) = min                               if i = 0
///                      = max                               if i = N-1
///                      = eps*a + (1 - 2*eps)*b + eps*c     otherwise
/// ```
///
/// The end drones go to `min` and `max` whatever `a`, `b` and `c` are.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && i@ < count@))]
#[cfg_attr(feature = "contracts", ensures(result.model() == next(p.model(), count@, a.model(), b.model(), c.model(), i@)))]
pub fn exec_cvg<S: Scalar>(p: &Params<S>, count: usize, a: &S, b: &S, c: &S, i: usize) -> S {
    if i == 0 {
        p.min.clone()
    } else if i + 1 == count {
        p.max.clone()
    } else {
        // eps*a + (1 - 2*eps)*b + eps*c
        let (eps, one, two) = (&p.eps, S::from_int(1), S::from_int(2));
        eps.clone() * a + &((one - &(two * eps)) * b) + &(eps.clone() * c)
    }
}

/// The position of drone `i` (Listing 4, `getx`); `i` is below N.
#[cfg_attr(feature = "contracts", requires(i@ < s.drones.seq().len()), ensures(*result == s.drones.seq()[i@]))]
pub fn getx<S, M: DroneMap<S>>(s: &State<M>, i: usize) -> &S {
    &s.drones.as_ref()[i]
}

/// The next position of drone `i`, reading the positions it needs through `position_of`.
///
/// This is the `LET xp, x, xf` block of Listing 4: the end drones have one neighbour only
/// and the segment's end stands in for the other.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && i@ < count@))]
#[cfg_attr(feature = "contracts", requires(forall<j: usize> j@ < count@ ==> position_of.precondition((j,))))]
#[cfg_attr(feature = "contracts", ensures(forall<x: Seq<Real>> x.len() == count@ && reads(position_of, x) ==> result.model() == next_of(p.model(), x, i@)))]
pub(crate) fn update<'s, S: Scalar + 's>(
    p: &'s Params<S>,
    count: usize,
    i: usize,
    position_of: impl Fn(usize) -> &'s S,
) -> S {
    let xp = if i > 0 { position_of(i - 1) } else { &p.min };
    let x = position_of(i);
    let xf = if i + 1 < count { position_of(i + 1) } else { &p.max };
    exec_cvg(p, count, xp, x, xf, i)
}

/// One protocol step: every drone moves at once, from the same old positions (Listing 4,
/// `exec_coverage`). The tick counter is kept.
#[cfg_attr(feature = "contracts", requires(exact::<S>()), ensures(result.timesteps == s.timesteps))]
#[cfg_attr(feature = "contracts", ensures(positions(result).ext_eq(step(p.model(), positions(*s)))))]
pub fn exec_coverage<S: Scalar, M: DroneMap<S>>(p: &Params<S>, s: &State<M>) -> State<M> {
    State { drones: next_placement(p, &s.drones), timesteps: s.timesteps }
}

/// The `LAMBDA (i: drone_id)` of Listing 4: the next position of every drone.
#[cfg_attr(feature = "contracts", requires(exact::<S>()), ensures(reals(result.seq()).ext_eq(step(p.model(), reals(drones.seq())))))]
fn next_placement<S: Scalar, M: DroneMap<S>>(p: &Params<S>, drones: &M) -> M {
    let x = drones.as_ref();
    drones.lambda(|i| update(p, x.len(), i, |j| &x[j]))
}

/// One tick: a protocol step when the counter has reached `n`, otherwise only the counter
/// moves (Listing 4, `tick`). One tick is one co-simulation step of tau seconds.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && s.timesteps <= p.n), ensures(ticked(p.model(), s, result)))]
pub fn tick<S: Scalar, M: DroneMap<S>>(p: &Params<S>, s: State<M>) -> State<M> {
    s.tick_with(p.n, |drones| next_placement(p, drones))
}

/// `tick` applied `k` times to `initial` (Listing 4, `kth_step`; iterated where the paper
/// recurses, so that the cost is k ticks and the stack is flat).
///
/// `k` counts ticks. With `n = 0` every tick is a protocol step, so that the placement X^k
/// of the paper's section 7 is `kth_step` with `n = 0`.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && initial.timesteps <= p.n))]
#[cfg_attr(feature = "contracts", ensures(after_ticks(p.model(), initial, k@, result)))]
pub fn kth_step<S: Scalar, M: DroneMap<S>>(p: &Params<S>, initial: State<M>, k: u64) -> State<M> {
    #[cfg(creusot)]
    let start = snapshot!(initial);
    let mut s = initial;
    #[cfg_attr(creusot, invariant(s.timesteps <= p.n && after_ticks(p.model(), *start, produced.len(), s)))]
    for _ in 0..k {
        #[cfg(creusot)]
        let before = snapshot!(s);
        s = tick(p, s);
        #[cfg(creusot)]
        proof_assert!(one_tick_more(p.model(), *start, produced.len() - 1, *before, s));
    }
    s
}
