//! Positivity by linear programming: finds nonnegative multipliers of products of facts whose
//! sum is the goal (Handelman's form, and Farkas' for degree 1), products of low degree first.
//!
//! Two things keep the programs small. Facts have units (a gap is a length, a weight is none),
//! and only products in the goal's unit can add up to it. And products whose degree in some
//! indeterminate exceeds the goal's and every fact's are left out: they could only cancel each other.

use std::collections::BTreeMap;

use cordon_spec::Scalar;
use num_traits::{One, Signed, Zero};

use super::symbols::{Fact, Goal, Sign, fact, int, is_length, name, named, substitute, unit};
use cordon_core::Rational;
use cordon_core::scalar::{Monomial, Polynomial};
use cordon_core::simplex::{Solution, maximise};

/// A sum of products by name.
pub type Terms = Vec<(Rational, Vec<String>)>;

/// A proof that the checker can replay.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Proof {
    /// `times * goal = terms`, for a sign.
    Positivity {
        /// Names of positive facts.
        times: Vec<String>,
        /// Facts and multipliers.
        terms: Terms,
    },
    /// `times * goal = terms`, for an equation.
    Identity {
        /// Names of positive facts.
        times: Vec<String>,
        /// Facts and multipliers.
        terms: Terms,
    },
    /// By the sign of a polynomial.
    Split {
        /// The polynomial.
        on: Terms,
        /// Where it is >= 0, and where it is <= 0.
        branches: Box<[Proof; 2]>,
    },
}

/// How far the search goes.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Most factors of a product, together with the facts that multiply the goal.
    pub level: usize,
    /// Most facts that multiply the goal.
    pub times: usize,
    /// Most products tried in one linear program.
    pub products: usize,
}

impl Default for Effort {
    /// Enough for every theorem of the paper: 7.8 needs products of 4 facts.
    fn default() -> Self {
        Self { level: 4, times: 2, products: 600 }
    }
}

/// Finds a proof of the goal, directly or by one split.
pub fn prove(goal: &Goal, effort: Effort) -> Option<Proof> {
    if goal.sign == Sign::Zero && goal.poly.is_zero() {
        return Some(Proof::Identity { times: Vec::new(), terms: Vec::new() });
    }
    let splits = if goal.sign == Sign::Zero { Vec::new() } else { splits(goal) };
    for level in 0..=effort.level {
        for times in multipliers(goal, effort.times.min(level)) {
            let combine = |goal: &Goal| combine(goal, &times, level - times.len(), effort);
            if let Some(proof) = combine(goal) {
                return Some(proof);
            }
            for on in &splits {
                let branch = |poly: Polynomial| {
                    let mut goal = goal.clone();
                    goal.facts.push(fact("split.0", poly, Sign::NonNegative));
                    combine(&goal)
                };
                // The second branch is tried only where the first is proved.
                let Some(above) = branch(on.clone()) else { continue };
                let Some(below) = branch(int(0) - on) else { continue };
                return Some(Proof::Split { on: terms_of(on), branches: Box::new([above, below]) });
            }
        }
    }
    None
}

/// The polynomial as named terms.
pub fn terms_of(p: &Polynomial) -> Terms {
    p.terms().map(|(monomial, c)| (c.clone(), names_of(monomial))).collect()
}

fn names_of(monomial: &Monomial) -> Vec<String> {
    monomial.powers().flat_map(|(v, e)| (0..e).map(move |_| name(v))).collect()
}

/// What may multiply the goal: products of up to `most` positive facts that measure no length.
fn multipliers(goal: &Goal, most: usize) -> Vec<Vec<usize>> {
    let useful = |f: &Fact| {
        f.sign == Sign::Positive && unit(&f.poly) == Some(0) && f.poly.terms().count() == 1
    };
    let positive: Vec<usize> = (0..goal.facts.len()).filter(|&i| useful(&goal.facts[i])).collect();
    let mut all = vec![Vec::new()];
    let mut from = 0;
    for _ in 0..most {
        let to = all.len();
        for k in from..to {
            let least = all[k].last().copied().unwrap_or(0);
            for &i in positive.iter().filter(|&&i| i >= least) {
                let mut longer: Vec<usize> = all[k].clone();
                longer.push(i);
                all.push(longer);
            }
        }
        from = to;
    }
    all
}

/// Polynomials worth splitting on: the middle of the range of weights, the middle of the line.
fn splits(goal: &Goal) -> Vec<Polynomial> {
    let mut all = Vec::new();
    let bounds: Vec<Rational> = goal.facts.iter().filter_map(|f| root_in_eps(&f.poly)).collect();
    if let (Some(low), Some(high)) = (bounds.iter().min(), bounds.iter().max())
        && low < high
    {
        let middle = (low + high) / Rational::from_int(2);
        all.push(named("eps") - &Polynomial::constant(middle));
    }
    if mentions(&goal.poly, "i") && mentions(&goal.poly, "last") {
        all.push(named("last") - &(int(2) * &named("i")));
    }
    all
}

fn mentions(p: &Polynomial, variable: &'static str) -> bool {
    substitute(p, &[(named(variable), int(0))]) != *p
}

/// The zero of a polynomial a + b*eps, b not zero.
fn root_in_eps(p: &Polynomial) -> Option<Rational> {
    let at = |value: i32| {
        let terms = terms_of(&substitute(p, &[(named("eps"), int(value))]));
        match terms.as_slice() {
            [] => Some(Rational::zero()),
            [(c, of)] if of.is_empty() => Some(c.clone()),
            _ => None,
        }
    };
    let (a, sum, twice) = (at(0)?, at(1)?, at(2)?);
    let b = sum - &a;
    (!b.is_zero() && twice == &a + &b + &b).then(|| -a / b)
}

/// One candidate term.
struct Product {
    poly: Polynomial,
    factors: Vec<String>,
    /// All factors are positive.
    positive: bool,
    /// Both signs are allowed: a factor is zero.
    free: bool,
    /// The first factor that may come next.
    least: usize,
}

/// Finds multipliers for products of at most `degree` facts, if there are any.
fn combine(goal: &Goal, times: &[usize], degree: usize, effort: Effort) -> Option<Proof> {
    let target = times.iter().fold(goal.poly.clone(), |t, &i| t * &goal.facts[i].poly);
    let products = candidates(goal, &target, degree)?;
    if products.len() > effort.products {
        return None;
    }
    let mut rows: BTreeMap<Monomial, usize> = BTreeMap::new();
    let polys = products.iter().map(|p| &p.poly).chain([&target]);
    for (monomial, _) in polys.flat_map(Polynomial::terms) {
        let next = rows.len();
        rows.entry(monomial.clone()).or_insert(next);
    }
    // Columns: each product, each free product negated, and last the slack of the cap on
    // positive terms.
    let columns: Vec<(usize, bool)> = (0..products.len())
        .flat_map(|k| {
            let negated = products[k].free.then_some((k, true));
            [(k, false)].into_iter().chain(negated)
        })
        .collect();
    let width = columns.len() + 1;
    let mut equations = vec![vec![Rational::zero(); width]; rows.len() + 1];
    let mut constants = vec![Rational::zero(); rows.len() + 1];
    let mut objective = vec![Rational::zero(); width];
    let strict = goal.sign == Sign::Positive;
    for (column, &(k, negated)) in columns.iter().enumerate() {
        for (monomial, c) in products[k].poly.terms() {
            equations[rows[monomial]][column] = if negated { -c.clone() } else { c.clone() };
        }
        if strict && products[k].positive {
            objective[column] = Rational::one();
            equations[rows.len()][column] = Rational::one();
        }
    }
    for (monomial, c) in target.terms() {
        constants[rows[monomial]] = c.clone();
    }
    equations[rows.len()][width - 1] = Rational::one();
    // A cap keeps the program bounded where the facts contradict each other.
    constants[rows.len()] = Rational::from_int(1_000);
    let Solution::Optimal(x) = maximise(&objective, &equations, &constants) else {
        return None;
    };
    let value: Rational = objective.iter().zip(&x).map(|(c, x)| c * x).sum();
    if strict && !value.is_positive() {
        return None;
    }
    let terms = columns
        .iter()
        .zip(&x)
        .filter(|(_, x)| !x.is_zero())
        .map(|(&(k, negated), x)| {
            (if negated { -x.clone() } else { x.clone() }, products[k].factors.clone())
        })
        .collect();
    let times = times.iter().map(|&i| goal.facts[i].name.clone()).collect();
    Some(match goal.sign {
        Sign::Zero => Proof::Identity { times, terms },
        _ => Proof::Positivity { times, terms },
    })
}

/// All products of at most `degree` facts in the unit of the target; equations also times
/// monomials of the target without unit. `None` if the target mixes units.
fn candidates(goal: &Goal, target: &Polynomial, degree: usize) -> Option<Vec<Product>> {
    let wanted = unit(target)?;
    let factors = factors(goal, target);
    let mut limits = degrees(target);
    for (v, e) in factors.iter().flat_map(|f| degrees(&f.poly)) {
        let limit = limits.entry(v).or_insert(1);
        *limit = e.max(*limit);
    }
    let fits =
        |p: &Polynomial| degrees(p).iter().all(|(v, &e)| limits.get(v).is_some_and(|&l| e <= l));
    let one = Product { poly: int(1), factors: Vec::new(), positive: true, free: false, least: 0 };
    let (mut all, mut layer) = (Vec::new(), vec![one]);
    for _ in 0..=degree {
        let mut next = Vec::new();
        for product in &layer {
            for (k, fact) in factors.iter().enumerate().skip(product.least) {
                let poly = product.poly.clone() * &fact.poly;
                if fits(&poly) && unit(&poly).is_some_and(|u| u <= wanted) {
                    let mut factors = product.factors.clone();
                    factors.push(fact.name.clone());
                    next.push(Product {
                        poly,
                        factors,
                        positive: product.positive && fact.sign == Sign::Positive,
                        free: product.free || fact.sign == Sign::Zero,
                        least: k,
                    });
                }
            }
        }
        // Indeterminates, whose names unlike those of facts have no space, multiply equations only.
        all.extend(layer.into_iter().filter(|p| {
            let signed = goal.sign != Sign::Zero && p.factors.iter().all(|f| f.contains(' '));
            unit(&p.poly) == Some(wanted) && (p.free || signed)
        }));
        layer = next;
    }
    Some(all)
}

/// The degree in each indeterminate.
fn degrees(p: &Polynomial) -> BTreeMap<u32, u32> {
    let mut degrees = BTreeMap::new();
    for (v, e) in p.terms().flat_map(|(monomial, _)| monomial.powers()) {
        let degree = degrees.entry(v).or_insert(0);
        *degree = e.max(*degree);
    }
    degrees
}

/// The facts with a unit, and the indeterminates without one that may multiply an equation.
fn factors(goal: &Goal, target: &Polynomial) -> Vec<Fact> {
    let mut factors: Vec<Fact> =
        goal.facts.iter().filter(|f| unit(&f.poly).is_some()).cloned().collect();
    if goal.facts.iter().any(|f| f.sign == Sign::Zero) {
        for v in degrees(target).into_keys().filter(|&v| !is_length(v)) {
            let poly = Polynomial::variable(v);
            factors.push(Fact { name: name(v), poly, sign: Sign::NonNegative });
        }
    }
    factors
}
