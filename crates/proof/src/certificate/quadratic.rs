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

/// A map at the ends of ranges: its mode, and its weight in a step, a number times facts.
struct Vertex {
    mode: usize,
    factor: Rational,
    facts: Vec<String>,
    map: Matrix,
}

type Names = Vec<String>;

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
        let [form, bound, s, earlier] =
            ["V", "r", "s", "earlier"].map(|name| runs.names.fresh(name));
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

    /// A lemma that a form of z is at least 0, times a number that is given back.
    fn semidefinite(&mut self, name: &str, m: &Matrix) -> Option<Rational> {
        let squares = squares(m)?;
        let scale = squares.iter().fold(BigInt::one(), |d, (c, _)| d.lcm(c.denom()));
        let scale = Rational::from_integer(scale);
        let (mut given, mut facts, mut long) = (Vec::new(), Vec::new(), Vec::new());
        let mut sum = String::new();
        for (i, (factor, entries)) in squares.iter().enumerate() {
            let entries: Vec<(usize, Rational)> =
                entries.iter().map(|(j, c)| (*j, Rational::from_integer(c.clone()))).collect();
            let text = linear(&entries, &self.z);
            let (factor, fact) = (factor * &scale, format!("[s{i}]"));
            let root = if entries.len() > 2 {
                // A variable in its place: its square has one term.
                let root = format!("{}{}", self.q, long.len());
                given.push(format!("e{i}: {root} = {text}"));
                add_term(&mut sum, &-&factor, &[&format!("[e{i}]"), &format!("({text} + {root})")]);
                long.push((root.clone(), text));
                root
            } else {
                text
            };
            add_term(&mut sum, &factor, &[&fact]);
            facts.push(instance(&format!("s{i}"), "square", &format!("{}={root}", self.s), ""));
        }
        let goal = format!("{} >= 0", quadratic(&matrix_times(&scale, m), &self.z));
        let roots: Names = long.iter().map(|(root, ..)| root.clone()).collect();
        let under = if long.is_empty() { name.to_owned() } else { format!("{name}.squares") };
        let given: Vec<&str> = given.iter().map(String::as_str).collect();
        let proof = positivity(&facts, &or_zero(sum));
        self.sheet.lemma(clause(&under, &reals(&[&self.z, &roots]), &given, &goal), proof);
        if !long.is_empty() {
            let same = self.z.iter().map(|z| (z.clone(), z.clone()));
            let all: Names = same.chain(long).map(|(v, term)| format!("{v}={term}")).collect();
            let proof =
                positivity(&[instance("squares", &under, &all.join(", "), "")], "[squares]");
            self.sheet.lemma(clause(name, &reals(&[&self.z]), &[], &goal), proof);
        }
        Some(scale)
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

    /// For each form a lemma about z and u, what a step makes of z: rate^2 z'Pz - u'Pu >= 0, or u'Pu - z'Pz >= 0 where there is no rate. All in
    /// integers: gives how many times u the equations speak of, and how many times the difference the lemmas do.
    fn mixed(&mut self, vertices: &[Vertex], square: Option<&Rational>) -> Option<[Rational; 2]> {
        let (one, forms) = (Rational::one(), self.forms.clone());
        let (z, u) = (self.z.clone(), self.u.clone());
        let several = vertices.len() > 1;
        let sign = if square.is_some() { one.clone() } else { -&one };
        let square = square.unwrap_or(&one);
        let entries = vertices.iter().flat_map(|v| v.map.iter().flatten());
        let unit = Rational::from_integer(entries.fold(BigInt::one(), |d, x| d.lcm(x.denom())));
        let whole = Rational::from_integer(square.denom().clone());
        let times = &unit * &unit * &whole;
        let weights: Names =
            (0..vertices.len()).filter(|_| several).map(|i| format!("{}{i}", self.w)).collect();
        let maps: Vec<Matrix> = vertices.iter().map(|v| matrix_times(&unit, &v.map)).collect();
        let image = |i: usize, a: usize| linear(&sparse(&maps[i][a]), &z);
        let mut given: Names = weights.iter().map(|w| format!("{w}: {w} >= 0")).collect();
        if several {
            given.push(format!("all: {} = 1", weights.join(" + ")));
        }
        for (a, u) in u.iter().enumerate() {
            let mixed = weights.iter().enumerate().map(|(i, w)| format!("{w}*({})", image(i, a)));
            let image = if several { mixed.collect::<Vec<_>>().join(" + ") } else { image(0, a) };
            given.push(format!("{u}: {} = {image}", fraction_times(&unit, u)));
        }
        let given: Vec<&str> = given.iter().map(String::as_str).collect();
        let gaps = |i: usize| -> Names {
            let gap = |(a, u): (usize, &String)| {
                format!("{} - {}", image(i, a), fraction_times(&unit, u))
            };
            u.iter().enumerate().map(gap).collect()
        };
        let gaps: Vec<Names> = (0..vertices.len()).map(gaps).collect();
        for (t, target) in forms.iter().enumerate() {
            let own = |v: &Vertex| forms.get(if forms.len() == 1 { 0 } else { v.mode });
            let after = quadratic(&matrix_times(&times, target), &u);
            let before =
                |v: &Vertex| Some(quadratic(&matrix_times(&(&times * square), own(v)?), &z));
            let (mut facts, mut sum) = (Vec::new(), String::new());
            for (i, v) in vertices.iter().enumerate() {
                let moved = product(&product(&transposed(&v.map), target), &v.map);
                let left = difference(
                    &matrix_times(&(&sign * square), own(v)?),
                    &matrix_times(&sign, &moved),
                );
                let lemma = format!("vertex{i}.{t}");
                let factor = &times / self.semidefinite(&lemma, &left)?;
                facts.push(self.instance_of(&format!("f{i}"), &lemma, &z));
                let weight = weights.get(i).map(|w| format!("[{w}]"));
                let fact = format!("[f{i}]");
                add_term(
                    &mut sum,
                    &factor,
                    &weight.iter().chain([&fact]).map(String::as_str).collect::<Vec<_>>(),
                );
                if let Some(weight) = weight {
                    facts.push(self.instance_of(&format!("g{i}"), &format!("form.{t}"), &gaps[i]));
                    add_term(&mut sum, &whole, &[&weight, &format!("[g{i}]")]);
                }
            }
            let first = before(vertices.first()?)?;
            let goal = match (forms.len(), sign.is_positive()) {
                (1, true) => format!("{first} - ({after})"),
                (1, false) => format!("{after} - ({first})"),
                _ => {
                    let terms = weights
                        .iter()
                        .zip(vertices)
                        .map(|(w, v)| Some(format!("{w}*({})", before(v)?)));
                    format!("{} - ({after})", terms.collect::<Option<Vec<_>>>()?.join(" + "))
                }
            };
            if several {
                let common = if forms.len() == 1 { format!("{first} + ") } else { String::new() };
                sum += &format!(" - [all]*({common}{after})");
            }
            for (name, row) in u.iter().zip(target) {
                let of =
                    |c: Rational, row: &[Rational]| row.iter().map(|x| &c * x).collect::<Vec<_>>();
                let two = Rational::from_integer(2.into());
                if several {
                    let image = linear(&sparse(&of(-&two * &whole * &unit, row)), &u);
                    sum += &format!(" + [{name}]*({image})");
                } else {
                    let factor = -&sign * &whole;
                    let both = [
                        linear(&sparse(&of(&factor * &unit, row)), &u),
                        linear(&sparse(&of(factor, &matrix::before(row, &maps[0]))), &z),
                    ];
                    sum += &format!(" + [{name}]*({} + ({}))", both[0], both[1]);
                }
            }
            let clause = clause(
                &format!("mixed.{t}"),
                &reals(&[&z, &u, &weights]),
                &given,
                &format!("{goal} >= 0"),
            );
            self.sheet.lemma(clause, positivity(&facts, &sum));
        }
        Some([unit, times])
    }

    /// A lemma about z of these terms.
    fn instance_of(&self, name: &str, lemma: &str, terms: &[String]) -> Value {
        let with: Names = self.z.iter().zip(terms).map(|(z, term)| format!("{z}={term}")).collect();
        instance(name, lemma, &with.join(", "), "")
    }

    /// Each of the mixed lemmas, of this step: a fact `mixed.t`.
    fn mixed_now(&self, vertices: &[Vertex], unit: &Rational) -> Vec<Value> {
        let (now, next) = (self.at(&self.now), self.at(&self.now.later(1)));
        let mut with: Names = self
            .z
            .iter()
            .zip(&now)
            .chain(self.u.iter().zip(&next))
            .map(|(v, term)| format!("{v}={term}"))
            .collect();
        let mut given: Names = self
            .u
            .iter()
            .zip(&self.y)
            .map(|(u, y)| format!("{u}={}", fraction_times(unit, &format!("[next.{y}]"))))
            .collect();
        let mut facts: Vec<Value> =
            self.y.iter().map(|y| self.this_step(&format!("next.{y}"))).collect();
        if self.runs.chooses() {
            facts.push(self.runs.every("modes", &self.now, ""));
        }
        if vertices.len() > 1 {
            let ranges = self
                .runs
                .ranges
                .iter()
                .flat_map(|(f, _)| ["low", "high"].map(|end| format!("{end}.{f}")));
            let acts = self.selectors(&self.now).into_iter().flatten();
            let acts = acts.zip(&self.runs.modes).map(|(_, (m, _))| format!("acts.{m}"));
            facts.extend(ranges.chain(acts).map(|fact| self.runs.every(&fact, &self.now, "")));
            for (i, v) in vertices.iter().enumerate() {
                let mut product = String::new();
                let names: Names = v.facts.iter().map(|f| format!("[{f}]")).collect();
                add_term(
                    &mut product,
                    &v.factor,
                    &names.iter().map(String::as_str).collect::<Vec<_>>(),
                );
                let term = v.facts.iter().map(|f| self.meaning(f)).collect::<Vec<_>>();
                let mut text = String::new();
                add_term(
                    &mut text,
                    &v.factor,
                    &term.iter().map(String::as_str).collect::<Vec<_>>(),
                );
                with.push(format!("{}{i}={text}", self.w));
                given.push(format!("{}{i}={product}", self.w));
            }
            if self.runs.chooses() {
                given.push("all=-[modes]".to_owned());
            }
        }
        let all = (0..self.forms.len()).map(|t| {
            let name = format!("mixed.{t}");
            instance(&name, &name, &with.join(", "), &given.join(", "))
        });
        facts.extend(all);
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

    /// Selectors, each times the fact of that name, number and step.
    fn weighted(&self, fact: &str, scales: &[Rational]) -> String {
        let mut sum = String::new();
        for (t, scale) in scales.iter().enumerate() {
            let acts = self
                .runs
                .modes
                .get(t)
                .filter(|_| scales.len() > 1)
                .map(|(m, _)| format!("[acts.{m}]"));
            let fact = format!("[{fact}.{t}]");
            add_term(
                &mut sum,
                &scale.recip(),
                &acts.iter().chain([&fact]).map(String::as_str).collect::<Vec<_>>(),
            );
        }
        sum
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
        let mut scales = Vec::new();
        for (t, p) in self.forms.clone().iter().enumerate() {
            let less = difference(p, &matrix_times(&part, &matrix::unit(p.len())));
            scales.push(self.semidefinite(&format!("norm.{t}"), &less)?);
        }
        let vertices = self.vertices()?;
        if vertices.len() > 1 {
            for (t, (p, scale)) in self.forms.clone().iter().zip(&scales).enumerate() {
                let mut facts = vec![self.instance_of("norm", &format!("norm.{t}"), &self.z)];
                let mut sum = fraction_times(&scale.recip(), "[norm]");
                for z in &self.z {
                    facts.push(instance(z, "square", &format!("{}={z}", self.s), ""));
                    add_term(&mut sum, &part, &[&format!("[{z}]")]);
                }
                let goal = format!("{} >= 0", quadratic(p, &self.z));
                let clause = clause(&format!("form.{t}"), &reals(&[&self.z]), &[], &goal);
                self.sheet.lemma(clause, positivity(&facts, &sum));
            }
        }
        let [unit, times] = self.mixed(&vertices, Some(square))?;
        // In one step.
        let mut facts = self.mixed_now(&vertices, &unit);
        facts.extend([self.defined(&v, &now, "now"), self.defined(&v, &next, "next")]);
        let mixed = fraction(&times.recip());
        let sum = match self.selectors(&next).filter(|_| several) {
            None => format!("{mixed}*[mixed.0] + {} - [next]", fraction_times(square, "[now]")),
            Some(selectors) => {
                let acts = self.runs.modes.iter().map(|(m, _)| format!("acts.{m}"));
                let mut sum = format!(
                    "{} - [next]",
                    fraction_times(square, &format!("({})*[now]", selectors.join(" + ")))
                );
                sum += &format!(" + {}", fraction_times(square, &format!("{v}({k})*[modes-next]")));
                for (t, acts) in acts.enumerate() {
                    facts.push(self.runs.every(&acts, &next, "-next"));
                    sum += &format!(" + {mixed}*[{acts}-next]*[mixed.{t}]");
                }
                facts.push(self.runs.every("modes", &next, "-next"));
                sum
            }
        };
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
        facts.extend(
            (0..scales.len())
                .map(|t| self.instance_of(&format!("norm.{t}"), &format!("norm.{t}"), &y)),
        );
        let mut sum = format!("[falls] + [now] + {}", self.weighted("norm", &scales));
        if several {
            sum += &format!(" - {norm}*[modes]");
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
        let [unit, times] = self.mixed(&vertices, None)?;
        let mut facts = self.mixed_now(&vertices, &unit);
        facts.extend([self.defined(&v, &now, "now"), self.defined(&v, &now.later(1), "next")]);
        let sum = format!("{}*[mixed.0] + [next] - [now]", fraction(&times.recip()));
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

/// A number as a summand.
fn bracketed(c: &Rational) -> String {
    if c.is_negative() { format!("({})", fraction(c)) } else { fraction(c) }
}

/// Variables of a clause, reals.
fn reals(names: &[&Names]) -> String {
    names.iter().flat_map(|n| n.iter()).map(|n| format!("{n}:real")).collect::<Vec<_>>().join(" ")
}
