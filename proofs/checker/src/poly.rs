//! Polynomials over the rationals, as the checker's [`Scalar`]: executing the spec on them
//! gives its transition relation.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::{Add, Mul, Sub};

use cordon_spec::Scalar;
use num_traits::{One, Zero};

/// Exact rationals.
pub type Rational = num_rational::BigRational;

/// An indeterminate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Var {
    /// One of a kind: `eps`, `min`, `i`, ...
    Named(&'static str),
    /// One of a row: `x[-1]` is the position of drone i-1.
    At(&'static str, i32),
}

impl fmt::Display for Var {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Named(name) => f.write_str(name),
            Self::At(name, offset) => write!(f, "{name}[{offset}]"),
        }
    }
}

/// A monomial: its indeterminates in ascending order, each as often as its exponent says.
pub type Monomial = Vec<Var>;

/// A polynomial: its monomials with their coefficients, none of which is zero, so that equal
/// polynomials are equal maps.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Poly(BTreeMap<Monomial, Rational>);

impl Poly {
    /// A constant.
    pub fn constant(c: Rational) -> Self {
        let mut p = Self::default();
        p.add_term(Vec::new(), c);
        p
    }

    /// An indeterminate.
    pub fn var(v: Var) -> Self {
        Self(BTreeMap::from([(vec![v], Rational::one())]))
    }

    /// The indeterminate of that name.
    pub fn named(name: &'static str) -> Self {
        Self::var(Var::Named(name))
    }

    /// Whether this is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The number of monomials.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is no monomial: the same as [`Self::is_zero`].
    pub fn is_empty(&self) -> bool {
        self.is_zero()
    }

    /// The monomials and their coefficients.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &Rational)> {
        self.0.iter()
    }

    /// Adds `c` times the monomial, whose indeterminates are in ascending order.
    pub fn add_term(&mut self, monomial: Monomial, c: Rational) {
        let sum = self.0.remove(&monomial).map_or(c.clone(), |old| old + c);
        if !sum.is_zero() {
            self.0.insert(monomial, sum);
        }
    }

    /// The polynomial with `value(v)` in the place of each indeterminate v for which there is one.
    pub fn substitute(&self, value: impl Fn(Var) -> Option<Self>) -> Self {
        self.0.iter().fold(Self::default(), |sum, (monomial, c)| {
            let product = monomial.iter().fold(Self::constant(c.clone()), |product, &v| {
                product * &value(v).unwrap_or_else(|| Self::var(v))
            });
            sum + &product
        })
    }
}

impl From<usize> for Poly {
    fn from(index: usize) -> Self {
        Self::constant(Rational::from_integer(index.into()))
    }
}

impl Add<&Self> for Poly {
    type Output = Self;

    fn add(mut self, other: &Self) -> Self {
        for (monomial, c) in &other.0 {
            self.add_term(monomial.clone(), c.clone());
        }
        self
    }
}

impl Sub<&Self> for Poly {
    type Output = Self;

    fn sub(mut self, other: &Self) -> Self {
        for (monomial, c) in &other.0 {
            self.add_term(monomial.clone(), -c.clone());
        }
        self
    }
}

impl Mul<&Self> for Poly {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        let mut product = Self::default();
        for (m, c) in &self.0 {
            for (n, d) in &other.0 {
                let mut monomial: Monomial = m.iter().chain(n).copied().collect();
                monomial.sort_unstable();
                product.add_term(monomial, c * d);
            }
        }
        product
    }
}

impl Scalar for Poly {
    fn from_int(n: i32) -> Self {
        Self::constant(Rational::from_integer(n.into()))
    }
}
