//! The error matrix of one step, and what is exactly decidable of it.

use cordon_spec::placement::contraction_weight;
use cordon_spec::theorems::{Form, WeightRange};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use cordon_core::Rational;
use cordon_core::linear::rows::Row;
use cordon_core::stencil::Stencil;

/// The matrix A of `e' = A e` on the internal drones, times the weight's denominator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ErrorMatrix {
    /// Entries, by rows.
    rows: Vec<Vec<BigInt>>,
    /// The denominator.
    den: BigInt,
    /// The weight.
    eps: Rational,
}

impl ErrorMatrix {
    /// Of `count >= 3` drones and the weight `eps`.
    pub fn of(eps: &Rational, count: usize) -> Self {
        let stencil = Stencil::of(eps);
        let dense = |row: &Row<BigInt>| {
            let mut entries = vec![BigInt::zero(); count];
            row.iter().for_each(|(j, a)| entries[*j].clone_from(a));
            entries[1..count - 1].to_vec()
        };
        // A step that moves the targets has no such matrix; nothing is concluded about it.
        let all = stencil.error_rows(count).unwrap_or_else(|| vec![Row::new(); count]);
        let rows = all[1..count - 1].iter().map(dense).collect();
        Self { rows, den: stencil.den, eps: eps.clone() }
    }

    /// Whether the squared errors fall in every step from all errors but 0: whether
    /// `den^2 I - (den A)^2` is positive definite, A being symmetric. Decided on the leading
    /// minors (Sylvester).
    pub fn contracts(&self) -> bool {
        let size = self.rows.len();
        let square = &self.den * &self.den;
        let difference = (0..size)
            .map(|i| {
                (0..size)
                    .map(|j| {
                        // Columns times columns: the transpose of A times A.
                        let product: BigInt = self.rows.iter().map(|r| &r[i] * &r[j]).sum();
                        if i == j { &square - product } else { -product }
                    })
                    .collect()
            })
            .collect();
        leading_minors(difference).is_some_and(|minors| minors.iter().all(Signed::is_positive))
    }

    /// Whether no errors but 0 become 0: whether det A is not 0.
    pub fn is_regular(&self) -> bool {
        let mut rows = self.rows.clone();
        let size = rows.len();
        let mut before = BigInt::one();
        for k in 0..size {
            let Some(pivot) = (k..size).find(|i| !rows[*i][k].is_zero()) else { return false };
            rows.swap(k, pivot);
            eliminate(&mut rows, k, &before);
            before = rows[k][k].clone();
        }
        true
    }

    /// Whether the rate of 7.8 holds from all errors: |A| w <= (1 - 8 eps/(N-1)^2) w, where it
    /// is claimed. Then |e_i'| <= sum |A_ij| |e_j| <= max_j(|e_j|/w_j) * (|A| w)_i.
    pub fn keeps_rate(&self, form: Form) -> bool {
        let (num, den) = (self.eps.numer(), self.eps.denom());
        let count = self.rows.len() + 2;
        let claimed = form == Form::Sharp
            && WeightRange::PositiveUpToHalf.contains(num, den, count).is_true();
        let square = BigInt::from((count - 1) * (count - 1));
        let kept: BigInt = &square * den - num * 8;
        let weight = |i: usize| BigInt::from(contraction_weight(count, i + 1));
        !claimed
            || self.rows.iter().enumerate().all(|(i, row)| {
                let bound: BigInt = row.iter().enumerate().map(|(j, a)| a.abs() * weight(j)).sum();
                &square * bound <= &kept * weight(i)
            })
    }

    /// Errors that one step does not make smaller in squares, where power iteration in
    /// integers finds some: candidates only, the spec decides about each.
    pub fn stubborn_errors(&self) -> Vec<Vec<BigInt>> {
        let count = self.rows.len() + 2;
        let alternating = |i: usize| {
            let w = BigInt::from(contraction_weight(count, i + 1));
            if i.is_multiple_of(2) { w } else { -w }
        };
        let mut e: Vec<BigInt> = (0..self.rows.len()).map(alternating).collect();
        let mut candidates = vec![e.clone()];
        for _ in 0..POWER_STEPS {
            let next: Vec<BigInt> =
                self.rows.iter().map(|r| r.iter().zip(&e).map(|(a, x)| a * x).sum()).collect();
            let largest = next.iter().map(Signed::abs).max().unwrap_or_default();
            if largest.is_zero() {
                break;
            }
            e = next.iter().map(|x| x * POWER_SCALE / &largest).collect();
            candidates.push(e.clone());
        }
        candidates.reverse();
        candidates
    }
}

/// Steps of power iteration, and the size to which each is scaled: they settle how close to
/// the critical weight a growing start is found.
const POWER_STEPS: usize = 60;
const POWER_SCALE: i32 = 10_000;

/// The leading minors of a square matrix by fraction-free elimination; `None` where one of
/// them is 0, from which on they cannot all be positive.
fn leading_minors(mut rows: Vec<Vec<BigInt>>) -> Option<Vec<BigInt>> {
    let mut minors = Vec::with_capacity(rows.len());
    let mut before = BigInt::one();
    for k in 0..rows.len() {
        let pivot = rows[k][k].clone();
        if pivot.is_zero() {
            return None;
        }
        eliminate(&mut rows, k, &before);
        before.clone_from(&pivot);
        minors.push(pivot);
    }
    Some(minors)
}

/// One step of Bareiss' elimination below row k: entries stay integers, being minors.
fn eliminate(rows: &mut [Vec<BigInt>], k: usize, before: &BigInt) {
    let size = rows.len();
    for i in k + 1..size {
        for j in k + 1..size {
            rows[i][j] = (&rows[i][j] * &rows[k][k] - &rows[i][k] * &rows[k][j]) / before;
        }
    }
}

#[cfg(test)]
mod tests {
    use cordon_spec::theorems::Truth;

    use super::*;

    fn rational(p: i64, q: i64) -> Rational {
        Rational::new(p.into(), q.into())
    }

    #[test]
    fn matrix_is_tridiagonal() {
        let a = ErrorMatrix::of(&rational(1, 5), 6);
        let row = |r: [i64; 4]| r.map(BigInt::from).to_vec();
        let wanted = [row([3, 1, 0, 0]), row([1, 3, 1, 0]), row([0, 1, 3, 1]), row([0, 0, 1, 3])];
        assert_eq!(a.rows, wanted);
    }

    #[test]
    fn contraction_is_the_critical_weight_of_the_spec() {
        let (mut inside, mut outside) = (0, 0);
        for count in 3..=9 {
            for q in 1..=24 {
                for p in -2..=q + 4 {
                    let range = WeightRange::BelowCritical;
                    let below = range.contains(&i128::from(p), &i128::from(q), count);
                    let contracts = ErrorMatrix::of(&rational(p, q), count).contracts();
                    assert_eq!(contracts, below == Truth::True, "N = {count}, eps = {p}/{q}");
                    if contracts { inside += 1 } else { outside += 1 }
                }
            }
        }
        assert_eq!((inside, outside), (1_217, 2_059));
    }

    #[test]
    fn singular_exactly_where_an_eigenvalue_is_zero() {
        // 1 - 2 eps (1 - cos(j pi/(N-1))) = 0 has these rational solutions in [0, 1].
        for (count, p, q) in [(3, 1, 2), (5, 1, 2), (4, 1, 3), (7, 1, 3), (4, 1, 1), (7, 1, 1)] {
            assert!(!ErrorMatrix::of(&rational(p, q), count).is_regular(), "{count} {p}/{q}");
        }
        for (count, p, q) in [(4, 1, 2), (6, 1, 2), (5, 1, 3), (5, 1, 1), (6, 2, 5), (3, 1, 1)] {
            assert!(ErrorMatrix::of(&rational(p, q), count).is_regular(), "{count} {p}/{q}");
        }
    }

    #[test]
    fn rate_is_kept_up_to_one_half() {
        let mut checked = 0;
        for count in 3..=12 {
            for q in 2..=12 {
                for p in 1..=q / 2 {
                    assert!(ErrorMatrix::of(&rational(p, q), count).keeps_rate(Form::Sharp));
                    checked += 1;
                }
            }
        }
        assert_eq!(checked, 360);
    }
}
