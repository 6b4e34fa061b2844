//! Corollary 7.4: the sum of the positions, its bound and when it is met.

#[cfg(feature = "contracts")]
use crate::model::*;

use super::Setting;
use super::hypothesis::at_targets;
use super::verdict::{Subject, Truth, Verdict, at_most, equal};
use crate::placement::sum;
use crate::{Ordered, Scalar};

/// Twice the sum, and twice its bound: 2*(N*min + N(N-1)/2 * l) = N*(min + max).
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(result.0.model() == int(2) * total(reals(x@), x@.len()) && result.1.model() == bound(setting.model(), reals(x@))))]
fn doubled<S: Scalar>(setting: &Setting<S>, x: &[S]) -> (S, S) {
    let ends = setting.min.clone() + &setting.max;
    (S::from_int(2) * &sum(x), S::from_index(x.len()) * &ends)
}

/// The sum is at most its bound.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, int(2) * total(reals(x@), x@.len()) <= bound(setting.model(), reals(x@)))))]
pub(super) fn bounded<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Verdict {
    let (c, bound) = doubled(setting, x);
    Verdict::one(at_most(&c, &bound), 0, Subject::Sum)
}

/// The sum meets its bound exactly when all drones are at their targets. Vacuous where
/// neither is so.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, (int(2) * total(reals(x@), x@.len()) == bound(setting.model(), reals(x@))) == reach_targets(setting.model(), reals(x@)))))]
pub(super) fn maximal<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Verdict {
    let (c, bound) = doubled(setting, x);
    match (equal(&c, &bound), at_targets(setting, x)) {
        (Truth::True, Truth::True) => Verdict::Holds,
        (Truth::False, Truth::False) => Verdict::Vacuous,
        (Truth::Unknown, _) | (_, Truth::Unknown) => Verdict::Undecided,
        _ => Verdict::one(Truth::False, 0, Subject::Sum),
    }
}
