//! Simple fractions: those with small denominators.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::Rational;

/// The fraction strictly between `lo` and `hi` with the least denominator, and among those
/// the one nearest zero. `None` unless `lo < hi`.
pub fn strictly_between(lo: &Rational, hi: &Rational) -> Option<Rational> {
    if lo >= hi {
        return None;
    }
    if lo.is_negative() && hi.is_positive() {
        return Some(Rational::zero());
    }
    if !hi.is_positive() {
        return strictly_between(&-hi.clone(), &-lo.clone()).map(|x| -x);
    }
    // 0 <= lo < hi: walk the continued fraction (Stern-Brocot) with both ends excluded.
    let whole = lo.floor();
    let next = &whole + Rational::one();
    if &next < hi {
        return Some(next);
    }
    // No integer strictly between: whole <= lo < hi <= whole + 1.
    let (low, high) = (lo - &whole, hi - &whole);
    // 1/x is in (1/high, 1/low), unbounded where low is 0.
    let inverse = if low.is_zero() {
        high.recip().floor() + Rational::one()
    } else {
        strictly_between(&high.recip(), &low.recip())?
    };
    Some(whole + inverse.recip())
}

/// All fractions in the closed interval with denominators up to `denominators`, the simplest
/// (least denominator, then least value) first. Each once.
pub fn fractions_within(lo: &Rational, hi: &Rational, denominators: u32) -> Vec<Rational> {
    let mut found = Vec::new();
    for q in 1..=denominators {
        let q = BigInt::from(q);
        let scale = Rational::from_integer(q.clone());
        let mut p = (lo * &scale).ceil().to_integer();
        let last = (hi * &scale).floor().to_integer();
        while p <= last {
            if p.gcd(&q).is_one() {
                found.push(Rational::new(p.clone(), q.clone()));
            }
            p += 1;
        }
    }
    found
}
