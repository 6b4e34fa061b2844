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

mod readouts;
mod shown;
mod squares;
mod step;
mod text;

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use serde_json::Value;

use super::linear::{LinearSystem, form};
use super::runs::{Runs, Time, Turns};
use super::theorem::{Sheet, bracketed, clause, induction, instance, positivity};
use crate::claims::doubles::negative_direction;
use cordon_core::Rational;
use cordon_core::exact::{self, fraction};
use cordon_core::linear::affine::Affine;
use cordon_core::linear::matrix::{self, Matrix};
use cordon_core::scalar::Polynomial;
use text::{add, fraction_times, linear, matrix_times, quadratic, sparse};

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

/// Names, or terms in their places.
type Names = Vec<String>;

/// A certificate in the making.
struct Writer<'q> {
    quadratic: &'q Quadratic,
    sheet: Sheet,
    runs: Runs,
    /// The step that clauses speak of.
    now: Time,
    /// The parameters, as coefficients count them.
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
    /// The same for V before and after.
    values_of_form: [String; 2],
    /// The variable of an induction's hypothesis.
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
        let vertices = self.vertices()?;
        let norms = self.norms(&part, vertices.len() > 1)?;
        let mixed = self.mixed(&vertices, Some(square))?;
        // In one step.
        let mut facts = self.mixed_now(&vertices, &mixed);
        let mut sum = String::new();
        for (t, times) in mixed.times.iter().enumerate() {
            let acts = self.runs.modes.get(t).filter(|_| several).map(|(m, _)| format!("acts.{m}"));
            let names = acts.as_ref().map(|acts| format!("[{acts}-next]"));
            facts.extend(acts.map(|acts| self.runs.every(&acts, &next, "-next")));
            add(&mut sum, &times.recip(), names.into_iter().chain([format!("[mixed.{t}]")]));
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
            add(&mut sum, &shown.times.recip(), acts.into_iter().chain([format!("[{fact}]")]));
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
                add(&mut sum, c, [format!("[start.{x}]")]);
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
