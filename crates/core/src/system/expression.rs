//! The expressions of protocol files: sums and products of numbers, parameters and states.
//!
//! ```text
//! comparison = sum (("<" | "<=" | "=" | ">=" | ">") sum)+
//! sum        = product (("+" | "-") product)*
//! product    = factor (("*" | "/") factor)*           a divisor is a number
//! factor     = "-" factor | "(" sum ")" | number | name | name "." name | name "[" sum "]" | "sum" "(" sum ")"
//! ```
//!
//! The meaning of names is given by a [`Meaning`]; the value of an expression is a polynomial.

use num_traits::{One, Signed, Zero};

use crate::exact::{self, fraction};
use crate::linear::feasible::Sign;
use crate::scalar::{Monomial, Polynomial};
use crate::{Rational, text::cut};

/// An expression with the places of its names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expression {
    node: Node,
    at: usize,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Node {
    Number(Rational),
    Name(String),
    Member(String, String),
    Indexed(String, Box<Expression>),
    Sum(Box<Expression>),
    Plus(Box<[Expression; 2]>),
    Minus(Box<[Expression; 2]>),
    Times(Box<[Expression; 2]>),
    Over(Box<[Expression; 2]>),
}

/// A comparison of two expressions, as a condition on `greater - less`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// The side that is claimed to be no less.
    pub greater: Expression,
    /// The side that is claimed to be no greater.
    pub less: Expression,
    /// `<`, `<=` or `=` as the sign of the difference.
    pub relation: Sign,
}

/// An error in an expression, and where it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SyntaxError {
    /// Where the error is, in bytes from the beginning of the text.
    pub at: usize,
    /// What was found there and what was expected.
    pub message: String,
}

/// What the names of an expression stand for. Errors are messages; the caller adds the place.
pub trait Meaning {
    /// `name`
    ///
    /// # Errors
    /// There is nothing of that name.
    fn name(&self, name: &str) -> Result<Polynomial, String>;

    /// `owner.name`
    ///
    /// # Errors
    /// There is none.
    fn member(&self, owner: &str, _name: &str) -> Result<Polynomial, String> {
        Err(format!("`{owner}.` is not defined here"))
    }

    /// `name[index]`
    ///
    /// # Errors
    /// There is none.
    fn indexed(&self, name: &str, _index: &Rational) -> Result<Polynomial, String> {
        Err(format!("`{name}[..]` is not defined here"))
    }

    /// `sum(inner)`
    ///
    /// # Errors
    /// There is nothing to sum over, or `inner` is wrong.
    fn sum(&self, _inner: &Expression) -> Result<Polynomial, SyntaxError> {
        Err(SyntaxError { at: 0, message: "`sum` is not defined here".to_owned() })
    }
}

/// How the names of an expression are written in another syntax. Errors are messages; the caller adds
/// the place.
pub trait Words {
    /// `name`
    ///
    /// # Errors
    /// It has no counterpart.
    fn name(&self, name: &str) -> Result<String, String>;

    /// `owner.name`
    ///
    /// # Errors
    /// It has no counterpart.
    fn member(&self, owner: &str, name: &str) -> Result<String, String>;

    /// `name[index]`
    ///
    /// # Errors
    /// It has no counterpart.
    fn indexed(&self, name: &str, index: &Expression) -> Result<String, String>;

    /// `sum(inner)`
    ///
    /// # Errors
    /// It has no counterpart.
    fn sum(&self, inner: &Expression) -> Result<String, String>;
}

/// The meaning of constant expressions: no name is defined.
struct Numbers;

impl Meaning for Numbers {
    fn name(&self, name: &str) -> Result<Polynomial, String> {
        Err(format!("`{name}`: expected a number"))
    }
}

impl Expression {
    /// The expression in another syntax: sums and products in brackets, fractions as numbers.
    ///
    /// # Errors
    /// A name that has no counterpart there.
    pub fn written(&self, words: &impl Words) -> Result<String, SyntaxError> {
        let placed = |message| SyntaxError { at: self.at, message };
        let both = |pair: &[Self; 2]| {
            let [a, b] = pair;
            Ok((a.written(words)?, b.written(words)?))
        };
        match &self.node {
            Node::Number(n) if n.is_negative() => Ok(format!("(0 - {})", fraction(&n.abs()))),
            Node::Number(n) => Ok(fraction(n)),
            Node::Name(name) => words.name(name).map_err(placed),
            Node::Member(owner, name) => words.member(owner, name).map_err(placed),
            Node::Indexed(name, index) => words.indexed(name, index).map_err(placed),
            Node::Sum(inner) => words.sum(inner).map_err(placed),
            Node::Plus(pair) => both(pair).map(|(a, b)| format!("({a} + {b})")),
            Node::Minus(pair) => both(pair).map(|(a, b)| format!("({a} - {b})")),
            Node::Times(pair) => both(pair).map(|(a, b)| format!("{a}*{b}")),
            Node::Over(pair) => {
                let [a, b] = &**pair;
                match number(&b.value(&Numbers)?) {
                    Some(d) if !d.is_zero() => {
                        let factor = Self { node: Node::Number(d.recip()), at: self.at };
                        Ok(format!("{}*{}", a.written(words)?, factor.written(words)?))
                    }
                    _ => Err(placed("expected a number other than 0 to divide by".to_owned())),
                }
            }
        }
    }

    /// Reads an expression.
    ///
    /// # Errors
    /// Anything else, with the place.
    pub fn parse(text: &str) -> Result<Self, SyntaxError> {
        let mut parser = Parser { text, at: 0, depth: 0, atoms: 0 };
        let expression = parser.sum()?;
        parser.end()?;
        Ok(expression)
    }

    /// Its value.
    ///
    /// # Errors
    /// An undefined name, or a divisor that is not a nonzero number.
    pub fn value(&self, meaning: &impl Meaning) -> Result<Polynomial, SyntaxError> {
        let placed = |message| SyntaxError { at: self.at, message };
        let both = |pair: &[Self; 2]| {
            let [a, b] = pair;
            Ok((a.value(meaning)?, b.value(meaning)?))
        };
        match &self.node {
            Node::Number(n) => Ok(Polynomial::constant(n.clone())),
            Node::Name(name) => meaning.name(name).map_err(placed),
            Node::Member(owner, name) => meaning.member(owner, name).map_err(placed),
            Node::Indexed(name, index) => {
                let index = number(&index.value(meaning)?)
                    .ok_or_else(|| placed(format!("`{name}[..]`: expected a number within")))?;
                meaning.indexed(name, &index).map_err(placed)
            }
            Node::Sum(inner) => meaning.sum(inner).map_err(|e| match e.at {
                0 => SyntaxError { at: self.at, ..e },
                _ => e,
            }),
            Node::Plus(pair) => both(pair).map(|(a, b)| a + &b),
            Node::Minus(pair) => both(pair).map(|(a, b)| a - &b),
            Node::Times(pair) => both(pair).map(|(a, b)| a * &b),
            Node::Over(pair) => {
                let (a, b) = both(pair)?;
                match number(&b) {
                    Some(d) if !d.is_zero() => Ok(a * &Polynomial::constant(d.recip())),
                    Some(_) => Err(placed("a division by zero".to_owned())),
                    None => Err(placed("expected a number to divide by".to_owned())),
                }
            }
        }
    }
}

/// The polynomial's value, where it is a number.
pub fn number(p: &Polynomial) -> Option<Rational> {
    let constant = p.coefficient(&Monomial::default());
    (p.terms().all(|(m, _)| m.degree() == 0)).then_some(constant)
}

/// Adds a coefficient times factors to a sum in words.
pub fn add_term(text: &mut String, c: &Rational, factors: &[&str]) {
    *text += match (c.is_negative(), text.is_empty()) {
        (true, true) => "-",
        (true, false) => " - ",
        (false, true) => "",
        (false, false) => " + ",
    };
    let number = fraction(&c.abs());
    let shown = !c.abs().is_one() || factors.is_empty();
    let all: Vec<&str> =
        shown.then_some(&*number).into_iter().chain(factors.iter().copied()).collect();
    *text += &all.join("*");
}

/// The text of a sum, `0` where it has no terms.
pub fn or_zero(text: String) -> String {
    if text.is_empty() { "0".to_owned() } else { text }
}

/// A sum in words: each term given by its coefficient and the names of its factors.
pub fn sum_text<'t>(terms: impl IntoIterator<Item = (&'t Rational, Vec<&'t str>)>) -> String {
    let mut text = String::new();
    for (c, factors) in terms {
        add_term(&mut text, c, &factors);
    }
    or_zero(text)
}

/// Reads comparisons: expressions with `<`, `<=`, `=`, `>=`, `>` between, two or more
/// (`x[0] < x[1] <= 1`). One comparison for every relation sign.
///
/// # Errors
/// Anything else, with the place.
pub fn comparisons(text: &str) -> Result<Vec<Comparison>, SyntaxError> {
    let mut parser = Parser { text, at: 0, depth: 0, atoms: 0 };
    let mut left = parser.sum()?;
    let mut comparisons = Vec::new();
    while let Some((sign, relation, descending)) = parser.relation() {
        parser.at += sign.len();
        let right = parser.sum()?;
        let (greater, less) =
            if descending { (left, right.clone()) } else { (right.clone(), left) };
        comparisons.push(Comparison { greater, less, relation });
        left = right;
    }
    if comparisons.is_empty() {
        return Err(parser.fault("expected `<`, `<=`, `=`, `>=` or `>`"));
    }
    parser.end()?;
    Ok(comparisons)
}

/// Deepest nesting of parentheses and signs.
const DEEPEST: usize = 100;

/// Most numbers and names in an expression: evaluation recurses once per term of a sum.
const LONGEST: usize = 2_000;

struct Parser<'t> {
    text: &'t str,
    at: usize,
    depth: usize,
    atoms: usize,
}

impl<'t> Parser<'t> {
    fn rest(&mut self) -> &'t str {
        let rest = self.text.get(self.at..).unwrap_or_default();
        let trimmed = rest.trim_start();
        self.at += rest.len() - trimmed.len();
        trimmed
    }

    fn fault(&mut self, message: &str) -> SyntaxError {
        let found = match self.rest() {
            "" => "the end".to_owned(),
            rest => format!("`{}`", cut(rest, 12)),
        };
        SyntaxError { at: self.at, message: format!("{message}, found {found}") }
    }

    fn end(&mut self) -> Result<(), SyntaxError> {
        if self.rest().is_empty() {
            Ok(())
        } else {
            Err(self.fault("expected an operator or the end"))
        }
    }

    fn relation(&mut self) -> Option<(&'static str, Sign, bool)> {
        let signs = [
            ("<=", Sign::NonNegative, false),
            (">=", Sign::NonNegative, true),
            ("<", Sign::Positive, false),
            (">", Sign::Positive, true),
            ("=", Sign::Zero, false),
        ];
        let rest = self.rest();
        signs.into_iter().find(|(sign, ..)| rest.starts_with(sign))
    }

    fn take(&mut self, sign: char) -> bool {
        let found = self.rest().starts_with(sign);
        if found {
            self.at += sign.len_utf8();
        }
        found
    }

    fn expect(&mut self, sign: char) -> Result<(), SyntaxError> {
        if self.take(sign) { Ok(()) } else { Err(self.fault(&format!("expected `{sign}`"))) }
    }

    fn sum(&mut self) -> Result<Expression, SyntaxError> {
        let mut total = self.product()?;
        loop {
            let at = self.at;
            let node = if self.take('+') {
                Node::Plus([total, self.product()?].into())
            } else if self.take('-') {
                Node::Minus([total, self.product()?].into())
            } else {
                return Ok(total);
            };
            total = Expression { node, at };
        }
    }

    fn product(&mut self) -> Result<Expression, SyntaxError> {
        let mut total = self.factor()?;
        loop {
            let at = self.at;
            let node = if self.take('*') {
                Node::Times([total, self.factor()?].into())
            } else if self.take('/') {
                Node::Over([total, self.factor()?].into())
            } else {
                return Ok(total);
            };
            total = Expression { node, at };
        }
    }

    fn factor(&mut self) -> Result<Expression, SyntaxError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.fault("is nested too deeply"));
        }
        self.atoms += 1;
        if self.atoms > LONGEST {
            let message = format!("expected at most {LONGEST} numbers and names in one expression");
            return Err(SyntaxError { at: self.at, message });
        }
        let factor = self.atom();
        self.depth -= 1;
        factor
    }

    fn atom(&mut self) -> Result<Expression, SyntaxError> {
        self.rest();
        let at = self.at;
        if self.take('-') {
            let zero = Expression { node: Node::Number(Rational::zero()), at };
            let node = Node::Minus([zero, self.factor()?].into());
            return Ok(Expression { node, at });
        }
        if self.take('(') {
            let inner = self.sum()?;
            self.expect(')')?;
            return Ok(inner);
        }
        let rest = self.rest();
        let starts_number = rest.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        let ends = |c: char| !(c.is_ascii_alphanumeric() || (starts_number && c == '.'));
        let mut length = rest.find(ends).unwrap_or(rest.len());
        // The sign of an exponent belongs to the number: `1e-5`.
        if starts_number
            && let Some((_, exponent)) = rest.split_at_checked(length)
            && rest.get(..length).is_some_and(|word| word.ends_with(['e', 'E']))
            && let Some(digits) = exponent.strip_prefix(['+', '-'])
        {
            let is_other = |c: char| !c.is_ascii_digit();
            length += 1 + digits.find(is_other).unwrap_or(digits.len());
        }
        let word = rest.get(..length).unwrap_or_default();
        if starts_number {
            let number =
                exact::parse("number", word).map_err(|_| self.fault("expected a number"))?;
            self.at += word.len();
            return Ok(Expression { node: Node::Number(number), at });
        }
        if word.is_empty() {
            return Err(self.fault("expected a number, a name or `(`"));
        }
        self.at += word.len();
        let node = if word == "sum" && self.take('(') {
            let inner = self.sum()?;
            self.expect(')')?;
            Node::Sum(inner.into())
        } else if self.take('[') {
            let index = self.sum()?;
            self.expect(']')?;
            Node::Indexed(word.to_owned(), index.into())
        } else if self.take('.') {
            let rest = self.rest();
            let end = rest.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(rest.len());
            let name = rest.get(..end).unwrap_or_default();
            if name.is_empty() {
                return Err(self.fault("expected a variable's name"));
            }
            self.at += end;
            Node::Member(word.to_owned(), name.to_owned())
        } else {
            Node::Name(word.to_owned())
        };
        Ok(Expression { node, at })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
mod tests {
    use super::*;

    #[test]
    fn numbers_may_have_exponents() {
        let parsed = |text: &str| Expression::parse(text).map(|e| e.node);
        for (text, p, q) in [("1e5", 100_000, 1), ("1e-5", 1, 100_000), ("2.5E+1", 25, 1)] {
            let Node::Number(x) = parsed(text).unwrap() else { panic!("{text}") };
            assert_eq!(x, Rational::new(p.into(), q.into()), "{text}");
        }
        for text in ["1e-", "1e-x", "1e--5"] {
            assert!(parsed(text).is_err(), "{text}");
        }
        // A name that ends with `e` is no number.
        assert!(parsed("one-5").is_ok());
    }
}
