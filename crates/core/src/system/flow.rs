//! Systems in continuous time.

use std::collections::BTreeMap;

use num_traits::Zero;

use super::System;
use crate::exact::shortened;
use crate::linear::feasible::Sign;
use crate::{Error, Rational, Result};

/// A system in continuous time: its modes give the derivative of the state instead of the next state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flow {
    /// The modes, starts and claims; the schedule gives the order of the modes where they act in turn.
    pub system: System,
    /// When the active mode may change.
    pub switching: Switching,
}

/// When modes change; times are in the unit of time of the derivatives, seconds by convention.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Switching {
    /// At any time, arbitrarily often.
    Any,
    /// Once active, a mode stays active for at least this time.
    Dwell(Rational),
    /// The modes act in turn, each for this time.
    Every(Rational),
}

/// Most corners of a start box.
const MOST_CORNERS: usize = 1 << 10;

impl Flow {
    /// The corners of the box in which a run starts.
    ///
    /// # Errors
    /// The assumptions on the start are no box, or an empty one.
    pub fn corners(&self) -> Result<Vec<Vec<Rational>>> {
        let system = &self.system;
        let mut ends: BTreeMap<(usize, bool), Rational> = BTreeMap::new();
        for predicate in &system.starts {
            let (constant, coefficients) = predicate.is.form.parts().unzip();
            let nonzero = coefficients
                .unwrap_or_default()
                .iter()
                .enumerate()
                .filter(|(_, c)| !c.is_zero())
                .collect::<Vec<_>>();
            let ([(j, c)], Some(constant)) = (nonzero.as_slice(), constant) else {
                return Err(Error::input(format!(
                    "start: `{}`: expected bounds of single variables: in continuous time starts are a box",
                    shortened(&predicate.text)
                )));
            };
            // c x + constant >= 0.
            let end = -(constant / *c);
            let is_lower = **c > Rational::zero();
            let sides: &[bool] =
                if predicate.is.sign == Sign::Zero { &[false, true] } else { &[is_lower] };
            for &lower in sides {
                let tighter = |old: &Rational| if lower { end > *old } else { end < *old };
                if ends.get(&(*j, lower)).is_none_or(tighter) {
                    ends.insert((*j, lower), end.clone());
                }
            }
        }
        let mut corners = vec![Vec::new()];
        for (j, name) in system.state.iter().enumerate() {
            let (Some(low), Some(high)) = (ends.get(&(j, true)), ends.get(&(j, false))) else {
                return Err(Error::input(format!(
                    "start: `{name}` has no bounds: expected two, or a value"
                )));
            };
            if low > high {
                return Err(Error::input(format!(
                    "start: `{name}` is at least {low} and at most {high}: expected a start that there is"
                )));
            }
            let sides = if low == high { vec![low] } else { vec![low, high] };
            corners = corners
                .iter()
                .flat_map(|corner: &Vec<Rational>| {
                    sides
                        .iter()
                        .map(move |side| corner.iter().cloned().chain([(*side).clone()]).collect())
                })
                .collect();
            if corners.len() > MOST_CORNERS {
                return Err(Error::input(format!(
                    "start: expected a box of at most {MOST_CORNERS} corners"
                )));
            }
        }
        Ok(corners)
    }
}
