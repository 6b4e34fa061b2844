//! What is kept from the beginning (Houdini: Flanagan and Leino 2001).

use super::{Kept, Row, Search};
use cordon_core::Rational;
use cordon_core::linear::feasible::Constraint;
use cordon_core::system::inequalities;

impl Search<'_> {
    /// The largest set of assumptions and claims that holds of the start and that every step keeps.
    pub(super) fn kept_from_the_beginning(&mut self) -> Option<()> {
        let assumed: Vec<Constraint> = self.starts.iter().flat_map(inequalities).collect();
        for moment in 0..self.automaton.names.len() {
            let claims = self.automaton.claims[moment].iter();
            let claims = claims.filter_map(|&j| self.system.claims.get(j));
            let claimed = claims.flat_map(|c| inequalities(&c.predicate.is)).collect::<Vec<_>>();
            for is in claimed.into_iter().chain(assumed.clone()) {
                if !self.rows.iter().any(|r| r.moment == moment && r.is == is) {
                    let row = Row { is, moment, claim: None, depth: 0, leads_to: None };
                    self.rows.push(row);
                }
            }
        }
        let mut gone = vec![false; self.rows.len()];
        let mut base: Vec<Option<Vec<(usize, Rational)>>> = vec![None; self.rows.len()];
        for j in 0..self.rows.len() {
            if self.rows[j].moment == 0 {
                base[j] = self.holds_of_start(j);
                gone[j] = base[j].is_none();
            }
        }
        let mut kept: Vec<Vec<Kept>>;
        loop {
            kept = vec![Vec::new(); self.rows.len()];
            let mut dropped = false;
            for j in 0..self.rows.len() {
                if !gone[j] {
                    match self.keeps(j, &gone) {
                        Some(proofs) => kept[j] = proofs,
                        None => (gone[j], dropped) = (true, true),
                    }
                }
                if self.work.left() == 0 {
                    return None;
                }
            }
            if !dropped {
                break;
            }
        }
        self.retain(&gone, base, kept);
        Some(())
    }

    /// The proofs that every step to a row's moment keeps the row.
    fn keeps(&self, row: usize, gone: &[bool]) -> Option<Vec<Kept>> {
        let edges: Vec<(usize, usize, usize)> = self
            .automaton
            .into(self.rows[row].moment)
            .map(|(e, edge)| (e, edge.from, edge.mode))
            .collect();
        let mut proofs = Vec::new();
        for (edge, from, mode) in edges {
            for corner in self.corners(row, mode)? {
                let image = self.pre_image(row, mode, &corner)?;
                let multipliers = self.follows(&image, from, Some(gone))?;
                proofs.push(Kept { row, edge, corner, multipliers });
            }
        }
        Some(proofs)
    }
}
