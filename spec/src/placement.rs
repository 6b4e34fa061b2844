//! Quantities of a placement, all free of division so that they make sense in any ring.
//!
//! A placement `x` has one position a drone, N of them, N >= 2. The spacing is
//! `l = (max - min)/(N-1)` and the target of drone i is `T_i = min + i*l`; where a formula
//! would divide by N-1, the quantity here is the one multiplied by N-1, and its name says so.

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::Scalar;

/// The gap `g_i = X_{i+1} - X_i`; `i + 1` is below N.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && i@ + 1 < x@.len()))]
#[cfg_attr(feature = "contracts", ensures(result.model() == x@[i@ + 1].model() - x@[i@].model()))]
pub fn gap<S: Scalar>(x: &[S], i: usize) -> S {
    x[i + 1].clone() - &x[i]
}

/// The sum of all positions: the paper's c (definition 7 of its section 7.1).
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(result.model() == total(reals(x@), x@.len())))]
pub fn sum<S: Scalar>(x: &[S]) -> S {
    let mut c = S::from_int(0);
    #[cfg_attr(creusot, invariant(c.model() == total(reals(x@), produced.len()) && produced.len() <= x@.len()))]
    for xi in x {
        #[cfg(creusot)]
        proof_assert!(*xi == x@[produced.len() - 1] && reals(x@)[produced.len() - 1] == xi.model());
        c = c + xi;
    }
    c
}

/// The last index N-1, as a scalar: the number of gaps.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(result.model() == int(last_of(x@.len()))))]
pub fn gaps<S: Scalar>(x: &[S]) -> S {
    S::from_index(x.len().saturating_sub(1))
}

/// `(N-1) * T_i`: N-1 times the target of drone `i` of `count` (definition 3).
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(result.model() == target(min.model(), max.model(), int(last_of(count@)), int(i@))))]
pub fn scaled_target<S: Scalar>(min: &S, max: &S, count: usize, i: usize) -> S {
    let last = S::from_index(count.saturating_sub(1));
    last * min + &(S::from_index(i) * &(max.clone() - min))
}

/// `(N-1) * e_i`: N-1 times the error `e_i = T_i - X_i` of drone `i`; positive while the
/// drone is before its target.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && i@ < x@.len()))]
#[cfg_attr(feature = "contracts", ensures(result.model() == error(min.model(), max.model(), reals(x@), i@)))]
pub fn scaled_error<S: Scalar>(min: &S, max: &S, x: &[S], i: usize) -> S {
    // Target less position, with the two products by N-1 in one.
    gaps::<S>(x) * &(min.clone() - &x[i]) + &(S::from_index(i) * &(max.clone() - min))
}

/// `(N-1)^2` times the sum of the squared errors: zero exactly at the targets.
#[cfg_attr(feature = "contracts", requires(exact::<S>()))]
#[cfg_attr(feature = "contracts", ensures(result.model() == energy(min.model(), max.model(), reals(x@), x@.len())))]
pub fn scaled_energy<S: Scalar>(min: &S, max: &S, x: &[S]) -> S {
    let mut sum = S::from_int(0);
    #[cfg_attr(creusot, invariant(sum.model() == energy(min.model(), max.model(), reals(x@), produced.len())))]
    for i in 0..x.len() {
        let e = scaled_error(min, max, x, i);
        #[cfg(creusot)]
        proof_assert!(one_error_more(min.model(), max.model(), reals(x@), i@, e.model()) && i@ + 1 == produced.len()
            && energy(min.model(), max.model(), reals(x@), i@ + 1) == energy(min.model(), max.model(), reals(x@), i@) + times(e.model(), e.model()));
        sum = sum + &(e.clone() * &e);
    }
    sum
}

/// The contraction vector `w_i = i*(N-1-i)` (PROTOCOL section 2): positive on the internal
/// drones, zero at the ends.
#[cfg_attr(feature = "contracts", requires(i@ < count@ && count@ * count@ <= usize::MAX@))]
#[cfg_attr(feature = "contracts", ensures(result@ == i@ * (count@ - 1 - i@)))]
pub fn contraction_weight(count: usize, i: usize) -> usize {
    #[cfg(creusot)]
    proof_assert!(weight_fits(count@, i@, usize::MAX@));
    i * (count - 1 - i)
}
