//! The rules of proof: how an obligation follows from its facts.
//!
//! An obligation says that a polynomial is positive, nonnegative or zero wherever its facts
//! hold. One rule is one function, and [`RULES`] is the table of them.

use cordon_spec::Scalar;
use num_traits::Signed;

use crate::format::{MAX_FACTORS, Proof, Term, bounded, polynomial};
use crate::poly::{Poly, Rational, Var};

/// What is said of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// It is above zero.
    Positive,
    /// It is zero or above.
    NonNegative,
    /// It is zero.
    Zero,
}

/// A named hypothesis.
#[derive(Clone, Debug)]
pub struct Fact {
    /// How certificates call it; it ends with the relation: `eps >= 0`.
    pub name: String,
    /// The polynomial.
    pub poly: Poly,
    /// What it is.
    pub relation: Relation,
}

impl Fact {
    /// A fact called `label` and its relation to 0.
    pub fn new(label: &str, poly: Poly, relation: Relation) -> Self {
        let sign = match relation {
            Relation::Positive => "> 0",
            Relation::NonNegative => ">= 0",
            Relation::Zero => "= 0",
        };
        Self { name: format!("{label} {sign}"), poly, relation }
    }
}

/// Something to be proved: wherever the facts hold, so does the relation of the goal to 0.
#[derive(Clone, Debug)]
pub struct Obligation {
    /// How certificates call it.
    pub name: String,
    /// The hypotheses.
    pub facts: Vec<Fact>,
    /// The polynomial.
    pub goal: Poly,
    /// What it is to be.
    pub relation: Relation,
}

/// Why a proof was not accepted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The rule that failed.
    pub rule: &'static str,
    /// Why.
    pub reason: String,
}

type Rule = fn(&Obligation, &Proof, usize) -> Result<(), Fault>;

/// Every rule by name.
pub const RULES: &[(&str, Rule)] =
    &[("positivity", positivity), ("identity", identity), ("split", split)];

/// Most monomials that the products of one proof may have before they are added up: bounds
/// the work. The theorems need 600.
const MAX_EXPANSION: usize = 20_000;

/// Most nested splits. The theorems need 1.
const MAX_SPLITS: usize = 8;

/// Checks one proof; `depth` counts the splits around it.
pub fn check(obligation: &Obligation, proof: &Proof, depth: usize) -> Result<(), Fault> {
    match RULES.iter().find(|(name, _)| *name == proof.rule) {
        Some((_, rule)) => rule(obligation, proof, depth),
        None => Err(Fault { rule: "unknown", reason: format!("no rule `{}`", proof.rule) }),
    }
}

/// `positivity`: times * goal = sum of c * product of facts, where every fact of `times` is
/// positive and every term is nonnegative: c > 0 and each factor a fact that is >= 0 or > 0. A
/// term with a factor that is a zero fact may have any sign, and any indeterminates besides. Where the goal
/// is to be positive, one term has c > 0 and positive factors only.
fn positivity(obligation: &Obligation, proof: &Proof, _: usize) -> Result<(), Fault> {
    const RULE: &str = "positivity";
    let fail = |reason: String| Err(Fault { rule: RULE, reason });
    if obligation.relation == Relation::Zero {
        return fail("the goal is an equation: expected the rule `identity`".into());
    }
    let mut strict = false;
    for term in &proof.terms {
        match weakest(&obligation.facts, term).map_err(|reason| Fault { rule: RULE, reason })? {
            Relation::Zero => {}
            _ if !term.c.0.is_positive() => {
                return fail(format!("coefficient {} is not above 0", term.c.0));
            }
            Relation::Positive => strict = true,
            Relation::NonNegative => {}
        }
    }
    if obligation.relation == Relation::Positive && !strict {
        return fail("the goal is strict, but no term is positive".into());
    }
    equation(RULE, obligation, proof)
}

/// `identity`: times * goal = sum of c * product, with a zero fact in every product (any
/// indeterminates besides), and every fact of `times` positive. Without terms: the goal is the
/// zero polynomial.
fn identity(obligation: &Obligation, proof: &Proof, _: usize) -> Result<(), Fault> {
    const RULE: &str = "identity";
    let fail = |reason: String| Err(Fault { rule: RULE, reason });
    if obligation.relation != Relation::Zero {
        return fail("the goal is no equation: expected the rule `positivity`".into());
    }
    for term in &proof.terms {
        let weakest =
            weakest(&obligation.facts, term).map_err(|reason| Fault { rule: RULE, reason })?;
        if weakest != Relation::Zero {
            return fail(format!("no factor of `{}` is zero", term.of.join("` * `")));
        }
    }
    equation(RULE, obligation, proof)
}

/// `split`: the obligation under the additional fact `on` >= 0, and under `-on` >= 0; every
/// real number is one or the other. The fact is called `split.DEPTH >= 0` in both branches.
fn split(obligation: &Obligation, proof: &Proof, depth: usize) -> Result<(), Fault> {
    let fault = |reason: String| Fault { rule: "split", reason };
    if !proof.terms.is_empty() || !proof.times.is_empty() {
        return Err(fault("`terms` and `times` belong to other rules".into()));
    }
    if depth >= MAX_SPLITS {
        return Err(fault(format!("more than {MAX_SPLITS} nested splits")));
    }
    let on = polynomial(&proof.on, &indeterminates(obligation)).map_err(fault)?;
    let [above, below] = proof.branches.as_slice() else {
        return Err(fault(format!("{} branches: expected 2", proof.branches.len())));
    };
    let with = |poly: Poly| {
        let mut branch = obligation.clone();
        branch.facts.push(Fact::new(&format!("split.{depth}"), poly, Relation::NonNegative));
        branch
    };
    check(&with(on.clone()), above, depth + 1)?;
    check(&with(Poly::from_int(0) - &on), below, depth + 1)
}

/// The least that the factors allow to say of a term's product: zero if one factor is, else nonnegative
/// if one is, else positive.
fn weakest(facts: &[Fact], term: &Term) -> Result<Relation, String> {
    let of = |name: &String| facts.iter().find(|f| f.name == *name).map(|f| f.relation);
    let relations: Vec<_> = term.of.iter().map(of).collect();
    if relations.contains(&Some(Relation::Zero)) {
        return Ok(Relation::Zero);
    }
    if let Some(unknown) = relations.iter().position(Option::is_none) {
        return Err(format!("`{}` is no fact of this obligation", term.of[unknown]));
    }
    Ok(if relations.contains(&Some(Relation::NonNegative)) {
        Relation::NonNegative
    } else {
        Relation::Positive
    })
}

/// Whether times * goal and the sum of the terms are the same polynomial, `times` having
/// positive facts only.
fn equation(rule: &'static str, obligation: &Obligation, proof: &Proof) -> Result<(), Fault> {
    let fault = |reason: String| Fault { rule, reason };
    if !proof.on.is_empty() || !proof.branches.is_empty() {
        return Err(fault("`on` and `branches` belong to the rule `split`".into()));
    }
    bounded(&proof.terms).map_err(fault)?;
    let vars = indeterminates(obligation);
    let factor = |name: &String| -> Result<Poly, Fault> {
        let fact = obligation.facts.iter().find(|f| f.name == *name).map(|f| f.poly.clone());
        let var = || vars.iter().find(|v| v.to_string() == *name).map(|&v| Poly::var(v));
        fact.or_else(var).ok_or_else(|| fault(format!("`{name}` is no fact or indeterminate")))
    };
    let mut expansion = 0_usize;
    let mut product = |start: Poly, names: &[String]| -> Result<Poly, Fault> {
        names.iter().try_fold(start, |product, name| {
            let next = factor(name)?;
            expansion = expansion.saturating_add(product.len().saturating_mul(next.len()));
            if expansion > MAX_EXPANSION {
                return Err(fault(format!("products of more than {MAX_EXPANSION} monomials")));
            }
            Ok(product * &next)
        })
    };
    if proof.times.len() > MAX_FACTORS {
        return Err(fault(format!("{} factors: at most {MAX_FACTORS}", proof.times.len())));
    }
    for name in &proof.times {
        let relation = obligation.facts.iter().find(|f| f.name == *name).map(|f| f.relation);
        if relation != Some(Relation::Positive) {
            return Err(fault(format!("`{name}` multiplies the goal but is no positive fact")));
        }
    }
    let left = product(obligation.goal.clone(), &proof.times)?;
    let mut right = Poly::default();
    for term in &proof.terms {
        right = right + &product(Poly::constant(term.c.0.clone()), &term.of)?;
    }
    let rest = left - &right;
    match rest.terms().next() {
        None => Ok(()),
        Some((monomial, c)) => {
            let shown: Vec<String> = monomial.iter().map(Var::to_string).collect();
            Err(fault(format!("the two sides differ by {} {}", brief(c), shown.join("*"))))
        }
    }
}

/// The indeterminates of goal and facts.
fn indeterminates(obligation: &Obligation) -> Vec<Var> {
    let polys = obligation.facts.iter().map(|f| &f.poly).chain([&obligation.goal]);
    let mut vars: Vec<Var> =
        polys.flat_map(|p| p.terms()).flat_map(|(m, _)| m.iter().copied()).collect();
    vars.sort_unstable();
    vars.dedup();
    vars
}

/// A number for a message, cut where it is long.
fn brief(c: &Rational) -> String {
    let text = c.to_string();
    if text.len() <= 40 { text } else { format!("{}...", &text[..40]) }
}
