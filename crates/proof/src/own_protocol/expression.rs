//! Expressions in a user's protocol file: sums and products of numbers, `eps` and positions.

use cordon_spec::Scalar;
use num_traits::Zero;

use cordon_core::Rational;
use cordon_core::exact;
use cordon_core::linear::feasible::Sign;

/// An expression. It is evaluated on any scalars: exact numbers, forms, polynomials.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expression {
    /// A constant.
    Number(Rational),
    /// The weight.
    Eps,
    /// The position of a drone.
    Position(usize),
    /// Left plus right.
    Sum(Box<[Expression; 2]>),
    /// Left minus right.
    Difference(Box<[Expression; 2]>),
    /// Left times right.
    Product(Box<[Expression; 2]>),
}

/// The largest power of eps, and of positions together, in an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Degree {
    /// In eps.
    pub eps: u32,
    /// In the positions.
    pub positions: u32,
}

/// What is compared in a claim, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// What is said to be nonnegative, positive or zero.
    pub difference: Expression,
    /// `<`, `<=` or `=` as signs of the difference.
    pub relation: Sign,
}

/// What is wrong with an expression, and at which character.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SyntaxError {
    /// Offset in bytes.
    pub at: usize,
    /// In words.
    pub message: String,
}

impl Expression {
    /// The value where the weight is `eps` and the positions are `x`; `number` embeds
    /// constants. Positions are below `x.len()`, which the parser sees to.
    pub fn value<S: Scalar>(&self, number: &impl Fn(&Rational) -> S, eps: &S, x: &[S]) -> S {
        let both = |pair: &[Self; 2]| {
            let [a, b] = pair;
            (a.value(number, eps, x), b.value(number, eps, x))
        };
        match self {
            Self::Number(value) => number(value),
            Self::Eps => eps.clone(),
            Self::Position(i) => x.get(*i).cloned().unwrap_or_else(|| S::from_int(0)),
            Self::Sum(pair) => {
                let (a, b) = both(pair);
                a + &b
            }
            Self::Difference(pair) => {
                let (a, b) = both(pair);
                a - &b
            }
            Self::Product(pair) => {
                let (a, b) = both(pair);
                a * &b
            }
        }
    }

    /// The degree as written: products that cancel count all the same.
    pub fn degree(&self) -> Degree {
        let both = |pair: &[Self; 2]| pair.each_ref().map(Self::degree);
        let none = Degree { eps: 0, positions: 0 };
        match self {
            Self::Number(_) => none,
            Self::Eps => Degree { eps: 1, ..none },
            Self::Position(_) => Degree { positions: 1, ..none },
            Self::Sum(pair) | Self::Difference(pair) => {
                let [a, b] = both(pair);
                Degree { eps: a.eps.max(b.eps), positions: a.positions.max(b.positions) }
            }
            Self::Product(pair) => {
                let [a, b] = both(pair);
                Degree {
                    eps: a.eps.saturating_add(b.eps),
                    positions: a.positions.saturating_add(b.positions),
                }
            }
        }
    }

    /// Reads an expression about `count` drones.
    ///
    /// # Errors
    /// Anything else, with the place.
    pub fn parse(text: &str, count: usize) -> Result<Self, SyntaxError> {
        let mut parser = Parser { text, at: 0, count, depth: 0 };
        let expression = parser.sum()?;
        parser.end()?;
        Ok(expression)
    }
}

/// Reads a claim: expressions with `<`, `<=`, `=`, `>=`, `>` between, two or more
/// (`x0 < x1 <= 1`). One comparison for every relation sign.
///
/// # Errors
/// Anything else, with the place.
pub fn parse_claim(text: &str, count: usize) -> Result<Vec<Comparison>, SyntaxError> {
    let mut parser = Parser { text, at: 0, count, depth: 0 };
    let mut left = parser.sum()?;
    let mut comparisons = Vec::new();
    while let Some((sign, relation, descending)) = parser.relation() {
        parser.at += sign.len();
        let right = parser.sum()?;
        let pair = if descending { [left, right.clone()] } else { [right.clone(), left] };
        comparisons.push(Comparison { difference: Expression::Difference(pair.into()), relation });
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

struct Parser<'t> {
    text: &'t str,
    at: usize,
    count: usize,
    depth: usize,
}

impl Parser<'_> {
    fn rest(&mut self) -> &str {
        let rest = self.text.get(self.at..).unwrap_or_default();
        let trimmed = rest.trim_start();
        self.at += rest.len() - trimmed.len();
        trimmed
    }

    fn fault(&mut self, message: &str) -> SyntaxError {
        let found: String = self.rest().chars().take(12).collect();
        let found = if found.is_empty() { "the end".to_owned() } else { format!("`{found}`") };
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
        let rest = self.rest().to_owned();
        signs.into_iter().find(|(sign, ..)| rest.starts_with(sign))
    }

    fn take(&mut self, sign: char) -> bool {
        let found = self.rest().starts_with(sign);
        if found {
            self.at += sign.len_utf8();
        }
        found
    }

    fn sum(&mut self) -> Result<Expression, SyntaxError> {
        let mut total = self.product()?;
        loop {
            if self.take('+') {
                total = Expression::Sum([total, self.product()?].into());
            } else if self.take('-') {
                total = Expression::Difference([total, self.product()?].into());
            } else {
                return Ok(total);
            }
        }
    }

    fn product(&mut self) -> Result<Expression, SyntaxError> {
        let mut total = self.factor()?;
        loop {
            if self.take('*') {
                total = Expression::Product([total, self.factor()?].into());
            } else if self.take('/') {
                let divisor = self.factor()?;
                let Expression::Number(divisor) = divisor else {
                    return Err(self.fault("expected a number to divide by before this"));
                };
                if divisor.is_zero() {
                    return Err(self.fault("a division by zero before this"));
                }
                let inverse = Expression::Number(divisor.recip());
                total = match total {
                    // `1/3` is a number, and may divide.
                    Expression::Number(n) => Expression::Number(n / divisor),
                    total => Expression::Product([total, inverse].into()),
                };
            } else {
                return Ok(total);
            }
        }
    }

    fn factor(&mut self) -> Result<Expression, SyntaxError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.fault("is nested too deeply"));
        }
        let factor = self.atom();
        self.depth -= 1;
        factor
    }

    fn atom(&mut self) -> Result<Expression, SyntaxError> {
        if self.take('-') {
            let zero = Expression::Number(Rational::zero());
            return Ok(match self.factor()? {
                Expression::Number(n) => Expression::Number(-n),
                other => Expression::Difference([zero, other].into()),
            });
        }
        if self.take('(') {
            let inner = self.sum()?;
            return if self.take(')') { Ok(inner) } else { Err(self.fault("expected `)`")) };
        }
        let word: String = self
            .rest()
            .chars()
            .take_while(|c| c.is_ascii_alphanumeric() || *c == '.' || *c == '_')
            .collect();
        let atom = self.word(&word)?;
        self.at += word.len();
        Ok(atom)
    }

    fn word(&mut self, word: &str) -> Result<Expression, SyntaxError> {
        if word == "eps" {
            return Ok(Expression::Eps);
        }
        if word.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            let number = exact::parse("number", word);
            return number.map(Expression::Number).map_err(|_| self.fault("expected a number"));
        }
        let index = word.strip_prefix('x').and_then(|i| i.parse::<usize>().ok());
        match index {
            Some(i) if i < self.count => Ok(Expression::Position(i)),
            Some(i) => {
                let last = self.count.saturating_sub(1);
                let message = format!("`x{i}` is no drone: expected x0 to x{last}");
                Err(SyntaxError { at: self.at, message })
            }
            None => Err(self.fault("expected a number, `eps`, a position like `x0`, or `(`")),
        }
    }
}
