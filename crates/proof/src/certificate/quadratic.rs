//! Convergence by a quadratic form, and the lack of it, as theorems.
//!
//! Readouts y(k) and a form V(k) of them are defined in the statement. If in every step V falls to rate^2 of it at most, and is
//! at least delta |y|^2, then all y tend to 0. If V never falls, and is above 0 at the start, they do not.
//!
//! A step mixes the maps A_v of modes and ends of ranges with weights w_v: u = sum of w_v A_v z. With P >= 0
//!
//! rate^2 z'Pz - u'Pu = sum of w_v (rate^2 z'Pz - (A_v z)'P(A_v z)) + sum of w_v (A_v z - u)'P(A_v z - u),
//!
//! so that rate^2 P - A_v'P A_v >= 0 at each v is enough; that, and P - delta >= 0, are shown as sums of squares.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use serde_json::Value;

use super::linear::{LinearSystem, form};
use super::runs::{Runs, Time, Turns};
use super::squares::squares;
use super::theorem::{Sheet, clause, induction, instance, positivity, split};
use crate::claims::doubles::negative_direction;
use cordon_core::Rational;
use cordon_core::exact::{self, fraction};
use cordon_core::linear::affine::Affine;
use cordon_core::linear::matrix::{self, Matrix, product, transposed};
use cordon_core::scalar::Polynomial;
use cordon_core::system::expression::{add_term, or_zero};

/// What readouts y of a system do, by a quadratic form y'Py.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadratic {
    /// What runs.
    pub system: LinearSystem,
    /// y0, y1, ...: affine forms of the state.
    pub readouts: Vec<Affine>,
    /// By the name of the mode, for each readout what it is after a step: by the place of a readout its coefficient,
    /// affine in each of the `parameters`.
    pub maps: BTreeMap<String, Vec<BTreeMap<usize, Polynomial>>>,
    /// The parameters' names, in the order in which coefficients count them.
    pub parameters: Vec<String>,
    /// P for all modes; or one for each mode in the order of their names, which measures where that mode acts next.
    pub forms: Vec<Matrix>,
    /// What is shown.
    pub course: Course,
}

/// What a form does in the course of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Course {
    /// Its root falls to so much of it at most, in every step: 0 <= rate < 1. All y tend to 0.
    Falls(Rational),
    /// It never falls, from this state, where it is above 0. The y do not tend to 0. For one mode, without ranges.
    Stays(Vec<Rational>),
}

/// A parameter in polynomials: a number, or a function with its range.
enum Parameter {
    Point(Rational),
    Range(String, [Rational; 2]),
}

/// The mixed lemmas: how many times u the equations speak of, how many times the difference each does, and its roots.
#[derive(Default)]
struct Mixed {
    unit: Rational,
    times: Vec<Rational>,
    roots: Vec<Shown>,
}

/// A map at the ends of ranges: its mode, and its weight in a step, a number times facts.
struct Vertex {
    mode: usize,
    factor: Rational,
    facts: Vec<String>,
    map: Matrix,
}

type Names = Vec<String>;

/// A combination, by the places of its variables.
type Terms = Vec<(usize, Rational)>;

/// What shows that so many times a form is at least 0: literals given, facts and their sum, and what the roots are.
#[derive(Default)]
struct Shown {
    times: Rational,
    given: Names,
    facts: Vec<Value>,
    sum: String,
    roots: Vec<Terms>,
}

/// A certificate in the making.
struct Writer<'q> {
    quadratic: &'q Quadratic,
    sheet: Sheet,
    runs: Runs,
    /// The step that clauses speak of.
    now: Time,
    values: Vec<Parameter>,
    /// Functions: the readouts, V, and the part of V(0) that is left at most.
    y: Names,
    form: String,
    bound: String,
    /// Variables of lemmas about reals: readouts before a step and after it, weights, roots of squares.
    z: Names,
    u: Names,
    w: String,
    q: String,
    s: String,
    values_of_form: [String; 2],
    earlier: String,
    /// The forms in integers.
    forms: Vec<Matrix>,
}

impl Quadratic {
    /// The certificate; `None` where the forms do not show it, or are not found to.
    pub fn certificate(&self) -> Option<Value> {
        let mut writer = Writer::new(self)?;
        writer.readouts()?;
        match &self.course {
            Course::Falls(rate) => writer.falls(&(rate * rate))?,
            Course::Stays(start) => writer.stays(start)?,
        }
        Some(writer.sheet.certificate())
    }
}

impl<'q> Writer<'q> {
    fn new(quadratic: &'q Quadratic) -> Option<Self> {
        let entries = || quadratic.forms.iter().flatten().flatten();
        let scale = entries().fold(BigInt::one(), |d, x| d.lcm(x.denom()));
        let common =
            entries().fold(BigInt::zero(), |d, x| d.gcd(&(x.numer() * (&scale / x.denom()))));
        let unit = if common.is_zero() { return None } else { Rational::new(scale, common) };
        let forms = quadratic.forms.iter().map(|p| matrix_times(&unit, p)).collect();
        let mut sheet = Sheet::default();
        let mut runs = Runs::declare(&mut sheet, &quadratic.system, Turns::Any)?;
        if quadratic.forms.len() != 1
            && !(runs.chooses() && quadratic.forms.len() == runs.modes.len())
        {
            return None;
        }
        let mut ranges = runs.ranges.iter();
        let mut values = BTreeMap::new();
        for (name, [low, high]) in &quadratic.system.parameters {
            let value = match low == high {
                true => Parameter::Point(exact::parse(name, low).ok()?),
                false => {
                    ranges.next().map(|(f, ends)| Parameter::Range(f.clone(), ends.clone()))?
                }
            };
            values.insert(name, value);
        }
        let values =
            quadratic.parameters.iter().map(|p| values.remove(p)).collect::<Option<_>>()?;
        let [y, z, u, w, q] = ["y", "z", "u", "w", "q"].map(|stem| runs.names.stem(stem));
        let [form, bound, s, earlier, before, after] =
            ["V", "r", "s", "earlier", "before", "after"].map(|name| runs.names.fresh(name));
        let indexed =
            |stem: String| (0..quadratic.readouts.len()).map(|j| format!("{stem}{j}")).collect();
        let [y, z, u] = [y, z, u].map(indexed);
        let now = Time { variable: Some((runs.step.clone(), 0)), stride: 1, offset: 0 };
        Some(Self {
            quadratic,
            sheet,
            runs,
            now,
            values,
            y,
            form,
            bound,
            z,
            u,
            w,
            q,
            s,
            values_of_form: [before, after],
            earlier,
            forms,
        })
    }

    /// The readouts at that time.
    fn at(&self, time: &Time) -> Names {
        self.y.iter().map(|y| format!("{y}({})", time.text())).collect()
    }

    /// A readout of the state at that time.
    fn readout(&self, a: usize, time: &Time) -> Option<String> {
        let (constant, coefficients) = self.quadratic.readouts.get(a)?.parts()?;
        let names: Names =
            self.runs.state.iter().map(|v| format!("{v}({})", time.text())).collect();
        Some(form(constant, names.iter().map(String::as_str).zip(coefficients)))
    }

    /// What is defined, at that time: a fact of that name.
    fn defined(&self, function: &str, time: &Time, name: &str) -> Value {
        let (k, offset) = (&self.runs.step, time.offset);
        let from =
            if time.variable.is_some() { format!("[{k}] + {offset}") } else { offset.to_string() };
        instance(
            name,
            &format!("{function}.step"),
            &format!("{k}={}", time.text()),
            &format!("from={from}"),
        )
    }

    /// A lemma about every step, or about this one.
    fn every_step(&self, name: &str, goal: &str) -> Value {
        let k = &self.runs.step;
        clause(name, k, &[&format!("{k}: {k} >= 0")], goal)
    }

    fn this_step(&self, lemma: &str) -> Value {
        let k = &self.runs.step;
        instance(lemma, lemma, &format!("{k}={k}"), &format!("{k}=[{k}]"))
    }

    /// The hypothesis of an induction, of this step.
    fn before(&self) -> Value {
        let (k, earlier) = (&self.runs.step, &self.earlier);
        instance("before", "IH", &format!("{earlier}={k}"), &format!("{k}=[{k}]"))
    }

    /// The modes' selectors at that time; none where one mode acts in all steps.
    fn selectors(&self, time: &Time) -> Option<Names> {
        let at = |(m, _): &(String, _)| format!("{m}({})", time.text());
        self.runs.chooses().then(|| self.runs.modes.iter().map(at).collect())
    }

    /// What a mode makes of a readout, by the readouts at this step.
    fn row(&self, mode: usize, a: usize) -> Option<BTreeMap<usize, String>> {
        let rows = self.quadratic.maps.get(self.runs.written.get(mode)?)?;
        let text = |(b, entry): (&usize, &Polynomial)| {
            let mut text = String::new();
            for (monomial, c) in entry.terms() {
                let (mut c, mut names) = (c.clone(), Vec::new());
                for (p, _) in monomial.powers() {
                    match self.values.get(p as usize)? {
                        Parameter::Point(value) => c *= value,
                        Parameter::Range(f, _) => names.push(format!("{f}({})", self.runs.step)),
                    }
                }
                if !c.is_zero() {
                    add_term(&mut text, &c, &names.iter().map(String::as_str).collect::<Vec<_>>());
                }
            }
            Some((*b, text))
        };
        rows.get(a)?
            .iter()
            .map(text)
            .filter(|t| t.as_ref().is_none_or(|(_, t)| !t.is_empty()))
            .collect()
    }

    /// Defines readouts, and shows what a step makes of them.
    fn readouts(&mut self) -> Option<()> {
        let (now, k) = (self.now.clone(), self.runs.step.clone());
        let (next, here) = (now.later(1), self.at(&now));
        for a in 0..self.y.len() {
            let text = self.readout(a, &now)?;
            self.sheet.define(&self.y[a].clone(), &[&k], &[], &text, None);
        }
        for a in 0..self.y.len() {
            // By how much a step and the readouts' definitions have to be added.
            let mut goal = Vec::new();
            let mut sum = "[next]".to_owned();
            let mut facts = vec![self.defined(&self.y[a], &next, "next")];
            let (_, coefficients) = self.quadratic.readouts[a].parts()?;
            for (v, c) in coefficients.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
                facts.push(self.runs.step_at(v, &now, ""));
                add_term(&mut sum, c, &[&self.runs.step_fact(v, &now, "")]);
            }
            let selectors = self.selectors(&now);
            if selectors.is_some() {
                facts.push(self.runs.every("modes", &now, ""));
                sum += &format!(" + ({})*[modes]", self.readout(a, &now)?);
            }
            let mut read = BTreeMap::new();
            for mode in 0..self.runs.modes.len() {
                let row = self.row(mode, a)?;
                let by = selectors.as_ref().map(|s| format!("{}*", s[mode])).unwrap_or_default();
                let terms: Vec<String> =
                    row.iter().map(|(b, c)| format!("({c})*{}", here[*b])).collect();
                let terms = terms.join(" + ");
                if !terms.is_empty() {
                    goal.push(if by.is_empty() { terms } else { format!("{by}({terms})") });
                }
                for (b, c) in &row {
                    sum += &format!(" - {by}({c})*[{}]", self.y[*b]);
                    read.insert(*b, ());
                }
            }
            facts.extend(read.keys().map(|b| self.defined(&self.y[*b], &now, &self.y[*b])));
            let goal = format!("{} = {}", self.at(&next)[a], or_zero(goal.join(" + ")));
            let clause = self.every_step(&format!("next.{}", self.y[a]), &goal);
            self.sheet.lemma(clause, positivity(&facts, &sum));
        }
        self.square();
        Some(())
    }

    /// Squares are not negative.
    fn square(&mut self) {
        let s = &self.s;
        let [above, equal, below] = ["[sign]*[sign]", &format!("[sign]*{s}"), "[sign]*[sign]"]
            .map(|sum| positivity(&[], sum));
        let clause = clause("square", &format!("{s}:real"), &[], &format!("{s}*{s} >= 0"));
        self.sheet.lemma(clause, split("sign", s, [above, equal, below]));
    }

    /// What shows that a form of z, times a number, is at least 0. A square of more than two terms is that of a variable, a root, for
    /// which they are given.
    fn shown(&self, m: &Matrix) -> Option<Shown> {
        let squares = squares(m)?;
        let whole = squares.iter().fold(BigInt::one(), |d, (c, _)| d.lcm(c.denom()));
        let mut shown = Shown { times: Rational::from_integer(whole), ..Shown::default() };
        for (i, (factor, entries)) in squares.into_iter().enumerate() {
            let integer = |(j, c)| (j, Rational::from_integer(c));
            let entries: Terms = entries.into_iter().map(integer).collect();
            let (factor, mut root) = (factor * &shown.times, linear(&entries, &self.z));
            if entries.len() > 2 {
                let text = std::mem::replace(&mut root, format!("{}{}", self.q, shown.roots.len()));
                shown.given.push(format!("{root}: {root} = {text}"));
                let both = format!("({text} + {root})");
                add_term(&mut shown.sum, &-&factor, &[&format!("[{root}]"), &both]);
                shown.roots.push(entries);
            }
            add_term(&mut shown.sum, &factor, &[&format!("[s{i}]")]);
            let square = instance(&format!("s{i}"), "square", &format!("{}={root}", self.s), "");
            shown.facts.push(square);
        }
        Some(shown)
    }

    fn roots(&self, shown: &Shown) -> Names {
        (0..shown.roots.len()).map(|i| format!("{}{i}", self.q)).collect()
    }

    /// Terms for z, and for the roots of what is shown.
    fn of(&self, terms: &[String], shown: &Shown) -> Names {
        let roots = shown.roots.iter().map(|root| linear(root, terms));
        let names = self.z.iter().cloned().chain(self.roots(shown));
        names
            .zip(terms.iter().cloned().chain(roots))
            .map(|(v, term)| format!("{v}={term}"))
            .collect()
    }

    /// What the modes make of readouts at the ends of all ranges.
    fn vertices(&self) -> Option<Vec<Vertex>> {
        let mut all = Vec::new();
        for (mode, name) in self.runs.written.iter().enumerate() {
            let rows = self.quadratic.maps.get(name)?;
            let mut occur: Vec<usize> = rows
                .iter()
                .flat_map(BTreeMap::values)
                .flat_map(Polynomial::terms)
                .flat_map(|(m, _)| m.powers().map(|(p, _)| p as usize).collect::<Vec<_>>())
                .collect();
            occur.sort_unstable();
            occur.dedup();
            let number = |p: &Parameter| {
                if let Parameter::Point(x) = p { x.clone() } else { Rational::zero() }
            };
            let facts =
                self.selectors(&self.now).map(|_| format!("acts.{}", self.runs.modes[mode].0));
            let mut corners = vec![(
                self.values.iter().map(number).collect::<Vec<_>>(),
                Rational::one(),
                Vec::from_iter(facts),
            )];
            for p in occur {
                let Parameter::Range(f, [low, high]) = self.values.get(p)? else { continue };
                // At an end, how far the other is.
                let ends = [(low, "high"), (high, "low")];
                corners = corners
                    .iter()
                    .flat_map(|(values, factor, facts)| {
                        ends.iter().map(move |(end, fact)| {
                            let (mut values, mut facts) = (values.clone(), facts.clone());
                            values[p] = (*end).clone();
                            facts.push(format!("{fact}.{f}"));
                            (values, factor / (high - low), facts)
                        })
                    })
                    .collect();
            }
            for (values, factor, facts) in corners {
                let entry = |row: &BTreeMap<usize, Polynomial>, b| {
                    row.get(&b).map_or_else(Rational::zero, |e: &Polynomial| {
                        e.evaluate(|p| {
                            values.get(p as usize).cloned().unwrap_or_else(Rational::zero)
                        })
                    })
                };
                let map = rows
                    .iter()
                    .map(|row| (0..rows.len()).map(|b| entry(row, b)).collect())
                    .collect();
                all.push(Vertex { mode, factor, facts, map });
            }
        }
        Some(all)
    }

    /// V at that time, as a form of the readouts.
    fn value(&self, time: &Time) -> String {
        let y = self.at(time);
        match (self.forms.as_slice(), self.selectors(time)) {
            ([one], _) => quadratic(one, &y),
            (all, Some(selectors)) => {
                let terms =
                    selectors.iter().zip(all).map(|(m, p)| format!("{m}*({})", quadratic(p, &y)));
                terms.collect::<Vec<_>>().join(" + ")
            }
            _ => String::new(),
        }
    }

    /// For each form a lemma about z, u, and the values p and q of V before and after: rate^2 p - q >= 0, or q - p >= 0 where there is no
    /// rate, so many times.
    fn mixed(&mut self, vertices: &[Vertex], square: Option<&Rational>) -> Option<Mixed> {
        let (one, forms) = (Rational::one(), self.forms.clone());
        let (z, u) = (self.z.clone(), self.u.clone());
        let sign = if square.is_some() { one.clone() } else { -&one };
        let square = square.unwrap_or(&one);
        let entries = vertices.iter().flat_map(|v| v.map.iter().flatten());
        let unit = Rational::from_integer(entries.fold(BigInt::one(), |d, x| d.lcm(x.denom())));
        let maps: Vec<Matrix> = vertices.iter().map(|v| matrix_times(&unit, &v.map)).collect();
        let image = |i: usize, a: usize| linear(&sparse(&maps[i][a]), &z);
        let several = vertices.len() > 1;
        let weights: Names =
            (0..vertices.len()).filter(|_| several).map(|i| format!("{}{i}", self.w)).collect();
        let mut known: Names = weights.iter().map(|w| format!("{w}: {w} >= 0")).collect();
        if several {
            known.push(format!("all: {} = 1", weights.join(" + ")));
        }
        for (a, u) in u.iter().enumerate() {
            let mixed = weights.iter().enumerate().map(|(i, w)| format!("{w}*({})", image(i, a)));
            let image = if several { mixed.collect::<Vec<_>>().join(" + ") } else { image(0, a) };
            known.push(format!("{u}: {} = {image}", fraction_times(&unit, u)));
        }
        let mut mixed = Mixed { unit: unit.clone(), ..Mixed::default() };
        for (t, target) in forms.iter().enumerate() {
            let own = |v: &Vertex| forms.get(if forms.len() == 1 { 0 } else { v.mode });
            let left = |v: &Vertex| {
                self.shown(&matrix_times(&sign, &left_of(own(v)?, square, &v.map, target)))
            };
            let shown = vertices.iter().map(left).collect::<Option<Vec<_>>>()?;
            let whole = shown
                .iter()
                .fold(square.denom() * unit.numer() * unit.numer(), |d, s| d.lcm(s.times.numer()));
            let times = Rational::from_integer(whole);
            let (mut facts, mut sum, mut given) = (Vec::new(), String::new(), known.clone());
            let before = match (forms.len(), vertices.first()) {
                (1, _) => quadratic(target, &z),
                _ => {
                    let terms = weights
                        .iter()
                        .zip(vertices)
                        .map(|(w, v)| Some(format!("{w}*({})", quadratic(own(v)?, &z))));
                    terms.collect::<Option<Vec<_>>>()?.join(" + ")
                }
            };
            let after = quadratic(target, &u);
            let [p, q] = &self.values_of_form;
            given.extend([format!("before: {p} = {before}"), format!("after: {q} = {after}")]);
            add_term(&mut sum, &(&sign * square * &times), &["[before]"]);
            add_term(&mut sum, &(-&sign * &times), &["[after]"]);
            let mut roots = Shown::default();
            let factor = &times / &unit;
            if several {
                for (i, (v, shown)) in vertices.iter().zip(shown).enumerate() {
                    let lemma = format!("vertex{i}.{t}");
                    let names = self.roots(&shown);
                    let goal =
                        matrix_times(&shown.times, &left_of(own(v)?, square, &v.map, target));
                    let with = self.of(&z, &shown);
                    let given: Vec<&str> = shown.given.iter().map(String::as_str).collect();
                    let clause = clause(
                        &lemma,
                        &reals(&[&z, &names]),
                        &given,
                        &format!("{} >= 0", quadratic(&goal, &z)),
                    );
                    self.sheet.lemma(clause, positivity(&shown.facts, &or_zero(shown.sum)));
                    facts.push(instance(&format!("f{i}"), &lemma, &with.join(", "), ""));
                    let gap = |(a, u): (usize, &String)| {
                        format!("{} - {}", image(i, a), fraction_times(&unit, u))
                    };
                    let gaps: Names = u.iter().enumerate().map(gap).collect();
                    facts.push(instance(
                        &format!("g{i}"),
                        &format!("form.{t}"),
                        &self.of(&gaps, &Shown::default()).join(", "),
                        "",
                    ));
                    let weight = format!("[{}]", weights[i]);
                    add_term(&mut sum, &(&times / &shown.times), &[&weight, &format!("[f{i}]")]);
                    add_term(&mut sum, &(&factor / &unit), &[&weight, &format!("[g{i}]")]);
                }
                let kept = if forms.len() == 1 {
                    format!("{} + ", fraction_times(square, &format!("({before})")))
                } else {
                    String::new()
                };
                add_term(&mut sum, &-&times, &["[all]", &format!("({kept}{after})")]);
            } else {
                roots = shown.into_iter().next()?;
                facts.append(&mut roots.facts);
                given.append(&mut roots.given);
                add_term(
                    &mut sum,
                    &(&times / &roots.times),
                    &[&format!("({})", or_zero(std::mem::take(&mut roots.sum)))],
                );
            }
            let scaled = |c: &Rational, row: &[Rational]| {
                sparse(&row.iter().map(|x| c * x).collect::<Vec<_>>())
            };
            for (name, row) in u.iter().zip(target) {
                if several {
                    let twice = -&factor - &factor;
                    sum += &format!(" + [{name}]*({})", linear(&scaled(&twice, row), &u));
                } else {
                    let (by, moved) = (-&sign * &factor, matrix::before(row, &maps[0]));
                    let [here, there] = [
                        linear(&scaled(&by, row), &u),
                        linear(&scaled(&(&by / &unit), &moved), &z),
                    ];
                    sum += &format!(" + [{name}]*({here} + ({there}))");
                }
            }
            let [first, second] = if sign.is_positive() { [p, q] } else { [q, p] };
            let [first, second] =
                [fraction_times(&(&times * square), first), fraction_times(&times, second)];
            let given: Vec<&str> = given.iter().map(String::as_str).collect();
            let variables =
                reals(&[&z, &u, &weights, &self.roots(&roots), &self.values_of_form.to_vec()]);
            let clause = clause(
                &format!("mixed.{t}"),
                &variables,
                &given,
                &format!("{first} - {second} >= 0"),
            );
            self.sheet.lemma(clause, positivity(&facts, &sum));
            mixed.times.push(times);
            mixed.roots.push(roots);
        }
        Some(mixed)
    }

    /// The mixed lemmas, of this step: facts `mixed.t` and what they read.
    fn mixed_now(&self, vertices: &[Vertex], mixed: &Mixed) -> Vec<Value> {
        let (k, next) = (&self.now, self.now.later(1));
        let (here, there) = (self.at(k), self.at(&next));
        let mut with: Names = self.u.iter().zip(&there).map(|(u, y)| format!("{u}={y}")).collect();
        let mut given: Names = Vec::new();
        let mut facts =
            vec![self.defined(&self.form, k, "before"), self.defined(&self.form, &next, "after")];
        for (u, y) in self.u.iter().zip(&self.y) {
            given.push(format!("{u}={}", fraction_times(&mixed.unit, &format!("[next.{y}]"))));
            facts.push(self.this_step(&format!("next.{y}")));
        }
        if vertices.len() > 1 {
            let ranges = self
                .runs
                .ranges
                .iter()
                .flat_map(|(f, _)| ["low", "high"].map(|end| format!("{end}.{f}")));
            facts.extend(ranges.map(|fact| self.runs.every(&fact, k, "")));
            facts.extend(self.acting(k));
            for (i, v) in vertices.iter().enumerate() {
                let product = |name: &dyn Fn(&String) -> String| {
                    let (mut text, names) =
                        (String::new(), v.facts.iter().map(name).collect::<Vec<_>>());
                    add_term(
                        &mut text,
                        &v.factor,
                        &names.iter().map(String::as_str).collect::<Vec<_>>(),
                    );
                    text
                };
                with.push(format!("{}{i}={}", self.w, product(&|f| self.meaning(f))));
                given.push(format!("{}{i}={}", self.w, product(&|f| format!("[{f}]"))));
            }
            if self.runs.chooses() {
                given.push("all=-[modes]".to_owned());
            }
        }
        let [p, q] = &self.values_of_form;
        given.push("before=[before]".to_owned());
        with.push(format!("{p}={}({})", self.form, k.text()));
        for (t, (form, roots)) in self.forms.iter().zip(&mixed.roots).enumerate() {
            let (mut with, mut given) = (with.clone(), given.clone());
            with.extend(self.of(&here, roots));
            if self.forms.len() == 1 {
                with.push(format!("{q}={}({})", self.form, next.text()));
                given.push("after=[after]".to_owned());
            } else {
                with.push(format!("{q}={}", quadratic(form, &there)));
            }
            let name = format!("mixed.{t}");
            facts.push(instance(&name, &name, &with.join(", "), &given.join(", ")));
        }
        facts
    }

    /// What a fact about a range or a selector says is >= 0, at this step.
    fn meaning(&self, fact: &str) -> String {
        let k = &self.runs.step;
        let (kind, name) = fact.split_once('.').unwrap_or_default();
        let range = self.runs.ranges.iter().find(|(f, _)| f == name).map(|(_, ends)| ends);
        match (kind, range) {
            ("low", Some([low, _])) => format!("({name}({k}) - ({}))", fraction(low)),
            ("high", Some([_, high])) => format!("({} - {name}({k}))", fraction(high)),
            _ => format!("{name}({k})"),
        }
    }

    /// What is known of the selectors at that time.
    fn acting(&self, time: &Time) -> Vec<Value> {
        let acts =
            self.runs.modes.iter().map(|(m, _)| format!("acts.{m}")).chain(["modes".to_owned()]);
        acts.filter(|_| self.runs.chooses()).map(|fact| self.runs.every(&fact, time, "")).collect()
    }

    /// The readouts tend to 0.
    fn falls(&mut self, square: &Rational) -> Option<()> {
        let (now, k, v, r) =
            (self.now.clone(), self.runs.step.clone(), self.form.clone(), self.bound.clone());
        let next = now.later(1);
        let several = self.forms.len() > 1;
        self.sheet.define(&v, &[&k], &[], &self.value(&now), None);
        self.sheet.define(&r, &[&k], &["1"], &fraction_times(square, &format!("{r}({k})")), None);
        let part = least_part(&self.forms)?;
        let mut norms = Vec::new();
        let vertices = self.vertices()?;
        for (t, p) in self.forms.clone().iter().enumerate() {
            let shown = self.shown(&difference(p, &matrix_times(&part, &matrix::unit(p.len()))))?;
            let (z, [value, _]) = (self.z.clone(), self.values_of_form.clone());
            let (name, text) = (format!("norm.{t}"), quadratic(p, &z));
            let squares: Names = z.iter().map(|z| format!("{z}*{z}")).collect();
            let least =
                fraction_times(&(&part * &shown.times), &format!("({})", squares.join(" + ")));
            let goal = format!("{} >= {least}", fraction_times(&shown.times, &value));
            let mut given = shown.given.clone();
            given.push(format!("form: {value} = {text}"));
            let given: Vec<&str> = given.iter().map(String::as_str).collect();
            let sum = format!(
                "{} + {}",
                or_zero(shown.sum.clone()),
                fraction_times(&shown.times, "[form]")
            );
            let variables = reals(&[&z, &self.roots(&shown), &vec![value.clone()]]);
            self.sheet
                .lemma(clause(&name, &variables, &given, &goal), positivity(&shown.facts, &sum));
            if vertices.len() > 1 {
                let mut with = self.of(&z, &shown);
                with.push(format!("{value}={text}"));
                let mut facts = vec![instance("norm", &name, &with.join(", "), "")];
                let mut sum = fraction_times(&shown.times.recip(), "[norm]");
                for z in &z {
                    facts.push(instance(z, "square", &format!("{}={z}", self.s), ""));
                    add_term(&mut sum, &part, &[&format!("[{z}]")]);
                }
                let clause =
                    clause(&format!("form.{t}"), &reals(&[&z]), &[], &format!("{text} >= 0"));
                self.sheet.lemma(clause, positivity(&facts, &sum));
            }
            norms.push(shown);
        }
        let mixed = self.mixed(&vertices, Some(square))?;
        // In one step.
        let mut facts = self.mixed_now(&vertices, &mixed);
        let mut sum = String::new();
        for (t, times) in mixed.times.iter().enumerate() {
            let acts = self.runs.modes.get(t).filter(|_| several).map(|(m, _)| format!("acts.{m}"));
            let names = acts.as_ref().map(|acts| format!("[{acts}-next]"));
            facts.extend(acts.map(|acts| self.runs.every(&acts, &next, "-next")));
            let fact = format!("[mixed.{t}]");
            add_term(
                &mut sum,
                &times.recip(),
                &names.iter().chain([&fact]).map(String::as_str).collect::<Vec<_>>(),
            );
        }
        if several {
            facts.push(self.runs.every("modes", &next, "-next"));
            sum += &format!(
                " + {} - [after]",
                fraction_times(square, &format!("{v}({k})*[modes-next]"))
            );
        }
        let goal = format!("{v}({k} + 1) <= {}", fraction_times(square, &format!("{v}({k})")));
        self.sheet.lemma(self.every_step("step", &goal), positivity(&facts, &sum));
        // In all steps.
        let facts = [self.before(), self.this_step("step"), self.defined(&r, &now, "bound")];
        let sum = format!("{} + [step] + [bound]*{v}(0)", fraction_times(square, "[before]"));
        let proof = induction(
            &k,
            &k,
            &self.earlier,
            positivity(&[], &format!("[{r}.0]*{v}(0)")),
            positivity(&facts, &sum),
        );
        let goal = format!("{v}({k}) <= {r}({k})*{v}(0)");
        self.sheet.conclude(self.every_step("falls", &goal), proof);
        let y = self.at(&now);
        let norm: Names = y.iter().map(|y| format!("{y}*{y}")).collect();
        let norm = fraction_times(&part, &format!("({})", norm.join(" + ")));
        let mut facts = self.acting(&now);
        facts.extend([self.this_step("falls"), self.defined(&v, &now, "now")]);
        let mut sum = "[falls]".to_owned();
        for (t, (shown, p)) in norms.iter().zip(&self.forms).enumerate() {
            let (fact, [value, _]) = (format!("norm.{t}"), &self.values_of_form);
            let mut with = self.of(&y, shown);
            let text = if several { quadratic(p, &y) } else { format!("{v}({k})") };
            with.push(format!("{value}={text}"));
            facts.push(instance(
                &fact,
                &fact,
                &with.join(", "),
                if several { "" } else { "form=[now]" },
            ));
            let acts =
                self.runs.modes.get(t).filter(|_| several).map(|(m, _)| format!("[acts.{m}]"));
            let fact = format!("[{fact}]");
            add_term(
                &mut sum,
                &shown.times.recip(),
                &acts.iter().chain([&fact]).map(String::as_str).collect::<Vec<_>>(),
            );
        }
        if several {
            sum += &format!(" + [now] - {norm}*[modes]");
        }
        let goal = format!("{norm} <= {r}({k})*{v}(0)");
        self.sheet.conclude(self.every_step("tends", &goal), positivity(&facts, &sum));
        Some(())
    }

    /// The readouts do not tend to 0.
    fn stays(&mut self, start: &[Rational]) -> Option<()> {
        let (now, k, v) = (self.now.clone(), self.runs.step.clone(), self.form.clone());
        let vertices = self.vertices()?;
        let ([form], [_]) = (self.forms.as_slice(), vertices.as_slice()) else { return None };
        let form = form.clone();
        self.sheet.define(&v, &[&k], &[], &self.value(&now), None);
        let begin = Time::step(0);
        for (x, value) in self.runs.state.iter().zip(start) {
            self.sheet.assume(clause(
                &format!("start.{x}"),
                "",
                &[],
                &format!("{x}(0) = {}", fraction(value)),
            ));
        }
        let y = self.quadratic.readouts.iter().map(|y| y.at(start)).collect::<Option<Vec<_>>>()?;
        for (a, at_start) in y.iter().enumerate() {
            let mut sum = "[y]".to_owned();
            let (_, coefficients) = self.quadratic.readouts[a].parts()?;
            for (x, c) in self.runs.state.iter().zip(coefficients).filter(|(_, c)| !c.is_zero()) {
                add_term(&mut sum, c, &[&format!("[start.{x}]")]);
            }
            let goal = format!("{} = {}", self.at(&begin)[a], fraction(at_start));
            let name = format!("start.{}", self.y[a]);
            let facts = [self.defined(&self.y[a], &begin, "y")];
            self.sheet.lemma(clause(&name, "", &[], &goal), positivity(&facts, &sum));
        }
        let mixed = self.mixed(&vertices, None)?;
        let facts = self.mixed_now(&vertices, &mixed);
        let sum = fraction_times(&mixed.times.first()?.recip(), "[mixed.0]");
        let goal = format!("{v}({k} + 1) >= {v}({k})");
        self.sheet.lemma(self.every_step("step", &goal), positivity(&facts, &sum));
        let image = matrix::applied(&form, &y);
        let value = matrix::dot(&image, &y);
        if !value.is_positive() {
            return None;
        }
        let mut sum = "[value]".to_owned();
        for ((name, row), number) in self.y.iter().zip(&form).zip(&image) {
            let image = linear(&sparse(row), &self.at(&begin));
            sum += &format!(" + [start.{name}]*({image} + {})", bracketed(number));
        }
        let base = positivity(&[self.defined(&v, &begin, "value")], &sum);
        let step = positivity(&[self.before(), self.this_step("step")], "[before] + [step]");
        let goal = format!("{v}({k}) >= {}", fraction(&value));
        self.sheet.conclude(
            self.every_step("stays", &goal),
            induction(&k, &k, &self.earlier, base, step),
        );
        Some(())
    }
}

/// The part of |z|^2 that all forms are at least, as a power of 2 times the least entry on their diagonals; for dominant
/// forms the least by which they are.
fn least_part(forms: &[Matrix]) -> Option<Rational> {
    let rows = || forms.iter().flat_map(|p| p.iter().enumerate());
    let excess = |(i, row): (usize, &Vec<Rational>)| {
        let beside = row.iter().enumerate().filter(|(j, _)| *j != i);
        beside.fold(row[i].clone(), |rest, (_, x)| rest - x.abs())
    };
    let dominant = rows().map(excess).min()?;
    if dominant.is_positive() {
        return Some(dominant);
    }
    let least = rows().map(|(i, row)| row[i].clone()).min()?;
    let doubles: Vec<Vec<Vec<f64>>> = forms
        .iter()
        .map(|p| p.iter().map(|row| row.iter().map(exact::to_f64).collect()).collect())
        .collect();
    (1..60).map(|j| &least / Rational::from_integer(BigInt::one() << j)).find(|part| {
        let part = exact::to_f64(part);
        least.is_positive() && doubles.iter().all(|p| negative_direction(p, 2.0 * part).is_none())
    })
}

/// The entries that are not 0, with their places.
fn sparse(row: &[Rational]) -> Vec<(usize, Rational)> {
    row.iter().cloned().enumerate().filter(|(_, c)| !c.is_zero()).collect()
}

fn linear(entries: &[(usize, Rational)], names: &[String]) -> String {
    form(&Rational::zero(), entries.iter().map(|(j, c)| (names[*j].as_str(), c)))
}

/// z'mz, row by row.
fn quadratic(m: &Matrix, names: &[String]) -> String {
    let two = Rational::from_integer(2.into());
    let mut text = String::new();
    for (i, row) in m.iter().enumerate() {
        let entries = row.iter().enumerate().skip(i).filter(|(_, c)| !c.is_zero());
        let entries: Vec<(usize, Rational)> =
            entries.map(|(j, c)| (j, if i == j { c.clone() } else { c * &two })).collect();
        match entries.as_slice() {
            [] => {}
            [(j, c)] => add_term(&mut text, c, &[&names[i], &names[*j]]),
            _ => add_term(
                &mut text,
                &Rational::one(),
                &[&names[i], &format!("({})", linear(&entries, names))],
            ),
        }
    }
    or_zero(text)
}

fn matrix_times(c: &Rational, m: &Matrix) -> Matrix {
    m.iter().map(|row| row.iter().map(|x| c * x).collect()).collect()
}

fn difference(a: &Matrix, b: &Matrix) -> Matrix {
    a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(x, y)| x - y).collect()).collect()
}

/// A number, not below 0, times a factor.
fn fraction_times(c: &Rational, factor: &str) -> String {
    if c.is_one() { factor.to_owned() } else { format!("{}*{factor}", fraction(c)) }
}

/// rate^2 P - A'QA.
fn left_of(p: &Matrix, square: &Rational, map: &Matrix, q: &Matrix) -> Matrix {
    difference(&matrix_times(square, p), &product(&product(&transposed(map), q), map))
}

/// A number as a summand.
fn bracketed(c: &Rational) -> String {
    if c.is_negative() { format!("({})", fraction(c)) } else { fraction(c) }
}

/// Variables of a clause, reals.
fn reals(names: &[&Names]) -> String {
    names.iter().flat_map(|n| n.iter()).map(|n| format!("{n}:real")).collect::<Vec<_>>().join(" ")
}
