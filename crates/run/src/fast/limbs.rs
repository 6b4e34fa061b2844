//! Long integers as little-endian slices of 64-bit limbs: the inner loops.
//!
//! Nothing here allocates, so that an engine decides where its numbers live. Lengths are
//! fixed by the caller, who knows a bound of every value beforehand; what does not fit is
//! dropped (arithmetic modulo 2^(64 length)), which is what two's complement needs.

use num_bigint::{BigInt, BigUint, Sign};

/// Bits of a limb.
pub const LIMB_BITS: u64 = 64;

/// The low and the high limb of `x`.
fn split(x: u128) -> (u64, u64) {
    // Both casts keep exactly the half they name.
    (x as u64, (x >> LIMB_BITS) as u64)
}

/// `dst += carry`; the carry out.
fn ripple_add(dst: &mut [u64], mut carry: u64) -> u64 {
    for d in dst {
        if carry == 0 {
            return 0;
        }
        let (sum, over) = d.overflowing_add(carry);
        *d = sum;
        carry = u64::from(over);
    }
    carry
}

/// `dst -= borrow`; the borrow out.
fn ripple_sub(dst: &mut [u64], mut borrow: u64) -> u64 {
    for d in dst {
        if borrow == 0 {
            return 0;
        }
        let (difference, under) = d.overflowing_sub(borrow);
        *d = difference;
        borrow = u64::from(under);
    }
    borrow
}

/// `dst += src + carry`; the carry out. Limbs of `src` beyond `dst` are dropped.
pub fn add(dst: &mut [u64], src: &[u64], carry: bool) -> bool {
    let (low, high) = dst.split_at_mut(src.len().min(dst.len()));
    let mut carry = u64::from(carry);
    for (d, &s) in low.iter_mut().zip(src) {
        let (sum, c) = split(u128::from(*d) + u128::from(s) + u128::from(carry));
        (*d, carry) = (sum, c);
    }
    ripple_add(high, carry) != 0
}

/// `dst -= src + borrow`; the borrow out. Limbs of `src` beyond `dst` are dropped.
pub fn sub(dst: &mut [u64], src: &[u64], borrow: bool) -> bool {
    let (low, high) = dst.split_at_mut(src.len().min(dst.len()));
    let mut borrow = borrow;
    for (d, &s) in low.iter_mut().zip(src) {
        let (x, first) = d.overflowing_sub(s);
        let (x, second) = x.overflowing_sub(u64::from(borrow));
        *d = x;
        borrow = first | second;
    }
    ripple_sub(high, u64::from(borrow)) != 0
}

/// `dst += src * w`, modulo the length of `dst`.
pub fn add_mul(dst: &mut [u64], src: &[u64], w: u64) {
    let (low, high) = dst.split_at_mut(src.len().min(dst.len()));
    let mut carry = 0;
    for (d, &s) in low.iter_mut().zip(src) {
        // At most (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1.
        let (x, c) = split(u128::from(s) * u128::from(w) + u128::from(*d) + u128::from(carry));
        (*d, carry) = (x, c);
    }
    ripple_add(high, carry);
}

/// `dst -= src * w`, modulo the length of `dst`.
pub fn sub_mul(dst: &mut [u64], src: &[u64], w: u64) {
    let (low, high) = dst.split_at_mut(src.len().min(dst.len()));
    let mut carry = 0;
    for (d, &s) in low.iter_mut().zip(src) {
        let (x, c) = split(u128::from(s) * u128::from(w) + u128::from(carry));
        let (difference, under) = d.overflowing_sub(x);
        *d = difference;
        // No overflow: c is 2^64 - 1 only where x is 0, and then there is no borrow.
        carry = c + u64::from(under);
    }
    ripple_sub(high, carry);
}

/// `dst += sign * src * weight` for a weight of any length, modulo the length of `dst`.
pub fn accumulate(dst: &mut [u64], src: &[u64], weight: &[u64], negative: bool) {
    let row = if negative { sub_mul } else { add_mul };
    for (index, &w) in weight.iter().enumerate() {
        let Some(shifted) = dst.get_mut(index..) else { return };
        row(shifted, src, w);
    }
}

/// `dst >>= bits`, for `bits` below 64.
pub fn shift_right(dst: &mut [u64], bits: u32) {
    if bits == 0 {
        return;
    }
    let mut above = 0;
    for d in dst.iter_mut().rev() {
        let low = *d << (64 - bits);
        *d = *d >> bits | above;
        above = low;
    }
}

/// `a < b` as natural numbers; high limbs of `a` that are 0 may be missing.
pub fn less(a: &[u64], b: &[u64]) -> bool {
    let (low, high) = b.split_at(a.len().min(b.len()));
    if high.iter().any(|&limb| limb != 0) {
        return true;
    }
    a.iter().rev().lt(low.iter().rev())
}

/// Whether the two's complement number is negative.
pub fn is_negative(x: &[u64]) -> bool {
    x.last().is_some_and(|&top| top >> 63 == 1)
}

/// `x = -x` in two's complement.
pub fn negate(x: &mut [u64]) {
    let mut carry = true;
    for limb in x {
        let (negated, over) = (!*limb).overflowing_add(u64::from(carry));
        (*limb, carry) = (negated, over);
    }
}

/// `x` as a little-endian natural number, high zero limbs dropped.
pub fn trimmed(x: &[u64]) -> &[u64] {
    let used = x.iter().rposition(|&limb| limb != 0).map_or(0, |top| top + 1);
    &x[..used]
}

/// The natural number of some limbs.
pub fn natural(x: &[u64]) -> BigUint {
    // Both casts keep exactly the half they name.
    BigUint::new(trimmed(x).iter().flat_map(|&l| [l as u32, (l >> 32) as u32]).collect())
}

/// The integer of some limbs in two's complement. Uses `x` as scratch.
pub fn integer(x: &mut [u64]) -> BigInt {
    if is_negative(x) {
        negate(x);
        BigInt::from_biguint(Sign::Minus, natural(x))
    } else {
        natural(x).into()
    }
}

/// Writes `x` in two's complement over the whole of `dst`, which is long enough.
pub fn write(dst: &mut [u64], x: &BigInt) {
    dst.fill(0);
    for (d, limb) in dst.iter_mut().zip(x.magnitude().iter_u64_digits()) {
        *d = limb;
    }
    if x.sign() == Sign::Minus {
        negate(dst);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn limb() -> impl Strategy<Value = u64> {
        prop_oneof![any::<u64>(), Just(0), Just(1), Just(u64::MAX), Just(1 << 63)]
    }

    fn modulus(length: usize) -> BigInt {
        BigInt::from(1) << (64 * length)
    }

    proptest! {
        #[test]
        fn rows_are_arithmetic_modulo_the_length(
            dst in prop::collection::vec(limb(), 6),
            src in prop::collection::vec(limb(), 0..=6),
            weight in prop::collection::vec(limb(), 0..=3),
            carry in any::<bool>(),
            negative in any::<bool>(),
        ) {
            let (d, s, w) = (BigInt::from(natural(&dst)), BigInt::from(natural(&src)), BigInt::from(natural(&weight)));
            let one = i32::from(carry);
            let m = modulus(6);
            let equal = |x: &[u64], wanted: BigInt| natural(x) == num_integer::Integer::mod_floor(&wanted, &m).magnitude().clone();

            let mut x = dst.clone();
            let over = add(&mut x, &src, carry);
            prop_assert!(equal(&x, &d + &s + one));
            prop_assert_eq!(over, &d + &s + one >= m);

            let mut x = dst.clone();
            let under = sub(&mut x, &src, carry);
            prop_assert!(equal(&x, &d - &s - one));
            prop_assert_eq!(under, &d - &s < BigInt::from(one));

            let mut x = dst.clone();
            accumulate(&mut x, &src, &weight, negative);
            let product = if negative { -(&s * &w) } else { &s * &w };
            prop_assert!(equal(&x, &d + product));

            let mut x = dst;
            shift_right(&mut x, 2);
            prop_assert_eq!(natural(&x), natural(&{ let mut y = vec![0u64; 6]; write(&mut y, &(d >> 2)); y }));
        }

        #[test]
        fn twos_complement_reads_back(words in prop::collection::vec(limb(), 0..4), minus in any::<bool>()) {
            let n = BigInt::from(natural(&words));
            let n = if minus { -n } else { n };
            let mut x = vec![7u64; 5];
            write(&mut x, &n);
            prop_assert_eq!(integer(&mut x), n);
        }
    }
}
