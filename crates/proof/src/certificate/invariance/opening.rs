//! The node that follows from what is assumed of the start: its literals one by one, as facts without
//! weights, since such multipliers are often many.

use std::collections::BTreeMap;

use num_traits::{One, Signed, Zero};

use super::super::runs::Time;
use super::super::theorem::{clause, positivity};
use super::carry::row;
use super::walk::How;
use super::{Opening, Writer};
use cordon_core::Rational;
use cordon_core::exact::fraction;
use cordon_core::linear::feasible::Sign;
use cordon_core::system::expression::add_term;

/// Multipliers of the assumptions, and the constant that they leave.
type Row = (BTreeMap<usize, Rational>, Rational);

impl Writer<'_> {
    /// Makes facts of the literals of the node that follows from the start without a step, unless something is claimed
    /// of the start itself. `None` where the multipliers do not fit.
    pub(super) fn open(&mut self) -> Option<()> {
        let edge = match self.walk.places.get(1).map(|p| &p.how) {
            Some(How::Here(edge)) if !self.claimed(0) => *edge,
            _ => return Some(()),
        };
        let (start, node) = (self.node(0).to_vec(), self.node(1).to_vec());
        let strict = |i: &usize| start.get(*i).is_some_and(|l| l.sign == Sign::Positive);
        let rows = node.iter().zip(&edge.multipliers).map(|(literal, multipliers)| {
            let [multipliers] = multipliers.as_slice() else { return None };
            row(multipliers, literal.constant.clone(), &start)
        });
        let rows = rows.collect::<Option<Vec<Row>>>()?;
        // How often a row has the margin.
        let margins = |(m, _): &Row| -> Rational {
            m.iter().filter(|(i, _)| strict(i)).map(|(_, m)| m).sum()
        };
        let above = node.iter().zip(&rows).filter(|(l, _)| l.sign == Sign::Positive);
        let share =
            above.map(|(_, row)| &row.1 + margins(row)).fold(Rational::one(), Rational::min);
        if rows.len() != node.len() || !share.is_positive() {
            return None;
        }
        for (j, (literal, row)) in node.iter().zip(&rows).enumerate() {
            let form = self.runs.text(&literal.poly(), &Time::step(0));
            let margin =
                if self.has_margin() { format!("*{}", self.margin) } else { String::new() };
            let (goal, least) = match literal.sign {
                Sign::Zero => (format!("{form} = 0"), Rational::zero()),
                Sign::NonNegative => (format!("{form} >= 0"), Rational::zero()),
                Sign::Positive => {
                    (format!("{form} >= {}{margin}", fraction(&share)), share.clone())
                }
            };
            // Often it is little more than the one before.
            let before = j.checked_sub(1).filter(|b| node[*b].sign == Sign::NonNegative);
            let rest = before.and_then(|b| less(row, &rows[b], &|i| start[*i].sign == Sign::Zero));
            let rest =
                rest.filter(|(m, _)| literal.sign == Sign::NonNegative && m.len() < row.0.len());
            let mut sum = String::new();
            if let (Some(before), Some(_)) = (before, &rest) {
                add_term(&mut sum, &Rational::one(), &[&format!("[first.{before}]")]);
            }
            let row = rest.as_ref().unwrap_or(row);
            for (i, m) in &row.0 {
                add_term(&mut sum, m, &[&format!("[start.{i}]")]);
            }
            // What is left: constant + margins * margin - least * margin, the margin being in (0, 1].
            let (mut constant, mut over) = (row.1.clone(), margins(row));
            if self.has_margin() {
                over -= &least;
                if over.is_negative() {
                    constant += &over;
                    add_term(&mut sum, &-over, &["[margin.high]"]);
                } else if !over.is_zero() {
                    add_term(&mut sum, &over, &["[margin.low]"]);
                }
            } else {
                constant -= &least;
            }
            if !constant.is_zero() || sum.is_empty() {
                add_term(&mut sum, &constant, &[]);
            }
            let goal = clause(&format!("first.{j}"), "", &[], &goal);
            self.sheet.lemma(goal, positivity(&[], &sum));
        }
        self.opening = Opening { place: 1, facts: "first", share };
        Some(())
    }
}

/// A row minus another, if what is left is a row too.
fn less(row: &Row, other: &Row, equation: &impl Fn(&usize) -> bool) -> Option<Row> {
    let (mut m, constant) = (row.0.clone(), &row.1 - &other.1);
    for (i, c) in &other.0 {
        *m.entry(*i).or_default() -= c;
    }
    m.retain(|_, c| !c.is_zero());
    let fits = !constant.is_negative() && m.iter().all(|(i, c)| equation(i) || !c.is_negative());
    fits.then_some((m, constant))
}
