//! A user's system as part of a statement: its variables are functions of the step, about which the
//! assumptions say how each step is made.
//!
//! A parameter is a function of the step as well, with its range; where a step may be made by one of
//! several modes, so is each mode m: m(k) is 1 where it acts and 0 elsewhere.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::Zero;
use serde_json::Value;

use super::linear::LinearSystem;
use super::theorem::{Sheet, bracketed, clause, instance};
use cordon_core::Rational;
use cordon_core::exact::{self, fraction};
use cordon_core::linear::feasible::Sign;
use cordon_core::scalar::Polynomial;
use cordon_core::system::expression::{
    Comparison, Expression, Meaning, add_term, comparisons, or_zero,
};

/// Which mode acts in a step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Turns {
    /// Any of all.
    Any,
    /// These, by their places among the modes, over and over.
    Cycle(Vec<usize>),
}

/// When: at a step, or at every step `stride * variable + offset`, the variable being at least `least`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Time {
    /// The variable, if there is one; its bound is the fact of that name.
    pub variable: Option<(String, usize)>,
    /// Steps from one value of the variable to the next.
    pub stride: usize,
    /// The step, or the first.
    pub offset: usize,
}

impl Time {
    /// A step.
    pub fn step(offset: usize) -> Self {
        Self { variable: None, stride: 0, offset }
    }

    /// The time so many steps later.
    pub fn later(&self, steps: usize) -> Self {
        Self { offset: self.offset + steps, ..self.clone() }
    }

    /// The term in the checker's words.
    pub fn text(&self) -> String {
        let Some((name, _)) = &self.variable else { return self.offset.to_string() };
        let scaled =
            if self.stride == 1 { name.clone() } else { format!("{}*{name}", self.stride) };
        if self.offset == 0 { scaled } else { format!("{scaled} + {}", self.offset) }
    }

    /// Of the term divided by `by`, rounded down, the text and why it is at least 0. The stride is a multiple of `by`.
    fn quotient(&self, by: usize) -> [String; 2] {
        let offset = self.offset / by;
        let Some((name, least)) = &self.variable else {
            return [offset.to_string(), offset.to_string()];
        };
        let stride = self.stride / by;
        let whole = Self { stride, offset, ..self.clone() };
        [whole.text(), format!("{stride}*[{name}] + {}", stride * least + offset)]
    }
}

/// Names that are not given twice.
#[derive(Clone, Debug, Default)]
pub struct Names(BTreeSet<String>);

impl Names {
    /// A name of letters and digits like the one wanted.
    pub fn fresh(&mut self, wanted: &str) -> String {
        let mut name: String =
            wanted.chars().filter(char::is_ascii_alphanumeric).take(30).collect();
        if !name.starts_with(|c: char| c.is_ascii_alphabetic()) || name == "last" {
            name.insert(0, 'm');
        }
        let taken = |n: &String| self.0.contains(n);
        let numbered = (2..).map(|i| format!("{name}x{i}")).find(|n| !taken(n));
        let name = if taken(&name) { numbered.unwrap_or_default() } else { name };
        self.0.insert(name.clone());
        name
    }

    /// A name that stays new with any number after it.
    pub fn stem(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let digits = |rest: &str| rest.bytes().all(|b| b.is_ascii_digit());
        while self.0.iter().any(|taken| taken.strip_prefix(&name).is_some_and(digits)) {
            name.push('x');
        }
        self.0.insert(name.clone());
        name
    }
}

/// A comparison of an affine form in the state with 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Literal {
    /// The coefficients that are not 0, by the place of the variable.
    pub form: BTreeMap<usize, Rational>,
    /// The constant.
    pub constant: Rational,
    /// How the form compares with 0.
    pub sign: Sign,
}

/// What the statement calls the parts of a system.
#[derive(Clone, Debug)]
pub struct Runs {
    /// The names that are taken.
    pub names: Names,
    /// The variable of clauses about every step.
    pub step: String,
    /// The variables of the state.
    pub state: Vec<String>,
    /// The parameters whose range is no point, with its ends. In polynomials they come after the state.
    pub ranges: Vec<(String, [Rational; 2])>,
    /// The modes' names as written.
    pub written: Vec<String>,
    /// For each mode its selector, and what it makes of the variables that it changes.
    pub modes: Vec<(String, BTreeMap<usize, Polynomial>)>,
    /// Which mode acts when; `Cycle` speaks of places in `modes`.
    pub turns: Turns,
}

/// What the names of a system stand for.
struct Symbols(BTreeMap<String, Polynomial>);

impl Meaning for Symbols {
    fn name(&self, name: &str) -> Result<Polynomial, String> {
        let unknown =
            || format!("`{}`: expected a variable or a parameter", exact::shortened(name));
        self.0.get(name).cloned().ok_or_else(unknown)
    }
}

/// A variable by its place in the state, or a parameter by that after the state.
pub fn symbol(index: usize) -> Polynomial {
    Polynomial::variable(u32::try_from(index).unwrap_or(u32::MAX))
}

impl Runs {
    /// Declares a system in the sheet, and assumes its steps. `None` where its text cannot be read.
    pub fn declare(sheet: &mut Sheet, system: &LinearSystem, turns: Turns) -> Option<Self> {
        let mut names = Names::default();
        let mut symbols = Symbols(BTreeMap::new());
        let mut state = Vec::new();
        for (index, name) in system.state.iter().enumerate() {
            symbols.0.insert(name.clone(), symbol(index));
            state.push(names.fresh(name));
        }
        let mut ranges = Vec::new();
        for (name, ends) in &system.parameters {
            let [low, high] =
                [exact::parse(name, &ends[0]).ok()?, exact::parse(name, &ends[1]).ok()?];
            let value = if low == high {
                Polynomial::constant(low)
            } else {
                ranges.push((names.fresh(name), [low, high]));
                symbol(state.len() + ranges.len() - 1)
            };
            symbols.0.insert(name.clone(), value);
        }
        let mut modes = Vec::new();
        for (name, rows) in &system.modes {
            let row = |(variable, text): (&String, &String)| {
                let index = system.state.iter().position(|v| v == variable)?;
                Some((index, Expression::parse(text).ok()?.value(&symbols).ok()?))
            };
            let rows = rows.iter().map(row).collect::<Option<BTreeMap<_, _>>>()?;
            modes.push((name.clone(), rows));
        }
        if turns == Turns::Any && modes.len() > 1 {
            modes.iter_mut().for_each(|(name, _)| *name = names.fresh(name));
        }
        let step = names.stem("k");
        let written = system.modes.keys().cloned().collect();
        let runs = Self { names, step, state, ranges, written, modes, turns };
        runs.assume(sheet);
        Some(runs)
    }

    /// Whether some of several modes acts in each step.
    pub fn chooses(&self) -> bool {
        self.turns == Turns::Any && self.modes.len() > 1
    }

    fn assume(&self, sheet: &mut Sheet) {
        let name = self.step.clone();
        let k = Time { variable: Some((name.clone(), 0)), stride: 1, offset: 0 };
        for v in &self.state {
            sheet.function(v, 1, "real");
        }
        for (p, [low, high]) in &self.ranges {
            sheet.function(p, 1, "real");
            let [low, high] = [
                format!("{p}({name}) >= {}", fraction(low)),
                format!("{p}({name}) <= {}", fraction(high)),
            ];
            sheet.assume(clause(&format!("low.{p}"), &name, &[], &low));
            sheet.assume(clause(&format!("high.{p}"), &name, &[], &high));
        }
        if self.chooses() {
            for (m, _) in &self.modes {
                sheet.function(m, 1, "integer");
                sheet.assume(clause(
                    &format!("acts.{m}"),
                    &name,
                    &[],
                    &format!("{m}({name}) >= 0"),
                ));
            }
            let all: Vec<String> = self.modes.iter().map(|(m, _)| format!("{m}({name})")).collect();
            sheet.assume(clause("modes", &name, &[], &format!("1 - ({}) = 0", all.join(" + "))));
        }
        let period = match &self.turns {
            Turns::Any => 1,
            Turns::Cycle(modes) => modes.len(),
        };
        let given = format!("k: {name} >= 0");
        for phase in 0..period {
            let now = Time { stride: period, offset: phase, ..k.clone() };
            for (v, function) in self.state.iter().enumerate() {
                let goal = format!("{function}({}) = {}", now.later(1).text(), self.next(v, &now));
                sheet.assume(clause(&self.step_name(v, phase), &name, &[&given], &goal));
            }
        }
    }

    fn step_name(&self, v: usize, phase: usize) -> String {
        match &self.turns {
            Turns::Any => format!("step.{}", self.state[v]),
            Turns::Cycle(_) => format!("step{phase}.{}", self.state[v]),
        }
    }

    /// What a variable is after the step at that time, as text.
    fn next(&self, v: usize, now: &Time) -> String {
        let stays = format!("{}({})", self.state[v], now.text());
        let row = |m: usize| self.modes.get(m).and_then(|(_, rows)| rows.get(&v));
        match &self.turns {
            Turns::Cycle(modes) => {
                let mode = modes.get(now.offset % modes.len().max(1)).copied();
                mode.and_then(row).map_or(stays, |row| self.text(row, now))
            }
            Turns::Any if self.modes.len() == 1 => row(0).map_or(stays, |row| self.text(row, now)),
            Turns::Any => {
                let changed = (0..self.modes.len()).filter_map(|m| {
                    let (name, at) = (&self.modes[m].0, now.text());
                    row(m).map(|row| format!(" + {name}({at})*({} - {stays})", self.text(row, now)))
                });
                let changed: String = changed.collect();
                stays + &changed
            }
        }
    }

    /// How far a parameter is from the `low` or the `high` end of its range at that time, as text.
    pub fn distance(&self, end: &str, parameter: &str, at: &Time) -> Option<String> {
        let (_, [low, high]) = self.ranges.iter().find(|(name, _)| name == parameter)?;
        let value = format!("{parameter}({})", at.text());
        match end {
            "low" => Some(format!("({value} - {})", bracketed(low))),
            "high" => Some(format!("({} - {value})", bracketed(high))),
            _ => None,
        }
    }

    /// A polynomial in state and parameters at that time.
    pub fn text(&self, poly: &Polynomial, at: &Time) -> String {
        let at = at.text();
        let name = |v: u32| {
            let past = (v as usize).checked_sub(self.state.len());
            let range = past.and_then(|p| self.ranges.get(p)).map(|(name, _)| name);
            let function = range.or_else(|| self.state.get(v as usize));
            function.map(|f| format!("{f}({at})"))
        };
        let mut text = String::new();
        for (monomial, c) in poly.terms() {
            let factors = monomial.powers().flat_map(|(v, e)| (0..e).filter_map(move |_| name(v)));
            let factors: Vec<String> = factors.collect();
            add_term(&mut text, c, &factors.iter().map(String::as_str).collect::<Vec<_>>());
        }
        or_zero(text)
    }

    /// The fact by which a variable changes in the step at that time, its name ending in `tag`.
    pub fn step_at(&self, v: usize, at: &Time, tag: &str) -> Value {
        let period = if let Turns::Cycle(modes) = &self.turns { modes.len().max(1) } else { 1 };
        let lemma = self.step_name(v, at.offset % period);
        let [term, bound] = at.quotient(period);
        let k = &self.step;
        instance(&format!("{lemma}{tag}"), &lemma, &format!("{k}={term}"), &format!("k={bound}"))
    }

    /// The name of [`Self::step_at`]'s fact.
    pub fn step_fact(&self, v: usize, at: &Time, tag: &str) -> String {
        let period = if let Turns::Cycle(modes) = &self.turns { modes.len().max(1) } else { 1 };
        format!("[{}{tag}]", self.step_name(v, at.offset % period))
    }

    /// An assumption about every step at that time, its name ending in `tag`.
    pub fn every(&self, lemma: &str, at: &Time, tag: &str) -> Value {
        let k = &self.step;
        instance(&format!("{lemma}{tag}"), lemma, &format!("{k}={}", at.text()), "")
    }

    /// Reads a comparison of forms that are affine in the state.
    pub fn literal(&self, system: &LinearSystem, text: &str) -> Option<Literal> {
        let names = system.state.iter().enumerate().map(|(i, name)| (name.clone(), symbol(i)));
        let symbols = Symbols(names.collect());
        let [Comparison { greater, less, relation }] = comparisons(text).ok()?.try_into().ok()?;
        let [greater, less] = [greater.value(&symbols).ok()?, less.value(&symbols).ok()?];
        // Of an equation the left side comes first, as in the checker.
        let form = if relation == Sign::Zero { less - &greater } else { greater - &less };
        let form = form.affine()?;
        let (constant, coefficients) = form.parts()?;
        let nonzero = coefficients.iter().cloned().enumerate().filter(|(_, c)| !c.is_zero());
        Some(Literal { form: nonzero.collect(), constant: constant.clone(), sign: relation })
    }
}

impl Literal {
    /// The form as a polynomial, with a polynomial in the place of each variable.
    pub fn with(&self, value: impl Fn(usize) -> Polynomial) -> Polynomial {
        let constant = Polynomial::constant(self.constant.clone());
        self.form
            .iter()
            .fold(constant, |sum, (v, c)| sum + &(value(*v) * &Polynomial::constant(c.clone())))
    }

    /// The form as a polynomial.
    pub fn poly(&self) -> Polynomial {
        self.with(symbol)
    }

    /// The literal in the checker's words.
    pub fn text(&self, runs: &Runs, at: &Time) -> String {
        let sign = match self.sign {
            Sign::Positive => ">",
            Sign::NonNegative => ">=",
            Sign::Zero => "=",
        };
        format!("{} {sign} 0", runs.text(&self.poly(), at))
    }
}
