//! Exact matrices, and the definiteness of quadratic forms.

use crate::fault::{Result, ensure};
use crate::number::{Number, charge, exhausted};

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

/// A number above 0 that makes all of a matrix integers, and those: integers are cheaper than fractions.
fn integers(m: &Matrix) -> (Number, Matrix) {
    let entries = m.iter().flatten().filter(|x| !x.is_integer());
    let scale = entries.fold(Number::whole(1), |d, x| (&d * x).denominator() * &d);
    let whole = |row: &Vec<Number>| row.iter().map(|x| &scale * x).collect();
    (scale.clone(), m.iter().map(whole).collect())
}

/// The product with a symmetric matrix.
pub fn product(a: &Matrix, symmetric: &Matrix) -> Matrix {
    let ((over_a, a), (over_b, b)) = (integers(a), integers(symmetric));
    let scale = over_a * &over_b;
    let entry =
        |row: &Vec<Number>, line| dot(row, line).over(&scale).unwrap_or_else(|| Number::whole(0));
    a.iter().map(|row| b.iter().map(|line| entry(row, line)).collect()).collect()
}

/// The product of two vectors; zeros cost little.
pub fn dot(a: &[Number], b: &[Number]) -> Number {
    charge(a.len() as u64);
    let pairs = a.iter().zip(b).filter(|(x, y)| !x.is_zero() && !y.is_zero());
    pairs.fold(Number::whole(0), |sum, (x, y)| sum + &(x * y))
}

/// The lower triangle of a symmetric matrix with one more row.
pub fn bordered(mut m: Matrix, mut row: Vec<Number>, corner: Number) -> Matrix {
    row.push(corner);
    m.push(row);
    m
}

/// Whether x'mx >= 0 for every x (> 0 but for x = 0), m being symmetric (its lower triangle is enough): by elimination without
/// fractions (Bareiss), in which all entries stay minors of the integers that it begins with.
pub fn definite(m: &Matrix, strictly: bool) -> bool {
    let (_, mut m) = integers(m);
    let mut before = Number::whole(1);
    for k in 0..m.len() {
        let column: Vec<Number> = m[k..].iter().map(|row| row[k].clone()).collect();
        let (pivot, below) = (&column[0], &column[1..]);
        if exhausted() || *pivot < Number::whole(0) || (strictly && pivot.is_zero()) {
            return false;
        }
        if pivot.is_zero() {
            // An entry beside a zero on the diagonal: a form of both signs.
            if below.iter().any(|x| !x.is_zero()) {
                return false;
            }
            continue;
        }
        for (i, (row, factor)) in m[k + 1..].iter_mut().zip(below).enumerate() {
            for (x, y) in row[k + 1..].iter_mut().zip(&below[..=i]) {
                let taken = if y.is_zero() { y.clone() } else { factor * y };
                if !x.is_zero() || !taken.is_zero() {
                    *x = (pivot * x - &taken).divided(&before);
                }
            }
        }
        before = pivot.clone();
    }
    true
}
