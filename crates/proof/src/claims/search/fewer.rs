//! Rows that are left out of an invariant.

use std::mem;

use num_traits::Zero;

use super::{Kept, Search};
use cordon_core::Rational;

/// Puts a combination of others in the place of a premise.
fn replace(multipliers: &mut Vec<(usize, Rational)>, row: usize, others: &[(usize, Rational)]) {
    let Some(at) = multipliers.iter().position(|(j, _)| *j == row) else { return };
    let (_, factor) = multipliers.swap_remove(at);
    for (j, m) in others {
        match multipliers.iter_mut().find(|(known, _)| known == j) {
            Some((_, sum)) => *sum += &factor * m,
            None => multipliers.push((*j, &factor * m)),
        }
    }
    multipliers.retain(|(_, m)| !m.is_zero());
    multipliers.sort_by_key(|(j, _)| *j);
}

impl Search<'_> {
    /// Leaves out rows that follow from others of their moment: what was shown with their help is shown
    /// with the help of those. The longest way from a claim goes first: there numbers are longest.
    pub(super) fn minimise(&mut self) {
        let mut gone = vec![false; self.rows.len()];
        for j in (0..self.rows.len()).rev() {
            let Some(row) = self.rows.get(j).filter(|r| r.claim.is_none()) else { continue };
            if let Some(slot) = gone.get_mut(j) {
                *slot = true;
            }
            let Some(others) = self.follows(&row.is, row.moment, Some(&gone)) else {
                if let Some(slot) = gone.get_mut(j) {
                    *slot = false;
                }
                continue;
            };
            for kept in &mut self.kept {
                replace(&mut kept.multipliers, j, &others);
            }
        }
        let mut base = vec![None; self.rows.len()];
        for (j, multipliers) in mem::take(&mut self.base) {
            if let Some(slot) = base.get_mut(j) {
                *slot = Some(multipliers);
            }
        }
        let kept = vec![mem::take(&mut self.kept)];
        self.retain(&gone, base, kept);
    }

    /// Drops the rows that are gone, and renumbers the others.
    pub(super) fn retain(
        &mut self,
        gone: &[bool],
        base: Vec<Option<Vec<(usize, Rational)>>>,
        kept: Vec<Vec<Kept>>,
    ) {
        let mut index = vec![usize::MAX; gone.len()];
        let mut rows = Vec::new();
        for (j, row) in self.rows.drain(..).enumerate() {
            if gone.get(j) == Some(&false) {
                index[j] = rows.len();
                rows.push(row);
            }
        }
        self.rows = rows;
        let at = |j: usize| index.get(j).copied().unwrap_or(usize::MAX);
        for (j, multipliers) in base.into_iter().enumerate() {
            if let (Some(m), false) = (multipliers, at(j) == usize::MAX) {
                self.base.push((at(j), m));
            }
        }
        for proof in kept.into_iter().flatten().filter(|k| at(k.row) != usize::MAX) {
            let multipliers = proof.multipliers.into_iter().map(|(j, m)| (at(j), m)).collect();
            self.kept.push(Kept { row: at(proof.row), multipliers, ..proof });
        }
    }
}
