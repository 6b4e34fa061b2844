//! The update of the coverage protocol as integer weights over one denominator.
//!
//! For a given weight eps the update of a drone is linear in its neighbours' positions, its
//! own and the segment's ends. The weights are not written down here: they are read off
//! [`exec_cvg`] by executing it, over exact rationals, on the points where one of its inputs
//! is 1 and the others 0. Engines that step integers over a common denominator
//! (`X^k = x^k / den^k`) take their weights from here, so that the spec stays the only
//! definition of the protocol.

use cordon_spec::coverage::exec_cvg;
use cordon_spec::{Params, Scalar};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::One;

use crate::Rational;

/// Place of a drone in the line: all that the update depends on besides positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// Drone 0, which stays at min (coverage).
    First,
    /// A drone with two neighbours.
    Internal,
    /// Drone N-1, which stays at max (coverage).
    Last,
}

impl Role {
    /// The three roles, along the line.
    pub const ALL: [Self; 3] = [Self::First, Self::Internal, Self::Last];

    /// The role of drone `i` of `count`.
    pub fn of(i: usize, count: usize) -> Self {
        if i == 0 {
            Self::First
        } else if i + 1 == count {
            Self::Last
        } else {
            Self::Internal
        }
    }
}

/// The weight of each input in the next position of a drone, in units of 1/den of the [`Stencil`] it
/// belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Weights<T> {
    /// Of the segment's left end.
    pub min: T,
    /// Of the segment's right end.
    pub max: T,
    /// Of the preceding drone's position (for drone 0: of the left end instead).
    pub prec: T,
    /// Of the drone's own position.
    pub own: T,
    /// Of the following drone's position (for drone N-1: of the right end instead).
    pub foll: T,
}

impl<T> Weights<T> {
    /// The same weights over another type of number.
    ///
    /// # Errors
    /// The first error of `f`.
    pub fn try_map<U, E>(&self, mut f: impl FnMut(&T) -> Result<U, E>) -> Result<Weights<U>, E> {
        Ok(Weights {
            min: f(&self.min)?,
            max: f(&self.max)?,
            prec: f(&self.prec)?,
            own: f(&self.own)?,
            foll: f(&self.foll)?,
        })
    }

    /// The same weights over another type of number.
    pub fn map<U>(&self, f: impl Fn(&T) -> U) -> Weights<U> {
        let Self { min, max, prec, own, foll } = self;
        Weights { min: f(min), max: f(max), prec: f(prec), own: f(own), foll: f(foll) }
    }

    /// The weights in the order `min, max, prec, own, foll`.
    pub fn as_array(&self) -> [&T; 5] {
        [&self.min, &self.max, &self.prec, &self.own, &self.foll]
    }
}

impl<T: Scalar> Weights<T> {
    /// `den` times the next position.
    pub fn apply(&self, min: &T, max: &T, prec: &T, own: &T, foll: &T) -> T {
        let terms = [(&self.max, max), (&self.prec, prec), (&self.own, own), (&self.foll, foll)];
        let first = self.min.clone() * min;
        terms.into_iter().fold(first, |sum, (w, x)| sum + &(w.clone() * x))
    }
}

/// The update of the coverage protocol for one weight eps: integer weights over one denominator, one
/// set for each role.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stencil<T = BigInt> {
    /// The common denominator, positive; for eps = p/q in lowest terms it is q.
    pub den: T,
    /// Weights of drone 0.
    pub first: Weights<T>,
    /// Weights of every internal drone.
    pub internal: Weights<T>,
    /// Weights of drone N-1.
    pub last: Weights<T>,
}

impl Stencil {
    /// The weights of [`exec_cvg`] for the weight `eps`, any rational, over their least common
    /// denominator.
    pub fn of(eps: &Rational) -> Self {
        let Stencil { first, internal, last, .. } = Stencil::executed(eps);
        let den = [&first, &internal, &last]
            .into_iter()
            .flat_map(Weights::as_array)
            .fold(BigInt::one(), |den, w| den.lcm(w.denom()));
        let scaled = |w: &Weights<Rational>| w.map(|w| w.numer() * (&den / w.denom()));
        let (first, internal, last) = (scaled(&first), scaled(&internal), scaled(&last));
        Self { den, first, internal, last }
    }
}

impl<T: Scalar> Stencil<T> {
    /// The weights of [`exec_cvg`] for an eps of any scalar type (a symbol, say) over the denominator
    /// 1: its results where one input is 1 and the others are 0.
    pub fn executed(eps: &T) -> Self {
        // In a line of three there is one drone of each role.
        let [first, internal, last] = [0, 1, 2].map(|i| {
            let at = |input: usize| {
                let is = |j| T::from_int(i32::from(j == input));
                let p = Params { min: is(0), max: is(1), eps: eps.clone(), n: 0 };
                exec_cvg(&p, 3, &is(2), &is(3), &is(4), i)
            };
            Weights { min: at(0), max: at(1), prec: at(2), own: at(3), foll: at(4) }
        });
        Self { den: T::from_int(1), first, internal, last }
    }
}

impl<T> Stencil<T> {
    /// The weights of a role.
    pub fn weights(&self, role: Role) -> &Weights<T> {
        match role {
            Role::First => &self.first,
            Role::Internal => &self.internal,
            Role::Last => &self.last,
        }
    }

    /// The same stencil over another type of number.
    ///
    /// # Errors
    /// The first error of `f` (a weight out of range, say).
    pub fn try_map<U, E>(&self, mut f: impl FnMut(&T) -> Result<U, E>) -> Result<Stencil<U>, E> {
        Ok(Stencil {
            den: f(&self.den)?,
            first: self.first.try_map(&mut f)?,
            internal: self.internal.try_map(&mut f)?,
            last: self.last.try_map(&mut f)?,
        })
    }
}

impl<T: Scalar> Stencil<T> {
    /// `den` times the next position of drone `i` of the placement `x` (N >= 2 drones, `i`
    /// below N), the segment being from `min` to `max`.
    pub fn apply(&self, min: &T, max: &T, x: &[T], i: usize) -> T {
        let prec = if i == 0 { min } else { &x[i - 1] };
        let foll = if i + 1 == x.len() { max } else { &x[i + 1] };
        self.weights(Role::of(i, x.len())).apply(min, max, prec, &x[i], foll)
    }
}

#[cfg(test)]
mod tests {
    use cordon_spec::State;
    use cordon_spec::coverage::exec_coverage;
    use proptest::prelude::*;

    use super::*;

    fn rational() -> impl Strategy<Value = Rational> {
        (-1000i64..=1000, 1i64..=60).prop_map(|(p, q)| Rational::new(p.into(), q.into()))
    }

    proptest! {
        #[test]
        fn stencil_is_the_spec(
            eps in rational(),
            min in rational(),
            max in rational(),
            x in prop::collection::vec(rational(), 3..10),
        ) {
            let p = Params { min, max, eps, n: 0 };
            let stepped = exec_coverage(&p, &State { drones: x.clone(), timesteps: 0 });
            let stencil = Stencil::of(&p.eps);
            let over = stencil.try_map(|w| Ok::<_, ()>(Rational::from(w.clone()))).unwrap_or_else(|()| unreachable!());
            for (i, wanted) in stepped.drones.iter().enumerate() {
                let got = over.apply(&p.min, &p.max, &x, i) / &over.den;
                prop_assert_eq!(&got, wanted);
            }
        }

        #[test]
        fn denominator_is_that_of_the_weight(eps in rational()) {
            prop_assert_eq!(&Stencil::of(&eps).den, eps.denom());
        }

        #[test]
        fn weights_of_every_role_sum_to_the_denominator(eps in rational()) {
            let s = Stencil::of(&eps);
            for role in Role::ALL {
                let sum: BigInt = s.weights(role).as_array().into_iter().sum();
                prop_assert_eq!(&sum, &s.den);
            }
        }
    }

    #[test]
    fn weights_of_one_fifth() {
        let s = Stencil::of(&Rational::new(1.into(), 5.into()));
        let row = |role| {
            s.weights(role).as_array().map(|w| i64::try_from(w).unwrap_or_else(|_| unreachable!()))
        };
        assert_eq!(row(Role::First), [5, 0, 0, 0, 0]);
        assert_eq!(row(Role::Internal), [0, 0, 1, 3, 1]);
        assert_eq!(row(Role::Last), [0, 5, 0, 0, 0]);
    }

    #[test]
    fn roles_along_the_line() {
        let roles: Vec<_> = (0..4).map(|i| Role::of(i, 4)).collect();
        assert_eq!(roles, [Role::First, Role::Internal, Role::Internal, Role::Last]);
    }
}
