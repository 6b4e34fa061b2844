//! Powers of long integers by a [`Multiply`] backend.

use num_bigint::BigUint;
use num_traits::One;

use super::limbs;
use super::multiply::Multiply;

/// `base^k` by repeated squaring, from the highest bit of k.
pub fn natural(base: &BigUint, k: u64, by: &dyn Multiply) -> BigUint {
    if k == 0 || base.is_one() {
        return BigUint::one();
    }
    let small = base.to_u64_digits();
    let mut power = small.clone();
    for bit in (0..k.ilog2()).rev() {
        power = by.square(power);
        if k >> bit & 1 == 1 {
            let mut next = vec![0; power.len() + small.len()];
            limbs::accumulate(&mut next, &power, &small, false);
            power = next;
        }
    }
    limbs::natural(&power)
}
