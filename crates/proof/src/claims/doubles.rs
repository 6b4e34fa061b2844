//! Small dense matrices in doubles: where quadratic forms are guessed. Nothing here is believed; what
//! is found is checked in rationals.

/// A square matrix, row by row.
pub type Matrix = Vec<Vec<f64>>;

/// The identity.
pub fn identity(n: usize) -> Matrix {
    (0..n).map(|i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect()).collect()
}

/// The product.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let width = b.first().map_or(0, Vec::len);
    a.iter()
        .map(|row| {
            let mut sum = vec![0.0; width];
            for (x, b) in row.iter().zip(b).filter(|(x, _)| **x != 0.0) {
                for (s, y) in sum.iter_mut().zip(b) {
                    *s += x * y;
                }
            }
            sum
        })
        .collect()
}

/// a' p a.
pub fn moved(a: &Matrix, p: &Matrix) -> Matrix {
    product(&transposed(a), &product(p, a))
}

/// The transpose.
pub fn transposed(a: &Matrix) -> Matrix {
    let width = a.first().map_or(0, Vec::len);
    (0..width).map(|j| a.iter().map(|row| row[j]).collect()).collect()
}

/// The sum of all a'^k a^k, by doubling: the solution p of p - a' p a = 1, where a's powers vanish.
pub fn images_of_unit(a: &Matrix) -> Matrix {
    let (mut form, mut power) = (identity(a.len()), a.clone());
    for _ in 0..40 {
        form = plus(&form, 1.0, &moved(&power, &form));
        power = product(&power, &power);
        if largest(&power) < 1e-12 {
            break;
        }
    }
    form
}

/// The inverse, by elimination; `None` where there is none, as far as doubles tell.
pub fn inverse(a: &Matrix) -> Option<Matrix> {
    let n = a.len();
    let mut rows: Vec<(Vec<f64>, Vec<f64>)> = a.iter().cloned().zip(identity(n)).collect();
    let least = 1e-13 * largest(a);
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| rows[i].0[k].abs().total_cmp(&rows[j].0[k].abs()))?;
        rows.swap(k, pivot);
        let (mut row, mut beside) = rows[k].clone();
        let pivot = row[k];
        if pivot.is_nan() || pivot.abs() <= least {
            return None;
        }
        row.iter_mut().chain(&mut beside).for_each(|x| *x /= pivot);
        for (i, (other, to)) in rows.iter_mut().enumerate() {
            if i == k {
                (*other, *to) = (row.clone(), beside.clone());
            } else if other[k] != 0.0 {
                let factor = other[k];
                other.iter_mut().zip(&row).for_each(|(x, p)| *x -= factor * p);
                to.iter_mut().zip(&beside).for_each(|(x, p)| *x -= factor * p);
            }
        }
    }
    Some(rows.into_iter().map(|(_, beside)| beside).collect())
}

/// `a + factor * b`.
pub fn plus(a: &Matrix, factor: f64, b: &Matrix) -> Matrix {
    let row =
        |(a, b): (&Vec<f64>, &Vec<f64>)| a.iter().zip(b).map(|(a, b)| a + factor * b).collect();
    a.iter().zip(b).map(row).collect()
}

/// The largest entry, in magnitude.
pub fn largest(a: &Matrix) -> f64 {
    a.iter().flatten().fold(0.0, |m, x| m.max(x.abs()))
}

/// A direction v in which `a - margin * 1`, symmetric, is not positive: of the first pivot of
/// Cholesky's method that is not. `None` where it is positive definite.
pub fn negative_direction(a: &Matrix, margin: f64) -> Option<Vec<f64>> {
    let n = a.len();
    let mut l = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..i {
            let sum: f64 = (0..j).map(|k| l[i][k] * l[j][k]).sum();
            l[i][j] = (a[i][j] - sum) / l[j][j];
        }
        let pivot = a[i][i] - margin - l[i].iter().map(|x| x * x).sum::<f64>();
        if pivot.is_nan() || pivot <= 0.0 {
            // The pivot is v'(a - margin * 1)v for the v whose last entry is 1 and whose image ends in zeros.
            let mut v = vec![0.0; n];
            v[i] = 1.0;
            for k in (0..i).rev() {
                let sum: f64 = (k + 1..=i).map(|q| l[q][k] * v[q]).sum();
                v[k] = -sum / l[k][k];
            }
            return Some(v);
        }
        l[i][i] = pivot.sqrt();
    }
    None
}

/// a v.
pub fn image(a: &Matrix, v: &[f64]) -> Vec<f64> {
    a.iter().map(|row| dot(row, v)).collect()
}

/// The sum of the products.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// An estimate of the spectral radius: the norm of a high power, by repeated squaring. Its logarithm is known to
/// about a thousandth.
pub fn spectral_radius(a: &Matrix) -> f64 {
    radius_of_power(a, 12)
}

/// As [`spectral_radius`], to about a billionth: near 1.
pub fn fine_spectral_radius(a: &Matrix) -> f64 {
    radius_of_power(a, 32)
}

fn radius_of_power(a: &Matrix, squarings: usize) -> f64 {
    let (mut power, mut log, mut exponent) = (a.clone(), 0.0, 1.0);
    for _ in 0..squarings {
        let norm = largest(&power);
        if norm == 0.0 {
            return 0.0;
        }
        for x in power.iter_mut().flatten() {
            *x /= norm;
        }
        log += norm.ln() / exponent;
        power = product(&power, &power);
        exponent *= 2.0;
    }
    (log + largest(&power).max(f64::MIN_POSITIVE).ln() / exponent).exp()
}
