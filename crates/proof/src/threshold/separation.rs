//! The largest gain with which drones in flight keep their gaps, from both sides: a cone below,
//! a negative sample of the response above.

use std::collections::BTreeMap;

use cordon_core::{Rational, Result};
use num_bigint::BigInt;
use num_traits::Pow;

use crate::certificate::accepted;
use crate::separation::{Cone, Finding, Negative, Response, decide, negative, nonnegative};

/// What was found of gains that are multiples of 10^-digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bracket {
    /// The largest one for which a cone was found, with the response.
    pub below: Option<(Rational, Response, Cone)>,
    /// The smallest one above for which a sample is negative.
    pub above: Option<(Rational, Response, Negative)>,
}

/// The bracket among gains up to `most`. `respond` has the response with a gain: its readouts are
/// all that may not be negative below, its first readout and start are those of the sample above.
///
/// Both sides are facts about the two gains; that one halves towards them takes for granted that
/// larger gains are worse.
///
/// # Errors
/// `respond` fails.
pub fn bracket(
    most: &Rational,
    digits: usize,
    respond: impl Fn(&Rational) -> Result<Response>,
) -> Result<Bracket> {
    let unit = Rational::from_integer(BigInt::from(10).pow(digits)).recip();
    let gain = |n: &BigInt| Rational::from_integer(n.clone()) * &unit;
    let last = (most / &unit).floor().to_integer();
    let mut cones: BTreeMap<BigInt, (Rational, Response, Cone)> = BTreeMap::new();
    let (mut lo, mut hi) = (BigInt::from(0), last.clone() + 1);
    while &hi - &lo > BigInt::from(1) {
        let middle = (&lo + &hi) / 2;
        let response = respond(&gain(&middle))?;
        match decide(&response) {
            // A certificate beyond what the checker reads is none.
            Finding::NonNegative(cone) if accepted(&nonnegative(&response, &cone)) => {
                cones.insert(middle.clone(), (gain(&middle), response, cone));
                lo = middle;
            }
            _ => hi = middle,
        }
    }
    let below = cones.remove(&lo);
    let mut samples: BTreeMap<BigInt, (Rational, Response, Negative)> = BTreeMap::new();
    hi = last + 1;
    while &hi - &lo > BigInt::from(1) {
        let middle = (&lo + &hi) / 2;
        let mut response = respond(&gain(&middle))?;
        response.readouts.truncate(1);
        response.starts.truncate(1);
        match decide(&response) {
            Finding::Negative(sample) if accepted(&negative(&response, &sample)) => {
                samples.insert(middle.clone(), (gain(&middle), response, sample));
                hi = middle;
            }
            _ => lo = middle,
        }
    }
    Ok(Bracket { below, above: samples.remove(&hi) })
}
