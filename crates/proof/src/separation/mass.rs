//! Bounds on the negative part of a response, and on the sum of its magnitudes.
//!
//! The first samples are executed; the rest is bounded by a geometric sequence: with an additional
//! state variable s, s' = rate s, both s - y and s + y are never negative for every readout y, which is
//! shown by a cone as for any other response.

use cordon_core::Rational;
use cordon_core::linear::matrix::{Matrix, dot};
use num_bigint::BigInt;
use num_traits::{One, Pow, Signed, Zero};

use super::cone;
use super::modes::modes;
use super::path::{Entry, Path, entry};
use super::{Cone, Response};

/// Bounds on the negative part of a response, and on all of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mass {
    /// An upper bound on the sum of the magnitudes of the negative samples of a readout.
    pub negative: Rational,
    /// An upper bound on the sum of the magnitudes of all samples.
    pub absolute: Rational,
    /// Number of samples that were executed.
    pub samples: usize,
    /// The part of the bound that covers all later samples.
    pub tail: Rational,
    /// Sample k is at most `scale rate^k` in magnitude.
    pub scale: Rational,
    /// The factor by which the tail shrinks in `block` samples, below 1.
    pub rate: Rational,
    /// The system with s in its state, and the readouts s - y and s + y.
    pub bounded: Response,
    /// The cone that shows that these are never negative.
    pub cone: Cone,
}

/// Decimal places of the bound.
const PLACES: u32 = 9;

/// The tail is to be less than one unit in this decimal place.
const TAIL_PLACES: u32 = 6;

/// Most samples that are executed.
const MOST_SAMPLES: usize = 5_000;

/// The masses of the response to its first start, the largest over its readouts. `None` where the
/// response does not decay, or no bound was found.
pub fn masses(response: &Response) -> Option<Mass> {
    let slowest = modes(&response.matrix, &response.readouts)?.first()?.factor.norm_sqr().sqrt();
    if slowest.is_nan() || slowest >= 1.0 {
        return None;
    }
    let one = Rational::one();
    let steps = Rational::from_float((2.0 / (1.0 - slowest)).ceil())?;
    let rate = &one - steps.recip();
    let (name, start) = response.starts.first()?;
    let mut bounded = with_bound(response, &rate);
    let mut cone = cone::find(&bounded)?;
    // The least scale with which the start is in the cone, rounded up to few digits.
    let needed = cone.rows.iter().map(|row| {
        let (bound, state) = row.split_last()?;
        bound.is_positive().then(|| -dot(state, start) / bound)
    });
    let scale = needed.collect::<Option<Vec<_>>>()?.into_iter().max()?;
    let scale = rounded_up(&scale, PLACES);
    let state = start.iter().cloned().chain([scale.clone()]).collect();
    bounded.starts = vec![(name.clone(), state)];
    let Entry::At(0) = entry(&bounded, Some(&cone.rows), 0) else {
        return None;
    };
    cone.entered = 0;
    let wanted = Rational::new(BigInt::one(), BigInt::from(10).pow(TAIL_PLACES));
    let mut tail = &scale * &steps;
    let mut samples = 0;
    while tail > wanted && samples < MOST_SAMPLES {
        tail = rounded_up(&(tail * &rate), 2 * PLACES);
        samples += 1;
    }
    let mut path = Path::new(&response.matrix, start);
    let mut sums = vec![[Rational::zero(), Rational::zero()]; response.readouts.len()];
    // Bounds the error of rounding the samples down.
    let rounded = Rational::new(BigInt::one(), BigInt::from(10).pow(2 * PLACES));
    for _ in 0..samples {
        for (sums, sample) in sums.iter_mut().zip(path.values(&response.readouts, 2 * PLACES)) {
            let [negative, absolute] = sums;
            *negative += (-&sample).max(Rational::zero());
            *absolute += sample.abs() + &rounded;
        }
        path.step();
    }
    let most = |side: usize| {
        let executed = sums.iter().filter_map(|sums| sums.get(side)).max()?;
        Some(rounded_up(&(executed + &tail), PLACES))
    };
    let (negative, absolute) = (most(0)?, most(1)?);
    Some(Mass { negative, absolute, samples, tail, scale, rate, bounded, cone })
}

fn with_bound(response: &Response, rate: &Rational) -> Response {
    let zero = Rational::zero();
    let extended = |row: &Vec<Rational>, last: &Rational| -> Vec<Rational> {
        row.iter().cloned().chain([last.clone()]).collect()
    };
    let mut matrix: Matrix = response.matrix.iter().map(|row| extended(row, &zero)).collect();
    matrix.push(extended(&vec![zero; response.matrix.len()], rate));
    let one = Rational::one();
    let both = |row: &Vec<Rational>| {
        let negated = row.iter().map(|x| -x).collect();
        [extended(&negated, &one), extended(row, &one)]
    };
    let state = response.state.iter().cloned().chain(["s".to_owned()]).collect();
    let readouts = response.readouts.iter().flat_map(both).collect();
    Response { state, matrix, starts: Vec::new(), readouts }
}

/// The next multiple of 10^-places.
fn rounded_up(x: &Rational, places: u32) -> Rational {
    let unit = Rational::from_integer(BigInt::from(10).pow(places));
    (x * &unit).ceil() / unit
}
