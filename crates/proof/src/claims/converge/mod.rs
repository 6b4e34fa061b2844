//! Convergence by quadratic forms: what has to vanish, and what a step makes of it.
//!
//! P > 0 with rate^2 P - A'PA >= 0 shows it, A'PA - P >= 0 with y'Py > 0 refutes it. P is found in
//! doubles, rounded, and checked exactly by the independent checker.

mod contraction;
mod growth;
mod short;
mod split;
mod unfixed;

pub use contraction::{Contraction, contraction};
pub use growth::{Growth, grows};
pub use unfixed::{Unfixed, unfixed};

use std::collections::BTreeMap;

use serde_json::Value;

use super::certificate::linear_system;
use super::doubles::{Matrix, product, spectral_radius};
use super::readouts::{self, QuotientRows, Readouts};
use crate::certificate::quadratic::{Course, Quadratic};
use cordon_core::Rational;
use cordon_core::exact::to_f64;
use cordon_core::system::{Parameter, System};

/// Most readouts: as many as the checker takes.
const MOST_READOUTS: usize = 200;

/// Most maps, one a mode and corner, and most of them times the cube of their size.
const MOST_MAPS: usize = 256;
const MOST_ENTRIES: usize = 100_000_000;

/// Why nothing is shown: too much has to vanish, there are too many ends of ranges, or, in these words, nothing was
/// found.
pub fn open(system: &System, nothing: &str) -> String {
    let neither = nothing.to_owned();
    let Some(count) = Readouts::of(system).map(|readouts| readouts.all.len()) else {
        return neither;
    };
    let many = format!("{count} differences have to vanish");
    match Quotient::of(system) {
        _ if count > MOST_READOUTS => format!("{many}: expected at most {MOST_READOUTS}"),
        Err(Some(most)) => format!(
            "{many}, at more than {most} combinations of modes and ends of ranges: expected fewer"
        ),
        _ if count > MANY => format!(
            "{neither}, within the limits of the independent checker: {many}, and dense forms of more than {MANY} \
             are long"
        ),
        _ => neither,
    }
}

/// Readouts of which a dense form may be beyond the checker's limits.
const MANY: usize = 40;

/// Most maps of so many readouts.
fn most_maps(readouts: usize) -> usize {
    (MOST_ENTRIES / readouts.pow(3).max(1)).clamp(1, MOST_MAPS)
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
    /// The step on readouts; else how many maps there may be, where there are more.
    fn of(system: &System) -> std::result::Result<Self, Option<usize>> {
        let readouts = Readouts::of(system).ok_or(None)?;
        if readouts.all.is_empty() || readouts.all.len() > MOST_READOUTS {
            return Err(None);
        }
        let most = most_maps(readouts.all.len());
        let rows = system.modes.iter().map(|m| readouts.quotient(m));
        let rows = rows.collect::<Option<Vec<_>>>().ok_or(None)?;
        let mut maps = Vec::new();
        for (mode, rows) in rows.iter().enumerate() {
            let mut corners = vec![system.values(|p| p.low.clone())];
            for p in readouts::parameters_in(rows) {
                let ends = system.parameters.get(p).map(Parameter::ends).ok_or(None)?;
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
                if corners.len() > most {
                    return Err(Some(most));
                }
            }
            maps.extend(corners.iter().map(|values| (mode, readouts::at(rows, values))));
        }
        if maps.len() > most { Err(Some(most)) } else { Ok(Self { readouts, rows, maps }) }
    }

    fn doubles(&self) -> Vec<(usize, Matrix)> {
        let double = |(mode, m): &(usize, Vec<Vec<Rational>>)| {
            (*mode, m.iter().map(|row| row.iter().map(to_f64).collect()).collect())
        };
        self.maps.iter().map(double).collect()
    }

    /// The certificate that forms do so, one or one for each mode.
    fn certificate(&self, system: &System, forms: Vec<Form>, course: Course) -> Option<Value> {
        let names = system.modes.iter().map(|m| m.name.clone());
        let own = names.clone().zip(forms.iter().cloned()).collect::<BTreeMap<_, _>>();
        let several = forms.len() > 1;
        let quadratic = Quadratic {
            system: linear_system(system),
            readouts: self.readouts.forms(),
            maps: names.zip(self.rows.iter().cloned()).collect(),
            parameters: system.parameters.iter().map(|p| p.name.clone()).collect(),
            forms: if several { own.into_values().collect() } else { forms },
            course,
        };
        quadratic.certificate()
    }
}

/// A quadratic form, symmetric.
type Form = Vec<Vec<Rational>>;

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
