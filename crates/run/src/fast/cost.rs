//! What the work of the engines costs, in nanoseconds of one core: for choices between them, not
//! for forecasts. Only ratios matter. Unit costs are measured; how often each is incurred is
//! tested against the engines.

use super::growth::{Growth, limbs_for, log2_above, longest};
use super::line::Line;
use super::ntt::SHORTEST;
use super::ring::{Size, half_ring};

/// A limb of a sum, of a copy, or of a product by one limb.
pub const LIMB: f64 = 1.0;

/// A pair of drones in a convolution, beside its limbs.
pub const PAIR: f64 = 20.0;

/// One drone in one step, beside its limbs, and a limb of it: where the neighbours' weight is
/// 1, and for each limb of weights else.
const STEP_DRONE: f64 = 6.0;
const STEP_LIMB: f64 = 1.3;
const STEP_LIMB_WEIGHTED: f64 = 2.2;

/// A squaring of the kernel, however short.
const SQUARING: f64 = 600.0;

/// The product of numbers of `a` and `b` limbs.
pub fn product(a: usize, b: usize) -> f64 {
    let (short, long) = (a.min(b) as f64, a.max(b) as f64);
    if short < SHORTEST as f64 {
        // Long multiplication, from some 30 limbs on by Karatsuba's method, piece by piece.
        return long * short.min(4.7 * short.powf(0.574)) + 30.0;
    }
    let length = short + long;
    25_000.0 + 4.3 * length * length.log2()
}

/// The square of a number of `a` limbs: one transform less; long multiplication gains nothing.
pub fn square(a: usize) -> f64 {
    if a < SHORTEST { product(a, a) } else { 0.65 * product(a, a) }
}

/// Every step of a line up to step k.
pub fn stepping(line: &Line, k: u64) -> f64 {
    let limb = match longest([&line.side, &line.centre]) {
        _ if line.side == 1.into() => STEP_LIMB,
        bits if bits <= 62 => STEP_LIMB_WEIGHTED,
        bits => 1.5 * STEP_LIMB_WEIGHTED * limbs_for(bits) as f64,
    };
    let drones_and_steps = line.count() as f64 * k as f64;
    drones_and_steps * (mean_limbs(line, k) * limb + STEP_DRONE)
}

/// Limbs of a number in a run of k steps, on average.
fn mean_limbs(line: &Line, k: u64) -> f64 {
    let start = longest(&line.deviation) as f64 / 64.0 + 0.5;
    (log2_above(&line.growth()) / 64.0) * k as f64 / 2.0 + start
}

/// A jump of a line to step k.
pub fn jumping(line: &Line, k: u64) -> f64 {
    let kernel = KernelCost::of(line, k);
    let long = limbs_for(Growth::of(&line.growth()).bits(k));
    let size = Size {
        count: line.count(),
        support: (2 * kernel.degree + 1).min(2 * half_ring(line)),
        stride: long,
        deviation: limbs_for(longest(&line.deviation) + 2),
    };
    let (convolution, _) = size.cheaper();
    // The denominator's power takes the squares of a number of its length.
    let denominator = 2.0 * square(long / 2 + 1);
    kernel.products
        + kernel.passes
        + convolution
        + denominator
        + 4.0 * LIMB * (line.count() * long) as f64
}

/// The work of raising a kernel.
struct KernelCost {
    /// Multiplications.
    products: f64,
    /// Everything else.
    passes: f64,
    /// The largest place reached.
    degree: usize,
}

impl KernelCost {
    fn of(line: &Line, k: u64) -> Self {
        let (half, growth) = (half_ring(line), Growth::of(&line.growth()));
        let degree = |k: u64| usize::try_from(k).unwrap_or(usize::MAX).min(half);
        let mut cost = Self { products: 0.0, passes: 0.0, degree: degree(k) };
        let mut exponent: u64 = 0;
        for bit in (0..u64::BITS - k.leading_zeros()).rev() {
            if exponent > 0 {
                let slot = limbs_for(growth.bits(exponent.saturating_mul(2)) / 2 + 1);
                let packed = (2 * degree(exponent) + 1) * slot;
                cost.products += square(packed);
                cost.passes += SQUARING + 6.0 * LIMB * packed as f64;
            }
            exponent = k >> bit;
            if exponent & 1 == 1 {
                let limbs = degree(exponent) * limbs_for(growth.bits(exponent));
                cost.passes += 4.0 * LIMB * limbs as f64;
            }
        }
        cost
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use std::sync::Mutex;

    use cordon_core::Rational;
    use cordon_spec::Params;

    use super::super::kernel::Kernel;
    use super::super::multiply::Multiply;
    use super::*;

    /// Counts what it is asked to multiply, in the units above, and multiplies nothing: lengths
    /// do not depend on values.
    struct Counting(Mutex<f64>);

    impl Multiply for Counting {
        fn name(&self) -> &'static str {
            "counting"
        }

        fn product(&self, a: &[u64], b: &[u64]) -> Vec<u64> {
            *self.0.lock().unwrap() += product(a.len(), b.len());
            vec![0; a.len() + b.len()]
        }

        fn square(&self, a: Vec<u64>) -> Vec<u64> {
            *self.0.lock().unwrap() += square(a.len());
            vec![0; 2 * a.len()]
        }
    }

    fn line(count: i64, (p, q): (i64, i64)) -> Line {
        let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
        let place = |i| if i + 1 == count { ratio(100, 1) } else { ratio(40 * i, count - 1) };
        let start: Vec<_> = (0..count).map(place).collect();
        let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(p, q), n: 0 };
        Line::coverage(&p, &start).unwrap()
    }

    const WEIGHTS: [(i64, i64); 4] =
        [(1, 5), (2, 7), (3, 5), (123_456_789_012_345_678, 987_654_321_098_765_433)];

    /// Both counted over the grid: what is chosen is never more than 1.2 times the better.
    #[test]
    fn the_engine_chosen_does_not_more_than_the_better_one() {
        let (mut jumps, mut steps) = (0, 0);
        for eps in WEIGHTS {
            for count in [3, 4, 10, 40, 150, 400] {
                for k in [1u64, 7, 30, 100, 300, 700] {
                    let line = line(count, eps);
                    let jump_work = counted_jump(&line, k);
                    let step_work = counted_step(&line, k);
                    let jump = super::super::engine::jump_is_faster(&line, k, [k]);
                    let chosen = if jump { jump_work } else { step_work };
                    let better = jump_work.min(step_work);
                    assert!(
                        chosen <= 1.2 * better + 2_000.0,
                        "N = {count}, k = {k}, {eps:?}: jump {jump_work}, step {step_work}"
                    );
                    if jump { jumps += 1 } else { steps += 1 }
                }
            }
        }
        assert!(jumps >= 20 && steps >= 60 && jumps + steps == 144, "{jumps} {steps}");
    }

    /// The multiplications of a jump as they happen; its passes over limbs as modelled.
    fn counted_jump(line: &Line, k: u64) -> f64 {
        let by = Counting(Mutex::new(0.0));
        let kernel = Kernel::power(line, half_ring(line), k, &by);
        let raised = *by.0.lock().unwrap();
        assert_eq!(
            kernel.support(),
            (2 * KernelCost::of(line, k).degree + 1).min(2 * half_ring(line))
        );
        jumping(line, k) - KernelCost::of(line, k).products + raised
    }

    /// The limbs of every drone in every step, as long as the stepping engine has them.
    fn counted_step(line: &Line, k: u64) -> f64 {
        let growth = Growth::of(&line.growth());
        let start: Vec<_> = line.start().collect();
        let bits = longest(&start) + 1;
        let limbs: usize = (1..=k).map(|t| limbs_for(growth.bits(t) + bits)).sum();
        stepping(line, k) * (limbs as f64 / k as f64) / mean_limbs(line, k)
    }
}
