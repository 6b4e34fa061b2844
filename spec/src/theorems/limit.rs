//! Theorem 7.8: every drone converges to its target.
//!
//! A finite run shows a limit only through what is equivalent to it. The errors obey
//! e' = A e with A symmetric, so the positions converge from every start exactly when the
//! spectral radius of A is below 1, that is exactly when the sum of the squared errors falls in
//! every step from every start off the targets. That is the conclusion evaluated here. Up to
//! eps = 1/2 the sharp form adds the rate: with w_i = i(N-1-i),
//! |e_i^{k+1}| <= (1 - 8 eps/(N-1)^2) * max_j(|e_j^k|/w_j) * w_i.

use core::cmp::Ordering;

#[cfg(feature = "contracts")]
use crate::model::*;

use super::hypothesis::at_targets;
use super::verdict::{Subject, Truth, Verdict, Violation, at_most, less};
use super::{Form, Setting, WeightRange};
use crate::placement::{contraction_weight, gaps, scaled_energy, scaled_error};
use crate::{DroneMap, Ordered};

#[cfg_attr(feature = "contracts", requires(exact::<S>() && now@.len() * now@.len() <= usize::MAX@ && later@.len() > 0 && later@[0].seq().len() == now@.len()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, approaches(form, *setting, now@, later@[0].seq()))))]
pub(super) fn conclusion<S: Ordered, M: DroneMap<S>>(
    form: Form,
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    Verdict::given(at_targets(setting, now).negated(), || {
        let next = later[0].as_ref();
        let after = scaled_energy(&setting.min, &setting.max, next);
        let before = scaled_energy(&setting.min, &setting.max, now);
        match Verdict::one(less(&after, &before), 1, Subject::Energy) {
            Verdict::Holds if form == Form::Sharp => at_rate(setting, now, next),
            verdict => verdict,
        }
    })
}

/// The contraction in one step: for every internal i there is an internal j with
/// (N-1)^2 den |e_i'| w_j <= ((N-1)^2 den - 8 num) |e_j| w_i. Holds trivially beyond 1/2,
/// where the rate is not claimed.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && now@.len() * now@.len() <= usize::MAX@ && next@.len() == now@.len()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, shrinks(*setting, now@, next@))))]
fn at_rate<S: Ordered>(setting: &Setting<S>, now: &[S], next: &[S]) -> Verdict {
    let count = now.len();
    let (num, den) = (&setting.eps_num, &setting.eps_den);
    match WeightRange::PositiveUpToHalf.contains(num, den, count) {
        Truth::True => {}
        Truth::False => return Verdict::Holds,
        Truth::Unknown => return Verdict::Undecided,
    }
    let whole = gaps::<S>(now) * &gaps(now) * den;
    let kept = whole.clone() - &(S::from_int(8) * num);
    let internal = count.saturating_sub(2);
    Verdict::for_all(
        internal,
        |i| Truth::any(internal, |j| bounded_by(setting, &whole, &kept, now, next, i, j)),
        |i| Violation { step: 1, subject: Subject::Drone(i + 1) },
    )
}

/// Whether drone `j + 1` is such a one for drone `i + 1`. `whole` is (N-1)^2 den, and `kept` 8 num
/// less.
#[cfg_attr(feature = "contracts", requires(rated(*setting, whole, kept, now@, next@) && i@ + 2 < now@.len() && j@ + 2 < now@.len()))]
#[cfg_attr(feature = "contracts", ensures(says(result, shrinks_to(*setting, now@, next@, i@ + 1, j@ + 1))))]
fn bounded_by<S: Ordered>(
    setting: &Setting<S>,
    whole: &S,
    kept: &S,
    now: &[S],
    next: &[S],
    i: usize,
    j: usize,
) -> Truth {
    let (min, max, count, i, j) = (&setting.min, &setting.max, now.len(), i + 1, j + 1);
    let after = weighed(whole, scaled_error(min, max, next, i), contraction_weight(count, j));
    let before = weighed(kept, scaled_error(min, max, now, j), contraction_weight(count, i));
    let bounded = match (after, before) {
        (Some(after), Some(before)) => at_most(&after, &before),
        _ => Truth::Unknown,
    };
    #[cfg(creusot)]
    proof_assert!(says(bounded, shrinks_to(*setting, now@, next@, i@, j@)));
    bounded
}

/// `factor * |e| * weight`, where the sign of `e` is known.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(forall<r> result == Some(r) ==> r.model() == times(times(factor.model(), absolute(e.model())), int(weight@))))]
fn weighed<S: Ordered>(factor: &S, e: S, weight: usize) -> Option<S> {
    Some(factor.clone() * &magnitude(e)? * &S::from_index(weight))
}

/// The absolute value, where the sign is known.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(forall<r> result == Some(r) ==> r.model() == absolute(e.model())))]
fn magnitude<S: Ordered>(e: S) -> Option<S> {
    let zero = S::from_int(0);
    Some(if e.compare(&zero)? == Ordering::Less { zero - &e } else { e })
}
