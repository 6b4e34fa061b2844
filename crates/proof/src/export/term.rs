//! Scalars that are SMT-LIB terms: executing the spec on them writes the formula down.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Sub};
use std::rc::Rc;

use cordon_spec::{Ordered, Scalar};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use super::decision::Oracle;

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

impl Term {
    fn add(a: &Self, b: &Self) -> Self {
        match (a, b) {
            (Self::Int(m), Self::Int(n)) => Self::Int(m + n),
            (Self::Int(z), x) | (x, Self::Int(z)) if z.is_zero() => x.clone(),
            _ => Self::Add(Rc::new((a.clone(), b.clone()))),
        }
    }

    fn sub(a: &Self, b: &Self) -> Self {
        match (a, b) {
            (Self::Int(m), Self::Int(n)) => Self::Int(m - n),
            (x, Self::Int(z)) if z.is_zero() => x.clone(),
            _ => Self::Sub(Rc::new((a.clone(), b.clone()))),
        }
    }

    fn mul(a: &Self, b: &Self) -> Self {
        match (a, b) {
            (Self::Int(m), Self::Int(n)) => Self::Int(m * n),
            (Self::Int(z), _) | (_, Self::Int(z)) if z.is_zero() => Self::Int(BigInt::zero()),
            (Self::Int(u), x) | (x, Self::Int(u)) if u.is_one() => x.clone(),
            _ => Self::Mul(Rc::new((a.clone(), b.clone()))),
        }
    }

    /// The order of the two terms where it is the same for all values of the symbols and needs
    /// no algebra: two constants, or the same term twice.
    fn order_by_form(&self, other: &Self) -> Option<Ordering> {
        match (self, other) {
            (Self::Int(a), Self::Int(b)) => Some(a.cmp(b)),
            (a, b) if a == b => Some(Ordering::Equal),
            _ => None,
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

/// A term that knows whom to ask when it is compared: the scalar on which the spec is executed.
///
/// Comparing two of them asks the [`Oracle`], which answers from the path that is being
/// explored and remembers the question. Constants know no oracle; comparing two constants needs
/// none.
#[derive(Clone, Debug)]
pub struct Symbolic {
    /// The term.
    pub term: Term,
    oracle: Option<Rc<Oracle>>,
}

impl Symbolic {
    /// The constant of this name.
    pub fn symbol(name: &str, oracle: &Rc<Oracle>) -> Self {
        Self { term: Term::Symbol(name.into()), oracle: Some(Rc::clone(oracle)) }
    }

    fn combine(self, other: &Self, op: impl Fn(&Term, &Term) -> Term) -> Self {
        let term = op(&self.term, &other.term);
        Self { term, oracle: self.oracle.or_else(|| other.oracle.clone()) }
    }
}

impl Add<&Self> for Symbolic {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        self.combine(other, Term::add)
    }
}

impl Sub<&Self> for Symbolic {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        self.combine(other, Term::sub)
    }
}

impl Mul<&Self> for Symbolic {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        self.combine(other, Term::mul)
    }
}

impl Scalar for Symbolic {
    fn from_int(n: i32) -> Self {
        Self { term: Term::Int(n.into()), oracle: None }
    }
}

impl Ordered for Symbolic {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        self.term.order_by_form(&other.term).or_else(|| {
            let oracle = self.oracle.as_ref().or(other.oracle.as_ref())?;
            oracle.ask(&self.term, &other.term)
        })
    }
}
