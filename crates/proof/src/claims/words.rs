//! Several steps as one: a round of modes that act in turn, or choices that a run makes over and over.

use std::collections::BTreeSet;

use super::converge::grows_or_stays;
use super::doubles::Matrix;
use super::readouts::{self, Readouts};
use super::search::Choice;
use cordon_core::exact::to_f64;
use cordon_core::scalar::Polynomial;
use cordon_core::system::{Mode, Parameter, ParameterKind, Schedule, System};
use cordon_core::{Rational, Result};

/// Most words that are tried for one choice of the constants, and most of them times the cube of the readouts.
const MOST_WORDS: usize = 1_000;
const MOST_ENTRIES: usize = 400_000_000;

/// Most steps of a word where any mode may act.
const LONGEST: usize = 6;

/// Most ways to choose in a step that are all tried; of more, that with every parameter at its lowest and
/// that with every one at its highest.
const MOST_OPTIONS: usize = 64;

/// The system whose step is these steps, one after another.
///
/// # Errors
/// There is none where the choices are of the system.
pub fn as_one_step(system: &System, word: &[Choice]) -> Result<System> {
    let mut one = System { schedule: Schedule::Any, ..system.clone() };
    let modes = || word.iter().filter_map(|c| Some((system.modes.get(c.mode)?, c)));
    if let ([choice], true) = (word, system.is_deterministic()) {
        one.modes = modes().map(|(mode, _)| mode.clone()).collect();
        for (p, value) in one.parameters.iter_mut().zip(&choice.values) {
            (p.low, p.high) = (value.clone(), value.clone());
        }
        return Ok(one);
    }
    let names: Vec<&str> = modes().map(|(mode, _)| mode.name.as_str()).collect();
    one.parameters.clear();
    one.modes =
        vec![Mode::executed(&names.join(", "), system.state.len(), &[], |number, _, x| {
            modes().fold(x.to_vec(), |x, (mode, choice)| {
                let values: Vec<_> = choice.values.iter().map(number).collect();
                mode.step(&number, &values, &x)
            })
        })?];
    Ok(one)
}

/// The words that a run may repeat for ever and under which what has to vanish may not, the shortest
/// first; as far as doubles tell. The constants have these values.
///
/// # Errors
/// There is none: a step stays affine.
pub fn that_may_not_vanish(system: &System, constants: &[Rational]) -> Result<Vec<Vec<Choice>>> {
    let Some(readouts) = Readouts::of(system) else { return Ok(Vec::new()) };
    // Whether the targets stay may depend on what is chosen: a way to choose by which they move is left out.
    let option = |choice: Choice| {
        let one = as_one_step(system, std::slice::from_ref(&choice))?;
        let rows = one.modes.first().and_then(|mode| readouts.quotient(mode));
        Ok(rows.map(|rows| {
            let map = readouts::at(&rows, &choice.values);
            let map = map.iter().map(|row| row.iter().map(to_f64).collect()).collect();
            (choice, map)
        }))
    };
    let of_mode = |mode: usize| {
        let corners = corners(system, constants, mode).into_iter();
        let options = corners.map(|values| option(Choice { mode, values }));
        Ok(options.collect::<Result<Vec<_>>>()?.into_iter().flatten().collect::<Vec<_>>())
    };
    let options = (0..system.modes.len()).map(of_mode).collect::<Result<Vec<_>>>()?;
    let all: Vec<&(Choice, Matrix)> = options.iter().flatten().collect();
    let most = (MOST_ENTRIES / readouts.all.len().pow(3).max(1)).clamp(1, MOST_WORDS);
    let words = match &system.schedule {
        Schedule::Any => words_of(&all, most),
        Schedule::Cycle(list) => rounds(&options, list, most),
    };
    let grows = |word: &&Vec<&(Choice, Matrix)>| {
        grows_or_stays(&word.iter().map(|(_, map)| map).collect::<Vec<_>>())
    };
    let choices = |word: &Vec<&(Choice, Matrix)>| word.iter().map(|(c, _)| c.clone()).collect();
    Ok(words.iter().filter(grows).map(choices).collect())
}

/// The values of the parameters in a step of a mode: these constants, and of what varies the ends.
fn corners(system: &System, constants: &[Rational], mode: usize) -> Vec<Vec<Rational>> {
    let rows = (0..system.state.len()).filter_map(|j| system.modes.get(mode)?.row(j));
    let occurring: BTreeSet<usize> = rows
        .flat_map(|(constant, entries)| entries.values().chain([constant]))
        .flat_map(Polynomial::terms)
        .flat_map(|(monomial, _)| monomial.powers().map(|(v, _)| v as usize))
        .collect();
    let varies = |p: &Parameter| p.kind != ParameterKind::Constant && p.fixed().is_none();
    let varying = system.parameters.iter().enumerate();
    let varying: Vec<usize> =
        varying.filter(|(j, p)| varies(p) && occurring.contains(j)).map(|(j, _)| j).collect();
    let with = |is_high: &dyn Fn(usize) -> bool| {
        let mut values = constants.to_vec();
        for (index, &j) in varying.iter().enumerate() {
            if let (Some(slot), Some(p)) = (values.get_mut(j), system.parameters.get(j)) {
                *slot = if is_high(index) { p.high.clone() } else { p.low.clone() };
            }
        }
        values
    };
    let count = u32::try_from(varying.len()).ok().and_then(|n| 1_usize.checked_shl(n));
    match count.filter(|&count| count <= MOST_OPTIONS) {
        Some(count) => (0..count).map(|bits| with(&|index| bits >> index & 1 == 1)).collect(),
        None => vec![with(&|_| false), with(&|_| true)],
    }
}

/// Words of any of these in each step; of those that are a word repeated, or begin elsewhere in it, one.
fn words_of<'o, T>(options: &[&'o T], most: usize) -> Vec<Vec<&'o T>> {
    let mut words: Vec<Vec<usize>> = Vec::new();
    let mut longer: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..LONGEST {
        if longer.len().saturating_mul(options.len()) > most {
            break;
        }
        longer = longer
            .iter()
            .flat_map(|w| (0..options.len()).map(move |o| w.iter().copied().chain([o]).collect()))
            .collect();
        words.extend(longer.iter().filter(|w| is_first_turn(w)).cloned());
    }
    words.iter().map(|w| w.iter().filter_map(|&o| options.get(o).copied()).collect()).collect()
}

/// Whether a word comes before everything that begins later in it and goes on at its front.
fn is_first_turn(word: &[usize]) -> bool {
    (1..word.len()).all(|k| word[k..].iter().chain(&word[..k]).gt(word))
}

/// Rounds of modes in turn, with any choices; where those are too many, with alike ones in all steps.
fn rounds<'o, T>(options: &'o [Vec<T>], list: &[usize], most: usize) -> Vec<Vec<&'o T>> {
    let turn: Vec<&Vec<T>> = list.iter().filter_map(|&m| options.get(m)).collect();
    let count = turn.iter().try_fold(1_usize, |n, o| n.checked_mul(o.len()));
    if count.is_none_or(|count| count > most) {
        let alike = turn.iter().map(|o| o.len()).min().unwrap_or(0);
        return (0..alike).map(|k| turn.iter().filter_map(|o| o.get(k)).collect()).collect();
    }
    turn.iter().fold(vec![Vec::new()], |words, options| {
        let then = |w: &Vec<&'o T>| {
            let w = w.clone();
            options.iter().map(move |o| w.iter().copied().chain([o]).collect::<Vec<_>>())
        };
        words.iter().flat_map(then).collect()
    })
}
