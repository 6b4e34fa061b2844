//! The start and the run of a half-space that fails.

use num_traits::Zero;

use super::{Answer, Choice, End, Search};
use crate::claims::bounds::extreme;
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign, point_within};

impl Search<'_> {
    /// What a row comes to that was not shown of every start.
    pub(super) fn fails(&self, row: usize, depth: usize, may_refute: bool) -> Answer {
        let found = if may_refute { self.refuted(row) } else { None };
        let end = if self.work.left() == 0 { End::Work } else { End::Varying };
        found.unwrap_or(Answer::Open(depth, end))
    }

    /// The counterexample that a row is which fails of some start.
    fn refuted(&self, row: usize) -> Option<Answer> {
        let found = self.rows.get(row)?;
        let start = self.violating(&found.is)?;
        let mut choices = Vec::new();
        let mut at = &found.leads_to;
        while let Some((row, edge, corner)) = at {
            let mode = self.automaton.edges.get(*edge)?.mode;
            choices.push(Choice { mode, values: self.values(corner) });
            at = &self.rows.get(*row)?.leads_to;
        }
        Some(Answer::Refuted(start, choices))
    }

    /// A start that meets the assumptions and of which the half-space fails.
    fn violating(&self, is: &Constraint) -> Option<Vec<Rational>> {
        // The negation of form > 0 is -form >= 0, and of form >= 0 it is -form > 0.
        let form = Affine::constant(Rational::zero()) - &is.form;
        let with = |sign| {
            let last = Constraint { form: form.clone(), sign };
            let all: Vec<Constraint> = self.starts.iter().cloned().chain([last]).collect();
            point_within(self.system.state.len(), &all, &self.work)
        };
        // A corner of the start set first: its numbers are short. Then a real violation anywhere, then one that
        // only touches the bound.
        let corner = extreme(&form, &self.starts, self.system.state.len(), &self.work);
        let fails = |x: &Vec<Rational>| is.form.at(x).is_some_and(|value| !is.sign.met_by(&value));
        let is_start = |x: &Vec<Rational>| {
            self.starts.iter().all(|c| c.form.at(x).is_some_and(|value| c.sign.met_by(&value)))
        };
        if let Some(corner) = corner.filter(|x| fails(x) && is_start(x)) {
            return Some(corner);
        }
        with(Sign::Positive)
            .or_else(|| (is.sign == Sign::Positive).then(|| with(Sign::NonNegative)).flatten())
    }
}
