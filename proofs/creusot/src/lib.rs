//! The theorems of the paper's section 7 about the protocol over the reals, for every number of
//! drones and every number of steps; and, at the end, about the code of [`cordon_spec`]. They are
//! read by Creusot: an ordinary build has none of them.

#![no_std]
#![forbid(unsafe_code)]
#![cfg(feature = "contracts")]
// Erased contracts leave their names unused.
#![allow(unused_imports)]

use cordon_spec::graph::Graph;
use cordon_spec::model::*;
use cordon_spec::{DroneMap, Params, Scalar, State};
#[cfg(creusot)]
use cordon_spec::{
    activation::exec_coverage_active, consensus::exec_consensus, coverage::kth_step,
    delay::exec_coverage_delayed,
};

/// The product of two numbers that are not negative.
#[logic]
#[requires(a >= int(0) && b >= int(0))]
#[ensures(a * b >= int(0))]
pub fn product(a: Real, b: Real) {}

/// Drones `i` and `i + 1` do not cross in one step: up to 1/2, and up to 1 if they are three.
#[logic]
#[requires(anchored(p, x) && in_order(x) && 0 <= i && i + 1 < x.len())]
#[requires(up_to_half(p) || x.len() == 3 && int(0) <= p.eps && p.eps <= int(1))]
#[ensures(next_of(p, x, i) < next_of(p, x, i + 1))]
pub fn pair_keeps_order(p: Params<Real>, x: Seq<Real>, i: Int) {}

/// Theorem 7.2, the induction step.
#[logic]
#[requires(anchored(p, x) && in_order(x))]
#[requires(up_to_half(p) || x.len() == 3 && int(0) <= p.eps && p.eps <= int(1))]
#[ensures(anchored(p, step(p, x)) && in_order(step(p, x)))]
pub fn step_keeps_order(p: Params<Real>, x: Seq<Real>) {
    pearlite! {
        proof_assert!(forall<i> 0 <= i && i + 1 < x.len()
            ==> { pair_keeps_order(p, x, i); true } && next_of(p, x, i) < next_of(p, x, i + 1))
    }
}

/// Theorem 7.2: order is kept for ever.
#[logic]
#[variant(k)]
#[requires(k >= 0 && anchored(p, x) && in_order(x))]
#[requires(up_to_half(p) || x.len() == 3 && int(0) <= p.eps && p.eps <= int(1))]
#[ensures(anchored(p, steps(p, x, k)) && in_order(steps(p, x, k)) && steps(p, x, k).len() == x.len())]
pub fn order_is_kept(p: Params<Real>, x: Seq<Real>, k: Int) {
    if k > 0 {
        order_is_kept(p, x, k - 1);
        step_keeps_order(p, steps(p, x, k - 1))
    }
}

/// The identity of polynomials behind [`error_step`].
#[logic]
#[ensures(t - last * (eps * a + (int(1) - int(2) * eps) * b + eps * c)
    == eps * (t - l - last * a) + (int(1) - int(2) * eps) * (t - last * b) + eps * (t + l - last * c))]
pub fn mixed(eps: Real, last: Real, t: Real, l: Real, a: Real, b: Real, c: Real) {}

/// The errors obey the protocol's own recurrence.
#[logic]
#[requires(anchored(p, x) && 0 < i && i + 1 < x.len())]
#[ensures(error(p.min, p.max, step(p, x), i) == p.eps * error(p.min, p.max, x, i - 1)
    + (int(1) - int(2) * p.eps) * error(p.min, p.max, x, i)
    + p.eps * error(p.min, p.max, x, i + 1))]
pub fn error_step(p: Params<Real>, x: Seq<Real>, i: Int) {
    pearlite! {
        let (last, j, l) = (int(x.len() - 1), int(i), p.max - p.min);
        proof_assert!(int(i - 1) == j - int(1) && int(i + 1) == j + int(1));
        proof_assert!(error(p.min, p.max, x, i - 1) == last * p.min + j * l - l - last * x[i - 1]);
        proof_assert!(error(p.min, p.max, x, i + 1) == last * p.min + j * l + l - last * x[i + 1]);
        proof_assert!(step(p, x)[i] == p.eps * x[i - 1] + (int(1) - int(2) * p.eps) * x[i] + p.eps * x[i + 1]);
        proof_assert!(error(p.min, p.max, step(p, x), i) == last * p.min + j * l - last * step(p, x)[i]);
        mixed(p.eps, last, last * p.min + j * l, l, x[i - 1], x[i], x[i + 1])
    }
}

/// The end drones have no error.
#[logic]
#[requires(anchored(p, x))]
#[ensures(error(p.min, p.max, x, 0) == int(0) && error(p.min, p.max, x, x.len() - 1) == int(0))]
pub fn end_errors(p: Params<Real>, x: Seq<Real>) {}

/// Theorem 7.3 for drone `i`, the induction step, and its mirror image.
#[logic]
#[requires(anchored(p, x) && up_to_half(p) && 0 <= i && i < x.len())]
#[ensures(behind(p, x) ==> error(p.min, p.max, step(p, x), i) >= int(0))]
#[ensures(ahead(p, x) ==> error(p.min, p.max, step(p, x), i) <= int(0))]
pub fn drone_keeps_side(p: Params<Real>, x: Seq<Real>, i: Int) {
    if 0 < i && i + 1 < x.len() {
        let (a, b, c) = (
            error(p.min, p.max, x, i - 1),
            error(p.min, p.max, x, i),
            error(p.min, p.max, x, i + 1),
        );
        error_step(p, x, i);
        let kept = int(1) - int(2) * p.eps;
        if a >= int(0) && b >= int(0) && c >= int(0) {
            product(p.eps, a);
            product(kept, b);
            product(p.eps, c)
        }
        if a <= int(0) && b <= int(0) && c <= int(0) {
            product(p.eps, -a);
            product(kept, -b);
            product(p.eps, -c)
        }
    } else {
        end_errors(p, step(p, x))
    }
}

/// Drone `i` stays in the box.
#[logic]
#[requires(anchored(p, x) && up_to_half(p) && boxed(p, x) && 0 <= i && i < x.len())]
#[ensures(p.min <= next_of(p, x, i) && next_of(p, x, i) <= p.max)]
pub fn drone_stays_boxed(p: Params<Real>, x: Seq<Real>, i: Int) {
    if 0 < i && i + 1 < x.len() {
        let kept = int(1) - int(2) * p.eps;
        product(p.eps, x[i - 1] - p.min);
        product(kept, x[i] - p.min);
        product(p.eps, x[i + 1] - p.min);
        product(p.eps, p.max - x[i - 1]);
        product(kept, p.max - x[i]);
        product(p.eps, p.max - x[i + 1])
    }
}

/// Theorem 7.3, its mirror image and the box, the induction step.
#[logic]
#[requires(anchored(p, x) && up_to_half(p))]
#[ensures(anchored(p, step(p, x)))]
#[ensures(behind(p, x) ==> behind(p, step(p, x)))]
#[ensures(ahead(p, x) ==> ahead(p, step(p, x)))]
#[ensures(boxed(p, x) ==> boxed(p, step(p, x)))]
pub fn step_keeps_bounds(p: Params<Real>, x: Seq<Real>) {
    pearlite! {
        proof_assert!(forall<i> 0 <= i && i < x.len() ==> { drone_keeps_side(p, x, i); true }
            && (behind(p, x) ==> error(p.min, p.max, step(p, x), i) >= int(0))
            && (ahead(p, x) ==> error(p.min, p.max, step(p, x), i) <= int(0)));
        proof_assert!(boxed(p, x) ==> forall<i> 0 <= i && i < x.len()
            ==> { drone_stays_boxed(p, x, i); true } && p.min <= next_of(p, x, i) && next_of(p, x, i) <= p.max)
    }
}

/// Theorem 7.3, its mirror image and the box: for ever.
#[logic]
#[variant(k)]
#[requires(k >= 0 && anchored(p, x) && up_to_half(p))]
#[ensures(anchored(p, steps(p, x, k)) && steps(p, x, k).len() == x.len())]
#[ensures(behind(p, x) ==> behind(p, steps(p, x, k)))]
#[ensures(ahead(p, x) ==> ahead(p, steps(p, x, k)))]
#[ensures(boxed(p, x) ==> boxed(p, steps(p, x, k)))]
pub fn bounds_are_kept(p: Params<Real>, x: Seq<Real>, k: Int) {
    if k > 0 {
        bounds_are_kept(p, x, k - 1);
        step_keeps_bounds(p, steps(p, x, k - 1))
    }
}

/// The telescoping identity behind 7.5, for the first `n` drones.
#[logic]
#[variant(n)]
#[requires(anchored(p, x) && 1 <= n && n < x.len())]
#[ensures(total(step(p, x), n) - total(x, n) == p.eps * ((x[n] - x[n - 1]) - (x[1] - x[0])))]
pub fn telescoping(p: Params<Real>, x: Seq<Real>, n: Int) {
    pearlite! {
        proof_assert!(total(step(p, x), n) == total(step(p, x), n - 1) + step(p, x)[n - 1]);
        proof_assert!(total(x, n) == total(x, n - 1) + x[n - 1]);
        if n > 1 {
            telescoping(p, x, n - 1);
            proof_assert!(step(p, x)[n - 1] - x[n - 1] == p.eps * ((x[n] - x[n - 1]) - (x[n - 1] - x[n - 2])))
        }
    }
}

/// The telescoping identity behind 7.5: `c^{k+1} - c^k = eps*(g_{N-2} - g_0)`.
#[logic]
#[requires(anchored(p, x))]
#[ensures(total(step(p, x), x.len()) - total(x, x.len())
    == p.eps * ((x[x.len() - 1] - x[x.len() - 2]) - (x[1] - x[0])))]
pub fn sum_step(p: Params<Real>, x: Seq<Real>) {
    telescoping(p, x, x.len() - 1)
}

/// Theorem 7.5 (i): the sum never decreases.
#[logic]
#[requires(anchored(p, x) && up_to_half(p) && behind(p, x))]
#[ensures(total(step(p, x), x.len()) >= total(x, x.len()))]
pub fn sum_never_decreases(p: Params<Real>, x: Seq<Real>) {
    sum_step(p, x);
    let last = x.len() - 1;
    last_gap_is_wider(p, x);
    product(p.eps, (x[last] - x[last - 1]) - (x[1] - x[0]))
}

/// Of drones behind their targets the last gap is no narrower than the first.
#[logic]
#[requires(anchored(p, x) && behind(p, x))]
#[ensures(x[x.len() - 1] - x[x.len() - 2] >= x[1] - x[0])]
pub fn last_gap_is_wider(p: Params<Real>, x: Seq<Real>) {
    pearlite! {
        let last = int(x.len() - 1);
        proof_assert!(error(p.min, p.max, x, x.len() - 2) == last * (x[x.len() - 1] - x[x.len() - 2]) - (p.max - p.min));
        proof_assert!(error(p.min, p.max, x, 1) == (p.max - p.min) - last * (x[1] - x[0]));
        scaled_order(last, x[1] - x[0], x[x.len() - 1] - x[x.len() - 2])
    }
}

/// A positive factor keeps order.
#[logic]
#[requires(c > int(0) && c * a <= c * b)]
#[ensures(a <= b)]
pub fn scaled_order(c: Real, a: Real, b: Real) {}

/// A drone in the middle of its neighbours stays.
#[logic]
#[requires(last > int(0) && last * a + last * c == int(2) * (last * b) && 0 < i && i + 1 < count)]
#[ensures(next(p, count, a, b, c, i) == b)]
pub fn middle(p: Params<Real>, count: Int, last: Real, a: Real, b: Real, c: Real, i: Int) {
    pearlite! {
        proof_assert!(last * (a + c) == last * (int(2) * b));
        scaled_order(last, a + c, int(2) * b);
        scaled_order(last, int(2) * b, a + c);
        proof_assert!(c == int(2) * b - a)
    }
}

/// Drones at their targets are in the middle of their neighbours.
#[logic]
#[requires(anchored(p, x) && behind(p, x) && ahead(p, x) && 0 < i && i + 1 < x.len())]
#[ensures(int(x.len() - 1) * x[i - 1] + int(x.len() - 1) * x[i + 1] == int(2) * (int(x.len() - 1) * x[i]))]
pub fn targets_line_up(p: Params<Real>, x: Seq<Real>, i: Int) {
    pearlite! {
        let last = int(x.len() - 1);
        proof_assert!(int(i - 1) == int(i) - int(1) && int(i + 1) == int(i) + int(1));
        proof_assert!(error(p.min, p.max, x, i - 1) == int(0) && error(p.min, p.max, x, i) == int(0)
            && error(p.min, p.max, x, i + 1) == int(0));
        proof_assert!(last * x[i] == target(p.min, p.max, last, int(i)));
        proof_assert!(last * x[i - 1] == target(p.min, p.max, last, int(i)) - (p.max - p.min));
        proof_assert!(last * x[i + 1] == target(p.min, p.max, last, int(i)) + (p.max - p.min))
    }
}

/// Theorem 7.6 (i) for drone `i`, with any weight.
#[logic]
#[requires(anchored(p, x) && behind(p, x) && ahead(p, x) && 0 <= i && i < x.len())]
#[ensures(next_of(p, x, i) == x[i])]
pub fn target_is_fixed(p: Params<Real>, x: Seq<Real>, i: Int) {
    if 0 < i && i + 1 < x.len() {
        targets_line_up(p, x, i);
        middle(p, x.len(), int(x.len() - 1), x[i - 1], x[i], x[i + 1], i)
    }
}

/// Theorem 7.6 (i): drones at their targets stay there, with any weight.
#[logic]
#[requires(anchored(p, x) && behind(p, x) && ahead(p, x))]
#[ensures(step(p, x) == x)]
pub fn targets_are_fixed(p: Params<Real>, x: Seq<Real>) {
    pearlite! {
        proof_assert!(forall<i> 0 <= i && i < x.len()
            ==> { target_is_fixed(p, x, i); true } && next_of(p, x, i) == x[i]);
        proof_assert!(step(p, x).ext_eq(x))
    }
}

/// That `y[i]` is on the same side of its target, and in the box, as all of `x` are.
#[logic(open)]
pub fn same_side(p: Params<Real>, x: Seq<Real>, y: Seq<Real>, i: Int) -> bool {
    pearlite! {
        (behind(p, x) ==> error(p.min, p.max, y, i) >= int(0))
            && (ahead(p, x) ==> error(p.min, p.max, y, i) <= int(0))
            && (boxed(p, x) ==> p.min <= y[i] && y[i] <= p.max)
    }
}

/// The error of a drone is one of its own place.
#[logic]
#[requires(x.len() == y.len())]
#[ensures(x[i] == y[i] ==> error(p.min, p.max, x, i) == error(p.min, p.max, y, i))]
pub fn same_error(p: Params<Real>, x: Seq<Real>, y: Seq<Real>, i: Int) {}

/// One drone that moves by what it sees, `x`, keeps the bounds that what it sees has.
#[logic]
#[requires(anchored(p, x) && up_to_half(p) && 0 <= i && i < x.len() && y.len() == x.len())]
#[requires(y[i] == next_of(p, x, i) || y[i] == x[i])]
#[ensures(same_side(p, x, y, i))]
pub fn one_drone_keeps(p: Params<Real>, x: Seq<Real>, y: Seq<Real>, i: Int) {
    pearlite! {
        drone_keeps_side(p, x, i);
        proof_assert!(step(p, x).len() == x.len() && step(p, x)[i] == next_of(p, x, i));
        same_error(p, x, y, i);
        same_error(p, step(p, x), y, i);
        proof_assert!(boxed(p, x) ==> { drone_stays_boxed(p, x, i); true }
            && p.min <= next_of(p, x, i) && next_of(p, x, i) <= p.max)
    }
}

/// The sum of the pulls on the first `m` drones by the first `n`.
#[logic(open)]
#[variant(m)]
#[requires(m >= 0 && n >= 0)]
pub fn pulls<G: Graph>(g: G, x: Seq<Real>, m: Int, n: Int) -> Real {
    if m == 0 { int(0) } else { pulls(g, x, m - 1, n) + pull_of(g, x, m - 1, n) }
}

/// What drone `n` adds to the pulls on the first `m` drones is what they add to its own, negated.
#[logic]
#[variant(m)]
#[requires(m >= 0 && n >= 0)]
#[ensures(pulls(g, x, m, n + 1) == pulls(g, x, m, n) - pull_of(g, x, n, m))]
pub fn one_drone_more<G: Graph>(g: G, x: Seq<Real>, m: Int, n: Int) {
    if m > 0 {
        one_drone_more(g, x, m - 1, n);
        g.undirected(m - 1, n)
    }
}

/// The pulls of any number of drones on each other add up to nothing.
#[logic]
#[variant(n)]
#[requires(n >= 0)]
#[ensures(pulls(g, x, n, n) == int(0))]
pub fn pulls_cancel<G: Graph>(g: G, x: Seq<Real>, n: Int) {
    if n > 0 {
        pulls_cancel(g, x, n - 1);
        one_drone_more(g, x, n - 1, n - 1);
        g.undirected(n - 1, n - 1)
    }
}

/// A factor is distributed.
#[logic]
#[requires(s == a + b)]
#[ensures(c * s == c * a + c * b)]
pub fn scaled_sum(c: Real, s: Real, a: Real, b: Real) {}

/// The sum of the first `m` drones after a consensus step.
#[logic]
#[variant(m)]
#[requires(0 <= m && m <= x.len())]
#[ensures(total(consensus_step(eps, g, x), m) == total(x, m) + eps * pulls(g, x, m, x.len()))]
pub fn partial_sum<G: Graph>(eps: Real, g: G, x: Seq<Real>, m: Int) {
    pearlite! {
        if m > 0 {
            partial_sum(eps, g, x, m - 1);
            let (before, last) = (pulls(g, x, m - 1, x.len()), pull_of(g, x, m - 1, x.len()));
            proof_assert!(consensus_step(eps, g, x)[m - 1] == x[m - 1] + eps * last);
            proof_assert!(total(consensus_step(eps, g, x), m) == total(consensus_step(eps, g, x), m - 1) + consensus_step(eps, g, x)[m - 1]);
            proof_assert!(total(x, m) == total(x, m - 1) + x[m - 1]);
            proof_assert!(pulls(g, x, m, x.len()) == before + last);
            scaled_sum(eps, pulls(g, x, m, x.len()), before, last)
        }
    }
}

/// Consensus keeps the sum, with any weight on any graph (PROTOCOL section 2).
#[logic]
#[ensures(total(consensus_step(eps, g, x), x.len()) == total(x, x.len()))]
pub fn consensus_keeps_sum<G: Graph>(eps: Real, g: G, x: Seq<Real>) {
    partial_sum(eps, g, x, x.len());
    pulls_cancel(g, x, x.len())
}

/// [`consensus_keeps_sum`] of the code.
#[cfg(creusot)]
#[requires(exact::<S>() && graph.size() == x.seq().len())]
#[ensures(total(reals(result.seq()), result.seq().len()) == total(reals(x.seq()), x.seq().len()))]
pub fn exec_consensus_keeps_sum<S: Scalar, G: Graph, M: DroneMap<S>>(
    eps: &S,
    graph: &G,
    x: &M,
) -> M {
    proof_assert!({
        consensus_keeps_sum(eps.model(), *graph, reals(x.seq()));
        true
    });
    exec_consensus(eps, graph, x)
}

/// Theorem 7.3, its mirror image and the box where any drones skip the step.
#[cfg(creusot)]
#[requires(exact::<S>() && anchored(p.model(), positions(*s)) && up_to_half(p.model()))]
#[requires(forall<i: usize> i@ < s.drones.seq().len() ==> active.precondition((i,)))]
#[ensures(behind(p.model(), positions(*s)) ==> behind(p.model(), positions(result)))]
#[ensures(ahead(p.model(), positions(*s)) ==> ahead(p.model(), positions(result)))]
#[ensures(boxed(p.model(), positions(*s)) ==> boxed(p.model(), positions(result)))]
pub fn active_keeps<S: Scalar, M: DroneMap<S>>(
    p: &Params<S>,
    s: &State<M>,
    active: impl Fn(usize) -> bool,
) -> State<M> {
    let result = exec_coverage_active(p, s, active);
    proof_assert!(forall<i> 0 <= i && i < s.drones.seq().len()
        ==> { one_drone_keeps(p.model(), positions(*s), positions(result), i); true }
        && same_side(p.model(), positions(*s), positions(result), i));
    result
}

/// Theorem 7.3, its mirror image and the box where drone `i` sees the placement `views[i]`: what
/// all that is seen keeps, the drones keep.
#[cfg(creusot)]
#[requires(exact::<S>() && up_to_half(p.model()) && views.len() == s.drones.seq().len())]
#[requires(forall<i> 0 <= i && i < views.len() ==> anchored(p.model(), views[i]) && sees(seen, positions(*s), i, views[i]))]
#[requires(forall<i: usize, j: usize> i@ < s.drones.seq().len() && j@ < s.drones.seq().len() ==> seen.precondition((i, j)))]
#[ensures((forall<i> 0 <= i && i < views.len() ==> behind(p.model(), views[i])) ==> behind(p.model(), positions(result)))]
#[ensures((forall<i> 0 <= i && i < views.len() ==> ahead(p.model(), views[i])) ==> ahead(p.model(), positions(result)))]
#[ensures((forall<i> 0 <= i && i < views.len() ==> boxed(p.model(), views[i])) ==> boxed(p.model(), positions(result)))]
pub fn delayed_keeps<'s, S: Scalar + 's, M: DroneMap<S>>(
    p: &'s Params<S>,
    s: &'s State<M>,
    seen: impl Fn(usize, usize) -> &'s S,
    views: Snapshot<Seq<Seq<Real>>>,
) -> State<M> {
    let result = exec_coverage_delayed(p, s, seen);
    proof_assert!(forall<i> 0 <= i && i < views.len()
        ==> { one_drone_keeps(p.model(), views[i], positions(result), i); true }
        && same_side(p.model(), views[i], positions(result), i));
    result
}

/// Theorems 7.2, 7.3 and the box about [`kth_step`](cordon_spec::coverage::kth_step), for every k, every period and both phases.
#[cfg(creusot)]
#[requires(exact::<S>() && initial.timesteps <= p.n && anchored(p.model(), positions(initial)))]
#[requires(up_to_half(p.model()))]
#[ensures(in_order(positions(initial)) ==> in_order(positions(result)))]
#[ensures(behind(p.model(), positions(initial)) ==> behind(p.model(), positions(result)))]
#[ensures(ahead(p.model(), positions(initial)) ==> ahead(p.model(), positions(result)))]
#[ensures(boxed(p.model(), positions(initial)) ==> boxed(p.model(), positions(result)))]
pub fn kth_step_keeps<S: Scalar, M: DroneMap<S>>(
    p: &Params<S>,
    initial: State<M>,
    k: u64,
) -> State<M> {
    let start = snapshot!(positions(initial));
    let passed = snapshot!(initial.timesteps@ + k@);
    proof_assert!({ counter_more(*passed, p.n@ + 1); passed.div_euclid(p.n@ + 1) >= 0 });
    proof_assert!({ bounds_are_kept(p.model(), *start, passed.div_euclid(p.n@ + 1)); true });
    proof_assert!(in_order(*start) ==> { order_is_kept(p.model(), *start, passed.div_euclid(p.n@ + 1)); true }
        && in_order(steps(p.model(), *start, passed.div_euclid(p.n@ + 1))));
    let result = kth_step(p, initial, k);
    proof_assert!(positions(result) == steps(p.model(), *start, passed.div_euclid(p.n@ + 1)));
    result
}
