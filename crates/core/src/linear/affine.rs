//! Affine forms over the rationals, as scalars of the spec.
//!
//! Running the protocol on forms gives every later position as an exact form in the start: what holds
//! of the form holds for every start. A product of two non-constant forms is not affine; it becomes
//! [`Affine::beyond`], about which nothing is known.

use std::ops::{Add, Mul, Sub};

use cordon_spec::Scalar;
use num_traits::{One, Zero};

use crate::Rational;

/// `constant + sum of coefficients[j] * x_j`, or something that is not affine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Affine {
    parts: Option<Parts>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Parts {
    constant: Rational,
    /// By index of the variable, without trailing zeros.
    coefficients: Vec<Rational>,
}

impl Affine {
    /// The form with these parts.
    pub fn new(constant: Rational, mut coefficients: Vec<Rational>) -> Self {
        while coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        Self { parts: Some(Parts { constant, coefficients }) }
    }

    /// The form that is `value` whatever the variables are.
    pub fn constant(value: Rational) -> Self {
        Self::new(value, Vec::new())
    }

    /// The form that is the variable x_j, counted from 0.
    pub fn variable(j: usize) -> Self {
        let mut coefficients = vec![Rational::zero(); j];
        coefficients.push(Rational::one());
        Self::new(Rational::zero(), coefficients)
    }

    /// A value that is not affine.
    pub fn beyond() -> Self {
        Self { parts: None }
    }

    /// Constant and coefficients (the missing ones are zero), where this is affine.
    pub fn parts(&self) -> Option<(&Rational, &[Rational])> {
        self.parts.as_ref().map(|p| (&p.constant, p.coefficients.as_slice()))
    }

    /// The value at the point `x`; `None` where this is not affine.
    pub fn at(&self, x: &[Rational]) -> Option<Rational> {
        let (constant, coefficients) = self.parts()?;
        Some(coefficients.iter().zip(x).fold(constant.clone(), |sum, (c, v)| sum + c * v))
    }

    /// The value, where this is constant.
    pub fn as_constant(&self) -> Option<&Rational> {
        self.parts().and_then(|(constant, rest)| rest.is_empty().then_some(constant))
    }

    fn scaled(parts: &Parts, by: &Rational) -> Self {
        let coefficients = parts.coefficients.iter().map(|c| c * by).collect();
        Self::new(&parts.constant * by, coefficients)
    }
}

fn combine(a: Affine, b: &Affine, op: impl Fn(Rational, &Rational) -> Rational) -> Affine {
    let (Some(mut a), Some(b)) = (a.parts, &b.parts) else {
        return Affine::beyond();
    };
    if a.coefficients.len() < b.coefficients.len() {
        a.coefficients.resize(b.coefficients.len(), Rational::zero());
    }
    for (x, y) in a.coefficients.iter_mut().zip(&b.coefficients) {
        *x = op(std::mem::take(x), y);
    }
    Affine::new(op(a.constant, &b.constant), a.coefficients)
}

impl Add<&Self> for Affine {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        combine(self, other, |a, b| a + b)
    }
}

impl Sub<&Self> for Affine {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        combine(self, other, |a, b| a - b)
    }
}

impl Mul<&Self> for Affine {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        match (&self.parts, &other.parts) {
            (Some(a), Some(b)) if a.coefficients.is_empty() => Self::scaled(b, &a.constant),
            (Some(a), Some(b)) if b.coefficients.is_empty() => Self::scaled(a, &b.constant),
            _ => Self::beyond(),
        }
    }
}

impl Scalar for Affine {
    fn from_int(n: i32) -> Self {
        Self::constant(Rational::from_integer(n.into()))
    }
}
