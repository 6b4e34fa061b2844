//! Enclosures in binary fixed point, as scalars of the spec.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use cordon_spec::{Ordered, Scalar};
use num_bigint::BigInt;

use crate::Rational;

/// All numbers from `lo / 2^BITS` to `hi / 2^BITS`. Each operation rounds outwards, so that a
/// All numbers from `lo / 2^BITS` to `hi / 2^BITS`. Each operation rounds outwards, so that a run on
/// enclosures encloses the exact run; unlike fractions, the numbers do not grow in length.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enclosure<const BITS: u32> {
    lo: BigInt,
    hi: BigInt,
}

impl<const BITS: u32> Enclosure<BITS> {
    /// The tightest enclosure of a number.
    pub fn of(x: &Rational) -> Self {
        let scaled = x * Rational::from_integer(BigInt::from(1) << BITS);
        Self { lo: scaled.floor().to_integer(), hi: scaled.ceil().to_integer() }
    }
}

impl<const BITS: u32> Add<&Self> for Enclosure<BITS> {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        Self { lo: self.lo + &other.lo, hi: self.hi + &other.hi }
    }
}

impl<const BITS: u32> Sub<&Self> for Enclosure<BITS> {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        Self { lo: self.lo - &other.hi, hi: self.hi - &other.lo }
    }
}

impl<const BITS: u32> Mul<&Self> for Enclosure<BITS> {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        let ends = [
            &self.lo * &other.lo,
            &self.lo * &other.hi,
            &self.hi * &other.lo,
            &self.hi * &other.hi,
        ];
        let [first, rest @ ..] = ends;
        let (mut least, mut largest) = (first.clone(), first);
        for x in rest {
            if x < least {
                least = x;
            } else if x > largest {
                largest = x;
            }
        }
        // A right shift of a BigInt rounds down; of the negated number, up.
        Self { lo: least >> BITS, hi: -(-largest >> BITS) }
    }
}

impl<const BITS: u32> Scalar for Enclosure<BITS> {
    fn from_int(n: i32) -> Self {
        let n = BigInt::from(n) << BITS;
        Self { lo: n.clone(), hi: n }
    }
}

impl<const BITS: u32> Ordered for Enclosure<BITS> {
    /// `None` where the enclosures overlap in more than one common point.
    fn compare(&self, other: &Self) -> Option<Ordering> {
        if self.hi < other.lo {
            Some(Ordering::Less)
        } else if self.lo > other.hi {
            Some(Ordering::Greater)
        } else if self.lo == self.hi && self == other {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use cordon_spec::coverage::exec_coverage;
    use cordon_spec::{Params, State};
    use proptest::prelude::*;

    use super::*;

    const BITS: u32 = 12;

    fn rational() -> impl Strategy<Value = Rational> {
        (-1000i64..=1000, 1i64..=60).prop_map(|(p, q)| Rational::new(p.into(), q.into()))
    }

    fn runs<S: Scalar>(eps: &S, x: &[S]) -> Vec<Vec<S>> {
        let (min, max) = (x[0].clone(), x[x.len() - 1].clone());
        let p = Params { min, max, eps: eps.clone(), n: 0 };
        let step = |s: &State<Vec<S>>| Some(exec_coverage(&p, s));
        let start = State { drones: x.to_vec(), timesteps: 0 };
        std::iter::successors(Some(start), step).take(5).map(|s| s.drones).collect()
    }

    proptest! {
        #[test]
        fn a_run_on_enclosures_encloses_the_exact_run(
            eps in rational(),
            x in prop::collection::vec(rational(), 3..8),
        ) {
            let of = Enclosure::<BITS>::of;
            let wide = runs(&of(&eps), &x.iter().map(of).collect::<Vec<_>>());
            let unit = Rational::from_integer(BigInt::from(1) << BITS);
            for (e, x) in wide.iter().flatten().zip(runs(&eps, &x).iter().flatten()) {
                let scaled = x * &unit;
                let [lo, hi] = [&e.lo, &e.hi].map(|end| Rational::from_integer(end.clone()));
                prop_assert!(lo <= scaled && scaled <= hi, "{:?} misses {}", e, x);
            }
        }
    }
}
