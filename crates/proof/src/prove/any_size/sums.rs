//! Goals as sums of products of facts, by linear programs over the monomials.

use num_traits::{One, Zero};

use super::text::{Literal, constant};
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Premises, Sign};
use cordon_core::scalar::{Monomial, Polynomial};
use cordon_core::simplex::Work;
use cordon_core::system::expression::{add_term, or_zero};

/// Something known, by the name that it has in a sum.
#[derive(Clone, Debug)]
pub struct Fact {
    pub name: String,
    pub literal: Literal,
}

/// The goal as a sum of facts, of facts times a constant's facts, and of a number; as text, with the
/// facts that it uses. `degree` is how many facts about constants a product may have. `None` too where
/// that takes more work than may be done.
pub fn sum(
    goal: &Literal,
    facts: &[Fact],
    about_constants: &[Fact],
    degree: usize,
    work: &Work,
) -> Option<(String, Vec<String>)> {
    let one = || Literal { poly: Polynomial::constant(Rational::one()), sign: Sign::Positive };
    let mut powers = vec![(Vec::new(), one())];
    let mut products: Vec<(Vec<&str>, Literal)> = Vec::new();
    for _ in 0..=degree {
        for (names, power) in &powers {
            for fact in facts {
                products.push((
                    [names.as_slice(), &[fact.name.as_str()]].concat(),
                    times(power, &fact.literal),
                ));
            }
            if !names.is_empty() {
                products.push((names.clone(), power.clone()));
            }
        }
        let longer = powers.iter().flat_map(|(names, power): &(Vec<&str>, Literal)| {
            // In the order of the facts, so that no product is there twice.
            let from = names.last().map_or(0, |last| {
                about_constants.iter().position(|f| f.name == *last).unwrap_or(0)
            });
            about_constants[from..].iter().map(move |f| {
                ([names.as_slice(), &[f.name.as_str()]].concat(), times(power, &f.literal))
            })
        });
        powers = longer.collect();
    }
    let mut monomials: Vec<&Monomial> = Vec::new();
    for (m, _) in products.iter().map(|(_, l)| l).chain([goal]).flat_map(|l| l.poly.terms()) {
        if m.degree() > 0 && !monomials.contains(&m) {
            monomials.push(m);
        }
    }
    let linear = |l: &Literal| {
        let coefficients = monomials.iter().map(|m| l.poly.coefficient(m)).collect();
        let form = Affine::new(l.poly.coefficient(&Monomial::default()), coefficients);
        Constraint { form, sign: l.sign }
    };
    let given: Vec<Constraint> = products.iter().map(|(_, l)| linear(l)).collect();
    let multipliers = Premises::new(&given)?.multipliers_within(&linear(goal), work)?;
    let (mut rest, mut text, mut used) = (goal.poly.clone(), String::new(), Vec::new());
    for (m, (names, l)) in multipliers.iter().zip(&products).filter(|(m, _)| !m.is_zero()) {
        let factors: Vec<String> = names.iter().map(|n| format!("[{n}]")).collect();
        add_term(&mut text, m, &factors.iter().map(String::as_str).collect::<Vec<_>>());
        used.extend(names.iter().map(|n| (*n).to_owned()));
        rest = rest - &(Polynomial::constant(m.clone()) * &l.poly);
    }
    let rest = constant(&rest)?;
    if !rest.is_zero() {
        add_term(&mut text, &rest, &[]);
    }
    Some((or_zero(text), used))
}

fn times(a: &Literal, b: &Literal) -> Literal {
    let sign = match (a.sign, b.sign) {
        (Sign::Zero, _) | (_, Sign::Zero) => Sign::Zero,
        (Sign::Positive, Sign::Positive) => Sign::Positive,
        _ => Sign::NonNegative,
    };
    Literal { poly: a.poly.clone() * &b.poly, sign }
}
