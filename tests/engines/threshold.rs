//! Exact thresholds, from the command line and against the closed form.
use std::fs;

use crate::common::{q, run};
use cordon_check::{Verdict, check};
use cordon_core::Rational;
use cordon_proof::certificate;
use cordon_proof::threshold::convergence::bracket;
use cordon_proof::threshold::invariance;
use cordon_proof::threshold::safety::{Cone, critical};
use num_bigint::BigInt;
use num_traits::{One, Pow, Signed, Zero};
use serde_json::{Value, json};

/// Bits of the independent evaluation of the closed form.
const BITS: u32 = 260;

/// pi in fixed point by Machin's formula.
fn pi() -> BigInt {
    let one = BigInt::one() << BITS;
    let arctan_inverse = |n: i32| {
        let (mut power, mut sum, mut k) = (&one / n, &one / n, 1);
        while !power.is_zero() {
            power /= n * n;
            k += 2;
            let term = &power / k;
            sum = if k % 4 == 3 { sum - term } else { sum + term };
        }
        sum
    };
    (arctan_inverse(5) * 4 - arctan_inverse(239)) * 4
}

/// 1/(1 + cos(pi/(N-1))) up to 2^-240, by Taylor's series.
fn closed_form(count: usize) -> Rational {
    let one = BigInt::one() << BITS;
    let x = pi() / BigInt::from(count - 1);
    let square = (&x * &x) >> BITS;
    let (mut term, mut cosine, mut k) = (one.clone(), one.clone(), 0);
    while !term.is_zero() {
        term = -((&term * &square) >> BITS) / ((k + 1) * (k + 2));
        cosine += &term;
        k += 2;
    }
    Rational::new(one.clone(), one + cosine)
}

fn valid(certificate: &Value) -> bool {
    matches!(check(&certificate.to_string()), Verdict::Valid { .. })
}

#[test]
fn convergence_to_thirty_digits_for_every_number_of_drones_to_fifty() {
    let unit = Rational::new(BigInt::one(), BigInt::from(10).pow(30u32));
    let tolerance = Rational::new(BigInt::one(), BigInt::one() << 240);
    let (mut brackets, mut exact) = (0, 0);
    for count in 3..=50 {
        let found = bracket(count, 30).unwrap();
        let value = closed_form(count);
        assert!(found.below < &value + &tolerance && &value - &tolerance < found.above, "{count}");
        assert!(&found.above - &found.below <= unit, "{count}");
        let w = &found.vector.weights;
        assert!(valid(&certificate::contraction(count, &found.below, &found.rate, w)), "{count}");
        assert!(valid(&certificate::growth(count, &found.above, w)), "{count}");
        // Each certificate on the other side is false, and seen to be.
        assert!(!valid(&certificate::contraction(count, &found.above, &found.rate, w)), "{count}");
        assert!(!valid(&certificate::growth(count, &found.below, w)), "{count}");
        if let Some(critical) = &found.exact {
            assert!((critical - &value).abs() < tolerance);
            exact += 1;
        }
        brackets += 1;
    }
    assert_eq!((brackets, exact), (48, 2), "rational for N = 3 and 4 only");
    assert_eq!(bracket(3, 5).unwrap().exact, Some(q("1")));
    assert_eq!(bracket(4, 5).unwrap().exact, Some(q("2/3")));
}

#[test]
fn ordering_and_bound_are_exactly_one_half() {
    let mut found = 0;
    for count in 3..=20 {
        for cone in [Cone::PositiveGaps, Cone::NonnegativeErrors] {
            let c = critical(cone, count, 12).unwrap();
            let expected = if cone == Cone::PositiveGaps && count == 3 { "1" } else { "1/2" };
            assert_eq!(c.critical, q(expected), "{cone:?} {count}");
            assert_eq!(c.above.step, 1);
            assert!(valid(&certificate::refutation(&c.above)), "{cone:?} {count}");
            for eps in [Rational::zero(), c.critical.clone()] {
                assert!(valid(&invariance::certificate(cone, count, &eps).unwrap()));
            }
            let beyond = &c.critical + q("1/1000");
            assert_eq!(invariance::certificate(cone, count, &beyond), None, "{cone:?} {count}");
            // One internal drone: a negative weight only makes it run away on its own side.
            let keeps = cone == Cone::NonnegativeErrors && count == 3;
            let negative = invariance::certificate(cone, count, &q("-1/1000"));
            assert_eq!(negative.is_some(), keeps, "{cone:?} {count}");
            found += 1;
        }
    }
    assert_eq!(found, 36);
}

#[test]
fn certificates_of_a_thousand_drones_are_written_and_valid() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path().to_str().unwrap();
    let args = ["threshold", "--property", "convergence", "--drones", "1000", "--digits", "12"];
    let (code, out, _) = run(&[&args[..], &["--out", dir]].concat());
    assert_eq!(code, 0, "{out}");
    for side in ["below", "above"] {
        let text = fs::read_to_string(folder.path().join(format!("convergence-1000-{side}.json")));
        assert!(matches!(check(&text.unwrap()), Verdict::Valid { .. }), "{side}");
    }
}

#[test]
fn the_command_says_what_it_found() {
    let (code, out, err) = run(&["threshold", "--property", "ordering", "--drones", "5"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.starts_with("ordering (7.2), N = 5: critical weight 1/2 exactly\n"), "{out}");
    let (code, out, _) =
        run(&["threshold", "--property", "convergence", "--drones", "5", "--digits", "12"]);
    assert_eq!(code, 0);
    assert!(out.contains("critical weight 0.585786437626..."), "{out}");
    let json_args = ["--property", "bound", "--drones", "4", "--format", "json"];
    let (code, out, _) = run(&[&["threshold"], &json_args[..]].concat());
    let page: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(code, 0);
    assert_eq!(page["schema"], json!("cordon-threshold/1"));
    assert_eq!(page["critical"], json!("1/2"));
    assert_eq!(page["above"]["step"], json!(1));
}

#[test]
fn out_of_range_is_refused() {
    let cases = [
        (["--drones", "2", "--digits", "5"], "drones: `2`: expected a number from 3 to 1000"),
        (["--drones", "1001", "--digits", "5"], "drones: `1001`"),
        (["--drones", "5", "--digits", "0"], "digits: `0`: expected a number from 1 to 1000"),
        (["--drones", "5", "--digits", "99999999"], "digits: `99999999`"),
    ];
    for property in ["ordering", "bound", "convergence"] {
        for (args, expected) in &cases {
            let all = [&["threshold", "--property", property], &args[..]].concat();
            let (code, out, err) = run(&all);
            assert_eq!((code, out.as_str()), (2, ""), "{all:?}");
            assert!(err.contains(expected), "{err}");
        }
    }
}
