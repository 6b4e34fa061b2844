//! Polynomials over variables and applications of functions: what clauses are made of, and the
//! checker's [`Scalar`], on which it executes the spec.

use std::collections::BTreeMap;
use std::ops::{Add, Mul, Sub};
use std::rc::Rc;

use cordon_spec::Scalar;

use crate::number::{Number, charge};

/// What a polynomial is made of.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Atom {
    /// A variable or a constant.
    Var(Rc<str>),
    /// A function of integer terms.
    App(Rc<str>, Rc<[Poly]>),
    /// A fact by its name; in the sums of proofs only.
    Fact(Rc<str>),
}

impl Atom {
    /// How many atoms it has inside, itself among them.
    fn size(&self) -> u64 {
        1 + match self {
            Self::App(_, terms) => terms.iter().map(Poly::size).sum(),
            _ => 0,
        }
    }
}

/// A polynomial: its monomials (atoms in ascending order, a power as a repetition) with their
/// coefficients, none of which is zero, so that equal polynomials are equal maps.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Poly(BTreeMap<Vec<Atom>, Number>);

impl Poly {
    /// A constant.
    pub fn constant(c: Number) -> Self {
        let mut p = Self::default();
        p.add_term(Vec::new(), c);
        p
    }

    /// An integer.
    pub fn whole(n: i64) -> Self {
        Self::constant(Number::whole(n))
    }

    /// An atom.
    pub fn atom(a: Atom) -> Self {
        Self(BTreeMap::from([(vec![a], Number::whole(1))]))
    }

    /// The variable or constant of that name.
    pub fn var(name: &str) -> Self {
        Self::atom(Atom::Var(name.into()))
    }

    /// That function of these terms.
    pub fn app(function: &str, terms: &[Self]) -> Self {
        Self::atom(Atom::App(function.into(), terms.into()))
    }

    /// Its monomials and coefficients.
    pub fn terms(&self) -> impl Iterator<Item = (&Vec<Atom>, &Number)> {
        self.0.iter()
    }

    /// Whether it is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// How many atoms it has: what copying it costs.
    pub fn size(&self) -> u64 {
        self.0.keys().map(|m| 1 + m.iter().map(Atom::size).sum::<u64>()).sum()
    }

    /// Whether some atom, or an atom in the terms of one, is so.
    pub fn any(&self, is: &dyn Fn(&Atom) -> bool) -> bool {
        let inside = |a: &Atom| matches!(a, Atom::App(_, terms) if terms.iter().any(|t| t.any(is)));
        self.0.keys().flatten().any(|a| is(a) || inside(a))
    }

    /// Whether the variable occurs.
    pub fn has(&self, name: &str) -> bool {
        self.any(&|a| matches!(a, Atom::Var(v) if **v == *name))
    }

    /// The polynomial with `value(a)` in the place of each atom for which there is one, also in
    /// the terms of applications.
    pub fn substitute(&self, value: &dyn Fn(&Atom) -> Option<Self>) -> Self {
        let inside = |a: &Atom| match a {
            Atom::App(f, terms) => {
                Atom::App(f.clone(), terms.iter().map(|t| t.substitute(value)).collect())
            }
            _ => a.clone(),
        };
        let mut sum = Self::default();
        for (monomial, c) in &self.0 {
            let (mut factors, mut rest) = (Vec::new(), Vec::new());
            for a in monomial {
                match value(a) {
                    Some(p) => factors.push(p),
                    None => rest.push(inside(a)),
                }
            }
            match factors.into_iter().reduce(|p, q| p * &q) {
                Some(factor) => sum.add_product(&rest, c, &factor),
                None if copied(&rest, &[]) => {
                    rest.sort_unstable();
                    sum.add_term(rest, c.clone());
                }
                None => break,
            }
        }
        sum
    }

    /// The polynomial with polynomials in the place of variables.
    pub fn with(&self, value: &dyn Fn(&str) -> Option<Self>) -> Self {
        self.substitute(&|a| if let Atom::Var(v) = a { value(v) } else { None })
    }

    /// Its value, if it is a constant.
    pub fn value(&self) -> Option<Number> {
        self.0.keys().all(Vec::is_empty).then(|| self.coefficient(&[]))
    }

    /// The terms with such coefficients.
    pub fn part(&self, is: impl Fn(&Number) -> bool) -> Self {
        Self(self.0.iter().filter(|(_, c)| is(c)).map(|(m, c)| (m.clone(), c.clone())).collect())
    }

    /// The coefficient of a monomial.
    pub fn coefficient(&self, monomial: &[Atom]) -> Number {
        self.0.get(monomial).cloned().unwrap_or_else(|| Number::whole(0))
    }

    /// Adds a term times a polynomial, as long as that is allowed.
    fn add_product(&mut self, m: &[Atom], c: &Number, p: &Self) {
        for (n, d) in &p.0 {
            if !copied(m, n) {
                return;
            }
            let mut monomial: Vec<Atom> = m.iter().chain(n).cloned().collect();
            monomial.sort_unstable();
            self.add_term(monomial, c * d);
        }
    }

    fn add_term(&mut self, monomial: Vec<Atom>, c: Number) {
        let sum = match self.0.remove(&monomial) {
            Some(old) => old + &c,
            None => c,
        };
        if !sum.is_zero() {
            self.0.insert(monomial, sum);
        }
    }
}

/// Charges the copy of a monomial, or of a product of two; whether it is allowed.
fn copied(m: &[Atom], n: &[Atom]) -> bool {
    charge(128 * (1 + m.iter().chain(n).map(Atom::size).sum::<u64>()))
}

impl Add<&Self> for Poly {
    type Output = Self;

    fn add(mut self, other: &Self) -> Self {
        for (m, c) in &other.0 {
            if copied(m, &[]) {
                self.add_term(m.clone(), c.clone());
            }
        }
        self
    }
}

impl Sub<&Self> for Poly {
    type Output = Self;

    fn sub(mut self, other: &Self) -> Self {
        self.add_product(&[], &Number::whole(-1), other);
        self
    }
}

impl Mul<&Self> for Poly {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        let mut product = Self::default();
        for (m, c) in &self.0 {
            product.add_product(m, c, other);
        }
        product
    }
}

impl Scalar for Poly {
    fn from_int(n: i32) -> Self {
        Self::whole(n.into())
    }
}
