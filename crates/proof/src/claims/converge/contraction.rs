//! Forms that fall: rate^2 P - A'PA >= 0 in every mode and at every corner; or a P_s for each mode s, with
//! rate^2 P_s - A'P_tA >= 0 for every mode t that may act next.
//!
//! The first guess is the sum of the images of the identity under the step, divided by the rate (the
//! discrete Lyapunov equation). Where there are several maps the images are averaged, and the forms are
//! moved as little as makes them fall in a direction in which they do not, until there is none (the
//! relaxation method of Agmon, Motzkin and Schoenberg). A'v -> v'A'PAv is convex in each parameter, so
//! that the corners decide. Modes that act in turn are judged a round at a time, where nothing varies.

use num_traits::{One, Signed, ToPrimitive};
use serde_json::Value;

use super::{Quotient, full, short};
use crate::certificate;
use crate::certificate::quadratic::Course;
use crate::claims::doubles::{
    Matrix, dot, fine_spectral_radius, identity, image, images_of_unit, largest, moved,
    negative_direction, plus, spectral_radius,
};
use crate::claims::pinned::with_pinned;
use crate::claims::readouts::{self, Readouts};
use crate::claims::search::Choice;
use crate::claims::words::as_one_step;
use cordon_core::exact::to_f64;
use cordon_core::linear::matrix;
use cordon_core::linear::simplest::strictly_between;
use cordon_core::system::{Schedule, System};
use cordon_core::{Rational, Result};

/// Quadratic forms that prove convergence.
#[derive(Clone, Debug)]
pub struct Contraction {
    /// The factor by which its root falls in every round, at least.
    pub rate: Rational,
    /// Steps of a round: 1, or those of modes in turn.
    pub round: u64,
    /// By how much a readout within a round may exceed the greatest at its begin: 1 where a round is a step.
    pub swing: Rational,
    /// The form, symmetric and positive definite; or one for each mode.
    pub forms: Vec<Vec<Vec<Rational>>>,
    /// What it is a form of.
    pub readouts: Readouts,
    /// The certificate, accepted by the checker.
    pub certificate: Value,
}
/// A proof that a system converges, for all its parameters and whatever mode acts.
///
/// # Errors
/// The checker rejects what was found.
pub fn contraction(system: &System) -> Result<Option<Contraction>> {
    let system = &with_pinned(system)?;
    match turn(system) {
        Some(word) => {
            let found = in_every_step(&as_one_step(system, &word)?)?;
            Ok(found.and_then(|found| {
                let swing = swing(system, &found.readouts, &word)?;
                Some(Contraction { round: word.len() as u64, swing, ..found })
            }))
        }
        None => in_every_step(system),
    }
}

/// The steps of a round, where modes act in turn and nothing varies.
fn turn(system: &System) -> Option<Vec<Choice>> {
    let Schedule::Cycle(list) = &system.schedule else { return None };
    let values = system.parameters.iter().map(|p| p.fixed().cloned());
    let values = values.collect::<Option<Vec<_>>>().filter(|_| list.len() > 1)?;
    Some(list.iter().map(|&mode| Choice { mode, values: values.clone() }).collect())
}

/// By how much a readout within a round may exceed the greatest at its begin.
fn swing(system: &System, readouts: &Readouts, word: &[Choice]) -> Option<Rational> {
    let mut so_far = matrix::unit(readouts.all.len());
    let mut most = Rational::one();
    for choice in word {
        let rows = readouts.quotient(system.modes.get(choice.mode)?)?;
        so_far = matrix::product(&readouts::at(&rows, &choice.values), &so_far);
        let sums = so_far.iter().map(|row| row.iter().map(Signed::abs).sum());
        most = sums.fold(most, |most: Rational, sum| most.max(sum));
    }
    Some(most)
}

/// Readouts of which dense forms are judged soon.
const FEW: usize = 24;

/// As [`contraction`], in every step, whatever mode acts.
fn in_every_step(system: &System) -> Result<Option<Contraction>> {
    let Ok(quotient) = Quotient::of(system) else { return Ok(None) };
    let maps = quotient.doubles();
    let greatest = |of: fn(&Matrix) -> f64| maps.iter().map(|(_, a)| of(a)).fold(0.0, f64::max);
    let radius = match greatest(spectral_radius) {
        rough if rough < 1.0 => rough,
        _ => greatest(fine_spectral_radius),
    };
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
            let tried = |forms: &[Lower]| checked(system, &quotient, &maps, &rate, forms);
            if count == 1 && quotient.readouts.all.len() > FEW {
                for form in short::forms(&maps, to_f64(&rate)) {
                    if let Judged::Accepted(found) = tried(&[form])? {
                        return Ok(Some(*found));
                    }
                }
            }
            let Some(forms) = falling_forms(&maps, count, to_f64(&rate)) else { continue };
            // Of many readouts with longer numbers what is left over in a step is near the identity.
            let dense = quotient.readouts.all.len() > FEW;
            for bits in if dense { [24, 30, 40] } else { [12, 24, 40] } {
                let Some(forms) = rounded(&forms, bits) else { continue };
                match tried(&forms)? {
                    Judged::Accepted(found) => return Ok(Some(*found)),
                    Judged::Rejected => {}
                    // Longer numbers are beyond too, and those of other rates are as long.
                    Judged::Beyond => return Ok(None),
                }
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

/// Most sums of images, and most of them times the maps and n^3.
const MOST_IMAGES: usize = 3_000;
const MOST_IMAGED: usize = 300_000_000;

/// The sum of the averaged images of the identity.
fn averaged(scaled: &[(usize, Matrix)], n: usize) -> Matrix {
    if let [(_, only)] = scaled {
        return images_of_unit(only);
    }
    let mut form = identity(n);
    let weight = 1.0 / scaled.len() as f64;
    for _ in 0..MOST_IMAGES.min(MOST_IMAGED / (scaled.len() * n.pow(3)).max(1)) {
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

/// The lower triangle of a form.
type Lower = Vec<Vec<Rational>>;

/// Forms rounded to so many bits: the lower triangles decide, the halves are equal but for rounding.
fn rounded(forms: &[Matrix], bits: i32) -> Option<Vec<Lower>> {
    let unit = forms.iter().map(largest).fold(0.0, f64::max) / 2f64.powi(bits);
    let unit = Rational::from_float(2f64.powi(unit.log2().floor() as i32))?;
    let entry = |x: &f64| {
        let steps = (x / to_f64(&unit)).round();
        Some(&unit * Rational::from_integer(steps.to_i64()?.into()))
    };
    let lower = |form: &Matrix| -> Option<Lower> {
        let row = |(i, row): (usize, &Vec<f64>)| row.iter().take(i + 1).map(entry).collect();
        form.iter().enumerate().map(row).collect()
    };
    forms.iter().map(lower).collect()
}

/// What becomes of a guess.
enum Judged {
    /// The checker accepts it.
    Accepted(Box<Contraction>),
    /// It does not fall.
    Rejected,
    /// It is beyond the checker's limits.
    Beyond,
}

/// The judgement of forms: in doubles first, since the exact one is long.
fn checked(
    system: &System,
    quotient: &Quotient,
    maps: &[(usize, Matrix)],
    rate: &Rational,
    lower: &[Lower],
) -> Result<Judged> {
    let forms: Vec<Vec<Vec<Rational>>> = lower.iter().map(|m| full(m)).collect();
    let doubles: Vec<Matrix> = forms
        .iter()
        .map(|m| m.iter().map(|row| row.iter().map(to_f64).collect()).collect())
        .collect();
    let (square, scale) = (to_f64(rate).powi(2), doubles.iter().map(largest).fold(0.0, f64::max));
    let falls = maps.iter().all(|(mode, a)| {
        let own = doubles.get(if doubles.len() == 1 { 0 } else { *mode });
        let fall = |next| own.map(|own| plus(&plus(own, square - 1.0, own), -1.0, &moved(a, next)));
        let is_fall = |f: Matrix| negative_direction(&f, -1e-9 * scale).is_none();
        doubles.iter().all(|next| fall(next).is_some_and(is_fall))
    });
    if !falls {
        return Ok(Judged::Rejected);
    }
    let course = Course::Falls(rate.clone());
    let Some(certificate) = quotient.certificate(system, forms.clone(), course) else {
        return Ok(Judged::Rejected);
    };
    match certificate::judged(&certificate) {
        Ok(_) => Ok(Judged::Accepted(Box::new(Contraction {
            rate: rate.clone(),
            round: 1,
            swing: Rational::one(),
            forms,
            readouts: quotient.readouts.clone(),
            certificate,
        }))),
        Err(cordon_core::Error::Rejected(_)) => Ok(Judged::Rejected),
        Err(cordon_core::Error::Input(_)) => Ok(Judged::Beyond),
        Err(e) => Err(e),
    }
}
