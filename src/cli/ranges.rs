//! Ranges as arguments: `5`, `3..7`, `0..1/2`.

use cordon_core::exact::{self, Rational};
use cordon_core::{Error, Result};

/// Fewest drones of a swarm.
const FEWEST: usize = 3;

/// The numbers of drones of `N` or `LO..HI`, both ends included, from 3 to `most`.
///
/// # Errors
/// Something else, an empty range, or a number out of bounds.
pub fn drones(text: &str, most: usize) -> Result<Vec<usize>> {
    let number = |part: &str| -> Result<usize> {
        part.trim().parse().ok().filter(|n| (FEWEST..=most).contains(n)).ok_or_else(|| {
            Error::input(format!(
                "drones: `{part}`: expected a number from {FEWEST} to {most}, or a range like 3..7"
            ))
        })
    };
    let (lo, hi) = match text.split_once("..") {
        Some((lo, hi)) => (number(lo)?, number(hi)?),
        None => (number(text)?, number(text)?),
    };
    if lo > hi {
        return Err(Error::input(format!("drones: `{text}`: expected a range that is not empty")));
    }
    Ok((lo..=hi).collect())
}

/// The ends of `X` or `LO..HI`, both included.
///
/// # Errors
/// Something else, or an empty range; `what` names the field.
pub fn interval(what: &str, text: &str) -> Result<(Rational, Rational)> {
    let (lo, hi) = match text.split_once("..") {
        Some((lo, hi)) => (exact::parse(what, lo)?, exact::parse(what, hi)?),
        None => (exact::parse(what, text)?, exact::parse(what, text)?),
    };
    if lo > hi {
        return Err(Error::input(format!("{what}: `{text}`: expected a range that is not empty")));
    }
    Ok((lo, hi))
}
