//! Polynomials on [0, 1] in Bernstein form: their coefficients enclose them.

/// Coefficients of a motion within a step, of degree 4: a chain of four integrators.
pub(super) const MOTION: usize = 5;

/// Coefficients of the square of one.
pub(super) const SQUARE: usize = 2 * MOTION - 1;

/// Bisections before a zero is read off a straight line. Near a double zero, rounding errors hide the
/// sign over about 1e-8 of the step, so that more bisections would find noise.
const HALVINGS: u32 = 26;

/// Zeros closer to one another than this count as one.
const RESOLUTION: f64 = 1e-6;

/// Coefficients in Bernstein form. The first and the last are the values at 0 and 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bernstein<const N: usize>(pub(super) [f64; N]);

impl Bernstein<MOTION> {
    /// The straight line from `a` to `b`.
    pub(super) fn line(a: f64, b: f64) -> Self {
        let d = b - a;
        Self([a, a + d / 4.0, a + d / 2.0, a + d * 0.75, b])
    }

    /// The polynomial with these coefficients of 1, s, .., s^4.
    pub(super) fn from_powers([c0, c1, c2, c3, c4]: [f64; MOTION]) -> Self {
        Self([
            c0,
            c0 + c1 / 4.0,
            c0 + c1 / 2.0 + c2 / 6.0,
            c0 + 0.75 * c1 + c2 / 2.0 + c3 / 4.0,
            c0 + c1 + c2 + c3 + c4,
        ])
    }

    /// The same polynomial, except for the value at 1.
    pub(super) fn ending_at(mut self, end: f64) -> Self {
        self.0[MOTION - 1] = end;
        self
    }

    pub(super) fn squared(&self) -> Bernstein<SQUARE> {
        // Binomial coefficients of 4, and of 8.
        const MOTIONS: [f64; MOTION] = [1.0, 4.0, 6.0, 4.0, 1.0];
        const SQUARES: [f64; SQUARE] = [1.0, 8.0, 28.0, 56.0, 70.0, 56.0, 28.0, 8.0, 1.0];
        let mut square = [0.0; SQUARE];
        for (i, (a, of_a)) in self.0.iter().zip(MOTIONS).enumerate() {
            for ((b, of_b), k) in self.0.iter().zip(MOTIONS).zip(i..) {
                square[k] += of_a * of_b / SQUARES[k] * a * b;
            }
        }
        Bernstein(square)
    }
}

impl<const N: usize> Bernstein<N> {
    /// The constant polynomial.
    pub(super) fn constant(value: f64) -> Self {
        Self([value; N])
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut sum = *self;
        for (a, b) in sum.0.iter_mut().zip(other.0) {
            *a += b;
        }
        sum
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        let mut difference = *self;
        for (a, b) in difference.0.iter_mut().zip(other.0) {
            *a -= b;
        }
        difference
    }

    /// A lower bound on [0, 1].
    pub(super) fn least(&self) -> f64 {
        self.0.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// An upper bound on [0, 1].
    pub(super) fn greatest(&self) -> f64 {
        self.0.iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// The value at `s` in [0, 1].
    pub(super) fn at(&self, s: f64) -> f64 {
        self.split(s).0.0[N - 1]
    }

    /// The polynomial on [0, s] and on [s, 1] (de Casteljau).
    fn split(&self, s: f64) -> (Self, Self) {
        let mut row = self.0;
        let (mut left, mut right) = ([0.0; N], [0.0; N]);
        for k in 0..N {
            left[k] = row[0];
            right[N - 1 - k] = row[N - 1 - k];
            for i in 0..N - 1 - k {
                row[i] += s * (row[i + 1] - row[i]);
            }
        }
        (Self(left), Self(right))
    }

    /// The zeros in (0, 1], ascending; a double one counts once. None where the polynomial is zero
    /// everywhere: two drones that move together do not meet again.
    pub(super) fn zeros(&self) -> Vec<f64> {
        let mut zeros = Vec::new();
        self.collect_zeros(0.0, 1.0, HALVINGS, &mut zeros);
        // A double zero is found from both sides and, because of rounding, as a cluster.
        let mut last = f64::NEG_INFINITY;
        zeros.retain(|&s| {
            let anew = s - last > RESOLUTION;
            last = s;
            anew
        });
        zeros
    }

    fn collect_zeros(&self, from: f64, to: f64, halvings: u32, zeros: &mut Vec<f64>) {
        let [first, inner @ .., last] = self.0.as_slice() else { return };
        let (first, last) = (*first, *last);
        if inner.iter().all(|c| *c == 0.0) && first == 0.0 && last == 0.0 {
            return;
        }
        // The beginning belongs to the previous piece.
        let rest = || inner.iter().copied().chain([last]);
        let one_sign = rest().all(|c| c > 0.0) || rest().all(|c| c < 0.0);
        if one_sign && (first == 0.0 || (first > 0.0) == (last > 0.0)) {
            return;
        }
        if halvings == 0 {
            let crossing = first / (first - last);
            let inside = (0.0..=1.0).contains(&crossing);
            zeros.push(if inside { from + (to - from) * crossing } else { to });
            return;
        }
        let same = || std::iter::once(first).chain(inner.iter().copied());
        if last == 0.0 && (same().all(|c| c > 0.0) || same().all(|c| c < 0.0)) {
            zeros.push(to);
            return;
        }
        let middle = (from + to) / 2.0;
        let (left, right) = self.split(0.5);
        left.collect_zeros(from, middle, halvings - 1, zeros);
        right.collect_zeros(middle, to, halvings - 1, zeros);
    }
}

#[cfg(test)]
mod tests {
    use super::Bernstein;

    #[test]
    fn zeros_are_found_and_only_those() {
        let zeros = |powers: [f64; 5]| Bernstein::from_powers(powers).zeros();
        let near = |found: Vec<f64>, expected: &[f64]| {
            assert_eq!(found.len(), expected.len(), "{found:?}, expected {expected:?}");
            for (a, b) in found.iter().zip(expected) {
                assert!((a - b).abs() < 1e-7, "{found:?}, expected {expected:?}");
            }
        };
        // (s - 1/4)(s - 1/2)(s - 3/4)(s - 2)
        near(
            zeros([3.0 / 16.0, -47.0 / 32.0, 59.0 / 16.0, -3.5, 1.0]).to_vec(),
            &[0.25, 0.5, 0.75],
        );
        // A touch: (s - 1/2)^2; nearly one: (s - 1/2)^2 + 1/1000.
        near(zeros([0.25, -1.0, 1.0, 0.0, 0.0]), &[0.5]);
        near(zeros([0.251, -1.0, 1.0, 0.0, 0.0]), &[]);
        // The beginning does not count, the end does.
        near(zeros([0.0, 1.0, 0.0, 0.0, 0.0]), &[]);
        near(zeros([1.0, -1.0, 0.0, 0.0, 0.0]), &[1.0]);
        near(zeros([0.0, -1.0, 1.0, 0.0, 0.0]), &[1.0]);
        near(zeros([0.0; 5]), &[]);
    }

    #[test]
    fn values_and_bounds_agree_with_the_powers() {
        let c = [1.0, -3.0, 2.5, 0.5, -1.0];
        let p = Bernstein::from_powers(c);
        for k in 0..=10 {
            let s = f64::from(k) / 10.0;
            let value = c.iter().rev().fold(0.0, |sum, c| sum * s + c);
            assert!((p.at(s) - value).abs() < 1e-12);
            assert!(p.least() <= value + 1e-12 && value <= p.greatest() + 1e-12);
        }
    }
}
