//! Convergence by quadratic forms: what has to vanish, and what a step makes of it.
//!
//! P > 0 with rate^2 P - A'PA >= 0 shows it, A'PA - P >= 0 with y'Py > 0 refutes it. P is found in
//! doubles, rounded, and checked exactly by the independent checker.

mod contraction;
mod growth;
mod unfixed;

pub use contraction::{Contraction, contraction};
pub use growth::{Growth, grows};
pub use unfixed::{Unfixed, unfixed};

use super::certificate::linear_system;
use super::doubles::{Matrix, product, spectral_radius};
use super::readouts::{self, QuotientRows, Readouts};
use crate::certificate::linear::Quadratic;
use cordon_core::Rational;
use cordon_core::exact::{fraction, to_f64};
use cordon_core::system::expression::sum_text;
use cordon_core::system::{Parameter, System};

/// Most readouts: the checker multiplies matrices of that size exactly.
const MOST_READOUTS: usize = 64;

/// Most maps, one a mode and corner.
const MOST_MAPS: usize = 256;

/// Why no form is searched, where a system has too much that has to vanish.
pub fn beyond(system: &System) -> Option<String> {
    let count = Readouts::of(system)?.all.len();
    let many = format!("{count} differences have to vanish: expected at most {MOST_READOUTS}");
    (count > MOST_READOUTS).then_some(many)
}

/// The step on readouts.
struct Quotient {
    readouts: Readouts,
    /// Of each mode.
    rows: Vec<QuotientRows>,
    /// At each corner of each mode, with the mode.
    maps: Vec<(usize, Vec<Vec<Rational>>)>,
}

impl Quotient {
    fn of(system: &System) -> Option<Self> {
        let readouts = Readouts::of(system)?;
        if readouts.all.is_empty() || readouts.all.len() > MOST_READOUTS {
            return None;
        }
        let rows = system.modes.iter().map(|m| readouts.quotient(m));
        let rows = rows.collect::<Option<Vec<_>>>()?;
        let mut maps = Vec::new();
        for (mode, rows) in rows.iter().enumerate() {
            let mut corners = vec![system.values(|p| p.low.clone())];
            for p in readouts::parameters_in(rows) {
                let ends = system.parameters.get(p).map(Parameter::ends)?;
                corners = corners
                    .iter()
                    .flat_map(|c| {
                        ends.iter().map(move |end| {
                            let mut corner = c.clone();
                            if let Some(slot) = corner.get_mut(p) {
                                *slot = end.clone();
                            }
                            corner
                        })
                    })
                    .collect();
                if corners.len() > MOST_MAPS {
                    return None;
                }
            }
            maps.extend(corners.iter().map(|values| (mode, readouts::at(rows, values))));
        }
        (maps.len() <= MOST_MAPS).then_some(Self { readouts, rows, maps })
    }

    fn doubles(&self) -> Vec<(usize, Matrix)> {
        let double = |(mode, m): &(usize, Vec<Vec<Rational>>)| {
            (*mode, m.iter().map(|row| row.iter().map(to_f64).collect()).collect())
        };
        self.maps.iter().map(double).collect()
    }

    /// The certificate's fields that do not depend on the form.
    fn certificate(&self, system: &System) -> Option<Quadratic> {
        let names: Vec<String> = (0..self.readouts.all.len()).map(|j| format!("y{j}")).collect();
        let parameter = |v: u32| system.parameters.get(v as usize).map_or("?", |p| p.name.as_str());
        let text = |row: &std::collections::BTreeMap<usize, cordon_core::scalar::Polynomial>| {
            let terms = row.iter().flat_map(|(j, a)| {
                let name = names.get(*j).map(String::as_str);
                a.terms().map(move |(m, c)| {
                    (c, m.powers().map(|(v, _)| parameter(v)).chain(name).collect::<Vec<_>>())
                })
            });
            sum_text(terms)
        };
        let maps = system.modes.iter().zip(&self.rows);
        Some(Quadratic {
            system: linear_system(system),
            readouts: self.readouts.texts(system)?,
            maps: maps.map(|(m, rows)| (m.name.clone(), rows.iter().map(text).collect())).collect(),
            ..Quadratic::default()
        })
    }
}
/// The rows as the certificate has them.
fn texts(lower: &[Vec<Rational>]) -> Vec<Vec<String>> {
    lower.iter().map(|r| r.iter().map(fraction).collect()).collect()
}

/// The symmetric matrix with this lower triangle.
fn full(lower: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
    let at = |i: usize, j: usize| lower[i.max(j)][i.min(j)].clone();
    (0..lower.len()).map(|i| (0..lower.len()).map(|j| at(i, j)).collect()).collect()
}

/// Whether these steps, the first first, repeated for ever, may not let everything vanish, as far as
/// doubles tell: the estimate of a radius of 1 may be a little less.
pub(super) fn grows_or_stays(word: &[&Matrix]) -> bool {
    let whole = word.iter().map(|a| (*a).clone()).reduce(|done, a| product(&a, &done));
    whole.is_some_and(|a| spectral_radius(&a) > 0.999)
}
