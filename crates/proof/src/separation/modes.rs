//! The modes of a linear system, in doubles: used for suggestions only.
//!
//! Only the four operations and square roots are used, which give the same results on every machine.

use cordon_core::exact::to_f64;
use cordon_core::linear::matrix::{Matrix, before, product};
use cordon_core::{Rational, linear::matrix};
use num_complex::Complex;
use num_traits::{One, Zero};

type Double = Complex<f64>;

/// A mode: a real eigenvalue, or a conjugate pair given by its member above the real axis.
#[derive(Clone, Debug)]
pub(super) struct Mode {
    /// The eigenvalue, by which a step multiplies the mode.
    pub(super) factor: Double,
    /// The component of the first readout in this mode: a left eigenvector.
    pub(super) row: Vec<Double>,
    /// The components of all readouts, in multiples of the first one's.
    pub(super) shares: Vec<Double>,
}

/// Most iterations for the eigenvalues.
const ITERATIONS: usize = 400;

/// The modes, the slowest first. `None` where doubles cannot separate them.
pub(super) fn modes(matrix: &Matrix, readouts: &Matrix) -> Option<Vec<Mode>> {
    // Eigenvalues are near 1 where steps are short: compute their difference from 1 instead.
    let unit = matrix::unit(matrix.len());
    let beyond: Matrix = matrix
        .iter()
        .zip(&unit)
        .map(|(row, one)| row.iter().zip(one).map(|(a, b)| a - b).collect())
        .collect();
    let polynomial = characteristic(&beyond);
    let roots = roots(&polynomial.iter().map(to_f64).collect::<Vec<_>>())?;
    let upper = roots.into_iter().filter(|root| root.im >= 0.0);
    let mut found = upper
        .map(|root| mode(&beyond, &polynomial, readouts, root))
        .collect::<Option<Vec<Mode>>>()?;
    found.sort_by(|a, b| b.factor.norm_sqr().total_cmp(&a.factor.norm_sqr()));
    Some(found)
}

/// The characteristic polynomial, constant term first (Faddeev and LeVerrier).
fn characteristic(matrix: &Matrix) -> Vec<Rational> {
    let size = matrix.len();
    let mut coefficients = vec![Rational::one()];
    let mut power = matrix::unit(size);
    for k in 1..=size {
        let next = product(matrix, &power);
        let trace: Rational = next.iter().enumerate().map(|(i, row)| &row[i]).sum();
        let coefficient = -trace / Rational::from_integer(k.into());
        power = next;
        power.iter_mut().enumerate().for_each(|(i, row)| row[i] += &coefficient);
        coefficients.push(coefficient);
    }
    coefficients.reverse();
    coefficients
}

/// The roots of a monic polynomial with distinct roots; real roots are exactly real (Weierstrass,
/// Durand and Kerner).
fn roots(polynomial: &[f64]) -> Option<Vec<Double>> {
    let degree = polynomial.len() - 1;
    let at = |z: Double| polynomial.iter().rev().fold(Double::zero(), |sum, c| sum * z + c);
    let radius = 1.0 + polynomial.iter().take(degree).fold(0.0_f64, |m, c| m.max(c.abs()));
    let turn = Double::new(0.4, 0.9);
    let mut z: Vec<Double> = Vec::with_capacity(degree);
    for k in 0..degree {
        let last = z.last().copied().unwrap_or(Double::new(radius.min(1.0), 0.0));
        z.push(if k == 0 { last } else { last * turn });
    }
    for _ in 0..ITERATIONS {
        for i in 0..degree {
            let others = (0..degree).filter(|j| *j != i);
            let spread = others.fold(Double::one(), |p, j| p * (z[i] - z[j]));
            let step = at(z[i]) / spread;
            if step.re.is_finite() && step.im.is_finite() {
                z[i] -= step;
            }
        }
    }
    let size = |x: Double| x.norm_sqr().sqrt();
    if z.iter().any(|x| !x.re.is_finite() || size(at(*x)) > 1e-9) {
        return None;
    }
    for x in &mut z {
        if x.im.abs() <= 1e-9 * size(*x) {
            x.im = 0.0;
        }
    }
    Some(z)
}

/// The mode of one root: the readout times the matrix polynomial with that root divided out. Sums that
/// nearly cancel are computed exactly.
fn mode(beyond: &Matrix, polynomial: &[Rational], readouts: &Matrix, root: Double) -> Option<Mode> {
    let exact = Complex::new(Rational::from_float(root.re)?, Rational::from_float(root.im)?);
    let real = |x: &Rational| Complex::new(x.clone(), Rational::zero());
    // Synthetic division, and the quotient at the root.
    let mut quotient: Vec<Complex<Rational>> = Vec::new();
    for c in polynomial.iter().skip(1).rev() {
        let carried = quotient.last().map_or_else(Complex::zero, |q| q * &exact);
        quotient.push(carried + real(c));
    }
    let scale = quotient.iter().fold(Complex::<Rational>::zero(), |sum, q| sum * &exact + q);
    if scale.is_zero() {
        return None;
    }
    let part = |readout: &Vec<Rational>| -> Vec<Double> {
        let mut row = vec![Complex::<Rational>::zero(); readout.len()];
        for q in &quotient {
            let parts = |f: fn(&Complex<Rational>) -> Rational| -> Vec<Rational> {
                before(&row.iter().map(f).collect::<Vec<_>>(), beyond)
            };
            let (re, im) = (parts(|x| x.re.clone()), parts(|x| x.im.clone()));
            let carried = re.into_iter().zip(im).map(|(re, im)| Complex::new(re, im));
            row = carried.zip(readout).map(|(x, r)| x + q * real(r)).collect();
        }
        let double = |x: &Complex<Rational>| Double::new(to_f64(&x.re), to_f64(&x.im));
        row.iter().map(|x| double(&(x / &scale))).collect()
    };
    let row = part(readouts.first()?);
    let length: f64 = row.iter().map(Double::norm_sqr).sum();
    let share = |readout| -> Double {
        let pairs = part(readout).into_iter().zip(&row);
        pairs.map(|(x, y)| x * y.conj()).sum::<Double>() / length
    };
    let shares: Vec<Double> = readouts.iter().map(share).collect();
    let finite = shares.iter().all(|s| s.re.is_finite() && s.im.is_finite());
    finite.then_some(Mode { factor: root + 1.0, row, shares })
}
