//! Small dense matrices of exact numbers, each a list of its rows.

use num_traits::{One, Zero};

use crate::Rational;

/// A matrix: its rows, all of one length.
pub type Matrix = Vec<Vec<Rational>>;

/// The dot product; entries beyond the end of the shorter vector are ignored.
pub fn dot(a: &[Rational], b: &[Rational]) -> Rational {
    let nonzero = a.iter().zip(b).filter(|(x, y)| !x.is_zero() && !y.is_zero());
    nonzero.fold(Rational::zero(), |sum, (x, y)| sum + x * y)
}

/// `matrix` times the column `x`.
pub fn applied(matrix: &Matrix, x: &[Rational]) -> Vec<Rational> {
    matrix.iter().map(|row| dot(row, x)).collect()
}

/// The row vector `y` times `matrix`.
pub fn before(y: &[Rational], matrix: &Matrix) -> Vec<Rational> {
    let width = matrix.first().map_or(0, Vec::len);
    let mut product = vec![Rational::zero(); width];
    for (factor, row) in y.iter().zip(matrix).filter(|(factor, _)| !factor.is_zero()) {
        for (sum, x) in product.iter_mut().zip(row).filter(|(_, x)| !x.is_zero()) {
            *sum += factor * x;
        }
    }
    product
}

/// The product of two matrices.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    a.iter().map(|row| before(row, b)).collect()
}

/// The identity matrix with `size` rows.
pub fn unit(size: usize) -> Matrix {
    let row = |i| (0..size).map(move |j| if i == j { Rational::one() } else { Rational::zero() });
    (0..size).map(|i| row(i).collect()).collect()
}

/// The transpose.
pub fn transposed(matrix: &Matrix) -> Matrix {
    let width = matrix.first().map_or(0, Vec::len);
    (0..width).map(|j| matrix.iter().filter_map(|row| row.get(j).cloned()).collect()).collect()
}

/// The X with `left X = right`, by elimination; `None` where `left` is not square or is singular.
pub fn solution(left: &Matrix, right: &Matrix) -> Option<Matrix> {
    let size = left.len();
    if right.len() != size || left.iter().any(|row| row.len() != size) {
        return None;
    }
    let mut rows: Matrix =
        left.iter().zip(right).map(|(a, b)| a.iter().chain(b).cloned().collect()).collect();
    for column in 0..size {
        let pivot = (column..size).find(|&r| !rows[r][column].is_zero())?;
        rows.swap(column, pivot);
        let lead = rows[column][column].clone();
        rows[column].iter_mut().for_each(|x| *x /= &lead);
        let (above, rest) = rows.split_at_mut(column);
        let (pivot, below) = rest.split_first_mut()?;
        for row in above.iter_mut().chain(below) {
            let factor = row[column].clone();
            if !factor.is_zero() {
                row.iter_mut().zip(&*pivot).for_each(|(x, p)| *x -= &factor * p);
            }
        }
    }
    Some(rows.into_iter().map(|row| row[size..].to_vec()).collect())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn solutions_solve_and_singular_matrices_have_none() {
        let m = |rows: &[&[i64]]| -> Matrix {
            rows.iter()
                .map(|r| r.iter().map(|&x| Rational::from_integer(x.into())).collect())
                .collect()
        };
        let (a, b) = (m(&[&[0, 2, 1], &[3, 0, -1], &[1, 1, 1]]), m(&[&[1, 0], &[5, 2], &[-3, 7]]));
        let x = solution(&a, &b).unwrap();
        assert_eq!(product(&a, &x), b);
        assert_eq!(solution(&a, &unit(3)).map(|i| product(&i, &a)), Some(unit(3)));
        assert_eq!(solution(&m(&[&[1, 2], &[2, 4]]), &unit(2)), None);
        assert_eq!(solution(&a, &unit(2)), None);
        assert_eq!(transposed(&transposed(&b)), b);
        assert_eq!(before(&a[0], &b), applied(&transposed(&b), &a[0]));
    }
}
