//! The nodes at the beginning of a run, each at one step: their literals one by one, as facts without
//! weights. Multipliers are numbers there, of which there may be many.

use std::collections::BTreeMap;

use num_traits::{One, Signed, Zero};
use serde_json::Value;

use super::super::linear::Multipliers;
use super::super::runs::{Literal, Time, symbol};
use super::super::theorem::{clause, positivity};
use super::Writer;
use super::carry::row;
use super::walk::How;
use cordon_core::Rational;
use cordon_core::exact::fraction;
use cordon_core::linear::feasible::Sign;
use cordon_core::scalar::Polynomial;
use cordon_core::system::expression::add_term;

/// Multipliers of the literals before, and the constant that they leave.
type Row = (BTreeMap<usize, Rational>, Rational);

impl Writer<'_> {
    /// The name of the fact that a place's literal holds.
    pub(super) fn fact(place: usize, j: usize) -> String {
        if place == 0 { format!("start.{j}") } else { format!("at{place}.{j}") }
    }

    /// Makes facts of the literals of all places from the start on, up to the first that recurs or that is reached by a
    /// step in which something is chosen. `None` where the multipliers do not fit.
    pub(super) fn begin(&mut self) -> Option<()> {
        let last = self.period().map_or(self.walk.places.len() - 1, |(first, _)| first);
        while self.shares.len() <= last {
            let place = self.shares.len();
            let Some(rows) = self.rows(place) else { break };
            let rows = rows.into_iter().collect::<Option<Vec<Row>>>()?;
            self.prove_facts(place, &rows)?;
        }
        Some(())
    }

    /// The multipliers of a place's literals, if they are numbers: of each what is written, if it fits.
    fn rows(&self, place: usize) -> Option<Vec<Option<Row>>> {
        let how = self.walk.places.get(place).map(|p| p.how.clone())?;
        let (edge, updates) = match how {
            How::Here(edge) => (edge, None),
            How::Step(edges) if !self.runs.chooses() => {
                let edge = *edges.first()?;
                let index =
                    self.runs.written.iter().position(|name| edge.by.as_ref() == Some(name))?;
                (edge, self.runs.modes.get(index))
            }
            How::Start | How::Step(_) => return None,
        };
        let size = self.runs.state.len();
        let image = |literal: &Literal| match updates {
            None => literal.poly(),
            Some((_, rows)) => literal.with(|v| rows.get(&v).cloned().unwrap_or_else(|| symbol(v))),
        };
        let images: Vec<Polynomial> = self.node(place).iter().map(image).collect();
        let varies =
            |p: &Polynomial| p.terms().any(|(m, _)| m.powers().any(|(v, _)| v as usize >= size));
        if images.iter().any(varies) {
            return None;
        }
        let before = self.node(place.checked_sub(1)?);
        let rows = images.iter().enumerate().map(|(j, image)| {
            let [multipliers] = edge.multipliers.get(j)?.as_slice() else { return None };
            row(multipliers, image.evaluate(|_| Rational::zero()), before)
        });
        Some(rows.collect())
    }

    /// How much of the margin (or of 1, where there is none) a sum of a place's literals has.
    fn margin_of(&self, place: usize, multipliers: &BTreeMap<usize, Rational>) -> Rational {
        let strict = |i: &usize| self.node(place).get(*i).is_some_and(|l| l.sign == Sign::Positive);
        let sum: Rational = multipliers.iter().filter(|(i, _)| strict(i)).map(|(_, m)| m).sum();
        self.shares.get(place).map_or_else(Rational::zero, |share| sum * share)
    }

    fn prove_facts(&mut self, place: usize, rows: &[Row]) -> Option<()> {
        let before = place.checked_sub(1)?;
        let node = self.node(place).to_vec();
        let at = Time::step(self.walk.places.get(place)?.step);
        let above = node.iter().zip(rows).filter(|(l, _)| l.sign == Sign::Positive);
        let share = above
            .map(|(_, row)| &row.1 + self.margin_of(before, &row.0))
            .fold(Rational::one(), Rational::min);
        if !share.is_positive() {
            return None;
        }
        let margin = if self.has_margin() { format!("*{}", self.margin) } else { String::new() };
        let equations: Vec<bool> = self.node(before).iter().map(|l| l.sign == Sign::Zero).collect();
        for (j, (literal, row)) in node.iter().zip(rows).enumerate() {
            let form = self.runs.text(&literal.poly(), &at);
            let (goal, least) = match literal.sign {
                Sign::Zero => (format!("{form} = 0"), Rational::zero()),
                Sign::NonNegative => (format!("{form} >= 0"), Rational::zero()),
                Sign::Positive => {
                    (format!("{form} >= {}{margin}", fraction(&share)), share.clone())
                }
            };
            let mut sum = String::new();
            let mut row = row.clone();
            let mut steps = Vec::new();
            if let How::Step(_) = self.walk.places.get(place)?.how {
                let then = Time::step(at.offset.checked_sub(1)?);
                for (v, c) in &literal.form {
                    add_term(&mut sum, c, &[&self.runs.step_fact(*v, &then, "")]);
                    steps.push(self.runs.step_at(*v, &then, ""));
                }
            } else if let Some(near) = j.checked_sub(1).filter(|near| {
                // Often it is little more than the one before.
                [near, &j].iter().all(|i| node[**i].sign == Sign::NonNegative)
            }) {
                let rest = less(&row, &rows[near], &equations).filter(|r| r.0.len() < row.0.len());
                if let Some(rest) = rest {
                    add_term(
                        &mut sum,
                        &Rational::one(),
                        &[&format!("[{}]", Self::fact(place, near))],
                    );
                    row = rest;
                }
            }
            self.add_facts(&mut sum, before, &row, &least);
            let goal = clause(&Self::fact(place, j), "", &[], &goal);
            self.sheet.lemma(goal, positivity(&steps, &sum));
        }
        self.shares.push(share);
        Some(())
    }

    /// Adds the facts of a place times multipliers, and what is left: a constant, and more of the margin than the `least`.
    fn add_facts(&self, sum: &mut String, place: usize, (m, left): &Row, least: &Rational) {
        for (i, m) in m {
            add_term(sum, m, &[&format!("[{}]", Self::fact(place, *i))]);
        }
        let (mut constant, over) = (left.clone(), self.margin_of(place, m) - least);
        match self.has_margin() {
            false => constant += over,
            // The margin is in (0, 1].
            true if over.is_negative() => {
                constant += &over;
                add_term(sum, &-over, &["[margin.high]"]);
            }
            true if over.is_zero() => {}
            true => add_term(sum, &over, &["[margin.low]"]),
        }
        if !constant.is_zero() || sum.is_empty() {
            add_term(sum, &constant, &[]);
        }
    }

    /// A literal from the facts of a place.
    pub(super) fn by_facts(
        &self,
        literal: &Literal,
        place: usize,
        multipliers: &Multipliers,
    ) -> Option<Value> {
        let row = row(multipliers, literal.constant.clone(), self.node(place))?;
        let mut sum = String::new();
        self.add_facts(&mut sum, place, &row, &Rational::zero());
        Some(positivity(&[], &sum))
    }

    /// The clause of the last place with facts, from those.
    pub(super) fn by_all_facts(&self, place: usize) -> Option<Value> {
        let share = self.shares.get(place)?;
        let added = format!("[{}]", self.added);
        let mut sum = String::new();
        for (j, literal) in self.node(place).iter().enumerate() {
            let l = self.weight(j);
            let l = if literal.sign == Sign::Zero { l } else { format!("[{l}]") };
            add_term(&mut sum, &Rational::one(), &[&l, &format!("[{}]", Self::fact(place, j))]);
        }
        let factors: &[&str] = if self.has_margin() { &["[margin.low]"] } else { &[] };
        add_term(&mut sum, share, &[factors, &["[positive]"]].concat());
        if !share.is_one() {
            add_term(&mut sum, &(Rational::one() - share), &[&added]);
        }
        if self.has_margin() {
            add_term(&mut sum, share, &["[margin.high]", &added]);
        }
        Some(positivity(&[], &sum))
    }
}

/// A row minus another, if what is left is a row too.
fn less(row: &Row, other: &Row, equations: &[bool]) -> Option<Row> {
    let (mut m, constant) = (row.0.clone(), &row.1 - &other.1);
    for (i, c) in &other.0 {
        *m.entry(*i).or_default() -= c;
    }
    m.retain(|_, c| !c.is_zero());
    let fits = |(i, c): (&usize, &Rational)| equations.get(*i) == Some(&true) || !c.is_negative();
    (!constant.is_negative() && m.iter().all(fits)).then_some((m, constant))
}
