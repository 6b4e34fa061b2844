//! The gaps of a start, and the weights for which coverage preserves the smallest one.

use cordon_core::Rational;

/// A gap, from drone `after` to the next.
pub(super) struct Gap {
    pub(super) size: Rational,
    pub(super) after: usize,
}

/// The smallest gap in two placements, and the size of the largest.
pub(super) fn smallest(desired: &[Rational], actual: &[Rational]) -> (Gap, Rational) {
    let sizes = |x: &[Rational]| -> Vec<Rational> { x.windows(2).map(|x| &x[1] - &x[0]).collect() };
    let (desired, actual) = (sizes(desired), sizes(actual));
    let all = || desired.iter().enumerate().chain(actual.iter().enumerate());
    let largest = all().map(|(_, size)| size).max().cloned().unwrap_or_default();
    let least = all().min_by_key(|(_, size)| *size);
    let (after, size) = least.map_or_else(Default::default, |(i, size)| (i, size.clone()));
    (Gap { size, after }, largest)
}

/// The largest weight for which no step lowers the smallest gap or raises the largest: each gap is then
/// a mean of itself and its neighbours. If no neighbour of a moving drone moves at the same time, the
/// weight may be 1.
pub(super) fn most_weight(count: usize, one_by_one: bool) -> Rational {
    let alone = count == 3 || one_by_one;
    Rational::new(1.into(), if alone { 1 } else { 2 }.into())
}

/// Whether no step lowers the smallest gap.
pub(super) fn kept(count: usize, eps: &Rational, one_by_one: bool) -> bool {
    *eps >= Rational::default() && *eps <= most_weight(count, one_by_one)
}
