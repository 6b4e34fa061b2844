//! The kernel: clauses, and the six rules by which they are proved.
//!
//! A clause says that for all integers and reals in the place of its variables, wherever the
//! literals given hold, so does its goal. `proofs/rocq/theories/Kernel.v` proves the rules sound.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::rc::Rc;

use cordon_spec::Scalar;

use crate::expr::Relation::{NonNegative, Positive, Zero};
use crate::expr::{Literal, Signature, Sort, Vars, joined};
use crate::fault::{Result, fault, need};
use crate::format::{self, Cases, Definition, Induction, Named, Positivity, Proof, Split};
use crate::number::charge;
use crate::poly::{Atom, Poly};

/// A universally quantified implication.
#[derive(Clone, Debug)]
pub struct Clause {
    /// The variables.
    pub vars: Vars,
    /// The literals given, by name.
    pub given: Facts,
    /// The goal.
    pub goal: Literal,
}

impl Clause {
    /// That a literal holds.
    pub fn fact(goal: Literal) -> Self {
        Self { vars: Vars::new(), given: Facts::new(), goal }
    }

    /// Whether a literal given is false, so that nothing is said.
    pub fn is_vacuous(&self) -> bool {
        self.given.values().any(|l| l.decided() == Some(false))
    }

    /// The clause with polynomials in the place of variables.
    fn with(&self, value: &dyn Fn(&str) -> Option<Poly>) -> Self {
        let at = |p: &Poly| p.with(value);
        let given = self.given.iter().map(|(n, l)| (n.clone(), l.map(at))).collect();
        Self { vars: self.vars.clone(), given, goal: self.goal.map(at) }
    }

    fn size(&self) -> u64 {
        let literals = self.given.values().chain([&self.goal]);
        self.vars.len() as u64 + literals.map(|l| 1 + l.poly.size()).sum::<u64>()
    }
}

/// What is said: literals given that hold anyway are left out.
impl fmt::Display for Clause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (sort, word) in [(Sort::Integer, "integers"), (Sort::Real, "reals")] {
            let names = joined(self.vars.iter().filter(|v| v.1 == sort).map(|v| &v.0), ", ");
            if !names.is_empty() {
                write!(f, "for all {word} {names}, ")?;
            }
        }
        let given = joined(self.given.values().filter(|l| l.decided() != Some(true)), " and ");
        if !given.is_empty() {
            write!(f, "if {given} then ")?;
        }
        self.goal.fmt(f)
    }
}

/// Names and what the facts of these names say.
pub type Facts = BTreeMap<Rc<str>, Literal>;

/// What is proved or assumed so far.
#[derive(Default)]
pub struct Kernel {
    /// The names that clauses may use.
    pub signature: Signature,
    /// Clauses by name.
    lemmas: BTreeMap<Rc<str>, Clause>,
    /// Those without variables and literals given: facts everywhere.
    closed: Facts,
}

/// Where a proof stands: hypotheses of inductions around it, and the variables they hold fixed.
#[derive(Clone, Default)]
struct Context {
    hypotheses: BTreeMap<Rc<str>, Clause>,
    fixed: BTreeSet<Rc<str>>,
}

impl Kernel {
    /// A name for something new.
    ///
    /// # Errors
    /// It is no name, or taken.
    pub fn fresh(&self, name: &str, vars: &Vars) -> Result<Rc<str>> {
        need(charge(128 + vars.len() as u64), "work", || "more than a file is allowed")?;
        let letters = name.starts_with(|c: char| c.is_ascii_alphabetic())
            && name.bytes().all(|b| b.is_ascii_alphanumeric());
        let taken = name == "last"
            || vars.iter().any(|(v, _)| **v == *name)
            || self.signature.constants.contains_key(name)
            || self.signature.functions.contains_key(name);
        need(letters && !taken, "name", || format!("`{name:.40}` is no name, or taken"))?;
        Ok(name.into())
    }

    /// Adds a clause that is assumed, or that has been proved.
    ///
    /// # Errors
    /// There is one of that name.
    pub fn add(&mut self, name: &str, clause: Clause) -> Result<()> {
        if clause.vars.is_empty() && clause.given.is_empty() {
            self.closed.insert(name.into(), clause.goal.clone());
        }
        let taken = self.lemmas.insert(name.into(), clause).is_some();
        need(!taken, "name", || format!("`{name:.40}` is there twice"))?;
        Ok(())
    }

    /// The clause of that name.
    pub fn lemma(&self, name: &str) -> Option<&Clause> {
        self.lemmas.get(name)
    }

    /// Reads a clause.
    ///
    /// # Errors
    /// Names or expressions that are wrong.
    pub fn clause(&self, written: &format::Clause) -> Result<Clause> {
        let mut vars = Vars::new();
        for v in &written.vars {
            let name = self.fresh(&v.name, &vars)?;
            vars.push((name, v.sort));
        }
        let mut given = Facts::new();
        for g in &written.given {
            insert(&mut given, &g.name, self.literal(&g.holds, &vars)?)?;
        }
        let goal = self.literal(&written.goal, &vars)?;
        Ok(Clause { vars, given, goal })
    }

    /// Reads a literal.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn literal(&self, text: &str, vars: &Vars) -> Result<Literal> {
        self.signature.literal(text, vars).or_else(|reason| fault("expression", reason))
    }

    /// Reads a polynomial.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn poly(&self, text: &str, vars: &Vars, facts: bool) -> Result<Poly> {
        self.signature.poly(text, vars, facts).or_else(|reason| fault("expression", reason))
    }

    /// Rule *definition*: there is just one function with the given first values and, from
    /// them on, `scale` times the next value equal to `step`, which reads `base.len()` values
    /// before it; nothing was known of its name. Gives the definition in words.
    ///
    /// # Errors
    /// A name that is taken, values of other arguments, or a scale that may be 0.
    pub fn define(&mut self, d: &Definition) -> Result<String> {
        const RULE: &str = "definition";
        let name = self.fresh(&d.name, &Vars::new())?;
        let mut vars = Vars::new();
        for argument in &d.of {
            let argument = self.fresh(argument, &vars)?;
            vars.push((argument, Sort::Integer));
        }
        // The last argument counts, from `start` on.
        let (parameters, start, here) = match vars.split_last() {
            None => {
                let constant = d.base.is_empty() && d.from.is_empty();
                need(constant, RULE, || "recursion without an argument")?;
                (Vars::new(), Poly::default(), Poly::default())
            }
            Some((last, parameters)) => {
                let start = self.poly(&d.from, &Vars::new(), false)?;
                let whole = self.signature.is_integer(&start, &Vars::new());
                need(whole, RULE, || "`from` is no integer")?;
                (parameters.to_vec(), start, Poly::var(&last.0))
            }
        };
        let value = |at: &Poly, j: usize| {
            let mut terms: Vec<Poly> = parameters.iter().map(|(p, _)| Poly::var(p)).collect();
            terms.extend(d.of.last().map(|_| at.clone() + &Poly::from_index(j)));
            Poly::app(&name, &terms)
        };
        let from = Literal { poly: here.clone() - &start, relation: NonNegative };
        let given: Facts = d.of.last().map(|_| ("from".into(), from)).into_iter().collect();
        let (by, sum) = d.scale.as_ref().map_or(("1", "1"), |s| (&s.by, &s.sum));
        let scale = self.poly(by, &vars, false)?;
        let positive = Literal { poly: scale.clone(), relation: Positive };
        self.sum(&positive, &[], sum, &given, &vars)?;
        let mut clauses = Vec::new();
        for (j, base) in d.base.iter().enumerate() {
            let poly = value(&start, j) - &self.poly(base, &parameters, false)?;
            let goal = Literal { poly, relation: Zero };
            let clause = Clause { vars: parameters.clone(), given: Facts::new(), goal };
            clauses.push((format!("{name}.{j}"), clause));
        }
        self.signature.functions.insert(name.clone(), (vars.len(), Sort::Real));
        let step = self.poly(&d.step, &vars, false)?;
        let known: BTreeSet<Poly> = (0..d.base.len()).map(|j| value(&here, j)).collect();
        let other = |a: &Atom| {
            matches!(a, Atom::App(f, _) if *f == name) && !known.contains(&Poly::atom(a.clone()))
        };
        need(!step.any(&other), RULE, || format!("`step` reads `{name}` at other arguments"))?;
        let poly = scale * &value(&here, d.base.len()) - &step;
        let goal = Literal { poly, relation: Zero };
        clauses.push((format!("{name}.step"), Clause { vars: vars.clone(), given, goal }));
        let words = joined(clauses.iter().map(|(_, clause)| clause), " and ");
        for (name, clause) in clauses {
            self.add(&name, clause)?;
        }
        Ok(words)
    }

    /// Checks the proof of a clause.
    ///
    /// # Errors
    /// The rule that fails, and why.
    pub fn check(&self, clause: &Clause, proof: &Proof) -> Result<()> {
        self.prove(clause, proof, &Context::default())
    }

    fn prove(&self, clause: &Clause, proof: &Proof, context: &Context) -> Result<()> {
        need(charge(128 * clause.size()), "work", || "more than a file is allowed")?;
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
        for instance in &p.instances {
            const RULE: &str = "instance";
            let lemma = context.hypotheses.get(&*instance.lemma);
            let Some(lemma) = lemma.or_else(|| self.lemmas.get(&*instance.lemma)) else {
                return fault(RULE, format!("no lemma `{:.40}`", instance.lemma));
            };
            let mut terms = BTreeMap::new();
            for (name, sort) in &lemma.vars {
                let term = self.poly(field(&instance.with, name)?, &clause.vars, false)?;
                let fits = *sort == Sort::Real || self.signature.is_integer(&term, &clause.vars);
                need(fits, RULE, || format!("`{name}` stands for integers"))?;
                terms.insert(name.clone(), term);
            }
            let fits = instance.with.0.len() == lemma.vars.len()
                && instance.given.0.len() <= lemma.given.len();
            need(fits, RULE, || {
                format!("`{:.40}` has fewer variables or literals", instance.lemma)
            })?;
            let lemma = lemma.with(&|v| terms.get(v).cloned());
            for (name, literal) in &lemma.given {
                let sum = field(&instance.given, name)?;
                self.sum(literal, &[], sum, &facts, &clause.vars)?;
            }
            let taken = self.closed.contains_key(&*instance.name);
            need(!taken, "name", || format!("the fact `{:.40}` is there twice", instance.name))?;
            insert(&mut facts, &instance.name, lemma.goal)?;
        }
        self.sum(&clause.goal, &p.times, &p.sum, &facts, &clause.vars)
    }

    /// `times` * goal is, as a polynomial, the sum; every fact of `times` is positive, and every
    /// product of the sum has a zero fact, or facts only and a coefficient above 0. For a goal =
    /// 0 all have a zero fact; for a goal > 0 one has a coefficient above 0 and positive facts only.
    fn sum(
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
        let sum = self.poly(sum, vars, true)?;
        let mut strict = false;
        for (monomial, c) in sum.terms() {
            let mut product = Positive;
            let mut facts_only = true;
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
            need(alone, RULE, || "a product without a zero fact, the goal being an equation")?;
            need(facts_only && c.is_positive(), RULE, || "a product that may be below 0")?;
            strict |= product == Positive;
        }
        let enough = goal.relation != Positive || strict;
        need(enough, RULE, || "no product that is above 0, as the goal has to be")?;
        let right = sum.substitute(&|a| match a {
            Atom::Fact(name) => fact(name).map(|l| l.poly.clone()),
            _ => None,
        });
        let rest = left - &right;
        match rest.terms().next() {
            None => Ok(()),
            Some((m, _)) if m.is_empty() => fault(RULE, "the sides differ in their constants"),
            Some((m, _)) => fault(RULE, format!("the sides differ at `{:.60}`", joined(m, "*"))),
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
        let mut equal = clause.with(&|v| (*v == *c.variable).then(|| bound.clone()));
        equal.vars.retain(|(v, _)| **v != *c.variable);
        let mut beyond = clause.clone();
        for (name, literal) in &mut beyond.given {
            if **name == *c.on {
                *literal = literal.map(|p| p.clone() - &Poly::whole(1));
            }
        }
        self.prove(&equal, &c.equal, context)?;
        self.prove(&beyond, &c.beyond, context)
    }

    /// Rule *split*: a real number is above, equal to or below 0; an integer at least 1, 0 or at most -1.
    fn split(&self, clause: &Clause, s: &Split, context: &Context) -> Result<()> {
        let poly = self.poly(&s.on, &clause.vars, false)?;
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
            let words = format!("`{:.40}` does not bound `{:.40}` below", i.on, i.variable);
            return fault(RULE, words);
        };
        let differs = clause.vars.iter().any(|(v, _)| general(v) && bound.has(v));
        need(!differs, RULE, || "the bound differs with the variables")?;
        let earlier = self.fresh(&i.earlier, &clause.vars)?;
        let at = |p: Poly| move |v: &str| (*v == *i.variable).then(|| p.clone());
        let (variable, one) = (Poly::var(&i.variable), Poly::whole(1));
        let mut base = clause.with(&at(bound));
        base.vars.retain(|(v, _)| **v != *i.variable);
        let mut step = clause.with(&at(variable.clone() + &one));
        step.given.extend(clause.given.get_key_value(&*i.on).map(|(n, l)| (n.clone(), l.clone())));
        let mut hypothesis = clause.with(&at(Poly::var(&earlier)));
        hypothesis.vars.retain(|(v, _)| **v != *i.variable && general(v));
        hypothesis.vars.push((earlier.clone(), Sort::Integer));
        let no_later = Literal { poly: variable - &Poly::var(&earlier), relation: NonNegative };
        insert(&mut hypothesis.given, &earlier, no_later)?;
        let mut inner = context.clone();
        inner.fixed.insert(i.variable.as_str().into());
        let taken = inner.hypotheses.insert(i.hypothesis.as_str().into(), hypothesis).is_some()
            || self.lemmas.contains_key(&*i.hypothesis);
        need(!taken, RULE, || format!("`{:.40}` is there twice", i.hypothesis))?;
        self.prove(&base, &i.base, context)?;
        self.prove(&step, &i.step, &inner)
    }
}

fn field<'n>(all: &'n Named<String>, name: &str) -> Result<&'n str> {
    let missing = || fault("instance", format!("nothing stands for `{name:.40}`"));
    all.0.get(name).map_or_else(missing, |text| Ok(text.as_str()))
}

fn insert(facts: &mut Facts, name: &str, literal: Literal) -> Result<()> {
    let taken = facts.insert(name.into(), literal).is_some();
    need(!taken, "name", || format!("the fact `{name:.40}` is there twice"))?;
    Ok(())
}
