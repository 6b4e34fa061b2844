//! Theorem 7.7: while a drone is off its target the sum of the positions will increase.

use core::cmp::Ordering;

#[cfg(feature = "contracts")]
use crate::model::*;

use super::fixed_point::stays;
use super::hypothesis::at_target;
use super::verdict::{Subject, Truth, Verdict, equal, less};
use super::{Form, Setting};
use crate::Ordered;
use crate::placement::{scaled_error, sum};

/// The smallest j at which the printed premise allows the first off-target drone.
const PRINTED_FIRST_OFF_TARGET: usize = 3;

/// How many steps beyond k the conclusion reads.
#[cfg_attr(feature = "contracts", trusted)]
pub(super) fn span(form: Form, count: usize) -> usize {
    let internal = count.saturating_sub(2).max(1);
    match form {
        // An increase between steps k+1 and k+1+(N-2), or never: see `Theorem::span`.
        Form::Paper => internal + 1,
        // h + 1 for the largest h: the drone nearest the middle.
        Form::Sharp => count.saturating_sub(1) / 2,
    }
}

#[cfg_attr(feature = "contracts", trusted)]
pub(super) fn conclusion<S: Ordered, M: AsRef<[S]>>(
    form: Form,
    setting: &Setting<S>,
    now: &[S],
    later: &[M],
) -> Verdict {
    match form {
        Form::Paper => as_printed(setting, now, later),
        Form::Sharp => exact(setting, now, later),
    }
}

#[cfg_attr(feature = "contracts", trusted)]
fn as_printed<S: Ordered, M: AsRef<[S]>>(setting: &Setting<S>, now: &[S], later: &[M]) -> Verdict {
    let premise = stays(&sum(now), later.get(..1).unwrap_or_default())
        .and(first_off_target_is_late(setting, now));
    Verdict::given(premise, || {
        let constant = match later {
            [next, rest @ ..] => stays_or_falls(&sum(next.as_ref()), rest),
            [] => Truth::Unknown,
        };
        let increases = match constant {
            Truth::True => Truth::False,
            Truth::False => Truth::True,
            Truth::Unknown => Truth::Unknown,
        };
        Verdict::one(increases, later.len(), Subject::Sum)
    })
}

/// Whether the first drone off its target is behind its target and has index 3 or more.
#[cfg_attr(feature = "contracts", trusted)]
fn first_off_target_is_late<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Truth {
    let zero = S::from_int(0);
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

/// Whether the sum never increases from `c` on through the placements.
#[cfg_attr(feature = "contracts", trusted)]
fn stays_or_falls<S: Ordered, M: AsRef<[S]>>(c: &S, placements: &[M]) -> Truth {
    let mut before = c.clone();
    let mut answer = Truth::True;
    for x in placements {
        let after = sum(x.as_ref());
        answer = answer.and(super::verdict::at_most(&after, &before));
        before = after;
    }
    answer
}

/// The sum stays until step k+h and increases in the next, with h as predicted.
#[cfg_attr(feature = "contracts", trusted)]
fn exact<S: Ordered, M: AsRef<[S]>>(setting: &Setting<S>, now: &[S], later: &[M]) -> Verdict {
    let last = now.len().saturating_sub(1);
    let mut first_increase: Option<usize> = None;
    for j in 0..now.len() {
        match at_target(setting, now, j) {
            Truth::True => {}
            Truth::False => {
                let depth = j.min(last - j);
                first_increase = Some(first_increase.map_or(depth, |d| d.min(depth)));
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
    let as_predicted = Truth::all(later.iter().enumerate().map(|(h, x)| {
        let after = sum(x.as_ref());
        match (h + 1).cmp(&step) {
            Ordering::Less => equal(&c, &after),
            Ordering::Equal => less(&c, &after),
            Ordering::Greater => Truth::True,
        }
    }));
    Verdict::one(as_predicted, step, Subject::Sum)
}
