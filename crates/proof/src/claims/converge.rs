//! Convergence by a quadratic form: P > 0 with rate^2 P - A'PA >= 0 in every mode and at every corner.
//!
//! P is found in doubles: the sum of the images of the identity under the step, divided by the rate
//! (the discrete Lyapunov equation). Where there are several maps the images are averaged, and a map for
//! which the form does not fall gets more weight, until it falls for all. Rounded, P is checked exactly by the independent checker.
//! A'v -> v'A'PAv is convex in each parameter, so that the corners decide.

use num_traits::{One, ToPrimitive, Zero};
use serde_json::Value;

use super::certificate::linear_system;
use super::doubles::{
    Matrix, identity, is_definite, largest, moved, plus, product, spectral_radius,
};
use super::readouts::{self, QuotientRows, Readouts};
use crate::certificate;
use crate::certificate::linear::Quadratic;
use cordon_core::exact::{fraction, to_f64};
use cordon_core::linear::simplest::strictly_between;
use cordon_core::system::expression::sum_text;
use cordon_core::system::{Parameter, System};
use cordon_core::{Rational, Result};

/// Most readouts: the checker multiplies matrices of that size exactly.
const MOST_READOUTS: usize = 64;

/// Most maps, one a mode and corner.
const MOST_MAPS: usize = 256;

/// A quadratic form that proves convergence.
#[derive(Clone, Debug)]
pub struct Contraction {
    /// The factor by which its root falls in every step, at least.
    pub rate: Rational,
    /// The form, symmetric and positive definite.
    pub form: Vec<Vec<Rational>>,
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
    /// At each corner of each mode.
    maps: Vec<Vec<Vec<Rational>>>,
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
        for rows in &rows {
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
            maps.extend(corners.iter().map(|values| readouts::at(rows, values)));
        }
        (maps.len() <= MOST_MAPS).then_some(Self { readouts, rows, maps })
    }

    fn doubles(&self) -> Vec<Matrix> {
        let double = |m: &Vec<Vec<Rational>>| -> Matrix {
            m.iter().map(|row| row.iter().map(to_f64).collect()).collect()
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
    let radius = maps.iter().map(spectral_radius).fold(0.0, f64::max);
    if radius >= 1.0 {
        return Ok(None);
    }
    // The smallest rate that works among some between the radius and 1.
    let steps = [1.0 / 16.0, 1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0, 3.0 / 4.0, 7.0 / 8.0, 15.0 / 16.0];
    for part in steps {
        let wanted = radius + (1.0 - radius) * part;
        let Some(rate) = rational_between(wanted, wanted + (1.0 - wanted) / 64.0) else { continue };
        let Some(form) = common_form(&maps, to_f64(&rate)) else { continue };
        if let Some(found) = checked(system, &quotient, &rate, &form)? {
            return Ok(Some(found));
        }
    }
    Ok(None)
}

/// The simplest fraction strictly between two doubles.
fn rational_between(low: f64, high: f64) -> Option<Rational> {
    strictly_between(&Rational::from_float(low)?, &Rational::from_float(high)?)
}

/// A form that falls by the rate under every map, in doubles.
fn common_form(maps: &[Matrix], rate: f64) -> Option<Matrix> {
    let n = maps.first()?.len();
    let scaled: Vec<Matrix> = maps
        .iter()
        .map(|a| a.iter().map(|r| r.iter().map(|x| x / rate).collect()).collect())
        .collect();
    if let [only] = scaled.as_slice() {
        // The sum over all powers, by doubling.
        let (mut form, mut power) = (identity(n), only.clone());
        for _ in 0..40 {
            form = plus(&form, 1.0, &moved(&power, &form));
            power = product(&power, &power);
            if largest(&power) < 1e-12 {
                break;
            }
        }
        return falls(&form, &scaled).is_none().then_some(form);
    }
    let mut weights = vec![1.0 / scaled.len() as f64; scaled.len()];
    for _ in 0..12 {
        let mut form = identity(n);
        for _ in 0..3_000 {
            let mut next = identity(n);
            for (a, w) in scaled.iter().zip(&weights) {
                next = plus(&next, *w, &moved(a, &form));
            }
            let change = largest(&plus(&next, -1.0, &form));
            let done = change < 1e-7 * largest(&next);
            form = next;
            if done || largest(&form) > 1e9 {
                break;
            }
        }
        match falls(&form, &scaled) {
            None => return Some(form),
            Some(worst) => {
                if let Some(w) = weights.get_mut(worst) {
                    *w *= 1.5;
                }
                let sum: f64 = weights.iter().sum();
                weights.iter_mut().for_each(|w| *w /= sum);
            }
        }
    }
    None
}

/// The first map under which the form does not fall.
fn falls(form: &Matrix, maps: &[Matrix]) -> Option<usize> {
    let margin = 1e-9 * largest(form);
    maps.iter().position(|a| !is_definite(&plus(form, -1.0, &moved(a, form)), margin))
}

/// The form in rationals, coarse first, as far as the checker accepts it.
fn checked(
    system: &System,
    quotient: &Quotient,
    rate: &Rational,
    form: &Matrix,
) -> Result<Option<Contraction>> {
    let scale = largest(form);
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
        let lower: Option<Vec<Vec<Rational>>> = form
            .iter()
            .enumerate()
            .map(|(i, row)| row.iter().take(i + 1).map(rounded).collect())
            .collect();
        let Some(lower) = lower else { continue };
        let Some(mut certificate) = quotient.certificate(system) else { return Ok(None) };
        certificate.matrix = Some(lower.iter().map(|r| r.iter().map(fraction).collect()).collect());
        certificate.rate = Some(fraction(rate));
        let certificate = certificate.certificate();
        match certificate::judged(&certificate) {
            Ok(_) => {
                let n = lower.len();
                let full = |i: usize, j: usize| lower[i.max(j)][i.min(j)].clone();
                let form = (0..n).map(|i| (0..n).map(|j| full(i, j)).collect()).collect();
                let readouts = quotient.readouts.clone();
                return Ok(Some(Contraction { rate: rate.clone(), form, readouts, certificate }));
            }
            // Too coarse: the next rounding may do. Or beyond the checker's limits.
            Err(cordon_core::Error::Rejected(_) | cordon_core::Error::Input(_)) => {}
            Err(e) => return Err(e),
        }
    }
    Ok(None)
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

/// A certificate that a system without choice does not converge from some start: a form that never
/// falls. `None` where none is found.
///
/// # Errors
/// The checker rejects what was found.
fn growth(system: &System) -> Result<Option<(Vec<Rational>, Value)>> {
    let Some(quotient) = Quotient::of(system) else { return Ok(None) };
    let maps = quotient.doubles();
    let [map] = maps.as_slice() else { return Ok(None) };
    let n = map.len();
    if n > LARGEST_STEIN {
        return Ok(None);
    }
    // A'PA - P = 1, as linear equations in the entries of P.
    let Some(form) = stein(map) else { return Ok(None) };
    // A direction in which it is positive: the unstable one.
    let Some(direction) = positive_direction(&form) else { return Ok(None) };
    let mut state = vec![Rational::zero(); system.state.len()];
    for ((j, reference), y) in quotient.readouts.all.iter().zip(&direction) {
        let Some(y) = Rational::from_float((y * 1e6).round() / 1e6) else { return Ok(None) };
        let y = cordon_core::linear::simplest::strictly_between(
            &(&y - Rational::new(1.into(), 1_000_000.into())),
            &(&y + Rational::new(1.into(), 1_000_000.into())),
        );
        let Some(y) = y else { return Ok(None) };
        if let Some(slot) = state.get_mut(*j) {
            *slot = match reference {
                readouts::Reference::Target(t) => t + y,
                readouts::Reference::Agent(_) => y,
            };
        }
    }
    let unit = Rational::new(One::one(), (1u64 << 30).into());
    let rounded = |x: &f64| {
        let steps = (x * f64::from(1u32 << 30)).round();
        Some(&unit * Rational::from_integer(steps.to_i64()?.into()))
    };
    let lower: Option<Vec<Vec<String>>> = form
        .iter()
        .enumerate()
        .map(|(i, row)| row.iter().take(i + 1).map(|x| rounded(x).map(|x| fraction(&x))).collect())
        .collect();
    let (Some(lower), Some(mut certificate)) = (lower, quotient.certificate(system)) else {
        return Ok(None);
    };
    certificate.matrix = Some(lower);
    certificate.start = Some(state.iter().map(fraction).collect());
    let certificate = certificate.certificate();
    match certificate::judged(&certificate) {
        Ok(_) => Ok(Some((state, certificate))),
        Err(cordon_core::Error::Rejected(_) | cordon_core::Error::Input(_)) => Ok(None),
        Err(e) => Err(e),
    }
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
