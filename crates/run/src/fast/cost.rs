//! What the work of the engines costs, in nanoseconds of one core of 2020: for choices between
//! them, not for forecasts. Only ratios matter.

/// One limb of a sum, a copy or a multiplication by a limb.
pub const LIMB: f64 = 1.0;

/// A pair of drones in a convolution, beside its limbs.
pub const PAIR: f64 = 20.0;

/// The product of numbers of `a` and `b` limbs.
pub fn product(a: usize, b: usize) -> f64 {
    let (short, long) = (a.min(b) as f64, a.max(b) as f64);
    if short < 1000.0 {
        // Karatsuba on pieces as long as the shorter.
        return 1.2 * long * short.max(1.0).powf(0.585).min(short) * 2.0;
    }
    let length = short + long;
    12.0 * length * length.log2()
}
