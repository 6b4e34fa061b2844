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
    let n = a.len();
    let transposed: Matrix = (0..n).map(|j| a.iter().map(|row| row[j]).collect()).collect();
    product(&transposed, &product(p, a))
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

/// An estimate of the spectral radius: the norm of a high power, by repeated squaring.
pub fn spectral_radius(a: &Matrix) -> f64 {
    let (mut power, mut log, mut exponent) = (a.clone(), 0.0, 1.0);
    for _ in 0..12 {
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
