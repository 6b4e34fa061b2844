//! Inductions over the steps, with cases over the agents.

use std::collections::BTreeMap;

use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Premises, Sign};
use cordon_core::scalar::Polynomial;
use cordon_core::simplex::Work;
use cordon_core::system::expression::{add_term, or_zero};
use cordon_run::protocol::Family;
use cordon_spec::Scalar;
use num_traits::Zero;
use serde_json::{Value, json};

use super::clause::{Clause, moved};
use super::sums::{Fact, sum};
use super::text::{Literal, Place, Symbol, Symbols};
use crate::certificate::theorem::{
    Sheet, absurd, cases, clause, induction, instance, positivity, split,
};

/// The fact that says on which side of the middle of its range a parameter is.
const HALF: &str = "half";

/// The class of agents that a case is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Case {
    First,
    Inner,
    Last,
    /// All at once.
    Any,
}

/// The search under way.
pub struct Search<'f> {
    pub family: &'f Family,
    pub symbols: &'f Symbols,
    pub rules: BTreeMap<(&'f str, &'f str), Polynomial>,
    pub starts: Vec<Clause>,
    pub about_constants: Vec<Fact>,
    pub degree: usize,
    pub work: Work,
    pub proved: Vec<Clause>,
}

/// A hypothesis of an induction: its clause, and how an instance begins.
type Hypothesis = (Clause, String, String);

/// A linear form in k, i, last, and its constant.
type Index = [i64; 4];

impl Search<'_> {
    /// Proves some of the candidates together, those of the same relation and range; whether there are any.
    pub fn mutual(&mut self, candidates: &mut Vec<Clause>, sheet: &mut Sheet) -> bool {
        let alike = |a: &Clause, b: &Clause| a.literal.sign == b.literal.sign && a.reach == b.reach;
        let groups = candidates.iter().map(|first| {
            candidates.iter().filter(|c| alike(c, first)).cloned().collect::<Vec<_>>()
        });
        let name = format!("M{}", self.proved.len());
        let Some((clause, proof, all)) = groups.into_iter().find_map(|g| self.together(g, &name))
        else {
            return false;
        };
        sheet.lemma(clause, proof);
        for (j, c) in all.iter().enumerate() {
            let more = if c.reach.is_some() { (", i=i", ", i=[i], u=[u]") } else { ("", "") };
            let given = format!("k=[k], s={j}, r={}{}", all.len() - 1 - j, more.1);
            let s = self.unused("s");
            let instance = instance("c", &name, &format!("k=k, {s}={j}{}", more.0), &given);
            sheet.lemma(c.written(self.symbols, "k", true), positivity(&[instance], "[c]"));
        }
        candidates.retain(|c| !all.iter().any(|p| p.name == c.name));
        self.proved.extend(all);
        true
    }

    /// A variable of that name, longer where the protocol has one.
    fn unused(&self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        while self.family.state.contains(&name) || self.family.parameters.contains_key(&name) {
            name.push('x');
        }
        name
    }

    /// A proof of the clause by induction over the steps.
    pub fn proof(&self, candidate: &Clause) -> Option<Value> {
        let hypothesis = Clause { name: "IH".into(), ..candidate.clone() };
        let t = self.unused("t");
        let hypothesis = (hypothesis, format!("{t}=k"), format!("k=[k], {t}=0"));
        let [base, step] = self.parts(candidate, &[hypothesis])?;
        Some(induction("k", "k", &t, base, step))
    }

    /// A clause that says all of several, of the same relation and range, with a variable s for which: for those that need each
    /// other. What cannot be shown with the help of all is left out.
    fn together(&self, mut all: Vec<Clause>, name: &str) -> Option<(Value, Value, Vec<Clause>)> {
        let [s, t] = ["s", "t"].map(|wanted| self.unused(wanted));
        loop {
            let most = all.len().checked_sub(1).filter(|most| *most > 0)?;
            let hypotheses: Vec<_> = (0..)
                .zip(&all)
                .map(|(j, c)| {
                    let hypothesis = Clause { name: "IH".into(), ..c.clone() };
                    let given = format!("k=[k], {t}=0, s={j}, r={}", most - j);
                    (hypothesis, format!("{t}=k, {s}={j}"), given)
                })
                .collect();
            let parts: Vec<_> = all.iter().map(|c| self.parts(c, &hypotheses)).collect();
            if parts.iter().any(Option::is_none) {
                let mut shown = parts.iter();
                all.retain(|_| shown.next().is_some_and(Option::is_some));
                continue;
            }
            let which = |part: usize| {
                let none = absurd(&[], "[s] + [r]");
                let proofs = parts.iter().flatten().rev();
                proofs.fold(none, |rest, p| cases("s", &s, p[part].clone(), rest))
            };
            let proof = induction("k", "k", &t, which(0), which(1));
            // Lagrange's polynomials in s: 1 at the literal's number, 0 at the others'.
            let which = self.symbols.variable(Symbol::Name(s.clone()));
            let number = |n: usize| Polynomial::from_int(i32::try_from(n).unwrap_or(i32::MAX));
            let terms = all.iter().enumerate().map(|(j, c)| {
                let others = (0..=most).filter(|l| *l != j);
                others.fold(c.literal.poly.clone(), |p, l| {
                    let scale = Rational::new(1.into(), (j as i64 - l as i64).into());
                    p * &((which.clone() - &number(l)) * &Polynomial::constant(scale))
                })
            });
            let poly = terms.fold(Polynomial::default(), |sum, t| sum + &t);
            let first = all.first()?;
            let whole = Clause {
                name: name.into(),
                literal: Literal { poly, ..first.literal.clone() },
                ..first.clone()
            };
            let mut written = whole.written(self.symbols, "k", true);
            for (key, more) in [
                ("for", vec![json!({ "name": s, "sort": "integer" })]),
                (
                    "given",
                    vec![
                        json!({ "name": "s", "holds": format!("{s} >= 0") }),
                        json!({ "name": "r", "holds": format!("{most} - {s} >= 0") }),
                    ],
                ),
            ] {
                written[key].as_array_mut()?.extend(more);
            }
            return Some((written, proof, all));
        }
    }

    /// Proofs of the literal at step 0 and one step later.
    fn parts(&self, candidate: &Clause, hypotheses: &[Hypothesis]) -> Option<[Value; 2]> {
        let step = |case: Case| self.step(candidate, case, hypotheses);
        Some([self.of_start(candidate)?, Self::by_class(candidate, &step)?])
    }

    /// A proof of the literal at step 0.
    pub fn of_start(&self, candidate: &Clause) -> Option<Value> {
        let base = |case: Case| self.base(candidate, case);
        base(Case::Any).or_else(|| Self::by_class(candidate, &base))
    }

    fn by_class(candidate: &Clause, leaf: &dyn Fn(Case) -> Option<Value>) -> Option<Value> {
        match candidate.reach {
            None => leaf(Case::Any),
            Some(_) => {
                let beyond = cases("u", "i", leaf(Case::Last)?, leaf(Case::Inner)?);
                Some(cases("i", "i", leaf(Case::First)?, beyond))
            }
        }
    }

    /// Where agent i is in a case.
    fn place(candidate: &Clause, case: Case) -> Place {
        match case {
            Case::First => Place::First(0),
            Case::Last => Place::Last(-candidate.reach.unwrap_or(0)),
            Case::Inner | Case::Any => Place::Inner(0),
        }
    }

    /// What is known of indices in a case: names, and forms that are >= 0.
    fn indices(candidate: &Clause, case: Case) -> Vec<(&'static str, Index)> {
        let mut known = vec![("n", [0, 0, 1, -2])];
        if let Some(reach) = candidate.reach {
            known.extend(match case {
                Case::Any => vec![("i", [0, 1, 0, 0]), ("u", [0, -1, 1, -reach])],
                Case::First => vec![("u", [0, 0, 1, -reach])],
                Case::Inner => vec![("i", [0, 1, 0, -1]), ("u", [0, -1, 1, -reach - 1])],
                Case::Last => vec![("i", [0, 0, 1, -reach - 1])],
            });
        }
        known
    }

    /// A form of indices as a sum of what is known of them.
    fn guard(known: &[(&'static str, Index)], form: Index) -> Option<String> {
        let affine = |f: Index| {
            let [k, i, last, constant] = f.map(|c| Rational::from_integer(c.into()));
            Constraint { form: Affine::new(constant, vec![k, i, last]), sign: Sign::NonNegative }
        };
        let given: Vec<Constraint> = known.iter().map(|(_, f)| affine(*f)).collect();
        let multipliers = Premises::new(&given)?.multipliers(&affine(form))?;
        let mut text = String::new();
        let mut rest = Rational::from_integer(form[3].into());
        for (m, (name, f)) in multipliers.iter().zip(known).filter(|(m, _)| !m.is_zero()) {
            add_term(&mut text, m, &[&format!("[{name}]")]);
            rest -= m * Rational::from_integer(f[3].into());
        }
        if !rest.is_zero() {
            add_term(&mut text, &rest, &[]);
        }
        Some(or_zero(text))
    }

    /// The instances of a clause near some agents, as facts with their names.
    fn instances(
        &self,
        of: &Clause,
        near: &[Place],
        indices: &[(&'static str, Index)],
        name: &str,
        (with, given): (&str, &str),
        found: &mut Vec<(Value, Fact)>,
    ) {
        let fact = |name: &str, poly| Fact {
            name: name.to_owned(),
            literal: Literal { poly, sign: of.literal.sign },
        };
        let Some(reach) = of.reach else {
            let value = instance(name, &of.name, with, given);
            found.push((value, fact(name, of.literal.poly.clone())));
            return;
        };
        for (j, place) in near.iter().enumerate() {
            if !(0..=reach).all(|o| near.contains(&place.plus(o))) {
                continue;
            }
            let index = match *place {
                Place::First(o) => [0, 0, 0, o],
                Place::Inner(o) => [0, 1, 0, o],
                Place::Last(o) => [0, 0, 1, o],
            };
            let room = [0, -index[1], 1 - index[2], -index[3] - reach];
            let (Some(i), Some(u)) = (Self::guard(indices, index), Self::guard(indices, room))
            else {
                continue;
            };
            let join = |a: &str, b: String| if a.is_empty() { b } else { format!("{a}, {b}") };
            let name = format!("{name}-{j}");
            let with = join(with, format!("i={}", place.written()));
            let value = instance(&name, &of.name, &with, &join(given, format!("i={i}, u={u}")));
            found.push((value, fact(&name, of.at(self.symbols, *place))));
        }
    }

    /// The literal at step 0, from what is assumed of the start.
    fn base(&self, candidate: &Clause, case: Case) -> Option<Value> {
        let poly = candidate.at(self.symbols, Self::place(candidate, case));
        let near: Vec<Place> = self.symbols.agents(&poly).into_iter().map(|(_, p)| p).collect();
        let indices = Self::indices(candidate, case);
        let mut found = Vec::new();
        for s in &self.starts {
            self.instances(s, &near, &indices, &s.name.to_lowercase(), ("", ""), &mut found);
        }
        self.leaf(&Literal { poly, sign: candidate.literal.sign }, &found, &[], "")
    }

    /// The literal one step later.
    fn step(&self, candidate: &Clause, case: Case, hypotheses: &[Hypothesis]) -> Option<Value> {
        let symbols = self.symbols;
        let poly = candidate.at(symbols, Self::place(candidate, case));
        let mut indices = Self::indices(candidate, case);
        indices.push(("k", [1, 0, 0, 0]));
        // What the rules make of each agent: as a polynomial, and as an instance.
        let (mut used, mut rest, mut after) = (Vec::new(), String::new(), BTreeMap::new());
        for (j, agent) in symbols.agents(&poly).into_iter().enumerate() {
            let (variable, place) = &agent;
            let (class, with, given) = match place {
                Place::First(0) => ("first", "k=k".to_owned(), "k=[k]".to_owned()),
                Place::Last(0) => ("last", "k=k".to_owned(), "k=[k]".to_owned()),
                _ => {
                    let index = match *place {
                        Place::First(o) => [0, 0, 0, o],
                        Place::Inner(o) => [0, 1, 0, o],
                        Place::Last(o) => [0, 0, 1, o],
                    };
                    let low = Self::guard(&indices, [0, index[1], index[2], index[3] - 1])?;
                    let high = Self::guard(&indices, [0, -index[1], 1 - index[2], -index[3] - 1])?;
                    (
                        "inner",
                        format!("k=k, i={}", place.written()),
                        format!("k=[k], i={low}, n={high}"),
                    )
                }
            };
            let name = format!("h{j}");
            used.push(instance(&name, &format!("step.{variable}.{class}"), &with, &given));
            rest += &format!(" + ({})*[{name}]", symbols.write(&symbols.slope(&poly, &agent), "k"));
            let next = self.after(class, variable, *place);
            after.insert(agent, next);
        }
        let next = symbols.with(&poly, &|s| match s {
            Symbol::At(name, place) => {
                after.get(&(name.clone(), *place)).cloned().unwrap_or_default()
            }
            name => symbols.variable(name.clone()),
        });
        let mut near: Vec<Place> = Vec::new();
        for (_, place) in symbols.agents(&next).into_iter().chain(symbols.agents(&poly)) {
            if !near.contains(&place) {
                near.push(place);
            }
        }
        let mut found = Vec::new();
        for (j, (hypothesis, with, given)) in hypotheses.iter().enumerate() {
            let with = (with.as_str(), given.as_str());
            self.instances(hypothesis, &near, &indices, &format!("g{j}"), with, &mut found);
        }
        for lemma in &self.proved {
            self.instances(
                lemma,
                &near,
                &indices,
                &lemma.name.to_lowercase(),
                ("k=k", "k=[k]"),
                &mut found,
            );
        }
        self.leaf(&Literal { poly: next, sign: candidate.literal.sign }, &found, &used, &rest)
    }

    /// The variable of an agent of that class one step later.
    fn after(&self, class: &str, variable: &str, place: Place) -> Polynomial {
        let class = if self.family.is_ring { "all" } else { class };
        let own = || self.symbols.variable(Symbol::At(variable.to_owned(), place));
        self.rules
            .get(&(class, variable))
            .map_or_else(own, |rule| self.symbols.with(rule, &|s| self.wrapped(s, place)))
    }

    /// States the variables, and what a step makes of them: clauses `step.x.first`, `.inner` and `.last`.
    pub fn assume_steps(&self, sheet: &mut Sheet) {
        let inner = ["k: k >= 0", "i: i - 1 >= 0", "n: last - 1 - i >= 0"];
        for x in &self.family.state {
            sheet.function(x, 2, "real");
            for (class, place, vars, given) in [
                ("first", Place::First(0), "k", &inner[..1]),
                ("inner", Place::Inner(0), "k i", &inner[..]),
                ("last", Place::Last(0), "k", &inner[..1]),
            ] {
                let next = self.symbols.write(&self.after(class, x, place), "k");
                let goal = format!("{x}(k+1,{}) = {next}", place.written());
                sheet.assume(clause(&format!("step.{x}.{class}"), vars, given, &goal));
            }
        }
    }

    /// A symbol of a rule of the agent at a place.
    fn wrapped(&self, symbol: &Symbol, place: Place) -> Polynomial {
        let wrapped = |p: Place| match p {
            Place::First(-1) => Place::Last(0),
            Place::Last(1) => Place::First(0),
            other => other,
        };
        match symbol {
            Symbol::At(name, Place::Inner(o)) => {
                self.symbols.variable(Symbol::At(name.clone(), wrapped(place.plus(*o))))
            }
            other => moved(self.symbols, other, place),
        }
    }

    /// The goal as a sum, with `rest` for what a step adds; by cases over a parameter if need be.
    fn leaf(
        &self,
        goal: &Literal,
        found: &[(Value, Fact)],
        used: &[Value],
        rest: &str,
    ) -> Option<Value> {
        let facts: Vec<Fact> = found.iter().map(|(_, f)| f.clone()).collect();
        let proof = |about: &[Fact]| {
            let (text, names) = sum(goal, &facts, about, self.degree, &self.work)?;
            let needed =
                found.iter().filter(|(_, f)| names.contains(&f.name)).map(|(v, _)| v.clone());
            let all: Vec<Value> = used.iter().cloned().chain(needed).collect();
            Some(positivity(&all, &format!("{text}{rest}")))
        };
        proof(&self.about_constants).or_else(|| {
            self.family.parameters.iter().find_map(|(name, ends)| {
                let [Some(from), Some(to)] = ends else { return None };
                let middle = (from + to) / Rational::from_integer(2.into());
                let p = self.symbols.variable(Symbol::Name(name.clone()))
                    - &Polynomial::constant(middle);
                let branch = |poly: Polynomial, sign: Sign| {
                    let more = Fact { name: HALF.into(), literal: Literal { poly, sign } };
                    proof(&[self.about_constants.as_slice(), &[more]].concat())
                };
                let above = branch(p.clone(), Sign::Positive)?;
                let equal = branch(p.clone(), Sign::Zero)?;
                let below = branch(Polynomial::from_int(0) - &p, Sign::Positive)?;
                Some(split(HALF, &self.symbols.write(&p, "k"), [above, equal, below]))
            })
        })
    }
}
