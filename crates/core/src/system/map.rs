//! Affine maps with rational coefficients, sparse.

use num_traits::Zero;

use crate::Rational;
use crate::linear::affine::Affine;

/// `x -> A x + b`: for every row the constant and the nonzero coefficients, by column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Map {
    /// Constant and coefficients of each row, columns ascending.
    pub rows: Vec<(Rational, Vec<(usize, Rational)>)>,
}

impl Map {
    /// The image of a point; columns beyond it count as 0.
    pub fn apply(&self, x: &[Rational]) -> Vec<Rational> {
        let entry = |(constant, row): &(Rational, Vec<(usize, Rational)>)| {
            let terms = row.iter().filter_map(|(j, a)| Some(a * x.get(*j)?));
            terms.fold(constant.clone(), |sum, term| sum + term)
        };
        self.rows.iter().map(entry).collect()
    }

    /// The form `x -> f(A x + b)` for an affine `f`: the value of `f` after the map. `None` where `f`
    /// is not affine.
    pub fn pulled_back(&self, f: &Affine) -> Option<Affine> {
        let (constant, coefficients) = f.parts()?;
        let mut constant = constant.clone();
        let mut sums = vec![Rational::zero(); self.rows.len()];
        for (c, (b, row)) in coefficients.iter().zip(&self.rows) {
            if c.is_zero() {
                continue;
            }
            constant += c * b;
            for (j, a) in row {
                *sums.get_mut(*j)? += c * a;
            }
        }
        Some(Affine::new(constant, sums))
    }
}
