//! Theorem 7.2: the trajectories of the drones do not cross.

use super::verdict::{Subject, Verdict, Violation, less};
use super::{Hypothesis, StartSet, Statement, Text, WeightRange};
use crate::Ordered;

pub(super) const TEXT: Text = Text {
    number: "7.2",
    name: "invariant spatial ordering",
    paper: Statement {
        hypothesis: Hypothesis { weights: WeightRange::BelowThird, starts: StartSet::Ordered },
        conclusion: "X_i^k < X_{i+1}^k for all i and k",
    },
    sharp: Statement {
        hypothesis: Hypothesis { weights: WeightRange::UpToHalfOrOne, starts: StartSet::Ordered },
        conclusion: "X_i^k < X_{i+1}^k for all i and k; for N >= 4 and any eps > 1/2 some start crosses at step 1",
    },
    erratum: Some(
        "the text has eps < 1/3, the appendix eps <= 1/3: neither is needed, 1/2 is exact for N >= 4",
    ),
};

/// X_i < X_{i+1} for all i.
pub(super) fn conclusion<S: Ordered>(x: &[S]) -> Verdict {
    Verdict::for_all(
        x.iter()
            .zip(x.iter().skip(1))
            .enumerate()
            .map(|(i, (a, b))| (less(a, b), Violation { step: 0, subject: Subject::Pair(i) })),
    )
}
