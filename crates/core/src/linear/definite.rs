//! Positive definiteness of symmetric matrices, decided exactly by LDL' over the rationals.

use num_traits::{Signed, Zero};

use crate::Rational;

/// Whether `x'Ax > 0` for every nonzero `x`. The matrix is taken to be symmetric: only its lower
/// triangle is read. True for the empty matrix.
pub fn is_positive_definite(matrix: &[Vec<Rational>]) -> bool {
    let mut rows: Vec<Vec<Rational>> = matrix.to_vec();
    for k in 0..rows.len() {
        let pivot_row = rows[k].clone();
        let Some(pivot) = pivot_row.get(k).filter(|p| p.is_positive()) else { return false };
        // The entries of the pivot's column, which the pivot's row mirrors.
        let column: Vec<Rational> =
            rows.iter().skip(k).map(|row| row.get(k).cloned().unwrap_or_default()).collect();
        for i in k + 1..rows.len() {
            let entry = &column[i - k];
            if entry.is_zero() {
                continue;
            }
            let factor = entry / pivot;
            for j in k + 1..=i {
                let taken = &factor * &column[j - k];
                if let Some(x) = rows[i].get_mut(j) {
                    *x -= taken;
                }
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: &[&[i64]]) -> Vec<Vec<Rational>> {
        rows.iter().map(|r| r.iter().map(|&x| Rational::from_integer(x.into())).collect()).collect()
    }

    #[test]
    fn definite_and_not() {
        assert!(is_positive_definite(&matrix(&[&[2, -1, 0], &[-1, 2, -1], &[0, -1, 2]])));
        assert!(is_positive_definite(&matrix(&[&[2], &[-1, 2]])));
        // Semidefinite, indefinite, and with a zero on the diagonal.
        assert!(!is_positive_definite(&matrix(&[&[1, 1], &[1, 1]])));
        assert!(!is_positive_definite(&matrix(&[&[1, 2], &[2, 1]])));
        assert!(!is_positive_definite(&matrix(&[&[0]])));
    }
}
