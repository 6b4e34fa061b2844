//! One protocol step in error coordinates, computed by the spec.
//!
//! On the segment \[0, N-1\] the target of drone i is i itself, so that no division is needed
//! and any ring will do.

use cordon_spec::coverage::exec_coverage;
use cordon_spec::{Params, Scalar, State};

/// The errors e_i' = T_i - X_i' of all `errors.len()` drones after one protocol step with
/// weight `eps`, from the errors e_i before it (PROTOCOL section 2: e' = A e on the internal
/// drones).
pub fn step<S: Scalar>(eps: &S, errors: &[S]) -> Vec<S> {
    let count = errors.len();
    let p = Params {
        min: S::from_int(0),
        max: S::from_index(count.saturating_sub(1)),
        eps: eps.clone(),
        n: 0,
    };
    let drones = errors.iter().enumerate().map(|(i, e)| S::from_index(i) - e).collect::<Vec<_>>();
    let next = exec_coverage(&p, &State { drones, timesteps: 0 });
    next.drones.iter().enumerate().map(|(i, x)| S::from_index(i) - x).collect()
}

/// The gaps g_i' after one protocol step with weight `eps`, from the gaps g_i before it; the
/// segment is \[0, sum of the gaps\].
pub fn step_gaps<S: Scalar>(eps: &S, gaps: &[S]) -> Vec<S> {
    let mut position = S::from_int(0);
    let mut drones = vec![position.clone()];
    for g in gaps {
        position = position + g;
        drones.push(position.clone());
    }
    let p = Params { min: S::from_int(0), max: position, eps: eps.clone(), n: 0 };
    let next = exec_coverage(&p, &State { drones, timesteps: 0 }).drones;
    next.iter().zip(next.iter().skip(1)).map(|(a, b)| b.clone() - a).collect()
}
