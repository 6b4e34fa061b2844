//! Theorem 7.2: the trajectories of the drones do not cross.

#[cfg(feature = "contracts")]
use crate::model::*;

use super::verdict::{Subject, Verdict, Violation, less};
use crate::Ordered;

/// X_i < X_{i+1} for all i.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(decides(result, in_order(reals(x@)))))]
pub(super) fn conclusion<S: Ordered>(x: &[S]) -> Verdict {
    Verdict::for_all(
        x.len().saturating_sub(1),
        |i| less(&x[i], &x[i + 1]),
        |i| Violation { step: 0, subject: Subject::Pair(i) },
    )
}
