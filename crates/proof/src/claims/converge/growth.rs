//! Forms that never fall: no convergence. One grows, or is kept exactly, since a combination w of what has
//! to vanish is kept, changes its sign, or turns.

use num_traits::{One, Signed, ToPrimitive, Zero};
use serde_json::Value;

use super::split::growing_form;
use super::{Quotient, full};
use crate::certificate;
use crate::certificate::quadratic::Course;
use crate::claims::bounds::extreme;
use crate::claims::doubles::{
    Matrix, fine_spectral_radius, identity, inverse, largest, moved, negative_direction, plus,
    product,
};
use crate::claims::pinned::with_pinned;
use crate::claims::readouts::{self, Readouts};
use crate::claims::search::Choice;
use crate::claims::words::{as_one_step, that_may_not_vanish};
use crate::claims::{PROOF, constants_up_to};
use cordon_core::exact::to_f64;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign, point_within};
use cordon_core::linear::matrix;
use cordon_core::linear::simplest::{fractions_within, strictly_between};
use cordon_core::simplex::Work;
use cordon_core::system::System;
use cordon_core::{Rational, Result};

/// Most words of choices for which a form is searched, for each choice of the constants, and most of them
/// times the cube of the readouts.
const MOST_TRIED: usize = 64;
const MOST_ENTRIES: usize = 20_000_000;

/// Most readouts of a system of which forms that are kept exactly are searched: by elimination in fractions.
const MOST_EXACT: usize = 100;

/// A start from which some system in the ranges does not converge, with its constants, what is chosen
/// over and over, and the certificate; constants are tried at the ends of their ranges, and at whole numbers between,
/// where those are few.
///
/// # Errors
/// The checker rejects what was found.
pub fn grows(system: &System) -> Result<Option<Growth>> {
    let system = &with_pinned(system)?;
    let count = Readouts::of(system).map_or(1, |readouts| readouts.all.len());
    let most = (MOST_ENTRIES / count.pow(3).max(1)).clamp(1, MOST_TRIED);
    let whole = constants_up_to(system, 1);
    let tried = if whole.len() > MOST_TRIED { constants_up_to(system, 0) } else { whole };
    for values in tried {
        for word in that_may_not_vanish(system, &values)?.into_iter().take(most) {
            if let Some((start, certificate)) = growth(&as_one_step(system, &word)?)? {
                return Ok(Some(Growth { values, word, start, certificate }));
            }
        }
    }
    Ok(None)
}

/// A start from which a system does not converge.
#[derive(Clone, Debug)]
pub struct Growth {
    /// The values of the parameters.
    pub values: Vec<Rational>,
    /// The steps that the run repeats for ever.
    pub word: Vec<Choice>,
    /// The whole state at the start.
    pub start: Vec<Rational>,
    /// The certificate, accepted by the checker.
    pub certificate: Value,
}

/// A certificate that a system without choice does not converge from some assumed start: a form that
/// never falls. `None` where none is found.
///
/// # Errors
/// The checker rejects what was found.
fn growth(system: &System) -> Result<Option<(Vec<Rational>, Value)>> {
    let Ok(quotient) = Quotient::of(system) else { return Ok(None) };
    let (maps, doubles) = (&quotient.maps, quotient.doubles());
    let ([(_, exact)], [(_, map)]) = (maps.as_slice(), doubles.as_slice()) else {
        return Ok(None);
    };
    let growing = growing_form(map).and_then(|form| {
        let direction = positive_direction(&form)?;
        Some((form, direction.iter().map(short).collect::<Option<Vec<_>>>()?))
    });
    let growing = growing.iter().flat_map(|(form, direction)| {
        let rounded = ROUNDED.iter().filter_map(|bits| Some(full(&rounded(form, *bits)?)));
        // A second one where the first was too coarse after all.
        rounded.filter(|form| may_grow(map, form)).take(2).map(|form| (form, direction.clone()))
    });
    let all_kept = || kept_forms(exact, map).into_iter().chain(kept(exact, map));
    for (form, direction) in growing.chain(std::iter::once_with(all_kept).flatten()) {
        let Some(start) = positive_start(system, &quotient.readouts, &form, &direction) else {
            continue;
        };
        let course = Course::Stays(start.clone());
        let Some(certificate) = quotient.certificate(system, vec![form], course) else { continue };
        match certificate::judged(&certificate) {
            Ok(_) => return Ok(Some((start, certificate))),
            Err(cordon_core::Error::Rejected(_) | cordon_core::Error::Input(_)) => {}
            Err(e) => return Err(e),
        }
    }
    Ok(None)
}

/// Whether a form never falls, as far as doubles tell: the exact judgement is long.
fn may_grow(map: &Matrix, form: &[Vec<Rational>]) -> bool {
    let form: Matrix = form.iter().map(|row| row.iter().map(to_f64).collect()).collect();
    negative_direction(&plus(&moved(map, &form), -1.0, &form), -1e-13).is_none()
}

/// Bits to which forms that grow are rounded, one after the other.
const ROUNDED: [u32; 5] = [8, 14, 22, 30, 44];

/// The lower triangle, rounded to so many bits.
fn rounded(form: &Matrix, bits: u32) -> Option<Vec<Vec<Rational>>> {
    let unit = Rational::new(One::one(), (1u64 << bits).into());
    let entry = |x: &f64| {
        let steps = (x * (1u64 << bits) as f64).round();
        Some(&unit * Rational::from_integer(steps.to_i64()?.into()))
    };
    form.iter().enumerate().map(|(i, row)| row.iter().take(i + 1).map(entry).collect()).collect()
}

/// The simplest fraction within a millionth.
fn short(x: &f64) -> Option<Rational> {
    let x = Rational::from_float((x * 1e6).round() / 1e6)?;
    let millionth = Rational::new(1.into(), 1_000_000.into());
    strictly_between(&(&x - &millionth), &(&x + &millionth))
}

/// Forms that the step keeps exactly, each with a direction in which it is positive: from combinations w
/// of what has to vanish with wA = w or wA = -w, and from those that turn, wAA - 2c wA + w = 0 with c a
/// simple fraction between -1 and 1.
fn kept(
    map: &[Vec<Rational>],
    doubles: &Matrix,
) -> impl Iterator<Item = (Vec<Vec<Rational>>, Vec<Rational>)> {
    let (map, doubles) = (map.to_vec(), doubles.clone());
    let one = Rational::one();
    let cosines = fractions_within(&-&one, &one, MOST_TURNS);
    let squared = product(&doubles, &doubles);
    let may_be = move |c: &Rational| {
        let (c, unit) = (to_f64(c), identity(doubles.len()));
        let zero = match c.abs() == 1.0 {
            true => plus(&doubles, -c, &unit),
            false => plus(&plus(&squared, -2.0 * c, &doubles), 1.0, &unit),
        };
        doubles.len() <= MOST_EXACT
            && inverse(&zero).is_none_or(|back| largest(&back) * largest(&zero) > 1e8)
    };
    cosines.into_iter().filter(may_be).flat_map(move |c| {
        let n = map.len();
        let unit = matrix::unit(n);
        let straight = c.abs().is_one();
        // A - c, or A^2 - 2cA + 1.
        let square = matrix::product(&map, &map);
        let two = Rational::from_integer(2.into());
        let entry = |i: usize, j: usize| match straight {
            true => &map[i][j] - &c * &unit[i][j],
            false => &square[i][j] - &two * &c * &map[i][j] + &unit[i][j],
        };
        let zero: Vec<Vec<Rational>> =
            (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let map = map.clone();
        left_kernel(&zero).into_iter().map(move |w| {
            let turned = matrix::before(&w, &map);
            let product = |a: &[Rational], b: &[Rational], i: usize, j: usize| &a[i] * &b[j];
            let entry = |i: usize, j: usize| match straight {
                true => product(&w, &w, i, j),
                false => {
                    let mixed = product(&w, &turned, i, j) + product(&turned, &w, i, j);
                    product(&w, &w, i, j) + product(&turned, &turned, i, j) - &c * mixed
                }
            };
            let form = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
            (form, w)
        })
    })
}

/// Most readouts of a system of which all forms that the step keeps are found: unknowns are pairs of readouts.
const MOST_PAIRED: usize = 12;

/// A basis of the forms P with A'PA = P, and their negatives, each with a direction in which it is positive: where
/// something turns, by any angle.
fn kept_forms(map: &[Vec<Rational>], doubles: &Matrix) -> Vec<(Vec<Vec<Rational>>, Vec<Rational>)> {
    let n = map.len();
    if n > MOST_PAIRED || (fine_spectral_radius(doubles) - 1.0).abs() > 1e-6 {
        return Vec::new();
    }
    let pairs: Vec<(usize, usize)> = (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))).collect();
    let one = |is: bool| if is { Rational::one() } else { Rational::zero() };
    // What becomes of the form that is 1 at (i, j) and (j, i), less itself, at (k, l).
    let image = |&(i, j): &(usize, usize)| -> Vec<Rational> {
        let entry = |&(k, l): &(usize, usize)| {
            let mixed = if i == j { Rational::zero() } else { &map[j][k] * &map[i][l] };
            &map[i][k] * &map[j][l] + mixed - one((i, j) == (k, l))
        };
        pairs.iter().map(entry).collect()
    };
    let images: Vec<Vec<Rational>> = pairs.iter().map(image).collect();
    let signed = left_kernel(&images).into_iter().flat_map(|w| {
        let negated = w.iter().map(|x| -x).collect();
        [w, negated]
    });
    let with_direction = |w: Vec<Rational>| {
        let mut form = vec![vec![Rational::zero(); n]; n];
        for ((i, j), x) in pairs.iter().zip(w) {
            form[*j][*i] = x.clone();
            form[*i][*j] = x;
        }
        let in_doubles: Matrix = form.iter().map(|row| row.iter().map(to_f64).collect()).collect();
        let direction = positive_direction(&in_doubles)?;
        Some((form, direction.iter().map(short).collect::<Option<Vec<_>>>()?))
    };
    signed.filter_map(with_direction).collect()
}

/// Largest denominator of the cosine of a turn.
const MOST_TURNS: u32 = 5;

/// A basis of the w with w a = 0.
fn left_kernel(a: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
    // The rows beside the identity, reduced: where a row vanishes, what stands beside it is such a w.
    let n = a.len();
    let mut rows: Vec<(Vec<Rational>, Vec<Rational>)> =
        a.iter().cloned().zip(matrix::unit(n)).collect();
    let mut done = 0;
    for column in 0..n {
        let Some(pivot) = (done..n).find(|&i| !rows[i].0[column].is_zero()) else { continue };
        rows.swap(done, pivot);
        let (pivot, beside) = rows[done].clone();
        for (row, combination) in rows.iter_mut().skip(done + 1) {
            let factor = &row[column] / &pivot[column];
            if !factor.is_zero() {
                row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= &factor * p);
                combination.iter_mut().zip(&beside).for_each(|(x, p)| *x -= &factor * p);
            }
        }
        done += 1;
    }
    rows.into_iter().skip(done).map(|(_, combination)| combination).collect()
}

/// An assumed start at which the form is positive: that direction itself, if it is assumed; else a start
/// that lies as far along it as any.
fn positive_start(
    system: &System,
    readouts: &Readouts,
    form: &[Vec<Rational>],
    direction: &[Rational],
) -> Option<Vec<Rational>> {
    let starts = system.start_constraints();
    let is_positive = |state: &Vec<Rational>| {
        let met = |c: &Constraint| c.form.at(state).is_some_and(|v| c.sign.met_by(&v));
        readouts.at(state).is_some_and(|y| {
            let value = form.iter().zip(&y).map(|(row, a)| a * matrix::dot(row, &y));
            value.fold(Rational::zero(), |sum, t| sum + t).is_positive()
        }) && starts.iter().all(met)
    };
    let mut along = vec![Rational::zero(); system.state.len()];
    for ((j, reference), y) in readouts.all.iter().zip(direction) {
        if let Some(slot) = along.get_mut(*j) {
            *slot = match reference {
                readouts::Reference::Target(t) => t + y,
                readouts::Reference::Agent(_) => y.clone(),
            };
        }
    }
    if is_positive(&along) {
        return Some(along);
    }
    let work = Work::limited(PROOF.work);
    let inside = point_within(system.state.len(), &starts, &work)?;
    // Where the starts are not bounded, near one of them.
    let near = |(j, x): (usize, &Rational)| {
        let above = Affine::variable(j) - &Affine::constant(x - Rational::one());
        let below = Affine::constant(x + Rational::one()) - &Affine::variable(j);
        [above, below].map(|form| Constraint { form, sign: Sign::NonNegative })
    };
    let boxed: Vec<Constraint> =
        starts.iter().cloned().chain(inside.iter().enumerate().flat_map(near)).collect();
    // Starts may have no part along the direction: then along one readout.
    let forms = readouts.forms();
    let slope = form.iter().map(|row| matrix::dot(row, direction));
    let none = || Affine::constant(Rational::zero());
    let far = forms.iter().zip(slope).fold(none(), |sum, (readout, factor)| {
        sum + &(readout.clone() * &Affine::constant(factor))
    });
    let all = [far].into_iter().chain(forms.into_iter().take(MOST_DIRECTIONS));
    for side in all.flat_map(|far| [far.clone(), none() - &far]) {
        let end = extreme(&side, &starts, system.state.len(), &work)
            .or_else(|| extreme(&side, &boxed, system.state.len(), &work));
        let Some(end) = end else { continue };
        // Strict bounds are not met at the end itself.
        let between = |near: Rational| -> Vec<Rational> {
            inside.iter().zip(&end).map(|(a, b)| b + (a - b) * &near).collect()
        };
        let nearer = [Rational::zero(), Rational::new(1.into(), 64.into())];
        let found = nearer.into_iter().map(between).find(|s| is_positive(s));
        if found.is_some() {
            return found;
        }
    }
    None
}

/// Most readouts along each of which a start is tried.
const MOST_DIRECTIONS: usize = 8;

/// A direction in which the form is positive: its greatest, by the power method on a shifted form.
fn positive_direction(form: &Matrix) -> Option<Vec<f64>> {
    let n = form.len();
    let shift = n as f64 * largest(form);
    let mut v: Vec<f64> = (0..n).map(|i| 1.0 + i as f64 / 7.0).collect();
    for _ in 0..5_000 {
        let mut next: Vec<f64> = form
            .iter()
            .zip(&v)
            .map(|(row, own)| row.iter().zip(&v).map(|(a, x)| a * x).sum::<f64>() + shift * own)
            .collect();
        let norm = next.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if norm == 0.0 {
            return None;
        }
        next.iter_mut().for_each(|x| *x /= norm);
        v = next;
    }
    let value: f64 = form
        .iter()
        .zip(&v)
        .map(|(row, x)| x * row.iter().zip(&v).map(|(a, y)| a * y).sum::<f64>())
        .sum();
    (value > 0.0).then_some(v)
}
