//! Theorem 7.5: the sum of the positions never decreases, and stays at the targets.

#[cfg(feature = "contracts")]
use crate::model::*;

use super::Setting;
use super::hypothesis::at_targets;
use super::verdict::{Subject, Verdict, at_most, equal};
use crate::placement::{gap, sum};
use crate::{DroneMap, Ordered, Scalar};

/// c^{k+1} >= c^k: the sum does not fall in the step.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && later@.len() > 0))]
#[cfg_attr(feature = "contracts", ensures(decides(result, sum_of(now@) <= sum_of(later@[0].seq()))))]
pub(super) fn conclusion<S: Ordered, M: DroneMap<S>>(now: &[S], later: &[M]) -> Verdict {
    Verdict::one(at_most(&sum(now), &sum(later[0].as_ref())), 1, Subject::Sum)
}

/// At the targets, c^{k+1} = c^k.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && later@.len() > 0))]
#[cfg_attr(feature = "contracts", ensures(decides(result, reach_targets(setting.model(), reals(now@)) ==> sum_of(later@[0].seq()) == sum_of(now@))))]
pub(super) fn stationary<S: Ordered, M: DroneMap<S>>(
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    Verdict::given(at_targets(setting, now), || {
        Verdict::one(equal(&sum(now), &sum(later[0].as_ref())), 1, Subject::Sum)
    })
}

/// `(c^{k+1} - c^k) - eps*(g_{N-2}^k - g_0^k)`: zero for every weight and every start with the
/// end drones in place (the telescoping identity behind 7.5; needs no order, so it can be
/// evaluated in any ring). Placements of N >= 2 drones, `after` one protocol step past `before`.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && before@.len() >= 2))]
#[cfg_attr(feature = "contracts", ensures(result.model() == total(reals(after@), after@.len()) - total(reals(before@), before@.len())
    - eps.model() * ends_apart(before@)))]
pub fn telescoping_residual<S: Scalar>(eps: &S, before: &[S], after: &[S]) -> S {
    let last = before.len() - 2;
    let ends = gap(before, last) - &gap(before, 0);
    #[cfg(creusot)]
    proof_assert!(same_factor(eps.model(), ends.model(), ends_apart(before@)) && times(eps.model(), ends.model()) == eps.model() * ends_apart(before@));
    sum(after) - &sum(before) - &(eps.clone() * &ends)
}
