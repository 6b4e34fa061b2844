//! Users' protocols on a line or a ring, for every number of agents at once.
//!
//! Candidates are the claims and what is assumed of the start. Each is tried by induction over the
//! steps, with cases over the agents (the first, the last, those between): the literal one step later is a sum of
//! products of what is known of the neighbours now, of what has been proved already, and of the ranges of the parameters. What
//! holds strictly may need cases over a parameter too. Whatever comes out, the checker judges.

mod sums;
mod text;

use std::collections::BTreeMap;

use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Premises, Sign};
use cordon_core::scalar::Polynomial;
use cordon_core::simplex::Work;
use cordon_core::system::expression::{add_term, or_zero};
use cordon_core::{Error, Rational, Result, exact};
use cordon_run::protocol::Family;
use cordon_spec::Scalar;
use num_traits::Zero;
use serde_json::{Value, json};

use crate::claims::search::End;

use super::builder::{Sheet, absurd, cases, clause, induction, instance, positivity, split};
use sums::{Fact, sum};
use text::{Literal, Place, Reader, Symbol, Symbols};

/// The fact that says on which side of the middle of its range a parameter is.
const HALF: &str = "half";

/// Most work that the linear programs of a search may take.
const WORK: u64 = 200_000_000;

/// What was found.
#[derive(Clone, Debug)]
pub struct AnySize {
    /// The certificate, with the claims that are proved as conclusions; none where no claim is.
    pub certificate: Option<Value>,
    /// How many clauses make up the invariant, the claims among them.
    pub invariant: usize,
    /// The claims that are not proved, by their places, with the reason.
    pub open: Vec<(usize, String)>,
}

/// A literal about agents, at every step: known, assumed of the start, or to be proved.
#[derive(Clone, Debug)]
struct Clause {
    name: String,
    literal: Literal,
    /// If it is about every i: the furthest neighbour, so that i runs from 0 to `last` minus that.
    reach: Option<i64>,
}

/// The class of agents that a case is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Case {
    First,
    Inner,
    Last,
    /// All at once.
    Any,
}

/// A certificate for every N of the claims for which the strategy finds one. That it finds none does not
/// mean that a claim is false.
///
/// # Errors
/// A rule or an assumption is no expression, or speaks of agents or powers that the strategy has no cases
/// for.
pub fn any_size(family: &Family) -> Result<AnySize> {
    let symbols = Symbols::default();
    let known = |name: &str| family.parameters.contains_key(name);
    let reader = Reader { symbols: &symbols, state: &family.state, constants: &known };
    let clauses = |prefix: &str, from: usize, texts: &[String]| -> Result<Vec<Clause>> {
        let named = (from..).zip(texts).map(|(j, t)| (format!("{prefix}{j}"), t));
        named.map(|(name, t)| read_clause(&reader, name, t)).collect()
    };
    let mut rules = BTreeMap::new();
    for (class, of) in &family.rules {
        for (variable, text) in of {
            rules.insert((class.as_str(), variable.as_str()), reader.polynomial(text)?);
        }
    }
    let starts = clauses("S", 0, &family.start)?;
    let mut count = 0;
    let mut claims: Vec<std::result::Result<Vec<Clause>, String>> = Vec::new();
    for claim in &family.claims {
        claims.push(claim.literals.clone().and_then(|literals| {
            let read = clauses("C", count, &literals).map_err(|e| e.to_string())?;
            count += read.len();
            Ok(read)
        }));
    }
    let mut candidates: Vec<Clause> = claims.iter().flatten().flatten().cloned().collect();
    for s in &starts {
        if !candidates.iter().any(|c| c.literal == s.literal && c.reach == s.reach) {
            candidates.push(s.clone());
        }
    }
    for (j, c) in candidates.iter_mut().enumerate() {
        c.name = format!("L{j}");
    }
    let mut about_constants = Vec::new();
    for (name, ends) in &family.parameters {
        for (end, value, sign) in [("from", &ends[0], 1), ("to", &ends[1], -1)] {
            if let Some(value) = value {
                let variable = symbols.variable(Symbol::Name(name.clone()));
                let poly =
                    (variable - &Polynomial::constant(value.clone())) * &Polynomial::from_int(sign);
                let literal = Literal { poly, sign: Sign::NonNegative };
                about_constants.push(Fact { name: format!("{name}.{end}"), literal });
            }
        }
    }
    let mut sheet = Sheet::of_family(written(family, &symbols, &rules));
    for (j, text) in family.given.iter().enumerate() {
        let literal = reader.literal(text)?;
        if !symbols.agents(&literal.poly).is_empty() {
            return Err(Error::input(format!("`{}`: expected no agents", exact::shortened(text))));
        }
        let name = format!("G{j}");
        sheet.assume(clause(&name, "", &[], &goal(&symbols, &literal, "k")));
        about_constants.push(Fact { name, literal });
    }
    for s in &starts {
        sheet.assume(s.written(&symbols, "0", false));
    }
    let degree = rules.values().map(|p| degree(&symbols, p)).max().unwrap_or(0);
    let mut search = Search {
        family,
        symbols: &symbols,
        rules,
        starts,
        about_constants,
        degree,
        work: Work::limited(WORK),
        proved: Vec::new(),
    };
    // Claims that rest on others wait for them.
    loop {
        let before = candidates.len();
        let mut open = Vec::new();
        for candidate in candidates {
            match search.proof(&candidate) {
                Some(proof) => {
                    sheet.lemma(candidate.written(&symbols, "k", true), proof);
                    search.proved.push(candidate);
                }
                None => open.push(candidate),
            }
        }
        candidates = open;
        if candidates.len() == before && !search.mutual(&mut candidates, &mut sheet) {
            break;
        }
    }
    let lemma = |claim: &Clause| {
        let same = |l: &&Clause| l.literal == claim.literal && l.reach == claim.reach;
        search.proved.iter().find(same)
    };
    let none = || {
        let why = if search.work.left() == 0 { End::Work.to_string() } else { NO_INDUCTION.into() };
        Err(why)
    };
    let mut open = Vec::new();
    for (place, claim) in claims.into_iter().enumerate() {
        let with_lemma = |c: Clause| lemma(&c).map(|lemma| (c, lemma));
        let found = claim.and_then(|own| {
            own.into_iter().map(with_lemma).collect::<Option<Vec<_>>>().map_or_else(none, Ok)
        });
        match found {
            Err(why) => open.push((place, why)),
            Ok(found) => {
                for (claim, lemma) in found {
                    let (with, given) = match claim.reach {
                        Some(_) => ("k=k, i=i", "k=[k], i=[i], u=[u]"),
                        None => ("k=k", "k=[k]"),
                    };
                    let proof = positivity(&[instance("c", &lemma.name, with, given)], "[c]");
                    sheet.conclude(claim.written(&symbols, "k", true), proof);
                }
            }
        }
    }
    Ok(AnySize {
        certificate: (open.len() < family.claims.len()).then(|| sheet.certificate()),
        invariant: search.proved.len(),
        open,
    })
}

/// Why a claim is open that was tried to the end.
const NO_INDUCTION: &str = "no induction over the steps was found";

/// The power of the constants together.
fn degree(symbols: &Symbols, p: &Polynomial) -> usize {
    let names = |m| symbols.factors(m).iter().filter(|s| matches!(s, Symbol::Name(_))).count();
    p.terms().map(|(m, _)| names(m)).max().unwrap_or(0)
}

fn read_clause(reader: &Reader<'_>, name: String, text: &str) -> Result<Clause> {
    let literal = reader.literal(text)?;
    let agents = reader.symbols.agents(&literal.poly);
    let fail = |expected: &str| {
        Err(Error::input(format!("`{}`: expected {expected}", exact::shortened(text))))
    };
    let several = |m| {
        let all = reader.symbols.factors(m);
        all.iter().filter(|s| matches!(s, Symbol::At(..))).count() > 1
    };
    if agents.is_empty() || literal.poly.terms().any(|(m, _)| several(m)) {
        return fail("agents, and no products of them");
    }
    let inner: Vec<i64> = agents
        .iter()
        .filter_map(|(_, place)| if let Place::Inner(o) = place { Some(*o) } else { None })
        .collect();
    let reach = inner.iter().max().copied();
    match (inner.iter().min(), reach) {
        (None, None) | (Some(0), Some(0 | 1)) => Ok(Clause { name, literal, reach }),
        _ => fail("agents i, or i and i+1"),
    }
}

/// The literal in the checker's words, agents at a step.
fn goal(symbols: &Symbols, literal: &Literal, time: &str) -> String {
    let sign = match literal.sign {
        Sign::Positive => ">",
        Sign::NonNegative => ">=",
        Sign::Zero => "=",
    };
    format!("{} {sign} 0", symbols.write(&literal.poly, time))
}

impl Clause {
    /// As a clause of the certificate, for every step or about one.
    fn written(&self, symbols: &Symbols, time: &str, every_step: bool) -> Value {
        let mut given = Vec::new();
        if every_step {
            given.push("k: k >= 0".to_owned());
        }
        if let Some(reach) = self.reach {
            given.push("i: i >= 0".to_owned());
            given.push(format!("u: last - {reach} - i >= 0"));
        }
        let vars = [every_step.then_some("k"), self.reach.map(|_| "i")];
        let vars: Vec<&str> = vars.into_iter().flatten().collect();
        let given: Vec<&str> = given.iter().map(String::as_str).collect();
        clause(&self.name, &vars.join(" "), &given, &goal(symbols, &self.literal, time))
    }

    /// The polynomial with the agents of i at a place.
    fn at(&self, symbols: &Symbols, place: Place) -> Polynomial {
        symbols.with(&self.literal.poly, &|s| moved(symbols, s, place))
    }
}

/// The symbol with a place for agent i.
fn moved(symbols: &Symbols, symbol: &Symbol, place: Place) -> Polynomial {
    let index = |p: Place| match p {
        Place::First(o) => Polynomial::from_int(i32::try_from(o).unwrap_or(0)),
        Place::Inner(o) => {
            symbols.variable(Symbol::Name("i".into()))
                + &Polynomial::from_int(i32::try_from(o).unwrap_or(0))
        }
        Place::Last(o) => {
            symbols.variable(Symbol::Name("last".into()))
                + &Polynomial::from_int(i32::try_from(o).unwrap_or(0))
        }
    };
    match symbol {
        Symbol::At(name, Place::Inner(o)) => {
            symbols.variable(Symbol::At(name.clone(), place.plus(*o)))
        }
        Symbol::Name(name) if name == "i" => index(place),
        other => symbols.variable(other.clone()),
    }
}

/// The family in the checker's words.
fn written(
    family: &Family,
    symbols: &Symbols,
    rules: &BTreeMap<(&str, &str), Polynomial>,
) -> Value {
    let mut classes = serde_json::Map::new();
    for class in family.rules.keys() {
        let of = rules.iter().filter(|((c, _), _)| c == class);
        let of: serde_json::Map<_, _> =
            of.map(|((_, v), p)| ((*v).to_owned(), json!(symbols.write(p, "k")))).collect();
        classes.insert(class.clone(), Value::Object(of));
    }
    let mut parameters = serde_json::Map::new();
    for (name, ends) in &family.parameters {
        let mut range = serde_json::Map::new();
        for (end, value) in ["from", "to"].into_iter().zip(ends) {
            if let Some(value) = value {
                range.insert(end.into(), json!(exact::fraction(value)));
            }
        }
        parameters.insert(name.clone(), Value::Object(range));
    }
    let topology = if family.is_ring { "ring" } else { "line" };
    json!({ "topology": topology, "state": family.state, "parameters": parameters, "rules": classes })
}

struct Search<'f> {
    family: &'f Family,
    symbols: &'f Symbols,
    rules: BTreeMap<(&'f str, &'f str), Polynomial>,
    starts: Vec<Clause>,
    about_constants: Vec<Fact>,
    degree: usize,
    work: Work,
    proved: Vec<Clause>,
}

/// A hypothesis of an induction: its clause, and how an instance begins.
type Hypothesis = (Clause, String, String);

/// A linear form in k, i, last, and its constant.
type Index = [i64; 4];

impl Search<'_> {
    /// Proves some of the candidates together, those of the same relation and range; whether there are any.
    fn mutual(&mut self, candidates: &mut Vec<Clause>, sheet: &mut Sheet) -> bool {
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
            let instance = instance("c", &name, &format!("k=k, s={j}{}", more.0), &given);
            sheet.lemma(c.written(self.symbols, "k", true), positivity(&[instance], "[c]"));
        }
        candidates.retain(|c| !all.iter().any(|p| p.name == c.name));
        self.proved.extend(all);
        true
    }

    /// A proof of the clause by induction over the steps.
    fn proof(&self, candidate: &Clause) -> Option<Value> {
        let hypothesis = Clause { name: "IH".into(), ..candidate.clone() };
        let [base, step] =
            self.parts(candidate, &[(hypothesis, "t=k".into(), "k=[k], t=0".into())])?;
        Some(induction("k", "k", "t", base, step))
    }

    /// A clause that says all of several, of the same relation and range, with a variable s for which: for those that need each
    /// other. What cannot be shown with the help of all is left out.
    fn together(&self, mut all: Vec<Clause>, name: &str) -> Option<(Value, Value, Vec<Clause>)> {
        loop {
            let most = all.len().checked_sub(1).filter(|most| *most > 0)?;
            let hypotheses: Vec<_> = (0..)
                .zip(&all)
                .map(|(j, c)| {
                    let hypothesis = Clause { name: "IH".into(), ..c.clone() };
                    let given = format!("k=[k], t=0, s={j}, r={}", most - j);
                    (hypothesis, format!("t=k, s={j}"), given)
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
                proofs.fold(none, |rest, p| cases("s", "s", p[part].clone(), rest))
            };
            let proof = induction("k", "k", "t", which(0), which(1));
            // Lagrange's polynomials in s: 1 at the literal's number, 0 at the others'.
            let s = self.symbols.variable(Symbol::Name("s".into()));
            let number = |n: usize| Polynomial::from_int(i32::try_from(n).unwrap_or(i32::MAX));
            let terms = all.iter().enumerate().map(|(j, c)| {
                let others = (0..=most).filter(|l| *l != j);
                others.fold(c.literal.poly.clone(), |p, l| {
                    let scale = Rational::new(1.into(), (j as i64 - l as i64).into());
                    p * &((s.clone() - &number(l)) * &Polynomial::constant(scale))
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
                ("for", vec![json!({ "name": "s", "sort": "integer" })]),
                (
                    "given",
                    vec![
                        json!({ "name": "s", "holds": "s >= 0" }),
                        json!({ "name": "r", "holds": format!("{most} - s >= 0") }),
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
        let base = |case: Case| self.base(candidate, case);
        let step = |case: Case| self.step(candidate, case, hypotheses);
        let by_class = |leaf: &dyn Fn(Case) -> Option<Value>| match candidate.reach {
            None => leaf(Case::Any),
            Some(_) => {
                let beyond = cases("u", "i", leaf(Case::Last)?, leaf(Case::Inner)?);
                Some(cases("i", "i", leaf(Case::First)?, beyond))
            }
        };
        Some([base(Case::Any).or_else(|| by_class(&base))?, by_class(&step)?])
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
            let class = if self.family.is_ring { "all" } else { class };
            let rule = self.rules.get(&(class, variable.as_str()));
            let own = symbols.variable(Symbol::At(variable.clone(), *place));
            let next = rule.map_or(own, |rule| symbols.with(rule, &|s| self.wrapped(s, *place)));
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
