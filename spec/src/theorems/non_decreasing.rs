//! Theorem 7.5: the sum of the positions never decreases, and stays at the targets.

#[cfg(feature = "contracts")]
#[allow(unused_imports)] // the erased macros swallow each other's attributes
use creusot_contracts::prelude::{ensures, requires};

use super::hypothesis::at_targets;
use super::verdict::{Subject, Verdict, at_most, equal};
use super::{Hypothesis, Setting, StartSet, Statement, Text, WeightRange};
use crate::placement::{gap, sum};
use crate::{Ordered, Scalar};

pub(super) const TEXT: Text = Text {
    number: "7.5i",
    name: "non-decreasing sum",
    paper: Statement {
        hypothesis: Hypothesis {
            weights: WeightRange::BelowHalf,
            starts: StartSet::FirstSubsegment,
        },
        conclusion: "c^{k+1} >= c^k for all k",
    },
    sharp: Statement {
        hypothesis: Hypothesis { weights: WeightRange::UpToHalf, starts: StartSet::UpperBounded },
        conclusion: "c^{k+1} - c^k = eps*(g_{N-2}^k - g_0^k) for every eps and start, and under this hypothesis it is >= 0",
    },
    erratum: None,
};

pub(super) const STATIONARY: Text = Text {
    number: "7.5ii",
    name: "stationary sum at the targets",
    paper: Statement {
        hypothesis: Hypothesis { weights: WeightRange::Unit, starts: StartSet::FirstSubsegment },
        conclusion: "X_i^k = T_i for all i implies c^{k+1} = c^k",
    },
    sharp: Statement {
        hypothesis: Hypothesis { weights: WeightRange::Any, starts: StartSet::Any },
        conclusion: "X_i^k = T_i for all i implies c^{k+1} = c^k",
    },
    erratum: None,
};

/// c^{k+1} >= c^k.
pub(super) fn conclusion<S: Ordered, M: AsRef<[S]>>(now: &[S], later: &[M]) -> Verdict {
    let c = sum(now);
    later.first().map_or(Verdict::Undecided, |next| {
        Verdict::one(at_most(&c, &sum(next.as_ref())), 1, Subject::Sum)
    })
}

/// At the targets, c^{k+1} = c^k.
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
#[cfg_attr(feature = "contracts", requires(before@.len() >= 2 && after@.len() == before@.len()))]
pub fn telescoping_residual<S: Scalar>(eps: &S, before: &[S], after: &[S]) -> S {
    let last = before.len() - 2;
    let ends = gap(before, last) - &gap(before, 0);
    sum(after) - &sum(before) - &(eps.clone() * &ends)
}
