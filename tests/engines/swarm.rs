//! Doubles against exact runs: the printed bound holds, and is worth printing.
use std::cell::Cell;

use cordon_core::Rational;
use cordon_run::fast::multiply::NumBigint;
use cordon_run::fast::{Line, step};
use cordon_run::swarm::Swarm;
use cordon_spec::Params;
use num_traits::{FromPrimitive, Signed};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};

fn ratio(p: i64, q: i64) -> Rational {
    Rational::new(p.into(), q.into())
}

fn exact_run(eps: &Rational, start: &[Rational], k: u64) -> Vec<Rational> {
    let (min, max) = (start[0].clone(), start[start.len() - 1].clone());
    let p = Params { min, max, eps: eps.clone(), n: 0 };
    let line = Line::coverage(&p, start).unwrap();
    step::at(&line, &[k]).unwrap()[0].positions(&NumBigint)
}

/// The exact largest distance of the doubles from the exact run.
fn distance(swarm: &Swarm, exact: &[Rational]) -> Rational {
    let away = |(x, exact): (&f64, &Rational)| (Rational::from_f64(*x).unwrap() - exact).abs();
    swarm.positions().iter().zip(exact).map(away).max().unwrap()
}

#[test]
fn bounds_hold_against_exact_runs() {
    const CASES: u32 = 300;
    let (ran, inexact, useful) = (Cell::new(0), Cell::new(0), Cell::new(0));
    let number = || (-1000i64..1000, 1i64..50).prop_map(|(p, q)| ratio(p, q));
    let weight = (-20i64..60, 30i64..61).prop_map(|(p, q)| ratio(p, q));
    let case = (weight, prop::collection::vec(number(), 3..20), 0u64..60);
    TestRunner::new_with_rng(
        ProptestConfig::with_cases(CASES),
        TestRng::deterministic_rng(RngAlgorithm::ChaCha),
    )
    .run(&case, |(eps, start, k)| {
        let mut swarm = Swarm::new(&eps, &start).unwrap();
        swarm.advance(k);
        prop_assert_eq!(swarm.steps(), k);
        let exact = exact_run(&eps, &start, k);
        let away = distance(&swarm, &exact);
        prop_assert!(away <= Rational::from_f64(swarm.error()).unwrap());
        let gaps = exact.windows(2).map(|w| &w[1] - &w[0]).min().unwrap();
        let (gap, margin) = swarm.smallest_gap();
        let off = (Rational::from_f64(gap).unwrap() - gaps).abs();
        prop_assert!(off <= Rational::from_f64(margin).unwrap());
        let (last, n) = (exact.len() - 1, exact.len());
        let target =
            |i: usize| &exact[0] + (&exact[last] - &exact[0]) * ratio(i as i64, n as i64 - 1);
        let deviation = (0..n).map(|i| (&exact[i] - target(i)).abs()).max().unwrap();
        let (found, margin) = swarm.largest_deviation();
        let off = (Rational::from_f64(found).unwrap() - deviation).abs();
        prop_assert!(off <= Rational::from_f64(margin).unwrap());
        ran.set(ran.get() + 1);
        inexact.set(inexact.get() + u32::from(away.is_positive()));
        let in_range = eps >= ratio(0, 1) && eps <= ratio(1, 2);
        if in_range {
            prop_assert!(swarm.error() < 1e-10, "{}", swarm.error());
            useful.set(useful.get() + 1);
        }
        Ok(())
    })
    .unwrap();
    assert_eq!(ran.get(), CASES);
    assert!(inexact.get() > CASES / 2 && useful.get() > 50);
}

/// Blocks do not show: more drones than a block holds, more steps than a task does at once.
#[test]
fn blocks_agree_with_exact_runs() {
    let (count, k) = (20_000, 300);
    let eps = ratio(1, 4);
    let ends = [ratio(0, 1), ratio(100, 1), ratio(40, 1)];
    let mut swarm = Swarm::spread(&eps, count, [&ends[0], &ends[1], &ends[2]]).unwrap();
    swarm.advance(k);
    let place = |i: usize| {
        if i + 1 == count { ratio(100, 1) } else { ratio(40 * i as i64, count as i64 - 1) }
    };
    let start: Vec<_> = (0..count).map(place).collect();
    let away = distance(&swarm, &exact_run(&eps, &start, k));
    assert!(away.is_positive() && away <= Rational::from_f64(swarm.error()).unwrap());
    assert!(swarm.error() < 1e-10);
    // Only the last few hundred drones have heard of the gap at the end.
    let moved = swarm
        .positions()
        .iter()
        .zip(&start)
        .filter(|(x, s)| (Rational::from_f64(**x).unwrap() - *s).abs() > ratio(1, 1_000_000));
    assert!((50..400).contains(&moved.count()));
}

#[test]
fn what_doubles_do_not_hold_is_refused() {
    let tiny = Rational::new(1.into(), num_bigint::BigInt::from(10).pow(320));
    let start = [0, 1, 2].map(|x| ratio(x, 1));
    assert!(Swarm::new(&tiny, &start).unwrap_err().to_string().starts_with("eps: "));
    let far = Rational::from_integer(num_bigint::BigInt::from(10).pow(400));
    let start = [ratio(0, 1), ratio(1, 1), far];
    assert!(Swarm::new(&ratio(1, 5), &start).unwrap_err().to_string().starts_with("start: "));
    assert!(
        Swarm::new(&ratio(1, 5), &start[..2]).unwrap_err().to_string().starts_with("drones: `2`")
    );
}
