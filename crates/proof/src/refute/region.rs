//! Start sets on the segment \[0, 1\], given by extreme points and directions.

use cordon_spec::theorems::StartSet;
use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::start_sets::{Coefficient, Generator, generators};
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::linear::simplest::strictly_between;

/// The convex set of starts spanned by points and directions: all mixtures of the points plus
/// nonnegative multiples of the directions. Where `open`, all weights are positive.
///
/// The variables are the positions of the internal drones, drone i being variable i-1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Region {
    /// Number of drones, at least 3.
    pub count: usize,
    /// Its extreme points, as positions of the internal drones.
    pub points: Vec<Vec<Rational>>,
    /// Its extreme directions, where it is unbounded.
    pub directions: Vec<Vec<Rational>>,
    /// Whether the boundary is excluded.
    pub open: bool,
}

impl Region {
    /// The region of a start set: its generators with a segment, scaled to \[0, 1\], are the
    /// points, those without one the directions.
    pub fn of(starts: StartSet, count: usize) -> Self {
        let (mut points, mut units) = (Vec::new(), Vec::new());
        for Generator { placement, coefficient } in generators(starts, count) {
            let length = placement.last().cloned().unwrap_or_default();
            let scale = if length.is_zero() { BigInt::one() } else { length.clone() };
            let internal = placement.into_iter().skip(1).take(count.saturating_sub(2));
            let scaled = internal.map(|x| Rational::new(x, scale.clone())).collect::<Vec<_>>();
            if length.is_zero() { units.push((scaled, coefficient)) } else { points.push(scaled) }
        }
        // The first is the one farthest to the right.
        points.sort_by(|a, b| b.cmp(a));
        let along = |(unit, coefficient): (Vec<Rational>, Coefficient)| match coefficient {
            Coefficient::Free => vec![unit.clone(), unit.iter().map(|x| -x).collect()],
            // Long enough to move a drone from its target to the left end of the segment.
            _ => vec![
                unit.iter()
                    .zip(points.first().into_iter().flatten())
                    .map(|(x, target)| x * target)
                    .collect(),
            ],
        };
        let directions: Vec<_> = units.into_iter().flat_map(along).collect();
        Self { count, open: directions.is_empty(), points, directions }
    }

    /// The positions of all drones as forms in the variables.
    pub fn placement(&self) -> Vec<Affine> {
        let internal = (0..self.count.saturating_sub(2)).map(Affine::variable);
        let ends = [Rational::zero(), Rational::one()].map(Affine::constant);
        let [first, last] = ends;
        std::iter::once(first).chain(internal).chain([last]).collect()
    }

    /// The start with the end drones at the ends of the segment.
    pub fn start(&self, x: &[Rational]) -> Vec<Rational> {
        let ends = [Rational::zero(), Rational::one()];
        let [first, last] = ends;
        std::iter::once(first).chain(x.iter().cloned()).chain([last]).collect()
    }

    /// A point that meets the constraint, near an extreme one; `None` where there is none: this is
    /// complete.
    ///
    /// An affine form attains its extreme values at extreme points or along extreme directions.
    pub fn point_with(&self, wanted: &Constraint) -> Option<Vec<Rational>> {
        let middle = self.middle();
        match wanted.sign {
            Sign::Positive | Sign::NonNegative => {
                let candidates = self.points.iter().cloned().chain(self.far_points(&middle));
                candidates
                    .filter_map(|extreme| self.towards(wanted, &middle, extreme))
                    .min_by_key(|x| size(x))
            }
            Sign::Zero => {
                let at = |x: &[Rational]| wanted.form.at(x);
                if at(&middle)?.is_zero() {
                    return Some(middle);
                }
                let sign = at(&middle)?;
                let mut candidates: Vec<_> = self.points.clone();
                candidates.extend(self.crossings(&wanted.form, &middle));
                candidates.into_iter().find_map(|extreme| {
                    let there = at(&extreme)?;
                    // The zero lies between the middle and the extreme, or at it.
                    if there.is_zero() {
                        return (!self.open).then_some(extreme);
                    }
                    ((&there * &sign) < Rational::zero()).then(|| {
                        let t = &sign / (&sign - &there);
                        mixed(&middle, &extreme, &t)
                    })
                })
            }
        }
    }

    /// A point in the interior: the mean of the points, plus one unit along every direction.
    pub fn middle(&self) -> Vec<Rational> {
        let number = Rational::from_integer(self.points.len().into());
        let mut mean = vec![Rational::zero(); self.count.saturating_sub(2)];
        for p in &self.points {
            for (m, x) in mean.iter_mut().zip(p) {
                *m += x / &number;
            }
        }
        for d in &self.directions {
            for (m, x) in mean.iter_mut().zip(d) {
                *m += x;
            }
        }
        mean
    }

    /// One unit along every direction, from every point (the set is closed if there are any).
    fn far_points(&self, middle: &[Rational]) -> impl Iterator<Item = Vec<Rational>> {
        let from = if self.open { vec![middle.to_vec()] } else { self.points.clone() };
        let directions = self.directions.clone();
        from.into_iter().flat_map(move |p| {
            directions.clone().into_iter().map(move |d| sum(&p, &d, &Rational::one()))
        })
    }

    /// Points along directions, far enough for the form to have changed its sign if it ever does.
    fn crossings(&self, form: &Affine, middle: &[Rational]) -> Vec<Vec<Rational>> {
        let mut found = Vec::new();
        for d in &self.directions {
            let (Some(here), Some(there)) =
                (form.at(middle), form.at(&sum(middle, d, &Rational::one())))
            else {
                continue;
            };
            let slope = &there - &here;
            if (&slope * &here) < Rational::zero() {
                let enough = -(&here / &slope) + Rational::one();
                found.push(sum(middle, d, &enough));
            }
        }
        found
    }

    /// The simplest mixture of the middle and an extreme point that meets a positivity constraint; in a
    /// closed set the extreme point itself if it does. Extreme directions are followed as far as
    /// necessary.
    fn towards(
        &self,
        wanted: &Constraint,
        middle: &[Rational],
        extreme: Vec<Rational>,
    ) -> Option<Vec<Rational>> {
        let there = wanted.form.at(&extreme)?;
        if !self.open {
            if wanted.sign.met_by(&there) {
                return Some(extreme);
            }
            return self.along(wanted, &extreme);
        }
        let here = wanted.form.at(middle)?;
        if wanted.sign.met_by(&here) {
            return Some(middle.to_vec());
        }
        if there <= Rational::zero() {
            return None;
        }
        // (1-t) here + t there > 0.
        let from = -&here / (&there - &here);
        let t = strictly_between(&from, &Rational::one())?;
        Some(mixed(middle, &extreme, &t))
    }

    /// A point far enough from `base` along the first direction in which the form grows.
    fn along(&self, wanted: &Constraint, base: &[Rational]) -> Option<Vec<Rational>> {
        let here = wanted.form.at(base)?;
        self.directions.iter().find_map(|d| {
            let slope = wanted.form.at(&sum(base, d, &Rational::one()))? - &here;
            (slope > Rational::zero()).then(|| {
                let enough = (-&here / &slope).floor() + Rational::one();
                sum(base, d, &enough.max(Rational::one()))
            })
        })
    }
}

/// a + t d.
fn sum(a: &[Rational], d: &[Rational], t: &Rational) -> Vec<Rational> {
    a.iter().zip(d).map(|(x, y)| x + y * t).collect()
}

/// (1-t) a + t b.
fn mixed(a: &[Rational], b: &[Rational], t: &Rational) -> Vec<Rational> {
    a.iter().zip(b).map(|(x, y)| x + (y - x) * t).collect()
}

/// The total length of the numbers in writing: the measure of simplicity.
fn size(x: &[Rational]) -> u64 {
    x.iter().map(|x| x.numer().bits() + x.denom().bits()).sum()
}
