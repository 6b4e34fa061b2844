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
use crate::Ordered;
use crate::placement::{contraction_weight, scaled_energy, scaled_error};

#[cfg_attr(feature = "contracts", trusted)]
pub(super) fn conclusion<S: Ordered, M: AsRef<[S]>>(
    form: Form,
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    let off_targets = match at_targets(setting, now) {
        Truth::True => Truth::False,
        Truth::False => Truth::True,
        Truth::Unknown => Truth::Unknown,
    };
    Verdict::given(off_targets, || {
        let Some(next) = later.first().map(AsRef::as_ref) else {
            return Verdict::Undecided;
        };
        let energy = |x| scaled_energy(&setting.min, &setting.max, x);
        match Verdict::one(less(&energy(next), &energy(now)), 1, Subject::Energy) {
            Verdict::Holds if form == Form::Sharp => at_rate(setting, now, next),
            verdict => verdict,
        }
    })
}

/// The contraction in one step: for every internal i there is an internal j with
/// (N-1)^2 den |e_i'| w_j <= ((N-1)^2 den - 8 num) |e_j| w_i. Holds trivially beyond 1/2,
/// where the rate is not claimed.
#[cfg_attr(feature = "contracts", trusted)]
fn at_rate<S: Ordered>(setting: &Setting<S>, now: &[S], next: &[S]) -> Verdict {
    let count = now.len();
    let (num, den) = (&setting.eps_num, &setting.eps_den);
    match WeightRange::PositiveUpToHalf.contains(num, den, count) {
        Truth::True => {}
        Truth::False => return Verdict::Holds,
        Truth::Unknown => return Verdict::Undecided,
    }
    let error = |x, i| magnitude(scaled_error(&setting.min, &setting.max, x, i));
    let square = S::from_index(count - 1) * &S::from_index(count - 1);
    let whole = square * den;
    let kept = whole.clone() - &(S::from_int(8) * num);
    let weight = |i| S::from_index(contraction_weight(count, i));
    let bounded_by = |i: usize, j: usize| -> Truth {
        match (error(next, i), error(now, j)) {
            (Some(after), Some(before)) => at_most(
                &(whole.clone() * &after * &weight(j)),
                &(kept.clone() * &before * &weight(i)),
            ),
            _ => Truth::Unknown,
        }
    };
    Verdict::for_all((1..count - 1).map(|i| {
        let some = any((1..count - 1).map(|j| bounded_by(i, j)));
        (some, Violation { step: 1, subject: Subject::Drone(i) })
    }))
}

/// The absolute value, where the sign is known.
#[cfg_attr(feature = "contracts", trusted)]
fn magnitude<S: Ordered>(e: S) -> Option<S> {
    let zero = S::from_int(0);
    Some(if e.compare(&zero)? == Ordering::Less { zero - &e } else { e })
}

/// Disjunction of many.
#[cfg_attr(feature = "contracts", trusted)]
fn any(answers: impl IntoIterator<Item = Truth>) -> Truth {
    let mut answer = Truth::False;
    for truth in answers {
        match truth {
            Truth::True => return Truth::True,
            Truth::Unknown => answer = Truth::Unknown,
            Truth::False => {}
        }
    }
    answer
}
