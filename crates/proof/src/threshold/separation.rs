//! The largest gain with which drones in flight keep their gaps, from both sides: a cone below,
//! a negative sample of the response above.

use cordon_core::{Rational, Result};
use num_bigint::BigInt;
use num_traits::Pow;
use serde_json::Value;

use crate::certificate::judged;
use crate::separation::{Cone, Finding, Negative, Response, decide, negative, nonnegative};

/// A gain with what was found there, and its certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Side<T> {
    /// The gain lambda_P, in 1/s.
    pub gain: Rational,
    /// The certificate or the negative sample at this gain.
    pub found: T,
    /// What the independent checker has accepted.
    pub certificate: Value,
}

/// What was found of gains that are multiples of 10^-digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bracket {
    /// The largest one for which a cone was found.
    pub below: Option<Side<Cone>>,
    /// The smallest one for which a sample is negative.
    pub above: Option<Side<Negative>>,
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
    let last = (most / &unit).floor().to_integer();
    // From one side what was found there, from the other nothing.
    let mut below = None;
    let (mut lo, mut hi) = (BigInt::from(0), last.clone() + 1);
    while &hi - &lo > BigInt::from(1) {
        let middle: BigInt = (&lo + &hi) / 2;
        let gain = Rational::from_integer(middle.clone()) * &unit;
        match kept(&respond(&gain)?) {
            Some((found, certificate)) => {
                below = Some(Side { gain, found, certificate });
                lo = middle;
            }
            None => hi = middle,
        }
    }
    let mut above = None;
    hi = last + 1;
    while &hi - &lo > BigInt::from(1) {
        let middle: BigInt = (&lo + &hi) / 2;
        let gain = Rational::from_integer(middle.clone()) * &unit;
        match lost(respond(&gain)?) {
            Some((found, certificate)) => {
                above = Some(Side { gain, found, certificate });
                hi = middle;
            }
            None => lo = middle,
        }
    }
    Ok(Bracket { below, above })
}

fn kept(response: &Response) -> Option<(Cone, Value)> {
    let Finding::NonNegative(cone) = decide(response) else { return None };
    let page = nonnegative(response, &cone).filter(|page| judged(page).is_ok())?;
    Some((cone, page))
}

fn lost(mut response: Response) -> Option<(Negative, Value)> {
    response.readouts.truncate(1);
    response.starts.truncate(1);
    let Finding::Negative(sample) = decide(&response) else { return None };
    let page = negative(&response, &sample).filter(|page| judged(page).is_ok())?;
    Some((sample, page))
}
