//! Convergence by quadratic forms: P > 0 with rate^2 P - A'PA >= 0 in every mode and at every corner; or
//! a P_s for each mode s, with rate^2 P_s - A'P_tA >= 0 for every mode t that may act next.
//!
//! P is found in doubles: the sum of the images of the identity under the step, divided by the rate
//! (the discrete Lyapunov equation). Where there are several maps the images are averaged, and the forms
//! are moved as little as makes them fall in a direction in which they do not, until there is none (the
//! relaxation method of Agmon, Motzkin and Schoenberg). Rounded, P is checked exactly by the independent
//! checker. A'v -> v'A'PAv is convex in each parameter, so that the corners decide.
//!
//! No convergence by a form that never falls: one that grows, or one that is kept exactly, since a
//! combination w of what has to vanish is kept, changes its sign, or turns.

use num_traits::{One, Signed, ToPrimitive, Zero};
use serde_json::Value;

use super::bounds::extreme;
use super::certificate::linear_system;
use super::doubles::{
    Matrix, dot, identity, image, largest, moved, negative_direction, plus, product,
    spectral_radius,
};
use super::readouts::{self, QuotientRows, Readouts};
use crate::certificate;
use crate::certificate::linear::Quadratic;
use cordon_core::exact::{fraction, to_f64};
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, point_within};
use cordon_core::linear::matrix;
use cordon_core::linear::simplest::{fractions_within, strictly_between};
use cordon_core::simplex::Work;
use cordon_core::system::expression::sum_text;
use cordon_core::system::{Parameter, System};
use cordon_core::{Rational, Result};

/// Most readouts: the checker multiplies matrices of that size exactly.
const MOST_READOUTS: usize = 64;

/// Most maps, one a mode and corner.
const MOST_MAPS: usize = 256;

/// Quadratic forms that prove convergence.
#[derive(Clone, Debug)]
pub struct Contraction {
    /// The factor by which its root falls in every step, at least.
    pub rate: Rational,
    /// The form, symmetric and positive definite; or one for each mode.
    pub forms: Vec<Vec<Vec<Rational>>>,
    /// What it is a form of.
    pub readouts: Readouts,
    /// The certificate, accepted by the checker.
    pub certificate: Value,
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

/// A proof that a system converges, for all its parameters and whatever mode acts.
///
/// # Errors
/// The checker rejects what was found.
pub fn contraction(system: &System) -> Result<Option<Contraction>> {
    let Some(quotient) = Quotient::of(system) else { return Ok(None) };
    let maps = quotient.doubles();
    let radius = maps.iter().map(|(_, a)| spectral_radius(a)).fold(0.0, f64::max);
    if radius >= 1.0 {
        return Ok(None);
    }
    // The smallest rate that works among some between the radius and 1.
    let steps = [1.0 / 16.0, 1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0, 3.0 / 4.0, 7.0 / 8.0, 15.0 / 16.0];
    // One form for all modes first; then one for each.
    let counts = if system.modes.len() > 1 { vec![1, system.modes.len()] } else { vec![1] };
    for count in counts {
        for part in steps {
            let wanted = radius + (1.0 - radius) * part;
            let Some(rate) = rational_between(wanted, wanted + (1.0 - wanted) / 64.0) else {
                continue;
            };
            let Some(forms) = falling_forms(&maps, count, to_f64(&rate)) else { continue };
            if let Some(found) = checked(system, &quotient, &rate, &forms)? {
                return Ok(Some(found));
            }
        }
    }
    Ok(None)
}

/// The simplest fraction strictly between two doubles.
fn rational_between(low: f64, high: f64) -> Option<Rational> {
    strictly_between(&Rational::from_float(low)?, &Rational::from_float(high)?)
}

/// Forms that fall by the rate under every map, in doubles: one for all modes, or one for each, which
/// measures where that mode acts next.
fn falling_forms(maps: &[(usize, Matrix)], count: usize, rate: f64) -> Option<Vec<Matrix>> {
    let scaled: Vec<(usize, Matrix)> = maps
        .iter()
        .map(|(m, a)| (*m, a.iter().map(|r| r.iter().map(|x| x / rate).collect()).collect()))
        .collect();
    let n = scaled.first()?.1.len();
    let mut forms = vec![averaged(&scaled, n); count];
    // What has to fall: from the form of the map's mode to that of any mode.
    let falls: Vec<(usize, usize, &Matrix)> = scaled
        .iter()
        .flat_map(|(m, a)| (0..count).map(move |next| (if count == 1 { 0 } else { *m }, next, a)))
        .collect();
    let fall = |forms: &[Matrix], (own, next, a): (usize, usize, &Matrix)| {
        plus(&forms[own], -1.0, &moved(a, &forms[next]))
    };
    let scale = |forms: &[Matrix]| forms.iter().map(largest).fold(0.0, f64::max);
    let margin = 1e-9 * scale(&forms);
    if falls.iter().all(|f| negative_direction(&fall(&forms, *f), margin).is_none()) {
        return Some(forms);
    }
    if falls.len() == 1 {
        return None;
    }
    let mut fallen = 0;
    let most = MOST_MOVES.min(MOST_WORK / (n * n * n).max(1));
    for f in falls.iter().cycle().take(most) {
        let (own, next, a) = *f;
        let (difference, scale) = (fall(&forms, *f), scale(&forms));
        let Some(v) = negative_direction(&difference, 1e-6 * scale) else {
            fallen += 1;
            if fallen == falls.len() {
                return Some(forms);
            }
            continue;
        };
        fallen = 0;
        // The fall along v is linear in the forms, with the slopes vv' and -uu' for u = av: the least move
        // that makes it a little positive goes along those.
        let u = image(a, &v);
        let (vv, uu, uv) = (dot(&v, &v), dot(&u, &u), dot(&u, &v));
        let common = if own == next { 2.0 * uv * uv } else { 0.0 };
        let steep = vv * vv + uu * uu - common;
        let step = (1e-3 * scale * vv - dot(&v, &image(&difference, &v))) / steep;
        if !step.is_finite() {
            return None;
        }
        for (form, sign, w) in [(own, step, &v), (next, -step, &u)] {
            for (row, x) in forms[form].iter_mut().zip(w) {
                row.iter_mut().zip(w).for_each(|(p, y)| *p += sign * x * y);
            }
        }
    }
    None
}

/// Most moves of forms, and most of them times n^3.
const MOST_MOVES: usize = 20_000;
const MOST_WORK: usize = 100_000_000;

/// The sum of the averaged images of the identity.
fn averaged(scaled: &[(usize, Matrix)], n: usize) -> Matrix {
    let mut form = identity(n);
    if let [(_, only)] = scaled {
        // By doubling.
        let mut power = only.clone();
        for _ in 0..40 {
            form = plus(&form, 1.0, &moved(&power, &form));
            power = product(&power, &power);
            if largest(&power) < 1e-12 {
                break;
            }
        }
        return form;
    }
    let weight = 1.0 / scaled.len() as f64;
    for _ in 0..3_000 {
        let images = scaled.iter().map(|(_, a)| moved(a, &form));
        let next = images.fold(identity(n), |sum, image| plus(&sum, weight, &image));
        let change = largest(&plus(&next, -1.0, &form));
        let done = change < 1e-7 * largest(&next);
        form = next;
        if done || largest(&form) > 1e9 {
            break;
        }
    }
    form
}

/// The forms in rationals, coarse first, as far as the checker accepts them.
fn checked(
    system: &System,
    quotient: &Quotient,
    rate: &Rational,
    forms: &[Matrix],
) -> Result<Option<Contraction>> {
    let scale = forms.iter().map(largest).fold(0.0, f64::max);
    for bits in [12, 24, 40] {
        let unit = scale / 2f64.powi(bits);
        let Some(unit) = Rational::from_float(2f64.powi(unit.log2().floor() as i32)) else {
            continue;
        };
        let rounded = |x: &f64| {
            let steps = (x / to_f64(&unit)).round();
            Some(&unit * Rational::from_integer(steps.to_i64()?.into()))
        };
        // The lower triangle decides: the two halves are equal but for rounding.
        let lower = |form: &Matrix| -> Option<Vec<Vec<Rational>>> {
            let row = |(i, row): (usize, &Vec<f64>)| row.iter().take(i + 1).map(rounded).collect();
            form.iter().enumerate().map(row).collect()
        };
        let Some(lower) = forms.iter().map(lower).collect::<Option<Vec<_>>>() else { continue };
        let Some(mut certificate) = quotient.certificate(system) else { return Ok(None) };
        match lower.as_slice() {
            [one] => certificate.matrix = Some(texts(one)),
            all => {
                let names = system.modes.iter().map(|m| m.name.clone());
                certificate.matrices = names.zip(all.iter().map(|m| texts(m))).collect();
            }
        }
        certificate.rate = Some(fraction(rate));
        let certificate = certificate.certificate();
        match certificate::judged(&certificate) {
            Ok(_) => {
                let forms = lower.iter().map(|m| full(m)).collect();
                let readouts = quotient.readouts.clone();
                return Ok(Some(Contraction { rate: rate.clone(), forms, readouts, certificate }));
            }
            // Too coarse: the next rounding may do. Or beyond the checker's limits.
            Err(cordon_core::Error::Rejected(_) | cordon_core::Error::Input(_)) => {}
            Err(e) => return Err(e),
        }
    }
    Ok(None)
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

/// A start from which some system in the ranges does not converge, with its constants and certificate:
/// at the ends of the constants' ranges, where nothing else varies.
///
/// # Errors
/// The checker rejects what was found.
pub fn grows(system: &System) -> Result<Option<Growth>> {
    for values in super::constants(system, 1).unwrap_or_default() {
        let mut fixed = system.clone();
        fixed.parameters = super::at(system, &values);
        if let Some((start, certificate)) = growth(&fixed)? {
            return Ok(Some(Growth { values, start, certificate }));
        }
    }
    Ok(None)
}

/// A start from which a system does not converge.
#[derive(Clone, Debug)]
pub struct Growth {
    /// The values of the parameters.
    pub values: Vec<Rational>,
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
    let Some(quotient) = Quotient::of(system) else { return Ok(None) };
    let (maps, doubles) = (&quotient.maps, quotient.doubles());
    let ([(_, exact)], [(_, map)]) = (maps.as_slice(), doubles.as_slice()) else {
        return Ok(None);
    };
    if map.len() > LARGEST_STEIN {
        return Ok(None);
    }
    let growing = stein(map).and_then(|form| {
        let direction = positive_direction(&form)?;
        Some((full(&rounded(&form)?), direction.iter().map(short).collect::<Option<Vec<_>>>()?))
    });
    for (form, direction) in growing.into_iter().chain(kept(exact)) {
        let Some(start) = positive_start(system, &quotient.readouts, &form, &direction) else {
            continue;
        };
        let Some(mut certificate) = quotient.certificate(system) else { return Ok(None) };
        let lower: Vec<Vec<Rational>> =
            form.iter().enumerate().map(|(i, row)| row[..=i].to_vec()).collect();
        certificate.matrix = Some(texts(&lower));
        certificate.start = Some(start.iter().map(fraction).collect());
        let certificate = certificate.certificate();
        match certificate::judged(&certificate) {
            Ok(_) => return Ok(Some((start, certificate))),
            Err(cordon_core::Error::Rejected(_) | cordon_core::Error::Input(_)) => {}
            Err(e) => return Err(e),
        }
    }
    Ok(None)
}

/// The lower triangle, rounded to 30 bits.
fn rounded(form: &Matrix) -> Option<Vec<Vec<Rational>>> {
    let unit = Rational::new(One::one(), (1u64 << 30).into());
    let entry = |x: &f64| {
        let steps = (x * f64::from(1u32 << 30)).round();
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
fn kept(map: &[Vec<Rational>]) -> impl Iterator<Item = (Vec<Vec<Rational>>, Vec<Rational>)> {
    let map = map.to_vec();
    let one = Rational::one();
    let cosines = fractions_within(&-&one, &one, MOST_TURNS);
    cosines.into_iter().flat_map(move |c| {
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
    // The slope of the form there, as a form of the state.
    let slope = form.iter().map(|row| matrix::dot(row, direction));
    let far = readouts
        .forms()
        .into_iter()
        .zip(slope)
        .fold(Affine::constant(Rational::zero()), |sum, (readout, factor)| {
            sum + &(readout * &Affine::constant(factor))
        });
    let work = Work::limited(super::PROOF.work);
    let inside = point_within(system.state.len(), &starts, &work)?;
    let near = Rational::new(1.into(), 64.into());
    for side in [far.clone(), Affine::constant(Rational::zero()) - &far] {
        // Strict bounds are not met at the end itself.
        let Some(end) = extreme(&side, &starts, system.state.len(), &work) else { continue };
        let between = |near: &Rational| -> Vec<Rational> {
            inside.iter().zip(&end).map(|(a, b)| b + (a - b) * near).collect()
        };
        let found = [Rational::zero(), near.clone()].iter().map(between).find(|s| is_positive(s));
        if found.is_some() {
            return found;
        }
    }
    None
}

/// Most readouts of a system whose growth is searched: the equations have n(n+1)/2 unknowns.
const LARGEST_STEIN: usize = 24;

/// The solution P of A'PA - P = 1, by elimination over the entries of the lower triangle.
fn stein(a: &Matrix) -> Option<Matrix> {
    let n = a.len();
    let place = |i: usize, j: usize| i.max(j) * (i.max(j) + 1) / 2 + i.min(j);
    let unknowns = n * (n + 1) / 2;
    let mut rows = Vec::with_capacity(unknowns);
    for i in 0..n {
        for j in 0..=i {
            let mut row = vec![0.0; unknowns + 1];
            for k in 0..n {
                for l in 0..n {
                    row[place(k, l)] += a[k][i] * a[l][j];
                }
            }
            row[place(i, j)] -= 1.0;
            row[unknowns] = if i == j { 1.0 } else { 0.0 };
            rows.push(row);
        }
    }
    for k in 0..unknowns {
        let best = (k..unknowns).max_by(|&p, &q| rows[p][k].abs().total_cmp(&rows[q][k].abs()))?;
        if rows[best][k].abs() < 1e-12 {
            return None;
        }
        rows.swap(k, best);
        let pivot = rows[k].clone();
        for row in rows.iter_mut().skip(k + 1) {
            let factor = row[k] / pivot[k];
            if factor != 0.0 {
                for (x, p) in row.iter_mut().zip(&pivot).skip(k) {
                    *x -= factor * p;
                }
            }
        }
    }
    let mut x = vec![0.0; unknowns];
    for k in (0..unknowns).rev() {
        let sum: f64 = (k + 1..unknowns).map(|j| rows[k][j] * x[j]).sum();
        x[k] = (rows[k][unknowns] - sum) / rows[k][k];
    }
    // Scaled, so that rounding to a fixed unit loses nothing that matters.
    let form: Matrix = (0..n).map(|i| (0..n).map(|j| x[place(i, j)]).collect()).collect();
    let scale = largest(&form);
    (scale.is_finite() && scale > 0.0)
        .then(|| form.iter().map(|r| r.iter().map(|x| x / scale).collect()).collect())
}

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
