//! What the answers of the theorem predicates say about the real numbers.

use super::*;
use crate::theorems::{Setting, StartSet, Truth, Verdict, Violation, WeightRange};

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

/// That `t` is the conjunction of the answers.
#[logic(open)]
pub fn conjunction(given: Seq<Truth>, t: Truth) -> bool {
    pearlite! {
        match t {
            Truth::True => forall<k> 0 <= k && k < given.len() ==> given[k] == Truth::True,
            Truth::False => exists<k> 0 <= k && k < given.len() && given[k] == Truth::False,
            Truth::Unknown => (forall<k> 0 <= k && k < given.len() ==> given[k] != Truth::False)
                && exists<k> 0 <= k && k < given.len() && given[k] == Truth::Unknown,
        }
    }
}

/// One answer more.
#[logic]
#[requires(conjunction(given, t))]
#[ensures(conjunction(given.concat(Seq::singleton(more)), both(t, more)))]
pub fn one_answer_more(given: Seq<Truth>, t: Truth, more: Truth) {
    pearlite! {
        let all = given.concat(Seq::singleton(more));
        proof_assert!(all.len() == given.len() + 1 && all[given.len()] == more);
        proof_assert!(forall<k> 0 <= k && k < given.len() ==> all[k] == given[k])
    }
}

/// That the iterator gives these elements and no more.
#[logic(open, prophetic)]
pub fn all_of<I: IteratorSpec>(it: I, given: Seq<I::Item>) -> bool {
    pearlite! { exists<done: &mut I> it.produces(given, *done) && done.completed() }
}

/// That no answer was a no, and what the verdict is where there is none.
#[logic(open)]
pub fn so_far(given: Seq<(Truth, Violation)>, v: Verdict) -> bool {
    pearlite! {
        (forall<k> 0 <= k && k < given.len() ==> given[k].0 != Truth::False)
            && (v == Verdict::Holds || v == Verdict::Undecided)
            && (v == Verdict::Holds) == (forall<k> 0 <= k && k < given.len() ==> given[k].0 == Truth::True)
    }
}

/// That `v` is the verdict on what the iterator gives: its first no, and no more read.
#[logic(open, prophetic)]
pub fn judged<I: IteratorSpec<Item = (Truth, Violation)>>(
    it: I,
    given: Seq<(Truth, Violation)>,
    v: Verdict,
) -> bool {
    pearlite! {
        match v {
            Verdict::Violated(at) => given.len() > 0 && given[given.len() - 1] == (Truth::False, at)
                && exists<rest: I> it.produces(given, rest),
            _ => all_of(it, given) && so_far(given, v),
        }
    }
}

/// The leading minor of order `k` of den*(I + A), A = tridiag(eps, 1 - 2 eps, eps).
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
    theorems::anchored(p, x)
        && match set {
            StartSet::Any => true,
            StartSet::Ordered => theorems::ordered(x),
            StartSet::FirstSubsegment => theorems::ordered(x) && before_first_target(p, x),
            StartSet::UpperBounded => theorems::behind(p, x),
        }
}

/// X_i < min + l for every internal i (assumption 3).
#[logic(open)]
pub fn before_first_target(p: Params<Real>, x: Seq<Real>) -> bool {
    pearlite! {
        let last = int(last_of(x.len()));
        forall<i> 0 < i && i + 1 < x.len() ==> last * x[i] < last * p.min + (p.max - p.min)
    }
}

/// X_i = T_i for every i.
#[logic(open)]
pub fn reach_targets(p: Params<Real>, x: Seq<Real>) -> bool {
    theorems::behind(p, x) && theorems::ahead(p, x)
}

/// Twice the bound of the sum (corollary 7.4).
#[logic(open)]
pub fn bound(p: Params<Real>, x: Seq<Real>) -> Real {
    int(x.len()) * (p.min + p.max)
}
