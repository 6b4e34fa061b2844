//! Expressions about agents, read and written: `x(i) + eps*(x(i-1) - x(i))`.

use std::cell::RefCell;

use num_traits::Zero;

use cordon_core::linear::feasible::Sign;
use cordon_core::scalar::{Monomial, Polynomial};
use cordon_core::system::expression::{add_term, or_zero};
use cordon_core::{Error, Rational, Result, exact};
use cordon_spec::Scalar;

/// An agent: so many places after the first, after agent i, or (not positive) after the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// Agent o.
    First(i64),
    /// Agent i + o.
    Inner(i64),
    /// Agent last + o.
    Last(i64),
}

/// What an expression is made of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Symbol {
    /// A parameter, `last` or `i`.
    Name(String),
    /// A variable of an agent.
    At(String, Place),
}

/// A polynomial and its relation to 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Literal {
    pub poly: Polynomial,
    pub sign: Sign,
}

/// The symbols by number.
#[derive(Debug, Default)]
pub struct Symbols(RefCell<Vec<Symbol>>);

impl Symbols {
    /// The polynomial that is just the symbol.
    pub fn variable(&self, symbol: Symbol) -> Polynomial {
        let mut all = self.0.borrow_mut();
        let known = all.iter().position(|s| *s == symbol);
        let number = known.unwrap_or_else(|| {
            all.push(symbol);
            all.len() - 1
        });
        Polynomial::variable(u32::try_from(number).unwrap_or(u32::MAX))
    }

    /// The factors of a monomial, a power as a repetition.
    pub fn factors(&self, m: &Monomial) -> Vec<Symbol> {
        let all = self.0.borrow();
        let power = |(v, e): (u32, u32)| {
            let symbol = all.get(v as usize).cloned();
            std::iter::repeat_n(symbol, e as usize).flatten()
        };
        m.powers().flat_map(power).collect()
    }

    /// The polynomial with polynomials in the place of symbols.
    pub fn with(&self, p: &Polynomial, value: &dyn Fn(&Symbol) -> Polynomial) -> Polynomial {
        p.terms().fold(Polynomial::default(), |sum, (m, c)| {
            let factors = self.factors(m);
            sum + &factors.iter().fold(Polynomial::constant(c.clone()), |p, s| p * &value(s))
        })
    }

    /// The agents' variables that occur, each once.
    pub fn agents(&self, p: &Polynomial) -> Vec<(String, Place)> {
        let mut found = Vec::new();
        for symbol in p.terms().flat_map(|(m, _)| self.factors(m)) {
            if let Symbol::At(name, place) = symbol
                && !found.contains(&(name.clone(), place))
            {
                found.push((name, place));
            }
        }
        found
    }

    /// What a variable of an agent is multiplied by.
    pub fn slope(&self, p: &Polynomial, of: &(String, Place)) -> Polynomial {
        let at = |one: i32| {
            self.with(p, &|s| match s {
                Symbol::At(name, place) if (name, place) == (&of.0, &of.1) => {
                    Polynomial::from_int(one)
                }
                Symbol::At(..) => Polynomial::from_int(0),
                name => self.variable(name.clone()),
            })
        };
        at(1) - &at(0)
    }

    /// The polynomial in the checker's syntax, agents at step `time`.
    pub fn write(&self, p: &Polynomial, time: &str) -> String {
        let mut text = String::new();
        for (m, c) in p.terms() {
            let factors: Vec<String> = self.factors(m).iter().map(|s| s.written(time)).collect();
            add_term(&mut text, c, &factors.iter().map(String::as_str).collect::<Vec<_>>());
        }
        or_zero(text)
    }
}

impl Symbol {
    fn written(&self, time: &str) -> String {
        match self {
            Self::Name(name) => name.clone(),
            Self::At(name, place) => format!("{name}({time},{})", place.written()),
        }
    }
}

impl Place {
    /// As a term of the checker's.
    pub fn written(self) -> String {
        let offset = |base: &str, o: i64| match o {
            0 => base.to_owned(),
            1.. => format!("{base}+{o}"),
            _ => format!("{base}{o}"),
        };
        match self {
            Self::First(o) => o.to_string(),
            Self::Inner(o) => offset("i", o),
            Self::Last(o) => offset("last", o),
        }
    }

    /// The place so much further on.
    pub fn plus(self, by: i64) -> Self {
        match self {
            Self::First(o) => Self::First(o + by),
            Self::Inner(o) => Self::Inner(o + by),
            Self::Last(o) => Self::Last(o + by),
        }
    }
}

/// Reads expressions about agents with these variables and these constants.
pub struct Reader<'f> {
    pub symbols: &'f Symbols,
    pub state: &'f [String],
    pub constants: &'f dyn Fn(&str) -> bool,
}

impl Reader<'_> {
    /// Two expressions with `<`, `<=`, `=`, `>=` or `>` between.
    pub fn literal(&self, text: &str) -> Result<Literal> {
        let relations = [
            (">=", Sign::NonNegative, false),
            ("<=", Sign::NonNegative, true),
            (">", Sign::Positive, false),
            ("<", Sign::Positive, true),
            ("=", Sign::Zero, false),
        ];
        for (relation, sign, turned) in relations {
            if let Some((left, right)) = text.split_once(relation) {
                let (left, right) = (self.polynomial(left)?, self.polynomial(right)?);
                let poly = if turned { right - &left } else { left - &right };
                return Ok(Literal { poly, sign });
            }
        }
        Err(Error::input(format!(
            "`{}`: expected `<`, `<=`, `=`, `>=` or `>`",
            exact::shortened(text)
        )))
    }

    /// A sum of products.
    pub fn polynomial(&self, text: &str) -> Result<Polynomial> {
        let mut parser = Parser { reader: self, rest: text.trim_start(), depth: 0 };
        match parser.sum() {
            Some(p) if parser.rest.is_empty() => Ok(p),
            _ => {
                let at = parser.rest.chars().take(12).collect::<String>();
                let text = exact::shortened(text);
                Err(Error::input(format!(
                    "`{text}`: expected sums and products of numbers, parameters and agents like `x(i-1)`, at `{at}`"
                )))
            }
        }
    }
}

struct Parser<'r, 't> {
    reader: &'r Reader<'r>,
    rest: &'t str,
    depth: usize,
}

impl<'t> Parser<'_, 't> {
    fn take(&mut self, sign: char) -> bool {
        let found = self.rest.strip_prefix(sign);
        self.rest = found.unwrap_or(self.rest).trim_start();
        found.is_some()
    }

    fn word(&mut self, is: impl Fn(char) -> bool) -> Option<&'t str> {
        let end = self.rest.find(|c| !is(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start();
        (!word.is_empty()).then_some(word)
    }

    fn sum(&mut self) -> Option<Polynomial> {
        self.depth += 1;
        if self.depth > 30 {
            return None;
        }
        let mut sum = Polynomial::default();
        let mut minus = self.take('-');
        loop {
            let mut product = self.factor()?;
            while self.take('*') {
                product = product * &self.factor()?;
            }
            sum = if minus { sum - &product } else { sum + &product };
            minus = self.take('-');
            if !minus && !self.take('+') {
                self.depth -= 1;
                return Some(sum);
            }
        }
    }

    fn factor(&mut self) -> Option<Polynomial> {
        if self.take('(') {
            let inside = self.sum()?;
            return self.take(')').then_some(inside);
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            let number = self.word(|c| c.is_ascii_digit() || "./".contains(c))?;
            return exact::parse("number", number).ok().map(Polynomial::constant);
        }
        let before = self.rest;
        let name = self.word(|c| c.is_ascii_alphanumeric())?;
        if self.reader.state.iter().any(|s| s == name) && self.take('(') {
            let place = place(self.word(|c| c != ')')?)?;
            let symbol = Symbol::At(name.to_owned(), place);
            return self.take(')').then(|| self.reader.symbols.variable(symbol));
        }
        let known = name == "last" || name == "i" || (self.reader.constants)(name);
        self.rest = if known { self.rest } else { before };
        known.then(|| self.reader.symbols.variable(Symbol::Name(name.to_owned())))
    }
}

fn place(text: &str) -> Option<Place> {
    let text: String = text.split_whitespace().collect();
    let offset = |rest: &str| match rest {
        "" => Some(0),
        _ => rest.parse::<i64>().ok().filter(|o| o.abs() < 1_000),
    };
    if let Some(rest) = text.strip_prefix("last") {
        offset(rest).filter(|o| *o <= 0).map(Place::Last)
    } else if let Some(rest) = text.strip_prefix('i') {
        offset(rest).map(Place::Inner)
    } else {
        text.parse().ok().filter(|o| (0..1_000).contains(o)).map(Place::First)
    }
}

/// The number that a polynomial without symbols is.
pub fn constant(p: &Polynomial) -> Option<Rational> {
    match p.terms().next() {
        None => Some(Rational::zero()),
        Some((m, c)) => (m.degree() == 0 && p.terms().count() == 1).then(|| c.clone()),
    }
}
