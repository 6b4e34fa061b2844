//! Theorem 7.3: the target of each drone is an upper bound of its position. Its companions
//! (the mirror image and the box) are here too.

use super::verdict::{Subject, Truth, Verdict, Violation, at_most};
use super::{Hypothesis, Setting, StartSet, Statement, Text, WeightRange};
use crate::Ordered;
use crate::placement::scaled_error;

pub(super) const TEXT: Text = Text {
    number: "7.3",
    name: "reference position upper bound",
    paper: Statement {
        hypothesis: Hypothesis {
            weights: WeightRange::BelowHalf,
            starts: StartSet::FirstSubsegment,
        },
        conclusion: "X_i^k <= T_i for all i and k",
    },
    sharp: Statement {
        hypothesis: Hypothesis { weights: WeightRange::UpToHalf, starts: StartSet::UpperBounded },
        conclusion: "X_i^k <= T_i for all i and k; for any eps > 1/2 some such start violates it at step 1",
    },
    erratum: Some(
        "assumption 3 is not needed, X_i^0 <= T_i is enough; the paper's own start (0,10,20,30,100) violates it (30 >= 25)",
    ),
};

/// X_i <= T_i for all i.
pub(super) fn conclusion<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Verdict {
    let zero = S::from_int(0);
    for_each_drone(x, |i| at_most(&zero, &scaled_error(&setting.min, &setting.max, x, i)))
}

/// The mirror image of 7.3: X_i >= T_i for all i, preserved for 0 <= eps <= 1/2 as well.
pub fn above_targets<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Verdict {
    let zero = S::from_int(0);
    for_each_drone(x, |i| at_most(&scaled_error(&setting.min, &setting.max, x, i), &zero))
}

/// min <= X_i <= max for all i: the box, preserved for 0 <= eps <= 1/2.
pub fn in_box<S: Ordered>(setting: &Setting<S>, x: &[S]) -> Verdict {
    for_each_drone(x, |i| at_most(&setting.min, &x[i]).and(at_most(&x[i], &setting.max)))
}

fn for_each_drone<S>(x: &[S], holds: impl Fn(usize) -> Truth) -> Verdict {
    Verdict::for_all(
        (0..x.len()).map(|i| (holds(i), Violation { step: 0, subject: Subject::Drone(i) })),
    )
}
