//! The starts of a theorem as combinations of finitely many generators.
//!
//! Drones 0 and N-1 are at the segment's ends, so that a start *is* a vector of N positions,
//! segment included, and one protocol step is linear in it. What the theorems say is unchanged
//! when a start is shifted or scaled (up to a factor), so that starts matter up to a shift.
//! Each start set of the spec then is a set of combinations `sum of a_r * r` of generators r,
//! every coefficient in its own range, independently of the others:
//!
//! | start set | coordinates | generators |
//! |---|---|---|
//! | ordered | the gaps g_0 .. g_{N-2}, all > 0 | gap i is 1, the others 0 |
//! | first subsegment | g_0 .. g_{N-3} and min + l - X_{N-2}, all > 0 (the last gap is positive then) | one coordinate is 1 or N-1, the others 0 |
//! | upper bounded | l > 0, errors e_1 .. e_{N-2} >= 0 | all at the targets, l = 1; error i is 1, l = 0 |
//! | any | l > 0, e_1 .. e_{N-2} any real numbers | the same |
//!
//! For a linear functional f that shifts do not change:
//!
//! * f >= 0 of every start iff f(r) >= 0 for every generator, and f(r) = 0 where the
//!   coefficient may have either sign;
//! * f > 0 of every start iff, beside that, f(r) > 0 for some generator whose coefficient is
//!   positive (the other coefficients may all be 0);
//! * f = 0 of every start iff f(r) = 0 for every generator.
//!
//! The generators themselves need not be starts: they lie on the border of the set (two drones
//! in one place, a segment without length), where f is defined all the same.

use cordon_spec::theorems::StartSet;
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

/// The range of a generator's coefficient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coefficient {
    /// Any number above 0.
    Positive,
    /// Any number from 0 on.
    NonNegative,
    /// Any real number.
    Free,
}

/// A generator of a start set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Generator {
    /// Positions of the N drones.
    pub placement: Vec<BigInt>,
    /// The range of its coefficient.
    pub coefficient: Coefficient,
}

/// The generators of a start set for `count >= 3` drones.
pub fn generators(starts: StartSet, count: usize) -> Vec<Generator> {
    match starts {
        StartSet::Ordered => (1..count)
            .map(|i| Generator {
                // Everything from drone i on is 1 further: gap i-1.
                placement: (0..count).map(|j| u8::from(j >= i).into()).collect(),
                coefficient: Coefficient::Positive,
            })
            .collect(),
        StartSet::FirstSubsegment => {
            let gaps = count - 1;
            let last_at = |x: usize| move |j: usize| if j == gaps { Some(x) } else { None };
            // The segment's length alone, then each gap before the last internal drone with
            // that drone exactly at min + l.
            let length = (0..count).map(|j| last_at(1)(j).unwrap_or(0).into()).collect();
            let gap = |i: usize| {
                let at = last_at(gaps);
                (0..count).map(|j| at(j).unwrap_or(usize::from(j >= i)).into()).collect()
            };
            std::iter::once(length)
                .chain((1..gaps).map(gap))
                .map(|placement| Generator { placement, coefficient: Coefficient::Positive })
                .collect()
        }
        StartSet::UpperBounded => by_errors(count, Coefficient::NonNegative),
        StartSet::Any => by_errors(count, Coefficient::Free),
    }
}

/// The targets, then a unit error of each internal drone.
fn by_errors(count: usize, errors: Coefficient) -> Vec<Generator> {
    let targets = Generator { placement: targets(count), coefficient: Coefficient::Positive };
    let units =
        (1..count - 1).map(|i| Generator { placement: unit_error(count, i), coefficient: errors });
    std::iter::once(targets).chain(units).collect()
}

/// All drones at their targets, the spacing l being 1.
pub fn targets(count: usize) -> Vec<BigInt> {
    (0..count).map(BigInt::from).collect()
}

/// Drone `i` is 1 before its target on a segment of no length.
pub fn unit_error(count: usize, i: usize) -> Vec<BigInt> {
    (0..count).map(|j| if j == i { BigInt::from(-1) } else { BigInt::zero() }).collect()
}

/// The sum of the generators with positive coefficients: a start of the set.
pub fn base(generators: &[Generator], count: usize) -> Vec<BigInt> {
    let positive = generators.iter().filter(|g| g.coefficient == Coefficient::Positive);
    positive.fold(vec![BigInt::zero(); count], |sum, g| plus(&sum, &1.into(), &g.placement))
}

/// `x + times * y`.
pub fn plus(x: &[BigInt], times: &BigInt, y: &[BigInt]) -> Vec<BigInt> {
    x.iter().zip(y).map(|(a, b)| a + times * b).collect()
}

/// The first generator that shows that the functional with these values is not >= 0.
pub fn negative_at(generators: &[Generator], values: &[BigInt]) -> Option<usize> {
    generators.iter().zip(values).position(|(g, f)| match g.coefficient {
        Coefficient::Free => !f.is_zero(),
        Coefficient::Positive | Coefficient::NonNegative => f.is_negative(),
    })
}

/// Whether a functional that is >= 0 of every start is > 0 of every start.
pub fn strictly_positive(generators: &[Generator], values: &[BigInt]) -> bool {
    generators
        .iter()
        .zip(values)
        .any(|(g, f)| g.coefficient == Coefficient::Positive && f.is_positive())
}

/// A start of which the functional is negative, generator `at` being the reason
/// ([`negative_at`]).
pub fn witness(
    generators: &[Generator],
    values: &[BigInt],
    at: usize,
    count: usize,
) -> Vec<BigInt> {
    let start = base(generators, count);
    let (Some(generator), Some(slope)) = (generators.get(at), values.get(at)) else {
        return start;
    };
    let of_base: BigInt = generators
        .iter()
        .zip(values)
        .filter(|(g, _)| g.coefficient == Coefficient::Positive)
        .map(|(_, f)| f)
        .sum();
    // Far enough along the generator, in the direction in which the functional falls.
    let far: BigInt = of_base.max(BigInt::zero()) / slope.abs() + 1;
    let times = if slope.is_positive() { -far } else { far };
    plus(&start, &times, &generator.placement)
}

#[cfg(test)]
mod tests {
    use cordon_spec::theorems::{Setting, Truth};
    use proptest::prelude::*;

    use super::*;

    const SETS: [StartSet; 4] =
        [StartSet::Any, StartSet::Ordered, StartSet::FirstSubsegment, StartSet::UpperBounded];

    fn contained(starts: StartSet, x: &[BigInt]) -> bool {
        let (Some(min), Some(max)) = (x.first(), x.last()) else { return false };
        let setting =
            Setting { min: min.clone(), max: max.clone(), eps_num: 0.into(), eps_den: 1.into() };
        min < max && starts.contains(&setting, x) == Truth::True
    }

    /// The coefficients of a placement (shifted to drone 0 at 0), times N-1: the generators are
    /// a basis, so they are what the coordinates of the table say.
    fn coordinates(starts: StartSet, x: &[BigInt]) -> Vec<BigInt> {
        let n = BigInt::from(x.len() - 1);
        let gap = |i: usize| &n * (&x[i + 1] - &x[i]);
        let (first, last) = (&x[0], &x[x.len() - 1]);
        let length = last - first;
        match starts {
            StartSet::Ordered => (0..x.len() - 1).map(gap).collect(),
            StartSet::FirstSubsegment => {
                let before = &x[x.len() - 2];
                // The length less N-1 times X_{N-2} - min, then the gaps.
                let rest = &n * (&length - &n * (before - first));
                std::iter::once(rest).chain((0..x.len() - 2).map(gap)).collect()
            }
            StartSet::UpperBounded | StartSet::Any => {
                let error = |i: usize| &n * first + BigInt::from(i) * &length - &n * &x[i];
                std::iter::once(length.clone()).chain((1..x.len() - 1).map(error)).collect()
            }
        }
    }

    proptest! {
        /// A placement is in the spec's start set iff its coefficients are in their ranges,
        /// and the generators with these coefficients give it back.
        #[test]
        fn generators_span_exactly_the_start_set(
            inner in prop::collection::vec(-3i64..20, 1..6),
            length in 1i64..24,
        ) {
            let count = inner.len() + 2;
            let mut x = vec![BigInt::zero()];
            x.extend(inner.iter().map(|x| BigInt::from(*x)));
            x.push(length.into());
            for starts in SETS {
                let gens = generators(starts, count);
                let coefficients = coordinates(starts, &x);
                prop_assert_eq!(gens.len(), coefficients.len());
                let rebuilt = gens.iter().zip(&coefficients).fold(
                    vec![BigInt::zero(); count],
                    |sum, (g, a)| plus(&sum, a, &g.placement),
                );
                let scaled: Vec<_> = x.iter().map(|x| x * BigInt::from(count - 1)).collect();
                prop_assert_eq!(rebuilt, scaled);
                let in_range = gens.iter().zip(&coefficients).all(|(g, a)| match g.coefficient {
                    Coefficient::Positive => a.is_positive(),
                    Coefficient::NonNegative => !a.is_negative(),
                    Coefficient::Free => true,
                });
                prop_assert_eq!(in_range, contained(starts, &x), "{:?} {:?}", starts, x);
            }
        }
    }

    #[test]
    fn bases_are_starts() {
        for starts in SETS {
            for count in 3..9 {
                assert!(contained(starts, &base(&generators(starts, count), count)));
            }
        }
    }

    #[test]
    fn witnesses_are_starts_where_the_functional_is_negative() {
        // f = 3*X_1 - X_2 (the segment starting at 0): any sign, on every start set.
        let f = |x: &[BigInt]| (&x[1] - &x[0]) * 3 - (&x[2] - &x[0]) * 2;
        let mut found = 0;
        for starts in SETS {
            for count in 4..9 {
                let gens = generators(starts, count);
                let values: Vec<_> = gens.iter().map(|g| f(&g.placement)).collect();
                if let Some(at) = negative_at(&gens, &values) {
                    let x = witness(&gens, &values, at, count);
                    assert!(contained(starts, &x), "{starts:?} {x:?}");
                    assert!(f(&x).is_negative(), "{starts:?} {x:?}");
                    found += 1;
                }
            }
        }
        assert_eq!(found, 20);
    }
}
