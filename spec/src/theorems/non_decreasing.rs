//! Theorem 7.5: the sum of the positions never decreases, and stays at the targets.

#[cfg(feature = "contracts")]
use crate::model::*;

use super::Setting;
use super::hypothesis::at_targets;
use super::verdict::{Subject, Verdict, at_most, equal};
use crate::placement::{gap, sum};
use crate::{Ordered, Scalar};

/// c^{k+1} >= c^k.
#[cfg_attr(feature = "contracts", trusted)]
pub(super) fn conclusion<S: Ordered, M: AsRef<[S]>>(now: &[S], later: &[M]) -> Verdict {
    let c = sum(now);
    later.first().map_or(Verdict::Undecided, |next| {
        Verdict::one(at_most(&c, &sum(next.as_ref())), 1, Subject::Sum)
    })
}

/// At the targets, c^{k+1} = c^k.
#[cfg_attr(feature = "contracts", trusted)]
pub(super) fn stationary<S: Ordered, M: AsRef<[S]>>(
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    Verdict::given(at_targets(setting, now), || {
        let c = sum(now);
        later.first().map_or(Verdict::Undecided, |next| {
            Verdict::one(equal(&c, &sum(next.as_ref())), 1, Subject::Sum)
        })
    })
}

/// `(c^{k+1} - c^k) - eps*(g_{N-2}^k - g_0^k)`: zero for every weight and every start with the
/// end drones in place (the telescoping identity behind 7.5; needs no order, so it can be
/// evaluated in any ring). Placements of N >= 2 drones, `after` one protocol step past `before`.
#[cfg_attr(feature = "contracts", trusted)] // promised, not proved
#[cfg_attr(feature = "contracts", requires(exact::<S>() && before@.len() >= 2))]
#[cfg_attr(feature = "contracts", ensures(result.model() == total(reals(after@), after@.len()) - total(reals(before@), before@.len())
    - eps.model() * ((before@[before@.len() - 1].model() - before@[before@.len() - 2].model()) - (before@[1].model() - before@[0].model()))))]
pub fn telescoping_residual<S: Scalar>(eps: &S, before: &[S], after: &[S]) -> S {
    let last = before.len() - 2;
    let ends = gap(before, last) - &gap(before, 0);
    sum(after) - &sum(before) - &(eps.clone() * &ends)
}
