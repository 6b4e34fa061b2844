//! Exact critical weights: the largest weight up to which a property holds, found from the
//! transition relation and bracketed from both sides.

pub mod convergence;
pub mod invariance;
pub mod late;
pub mod safety;
pub mod separation;

use cordon_core::{Error, Result};

/// Fewest drones of a swarm.
pub const FEWEST: usize = 3;

/// Most drones: one certificate of this size is still checked within a second.
pub const MOST: usize = 1_000;

/// Most digits: more than any use needs, and still a matter of seconds.
pub const MOST_DIGITS: usize = 1_000;

/// Checks the number of drones and the number of digits.
///
/// # Errors
/// Either is out of range.
pub fn check_size(count: usize, digits: usize) -> Result<()> {
    if !(FEWEST..=MOST).contains(&count) {
        return Err(Error::input(format!(
            "drones: `{count}`: expected a number from {FEWEST} to {MOST}"
        )));
    }
    if !(1..=MOST_DIGITS).contains(&digits) {
        return Err(Error::input(format!(
            "digits: `{digits}`: expected a number from 1 to {MOST_DIGITS}"
        )));
    }
    Ok(())
}
