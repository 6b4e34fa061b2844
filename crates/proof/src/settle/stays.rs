//! Runs that stay near the targets without converging: at the weights where |A| stretches
//! nothing and shrinks not everything.

use num_traits::{One, Signed, Zero};

use super::Runs;
use cordon_core::Rational;

/// What becomes of one run that does not converge by force of a contraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stays {
    /// Within the distance from this step on, for ever; and whether the errors vanish in the
    /// limit all the same.
    From(u64, bool),
    /// Outside again and again.
    Never,
}

/// Most steps until the part of the errors that shrinks, by a third a step, is out of the way.
const MOST_STEPS: u64 = 100_000;

/// What becomes of the runs, where it can be told without a contraction: `None` where it cannot.
///
/// An error of 0 stays 0 at every weight. With eps = 0 no drone moves. With N = 3 and eps = 1
/// the one error changes its sign at every step. With N = 4 and eps = 2/3 the sum of the two
/// errors shrinks to a third and their difference changes its sign. There is no other
/// rational weight at which the largest factor of A is exactly 1: it is 1/(1 + cos(pi/(N-1))).
pub(super) fn decide(runs: &Runs, within: &Rational) -> Option<Stays> {
    let each = runs.extremes.iter().map(|start| one(runs, &errors(start), within));
    let all = each.collect::<Option<Vec<Stays>>>()?;
    // Of every start in the segment some does not converge, whatever its extreme ones do.
    let first = Stays::From(0, !runs.every);
    Some(all.into_iter().fold(first, |worst, this| match (worst, this) {
        (Stays::From(a, all), Stays::From(b, this)) => Stays::From(a.max(b), all && this),
        _ => Stays::Never,
    }))
}

fn errors(start: &[Rational]) -> Vec<Rational> {
    let (min, max) = super::ends(start);
    let scale = Rational::from_integer((start.len() - 1).into());
    let error = |i| cordon_spec::placement::scaled_error(&min, &max, start, i) / &scale;
    (1..start.len() - 1).map(error).collect()
}

fn one(runs: &Runs, errors: &[Rational], within: &Rational) -> Option<Stays> {
    if errors.iter().all(Zero::is_zero) {
        return Some(Stays::From(0, true));
    }
    let one = Rational::one();
    let inside = |e: &Rational| e.abs() <= *within;
    match (errors, &runs.eps) {
        ([_], eps) if *eps == one => {}
        (_, eps) if eps.is_zero() => {}
        ([a, b], eps) if *eps == Rational::new(2.into(), 3.into()) => {
            return pair(&((a + b) / two()), &((a - b) / two()), within);
        }
        _ => return None,
    }
    let always = errors.iter().all(inside);
    Some(if always { Stays::From(0, false) } else { Stays::Never })
}

fn two() -> Rational {
    Rational::from_integer(2.into())
}

/// Errors s/3^k + d and s/3^k - d, but for the sign of d: the larger is |s|/3^k + |d|.
fn pair(s: &Rational, d: &Rational, within: &Rational) -> Option<Stays> {
    let three = Rational::from_integer(3.into());
    let (mut s, d) = (s.abs(), d.abs());
    if d > *within || (d == *within && !s.is_zero()) {
        return Some(Stays::Never);
    }
    for k in 0..=MOST_STEPS {
        if &s + &d <= *within {
            return Some(Stays::From(k, d.is_zero()));
        }
        s /= &three;
    }
    None
}
