//! Theorem 7.6: the sum is constant exactly at the targets.

#[cfg(feature = "contracts")]
use crate::model::*;

use super::hypothesis::at_targets;
use super::verdict::{Subject, Truth, Verdict, Violation, equal};
use super::{Form, Setting};
use crate::placement::sum;
use crate::{Ordered, Scalar};

/// How many steps beyond k both parts read.
#[cfg_attr(feature = "contracts", trusted)]
pub(super) fn span(form: Form, count: usize) -> usize {
    let internal = count.saturating_sub(2).max(1);
    match form {
        // Enough to decide "for all h": see `Theorem::span`.
        Form::Paper => internal,
        Form::Sharp => internal.div_ceil(2),
    }
}

/// At the targets at step k: the sum (paper) or every drone (sharp) stays.
#[cfg_attr(feature = "contracts", trusted)]
pub(super) fn targets_fixed<S: Ordered, M: AsRef<[S]>>(
    form: Form,
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    Verdict::given(at_targets(setting, now), || {
        let c = sum(now);
        Verdict::for_all(later.iter().enumerate().map(|(h, x)| {
            let stays = match form {
                Form::Paper => equal(&c, &sum(x.as_ref())),
                Form::Sharp => at_targets(setting, x.as_ref()),
            };
            (stays, Violation { step: h + 1, subject: Subject::Sum })
        }))
    })
}

/// A sum that stays over the span means that the drones were at their targets at step k.
#[cfg_attr(feature = "contracts", trusted)]
pub(super) fn constant_sum<S: Ordered, M: AsRef<[S]>>(
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    Verdict::given(stays(&sum(now), later), || {
        Verdict::one(at_targets(setting, now), 0, Subject::Sum)
    })
}

/// Whether every placement has the sum `c`.
#[cfg_attr(feature = "contracts", trusted)]
pub(super) fn stays<S: Scalar + Ordered, M: AsRef<[S]>>(c: &S, placements: &[M]) -> Truth {
    Truth::all(placements.iter().map(|x| equal(c, &sum(x.as_ref()))))
}
