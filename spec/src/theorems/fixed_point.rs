//! Theorem 7.6: the sum is constant exactly at the targets.

#[cfg(feature = "contracts")]
use crate::model::*;

use super::hypothesis::at_targets;
use super::verdict::{Subject, Truth, Verdict, Violation, equal};
use super::{Form, Setting};
use crate::placement::sum;
use crate::{DroneMap, Ordered};

/// At the targets at step k: the sum (paper) or every drone (sharp) stays.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, reach_targets(setting.model(), reals(now@)) ==> remains(form, setting.model(), now@, later@))))]
pub(super) fn targets_fixed<S: Ordered, M: DroneMap<S>>(
    form: Form,
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    Verdict::given(at_targets(setting, now), || remain(form, setting, now, later))
}

#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, remains(form, setting.model(), now@, later@))))]
fn remain<S: Ordered, M: DroneMap<S>>(
    form: Form,
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    let c = sum(now);
    let count = later.len();
    let at = |h| Violation { step: h + 1, subject: Subject::Sum };
    match form {
        Form::Paper => Verdict::for_all(count, |h| equal(&c, &sum(later[h].as_ref())), at),
        Form::Sharp => Verdict::for_all(count, |h| at_targets(setting, later[h].as_ref()), at),
    }
}

/// A sum that stays over the span means that the drones were at their targets at step k.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, constant(now@, later@, later@.len()) ==> reach_targets(setting.model(), reals(now@)))))]
pub(super) fn constant_sum<S: Ordered, M: DroneMap<S>>(
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    Verdict::given(stays(now, later, later.len()), || {
        Verdict::one(at_targets(setting, now), 0, Subject::Sum)
    })
}

/// Whether the first `count` of the later placements have the sum of `now`.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && count@ <= later@.len()))]
#[cfg_attr(feature = "contracts", ensures(says(result, constant(now@, later@, count@))))]
pub(super) fn stays<S: Ordered, M: DroneMap<S>>(now: &[S], later: &[M], count: usize) -> Truth {
    let c = sum(now);
    Truth::all(count, |h| equal(&c, &sum(later[h].as_ref())))
}
