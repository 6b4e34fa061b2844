//! The line unfolded to a ring, and k steps as one convolution on it.
//!
//! With fixed ends the deviations from the targets continue oddly beyond the ends, to a ring
//! of `2(N-1)` places on which every place obeys the same rule; with free ends (consensus) the
//! positions continue evenly, to a ring of `2N`. Short lines are convolved pair by pair, long
//! ones by one multiplication of long integers.

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use super::cost;
use super::growth::{limbs_for, longest};
use super::kernel::Kernel;
use super::limbs;
use super::line::{Ends, Line};
use super::multiply::Multiply;

/// Half the length of the ring that the line is unfolded to.
pub(super) fn half_ring(line: &Line) -> usize {
    match line.ends {
        Ends::Fixed => line.count() - 1,
        Ends::Free => line.count(),
    }
}

/// How far drone 0 is from its image beyond the left end.
fn image(ends: Ends) -> usize {
    match ends {
        Ends::Fixed => 0,
        Ends::Free => 1,
    }
}

/// The sizes that a convolution's cost depends on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Size {
    /// Drones of the line that the ring unfolds.
    pub count: usize,
    /// Places of the ring at which the kernel may not be 0.
    pub support: usize,
    /// Limbs of a coefficient of the kernel.
    pub stride: usize,
    /// Limbs of a deviation.
    pub deviation: usize,
}

impl Size {
    fn of(line: &Line, kernel: &Kernel) -> Self {
        Self {
            count: line.count(),
            support: kernel.support(),
            stride: kernel.stride(),
            deviation: limbs_for(longest(&line.deviation) + 2),
        }
    }

    /// Limbs of a sum of coefficients, weighted by deviations.
    fn width(self) -> usize {
        // The magnitudes of a power sum to W^k, which fits the kernel's stride: so do their
        // differences, and a sum of them weighted by deviations needs the bits of the largest
        // deviation more, one for its image and one for the sign.
        self.stride + self.deviation
    }

    /// The cost of the cheaper way, and whether that is the multiplication.
    pub(super) fn cheaper(self) -> (f64, bool) {
        let pairs = self.count as f64 * self.count.min(2 * self.support) as f64;
        let each = 2 * self.stride + self.deviation * self.width();
        let direct = pairs * (each as f64 + cost::PAIR) + (self.count * self.count) as f64;
        let (ring, slot) = (2 * self.count, self.width());
        let product =
            cost::product(self.support * slot, ring * slot) + cost::LIMB * (4 * ring * slot) as f64;
        (direct.min(product), product < direct)
    }
}

/// The convolution of the kernel with the unfolded deviations: one number a drone.
pub(super) fn convolve(line: &Line, kernel: &Kernel, by: &dyn Multiply) -> Vec<BigInt> {
    let size = Size::of(line, kernel);
    let (_, multiply) = size.cheaper();
    if multiply { by_product(line, kernel, size, by) } else { pairwise(line, kernel, size) }
}

/// The drones that move.
fn moving(line: &Line) -> std::ops::Range<usize> {
    match line.ends {
        Ends::Fixed => 1..line.count() - 1,
        Ends::Free => 0..line.count(),
    }
}

fn pairwise(line: &Line, kernel: &Kernel, size: Size) -> Vec<BigInt> {
    let sources = Sources::of(line);
    let mut moved = vec![BigInt::zero(); line.count()];
    for i in moving(line) {
        moved[i] = sources.at(i, line.ends, kernel, size.width());
    }
    moved
}

/// The deviations that are not 0.
pub(super) struct Sources(Vec<(usize, Vec<u64>, bool)>);

impl Sources {
    /// Those of a line.
    pub(super) fn of(line: &Line) -> Self {
        let deviations = line.deviation.iter().enumerate().filter(|(_, d)| !d.is_zero());
        Self(deviations.map(|(j, d)| (j, d.magnitude().to_u64_digits(), d.is_negative())).collect())
    }

    /// What one drone that moves comes to: [`convolve`] at place `i`.
    pub(super) fn one(&self, i: usize, line: &Line, kernel: &Kernel) -> BigInt {
        self.at(i, line.ends, kernel, Size::of(line, kernel).width())
    }

    fn at(&self, i: usize, ends: Ends, kernel: &Kernel, width: usize) -> BigInt {
        let (mut pair, mut sum) = (vec![0; kernel.stride() + 1], vec![0; width]);
        for (j, magnitude, negative) in &self.0 {
            let (direct, mirrored) = (i.abs_diff(*j), i + j + image(ends));
            if !(kernel.reaches(direct) || kernel.reaches(mirrored)) {
                continue;
            }
            let sign = pair_up(&mut pair, kernel, direct, mirrored, ends);
            limbs::accumulate(&mut sum, &pair, magnitude, sign ^ negative);
        }
        limbs::integer(&mut sum)
    }
}

/// The magnitude of what a deviation gives a drone: directly, and through its image beyond an
/// end, which is odd for fixed ends and even for free ones. Returns whether it is negative.
fn pair_up(pair: &mut [u64], kernel: &Kernel, direct: usize, mirrored: usize, ends: Ends) -> bool {
    pair.fill(0);
    limbs::add(pair, kernel.coefficient(direct), false);
    let opposite = kernel.negative(direct) != kernel.negative(mirrored);
    let mut below_zero = false;
    if opposite != (ends == Ends::Fixed) {
        below_zero = limbs::sub(pair, kernel.coefficient(mirrored), false);
    } else {
        limbs::add(pair, kernel.coefficient(mirrored), false);
    }
    if below_zero {
        limbs::negate(pair);
    }
    below_zero ^ kernel.negative(direct)
}

/// All sums at once: the ring's places side by side in one long integer, so that a product is
/// a convolution. A coefficient is negative by its place alone, so that deviations and sums
/// take the signs ([`Kernel::negative`]) and the kernel goes in as magnitudes.
fn by_product(line: &Line, kernel: &Kernel, size: Size, by: &dyn Multiply) -> Vec<BigInt> {
    let (slot, ring) = (size.width(), 2 * half_ring(line));
    let mirror = |index: usize| (2 * ring - image(line.ends) - index) % ring;
    // The kernel's support as the places 0 .. support, of which `shift` is its middle.
    let shift = if size.support < ring { size.support / 2 } else { 0 };
    let mut packed = vec![0; size.support * slot];
    for (index, into) in packed.chunks_exact_mut(slot).enumerate() {
        limbs::add(into, limbs::trimmed(kernel.coefficient((index + ring - shift) % ring)), false);
    }
    let odd = |index: usize| kernel.negative(index) != kernel.negative(0);
    let side = |wanted: bool| {
        let mut places = vec![0; ring * slot];
        let mut any = false;
        for (j, d) in line.deviation.iter().enumerate().filter(|(_, d)| !d.is_zero()) {
            for (index, flipped) in [(j, false), (mirror(j), line.ends == Ends::Fixed)] {
                if (d.is_negative() ^ flipped ^ odd(index)) == wanted {
                    limbs::write(&mut places[index * slot..][..slot], &d.abs());
                    any = true;
                }
            }
        }
        if any { folded(&by.product(&packed, &places), slot, ring, shift) } else { Vec::new() }
    };
    let positive = side(false);
    // Where what is unfolded is odd about its mirror, so are the sums.
    let is_odd = (line.ends == Ends::Fixed) != (odd(mirror(0)) != odd(0));
    let negative = if is_odd { Vec::new() } else { side(true) };
    let at = |sums: &[u64], index: usize| {
        let wide = slot + 1;
        sums.get(index * wide..(index + 1) * wide)
            .map_or_else(BigInt::zero, |x| limbs::natural(x).into())
    };
    let mut moved = vec![BigInt::zero(); line.count()];
    for i in moving(line) {
        let minus = if is_odd { at(&positive, mirror(i)) } else { at(&negative, i) };
        let sum = at(&positive, i) - minus;
        moved[i] = if kernel.negative(i) { -sum } else { sum };
    }
    moved
}

/// The places of a product, folded back to the ring; each in a limb more than a slot has.
fn folded(product: &[u64], slot: usize, ring: usize, shift: usize) -> Vec<u64> {
    let wide = slot + 1;
    let mut sums = vec![0; ring * wide];
    for (index, digit) in product.chunks(slot).enumerate() {
        let index = (index + 2 * ring - shift) % ring;
        limbs::add(&mut sums[index * wide..][..wide], digit, false);
    }
    sums
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use cordon_core::Rational;
    use cordon_spec::Params;
    use proptest::prelude::*;

    use super::super::growth::Growth;
    use super::super::multiply::NumBigint;
    use super::*;

    proptest! {
        #[test]
        fn the_product_is_the_pairwise_sum(
            free in any::<bool>(),
            (p, q) in (-40i64..=60, 1i64..=20),
            k in 0u64..40,
            start in prop::collection::vec(-1000i64..1000, 3..12),
        ) {
            let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
            let start: Vec<_> = start.iter().map(|&x| ratio(x, 7)).collect();
            let (eps, ends) = (ratio(p, q), (&start[0], &start[start.len() - 1]));
            let line = if free {
                Line::consensus(&eps, &start).unwrap()
            } else {
                let p = Params { min: ends.0.clone(), max: ends.1.clone(), eps, n: 0 };
                Line::coverage(&p, &start).unwrap()
            };
            let kernel = Kernel::power(&line, half_ring(&line), k, &NumBigint);
            prop_assert!(Growth::of(&line.growth()).bits(k) <= 64 * kernel.stride() as u64);
            let size = Size::of(&line, &kernel);
            prop_assert_eq!(
                by_product(&line, &kernel, size, &NumBigint),
                pairwise(&line, &kernel, size)
            );
        }
    }
}
