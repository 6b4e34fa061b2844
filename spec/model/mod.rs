//! What the contracts mean: the protocol over the real numbers.
//!
//! This is the module `model` of `cordon-spec`. Its contracts speak of a scalar as of the real
//! number [`Scalar::model`] and of a map of drones as of the sequence [`DroneMap::seq`]; the
//! functions here say what the protocol does to such numbers and sequences. They are logic, read
//! by Creusot and by nobody else: an ordinary build has none of them.
//!
//! Three things are assumed rather than proved: [`exact`], that a scalar's arithmetic is that of
//! the reals (`proofs/creusot/README.md` says of which scalars it is true); of Rust's own library,
//! what the `extern_spec` blocks say; and the promises of functions that are `trusted`.

pub use creusot_std::logic::ops::IndexLogic as _;
pub use creusot_std::logic::real::Real;
#[cfg(creusot)]
pub use creusot_std::prelude::inv;
pub use creusot_std::prelude::{
    DeepModel, Int, OrdLogic, Seq, Snapshot, View, ensures, extern_spec, invariant, logic,
    pearlite, proof_assert, requires, snapshot, trusted, variant,
};
pub use creusot_std::std::ops::{FnExt as _, FnMutExt as _, FnOnceExt as _};

mod lemmas;
mod verdicts;

pub use self::lemmas::*;
pub use self::verdicts::*;

use core::convert::AsRef;
use core::num::NonZero;
use core::ops::{Add, Mul, Sub};

use crate::graph::Graph;
use crate::local::{LocalParams, SimState};
use crate::{DroneMap, Ordered, Params, Scalar, State};

extern_spec! {
    mod core {
        mod ops {
            trait Add<Rhs> { fn add(self, rhs: Rhs) -> <Self as Add<Rhs>>::Output; }
            trait Sub<Rhs> { fn sub(self, rhs: Rhs) -> <Self as Sub<Rhs>>::Output; }
            trait Mul<Rhs> { fn mul(self, rhs: Rhs) -> <Self as Mul<Rhs>>::Output; }
        }
        mod convert {
            trait AsRef<T> where T: ?Sized { fn as_ref(&self) -> &T; }
        }
        mod array {
            #[requires(forall<i: usize, g: F> i@ < N@ && f.hist_inv(g) ==> g.precondition((i,)))]
            #[ensures(forall<i: Int> 0 <= i && i < N@ ==> exists<u: usize, g: F, h: F>
                u@ == i && f.hist_inv(g) && g.postcondition_mut((u,), h, result@[i]))]
            fn from_fn<T, const N: usize, F>(f: F) -> [T; N] where F: FnMut(usize) -> T;
        }
    }

    impl<T, const N: usize> AsRef<[T]> for [T; N] {
        #[ensures(result@ == self@)]
        fn as_ref(&self) -> &[T];
    }

    impl TryFrom<usize> for i32 {
        #[ensures(match result { Ok(n) => n@ == u@, Err(_) => u@ > i32::MAX@ })]
        fn try_from(u: usize) -> Result<i32, core::num::TryFromIntError>;
    }

    impl u32 {
        #[requires(rhs@ > 0)]
        #[ensures(result@ * rhs@ >= self@)]
        #[ensures(result@ > 0 ==> (result@ - 1) * rhs@ < self@)]
        fn div_ceil(self, rhs: u32) -> u32;
    }

    impl usize {
        #[requires(rhs@ > 0)]
        #[ensures(result@ * rhs@ >= self@)]
        #[ensures(result@ > 0 ==> (result@ - 1) * rhs@ < self@)]
        fn div_ceil(self, rhs: usize) -> usize;
    }
}

/// That the arithmetic of `S` is the arithmetic of the reals: every operation is defined for all
/// arguments and has the result that it has there. (That every place of a sequence has a `usize`
/// is a hint: the code's answers are about such.)
#[logic(open, prophetic)]
#[ensures(forall<x: Seq<S>, k> #[trigger(x[k])] 0 <= k && k < x.len() && x.len() <= usize::MAX@ ==> index(k)@ == k)]
pub fn exact<S: Scalar>() -> bool {
    pearlite! {
        (forall<a: S, b: &S> <S as Add<&S>>::add.precondition((a, b)))
        && (forall<a: S, b: &S> <S as Sub<&S>>::sub.precondition((a, b)))
        && (forall<a: S, b: &S> <S as Mul<&S>>::mul.precondition((a, b)))
        && (forall<a: &S> S::clone.precondition((a,)))
        && (forall<a: S, b: &S, r: S> <S as Add<&S>>::add.postcondition_once((a, b), r)
            ==> r.model() == a.model() + b.model())
        && (forall<a: S, b: &S, r: S> <S as Sub<&S>>::sub.postcondition_once((a, b), r)
            ==> r.model() == a.model() - b.model())
        && (forall<a: S, b: &S, r: S> <S as Mul<&S>>::mul.postcondition_once((a, b), r)
            ==> r.model() == times(a.model(), b.model()))
        && (forall<a: &S, r: S> S::clone.postcondition_once((a,), r) ==> r.model() == a.model())
    }
}

/// The whole number as a real one.
#[logic(open, inline)]
pub fn int(n: Int) -> Real {
    Real::from_int(n)
}

/// The value of a denominator.
#[trusted]
#[logic(opaque)]
#[ensures(result > 0)]
pub fn whole(n: NonZero<u32>) -> Int {
    dead
}

/// That `y` is the list of the `len` values of `f`.
#[logic(open)]
pub fn lists<T, F: Fn(usize) -> T>(f: F, len: Int, y: Seq<T>) -> bool {
    pearlite! {
        y.len() == len && forall<i> 0 <= i && i < len
            ==> exists<u: usize> u@ == i && f.postcondition((u,), y[i])
    }
}

/// The `usize` of an index.
#[trusted]
#[logic(opaque)]
#[ensures(0 <= k && k <= usize::MAX@ ==> result@ == k)]
pub fn index(k: Int) -> usize {
    dead
}

/// The real numbers that scalars stand for.
#[logic(open)]
pub fn reals<S: Scalar>(x: Seq<S>) -> Seq<Real> {
    Seq::create(x.len(), |i: Int| x[i].model())
}

/// The positions of the drones.
#[logic(open, inline)]
pub fn positions<S: Scalar, M: DroneMap<S>>(s: State<M>) -> Seq<Real> {
    reals(s.drones.seq())
}

impl<S: Scalar> Params<S> {
    /// Ends and weight as real numbers.
    #[logic(open)]
    pub fn model(self) -> Params<Real> {
        Params { min: self.min.model(), max: self.max.model(), eps: self.eps.model(), n: self.n }
    }
}

/// Equation 10 with the ends of Listing 4: what [`exec_cvg`](crate::coverage::exec_cvg) computes.
#[logic(open)]
pub fn next(p: Params<Real>, count: Int, a: Real, b: Real, c: Real, i: Int) -> Real {
    if i == 0 {
        p.min
    } else if i + 1 == count {
        p.max
    } else {
        p.eps * a + (int(1) - int(2) * p.eps) * b + p.eps * c
    }
}

/// Where drone `i` goes from the placement `x`.
#[logic(open)]
pub fn next_of(p: Params<Real>, x: Seq<Real>, i: Int) -> Real {
    let a = if i > 0 { x[i - 1] } else { p.min };
    let c = if i + 1 < x.len() { x[i + 1] } else { p.max };
    next(p, x.len(), a, x[i], c, i)
}

/// The placement one protocol step after `x`.
#[logic(open)]
pub fn step(p: Params<Real>, x: Seq<Real>) -> Seq<Real> {
    Seq::create(x.len(), |i: Int| next_of(p, x, i))
}

/// The placement `k` protocol steps after `x`.
#[logic(open)]
#[variant(k)]
#[requires(k >= 0)]
pub fn steps(p: Params<Real>, x: Seq<Real>, k: Int) -> Seq<Real> {
    if k == 0 { x } else { step(p, steps(p, x, k - 1)) }
}

/// That `position_of` reads the placement `x`.
#[logic(open, prophetic)]
pub fn reads<'s, S: Scalar + 's, F: Fn(usize) -> &'s S>(position_of: F, x: Seq<Real>) -> bool {
    pearlite! {
        forall<j: usize, r: &'s S> j@ < x.len() && position_of.postcondition((j,), r)
            ==> r.model() == x[j@]
    }
}

/// The sum of the first `n` numbers.
#[logic(open)]
#[variant(n)]
#[requires(0 <= n && n <= x.len())]
pub fn total(x: Seq<Real>, n: Int) -> Real {
    if n == 0 { int(0) } else { total(x, n - 1) + x[n - 1] }
}

/// That the pair `e` links the drones `i` and `j`.
#[logic(open)]
pub fn joins(e: (usize, usize), i: Int, j: Int) -> bool {
    pearlite! { e.0@ == i && e.1@ == j || e.0@ == j && e.1@ == i }
}

/// That every neighbour of drone `i` is in the range.
#[logic(open)]
pub fn hears<G: Graph + ?Sized>(g: G, i: Int, range: core::ops::Range<usize>) -> bool {
    pearlite! {
        range.start@ <= range.end@ && range.end@ <= g.size() && forall<j> 0 <= j && j < g.size()
            && g.edge(i, j) ==> range.start@ <= j && j < range.end@
    }
}

/// What drone `i` hears from drone `j`: their distance, if they are linked.
#[logic(open)]
pub fn heard<G: Graph>(g: G, x: Seq<Real>, i: Int, j: Int) -> Real {
    if g.edge(i, j) { x[j] - x[i] } else { int(0) }
}

/// The sum of the distances of drone `i` from its neighbours among the first `n` drones.
#[logic(open)]
#[variant(n)]
#[requires(n >= 0)]
pub fn pull_of<G: Graph>(g: G, x: Seq<Real>, i: Int, n: Int) -> Real {
    if n == 0 { int(0) } else { pull_of(g, x, i, n - 1) + heard(g, x, i, n - 1) }
}

/// The placement one consensus step after `x` (equation 6).
#[logic(open)]
pub fn consensus_step<G: Graph>(eps: Real, g: G, x: Seq<Real>) -> Seq<Real> {
    Seq::create(x.len(), |i: Int| x[i] + eps * pull_of(g, x, i, x.len()))
}

/// The index of the last of `count` drones; 0 of none.
#[logic(open)]
pub fn last_of(count: Int) -> Int {
    if count > 0 { count - 1 } else { 0 }
}

/// `last` times the target of drone `i` (definition 3 times N-1).
#[logic(open)]
pub fn target(min: Real, max: Real, last: Real, i: Real) -> Real {
    last * min + i * (max - min)
}

/// N-1 times the error of drone `i`.
#[logic(open)]
pub fn error(min: Real, max: Real, x: Seq<Real>, i: Int) -> Real {
    let last = int(last_of(x.len()));
    target(min, max, last, int(i)) - last * x[i]
}

/// `0 <= eps <= 1/2`.
#[logic(open)]
pub fn up_to_half(p: Params<Real>) -> bool {
    int(0) <= p.eps && int(2) * p.eps <= int(1)
}

/// Drones 0 and N-1 are at the ends of the segment (assumption 1).
#[logic(open)]
pub fn anchored(p: Params<Real>, x: Seq<Real>) -> bool {
    x.len() >= 2 && x[0] == p.min && x[x.len() - 1] == p.max
}

/// X_i < X_{i+1} for all i (assumption 2, theorem 7.2).
#[logic(open)]
pub fn in_order(x: Seq<Real>) -> bool {
    pearlite! { forall<i> 0 <= i && i + 1 < x.len() ==> x[i] < x[i + 1] }
}

/// X_i <= T_i for all i (theorem 7.3).
#[logic(open)]
pub fn behind(p: Params<Real>, x: Seq<Real>) -> bool {
    pearlite! { forall<i> 0 <= i && i < x.len() ==> error(p.min, p.max, x, i) >= int(0) }
}

/// X_i >= T_i for all i: the mirror image of 7.3.
#[logic(open)]
pub fn ahead(p: Params<Real>, x: Seq<Real>) -> bool {
    pearlite! { forall<i> 0 <= i && i < x.len() ==> error(p.min, p.max, x, i) <= int(0) }
}

/// min <= X_i <= max for all i.
#[logic(open)]
pub fn boxed(p: Params<Real>, x: Seq<Real>) -> bool {
    pearlite! { forall<i> 0 <= i && i < x.len() ==> p.min <= x[i] && x[i] <= p.max }
}

/// That `after` is `before` after `k` ticks: with the counter at `t`, `t + k` ticks have passed
/// since it last was 0, and a step ends every `n + 1` of them.
#[logic(open)]
pub fn after_ticks<S: Scalar, M: DroneMap<S>>(
    p: Params<Real>,
    before: State<M>,
    k: Int,
    after: State<M>,
) -> bool {
    pearlite! {
        let passed = before.timesteps@ + k;
        let period = p.n@ + 1;
        after.timesteps@ == passed.rem_euclid(period)
            && positions(after) == steps(p, positions(before), passed.div_euclid(period))
    }
}

/// What [`tick`](crate::coverage::tick) does to the state `s`.
#[logic(open)]
pub fn ticked<S: Scalar, M: DroneMap<S>>(p: Params<Real>, s: State<M>, after: State<M>) -> bool {
    pearlite! {
        if s.timesteps == p.n {
            after.timesteps@ == 0 && positions(after) == step(p, positions(s))
        } else {
            after.timesteps@ == s.timesteps@ + 1 && positions(after) == positions(s)
        }
    }
}

/// That drone `i` of the delayed step sees the placement `x`: itself as it is in `now`, the
/// others as `seen` has them.
#[logic(open, prophetic)]
pub fn sees<'s, S: Scalar + 's, F: Fn(usize, usize) -> &'s S>(
    seen: F,
    now: Seq<Real>,
    i: Int,
    x: Seq<Real>,
) -> bool {
    pearlite! {
        x.len() == now.len() && x[i] == now[i]
            && forall<u: usize, j: usize, r: &'s S> u@ == i && j@ < x.len() && j != u
                && seen.postcondition((u, j), r) ==> r.model() == x[j@]
    }
}

/// What [`fmu_tick`](crate::local::fmu_tick) does to the machine `s`.
#[logic(open)]
pub fn local_tick<S: Scalar>(p: LocalParams<S>, s: SimState<S>, after: SimState<S>) -> bool {
    pearlite! {
        after.st.prec == s.st.prec && after.st.foll == s.st.foll && local_update(p, s, after)
    }
}

/// What [`fmu_tick`](crate::local::fmu_tick) does to a copy of the machine `s`, as far as the
/// other machines learn of it.
#[logic(open)]
pub fn local_update<S: Scalar>(p: LocalParams<S>, s: SimState<S>, after: SimState<S>) -> bool {
    pearlite! {
        after.st.id == s.st.id && if s.timesteps@ * whole(p.ratio.den) >= p.ratio.num@ {
            after.timesteps@ == 0 && after.st.own.model() == next(
                p.protocol.model(),
                p.count@,
                s.st.prec.model(),
                s.st.own.model(),
                s.st.foll.model(),
                s.st.id@,
            )
        } else {
            after.timesteps@ == s.timesteps@ + 1 && after.st.own.model() == s.st.own.model()
        }
    }
}

/// That `after` is a copy of the machine `s` one tick later.
#[logic(open)]
pub fn copy_updated<S: Scalar>(p: LocalParams<S>, s: SimState<S>, after: SimState<S>) -> bool {
    pearlite! {
        exists<m: SimState<S>> local_tick(p, m, after) && m.timesteps == s.timesteps
            && m.st.id == s.st.id && m.st.own.model() == s.st.own.model()
            && m.st.prec.model() == s.st.prec.model() && m.st.foll.model() == s.st.foll.model()
    }
}

/// That the machine `m` is drone `i` of the placement `x`, and knows its neighbours' places.
#[logic(open)]
pub fn knows<S: Scalar>(m: SimState<S>, x: Seq<Real>, i: Int) -> bool {
    pearlite! {
        m.st.id@ == i && m.st.own.model() == x[i]
            && (i > 0 ==> m.st.prec.model() == x[i - 1])
            && (i + 1 < x.len() ==> m.st.foll.model() == x[i + 1])
    }
}

/// That every machine of `after` is that of `before` with its neighbours' present positions.
#[logic(open)]
pub fn exchanged<S: Scalar>(before: Seq<SimState<S>>, after: Seq<SimState<S>>) -> bool {
    pearlite! {
        forall<i> 0 <= i && i < before.len() ==> after[i].timesteps == before[i].timesteps
            && after[i].st.id == before[i].st.id
            && after[i].st.own.model() == before[i].st.own.model()
            && (i > 0 ==> after[i].st.prec.model() == before[i - 1].st.own.model())
            && (i + 1 < before.len() ==> after[i].st.foll.model() == before[i + 1].st.own.model())
    }
}

/// That the machines are the projections of the placement `x` with the counter at `t`.
#[logic(open)]
pub fn projections<S: Scalar>(machines: Seq<SimState<S>>, x: Seq<Real>, t: Int) -> bool {
    pearlite! {
        machines.len() == x.len() && forall<i> 0 <= i && i < x.len()
            ==> knows(machines[i], x, i) && machines[i].timesteps@ == t
    }
}

/// That the machines are at the places `x`, whatever they know of each other, with the counter
/// at `t`.
#[logic(open)]
pub fn placed<S: Scalar>(machines: Seq<SimState<S>>, x: Seq<Real>, t: Int) -> bool {
    pearlite! {
        machines.len() == x.len() && forall<i> 0 <= i && i < x.len()
            ==> machines[i].st.id@ == i && machines[i].st.own.model() == x[i]
                && machines[i].timesteps@ == t
    }
}

/// The first half of [`refines_tick`]: before the machines have exchanged their positions.
#[logic(open)]
pub fn moves_on<S: Scalar>(
    p: LocalParams<S>,
    before: Seq<SimState<S>>,
    after: Seq<SimState<S>>,
) -> bool {
    pearlite! {
        forall<x: Seq<Real>, t: Int> projections(before, x, t)
            ==> if t * whole(p.ratio.den) >= p.ratio.num@ {
                placed(after, step(p.protocol.model(), x), 0)
            } else {
                placed(after, x, t + 1)
            }
    }
}

/// The projection theorem for one tick: projections of a global state become those of the global
/// state one tick later.
#[logic(open)]
pub fn refines_tick<S: Scalar>(
    p: LocalParams<S>,
    before: Seq<SimState<S>>,
    after: Seq<SimState<S>>,
) -> bool {
    pearlite! {
        forall<x: Seq<Real>, t: Int> projections(before, x, t)
            ==> if t * whole(p.ratio.den) >= p.ratio.num@ {
                projections(after, step(p.protocol.model(), x), 0)
            } else {
                projections(after, x, t + 1)
            }
    }
}
