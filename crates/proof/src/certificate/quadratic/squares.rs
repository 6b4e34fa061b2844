//! Positive semidefinite forms as sums of squares, exactly.
//!
//! A diagonally dominant form is one of pairs, |m_ij| (z_i +- z_j)^2. Another is split by elimination; where its numbers
//! would get long, its Cholesky factor is rounded, and what is left over by that is dominant.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

use cordon_core::Rational;
use cordon_core::exact::to_f64;
use cordon_core::linear::matrix::Matrix;

/// A factor above 0, and a combination with integer coefficients, none 0, by the places of its variables.
pub type Square = (Rational, Vec<(usize, BigInt)>);

/// Rows of a form that is eliminated without rounding first.
const FEW: usize = 8;

/// Longest numbers of an elimination, in bits.
const LONGEST: u64 = 3_000;

/// The squares whose sum z'mz is, m being symmetric; `None` where none are found.
pub fn squares(m: &Matrix) -> Option<Vec<Square>> {
    dominant(m)
        .or_else(|| if m.len() <= FEW { eliminated(m) } else { None })
        .or_else(|| rounded(m))
        .or_else(|| eliminated(m))
}

/// Of a form whose diagonal is at least the sum of what stands beside it, in every row.
fn dominant(m: &Matrix) -> Option<Vec<Square>> {
    let mut all = Vec::new();
    for (i, row) in m.iter().enumerate() {
        let beside = row.iter().enumerate().filter(|(j, _)| *j != i);
        let rest = beside.fold(row.get(i)?.clone(), |rest, (_, x)| rest - x.abs());
        if rest.is_negative() {
            return None;
        }
        all.push((rest, vec![(i, BigInt::one())]));
        let pair = |(j, x): (usize, &Rational)| {
            (x.abs(), vec![(i, BigInt::one()), (j, x.numer().signum())])
        };
        all.extend(row.iter().enumerate().skip(i + 1).map(pair));
    }
    all.retain(|(factor, _)| !factor.is_zero());
    Some(all)
}

/// By elimination (LDL').
fn eliminated(m: &Matrix) -> Option<Vec<Square>> {
    let (mut m, mut all) = (m.clone(), Vec::new());
    for k in 0..m.len() {
        let (done, rest) = m.split_at_mut(k + 1);
        let row = done.last()?.get(k..)?;
        let pivot = row.first()?;
        if pivot.is_zero() && row.iter().all(Zero::is_zero) {
            continue;
        }
        if !pivot.is_positive() || pivot.numer().bits() + pivot.denom().bits() > LONGEST {
            return None;
        }
        for (below, factor) in rest.iter_mut().zip(row.iter().skip(1)) {
            if !factor.is_zero() {
                let factor = factor / pivot;
                let entries = below.get_mut(k..)?.iter_mut().zip(row);
                entries.filter(|(_, y)| !y.is_zero()).for_each(|(x, y)| *x -= &factor * y);
            }
        }
        // The least multiple of the row that is in integers.
        let scale = row.iter().fold(BigInt::one(), |d, x| d.lcm(x.denom()));
        let whole: Vec<BigInt> = row.iter().map(|x| x.numer() * (&scale / x.denom())).collect();
        let common = whole.iter().fold(BigInt::zero(), |d, x| d.gcd(x));
        let unit = Rational::new(common.clone(), scale);
        let entries = whole.into_iter().enumerate().filter(|(_, x)| !x.is_zero());
        all.push((&unit * &unit / pivot, entries.map(|(j, x)| (k + j, x / &common)).collect()));
    }
    Some(all)
}

/// By a Cholesky factor of what is a little less on the diagonal, rounded to as few bits as are enough.
fn rounded(m: &Matrix) -> Option<Vec<Square>> {
    let doubles: Vec<Vec<f64>> = m.iter().map(|row| row.iter().map(to_f64).collect()).collect();
    let factor = (1..8).find_map(|j| factor(&doubles, 2f64.powi(3 - 6 * j)))?;
    let largest = factor.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    let top = largest.log2().ceil() as i32;
    (8..54).step_by(2).find_map(|bits| {
        let scale = 2f64.powi(bits - top);
        let whole = |x: &f64| (x * scale).round().to_i64();
        let whole: Vec<Vec<i64>> =
            factor.iter().map(|row| row.iter().map(whole).collect()).collect::<Option<_>>()?;
        let square = Rational::from_float(scale * scale)?;
        let left = |i: usize, j: usize| -> Rational {
            let products =
                whole.iter().take(i.min(j) + 1).map(|r| i128::from(r[i]) * i128::from(r[j]));
            &m[i][j] * &square - Rational::from_integer(products.sum::<i128>().into())
        };
        let left: Matrix =
            (0..m.len()).map(|i| (0..m.len()).map(|j| left(i, j)).collect()).collect();
        let rest = dominant(&left)?.into_iter().map(|(c, form)| (c / &square, form));
        let rows = whole.iter().map(|row| {
            let entries = row.iter().enumerate().filter(|(_, x)| **x != 0);
            (square.recip(), entries.map(|(j, x)| (j, BigInt::from(*x))).collect::<Vec<_>>())
        });
        Some(rows.filter(|(_, form)| !form.is_empty()).chain(rest).collect())
    })
}

/// The Cholesky factor r, upper triangular, r'r being m with that part less on the diagonal.
fn factor(m: &[Vec<f64>], less: f64) -> Option<Vec<Vec<f64>>> {
    let n = m.len();
    let mut factor: Vec<Vec<f64>> = Vec::new();
    for k in 0..n {
        let mut row: Vec<f64> = (0..n).map(|j| if j < k { 0.0 } else { m[k][j] }).collect();
        let least = 1e-13 * m[k][k];
        row[k] *= 1.0 - less;
        for done in &factor {
            let by = done[k];
            row.iter_mut().zip(done).skip(k).for_each(|(x, y)| *x -= by * y);
        }
        let pivot = row[k];
        if pivot <= least && row.iter().any(|x| *x != 0.0) {
            return None;
        }
        let root = pivot.sqrt();
        row.iter_mut().skip(k).filter(|x| **x != 0.0).for_each(|x| *x /= root);
        factor.push(row);
    }
    Some(factor)
}
