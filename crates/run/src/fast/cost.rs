//! What the work of the engines costs, in nanoseconds of one core: for choices between them, not
//! for forecasts. Only ratios matter.

use super::growth::{Growth, limbs_for, log2_above, longest};
use super::line::Line;
use super::ring::{Size, half_ring};

/// A limb of a sum, of a copy, or of a product by one limb.
pub const LIMB: f64 = 1.0;

/// A pair of drones in a convolution, beside its limbs.
pub const PAIR: f64 = 20.0;

/// A limb of one drone in one step, and the drone itself.
const STEP_LIMB: f64 = 1.3;
const STEP_DRONE: f64 = 6.0;

/// The product of numbers of `a` and `b` limbs.
pub fn product(a: usize, b: usize) -> f64 {
    let (short, long) = (a.min(b) as f64, a.max(b) as f64);
    if short < 1000.0 {
        // Long multiplication, from 32 limbs on by Karatsuba's method, piece by piece.
        return long * short.min(6.5 * short.max(1.0).powf(0.46)) + 30.0;
    }
    let length = short + long;
    10.0 * length * length.log2()
}

/// Every step of a line up to step k.
pub fn stepping(line: &Line, k: u64) -> f64 {
    let limbs = log2_above(&line.growth()) / 64.0;
    let start = 1.0 + longest(&line.deviation) as f64 / 64.0;
    let (drones, k) = (line.count() as f64, k as f64);
    drones * k * ((k * limbs / 2.0 + start) * STEP_LIMB + STEP_DRONE)
}

/// A jump of a line to step k.
pub fn jumping(line: &Line, k: u64) -> f64 {
    let (half, growth) = (half_ring(line), Growth::of(&line.growth()));
    let degree = |k: u64| usize::try_from(k).unwrap_or(usize::MAX).min(half);
    let mut cost = 0.0;
    let mut exponent = 0;
    for bit in (0..u64::BITS - k.leading_zeros()).rev() {
        if exponent > 0 {
            let slot = limbs_for(growth.bits(2 * exponent) / 2 + 1);
            let packed = (2 * degree(exponent) + 1) * slot;
            cost += product(packed, packed) * SQUARE + 6.0 * LIMB * packed as f64;
        }
        exponent = k >> bit;
        if exponent & 1 == 1 {
            cost += (degree(exponent) * limbs_for(growth.bits(exponent))) as f64 * 4.0 * LIMB;
        }
    }
    let long = limbs_for(growth.bits(k));
    let support = if degree(k) == half { 2 * half } else { 2 * degree(k) + 1 };
    let deviation = limbs_for(longest(&line.deviation) + 2);
    let size = Size { count: line.count(), support, stride: long, deviation };
    let (convolution, _) = size.cheaper();
    cost + convolution
        + 2.0 * product(long / 2 + 1, long / 2 + 1)
        + 4.0 * LIMB * (line.count() * long) as f64
}

/// A square in units of a product.
const SQUARE: f64 = 0.7;
