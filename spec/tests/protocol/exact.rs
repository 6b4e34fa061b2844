//! What the contracts assume of the scalars (`model::exact`): that their operations are those of
//! numbers. Of big rationals for all of them, of machine integers while the results fit.
// The spec computes with references to the right operand: so does this.
#![allow(clippy::op_ref)]
use crate::placements::for_cases;
use cordon_core::Rational;
use cordon_spec::Scalar;
use num_traits::ToPrimitive;
use proptest::prelude::*;

const CASES: u32 = 400;

/// Fractions that are not in lowest terms, with negative denominators among them.
fn fraction() -> impl Strategy<Value = (i128, i128)> {
    (-1_000_000i128..=1_000_000, -1_000i128..=1_000).prop_filter("a denominator", |(_, d)| *d != 0)
}

fn rational((n, d): (i128, i128)) -> Rational {
    Rational::new(n.into(), d.into())
}

/// That `r` is the number `n/d`: `r.numer * d = n * r.denom`, on integers.
fn is(r: &Rational, n: i128, d: i128) -> bool {
    let (p, q) = (r.numer().to_i128().unwrap(), r.denom().to_i128().unwrap());
    q > 0 && p.checked_mul(d).unwrap() == n.checked_mul(q).unwrap()
}

#[test]
fn big_rationals_compute_as_fractions_do() {
    for_cases(CASES, (fraction(), fraction()), |((n, d), (m, e))| {
        let (a, b) = (rational((n, d)), rational((m, e)));
        prop_assert!(is(&(a.clone() + &b), n * e + m * d, d * e));
        prop_assert!(is(&(a.clone() - &b), n * e - m * d, d * e));
        prop_assert!(is(&(a.clone() * &b), n * m, d * e));
        prop_assert!(is(&a.clone(), n, d));
        Ok(())
    });
}

#[test]
fn machine_integers_compute_as_integers_do_while_they_fit() {
    // Of 15 bits: sums have 16, products 30.
    let small = -0x4000i32..0x4000;
    for_cases(CASES, (small.clone(), small), |(a, b)| {
        let (x, y) = (i64::from(a), i64::from(b));
        for (narrow, wide) in [(a + &b, x + y), (a - &b, x - y), (a * &b, x * y)] {
            prop_assert_eq!(i64::from(narrow), wide);
        }
        prop_assert_eq!(i128::from_int(a) * &i128::from_int(b), i128::from(x * y));
        Ok(())
    });
}
