//! Theorem 7.2: the trajectories of the drones do not cross.

#[cfg(feature = "contracts")]
use crate::model::*;

use super::verdict::{Subject, Verdict, Violation, less};
use crate::Ordered;

/// X_i < X_{i+1} for all i.
#[cfg_attr(feature = "contracts", trusted)] // promised, not proved
#[cfg_attr(feature = "contracts", requires(x@.len() < usize::MAX@))]
#[cfg_attr(feature = "contracts", ensures(decides(result, theorems::ordered(reals(x@)))))]
pub(super) fn conclusion<S: Ordered>(x: &[S]) -> Verdict {
    Verdict::for_all(
        x.iter()
            .zip(x.iter().skip(1))
            .enumerate()
            .map(|(i, (a, b))| (less(a, b), Violation { step: 0, subject: Subject::Pair(i) })),
    )
}
