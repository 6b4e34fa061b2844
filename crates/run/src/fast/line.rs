//! A line of drones in integers: what the stepping and the jump engine both start from.

use cordon_spec::consensus::exec_consensus;
use cordon_spec::graph::Path;
use cordon_spec::placement::scaled_target;
use cordon_spec::{Params, Scalar};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use cordon_core::stencil::Stencil;
use cordon_core::system::Map;
use cordon_core::{Error, Rational, Result};

/// What a drone beyond the end of the line would look like to the drone at the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The end drones stay where they are (coverage): deviations from the targets continue
    /// oddly beyond them.
    Fixed,
    /// The end drones have one neighbour (consensus on a path): positions continue evenly,
    /// each end drone beside its own mirror image.
    Free,
}

/// A line of drones whose step is one symmetric rule, over common denominators.
///
/// With `D = base` and `Q = den` the position of drone i after k steps is an integer over
/// `D * Q^k`, and a step is `x_i' = (side*x_{i-1} + centre*x_i + side*x_{i+1})/Q`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// Weight of each neighbour, times Q.
    pub side: BigInt,
    /// A drone's weight of its own position, times Q.
    pub centre: BigInt,
    /// The denominator Q of the weights, positive.
    pub den: BigInt,
    /// What happens at the ends.
    pub ends: Ends,
    /// The common denominator D of starts and resting places, positive.
    pub base: BigInt,
    /// D times a placement that the step leaves as it is: the targets (coverage) or 0.
    pub rest: Vec<BigInt>,
    /// D times (start - resting place) of every drone.
    pub deviation: Vec<BigInt>,
}

impl Line {
    /// The coverage protocol (equation 10) on \[min, max\] from `start`. Its rule is read off
    /// the spec; the tick counter limit `p.n` plays no part, k counts protocol steps.
    ///
    /// # Errors
    /// Fewer than 3 drones, or an end drone that does not start at its end.
    pub fn coverage(p: &Params<Rational>, start: &[Rational]) -> Result<Self> {
        let count = start.len();
        let (Some(first), Some(last)) = (start.first(), start.last()) else {
            return Err(too_few(count));
        };
        if count < 3 {
            return Err(too_few(count));
        }
        for (drone, at, end) in [(0, first, &p.min), (count - 1, last, &p.max)] {
            if at != end {
                return Err(Error::input(format!(
                    "start: drone {drone} is at `{at}`: expected `{end}`: the end drones stay at \
                     the ends of the segment"
                )));
            }
        }
        let gaps = Rational::from_index(count - 1);
        let rest: Vec<Rational> =
            (0..count).map(|i| scaled_target(&p.min, &p.max, count, i) / &gaps).collect();
        let LineWeights { side, centre, den } = LineWeights::of(&p.eps)?;
        Ok(Self::assemble(Ends::Fixed, side, centre, den, &rest, start))
    }

    /// Consensus (equation 6) on the path of all drones, from `start`.
    ///
    /// # Errors
    /// Fewer than 3 drones.
    pub fn consensus(eps: &Rational, start: &[Rational]) -> Result<Self> {
        if start.len() < 3 {
            return Err(too_few(start.len()));
        }
        // What the spec does to each unit placement of a path of five, column by column.
        let columns: [[Rational; 5]; 5] = std::array::from_fn(|j| {
            let unit = |i| if i == j { Rational::one() } else { Rational::zero() };
            exec_consensus(eps, &Path { count: 5 }, &std::array::from_fn(unit))
        });
        let [first, second, ..] = &columns;
        let [own_at_end, side, ..] = first;
        let [_, centre, ..] = second;
        let den = side.denom().lcm(centre.denom());
        let as_rule = |i: usize, j: usize| match i.abs_diff(j) {
            0 if i == 0 || i == 4 => own_at_end.clone(),
            0 => centre.clone(),
            1 => side.clone(),
            _ => Rational::zero(),
        };
        let as_expected = columns
            .iter()
            .enumerate()
            .all(|(j, column)| column.iter().enumerate().all(|(i, x)| *x == as_rule(i, j)));
        // An end drone beside its mirror image gets the neighbour's weight for its own.
        if !as_expected || *own_at_end != centre + side {
            return Err(not_a_line());
        }
        let whole = |w: &Rational| w.numer() * (&den / w.denom());
        let rest = vec![Rational::zero(); start.len()];
        Ok(Self::assemble(Ends::Free, whole(side), whole(centre), den.clone(), &rest, start))
    }

    /// The line that a map is, if it is one: every inner drone's row is the same symmetric rule
    /// whose weights sum to 1, and the end drones stay or are beside their own mirror image.
    pub fn of_map(map: &Map, start: &[Rational]) -> Option<Self> {
        let count = start.len();
        if count < 3 || map.rows.len() != count {
            return None;
        }
        let entry = |i: usize, j: usize| {
            let (_, row) = map.rows.get(i)?;
            Some(row.iter().find(|(c, _)| *c == j).map_or_else(Rational::zero, |(_, a)| a.clone()))
        };
        let (side, centre) = (entry(1, 0)?, entry(1, 1)?);
        let is = |i: usize, wanted: &[(usize, &Rational)], constant: &Rational| {
            let wanted = wanted.iter().filter(|(_, a)| !a.is_zero());
            map.rows.get(i).is_some_and(|(b, row)| {
                b == constant && row.iter().map(|(j, a)| (*j, a)).eq(wanted.copied())
            })
        };
        let none = Rational::zero();
        let symmetric =
            (1..count - 1).all(|i| is(i, &[(i - 1, &side), (i, &centre), (i + 1, &side)], &none));
        if !symmetric || &side + &side + &centre != Rational::one() {
            return None;
        }
        let stays = |i: usize| {
            let at = start.get(i).unwrap_or(&none);
            is(i, &[(i, &Rational::one())], &none) || is(i, &[], at)
        };
        let (last, own) = (count - 1, &centre + &side);
        let mirrored = is(0, &[(0, &own), (1, &side)], &none)
            && is(last, &[(last - 1, &side), (last, &own)], &none);
        let (ends, rest) = match (stays(0) && stays(last), mirrored) {
            (true, _) => {
                let gaps = Rational::from_index(last);
                let (min, max) = (start.first()?, start.last()?);
                let rest = (0..count).map(|i| scaled_target(min, max, count, i) / &gaps);
                (Ends::Fixed, rest.collect())
            }
            (false, true) => (Ends::Free, vec![none.clone(); count]),
            (false, false) => return None,
        };
        let den = side.denom().lcm(centre.denom());
        let whole = |w: &Rational| w.numer() * (&den / w.denom());
        Some(Self::assemble(ends, whole(&side), whole(&centre), den.clone(), &rest, start))
    }

    fn assemble(
        ends: Ends,
        side: BigInt,
        centre: BigInt,
        den: BigInt,
        rest: &[Rational],
        start: &[Rational],
    ) -> Self {
        let base =
            rest.iter().chain(start).fold(BigInt::one(), |base, x: &Rational| base.lcm(x.denom()));
        let whole = |x: &Rational| x.numer() * (&base / x.denom());
        let deviation = rest.iter().zip(start).map(|(r, x)| whole(x) - whole(r)).collect();
        let rest = rest.iter().map(whole).collect();
        Self { side, centre, den, ends, base, rest, deviation }
    }

    /// The number of drones N.
    pub fn count(&self) -> usize {
        self.rest.len()
    }

    /// D times the start of every drone.
    pub fn start(&self) -> impl Iterator<Item = BigInt> + '_ {
        self.rest.iter().zip(&self.deviation).map(|(r, d)| r + d)
    }

    /// The sum of the absolute weights: no placement grows faster than by this factor a step.
    pub fn growth(&self) -> BigInt {
        self.side.abs() * 2 + self.centre.abs()
    }
}

/// The weights of the coverage protocol's internal drones over a common denominator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineWeights {
    /// Numerator of the weight of each neighbour.
    pub side: BigInt,
    /// Of the drone itself.
    pub centre: BigInt,
    /// The denominator, positive.
    pub den: BigInt,
}

impl LineWeights {
    /// Reads the weights off the spec, and that the end drones stay at the ends, both
    /// neighbours count alike and all weights sum to 1.
    ///
    /// # Errors
    /// A spec of which that is not so.
    pub fn of(eps: &Rational) -> Result<Self> {
        let stencil = Stencil::of(eps);
        let w = &stencil.internal;
        let ends_stay = [(&stencil.first, 0), (&stencil.last, 1)].iter().all(|(w, end)| {
            w.as_array().iter().enumerate().all(|(input, weight)| {
                if input == *end { **weight == stencil.den } else { weight.is_zero() }
            })
        });
        let symmetric = w.prec == w.foll && w.min.is_zero() && w.max.is_zero();
        let keeps_lines = &w.prec + &w.own + &w.foll == stencil.den;
        if !(ends_stay && symmetric && keeps_lines) {
            return Err(not_a_line());
        }
        let (side, centre) = (w.prec.clone(), w.own.clone());
        Ok(Self { side, centre, den: stencil.den })
    }
}

fn too_few(count: usize) -> Error {
    Error::input(format!("drones: `{count}`: expected at least 3"))
}

fn not_a_line() -> Error {
    Error::internal("the spec's step is no symmetric rule along the line")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn ratio(p: i64, q: i64) -> Rational {
        Rational::new(p.into(), q.into())
    }

    #[test]
    fn weights_and_deviations_of_the_paper() {
        let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(1, 5), n: 0 };
        let line = Line::coverage(&p, &[0, 10, 20, 30, 100].map(|x| ratio(x, 1))).unwrap();
        let int = |x: &BigInt| i64::try_from(x).unwrap();
        assert_eq!((int(&line.side), int(&line.centre), int(&line.den)), (1, 3, 5));
        assert_eq!(line.deviation.iter().map(int).collect::<Vec<_>>(), [0, -15, -30, -45, 0]);
        let flock = Line::consensus(&ratio(3, 10), &[0, 1, 5, 7].map(|x| ratio(x, 2))).unwrap();
        assert_eq!((int(&flock.side), int(&flock.centre), int(&flock.den)), (3, 4, 10));
        assert_eq!(int(&flock.base), 2);
    }

    #[test]
    fn refusals_name_the_drone() {
        let p = Params { min: ratio(0, 1), max: ratio(9, 1), eps: ratio(1, 5), n: 0 };
        let said = |start: &[i64]| {
            let start: Vec<_> = start.iter().map(|&x| ratio(x, 1)).collect();
            Line::coverage(&p, &start).unwrap_err().to_string()
        };
        assert!(said(&[0, 9]).starts_with("drones: `2`"));
        assert!(said(&[1, 2, 9]).starts_with("start: drone 0 is at `1`"));
        assert!(said(&[0, 2, 8]).starts_with("start: drone 2 is at `8`"));
    }
}
