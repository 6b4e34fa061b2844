//! Scalars other than the exact rationals on which the same spec runs.
//!
//! | type | a run on it is |
//! |---|---|
//! | [`crate::Rational`] | exact |
//! | [`Polynomial`] | symbolic: the transition relation itself |
//! | [`Residue`] | exact modulo a prime: a fast cross-check |
//! | [`Affine`](crate::linear::affine::Affine) | a form in the start |
//! | [`Enclosure`](crate::linear::enclosure::Enclosure) | an enclosure in fixed point |

mod polynomial;
mod residue;

pub use polynomial::{Monomial, Polynomial};
pub use residue::{Modulus, Residue};

/// `Add`, `Sub` and `Mul` with a borrowed right-hand side, from one function each.
#[macro_export]
macro_rules! ring_operators {
    ($t:ty, $add:expr, $sub:expr, $mul:expr) => {
        impl std::ops::Add<&$t> for $t {
            type Output = $t;
            fn add(self, rhs: &$t) -> $t {
                ($add)(self, rhs)
            }
        }
        impl std::ops::Sub<&$t> for $t {
            type Output = $t;
            fn sub(self, rhs: &$t) -> $t {
                ($sub)(self, rhs)
            }
        }
        impl std::ops::Mul<&$t> for $t {
            type Output = $t;
            fn mul(self, rhs: &$t) -> $t {
                ($mul)(self, rhs)
            }
        }
    };
}
pub use ring_operators;
