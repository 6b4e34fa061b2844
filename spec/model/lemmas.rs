//! What Creusot has to be told on the way to the contracts of the code.

use super::*;

/// Drones without a link add nothing.
#[logic]
#[variant(to)]
#[requires(0 <= from && from <= to && forall<j> from <= j && j < to ==> !g.edge(i, j))]
#[ensures(pull_of(g, x, i, to) == pull_of(g, x, i, from))]
pub fn nobody_there<G: Graph>(g: G, x: Seq<Real>, i: Int, from: Int, to: Int) {
    if from < to {
        nobody_there(g, x, i, from, to - 1)
    }
}

/// Whoever is in the range is all that drone `i` hears.
#[logic]
#[requires(hears(g, i, range) && g.size() == x.len())]
#[ensures(pull_of(g, x, i, range.start.view()) == int(0))]
#[ensures(pull_of(g, x, i, range.end.view()) == pull_of(g, x, i, x.len()))]
pub fn range_is_all<G: Graph>(g: G, x: Seq<Real>, i: Int, range: core::ops::Range<usize>) {
    nobody_there(g, x, i, 0, range.start.view());
    nobody_there(g, x, i, range.end.view(), x.len())
}

/// The counter after one tick more: it wraps, and a step ends, where it reaches the period.
#[logic]
#[requires(passed >= 0 && period > 0)]
#[ensures(passed.div_euclid(period) >= 0)]
#[ensures(passed.rem_euclid(period) + 1 < period ==> (passed + 1).rem_euclid(period) == passed.rem_euclid(period) + 1
    && (passed + 1).div_euclid(period) == passed.div_euclid(period))]
#[ensures(passed.rem_euclid(period) + 1 == period ==> (passed + 1).rem_euclid(period) == 0
    && (passed + 1).div_euclid(period) == passed.div_euclid(period) + 1)]
pub fn counter_more(passed: Int, period: Int) {}

/// The induction step of [`kth_step`](crate::coverage::kth_step).
#[logic]
#[requires(k >= 0 && after_ticks(p, start, k, before) && ticked(p, before, after))]
#[ensures(result && after_ticks(p, start, k + 1, after))]
pub fn one_tick_more<S: Scalar, M: DroneMap<S>>(
    p: Params<Real>,
    start: State<M>,
    k: Int,
    before: State<M>,
    after: State<M>,
) -> bool {
    counter_more(start.timesteps.view() + k, p.n.view() + 1);
    true
}

/// Where a machine goes that knows its neighbours' places.
#[logic]
#[requires(knows(m, x, i) && 0 <= i && i < x.len())]
#[ensures(next(p, x.len(), m.st.prec.model(), m.st.own.model(), m.st.foll.model(), i) == next_of(p, x, i))]
pub fn one_machine<S: Scalar>(p: Params<Real>, m: SimState<S>, x: Seq<Real>, i: Int) {}

/// Local updates of projections are the global step.
#[logic]
#[requires(before.len() == p.count.view() && after.len() == p.count.view())]
#[requires(forall<i> 0 <= i && i < before.len() ==> copy_updated(p, before[i], after[i]))]
#[ensures(moves_on(p, before, after))]
pub fn local_is_global<S: Scalar>(
    p: LocalParams<S>,
    before: Seq<SimState<S>>,
    after: Seq<SimState<S>>,
) {
    pearlite! {
        proof_assert!(forall<i> 0 <= i && i < before.len() ==> local_update(p, before[i], after[i]));
        proof_assert!(forall<x: Seq<Real>, i> 0 <= i && i < before.len() && x.len() == before.len() && knows(before[i], x, i)
            ==> { one_machine(p.protocol.model(), before[i], x, i); true }
            && next(p.protocol.model(), p.count@, before[i].st.prec.model(), before[i].st.own.model(), before[i].st.foll.model(), i)
                == next_of(p.protocol.model(), x, i))
    }
}

/// The product. Its definition stays here: what the provers are told elsewhere is that equal factors
/// have equal products, which they do not see in `a * b`.
#[logic]
#[ensures(result == a * b)]
pub fn times(a: Real, b: Real) -> Real {
    a * b
}

/// Equal numbers are equal as factors.
#[logic]
#[requires(a == b)]
#[ensures(result && times(c, a) == c * b && times(a, c) == c * b)]
pub fn same_factor(c: Real, a: Real, b: Real) -> bool {
    true
}

/// One error more adds its square to the energy.
#[logic]
#[requires(n >= 0 && e == error(min, max, x, n))]
#[ensures(result && energy(min, max, x, n + 1) == energy(min, max, x, n) + times(e, e))]
pub fn one_error_more(min: Real, max: Real, x: Seq<Real>, n: Int, e: Real) -> bool {
    true
}

/// The recurrence of the leading minors, with what stands on the diagonal and beside it.
#[logic]
#[requires(k >= 0 && minors_are(num, den, k, minor, before))]
#[requires(d.model() == times(int(2), den.model()) - times(int(2), num.model()))]
#[requires(o.model() == times(num.model(), num.model()))]
#[ensures(result && after_minors(num, den, k, times(d.model(), minor.model()) - times(o.model(), before.model())))]
pub fn one_minor_more<S: Scalar>(num: S, den: S, k: Int, d: S, o: S, minor: S, before: S) -> bool {
    same_factor(minor.model(), d.model(), int(2) * den.model() - int(2) * num.model())
        && same_factor(before.model(), o.model(), num.model() * num.model())
}

/// That the leading minor of order `k + 1` is `m`.
#[logic(open)]
pub fn after_minors<S: Scalar>(num: S, den: S, k: Int, m: Real) -> bool {
    minor_of(num.model(), den.model(), k + 1) == m
}

/// The weights of the contraction fit where the square of the number of drones does.
#[logic]
#[requires(0 <= i && i < count && count * count <= limit)]
#[ensures(result && i * (count - 1 - i) <= limit)]
pub fn weight_fits(count: Int, i: Int, limit: Int) -> bool {
    pearlite! {
        proof_assert!(i * (count - 1 - i) <= i * count && i * count <= count * count);
        true
    }
}
