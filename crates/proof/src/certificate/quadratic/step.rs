//! What a step makes of a form: maps at the ends of all ranges, mixed.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use serde_json::Value;

use super::shown::Shown;
use super::text::{
    add, difference, fraction_times, linear, matrix_times, quadratic, reals, refs, sparse,
};
use super::{Names, Parameter, Writer};
use crate::certificate::theorem::{clause, instance, positivity};
use cordon_core::Rational;
use cordon_core::linear::matrix::{self, Matrix, product, transposed};
use cordon_core::scalar::Polynomial;
use cordon_core::system::expression::or_zero;

/// A map at the ends of ranges: its mode, and its weight in a step, a number times facts.
pub(super) struct Vertex {
    pub(super) mode: usize,
    pub(super) factor: Rational,
    pub(super) facts: Vec<String>,
    pub(super) map: Matrix,
}

/// The mixed lemmas: how many times u the equations speak of, how many times the difference each does, and its roots.
#[derive(Default)]
pub(super) struct Mixed {
    pub(super) unit: Rational,
    pub(super) times: Vec<Rational>,
    pub(super) roots: Vec<Shown>,
}

impl Writer<'_> {
    /// What the modes make of readouts at the ends of all ranges.
    pub(super) fn vertices(&self) -> Option<Vec<Vertex>> {
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

    /// For each form a lemma about z, u, and the values p and q of V before and after: rate^2 p - q >= 0, or q - p >= 0 where there is no
    /// rate, so many times.
    pub(super) fn mixed(
        &mut self,
        vertices: &[Vertex],
        square: Option<&Rational>,
    ) -> Option<Mixed> {
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
            let values = self.values_of_form.clone();
            let [p, q] = &values;
            given.extend([format!("before: {p} = {before}"), format!("after: {q} = {after}")]);
            add(&mut sum, &(&sign * square * &times), ["[before]".to_owned()]);
            add(&mut sum, &(-&sign * &times), ["[after]".to_owned()]);
            let mut roots = Shown::default();
            let factor = &times / &unit;
            if several {
                for (i, (v, shown)) in vertices.iter().zip(shown).enumerate() {
                    let left = left_of(own(v)?, square, &v.map, target);
                    facts.push(self.at_vertex(i, t, &shown, &left));
                    let gap = |(a, u): (usize, &String)| {
                        format!("{} - {}", image(i, a), fraction_times(&unit, u))
                    };
                    let gaps: Names = u.iter().enumerate().map(gap).collect();
                    let with = self.of(&gaps, &Shown::default()).join(", ");
                    facts.push(instance(&format!("g{i}"), &format!("form.{t}"), &with, ""));
                    let weight = format!("[{}]", weights[i]);
                    add(&mut sum, &(&times / &shown.times), [weight.clone(), format!("[f{i}]")]);
                    add(&mut sum, &(&factor / &unit), [weight, format!("[g{i}]")]);
                }
                // Forms of their own are mixed as they are.
                let kept = Some(fraction_times(square, &format!("({before})")))
                    .filter(|_| forms.len() == 1);
                let rest = kept.into_iter().chain([after]).collect::<Vec<_>>().join(" + ");
                add(&mut sum, &-&times, ["[all]".to_owned(), format!("({rest})")]);
            } else {
                roots = shown.into_iter().next()?;
                facts.append(&mut roots.facts);
                given.append(&mut roots.given);
                let squares = or_zero(std::mem::take(&mut roots.sum));
                add(&mut sum, &(&times / &roots.times), [format!("({squares})")]);
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
            let (name, goal) = (format!("mixed.{t}"), format!("{first} - {second} >= 0"));
            let variables = reals(&[&z, &u, &weights, &self.roots(&roots), &values.to_vec()]);
            let clause = clause(&name, &variables, &refs(&given), &goal);
            self.sheet.lemma(clause, positivity(&facts, &sum));
            mixed.times.push(times);
            mixed.roots.push(roots);
        }
        Some(mixed)
    }

    /// A lemma about one map: that what is left over of the form is at least 0. Gives it of z, as a fact.
    fn at_vertex(&mut self, i: usize, t: usize, shown: &Shown, left: &Matrix) -> Value {
        let lemma = format!("vertex{i}.{t}");
        let goal = format!("{} >= 0", quadratic(&matrix_times(&shown.times, left), &self.z));
        let variables = reals(&[&self.z, &self.roots(shown)]);
        let clause = clause(&lemma, &variables, &refs(&shown.given), &goal);
        self.sheet.lemma(clause, positivity(&shown.facts, &or_zero(shown.sum.clone())));
        instance(&format!("f{i}"), &lemma, &self.of(&self.z, shown).join(", "), "")
    }

    /// The mixed lemmas, of this step: facts `mixed.t` and what they read.
    pub(super) fn mixed_now(&self, vertices: &[Vertex], mixed: &Mixed) -> Vec<Value> {
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
                    let mut text = String::new();
                    add(&mut text, &v.factor, v.facts.iter().map(name));
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
        let (kind, name) = fact.split_once('.').unwrap_or_default();
        let distance = self.runs.distance(kind, name, &self.now);
        distance.unwrap_or_else(|| format!("{name}({})", self.runs.step))
    }
}

/// rate^2 P - A'QA.
fn left_of(p: &Matrix, square: &Rational, map: &Matrix, q: &Matrix) -> Matrix {
    difference(&matrix_times(square, p), &product(&product(&transposed(map), q), map))
}
