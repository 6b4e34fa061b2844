//! The spec's own predicates on symbolic placements.
//!
//! Positions are affine forms in the start. Whenever a predicate of the spec compares two of
//! them, an oracle answers: with what the search has assumed so far, or not at all. The spec's
//! three-valued logic then says whether the assumptions decide the predicate. So the theorems
//! are not stated a second time for the search: their comparisons are taken from the code.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};
use std::rc::Rc;

use cordon_spec::{Ordered, Scalar};
use num_traits::Zero;

use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};

/// What has been assumed of the comparisons, in the order in which they are made.
#[derive(Debug, Default)]
struct Oracle {
    answers: Vec<Option<Ordering>>,
    asked: Vec<Affine>,
}

/// An affine form with an oracle for comparisons that the form alone does not decide.
#[derive(Clone, Debug)]
pub struct Symbol {
    form: Affine,
    oracle: Option<Rc<RefCell<Oracle>>>,
}

impl Symbol {
    /// A constant.
    pub fn constant(value: Rational) -> Self {
        Self { form: Affine::constant(value), oracle: None }
    }

    fn combine(self, other: &Self, op: impl Fn(Affine, &Affine) -> Affine) -> Self {
        Self {
            form: op(self.form, &other.form),
            oracle: self.oracle.or_else(|| other.oracle.clone()),
        }
    }
}

impl Add<&Self> for Symbol {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        self.combine(other, |a, b| a + b)
    }
}

impl Sub<&Self> for Symbol {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        self.combine(other, |a, b| a - b)
    }
}

impl Mul<&Self> for Symbol {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        self.combine(other, |a, b| a * b)
    }
}

impl Scalar for Symbol {
    fn from_int(n: i32) -> Self {
        Self { form: Affine::from_int(n), oracle: None }
    }
}

impl Ordered for Symbol {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        let difference = self.form.clone() - &other.form;
        if let Some(value) = difference.as_constant() {
            return Some(value.cmp(&Rational::zero()));
        }
        // What is not affine is not asked about: nothing could be assumed of it.
        difference.parts()?;
        let mut oracle = self.oracle.as_ref().or(other.oracle.as_ref())?.borrow_mut();
        let answer = oracle.answers.get(oracle.asked.len()).copied().flatten();
        oracle.asked.push(difference);
        answer
    }
}

/// Evaluates a predicate on placements given as forms, under the assumed answers. Returns its
/// verdict and the differences that it compared with zero, in order.
pub fn evaluate<V>(
    placements: &[Vec<Affine>],
    answers: &[Option<Ordering>],
    predicate: impl Fn(&[Vec<Symbol>]) -> V,
) -> (V, Vec<Affine>) {
    let oracle = Rc::new(RefCell::new(Oracle { answers: answers.to_vec(), asked: Vec::new() }));
    let symbols: Vec<Vec<Symbol>> = placements
        .iter()
        .map(|x| {
            let symbol =
                |form: &Affine| Symbol { form: form.clone(), oracle: Some(Rc::clone(&oracle)) };
            x.iter().map(symbol).collect()
        })
        .collect();
    let verdict = predicate(&symbols);
    let asked = std::mem::take(&mut oracle.borrow_mut().asked);
    (verdict, asked)
}

/// The constraint that a difference compares with zero as assumed.
pub fn assumption(difference: &Affine, answer: Ordering) -> Constraint {
    let (form, sign) = match answer {
        Ordering::Less => (Affine::from_int(0) - difference, Sign::Positive),
        Ordering::Equal => (difference.clone(), Sign::Zero),
        Ordering::Greater => (difference.clone(), Sign::Positive),
    };
    Constraint { form, sign }
}

/// All answers to one comparison.
pub const ANSWERS: [Ordering; 3] = [Ordering::Less, Ordering::Equal, Ordering::Greater];

/// One comparison of a conjunction: the difference compared with zero, and the answers that
/// alone make the predicate false.
struct Comparison {
    difference: Affine,
    fatal: Vec<Ordering>,
}

/// The comparisons of a predicate that is a conjunction of comparisons; `None` where it is
/// false whatever the start, because constants were compared.
fn comparisons<V>(
    placements: &[Vec<Affine>],
    predicate: impl Fn(&[Vec<Symbol>]) -> V,
    is_false: impl Fn(&V) -> bool,
) -> Option<Vec<Comparison>> {
    let (verdict, asked) = evaluate(placements, &[], &predicate);
    if is_false(&verdict) {
        return None;
    }
    let fatal = |p: usize| {
        let mut answers = vec![None; p];
        answers.push(None);
        let alone = |answer: &Ordering| {
            let mut answers = answers.clone();
            answers[p] = Some(*answer);
            is_false(&evaluate(placements, &answers, &predicate).0)
        };
        ANSWERS.into_iter().filter(alone).collect()
    };
    let each = asked.into_iter().enumerate();
    Some(each.map(|(p, difference)| Comparison { difference, fatal: fatal(p) }).collect())
}

/// For a predicate that is a conjunction of comparisons: every assumption about one comparison
/// that alone makes it false. No assumption does exactly where it cannot be false.
pub fn ways_to_fail<V>(
    placements: &[Vec<Affine>],
    predicate: impl Fn(&[Vec<Symbol>]) -> V,
    is_false: impl Fn(&V) -> bool,
) -> Vec<Constraint> {
    let Some(comparisons) = comparisons(placements, predicate, is_false) else {
        return vec![Constraint { form: Affine::from_int(0), sign: Sign::Zero }];
    };
    let ways = |c: &Comparison| -> Vec<Constraint> {
        c.fatal.iter().map(|&answer| assumption(&c.difference, answer)).collect()
    };
    comparisons.iter().flat_map(ways).collect()
}

/// For a predicate that is a conjunction of comparisons: what it demands, as constraints.
/// `None` where it is false whatever the start, or demands that something differ from zero,
/// which no constraint says.
pub fn demands<V>(
    placements: &[Vec<Affine>],
    predicate: impl Fn(&[Vec<Symbol>]) -> V,
    is_false: impl Fn(&V) -> bool,
) -> Option<Vec<Constraint>> {
    use Ordering::{Equal, Greater, Less};
    let mut demands = Vec::new();
    for Comparison { difference, fatal } in comparisons(placements, predicate, is_false)? {
        let negated = || Affine::from_int(0) - &difference;
        let (form, sign) = match fatal.as_slice() {
            [] => continue,
            [Greater] => (negated(), Sign::NonNegative),
            [Less] => (difference, Sign::NonNegative),
            [Equal, Greater] => (negated(), Sign::Positive),
            [Less, Equal] => (difference, Sign::Positive),
            [Less, Greater] => (difference, Sign::Zero),
            _ => return None,
        };
        demands.push(Constraint { form, sign });
    }
    Some(demands)
}
