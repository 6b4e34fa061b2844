//! Targets at which no run can end: a step moves them.

use crate::claims::constants_up_to;
use crate::claims::search::Choice;
use cordon_core::Rational;
use cordon_core::system::{Convergence, ParameterKind, Schedule, System};

/// A step that moves the targets. Where states tend to them, so do the states after such a step to what it
/// makes of the targets: a run with infinitely many of these steps tends to no target.
#[derive(Clone, Debug)]
pub struct Unfixed {
    /// The values of the parameters.
    pub step: Choice,
    /// What it makes of the targets.
    pub image: Vec<Rational>,
}

/// A step that moves the targets, if one of those that are tried does: of every mode that acts, at the ends
/// of the constants' ranges, with what is usually chosen.
pub fn unfixed(system: &System) -> Option<Unfixed> {
    let Some(Convergence::To(targets)) = &system.converges else { return None };
    let acting: Vec<usize> = match &system.schedule {
        Schedule::Any => (0..system.modes.len()).collect(),
        Schedule::Cycle(list) => list.clone(),
    };
    for constants in constants_up_to(system, 0) {
        let of = system.parameters.iter().zip(&constants);
        let values: Vec<Rational> = of
            .map(|(p, value)| match (p.kind, p.fixed()) {
                (ParameterKind::Choice, None) => p.usual().clone(),
                _ => value.clone(),
            })
            .collect();
        for &mode in &acting {
            let image = system.modes.get(mode)?.at(&values).apply(targets);
            if image != *targets {
                return Some(Unfixed { step: Choice { mode, values }, image });
            }
        }
    }
    None
}
