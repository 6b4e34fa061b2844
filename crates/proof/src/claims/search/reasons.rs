//! Why a half-space holds: multipliers of others, those near it first.

use std::collections::BTreeSet;

use num_traits::Zero;

use super::Search;
use cordon_core::Rational;
use cordon_core::linear::feasible::{Constraint, Premises, Sign};

/// Links from what a goal speaks of to what is near it: 0, 1, and so on; then everything counts.
const NEAR: usize = 3;

/// Most half-spaces from all of which something is shown: a program with more, whose answer is mostly
/// that it does not follow, is work without use, where the near ones did not show it.
const MANY: usize = 300;

/// Most variables of a half-space that makes them near each other.
const FEW: usize = 4;

impl Search<'_> {
    /// Multipliers that show a half-space to follow from the rows of a moment, but for `without`.
    pub(super) fn follows(
        &self,
        goal: &Constraint,
        moment: usize,
        without: Option<&[bool]>,
    ) -> Option<Vec<(usize, Rational)>> {
        let known = |j: &usize| {
            self.rows[*j].moment == moment && without.is_none_or(|gone| gone.get(*j) != Some(&true))
        };
        let places: Vec<usize> = (0..self.rows.len()).filter(known).collect();
        // The row itself, or a weaker copy of it, is the commonest reason.
        let same = |&&j: &&usize| {
            let c = &self.rows[j].is;
            c.form == goal.form && (c.sign == goal.sign || c.sign == Sign::Positive)
        };
        if let Some(&j) = places.iter().find(same) {
            return Some(vec![(j, Rational::from_integer(1.into()))]);
        }
        let given: Vec<Constraint> = places.iter().map(|&j| self.rows[j].is.clone()).collect();
        let found = self.near_first(&given, goal, given.len() <= MANY)?;
        Some(found.into_iter().filter_map(|(at, m)| Some((*places.get(at)?, m))).collect())
    }

    /// Multipliers of what is given, by place: first of what speaks of nothing else than the goal does,
    /// a small program; then of what speaks of what is near that too, some links on; then, if `all` may
    /// count, of all.
    fn near_first(
        &self,
        given: &[Constraint],
        goal: &Constraint,
        all: bool,
    ) -> Option<Vec<(usize, Rational)>> {
        let speaks_of = |c: &Constraint| {
            let coefficients = c.form.parts().map_or(&[][..], |(_, c)| c);
            let nonzero = coefficients.iter().enumerate().filter(|(_, c)| !c.is_zero());
            nonzero.map(|(j, _)| j).collect::<Vec<usize>>()
        };
        let about: Vec<Vec<usize>> = given.iter().map(speaks_of).collect();
        let mut near: BTreeSet<usize> = speaks_of(goal).into_iter().collect();
        let mut tried = usize::MAX;
        for links in 0..=NEAR {
            let is_near = |j: &usize| {
                (all && links == NEAR)
                    || about.get(*j).is_some_and(|a| a.iter().all(|v| near.contains(v)))
            };
            let places: Vec<usize> = (0..given.len()).filter(is_near).collect();
            if places.len() != tried {
                tried = places.len();
                let some: Vec<Constraint> =
                    places.iter().filter_map(|&j| given.get(j).cloned()).collect();
                let premises = Premises::new(&some)?;
                if let Some(multipliers) = premises.multipliers_within(goal, &self.work) {
                    let found = places.into_iter().zip(multipliers);
                    return Some(found.filter(|(_, m)| !m.is_zero()).collect());
                }
            }
            let touches = |a: &&Vec<usize>| a.len() <= FEW && a.iter().any(|v| near.contains(v));
            let more: Vec<usize> = about.iter().filter(touches).flatten().copied().collect();
            near.extend(more);
        }
        None
    }

    /// Multipliers of the assumptions that show a row to hold of every start.
    pub(super) fn holds_of_start(&self, row: usize) -> Option<Vec<(usize, Rational)>> {
        self.near_first(&self.starts, &self.rows.get(row)?.is, true)
    }
}
