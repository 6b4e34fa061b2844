//! Theorem 7.7: while a drone is off its target the sum of the positions will increase.

use core::cmp::Ordering;

#[cfg(feature = "contracts")]
use crate::model::{self, *};

use super::Setting;
use super::fixed_point::stays;
use super::hypothesis::at_target;
use super::verdict::{Subject, Truth, Verdict, at_most, equal, less};
use crate::placement::{scaled_error, sum};
use crate::{DroneMap, Ordered};

/// The smallest j at which the printed premise allows the first off-target drone.
const PRINTED_FIRST_OFF_TARGET: usize = 3;

/// If the sum stays in the next step, it increases in one after that. At least one placement
/// is later.
#[cfg_attr(feature = "contracts", requires(model::exact::<S>() && later@.len() > 0))]
#[cfg_attr(feature = "contracts", ensures(decides(result, increases_as_printed(setting.model(), now@, later@))))]
pub(super) fn as_printed<S: Ordered, M: DroneMap<S>>(
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    let premise = stays(now, later, 1).and(first_off_target_is_late(setting, now));
    Verdict::given(premise, || {
        let falls = |h: usize| at_most(&sum(later[h + 1].as_ref()), &sum(later[h].as_ref()));
        let increases = Truth::all(later.len() - 1, falls).negated();
        Verdict::one(increases, later.len(), Subject::Sum)
    })
}

/// Whether the first drone off its target is behind its target and has index 3 or more.
#[cfg_attr(feature = "contracts", requires(model::exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(says(result, late(setting.model(), reals(x@)))))]
fn first_off_target_is_late<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Truth {
    let zero = S::from_int(0);
    #[cfg_attr(creusot, invariant(on_targets(setting.model(), reals(x@), produced.len())))]
    for j in 0..x.len() {
        match at_target(setting, x, j) {
            Truth::True => {}
            Truth::False if j < PRINTED_FIRST_OFF_TARGET => return Truth::False,
            Truth::False => {
                return less(&zero, &scaled_error(&setting.min, &setting.max, x, j));
            }
            Truth::Unknown => return Truth::Unknown,
        }
    }
    Truth::False
}

/// The sum stays until step k+h and increases in the next, with h as predicted.
#[cfg_attr(feature = "contracts", requires(model::exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, increases(setting.model(), now@, later@))))]
pub(super) fn exact<S: Ordered, M: DroneMap<S>>(
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    let last = now.len().saturating_sub(1);
    let mut first_increase: Option<usize> = None;
    #[cfg_attr(creusot, invariant(match first_increase { Some(d) => nearest(setting.model(), reals(now@), produced.len(), d@), None => on_targets(setting.model(), reals(now@), produced.len()) }))]
    for j in 0..now.len() {
        match at_target(setting, now, j) {
            Truth::True => {}
            Truth::False => {
                let depth = j.min(last - j);
                first_increase = Some(first_increase.map_or(depth, |before| before.min(depth)));
            }
            Truth::Unknown => return Verdict::Undecided,
        }
    }
    // `first_increase` is h + 1; it is at least 1, the end drones being at their targets.
    let Some(step) = first_increase else {
        return Verdict::Vacuous;
    };
    if step > later.len() {
        return Verdict::Undecided;
    }
    let c = sum(now);
    // Over all of the run, and no slice of it: its length depends on positions, and a loop's
    // must not.
    let as_predicted = Truth::all(later.len(), |h| {
        let after = sum(later[h].as_ref());
        match (h + 1).cmp(&step) {
            Ordering::Less => equal(&c, &after),
            Ordering::Equal => less(&c, &after),
            Ordering::Greater => Truth::True,
        }
    });
    #[cfg(creusot)]
    proof_assert!(nearest(setting.model(), reals(now@), now@.len(), step@) && says(as_predicted, increases_at(now@, later@, step@)));
    Verdict::one(as_predicted, step, Subject::Sum)
}
