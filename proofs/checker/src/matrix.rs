//! Exact matrices, and the definiteness of quadratic forms.

use crate::fault::{Result, ensure};
use crate::number::{Number, exhausted};

/// A matrix by its rows.
pub type Matrix = Vec<Vec<Number>>;

/// The symmetric matrix with that lower triangle.
///
/// # Errors
/// The rows do not have 1, 2, ..., `size` numbers.
pub fn symmetric(rule: &'static str, triangle: &[Vec<Number>], size: usize) -> Result<Matrix> {
    let fits = triangle.iter().map(Vec::len).eq(1..=size);
    ensure!(fits, rule, "a lower triangle of {size} rows is expected");
    let entry = |i: usize, j: usize| triangle[i.max(j)][i.min(j)].clone();
    Ok((0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect())
}

/// The product of two matrices; zeros cost nothing.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let row = |row: &Vec<Number>| {
        let mut sum = vec![Number::whole(0); b.first().map_or(0, Vec::len)];
        for (x, line) in row.iter().zip(b).filter(|(x, _)| !x.is_zero()) {
            for (sum, y) in sum.iter_mut().zip(line).filter(|(_, y)| !y.is_zero()) {
                *sum = sum.clone() + &(x.clone() * y);
            }
        }
        sum
    };
    a.iter().map(row).collect()
}

/// a'pa.
pub fn congruent(a: &Matrix, p: &Matrix) -> Matrix {
    let column = |k: usize| a.iter().map(|row| row[k].clone()).collect();
    let transposed: Matrix = (0..a.first().map_or(0, Vec::len)).map(column).collect();
    product(&product(&transposed, p), a)
}

/// The product of two vectors.
pub fn dot(a: &[Number], b: &[Number]) -> Number {
    a.iter().zip(b).fold(Number::whole(0), |sum, (x, y)| sum + &(x.clone() * y))
}

/// The matrix with one more row and column: m, then column and corner.
pub fn bordered(mut m: Matrix, mut column: Vec<Number>, corner: Number) -> Matrix {
    for (row, x) in m.iter_mut().zip(&column) {
        row.push(x.clone());
    }
    column.push(corner);
    m.push(column);
    m
}

/// c a - b.
pub fn difference(c: &Number, a: &Matrix, b: &Matrix) -> Matrix {
    let entry = |(x, y): (&Number, &Number)| c.clone() * x - y;
    a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(entry).collect()).collect()
}

/// Whether x'mx >= 0 for every x (> 0 but for x = 0), m being symmetric: by elimination.
pub fn definite(mut m: Matrix, strictly: bool) -> bool {
    for k in 0..m.len() {
        let pivot = m[k][k].clone();
        if exhausted() || pivot < Number::whole(0) || (strictly && pivot.is_zero()) {
            return false;
        }
        let column: Vec<Number> = m.iter().map(|row| row[k].clone()).collect();
        for (i, row) in m.iter_mut().enumerate().skip(k + 1).filter(|(_, row)| !row[k].is_zero()) {
            // An entry beside a zero on the diagonal: a form of both signs.
            let Some(factor) = row[k].clone().over(&pivot) else { return false };
            for (x, y) in row[k + 1..=i].iter_mut().zip(&column[k + 1..]) {
                *x = x.clone() - &(factor.clone() * y);
            }
        }
    }
    true
}
