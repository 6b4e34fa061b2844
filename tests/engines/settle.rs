//! Settling steps: proved and true, against runs of the spec.
use std::cell::Cell;

use crate::common::{for_cases, params_for, placements, q, run};
use cordon_core::Rational;
use cordon_proof::settle::{Observed, Settling, Starts, settling};
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
    let Settling::Settles { proved, not_before, observed: Observed::Step(step) } = found else {
        panic!("{found:?}")
    };
    assert!(not_before <= step, "{not_before} {step}");
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
fn jumps_land_on_the_step_that_doubles_find() {
    // Long enough for jumps; doubles are off by far less than the margin asserted.
    let mut jumped = 0;
    for (count, num, den) in [(60, 1, 2), (61, 1, 3), (75, 2, 5), (80, 1, 2)] {
        let eps = Rational::new(num.into(), den.into());
        let within = 1e-3;
        let found = settling(&Starts::AllWithin(count), &eps, &q("1/1000")).unwrap();
        let (_, step) = steps(found);
        let weight = f64::from(num) / f64::from(den);
        let mut e: Vec<f64> = (0..count).map(|i| i as f64 / (count - 1) as f64).collect();
        e[count - 1] = 0.0;
        let largest = |e: &[f64]| e.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        for k in 1..=step {
            let before = e.clone();
            for i in 1..count - 1 {
                e[i] = weight * (before[i - 1] + before[i + 1]) + (1.0 - 2.0 * weight) * before[i];
            }
            let inside = largest(&e) <= within;
            assert_eq!(inside, k == step, "N = {count}, step {k} of {step}: {}", largest(&e));
        }
        assert!(step > 2_000, "{step}: not a jump");
        jumped += 1;
    }
    assert_eq!(jumped, 4);
}

#[test]
fn long_runs_beyond_one_half_are_bracketed_without_being_executed() {
    let eps = q("50001/100000");
    let found = settling(&Starts::AllWithin(200), &eps, &q("1/1000")).unwrap();
    let Settling::Settles { proved, not_before, observed: Observed::TooLong } = found else {
        panic!("executed")
    };
    assert!(50_000 < not_before && not_before < proved[0].step, "{not_before} {proved:?}");
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

/// The start's errors have not the signs for a lower bound, and the weight is tiny: jumps find the
/// step, and no step is walked.
#[test]
fn vacuous_lower_bounds_do_not_make_long_walks() {
    let start = crate::common::qs("0,0,0,1");
    let found = settling(&Starts::One(start), &q("1e-8"), &q("1/2")).unwrap();
    let Settling::Settles { not_before, .. } = &found else { panic!("{found:?}") };
    assert_eq!(*not_before, 0);
    let (proved, step) = steps(found);
    assert!(10_000_000 < step && proved.iter().all(|p| *p >= step), "{step} {proved:?}");
}

/// Without a contraction a run may stay within the distance all the same.
#[test]
fn runs_that_do_not_converge_are_judged_by_their_errors() {
    let every =
        |count, eps, within| settling(&Starts::AllWithin(count), &q(eps), &q(within)).unwrap();
    let one = |start: &str, eps, within| {
        settling(&Starts::One(crate::common::qs(start)), &q(eps), &q(within)).unwrap()
    };
    let never = |found| matches!(found, Settling::NotFromEveryStart(_));
    let stays = |step, converges| Settling::Stays { step, converges };
    assert_eq!(every(3, "1", "100"), stays(0, false));
    assert_eq!(every(3, "1", "1/2"), stays(0, false));
    assert!(never(every(3, "1", "49/100")));
    assert_eq!(every(5, "0", "1"), stays(0, false));
    assert_eq!(every(5, "0", "3/4"), stays(0, false));
    assert!(never(every(5, "0", "7/10")));
    assert_eq!(every(4, "2/3", "1"), stays(0, false));
    assert!(never(every(4, "2/3", "1/3")));
    // Beyond the critical weight errors grow, but for those that are not there.
    assert!(never(every(4, "3/4", "100")));
    assert_eq!(one("0,1,2,3", "3/4", "1/100"), stays(0, true), "the start is the targets");
    assert_eq!(one("0,1,2", "1", "1/100"), stays(0, true));
    assert_eq!(one("0,1,3", "1", "1/2"), stays(0, false), "to and fro for ever");
    assert!(never(one("0,1,1,3", "3/4", "1/100")));
    // N = 4, eps = 2/3: e = s/3^k +- d, against runs of the spec.
    let mut compared = 0;
    for (a, b) in [("1/2", "3"), ("0", "5"), ("3", "3"), ("1", "2"), ("4", "-1")] {
        for within in ["1/10", "1/2", "1", "5/4", "3/2", "2", "3", "7"] {
            let start = crate::common::qs(&format!("0,{a},{b},3"));
            let found = settling(&Starts::One(start.clone()), &q("2/3"), &q(within)).unwrap();
            let step = by_running(&start, &q("2/3"), &q(within), 40);
            // The difference of the errors changes its sign for ever, their sum fades.
            let converges = q(a) - q("1") == q(b) - q("2");
            let expected = if step > 30 {
                Settling::NeverFromThisStart
            } else {
                Settling::Stays { step, converges }
            };
            assert_eq!(found, expected, "{a} {b} {within}");
            compared += 1;
        }
    }
    assert_eq!(compared, 40);
    // Distances far below what doubles hold.
    let tiny = format!("1/1{}", "0".repeat(300));
    let Settling::Settles { proved, observed: Observed::Step(step), .. } = every(5, "1/2", &tiny)
    else {
        panic!("too long")
    };
    assert_eq!(step, by_running(&crate::common::qs("0,1,1,1,1"), &q("1/2"), &q(&tiny), 2_050));
    assert!(proved.iter().all(|p| p.step >= step));
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
    let stays = ["settle", "--drones", "3", "--eps", "1", "--within", "100"];
    let (code, out, _) = run(&stays);
    assert_eq!(code, 0);
    assert!(out.contains("true    step 0 ") && out.contains("not every start converges"), "{out}");
    let (code, out, _) = run(&[&stays[..], &["--format", "json"]].concat());
    assert_eq!((code, out.contains("\"settles\": true")), (0, true));
    let never = ["settle", "--drones", "3", "--eps", "1", "--within", "0.1", "--start", "0,1,4"];
    assert_eq!(run(&never).0, 1);
    let short = ["settle", "--drones", "5", "--eps", "1/4", "--within", "1", "--start", "0,1,2"];
    assert_eq!(run(&short).0, 2);
}
