//! The critical weight of ordering (theorem 7.2) and of the upper bound (theorem 7.3).
//!
//! Both say that a cone is preserved: positive gaps, nonnegative errors. One step of the spec, executed
//! with the weight as an indeterminate in the cone's coordinates, gives the matrix of the step with
//! entries that are polynomials in eps. Where all entries are nonnegative, one step preserves the cone,
//! and hence any number of steps; where one is negative, a start close to its ray leaves the cone at
//! step 1. The entries are affine in eps, so the weights of the first kind form an interval whose end
//! is read off exactly.

use std::ops::Range;

use cordon_spec::Scalar;
use cordon_spec::theorems::{Form, Theorem};
use num_bigint::BigInt;
use num_traits::{One, Pow, Signed, Zero};

use crate::counterexample::Counterexample;
use cordon_core::Rational;
use cordon_core::linear::rows::{Row, applied};
use cordon_core::linear::simplest::strictly_between;
use cordon_core::scalar::{Monomial, Polynomial};
use cordon_core::stencil::Stencil;

/// The cone to be preserved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cone {
    /// All gaps positive: theorem 7.2.
    PositiveGaps,
    /// All errors nonnegative: theorem 7.3.
    NonnegativeErrors,
}

impl Cone {
    /// The theorem that states that it is preserved.
    pub fn theorem(self) -> Theorem {
        match self {
            Self::PositiveGaps => Theorem::Ordering,
            Self::NonnegativeErrors => Theorem::UpperBound,
        }
    }

    /// The step in the cone's coordinates, and the coordinates along its rays.
    pub(super) fn rows<T: Scalar + PartialEq>(
        self,
        stencil: &Stencil<T>,
        count: usize,
    ) -> Option<(Vec<Row<T>>, Range<usize>)> {
        match self {
            Self::PositiveGaps => Some((stencil.gap_rows(count)?, 0..count - 1)),
            Self::NonnegativeErrors => Some((stencil.error_rows(count)?, 1..count - 1)),
        }
    }
}

/// An entry of the matrix of a step: the coefficient of ray `ray` in coordinate `row`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Index of the gap or error after the step.
    pub row: usize,
    /// Index of the gap or error before the step.
    pub ray: usize,
    /// The polynomial in eps, lowest coefficient first; two coefficients.
    pub coefficients: [Rational; 2],
}

impl Entry {
    fn at(&self, eps: &Rational) -> Rational {
        let [constant, slope] = &self.coefficients;
        constant + slope * eps
    }

    /// The weight at which the entry is zero, where it depends on the weight.
    fn root(&self) -> Option<Rational> {
        let [constant, slope] = &self.coefficients;
        (!slope.is_zero()).then(|| -constant / slope)
    }
}

/// The critical weight, with proofs of both sides.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Critical {
    /// The cone that is preserved up to the critical weight.
    pub cone: Cone,
    /// The number of drones.
    pub count: usize,
    /// The critical weight: the cone is preserved for every eps in \[0, critical\] and for none beyond.
    pub critical: Rational,
    /// The number of entries examined: all that are not identically zero.
    pub entries: usize,
    /// The entry that turns negative at the critical weight.
    pub witness: Entry,
    /// A run that violates the theorem at the weight critical + 10^-digits.
    pub above: Counterexample,
}

/// The critical weight of `cone` for `count` drones, with a violating run 10^-digits above it.
///
/// `None` where the step is not affine in eps, or the safe weights are not an interval \[0, c\]:
/// neither happens with the protocol as specified.
pub fn critical(cone: Cone, count: usize, digits: usize) -> Option<Critical> {
    let entries = entries(cone, count)?;
    let witness = entries
        .iter()
        .filter(|e| e.coefficients[1].is_negative())
        .min_by_key(|e| e.root())?
        .clone();
    let critical = witness.root()?;
    let ends = [Rational::zero(), critical.clone()];
    // An affine entry that is nonnegative at both ends of an interval is nonnegative in between.
    let kept = ends.iter().all(|eps| keeps(cone, count, &entries, eps));
    if !kept {
        return None;
    }
    let eps = &critical + Rational::new(BigInt::one(), BigInt::from(10).pow(digits));
    let start = leaving_start(cone, count, &eps, &witness)?;
    let above = Counterexample::replay(cone.theorem(), Form::Sharp, &eps, start, 1)?;
    Some(Critical { cone, count, critical, entries: entries.len(), witness, above })
}

/// Whether one step at this weight preserves the cone: no entry is negative and, for positive gaps, no
/// row is zero.
fn keeps(cone: Cone, count: usize, entries: &[Entry], eps: &Rational) -> bool {
    let nonnegative = entries.iter().all(|e| !e.at(eps).is_negative());
    let row_lives = |row| entries.iter().any(|e| e.row == row && e.at(eps).is_positive());
    nonnegative && (cone == Cone::NonnegativeErrors || (0..count - 1).all(row_lives))
}

/// The entries that are not identically zero, for the step with the weight as an indeterminate.
fn entries(cone: Cone, count: usize) -> Option<Vec<Entry>> {
    let (rows, rays) = cone.rows(&Stencil::executed(&Polynomial::variable(0)), count)?;
    let mut found = Vec::new();
    for (row, entries) in rows.iter().enumerate() {
        for (ray, entry) in entries.iter().filter(|(ray, _)| rays.contains(ray)) {
            found.push(Entry { row, ray: *ray, coefficients: affine(entry)? });
        }
    }
    found.sort_by_key(|e| (e.ray, e.row));
    Some(found)
}

/// The coefficients of a polynomial in eps of degree at most 1.
fn affine(p: &Polynomial) -> Option<[Rational; 2]> {
    if p.terms().any(|(m, _)| m.degree() > 1) {
        return None;
    }
    let slope = p.terms().find(|(m, _)| m.degree() == 1).map(|(_, c)| c.clone());
    Some([p.coefficient(&Monomial::default()), slope.unwrap_or_else(Rational::zero)])
}

/// A start in the cone, on the segment \[0, 1\], whose coordinate `witness.row` is negative after one
/// step: the ray itself where the cone is closed; for positive gaps the simplest mixture of the ray
/// with equal gaps that suffices.
fn leaving_start(
    cone: Cone,
    count: usize,
    eps: &Rational,
    witness: &Entry,
) -> Option<Vec<Rational>> {
    let index = |i: usize| Rational::from_integer(i.into());
    let last = index(count - 1);
    match cone {
        Cone::NonnegativeErrors => {
            let place = |i| if i == witness.ray { index(0) } else { index(i) / &last };
            Some((0..count).map(place).collect())
        }
        Cone::PositiveGaps => {
            let on_ray = witness.at(eps);
            let equal = vec![Rational::one() / &last; count - 1];
            let rows = Stencil::executed(eps).gap_rows(count)?;
            let in_middle = applied(&rows, &equal).get(witness.row)?.clone();
            // (1-t) * in_middle + t * on_ray < 0.
            let from = &in_middle / (&in_middle - &on_ray);
            let t = strictly_between(&from, &Rational::one())?;
            let share = (Rational::one() - &t) / &last;
            let mut position = Rational::zero();
            let mut start = vec![position.clone()];
            for j in 0..count - 1 {
                position += &share;
                if j == witness.ray {
                    position += &t;
                }
                start.push(position.clone());
            }
            Some(start)
        }
    }
}
