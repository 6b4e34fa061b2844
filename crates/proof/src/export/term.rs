//! Scalars that are SMT-LIB terms: executing the spec on them writes the formula down.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Sub};
use std::rc::Rc;

use cordon_spec::Scalar;
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::symbolic::{Compared, Expression};

/// A term over the reals: integer constants, named constants, sums, differences, products.
///
/// Constants are folded and the units of addition and multiplication dropped, so that the
/// text stays readable; nothing else is rewritten.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Term {
    /// An integer.
    Int(BigInt),
    /// A declared or defined constant.
    Symbol(Rc<str>),
    /// A sum.
    Add(Rc<(Term, Term)>),
    /// A difference.
    Sub(Rc<(Term, Term)>),
    /// A product.
    Mul(Rc<(Term, Term)>),
}

impl Add<&Self> for Term {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        match (&self, other) {
            (Self::Int(m), Self::Int(n)) => Self::Int(m + n),
            (Self::Int(z), x) | (x, Self::Int(z)) if z.is_zero() => x.clone(),
            _ => Self::Add(Rc::new((self, other.clone()))),
        }
    }
}

impl Sub<&Self> for Term {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        match (&self, other) {
            (Self::Int(m), Self::Int(n)) => Self::Int(m - n),
            (_, Self::Int(z)) if z.is_zero() => self,
            _ => Self::Sub(Rc::new((self, other.clone()))),
        }
    }
}

impl Mul<&Self> for Term {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        match (&self, other) {
            (Self::Int(m), Self::Int(n)) => Self::Int(m * n),
            (Self::Int(z), _) | (_, Self::Int(z)) if z.is_zero() => Self::Int(BigInt::zero()),
            (Self::Int(u), x) | (x, Self::Int(u)) if u.is_one() => x.clone(),
            _ => Self::Mul(Rc::new((self, other.clone()))),
        }
    }
}

/// An integer as a term of sort Real: SMT-LIB has no negative literals, and the logic of the
/// reals wants a decimal point.
fn real_literal(n: &BigInt, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if n.is_negative() { write!(f, "(- {}.0)", n.magnitude()) } else { write!(f, "{n}.0") }
}

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Int(n) => real_literal(n, f),
            Self::Symbol(name) => f.write_str(name),
            Self::Add(t) => write!(f, "(+ {} {})", t.0, t.1),
            Self::Sub(t) => write!(f, "(- {} {})", t.0, t.1),
            Self::Mul(t) => write!(f, "(* {} {})", t.0, t.1),
        }
    }
}

impl Scalar for Term {
    fn from_int(n: i32) -> Self {
        Self::Int(n.into())
    }
}

impl Expression for Term {
    /// The order is known where it needs no algebra: two constants, or the same term twice.
    fn compared(&self, other: &Self) -> Compared<Self> {
        match (self, other) {
            (Self::Int(a), Self::Int(b)) => Compared::Known(a.cmp(b)),
            (a, b) if a == b => Compared::Known(Ordering::Equal),
            (a, b) => Compared::Open([a.clone(), b.clone()]),
        }
    }
}
