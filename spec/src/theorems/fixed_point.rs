//! Theorem 7.6: the sum is constant exactly at the targets.

use super::hypothesis::at_targets;
use super::verdict::{Subject, Truth, Verdict, Violation, equal};
use super::{Form, Hypothesis, Setting, StartSet, Statement, Text, WeightRange};
use crate::placement::sum;
use crate::{Ordered, Scalar};

const PAPER: Hypothesis =
    Hypothesis { weights: WeightRange::BelowThird, starts: StartSet::FirstSubsegment };

pub(super) const TARGETS_FIXED: Text = Text {
    number: "7.6i",
    name: "convergence: targets are fixed",
    paper: Statement {
        hypothesis: PAPER,
        conclusion: "X_i^k = T_i for all i implies c^{k+h} = c^k for all h >= 1",
    },
    sharp: Statement {
        hypothesis: Hypothesis { weights: WeightRange::Any, starts: StartSet::Any },
        conclusion: "X_i^k = T_i for all i implies X_i^{k+h} = T_i for all i and h >= 1",
    },
    erratum: None,
};

pub(super) const CONSTANT_SUM: Text = Text {
    number: "7.6ii",
    name: "convergence: a constant sum means targets",
    paper: Statement {
        hypothesis: PAPER,
        conclusion: "c^{k+h} = c^k for all h >= 1 implies X_i^k = T_i for all i",
    },
    sharp: Statement {
        hypothesis: Hypothesis {
            weights: WeightRange::PositiveUpToHalf,
            starts: StartSet::UpperBounded,
        },
        conclusion: "c^{k+h} = c^k for h = 1 .. ceil((N-2)/2) implies X_i^k = T_i for all i",
    },
    erratum: Some("false at eps = 0, which definition 6 allows"),
};

/// How many steps beyond k both parts read.
pub(super) fn span(form: Form, count: usize) -> usize {
    let internal = count.saturating_sub(2).max(1);
    match form {
        // Enough to decide "for all h": see `Theorem::span`.
        Form::Paper => internal,
        Form::Sharp => internal.div_ceil(2),
    }
}

/// At the targets at step k: the sum (paper) or every drone (sharp) stays.
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
pub(super) fn stays<S: Scalar + Ordered, M: AsRef<[S]>>(c: &S, placements: &[M]) -> Truth {
    Truth::all(placements.iter().map(|x| equal(c, &sum(x.as_ref()))))
}
