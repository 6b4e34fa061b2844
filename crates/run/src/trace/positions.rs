//! The exact positions of one row, in the engine's representation.

use num_bigint::BigInt;

use crate::fast::answer::{Answer, Terms};
use crate::fast::{engine, power};
use cordon_core::Rational;
use cordon_core::exact;

/// The exact positions of all drones. Decimals are computed without reduction to lowest terms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Positions(Kind);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Kind {
    /// Fractions in lowest terms.
    Lowest(Vec<Rational>),
    /// Over a common denominator with the factor `power`, which is `den^k`.
    Common { answer: Answer, power: BigInt },
}

impl From<Vec<Rational>> for Positions {
    fn from(positions: Vec<Rational>) -> Self {
        Self(Kind::Lowest(positions))
    }
}

impl From<Answer> for Positions {
    fn from(answer: Answer) -> Self {
        let power = power::natural(answer.den.magnitude(), answer.k, engine::multiplier());
        Self(Kind::Common { answer, power: power.into() })
    }
}

impl Positions {
    /// As fractions in lowest terms.
    pub fn lowest(&self) -> Vec<Rational> {
        match &self.0 {
            Kind::Lowest(positions) => positions.clone(),
            Kind::Common { answer, power } => {
                let mut terms = Terms::of(answer, power.clone());
                answer.numerators.iter().map(|n| terms.lowest(n)).collect()
            }
        }
    }

    /// As decimals, rounded half to even.
    pub fn decimals(&self, digits: usize) -> Vec<String> {
        self.quotients(|num, den| exact::quotient_decimal(num, den, digits))
    }

    /// As the nearest doubles.
    pub fn doubles(&self) -> Vec<f64> {
        self.quotients(exact::quotient_to_f64)
    }

    fn quotients<T>(&self, show: impl Fn(&BigInt, &BigInt) -> T) -> Vec<T> {
        match &self.0 {
            Kind::Lowest(positions) => {
                positions.iter().map(|x| show(x.numer(), x.denom())).collect()
            }
            Kind::Common { answer, power } => {
                let den = power * &answer.base;
                answer.numerators.iter().map(|n| show(n, &den)).collect()
            }
        }
    }
}
