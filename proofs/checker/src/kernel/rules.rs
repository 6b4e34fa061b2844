//! The rules by which a clause is proved.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use crate::expr::Relation::{NonNegative, Positive, Zero};
use crate::expr::{Literal, Sort, Vars, joined};
use crate::fault::{Result, ensure, fault};
use crate::format::{Cases, Induction, Instance, Named, Positivity, Proof, Split};
use crate::kernel::{Clause, Facts, Kernel, insert};
use crate::number::spend;
use crate::poly::{Atom, Poly};

/// Where a proof stands: hypotheses of inductions around it, and the variables they hold fixed.
#[derive(Clone, Default)]
struct Context {
    hypotheses: BTreeMap<Rc<str>, Clause>,
    fixed: BTreeSet<Rc<str>>,
}

impl Kernel {
    /// Checks the proof of a clause.
    ///
    /// # Errors
    /// The rule that fails, and why.
    pub fn check(&self, clause: &Clause, proof: &Proof) -> Result<()> {
        self.prove(clause, proof, &Context::default())
    }

    fn prove(&self, clause: &Clause, proof: &Proof, context: &Context) -> Result<()> {
        spend(128 * clause.size())?;
        match proof {
            Proof::Positivity(p) => self.positivity(clause, p, context),
            Proof::Absurd(p) => {
                let goal = Literal { poly: Poly::whole(-1), relation: NonNegative };
                self.positivity(&Clause { goal, ..clause.clone() }, p, context)
            }
            Proof::Cases(c) => self.cases(clause, c, context),
            Proof::Split(s) => self.split(clause, s, context),
            Proof::Induction(i) => self.induction(clause, i, context),
        }
    }

    /// Rule *positivity*, and *absurd*: the goal follows from the facts, instances of lemmas
    /// among them, by [`Self::sum`].
    fn positivity(&self, clause: &Clause, p: &Positivity, context: &Context) -> Result<()> {
        let mut facts = clause.given.clone();
        for instance in &p.r#use {
            let fact = self.instance(instance, &facts, &clause.vars, context)?;
            let taken = self.closed.contains_key(&*instance.name);
            ensure!(!taken, "name", "the fact `{:.40}` is there twice", instance.name);
            insert(&mut facts, &instance.name, fact)?;
        }
        self.sum(&clause.goal, &p.times, &p.sum, &facts, &clause.vars)
    }

    /// What a lemma, or a hypothesis, says of terms in the place of its variables, its literals given being proved of them.
    fn instance(
        &self,
        i: &Instance,
        facts: &Facts,
        vars: &Vars,
        context: &Context,
    ) -> Result<Literal> {
        const RULE: &str = "instance";
        let lemma = context.hypotheses.get(&*i.lemma).or_else(|| self.lemmas.get(&*i.lemma));
        let Some(lemma) = lemma else { return fault(RULE, format!("no lemma `{:.40}`", i.lemma)) };
        let mut terms = BTreeMap::new();
        for (name, sort) in &lemma.vars {
            let term = self.signature.poly(named(&i.with, name), vars, false)?;
            let fits = *sort == Sort::Real || self.signature.is_integer(&term, vars);
            ensure!(fits, RULE, "`{name}` stands for integers");
            terms.insert(name.clone(), term);
        }
        let known = i.with.0.keys().all(|v| terms.contains_key(&**v))
            && i.given.0.keys().all(|g| lemma.given.contains_key(&**g));
        ensure!(known, RULE, "`{:.40}` has no such variable or literal", i.lemma);
        let lemma = lemma.with(&|v| terms.get(v).cloned());
        for (name, literal) in &lemma.given {
            self.sum(literal, &[], named(&i.given, name), facts, vars)?;
        }
        Ok(lemma.goal)
    }

    /// `times` * goal is, as a polynomial, the sum; every fact of `times` is positive, and every
    /// product of the sum has a zero fact, or facts only and a coefficient above 0. For a goal =
    /// 0 all have a zero fact; for a goal > 0 one has a coefficient above 0 and positive facts only.
    pub(super) fn sum(
        &self,
        goal: &Literal,
        times: &[String],
        sum: &str,
        facts: &Facts,
        vars: &Vars,
    ) -> Result<()> {
        const RULE: &str = "positivity";
        let fact = |name: &str| facts.get(name).or_else(|| self.closed.get(name));
        let mut left = goal.poly.clone();
        for name in times {
            match fact(name) {
                Some(Literal { poly, relation: Positive }) => left = left * poly,
                _ => return fault(RULE, format!("`{name:.40}` is no positive fact")),
            }
        }
        let sum = self.signature.poly(sum, vars, true)?;
        let mut strict = false;
        for (monomial, c) in sum.terms() {
            let (mut product, mut facts_only) = (Positive, true);
            for atom in monomial {
                let Atom::Fact(name) = atom else {
                    facts_only = false;
                    continue;
                };
                product = match (fact(name).map(|l| l.relation), product) {
                    (None, _) => return fault(RULE, format!("no fact `{name:.40}`")),
                    (Some(Zero), _) | (_, Zero) => Zero,
                    (Some(NonNegative), _) => NonNegative,
                    (Some(Positive), p) => p,
                };
            }
            if product == Zero {
                continue;
            }
            let alone = goal.relation != Zero;
            ensure!(alone, RULE, "a product without a zero fact, the goal being an equation");
            ensure!(facts_only && c.is_positive(), RULE, "a product that may be below 0");
            strict |= product == Positive;
        }
        let enough = goal.relation != Positive || strict;
        ensure!(enough, RULE, "no product that is above 0, as the goal has to be");
        let sum = sum.substitute(&|a| match a {
            Atom::Fact(name) => fact(name).map(|l| l.poly.clone()),
            _ => None,
        });
        if left == sum {
            return Ok(());
        }
        let rest = left - &sum;
        match rest.terms().next().map(|(m, _)| joined(m, "*")) {
            Some(m) if !m.is_empty() => fault(RULE, format!("the sides differ at `{m:.60}`")),
            _ => fault(RULE, "the sides differ in their constants"),
        }
    }

    /// The bounds, from below and from above, that a literal `poly >= 0` sets an integer variable, no
    /// induction around holding it fixed: a bound has to be an integer that does not read the variable.
    fn bounds(&self, clause: &Clause, on: &str, v: &str, context: &Context) -> [Option<Poly>; 2] {
        let Some(Literal { poly, relation: NonNegative }) = clause.given.get(on) else {
            return [None, None];
        };
        let integer = clause.vars.iter().any(|(name, sort)| **name == *v && *sort == Sort::Integer);
        [Poly::var(v) - poly, poly.clone() + &Poly::var(v)].map(|bound| {
            let sound = self.signature.is_integer(&bound, &clause.vars) && !bound.has(v);
            (integer && sound && !context.fixed.contains(v)).then_some(bound)
        })
    }

    /// Rule *cases*: an integer that is at least (at most) an integer bound is the bound, or at least
    /// one more (at most one less).
    fn cases(&self, clause: &Clause, c: &Cases, context: &Context) -> Result<()> {
        let [below, above] = self.bounds(clause, &c.on, &c.variable, context);
        let Some(bound) = below.or(above) else {
            return fault("cases", format!("`{:.40}` does not bound `{:.40}`", c.on, c.variable));
        };
        let mut beyond = clause.clone();
        if let Some(literal) = beyond.given.get_mut(&*c.on) {
            *literal = literal.map(|p| p.clone() - &Poly::whole(1));
        }
        self.prove(&clause.at(&c.variable, &bound), &c.equal, context)?;
        self.prove(&beyond, &c.beyond, context)
    }

    /// Rule *split*: a real number is above, equal to or below 0; an integer at least 1, 0 or at most -1.
    fn split(&self, clause: &Clause, s: &Split, context: &Context) -> Result<()> {
        let poly = self.signature.poly(&s.on, &clause.vars, false)?;
        let (relation, step) = match self.signature.is_integer(&poly, &clause.vars) {
            true => (NonNegative, Poly::whole(1)),
            false => (Positive, Poly::default()),
        };
        let above = Literal { poly: poly.clone() - &step, relation };
        let below = Literal { poly: Poly::default() - &poly - &step, relation };
        let equal = Literal { poly, relation: Zero };
        for (literal, proof) in [(above, &s.above), (equal, &s.equal), (below, &s.below)] {
            let mut branch = clause.clone();
            insert(&mut branch.given, &s.name, literal)?;
            self.prove(&branch, proof, context)?;
        }
        Ok(())
    }

    /// Rule *induction*: what holds at an integer bound, and one further wherever it holds of all
    /// integers from the bound up to there, holds from the bound on. The hypothesis is about every value of the
    /// other variables, but for those that inductions around hold fixed; the bound is the same for all.
    fn induction(&self, clause: &Clause, i: &Induction, context: &Context) -> Result<()> {
        const RULE: &str = "induction";
        let general = |v: &Rc<str>| !context.fixed.contains(v);
        let [Some(bound), _] = self.bounds(clause, &i.on, &i.variable, context) else {
            return fault(
                RULE,
                format!("`{:.40}` does not bound `{:.40}` below", i.on, i.variable),
            );
        };
        let differs = clause.vars.iter().any(|(v, _)| general(v) && bound.has(v));
        ensure!(!differs, RULE, "the bound differs with the variables");
        let earlier = self.fresh(&i.earlier, &clause.vars)?;
        let variable = Poly::var(&i.variable);
        let mut step = clause.at(&i.variable, &(variable.clone() + &Poly::whole(1)));
        step.vars = clause.vars.clone();
        step.given.extend(clause.given.get_key_value(&*i.on).map(|(n, l)| (n.clone(), l.clone())));
        let mut hypothesis = clause.at(&i.variable, &Poly::var(&earlier));
        hypothesis.vars.retain(|(v, _)| general(v));
        hypothesis.vars.push((earlier.clone(), Sort::Integer));
        let no_later = Literal { poly: variable - &Poly::var(&earlier), relation: NonNegative };
        insert(&mut hypothesis.given, &earlier, no_later)?;
        let mut inner = context.clone();
        inner.fixed.insert(i.variable.as_str().into());
        let taken = inner.hypotheses.insert(i.hypothesis.as_str().into(), hypothesis).is_some()
            || self.lemmas.contains_key(&*i.hypothesis);
        ensure!(!taken, RULE, "`{:.40}` is there twice", i.hypothesis);
        self.prove(&clause.at(&i.variable, &bound), &i.base, context)?;
        self.prove(&step, &i.step, &inner)
    }
}

/// What is given by that name: 0 where nothing is.
fn named<'n>(all: &'n Named<String>, name: &str) -> &'n str {
    all.0.get(name).map_or("0", String::as_str)
}
