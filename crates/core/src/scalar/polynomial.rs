//! Polynomials in any number of indeterminates over the rationals.

use std::collections::BTreeMap;
use std::fmt;

use cordon_spec::Scalar;
use num_traits::{One, Signed, Zero};

use super::ring_operators;
use crate::Rational;
use crate::linear::affine::Affine;

/// A product of powers of indeterminates: indeterminate -> exponent, zero exponents left out.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial(BTreeMap<u32, u32>);

impl Monomial {
    /// The indeterminates that occur, with their exponents.
    pub fn powers(&self) -> impl Iterator<Item = (u32, u32)> {
        self.0.iter().map(|(&v, &e)| (v, e))
    }

    /// The sum of the exponents.
    pub fn degree(&self) -> u32 {
        self.0.values().sum()
    }

    fn times(&self, other: &Self) -> Self {
        let mut powers = self.0.clone();
        for (&v, &e) in &other.0 {
            *powers.entry(v).or_insert(0) += e;
        }
        Self(powers)
    }
}

/// A polynomial in normal form: no zero coefficients, so that equality is equality of
/// polynomials. A run of the spec on polynomials yields the transition relation itself.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polynomial(BTreeMap<Monomial, Rational>);

impl Polynomial {
    /// The indeterminate number `v`.
    pub fn variable(v: u32) -> Self {
        Self::term(Monomial(BTreeMap::from([(v, 1)])), Rational::one())
    }

    /// The polynomial of degree 0 with this value.
    pub fn constant(c: Rational) -> Self {
        Self::term(Monomial::default(), c)
    }

    fn term(m: Monomial, c: Rational) -> Self {
        if c.is_zero() { Self::default() } else { Self(BTreeMap::from([(m, c)])) }
    }

    /// The monomials that occur, with their coefficients, in a fixed order.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &Rational)> {
        self.0.iter()
    }

    /// The coefficient of a monomial.
    pub fn coefficient(&self, m: &Monomial) -> Rational {
        self.0.get(m).cloned().unwrap_or_else(Rational::zero)
    }

    /// Whether this is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The polynomial as an affine form in the indeterminates; `None` where it is not affine.
    pub fn affine(&self) -> Option<Affine> {
        let mut constant = Rational::zero();
        let mut coefficients = Vec::new();
        for (m, c) in &self.0 {
            match m.powers().collect::<Vec<_>>().as_slice() {
                [] => constant = c.clone(),
                [(v, 1)] => {
                    let v = *v as usize;
                    if coefficients.len() <= v {
                        coefficients.resize(v + 1, Rational::zero());
                    }
                    *coefficients.get_mut(v)? = c.clone();
                }
                _ => return None,
            }
        }
        Some(Affine::new(constant, coefficients))
    }

    /// The value with `value(v)` substituted for indeterminate `v`.
    pub fn evaluate(&self, value: impl Fn(u32) -> Rational) -> Rational {
        self.0.iter().fold(Rational::zero(), |sum, (m, c)| {
            let power = |product: Rational, (v, e): (u32, u32)| {
                (0..e).fold(product, |product, _| product * value(v))
            };
            sum + m.powers().fold(c.clone(), power)
        })
    }
}

fn sum(mut a: Polynomial, b: &Polynomial, sign: &Rational) -> Polynomial {
    for (m, c) in &b.0 {
        let entry = a.0.entry(m.clone()).or_insert_with(Rational::zero);
        *entry += sign * c;
    }
    a.0.retain(|_, c| !c.is_zero());
    a
}

fn product(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut product = BTreeMap::new();
    for (m, c) in &a.0 {
        for (n, d) in &b.0 {
            *product.entry(m.times(n)).or_insert_with(Rational::zero) += c * d;
        }
    }
    product.retain(|_, c| !c.is_zero());
    Polynomial(product)
}

ring_operators!(
    Polynomial,
    |a, b: &Polynomial| sum(a, b, &Rational::one()),
    |a, b: &Polynomial| sum(a, b, &-Rational::one()),
    |a: Polynomial, b: &Polynomial| product(&a, b)
);

impl Scalar for Polynomial {
    fn from_int(n: i32) -> Self {
        Self::constant(Rational::from_int(n))
    }
}

impl fmt::Display for Polynomial {
    /// In the indeterminates `x0`, `x1`, ...
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return write!(f, "0");
        }
        for (index, (m, c)) in self.0.iter().enumerate() {
            match (index, c.is_negative()) {
                (0, false) => {}
                (0, true) => write!(f, "-")?,
                (_, false) => write!(f, " + ")?,
                (_, true) => write!(f, " - ")?,
            }
            let mut factors = Vec::new();
            if !c.abs().is_one() || m.0.is_empty() {
                factors.push(c.abs().to_string());
            }
            for (v, e) in m.powers() {
                factors.push(if e == 1 { format!("x{v}") } else { format!("x{v}^{e}") });
            }
            write!(f, "{}", factors.join("*"))?;
        }
        Ok(())
    }
}
