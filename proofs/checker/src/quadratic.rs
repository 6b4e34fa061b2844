//! Limits of readouts of linear systems, by quadratic forms.

use crate::expr::{Signature, joined};
use crate::fault::{Result, Shown, ensure, fault};
use crate::format::{Named, Quadratic};
use crate::linear::{STEPS, System, Values, affine, at, coefficients, reals};
use crate::matrix::{Matrix, congruent, definite, difference, symmetric};
use crate::number::Number;
use crate::poly::Poly;

const RULE: &str = "quadratic";

/// Most readouts: a form of them has as many rows.
const MAX_READOUTS: usize = 200;

/// `quadratic`: readouts y with L(step(x)) = A L(x) for every mode, and y'Py. If P > 0 and rate^2 P - A'PA >= 0 then y'Py
/// falls by rate^2 in every step. If A'PA - P >= 0 it never falls, and if y'Py > 0 at a start y does not tend to 0 from there.
///
/// # Errors
/// What is wrong with it.
pub fn quadratic(c: &Quadratic) -> Result<Shown> {
    let (system, size) = (System::read(&c.system)?, c.readouts.len());
    ensure!(
        (1..=MAX_READOUTS).contains(&size),
        RULE,
        "{size} readouts: expected 1 to {MAX_READOUTS}"
    );
    let fits =
        c.maps.0.len() == system.modes.len() && c.matrix.is_some() == c.matrices.0.is_empty();
    ensure!(fits, RULE, "a map for each mode is expected, and `matrix` or `matrices`");
    let form = |mode: &&str| match c.matrix.as_ref().or_else(|| c.matrices.0.get(*mode)) {
        Some(triangle) => symmetric(RULE, triangle, size),
        None => fault(RULE, format!("no matrix of mode `{mode:.40}`")),
    };
    let forms = system.modes.keys().map(form).collect::<Result<Vec<_>>>()?;
    let targets = if c.matrix.is_some() { &forms[..1] } else { &forms[..] };
    let readout = |text: &String| affine(text, &system.state, &system.state);
    let readouts = c.readouts.iter().map(readout).collect::<Result<Vec<_>>>()?;
    // The readouts at the start, as a column, if growth is meant.
    let start: Option<Matrix> = match (&c.rate, &c.start) {
        (Some(rate), None) if (Number::whole(0)..Number::whole(1)).contains(rate) => None,
        (None, Some(start)) => {
            let start = system.placed(RULE, start)?;
            Some(readouts.iter().map(|y| vec![at(y, &start).coefficient(&[])]).collect())
        }
        _ => return fault(RULE, "`rate` in [0, 1), or `start`, is expected"),
    };
    let names: Vec<String> = (0..size).map(|j| format!("y{j}")).collect();
    let coordinates = reals(&names)?;
    let known = reals(names.iter().chain(c.system.parameters.0.keys()))?;
    let meaning: Values<'_> = names.iter().map(String::as_str).zip(readouts.clone()).collect();
    let mut proved = 0;
    for ((mode, made), form) in system.modes.iter().zip(&forms) {
        let written = c.maps.0.get(*mode).map_or(&[][..], Vec::as_slice);
        let map =
            written.iter().map(|t| affine(t, &known, &coordinates)).collect::<Result<Vec<_>>>()?;
        let rows = map.len();
        ensure!(rows == size, RULE, "mode `{mode:.40}`: {rows} rows of the map: expected {size}");
        for (j, (row, readout)) in map.iter().zip(&readouts).enumerate() {
            let is = linear(row, &coordinates) && at(row, &meaning) == at(readout, made);
            let what = "is not what a step makes of the readout";
            ensure!(is, RULE, "mode `{mode:.40}`: row {j} of the map {what}");
        }
        let (measures, how) = match &start {
            None => (definite(form, true), "the matrix is not positive definite"),
            Some(y) => {
                (congruent(y, form)[0][0].is_positive(), "the form is not above 0 at the start")
            }
        };
        ensure!(measures, RULE, "mode `{mode:.40}`: {how}");
        let vertices = system.vertices(&map)?;
        let one = start.is_none() || vertices.len() == 1;
        ensure!(one, RULE, "mode `{mode:.40}`: growth is shown for one value of each parameter");
        for (vertex, map) in vertices.iter().enumerate() {
            let a: Matrix = map.iter().map(|row| coefficients(row, &names).1).collect();
            for target in targets {
                let moved = congruent(&a, target);
                let (left, way) = match &c.rate {
                    Some(c) => (difference(&(c * c), form, &moved), "does not fall by the rate"),
                    None => (difference(&Number::whole(1), &moved, form), "may fall"),
                };
                let kept = definite(&left, false);
                ensure!(kept, RULE, "mode `{mode:.40}`: vertex {vertex}: the form {way}");
                proved += 1;
            }
        }
    }
    let modes = if system.modes.len() > 1 { ", whatever mode acts in each step" } else { "" };
    let said = match (&c.rate, &c.start) {
        (Some(rate), _) => format!(
            "from every start{modes}: these tend to 0 (in each step a quadratic norm of them falls to {rate} of it at most)"
        ),
        (None, start) => {
            let start = system.start(start.iter().flatten());
            format!("from {start}{modes}: these do not all tend to 0")
        }
    };
    let words = system.words(STEPS, &Named::default(), &[]);
    Ok((format!("{words}\n  proved {said}: {}", joined(readouts, ", ")), proved))
}

/// Whether each monomial has one of the coordinates.
fn linear(row: &Poly, coordinates: &Signature) -> bool {
    row.terms().all(|(m, _)| m.iter().any(|a| coordinates.knows(a)))
}
