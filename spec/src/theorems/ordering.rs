//! Theorem 7.2: the trajectories of the drones do not cross.

use super::verdict::{Subject, Verdict, Violation, less};
use crate::Ordered;

/// X_i < X_{i+1} for all i.
pub(super) fn conclusion<S: Ordered>(x: &[S]) -> Verdict {
    Verdict::for_all(
        x.iter()
            .zip(x.iter().skip(1))
            .enumerate()
            .map(|(i, (a, b))| (less(a, b), Violation { step: 0, subject: Subject::Pair(i) })),
    )
}
