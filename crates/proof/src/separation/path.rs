//! The exact states from a start until they enter a cone.

use cordon_core::Rational;
use cordon_core::linear::matrix::Matrix;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Pow, Signed, Zero};

use super::{Negative, Response};

/// A state as integers over one denominator, not in lowest terms: signs do not need that.
pub(super) struct Path {
    matrix: Vec<Vec<BigInt>>,
    by: BigInt,
    state: Vec<BigInt>,
    over: BigInt,
}

/// Numerators over the least common denominator, and that denominator.
fn integral<'a>(numbers: impl Iterator<Item = &'a Rational> + Clone) -> (Vec<BigInt>, BigInt) {
    let over = numbers.clone().fold(BigInt::one(), |over, x| over.lcm(x.denom()));
    (numbers.map(|x| x.numer() * (&over / x.denom())).collect(), over)
}

fn dot(row: &[BigInt], state: &[BigInt]) -> BigInt {
    row.iter().zip(state).filter(|(a, _)| !a.is_zero()).map(|(a, x)| a * x).sum()
}

/// Each row scaled by a positive factor to integers.
fn directions(rows: &Matrix) -> Vec<Vec<BigInt>> {
    rows.iter().map(|row| integral(row.iter()).0).collect()
}

impl Path {
    pub(super) fn new(matrix: &Matrix, start: &[Rational]) -> Self {
        let (numbers, by) = integral(matrix.iter().flatten());
        let matrix = numbers.chunks(start.len().max(1)).map(<[BigInt]>::to_vec).collect();
        let (state, over) = integral(start.iter());
        Self { matrix, by, state, over }
    }

    pub(super) fn step(&mut self) {
        self.state = self.matrix.iter().map(|row| dot(row, &self.state)).collect();
        self.over *= &self.by;
    }

    pub(super) fn state(&self) -> Vec<Rational> {
        self.state.iter().map(|x| Rational::new(x.clone(), self.over.clone())).collect()
    }

    /// The values of these forms, each rounded down to a multiple of 10^-places.
    pub(super) fn values(&self, rows: &Matrix, places: u32) -> Vec<Rational> {
        let ten: BigInt = BigInt::from(10).pow(places);
        let value = |row: &Vec<Rational>| {
            let (row, by) = integral(row.iter());
            let scaled = (dot(&row, &self.state) * &ten).div_floor(&(&self.over * by));
            Rational::new(scaled, ten.clone())
        };
        rows.iter().map(value).collect()
    }

    /// The first row that is negative at this state.
    fn negative(&self, rows: &[Vec<BigInt>]) -> Option<usize> {
        rows.iter().position(|row| dot(row, &self.state).is_negative())
    }
}

/// Where the runs from the starts lead.
pub(super) enum Entry {
    /// All are in the cone from this step on, and no readout was negative before.
    At(usize),
    /// A readout is negative first.
    Negative(Negative),
    /// Neither, within the steps that were allowed.
    Nowhere,
}

/// Follows the starts until no row is negative, for at most `most` steps; without rows, until a readout
/// is negative.
pub(super) fn entry(response: &Response, rows: Option<&Matrix>, most: usize) -> Entry {
    let readouts = directions(&response.readouts);
    let rows = rows.map(directions);
    let mut last = 0;
    for (start, (_, state)) in response.starts.iter().enumerate() {
        let mut path = Path::new(&response.matrix, state);
        let mut entered = false;
        for step in 0..=most {
            if let Some(readout) = path.negative(&readouts) {
                let value =
                    cordon_core::linear::matrix::dot(&response.readouts[readout], &path.state());
                return Entry::Negative(Negative { start, step, readout, value });
            }
            entered = rows.as_ref().is_some_and(|rows| path.negative(rows).is_none());
            if entered {
                last = last.max(step);
                break;
            }
            path.step();
        }
        if !entered && rows.is_some() {
            return Entry::Nowhere;
        }
    }
    if rows.is_some() { Entry::At(last) } else { Entry::Nowhere }
}
