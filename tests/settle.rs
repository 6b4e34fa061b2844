//! Settling steps: proved and true, against runs of the spec.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use std::cell::Cell;

use common::{for_cases, params_for, placements, q, run};
use cordon::Rational;
use cordon::settle::{Observed, Settling, Starts, settling};
use num_traits::Signed;
use proptest::prelude::*;

/// The first step from which on a long exact run is within the distance.
fn by_running(start: &[Rational], eps: &Rational, within: &Rational, horizon: usize) -> u64 {
    let p = params_for(eps.clone(), start);
    let last = Rational::from_integer((start.len() - 1).into());
    let target = |i: usize| &p.min + (&p.max - &p.min) * Rational::from_integer(i.into()) / &last;
    let outside =
        |x: &Vec<Rational>| x.iter().enumerate().any(|(i, x)| (x - target(i)).abs() > *within);
    let run = placements(&p, start.to_vec(), horizon);
    run.iter().rposition(outside).map_or(0, |k| k as u64 + 1)
}

fn steps(found: Settling) -> (Vec<u64>, u64) {
    let Settling::Settles { proved, observed: Observed::Step(step) } = found else {
        panic!("{found:?}")
    };
    (proved.iter().map(|p| p.step).collect(), step)
}

fn weight() -> impl Strategy<Value = Rational> {
    (1i32..=10, 11i32..=20).prop_map(|(n, d)| Rational::new(n.into(), d.into()))
}

#[test]
fn true_step_is_that_of_the_run_and_proved_steps_are_not_before_it() {
    let (beyond_half, proved_twice) = (Cell::new(0), Cell::new(0));
    let start = prop::collection::vec(-9i32..=9, 1..=3);
    for_cases(120, (start, weight(), 1i32..=6), |(internal, eps, places)| {
        let number = |n: i32| Rational::from_integer(n.into());
        let start: Vec<Rational> =
            [0].iter().chain(&internal).chain(&[4]).map(|&n| number(n)).collect();
        let within = number(places) / number(7);
        match settling(&Starts::One(start.clone()), &eps, &within).unwrap() {
            Settling::NotFromEveryStart(_) => prop_assert!(eps > q("1/2")),
            found => {
                let (proved, step) = steps(found);
                prop_assert_eq!(step, by_running(&start, &eps, &within, 150));
                prop_assert!(proved.iter().all(|&p| p >= step), "{:?} {}", proved, step);
                prop_assert_eq!(proved.len(), if eps > q("1/2") { 1 } else { 2 });
                beyond_half.set(beyond_half.get() + u32::from(eps > q("1/2")));
                proved_twice.set(proved_twice.get() + u32::from(eps <= q("1/2")));
            }
        }
        Ok(())
    });
    assert!(beyond_half.get() >= 5 && proved_twice.get() >= 50, "{beyond_half:?} {proved_twice:?}");
}

#[test]
fn from_every_start_means_from_every_corner_of_the_box() {
    let mut corners_seen = 0;
    for count in 3..=6 {
        for eps in ["1/7", "1/4", "1/2", "11/21", "4/7", "9/10"] {
            let eps = q(eps);
            let within = q("1/20");
            let found = settling(&Starts::AllWithin(count), &eps, &within).unwrap();
            if matches!(found, Settling::NotFromEveryStart(_)) {
                continue;
            }
            let (proved, step) = steps(found);
            let mut worst = 0;
            for bits in 0..1_u32 << (count - 2) {
                let inner = (0..count - 2).map(|i| q(if bits >> i & 1 == 1 { "1" } else { "0" }));
                let start: Vec<Rational> =
                    [q("0")].into_iter().chain(inner).chain([q("1")]).collect();
                worst = worst.max(by_running(&start, &eps, &within, 60 + 4 * step as usize));
                corners_seen += 1;
            }
            assert_eq!(step, worst, "N = {count}, eps = {eps}");
            assert!(proved.iter().all(|&p| p >= step));
        }
    }
    // 2 + 4 + 8 + 16 corners for three weights at least, more where the critical weight allows.
    assert_eq!(corners_seen, 2 * 6 + 4 * 5 + 8 * 5 + 16 * 4);
}

#[test]
fn exact_ties_are_settled_exactly() {
    // Errors 1/3, 1/9, ...: at the distance 1/27 exactly from step 2 on.
    let start = vec![q("0"), q("1/6"), q("1")];
    let found = settling(&Starts::One(start), &q("1/3"), &q("1/27")).unwrap();
    assert_eq!(steps(found).1, 2);
    let at_targets = vec![q("0"), q("1/2"), q("1")];
    let found = settling(&Starts::One(at_targets), &q("1/3"), &q("1/27")).unwrap();
    assert_eq!(steps(found), (vec![0, 0], 0));
}

#[test]
fn from_the_command_line() {
    let args = ["settle", "--drones", "5", "--eps", "1/4", "--within", "0.01"];
    let (code, out, err) = run(&args);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("proved  step 35 ") && out.contains("true    step 26 "), "{out}");
    let (code, out, _) = run(&["settle", "--drones", "5", "--eps", "0.6", "--within", "1"]);
    assert_eq!(code, 1);
    assert!(out.contains("some start does not settle"), "{out}");
    let folder = tempfile::tempdir().unwrap();
    let (code, ..) = run(&[&args[..], &["--out", folder.path().to_str().unwrap()]].concat());
    assert_eq!(code, 0);
    let text = std::fs::read_to_string(folder.path().join("contraction-5.json")).unwrap();
    assert!(matches!(cordon_check::check(&text), cordon_check::Verdict::Valid { .. }));
    for (args, expected) in [
        (["--drones", "2", "--eps", "1/4", "--within", "1"], "drones: `2`"),
        (["--drones", "5", "--eps", "1/0", "--within", "1"], "eps: `1/0` divides by zero"),
        (["--drones", "5", "--eps", "1/4", "--within", "0"], "within: `0`"),
        (["--drones", "5", "--eps", "1/4", "--within", "-1"], "within: `-1`"),
    ] {
        let (code, out, err) = run(&[&["settle"], &args[..]].concat());
        assert_eq!((code, out.as_str()), (2, ""));
        assert!(err.contains(expected), "{err}");
    }
    let short = ["settle", "--drones", "5", "--eps", "1/4", "--within", "1", "--start", "0,1,2"];
    assert_eq!(run(&short).0, 2);
}
