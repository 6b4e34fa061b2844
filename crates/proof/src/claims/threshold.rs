//! The critical value of a parameter: on one side a proof, on the other a counterexample.

use num_traits::One;

use super::{PROOF, Unproved, constants, converge, prove_with, refute_with};
use cordon_core::linear::simplest::strictly_between;
use cordon_core::system::System;
use cordon_core::{Rational, Result};

/// Which property is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Property {
    /// The claims hold at every step they are about.
    Claims,
    /// The system converges as claimed.
    Convergence,
}

/// What is known at one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// It holds, with a certificate.
    Holds,
    /// It fails: an exact run, or a certificate of growth.
    Fails,
    /// Neither was found.
    Open,
}

/// A bracket of the critical value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bracket {
    /// The nearest value found at which the property holds.
    pub holds: Rational,
    /// The nearest value found at which it fails.
    pub fails: Rational,
    /// A value between at which neither was found, where that ended the search.
    pub open: Option<Rational>,
    /// Whether the search ended since its work was used up.
    pub used_up: bool,
}

/// Steps up to which counterexamples are searched.
const STEPS: usize = 40;

/// Most work at all values together, in the unit of [`cordon_core::simplex::Work`], and at one of them: near the critical
/// value neither proof nor counterexample may be found.
const WORK: u64 = 600_000_000;
const WORK_AT_ONE: u64 = 150_000_000;

/// The system with one value of a parameter.
pub fn with(system: &System, parameter: usize, value: &Rational) -> System {
    let mut system = system.clone();
    if let Some(p) = system.parameters.get_mut(parameter) {
        (p.low, p.high) = (value.clone(), value.clone());
    }
    system
}

/// What is known of a system whose constants have ranges: it holds for all, or fails for some; with as much
/// work in linear programs as there is, and what is left of it stays.
///
/// # Errors
/// The checker rejects what was found.
pub fn known(system: &System, property: Property, work: &mut u64) -> Result<Known> {
    Ok(match property {
        Property::Claims => {
            let mut within = |part: u64, find: &mut dyn FnMut(&mut u64) -> Known| {
                let given = part.min(*work);
                let mut left = given;
                let found = find(&mut left);
                *work -= given - left;
                found
            };
            let proved = within(WORK_AT_ONE, &mut |left| match prove_with(system, &PROOF, left) {
                Ok(_) => Known::Holds,
                Err(Unproved::Fails(_)) => Known::Fails,
                Err(Unproved::Open(_)) => Known::Open,
            });
            if proved != Known::Open {
                return Ok(proved);
            }
            let some = constants(system, 4).unwrap_or_default();
            within(WORK_AT_ONE, &mut |left| match refute_with(system, &some, None, STEPS, left) {
                (Some(_), _) => Known::Fails,
                (None, _) => Known::Open,
            })
        }
        Property::Convergence => {
            if converge::contraction(system)?.is_some() {
                Known::Holds
            } else if converge::grows(system)?.is_some() || converge::unfixed(system).is_some() {
                Known::Fails
            } else {
                Known::Open
            }
        }
    })
}

/// The critical value of a parameter in its range, to so many decimal places. `None` where the property
/// does not hold at one end of the range and fail at the other; what is known at both ends comes with it.
///
/// # Errors
/// The checker rejects what was found.
pub fn critical(
    system: &System,
    parameter: usize,
    property: Property,
    digits: usize,
) -> Result<(Option<Bracket>, [Known; 2])> {
    let Some(p) = system.parameters.get(parameter) else { return Ok((None, [Known::Open; 2])) };
    let mut work = WORK;
    let mut at = |value: &Rational| {
        let found = known(&with(system, parameter, value), property, &mut work)?;
        Ok::<_, cordon_core::Error>((found, work == 0))
    };
    let ends = [at(&p.low)?.0, at(&p.high)?.0];
    let (mut holds, mut fails) = match ends {
        [Known::Holds, Known::Fails] => (p.low.clone(), p.high.clone()),
        [Known::Fails, Known::Holds] => (p.high.clone(), p.low.clone()),
        _ => return Ok((None, ends)),
    };
    let ten = Rational::from_integer(10.into());
    let width = (0..digits).fold(Rational::one(), |w, _| w / &ten);
    let (mut open, mut used_up) = (None, false);
    while num_traits::abs(&holds - &fails) > width && !used_up {
        // The simplest fraction in the middle half; where nothing is found there, which is the case at the
        // critical value itself, one on either side of it.
        let Some(middle) = open.clone().or_else(|| between(&holds, &fails)) else { break };
        let tried = match open {
            None => vec![middle.clone()],
            Some(_) => {
                [between(&holds, &middle), between(&middle, &fails)].into_iter().flatten().collect()
            }
        };
        let (mut moved, mut left_open) = (false, false);
        for value in tried {
            let (found, is_last) = at(&value)?;
            used_up |= is_last;
            match found {
                Known::Holds => (holds, moved) = (value, true),
                Known::Fails => (fails, moved) = (value, true),
                Known::Open => left_open = true,
            }
        }
        match (&open, moved) {
            (None, false) if left_open => open = Some(middle),
            (Some(_), false) => break,
            _ => {}
        }
    }
    Ok((Some(Bracket { holds, fails, open, used_up }), ends))
}

/// The simplest fraction in the middle half between two numbers, in either order.
fn between(a: &Rational, b: &Rational) -> Option<Rational> {
    let quarter = (b - a) / Rational::from_integer(4.into());
    let (near, far) = (a + &quarter, b - &quarter);
    if near < far { strictly_between(&near, &far) } else { strictly_between(&far, &near) }
}
