//! Predicates that are conjunctions of comparisons of affine forms: the ways in which they can fail,
//! and the constraints that they impose.

use std::cmp::Ordering;

use cordon_spec::Scalar;
use num_traits::Zero;

use crate::symbolic::{ANSWERS, Compared, Expression, Oracle, Question, Symbol};
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};

/// The question is the sign of the difference.
impl Expression for Affine {
    fn compared(&self, other: &Self) -> Compared<Self> {
        let difference = self.clone() - other;
        match (difference.as_constant(), difference.parts()) {
            (Some(value), _) => Compared::Known(value.cmp(&Rational::zero())),
            (None, Some(_)) => Compared::Open([difference, Self::from_int(0)]),
            (None, None) => Compared::Unknowable,
        }
    }
}

/// The constraint that the difference has the assumed sign.
pub fn assumption([difference, _]: &Question<Affine>, answer: Ordering) -> Constraint {
    let (form, sign) = match answer {
        Ordering::Less => (Affine::from_int(0) - difference, Sign::Positive),
        Ordering::Equal => (difference.clone(), Sign::Zero),
        Ordering::Greater => (difference.clone(), Sign::Positive),
    };
    Constraint { form, sign }
}

/// The comparisons of such a predicate, each with the answers that make the predicate false; `None`
/// where it is false for every start, because constants were compared.
fn comparisons<V>(
    placements: &[Vec<Affine>],
    predicate: impl Fn(&[Vec<Symbol<Affine>>]) -> V,
    is_false: impl Fn(&V) -> bool,
) -> Option<Vec<(Question<Affine>, Vec<Ordering>)>> {
    let oracle = Oracle::new();
    let symbols = oracle.symbols(placements);
    let (verdict, asked) = oracle.assuming(&[], || predicate(&symbols));
    if is_false(&verdict) {
        return None;
    }
    let fatal = |question: Question<Affine>| {
        let alone = |answer: &Ordering| {
            let answers = [(question.clone(), *answer)];
            is_false(&oracle.assuming(&answers, || predicate(&symbols)).0)
        };
        let fatal = ANSWERS.into_iter().filter(alone).collect();
        (question, fatal)
    };
    Some(asked.into_iter().map(fatal).collect())
}

/// Every assumption about one comparison that makes the predicate false. If there is none, it cannot be
/// false.
pub fn ways_to_fail<V>(
    placements: &[Vec<Affine>],
    predicate: impl Fn(&[Vec<Symbol<Affine>>]) -> V,
    is_false: impl Fn(&V) -> bool,
) -> Vec<Constraint> {
    let Some(comparisons) = comparisons(placements, predicate, is_false) else {
        return vec![Constraint { form: Affine::from_int(0), sign: Sign::Zero }];
    };
    comparisons
        .iter()
        .flat_map(|(question, fatal)| fatal.iter().map(|&answer| assumption(question, answer)))
        .collect()
}

/// The predicate as constraints. `None` where it is false for every start, or requires a form to be
/// nonzero, which no constraint expresses.
pub fn demands<V>(
    placements: &[Vec<Affine>],
    predicate: impl Fn(&[Vec<Symbol<Affine>>]) -> V,
    is_false: impl Fn(&V) -> bool,
) -> Option<Vec<Constraint>> {
    use Ordering::{Equal, Greater, Less};
    let mut demands = Vec::new();
    for ([difference, _], fatal) in comparisons(placements, predicate, is_false)? {
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
