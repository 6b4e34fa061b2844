//! Theorem 7.3: the target of each drone is an upper bound of its position. Its companions
//! (the mirror image and the box) are here too.

#[cfg(feature = "contracts")]
use crate::model::*;

use super::Setting;
use super::verdict::{Subject, Truth, Verdict, Violation, at_most};
use crate::Ordered;
use crate::placement::scaled_error;

/// X_i <= T_i for all i.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, behind(setting.model(), reals(x@)))))]
pub(super) fn conclusion<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Verdict {
    let zero = S::from_int(0);
    for_each_drone(x, |i| at_most(&zero, &scaled_error(&setting.min, &setting.max, x, i)))
}

/// The mirror image of 7.3: X_i >= T_i for all i, preserved for 0 <= eps <= 1/2 as well.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, ahead(setting.model(), reals(x@)))))]
pub fn above_targets<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Verdict {
    let zero = S::from_int(0);
    for_each_drone(x, |i| at_most(&scaled_error(&setting.min, &setting.max, x, i), &zero))
}

/// min <= X_i <= max for all i: the box, preserved for 0 <= eps <= 1/2.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, boxed(setting.model(), reals(x@)))))]
pub fn in_box<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Verdict {
    for_each_drone(x, |i| at_most(&setting.min, &x[i]).and(at_most(&x[i], &setting.max)))
}

#[cfg_attr(feature = "contracts", requires(forall<i: usize> i@ < x@.len() ==> holds.precondition((i,))))]
#[cfg_attr(feature = "contracts", ensures(verdict_of(holds, x@.len(), result)))]
fn for_each_drone<S>(x: &[S], holds: impl Fn(usize) -> Truth) -> Verdict {
    Verdict::for_all(x.len(), holds, |i| Violation { step: 0, subject: Subject::Drone(i) })
}
