//! Expressions: polynomials and their relations to 0 as text.

use std::collections::BTreeMap;
use std::fmt;
use std::rc::Rc;

use crate::fault::{Result, ensure, fault};
use crate::number::{Number, charge};
use crate::poly::{Atom, Poly};

/// What a variable, a constant or a function takes its values from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// The integers.
    Integer,
    /// The real numbers.
    Real,
}

impl fmt::Display for Sort {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Integer { "integer" } else { "real" })
    }
}

/// What is said of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Relation {
    /// It is above 0.
    Positive,
    /// It is 0 or above.
    NonNegative,
    /// It is 0.
    Zero,
}

/// A polynomial and its relation to 0.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Literal {
    /// The polynomial.
    pub poly: Poly,
    /// What it is.
    pub relation: Relation,
}

impl Literal {
    /// Whether it says of a constant polynomial what is true; nothing is known of another.
    pub fn decided(&self) -> Option<bool> {
        let value = self.poly.value()?;
        Some(match self.relation {
            Relation::Positive => value.is_positive(),
            Relation::NonNegative => value.is_positive() || value.is_zero(),
            Relation::Zero => value.is_zero(),
        })
    }

    /// The literal with a polynomial made of its own.
    pub fn map(&self, f: impl FnOnce(&Poly) -> Poly) -> Self {
        Self { poly: f(&self.poly), relation: self.relation }
    }
}

/// Variables with their sorts.
pub type Vars = Vec<(Rc<str>, Sort)>;

/// The names that an expression may use beside its variables.
#[derive(Clone, Debug, Default)]
pub struct Signature {
    /// Constants of the theorem.
    pub constants: BTreeMap<Rc<str>, Sort>,
    /// Functions: how many integer terms they take, and what they give.
    pub functions: BTreeMap<Rc<str>, (usize, Sort)>,
}

const RULE: &str = "expression";

/// Most brackets within brackets.
const MAX_DEPTH: usize = 32;

/// Longest name.
const MAX_NAME: usize = 40;

impl Signature {
    /// Whether it is an integer for all integers: integer coefficients, and atoms that are.
    pub fn is_integer(&self, p: &Poly, vars: &Vars) -> bool {
        p.terms().all(|(monomial, c)| {
            c.is_integer()
                && monomial.iter().all(|a| match a {
                    Atom::Var(v) => self.sort(v, vars) == Some(Sort::Integer),
                    Atom::App(f, _) => self.functions.get(f).is_some_and(|f| f.1 == Sort::Integer),
                    Atom::Fact(_) => false,
                })
        })
    }

    /// Whether it is one of the constants.
    pub fn knows(&self, atom: &Atom) -> bool {
        matches!(atom, Atom::Var(v) if self.constants.contains_key(v))
    }

    fn sort(&self, name: &str, vars: &Vars) -> Option<Sort> {
        charge(vars.len() as u64);
        let bound = vars.iter().find(|(v, _)| **v == *name).map(|(_, sort)| *sort);
        bound.or_else(|| self.constants.get(name).copied())
    }

    /// Reads a polynomial; facts, `[name]`, are atoms where they are allowed.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn poly(&self, text: &str, vars: &Vars, facts: bool) -> Result<Poly> {
        let mut parser =
            Parser { signature: self, vars, facts, rest: text.trim_start_matches(' ') };
        let poly = parser.sum(0).or_else(|reason| fault(RULE, reason))?;
        let rest = parser.rest;
        ensure!(rest.is_empty(), RULE, "`{text:.60}`: unexpected `{rest:.20}`");
        Ok(poly)
    }

    /// Reads two polynomials with `>=`, `>`, `=`, `<=` or `<` between.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn literal(&self, text: &str, vars: &Vars) -> Result<Literal> {
        for (sign, relation, turned) in [
            (">=", Relation::NonNegative, false),
            ("<=", Relation::NonNegative, true),
            (">", Relation::Positive, false),
            ("<", Relation::Positive, true),
            ("=", Relation::Zero, false),
        ] {
            if let Some((left, right)) = text.split_once(sign) {
                let (l, r) = (self.poly(left, vars, false)?, self.poly(right, vars, false)?);
                let poly = if turned { r - &l } else { l - &r };
                return Ok(Literal { poly, relation });
            }
        }
        fault(RULE, format!("`{text:.60}`: expected a relation"))
    }
}

type Parsed<T> = std::result::Result<T, String>;

struct Parser<'t> {
    signature: &'t Signature,
    vars: &'t Vars,
    facts: bool,
    rest: &'t str,
}

impl<'t> Parser<'t> {
    fn take(&mut self, wanted: &str) -> bool {
        let found = self.rest.strip_prefix(wanted);
        self.rest = found.map_or(self.rest, |rest| rest.trim_start_matches(' '));
        found.is_some()
    }

    fn expect(&mut self, wanted: &str) -> Parsed<()> {
        match self.take(wanted) {
            true => Ok(()),
            false => Err(format!("expected `{wanted}` before `{:.20}`", self.rest)),
        }
    }

    /// The longest beginning of such characters.
    fn word(&mut self, is: impl Fn(char) -> bool) -> Parsed<&'t str> {
        let end = self.rest.find(|c| !is(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start_matches(' ');
        if word.is_empty() || !charge(128) {
            return Err(format!("expected a number, a name or `(` before `{:.20}`", self.rest));
        }
        Ok(word)
    }

    /// `[-] product (+|- product)*`
    fn sum(&mut self, depth: usize) -> Parsed<Poly> {
        if depth > MAX_DEPTH {
            return Err(format!("more than {MAX_DEPTH} brackets within brackets"));
        }
        let minus = self.take("-");
        let first = self.product(depth)?;
        let mut sum = if minus { Poly::default() - &first } else { first };
        loop {
            if self.take("+") {
                sum = sum + &self.product(depth)?;
            } else if self.take("-") {
                sum = sum - &self.product(depth)?;
            } else {
                return Ok(sum);
            }
        }
    }

    /// `factor (* factor)*`
    fn product(&mut self, depth: usize) -> Parsed<Poly> {
        let mut product = self.factor(depth)?;
        while self.take("*") {
            product = product * &self.factor(depth)?;
        }
        Ok(product)
    }

    /// `number | name | name(sum, ...) | [fact] | (sum)`
    fn factor(&mut self, depth: usize) -> Parsed<Poly> {
        if self.take("(") {
            let inside = self.sum(depth + 1)?;
            return self.expect(")").map(|()| inside);
        }
        if self.facts && self.take("[") {
            let name = self.word(|c| c.is_ascii_alphanumeric() || ".-".contains(c))?;
            return self.expect("]").map(|()| Poly::atom(Atom::Fact(name.into())));
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            return Ok(Poly::constant(Number::read(
                self.word(|c| c.is_ascii_digit() || c == '/')?,
            )?));
        }
        let name = self.word(|c| c.is_ascii_alphanumeric())?;
        if name.len() > MAX_NAME {
            return Err(format!("a name of {} characters: at most {MAX_NAME}", name.len()));
        }
        if !self.take("(") {
            let known = self.signature.sort(name, self.vars).map(|_| Poly::var(name));
            return known.ok_or(format!("`{name}` is no variable or constant here"));
        }
        let mut terms = vec![self.sum(depth + 1)?];
        while self.take(",") {
            terms.push(self.sum(depth + 1)?);
        }
        self.expect(")")?;
        match self.signature.functions.get(name) {
            Some((arity, _)) if *arity == terms.len() => {}
            Some((arity, _)) => return Err(format!("`{name}` takes {arity} terms")),
            None => return Err(format!("`{name}` is no function here")),
        }
        match terms.iter().all(|t| self.signature.is_integer(t, self.vars)) {
            true => Ok(Poly::app(name, &terms)),
            false => Err(format!("a term of `{name}` is no integer")),
        }
    }
}

/// What each is, joined by that word.
pub fn joined<T: ToString>(each: impl IntoIterator<Item = T>, by: &str) -> String {
    each.into_iter().map(|one| one.to_string()).collect::<Vec<_>>().join(by)
}

impl fmt::Display for Poly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (n, (monomial, c)) in self.terms().enumerate() {
            let sign = if c.is_positive() { " + " } else { " - " };
            f.write_str(if n > 0 { sign } else { sign.trim().trim_start_matches('+') })?;
            match (c.magnitude(), joined(monomial, "*")) {
                (c, atoms) if atoms.is_empty() => c.fmt(f)?,
                (c, atoms) if c == Number::whole(1) => f.write_str(&atoms)?,
                (c, atoms) => write!(f, "{c}*{atoms}")?,
            }
        }
        if self.is_zero() { f.write_str("0") } else { Ok(()) }
    }
}

impl fmt::Display for Atom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Var(name) => f.write_str(name),
            Self::Fact(name) => write!(f, "[{name}]"),
            Self::App(name, terms) => write!(f, "{name}({})", joined(&**terms, ",")),
        }
    }
}

/// Positive terms to the left, negative ones to the right.
impl fmt::Display for Literal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let side = |positive| self.poly.part(|c| c.is_positive() == positive);
        let sign = match self.relation {
            Relation::Positive => ">",
            Relation::NonNegative => ">=",
            Relation::Zero => "=",
        };
        write!(f, "{} {sign} {}", side(true), Poly::default() - &side(false))
    }
}
