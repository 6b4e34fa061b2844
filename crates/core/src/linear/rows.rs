//! One protocol step as a sparse matrix in other coordinates than positions: errors and gaps.
//!
//! The rows are rearranged weights of a [`Stencil`], which reads them off the spec. That the step is
//! linear in these coordinates, without a constant, is not assumed but checked on the weights.

use std::collections::BTreeMap;

use cordon_spec::Scalar;

use crate::stencil::{Role, Stencil};

/// A row of a matrix: the columns in which it is not 0, ascending, with the entries.
pub type Row<T> = Vec<(usize, T)>;

impl<T: Scalar + PartialEq> Stencil<T> {
    /// The step in errors (PROTOCOL section 2: e' = A e): row i of A, times `den`, for drone i of
    /// `count`, with e_i = T_i - X_i. `None` where the step moves the targets.
    pub fn error_rows(&self, count: usize) -> Option<Vec<Row<T>>> {
        // On the segment [0, N-1] the target of drone i is i.
        let last = T::from_index(count.checked_sub(1)?);
        let targets: Vec<T> = (0..count).map(T::from_index).collect();
        let fixed = |i: usize| {
            let next = self.apply(&T::from_int(0), &last, &targets, i);
            next == self.den.clone() * &targets[i]
        };
        let row = |i: usize| {
            let w = self.weights(Role::of(i, count));
            // The ends of the segment have no error.
            let before = i.checked_sub(1).map(|j| (j, w.prec.clone()));
            let after = (i + 1 < count).then(|| (i + 1, w.foll.clone()));
            let entries = before.into_iter().chain([(i, w.own.clone())]).chain(after);
            without_zeros(entries)
        };
        (0..count).map(|i| fixed(i).then(|| row(i))).collect()
    }

    /// The step in gaps, the segment being that between the end drones: row i gives `den` times gap i,
    /// from drone i to drone i+1 of `count`, in terms of the gaps before the step. `None` where the
    /// step depends on more than gaps.
    pub fn gap_rows(&self, count: usize) -> Option<Vec<Row<T>>> {
        let last = count.checked_sub(1)?;
        let row = |i: usize| {
            let mut difference = BTreeMap::new();
            let zero = T::from_int(0);
            for (drone, is_upper) in [(i, false), (i + 1, true)] {
                let w = self.weights(Role::of(drone, count));
                let neighbours = [drone.saturating_sub(1), drone, (drone + 1).min(last)];
                let places = [0, last].into_iter().chain(neighbours);
                for (index, weight) in places.zip(w.as_array()) {
                    let sum = difference.remove(&index).unwrap_or_else(|| zero.clone());
                    difference.insert(index, if is_upper { sum + weight } else { sum - weight });
                }
            }
            // Summation by parts: the gap after place j counts the weights up to j, negated.
            let (from, to) = (*difference.keys().next()?, *difference.keys().next_back()?);
            let mut taken = T::from_int(0);
            let mut entries = Vec::new();
            for index in from..=to {
                if let Some(weight) = difference.get(&index) {
                    taken = taken - weight;
                }
                entries.push((index, taken.clone()));
            }
            (taken == zero).then(|| without_zeros(entries))
        };
        (0..last).map(row).collect()
    }
}

/// The product of the matrix and a vector.
pub fn applied<T: Scalar>(rows: &[Row<T>], x: &[T]) -> Vec<T> {
    let entry = |row: &Row<T>| {
        row.iter().fold(T::from_int(0), |sum, (j, a)| match x.get(*j) {
            Some(x) => sum + &(a.clone() * x),
            None => sum,
        })
    };
    rows.iter().map(entry).collect()
}

fn without_zeros<T: Scalar + PartialEq>(entries: impl IntoIterator<Item = (usize, T)>) -> Row<T> {
    let zero = T::from_int(0);
    entries.into_iter().filter(|(_, a)| *a != zero).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use cordon_spec::coverage::exec_coverage;
    use cordon_spec::{Params, State};
    use proptest::prelude::*;

    use super::*;
    use crate::Rational;

    fn rational() -> impl Strategy<Value = Rational> {
        (-1000i64..=1000, 1i64..=60).prop_map(|(p, q)| Rational::new(p.into(), q.into()))
    }

    proptest! {
        #[test]
        fn rows_are_the_spec(eps in rational(), x in prop::collection::vec(rational(), 3..10)) {
            let count = x.len();
            let last = Rational::from_index(count - 1);
            let stencil = Stencil::executed(&eps);
            // Errors on [0, N-1]; gaps on the segment between the end drones.
            let p = |min: &Rational, max: &Rational| {
                Params { min: min.clone(), max: max.clone(), eps: eps.clone(), n: 0 }
            };
            let step = |p| exec_coverage(&p, &State { drones: x.clone(), timesteps: 0 }).drones;
            let errors = |x: &[Rational]| -> Vec<Rational> {
                x.iter().enumerate().map(|(i, x)| Rational::from_index(i) - x).collect()
            };
            let rows = stencil.error_rows(count).unwrap();
            let after = step(p(&Rational::from_int(0), &last));
            prop_assert_eq!(applied(&rows, &errors(&x)), errors(&after));
            let gaps = |x: &[Rational]| -> Vec<Rational> {
                x.windows(2).map(|pair| &pair[1] - &pair[0]).collect()
            };
            let rows = stencil.gap_rows(count).unwrap();
            let after = step(p(&x[0], &x[count - 1]));
            prop_assert_eq!(applied(&rows, &gaps(&x)), gaps(&after));
        }
    }

    #[test]
    fn a_step_that_moves_the_targets_has_no_error_rows() {
        let mut stencil = Stencil::executed(&Rational::new(1.into(), 5.into()));
        assert!(stencil.error_rows(5).is_some() && stencil.gap_rows(5).is_some());
        stencil.internal.own = Rational::new(1.into(), 2.into());
        assert_eq!((stencil.error_rows(5), stencil.gap_rows(5)), (None, None));
    }
}
