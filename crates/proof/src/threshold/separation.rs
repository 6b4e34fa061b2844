//! The largest gain with which drones in flight keep their gaps, from both sides: a cone below, a
//! negative sample of the response above.

use cordon_core::{Rational, Result};
use num_bigint::BigInt;
use num_traits::Pow;
use serde_json::Value;

use crate::certificate::judged;
use crate::separation::{Cone, Finding, Negative, Response, decide, negative, nonnegative};

/// A gain, the result at this gain, and its certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Side<T> {
    /// The gain lambda_P, in 1/s.
    pub gain: Rational,
    /// The certificate or the negative sample at this gain.
    pub found: T,
    /// The certificate, accepted by the independent checker.
    pub certificate: Value,
}

/// The result among gains that are multiples of 10^-digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bracket {
    /// The largest gain for which a cone was found.
    pub below: Option<Side<Cone>>,
    /// The smallest gain for which a sample is negative.
    pub above: Option<Side<Negative>>,
}

/// The bracket among gains up to `most`. `respond` returns the response for a gain: below, all its
/// readouts must be nonnegative; above, the negative sample is that of its first readout and start.
///
/// Both sides are facts about the two gains; only the bisection assumes that larger gains are worse.
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
    // One bisection per side.
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
