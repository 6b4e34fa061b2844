//! Forms that are at least 0, as sums of squares.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::One;
use serde_json::Value;

use super::squares::squares;
use super::text::{
    Terms, add, difference, fraction_times, linear, matrix_times, quadratic, reals, refs,
};
use super::{Names, Writer};
use crate::certificate::theorem::{clause, instance, positivity, split};
use cordon_core::Rational;
use cordon_core::linear::matrix::{self, Matrix};

/// What shows that so many times a form is at least 0: literals given, facts and their sum, and what the roots are.
#[derive(Default)]
pub(super) struct Shown {
    pub(super) times: Rational,
    pub(super) given: Names,
    pub(super) facts: Vec<Value>,
    pub(super) sum: String,
    pub(super) roots: Vec<Terms>,
}

impl Writer<'_> {
    /// Squares are not negative.
    pub(super) fn square(&mut self) {
        let s = &self.s;
        let [above, equal, below] = ["[sign]*[sign]", &format!("[sign]*{s}"), "[sign]*[sign]"]
            .map(|sum| positivity(&[], sum));
        let clause = clause("square", &format!("{s}:real"), &[], &format!("{s}*{s} >= 0"));
        self.sheet.lemma(clause, split("sign", s, [above, equal, below]));
    }

    /// What shows that a form of z, times a number, is at least 0. A square of more than two terms is that of a variable, a root, for
    /// which they are given.
    pub(super) fn shown(&self, m: &Matrix) -> Option<Shown> {
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
                add(&mut shown.sum, &-&factor, [format!("[{root}]"), both]);
                shown.roots.push(entries);
            }
            add(&mut shown.sum, &factor, [format!("[s{i}]")]);
            let square = instance(&format!("s{i}"), "square", &format!("{}={root}", self.s), "");
            shown.facts.push(square);
        }
        Some(shown)
    }

    pub(super) fn roots(&self, shown: &Shown) -> Names {
        (0..shown.roots.len()).map(|i| format!("{}{i}", self.q)).collect()
    }

    /// Terms for z, and for the roots of what is shown.
    pub(super) fn of(&self, terms: &[String], shown: &Shown) -> Names {
        let roots = shown.roots.iter().map(|root| linear(root, terms));
        let names = self.z.iter().cloned().chain(self.roots(shown));
        names
            .zip(terms.iter().cloned().chain(roots))
            .map(|(v, term)| format!("{v}={term}"))
            .collect()
    }

    /// For each form a lemma that its value is at least that part of |z|^2; where steps mix maps, also that the form is at least 0.
    pub(super) fn norms(&mut self, part: &Rational, mixing: bool) -> Option<Vec<Shown>> {
        let (z, [value, _]) = (self.z.clone(), self.values_of_form.clone());
        let square = |z: &String| format!("{z}*{z}");
        let squares = format!("({})", z.iter().map(square).collect::<Vec<_>>().join(" + "));
        let mut norms = Vec::new();
        for (t, p) in self.forms.clone().iter().enumerate() {
            let shown = self.shown(&difference(p, &matrix_times(part, &matrix::unit(p.len()))))?;
            let (name, text) = (format!("norm.{t}"), quadratic(p, &z));
            let mut given = shown.given.clone();
            given.push(format!("form: {value} = {text}"));
            let mut sum = shown.sum.clone();
            add(&mut sum, &shown.times, ["[form]".to_owned()]);
            let least = fraction_times(&(part * &shown.times), &squares);
            let goal = format!("{} >= {least}", fraction_times(&shown.times, &value));
            let variables = reals(&[&z, &self.roots(&shown), &vec![value.clone()]]);
            let clause = clause(&name, &variables, &refs(&given), &goal);
            self.sheet.lemma(clause, positivity(&shown.facts, &sum));
            if mixing {
                self.form(t, part, &shown, &text);
            }
            norms.push(shown);
        }
        Some(norms)
    }

    /// A lemma that a form is at least 0.
    fn form(&mut self, t: usize, part: &Rational, norm: &Shown, text: &str) {
        let mut with = self.of(&self.z, norm);
        with.push(format!("{}={text}", self.values_of_form[0]));
        let mut facts = vec![instance("norm", &format!("norm.{t}"), &with.join(", "), "")];
        let mut sum = fraction_times(&norm.times.recip(), "[norm]");
        for z in &self.z {
            facts.push(instance(z, "square", &format!("{}={z}", self.s), ""));
            add(&mut sum, part, [format!("[{z}]")]);
        }
        let clause = clause(&format!("form.{t}"), &reals(&[&self.z]), &[], &format!("{text} >= 0"));
        self.sheet.lemma(clause, positivity(&facts, &sum));
    }
}
