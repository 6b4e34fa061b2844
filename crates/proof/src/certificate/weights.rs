//! Sums of products of facts with numbers: nonnegative by their form, and values at the same time.

use std::collections::BTreeMap;

use num_traits::{One, Zero};

use cordon_core::Rational;
use cordon_core::exact::fraction;
use cordon_core::system::expression::add_term;

/// Something that is multiplied: a fact and what it is, or only the latter.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Factor {
    /// What it is, as text.
    pub value: String,
    /// The fact that it is nonnegative (or a sum of facts), as text.
    pub fact: Option<String>,
}

impl Factor {
    /// A fact with its value.
    pub fn new(value: impl Into<String>, fact: impl Into<String>) -> Self {
        Self { value: value.into(), fact: Some(fact.into()) }
    }
}

/// A sum of products with numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sum(BTreeMap<Vec<Factor>, Rational>);

impl Sum {
    /// A number.
    pub fn number(c: Rational) -> Self {
        Self::of([(c, Vec::new())])
    }

    /// A factor alone.
    pub fn factor(factor: Factor) -> Self {
        Self::of([(Rational::one(), vec![factor])])
    }

    /// A sum of these products.
    pub fn of(terms: impl IntoIterator<Item = (Rational, Vec<Factor>)>) -> Self {
        let mut sum = Self::default();
        for (c, factors) in terms {
            sum.add_term(factors, c);
        }
        sum
    }

    fn add_term(&mut self, mut factors: Vec<Factor>, c: Rational) {
        factors.sort_unstable();
        let entry = self.0.entry(factors);
        let total = entry.or_insert_with(Rational::zero);
        *total += c;
    }

    /// Adds a number times another sum.
    pub fn add(&mut self, c: &Rational, other: &Self) {
        for (factors, d) in &other.0 {
            self.add_term(factors.clone(), c * d);
        }
    }

    /// The product with another sum.
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (left, c) in &self.0 {
            for (right, d) in &other.0 {
                product.add_term([left.as_slice(), right].concat(), c * d);
            }
        }
        product
    }

    /// Whether it has no product.
    pub fn is_zero(&self) -> bool {
        self.0.values().all(Zero::is_zero)
    }

    /// What it is, as text.
    pub fn value(&self) -> String {
        self.text(|f| Some(f.value.as_str())).unwrap_or_default()
    }

    /// Why it is nonnegative: the sum in facts. `None` where a factor is no fact.
    pub fn facts(&self) -> Option<String> {
        self.text(|f| f.fact.as_deref())
    }

    fn text<'s>(&'s self, word: impl Fn(&'s Factor) -> Option<&'s str>) -> Option<String> {
        let mut text = String::new();
        for (factors, c) in self.0.iter().filter(|(_, c)| !c.is_zero()) {
            let words = factors.iter().map(&word).collect::<Option<Vec<_>>>()?;
            add_term(&mut text, c, &words);
        }
        Some(if text.is_empty() { fraction(&Rational::zero()) } else { text })
    }
}

/// What has these values at the vertices of a box, and is affine between them in each range: as a sum over products of the
/// distances from the ranges' ends. Vertices are in the order of the ranges, low before high, the last changing
/// fastest; ranges on which nothing depends are left out.
pub fn spread(values: &[Rational], ranges: &[Range]) -> Sum {
    let Some(first) = values.first() else { return Sum::default() };
    let Some((range, rest)) = ranges.split_first().filter(|_| values.iter().any(|v| v != first))
    else {
        return Sum::number(first.clone());
    };
    let (low, high) = values.split_at(values.len() / 2);
    if low == high {
        return spread(low, rest);
    }
    let scale = Sum::number(range.width.recip());
    let part = |values, factor: &Factor| {
        spread(values, rest).times(&Sum::factor(factor.clone())).times(&scale)
    };
    let mut sum = part(low, &range.below_high);
    sum.add(&Rational::one(), &part(high, &range.above_low));
    sum
}

/// A parameter's distances from the ends of its range.
#[derive(Clone, Debug)]
pub struct Range {
    /// High end minus low end, above 0.
    pub width: Rational,
    /// The parameter minus the low end.
    pub above_low: Factor,
    /// The high end minus the parameter.
    pub below_high: Factor,
}
