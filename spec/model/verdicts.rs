//! What the answers of the theorem predicates say about the real numbers.

use super::*;
use crate::theorems::{Form, Setting, StartSet, Theorem, Truth, Verdict, WeightRange};

impl<S: Scalar> Setting<S> {
    /// The segment and the weight.
    #[logic(open)]
    pub fn model(self) -> Params<Real> {
        let eps = self.eps_num.model() / self.eps_den.model();
        Params { min: self.min.model(), max: self.max.model(), eps, n: 0u32 }
    }
}

/// What an answer says of a fact: a yes that it is one, a no that it is not.
#[logic(open)]
pub fn says(t: Truth, fact: bool) -> bool {
    match t {
        Truth::True => fact,
        Truth::False => !fact,
        Truth::Unknown => true,
    }
}

/// The same of a verdict: `Holds` that it is one, `Violated` that it is not.
#[logic(open)]
pub fn decides(v: Verdict, fact: bool) -> bool {
    match v {
        Verdict::Holds => fact,
        Verdict::Violated(_) => !fact,
        _ => true,
    }
}

/// The conjunction of two answers.
#[logic(open)]
pub fn both(a: Truth, b: Truth) -> Truth {
    match a {
        Truth::False => Truth::False,
        Truth::True => b,
        Truth::Unknown => match b {
            Truth::False => Truth::False,
            _ => Truth::Unknown,
        },
    }
}

/// That `t` is the conjunction of the answers about `0 .. count`; of `Unknown` nothing is said.
#[logic(open, prophetic)]
pub fn conjunction<F: Fn(usize) -> Truth>(holds: F, count: Int, t: Truth) -> bool {
    pearlite! {
        match t {
            Truth::True => forall<i: usize> i@ < count ==> holds.postcondition((i,), Truth::True),
            Truth::False => exists<i: usize> i@ < count && holds.postcondition((i,), Truth::False),
            Truth::Unknown => true,
        }
    }
}

/// That `t` is their disjunction.
#[logic(open, prophetic)]
pub fn disjunction<F: Fn(usize) -> Truth>(holds: F, count: Int, t: Truth) -> bool {
    pearlite! {
        match t {
            Truth::True => exists<i: usize> i@ < count && holds.postcondition((i,), Truth::True),
            Truth::False => forall<i: usize> i@ < count ==> holds.postcondition((i,), Truth::False),
            Truth::Unknown => true,
        }
    }
}

/// That `v` is the verdict on them.
#[logic(open, prophetic)]
pub fn verdict_of<F: Fn(usize) -> Truth>(holds: F, count: Int, v: Verdict) -> bool {
    match v {
        Verdict::Holds => conjunction(holds, count, Truth::True),
        Verdict::Violated(_) => conjunction(holds, count, Truth::False),
        Verdict::Vacuous => false,
        Verdict::Undecided => true,
    }
}

/// The leading minor of order `k` of den*(I + A), A = tridiag(eps, 1 - 2 eps, eps), eps = num/den.
#[logic(open)]
#[variant(k + 1)]
#[requires(k >= -1)]
pub fn minor_of(num: Real, den: Real, k: Int) -> Real {
    if k < 0 {
        int(0)
    } else if k == 0 {
        int(1)
    } else {
        (int(2) * den - int(2) * num) * minor_of(num, den, k - 1)
            - num * num * minor_of(num, den, k - 2)
    }
}

/// That the leading minors of orders `k` and `k - 1` are `minor` and `before`.
#[logic(open)]
pub fn minors_are<S: Scalar>(num: S, den: S, k: Int, minor: S, before: S) -> bool {
    minor.model() == minor_of(num.model(), den.model(), k)
        && before.model() == minor_of(num.model(), den.model(), k - 1)
}

/// That the leading minors up to order `k` are positive.
#[logic(open)]
pub fn minors_positive(num: Real, den: Real, k: Int) -> bool {
    pearlite! { forall<j> 1 <= j && j <= k ==> minor_of(num, den, j) > int(0) }
}

/// That the weight `num/den` is in the range, for `count` drones and `den > 0`.
#[logic(open)]
pub fn weighs(range: WeightRange, num: Real, den: Real, count: Int) -> bool {
    match range {
        WeightRange::Any => true,
        WeightRange::Unit => int(0) <= num && num <= den,
        WeightRange::BelowThird => int(0) <= num && int(3) * num < den,
        WeightRange::BelowHalf => int(0) <= num && int(2) * num < den,
        WeightRange::UpToHalf => int(0) <= num && int(2) * num <= den,
        WeightRange::UpToHalfOrOne => {
            int(0) <= num && if count == 3 { num <= den } else { int(2) * num <= den }
        }
        WeightRange::PositiveUpToHalf => int(0) < num && int(2) * num <= den,
        WeightRange::BelowCritical => int(0) < num && minors_positive(num, den, count - 2),
    }
}

/// That the start `x` is in the set.
#[logic(open)]
pub fn starts(set: StartSet, p: Params<Real>, x: Seq<Real>) -> bool {
    anchored(p, x)
        && match set {
            StartSet::Any => true,
            StartSet::Ordered => in_order(x),
            StartSet::FirstSubsegment => in_order(x) && before_first_target(p, x),
            StartSet::UpperBounded => behind(p, x),
        }
}

/// X_i < min + l for every internal i (assumption 3).
#[logic(open)]
pub fn before_first_target(p: Params<Real>, x: Seq<Real>) -> bool {
    pearlite! {
        let last = int(last_of(x.len()));
        forall<i: usize> i@ + 2 < x.len() ==> times(last, x[i@ + 1]) < times(last, p.min) + (p.max - p.min)
    }
}

/// X_i = T_i for every i.
#[logic(open)]
pub fn reach_targets(p: Params<Real>, x: Seq<Real>) -> bool {
    behind(p, x) && ahead(p, x)
}

/// Twice the bound of the sum (corollary 7.4). (That 2 doubles is a hint: the code's sum is doubled.)
#[logic(open)]
#[ensures(forall<c: Real> #[trigger(times(int(2), c))] times(int(2), c) == int(2) * c)]
pub fn bound(p: Params<Real>, x: Seq<Real>) -> Real {
    times(int(x.len()), p.min + p.max)
}

/// How many placements beyond X^k the conclusion about step k reads.
#[logic(open)]
pub fn steps_read(theorem: Theorem, form: Form, count: Int) -> Int {
    let internal = if count > 2 { count - 2 } else { 1 };
    match theorem {
        Theorem::Ordering | Theorem::UpperBound | Theorem::SumBounded | Theorem::SumMaximal => 0,
        Theorem::SumNonDecreasing | Theorem::SumStationary | Theorem::Limit => 1,
        Theorem::TargetsFixed | Theorem::ConstantSum => match form {
            Form::Paper => internal,
            Form::Sharp => (internal + 1) / 2,
        },
        Theorem::GloballyIncreasing => match form {
            Form::Paper => internal + 1,
            Form::Sharp => last_of(count) / 2,
        },
    }
}

/// What the conclusion of a theorem says of the run X^k, X^{k+1}, ...
#[logic(open)]
pub fn concludes<S: Scalar, M: DroneMap<S>>(
    theorem: Theorem,
    form: Form,
    setting: Setting<S>,
    run: Seq<M>,
) -> bool {
    let (p, now) = (setting.model(), run[0].seq());
    let x = reals(now);
    let later = run.subsequence(1, 1 + steps_read(theorem, form, now.len()));
    match theorem {
        Theorem::Ordering => in_order(x),
        Theorem::UpperBound => behind(p, x),
        Theorem::SumBounded => int(2) * sum_of(now) <= bound(p, x),
        Theorem::SumMaximal => (int(2) * sum_of(now) == bound(p, x)) == reach_targets(p, x),
        Theorem::SumNonDecreasing => sum_of(now) <= sum_of(later[0].seq()),
        Theorem::SumStationary => {
            pearlite! { reach_targets(p, x) ==> sum_of(later[0].seq()) == sum_of(now) }
        }
        Theorem::TargetsFixed => {
            pearlite! { reach_targets(p, x) ==> remains(form, p, now, later) }
        }
        Theorem::ConstantSum => {
            pearlite! { constant(now, later, later.len()) ==> reach_targets(p, x) }
        }
        Theorem::GloballyIncreasing => match form {
            Form::Paper => increases_as_printed(p, now, later),
            Form::Sharp => increases(p, now, later),
        },
        Theorem::Limit => approaches(form, setting, now, later[0].seq()),
    }
}

/// The sum of the positions: the paper's c.
#[logic(open, inline)]
pub fn sum_of<S: Scalar>(x: Seq<S>) -> Real {
    total(reals(x), x.len())
}

/// How much wider the last gap is than the first.
#[logic(open)]
pub fn ends_apart<S: Scalar>(x: Seq<S>) -> Real {
    let n = x.len();
    (x[n - 1].model() - x[n - 2].model()) - (x[1].model() - x[0].model())
}

/// That the first `count` of the later placements have the sum of `now`.
#[logic(open)]
pub fn constant<S: Scalar, M: DroneMap<S>>(now: Seq<S>, later: Seq<M>, count: Int) -> bool {
    pearlite! { forall<h: usize> h@ < count ==> sum_of(later[h@].seq()) == sum_of(now) }
}

/// 7.6 (i): the sum stays (paper), or every drone stays at its target (sharp).
#[logic(open)]
pub fn remains<S: Scalar, M: DroneMap<S>>(
    form: Form,
    p: Params<Real>,
    now: Seq<S>,
    later: Seq<M>,
) -> bool {
    pearlite! {
        match form {
            Form::Paper => constant(now, later, later.len()),
            Form::Sharp => forall<h: usize> h@ < later.len() ==> reach_targets(p, reals(later[h@].seq())),
        }
    }
}

/// That the first `n` drones are at their targets.
#[logic(open)]
pub fn on_targets(p: Params<Real>, x: Seq<Real>, n: Int) -> bool {
    pearlite! { forall<j> 0 <= j && j < n ==> error(p.min, p.max, x, j) == int(0) }
}

/// That the first drone off its target is behind it, and is drone 3 or a later one.
#[logic(open)]
pub fn late(p: Params<Real>, x: Seq<Real>) -> bool {
    pearlite! {
        exists<j> 3 <= j && j < x.len() && on_targets(p, x, j) && error(p.min, p.max, x, j) > int(0)
    }
}

/// 7.7 as printed: if the sum stays in the next step, it increases in one after that.
#[logic(open)]
pub fn increases_as_printed<S: Scalar, M: DroneMap<S>>(
    p: Params<Real>,
    now: Seq<S>,
    later: Seq<M>,
) -> bool {
    pearlite! {
        constant(now, later, 1) && late(p, reals(now)) ==> exists<h: usize> h@ + 1 < later.len()
            && sum_of(later[h@].seq()) < sum_of(later[h@ + 1].seq())
    }
}

/// How far drone `i` is from the nearer end of the line.
#[logic(open)]
pub fn depth(count: Int, i: Int) -> Int {
    if i < count - 1 - i { i } else { count - 1 - i }
}

/// That `d` is the least depth of those of the first `n` drones that are off their targets.
#[logic(open)]
pub fn nearest(p: Params<Real>, x: Seq<Real>, n: Int, d: Int) -> bool {
    pearlite! {
        (exists<j> 0 <= j && j < n && error(p.min, p.max, x, j) != int(0) && depth(x.len(), j) == d)
            && forall<j> 0 <= j && j < n && error(p.min, p.max, x, j) != int(0) ==> d <= depth(x.len(), j)
    }
}

/// 7.7: the sum stays, and increases in the step that is the least depth of a drone off its target.
#[logic(open)]
pub fn increases<S: Scalar, M: DroneMap<S>>(p: Params<Real>, now: Seq<S>, later: Seq<M>) -> bool {
    pearlite! { forall<d> nearest(p, reals(now), now.len(), d) ==> increases_at(now, later, d) }
}

/// That the sum stays before step `d` and increases in it.
#[logic(open)]
pub fn increases_at<S: Scalar, M: DroneMap<S>>(now: Seq<S>, later: Seq<M>, d: Int) -> bool {
    pearlite! {
        forall<h: usize> h@ < later.len() ==> (h@ + 1 < d ==> sum_of(later[h@].seq()) == sum_of(now))
            && (h@ + 1 == d ==> sum_of(now) < sum_of(later[h@].seq()))
    }
}

/// The sum of the squared errors of the first `n` drones, times (N-1)^2.
#[logic(open)]
#[variant(n)]
#[requires(n >= 0)]
pub fn energy(min: Real, max: Real, x: Seq<Real>, n: Int) -> Real {
    if n == 0 {
        int(0)
    } else {
        energy(min, max, x, n - 1) + error(min, max, x, n - 1) * error(min, max, x, n - 1)
    }
}

/// 7.8, from `x` to `y` in one step: the energy falls (paper), and at the rate (sharp).
#[logic(open)]
pub fn approaches<S: Scalar>(form: Form, setting: Setting<S>, x: Seq<S>, y: Seq<S>) -> bool {
    pearlite! {
        let p = setting.model();
        !reach_targets(p, reals(x)) ==> energy(p.min, p.max, reals(y), y.len()) < energy(p.min, p.max, reals(x), x.len())
            && (form == Form::Sharp ==> shrinks(setting, x, y))
    }
}

/// For weights up to 1/2 each internal error is, against its weight i (N-1-i), within
/// 1 - 8 eps/(N-1)^2 of some internal error one step before.
#[logic(open)]
pub fn shrinks<S: Scalar>(setting: Setting<S>, x: Seq<S>, y: Seq<S>) -> bool {
    pearlite! {
        weighs(WeightRange::PositiveUpToHalf, setting.eps_num.model(), setting.eps_den.model(), x.len())
            ==> forall<i: usize> i@ + 2 < x.len() ==> shrinks_to_some(setting, x, y, i@ + 1)
    }
}

/// That the error of drone `i` after the step is within the rate of some internal drone's before.
#[logic(open)]
pub fn shrinks_to_some<S: Scalar>(setting: Setting<S>, x: Seq<S>, y: Seq<S>, i: Int) -> bool {
    pearlite! { exists<j: usize> j@ + 2 < x.len() && shrinks_to(setting, x, y, i, j@ + 1) }
}

/// The same of drone `j`.
#[logic(open)]
pub fn shrinks_to<S: Scalar>(setting: Setting<S>, x: Seq<S>, y: Seq<S>, i: Int, j: Int) -> bool {
    let (p, n) = (setting.model(), x.len());
    times(
        times(whole_of(setting, n), absolute(error(p.min, p.max, reals(y), i))),
        int(j * (n - 1 - j)),
    ) <= times(
        times(kept_of(setting, n), absolute(error(p.min, p.max, reals(x), j))),
        int(i * (n - 1 - i)),
    )
}

/// The rate's denominator, (N-1)^2 times that of the weight.
#[logic(open)]
pub fn whole_of<S: Scalar>(setting: Setting<S>, n: Int) -> Real {
    times(times(int(last_of(n)), int(last_of(n))), setting.eps_den.model())
}

/// The rate's numerator: 8 times that of the weight is lost.
#[logic(open)]
pub fn kept_of<S: Scalar>(setting: Setting<S>, n: Int) -> Real {
    whole_of(setting, n) - times(int(8), setting.eps_num.model())
}

/// What `whole` and `kept` are in the search for such a drone, for which the weights fit.
#[logic(open, prophetic)]
pub fn rated<S: Scalar>(setting: Setting<S>, whole: &S, kept: &S, x: Seq<S>, y: Seq<S>) -> bool {
    pearlite! {
        exact::<S>() && y.len() == x.len() && x.len() * x.len() <= usize::MAX@
            && whole.model() == whole_of(setting, x.len()) && kept.model() == kept_of(setting, x.len())
    }
}

/// The absolute value of a number.
#[logic(open)]
pub fn absolute(e: Real) -> Real {
    if e < int(0) { int(0) - e } else { e }
}
