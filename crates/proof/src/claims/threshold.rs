//! The critical value of a parameter: on one side a proof, on the other a counterexample.

use num_traits::One;
use serde_json::Value;

use super::certificate::{certified, counterexample, within_limits};
use super::{PROOF, Unproved, constants_up_to, converge, prove_with, refute_with};
use cordon_core::exact::{fraction, shortened};
use cordon_core::linear::simplest::strictly_between;
use cordon_core::system::System;
use cordon_core::{Error, Rational, Result, progress};

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
    /// The certificates of both, where there are some.
    pub certificates: [Option<Value>; 2],
    /// A value between at which neither was found, where that ended the search.
    pub open: Option<Rational>,
    /// Whether the search ended since its work was used up.
    pub used_up: bool,
}

/// Steps up to which counterexamples are searched.
const STEPS: usize = 40;

/// Most work at all values together, where nothing else is said, and at one of them: near the critical value
/// neither proof nor counterexample may be found.
pub const WORK: u64 = 600_000_000;
const WORK_AT_ONE: u64 = 150_000_000;

/// The system with one value of a parameter.
pub fn with(system: &System, parameter: usize, value: &Rational) -> System {
    let mut system = system.clone();
    if let Some(p) = system.parameters.get_mut(parameter) {
        (p.low, p.high) = (value.clone(), value.clone());
    }
    system
}

/// What is known at one value, and by what.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decided {
    /// What.
    pub known: Known,
    /// The certificate, accepted by the checker; of what fails none where it is beyond the checker's limits, or
    /// where a step moves the targets.
    pub certificate: Option<Value>,
}

impl Decided {
    fn new(known: Known, certificate: Option<Value>) -> Self {
        Self { known, certificate }
    }

    const OPEN: Self = Self { known: Known::Open, certificate: None };
}

/// What is known of a system whose constants have ranges: it holds for all, or fails for some; with as much
/// work in linear programs as there is, and what is left of it stays.
///
/// # Errors
/// The checker rejects what was found.
pub fn decided(system: &System, property: Property, work: &mut u64) -> Result<Decided> {
    match property {
        Property::Claims => claims_decided(system, work),
        Property::Convergence => Ok(if let Some(found) = converge::contraction(system)? {
            Decided::new(Known::Holds, Some(found.certificate))
        } else if let Some(found) = converge::grows(system)? {
            Decided::new(Known::Fails, Some(found.certificate))
        } else if converge::unfixed(system).is_some() {
            Decided::new(Known::Fails, None)
        } else {
            Decided::OPEN
        }),
    }
}

fn claims_decided(system: &System, work: &mut u64) -> Result<Decided> {
    let mut given = WORK_AT_ONE.min(*work);
    *work -= given;
    let proved = prove_with(system, &PROOF, &mut given);
    *work += given;
    let run = match proved {
        Ok(found) => {
            let certificate = certified(&found)?.ok();
            let known = if certificate.is_some() { Known::Holds } else { Known::Open };
            return Ok(Decided::new(known, certificate));
        }
        Err(Unproved::Fails(run)) => Some(*run),
        Err(Unproved::Open(_)) => {
            let mut given = WORK_AT_ONE.min(*work);
            *work -= given;
            let some = constants_up_to(system, 4);
            let (run, _) = refute_with(system, &some, None, STEPS, &mut given);
            *work += given;
            run
        }
    };
    Ok(match run {
        Some(run) => {
            let certificate = counterexample(system, &run)
                .ok_or_else(|| Error::internal("a counterexample without a certificate"))?;
            Decided::new(Known::Fails, within_limits(certificate)?.ok())
        }
        None => Decided::OPEN,
    })
}

/// The critical value of a parameter in its range, to so many decimal places. `None` where the property
/// does not hold at one end of the range and fail at the other; what is known at both ends comes with it.
/// At all values together it takes as much work as there is, in the unit of [`cordon_core::simplex::Work`].
///
/// # Errors
/// The checker rejects what was found.
pub fn critical(
    system: &System,
    parameter: usize,
    property: Property,
    digits: usize,
    mut work: u64,
) -> Result<(Option<Bracket>, [Known; 2])> {
    let Some(p) = system.parameters.get(parameter) else { return Ok((None, [Known::Open; 2])) };
    let mut at = |value: &Rational| {
        progress::tries(format!("{} = {}", p.name, shortened(&fraction(value))));
        let found = decided(&with(system, parameter, value), property, &mut work)?;
        Ok::<_, Error>((found, work == 0))
    };
    let (low, high) = (at(&p.low)?.0, at(&p.high)?.0);
    let ends = [low.known, high.known];
    let (mut holds, mut fails, mut certificates) = match ends {
        [Known::Holds, Known::Fails] => {
            (p.low.clone(), p.high.clone(), [low.certificate, high.certificate])
        }
        [Known::Fails, Known::Holds] => {
            (p.high.clone(), p.low.clone(), [high.certificate, low.certificate])
        }
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
            match found.known {
                Known::Holds => {
                    (holds, certificates[0], moved) = (value, found.certificate, true);
                }
                Known::Fails => {
                    (fails, certificates[1], moved) = (value, found.certificate, true);
                }
                Known::Open => left_open = true,
            }
        }
        match (&open, moved) {
            (None, false) if left_open => open = Some(middle),
            (Some(_), false) => break,
            _ => {}
        }
    }
    Ok((Some(Bracket { holds, fails, certificates, open, used_up }), ends))
}

/// The simplest fraction in the middle half between two numbers, in either order.
fn between(a: &Rational, b: &Rational) -> Option<Rational> {
    let quarter = (b - a) / Rational::from_integer(4.into());
    let (near, far) = (a + &quarter, b - &quarter);
    if near < far { strictly_between(&near, &far) } else { strictly_between(&far, &near) }
}
