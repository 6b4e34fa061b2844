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

/// Whether Cholesky's method goes through on `a - margin * 1`.
pub fn is_definite(a: &Matrix, margin: f64) -> bool {
    let n = a.len();
    let mut l = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| l[i][k] * l[j][k]).sum();
            if i == j {
                let pivot = a[i][i] - margin - sum;
                if pivot.is_nan() || pivot <= 0.0 {
                    return false;
                }
                l[i][i] = pivot.sqrt();
            } else {
                l[i][j] = (a[i][j] - sum) / l[j][j];
            }
        }
    }
    true
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
