//! Numbers at the edge: read exactly, shown rounded once.
use crate::common::{for_cases, q};
use cordon_core::Rational;
use cordon_core::exact::{decimal_string, parse, to_f64};
use proptest::prelude::*;

#[test]
fn decimals_are_read_exactly() {
    let table = [
        ("0.2", "1/5"),
        ("-0.75", "-3/4"),
        ("+7", "7"),
        (" 1e3 ", "1000"),
        ("1.5e-3", "3/2000"),
        (".5", "1/2"),
        ("5.", "5"),
        ("-6/-8", "3/4"),
        (
            "0.1000000000000000055511151231257827",
            "1000000000000000055511151231257827/10000000000000000000000000000000000",
        ),
    ];
    for (text, expected) in table {
        assert_eq!(q(text).to_string(), Rational::to_string(&q(expected)), "{text}");
    }
}

#[test]
fn what_is_no_number_is_refused_with_the_field_named() {
    let texts = [
        "", "-", ".", "abc", "1/0", "1/", "/2", "1/2/3", "NaN", "inf", "0x10", "1 2", "1,2", "1e",
        "1e99999", "1e-99999", "e5", "1.2.3", "--1", "1/-0", "٣",
    ];
    for text in texts {
        let error = parse("eps", text).unwrap_err();
        assert_eq!(error.code(), 2);
        assert!(error.to_string().starts_with(&format!("eps: `{text}`")), "{error}");
    }
    assert!(parse("eps", &"9".repeat(200_000)).unwrap_err().to_string().len() < 200);
}

#[test]
fn decimals_round_half_to_even() {
    let table = [
        ("1/3", 4, "0.3333"),
        ("2/3", 4, "0.6667"),
        ("1/8", 2, "0.12"),
        ("3/8", 2, "0.38"),
        ("-1/8", 2, "-0.12"),
        ("-1/1000", 2, "0.00"),
        ("999/1000", 2, "1.00"),
        ("7/2", 0, "4"),
        ("5/2", 0, "2"),
        ("0", 3, "0.000"),
        ("-12345/100", 1, "-123.4"),
    ];
    for (x, digits, expected) in table {
        assert_eq!(decimal_string(&q(x), digits), expected, "{x} to {digits}");
    }
}

#[test]
fn fractions_read_back_as_themselves() {
    for_cases(500, crate::common::rational(), |x| {
        prop_assert_eq!(q(&cordon_core::exact::fraction(&x)), x);
        Ok(())
    });
}

/// The nearest double, judged by the standard library's correctly rounded parser.
#[test]
fn doubles_are_the_nearest_ones() {
    let decimal = ("-?[0-9]{1,25}", "[0-9]{0,25}", -330i32..330);
    for_cases(3000, decimal, |(whole, fraction, exponent)| {
        let text = format!("{whole}.{fraction}e{exponent}");
        let exact = parse("x", &text).unwrap();
        let expected: f64 = text.parse().unwrap();
        prop_assert_eq!(to_f64(&exact).to_bits() << 1, expected.to_bits() << 1, "{}", text);
        Ok(())
    });
    // Halfway cases, where the last bit of the quotient decides.
    for_cases(3000, (any::<u64>(), -1100i32..980), |(bits, exponent)| {
        let numerator = num_bigint::BigInt::from(bits | 1);
        let power = num_bigint::BigInt::from(1) << exponent.unsigned_abs();
        let exact = if exponent < 0 {
            Rational::new(numerator, power)
        } else {
            Rational::from(numerator * power)
        };
        // Two roundings only where the first is exact: a 64-bit integer in two halves.
        let (high, low) = ((bits | 1) >> 32, (bits | 1) & 0xffff_ffff);
        let expected = if exponent > -1000 {
            (high as f64 * 2f64.powi(32) + low as f64) * 2f64.powi(exponent)
        } else {
            return Ok(());
        };
        prop_assert_eq!(to_f64(&exact), expected);
        Ok(())
    });
    for (x, expected) in [("0", 0.0), ("1/10", 0.1), ("5e-324", 5e-324), ("2e-324", 0.0)] {
        assert_eq!(to_f64(&q(x)), expected);
    }
    assert_eq!(to_f64(&q("1e400")), f64::INFINITY);
    assert_eq!(to_f64(&q("-1e-400")), 0.0);
}
