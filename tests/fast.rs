//! The fast engines against plain runs of the spec.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::cell::Cell;

use cordon::Rational;
use cordon::fast::multiply::NumBigint;
use cordon::fast::{Line, jump, step};
use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::kth_step;
use cordon_spec::graph::Path;
use cordon_spec::{Params, Phase, State};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

fn ratio(p: i64, q: i64) -> Rational {
    Rational::new(p.into(), q.into())
}

/// A position or a weight: small, large, of either sign, with small and large denominators.
fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        4 => (-50i64..50, 1i64..8).prop_map(|(p, q)| ratio(p, q)),
        1 => (any::<i64>(), 1i64..i64::MAX).prop_map(|(p, q)| ratio(p, q)),
        1 => (any::<i128>(), 1i128..i128::MAX)
            .prop_map(|(p, q)| Rational::new(p.into(), q.into())),
    ]
}

/// A weight eps: the corners by name, below and above 1/2, negative, any.
fn weight() -> impl Strategy<Value = Rational> {
    prop_oneof![
        Just(ratio(0, 1)),
        Just(ratio(1, 2)),
        Just(ratio(1, 1)),
        Just(ratio(1, 5)),
        Just(ratio(-1, 1)),
        (1i64..20, 2i64..40).prop_map(|(p, q)| ratio(p, q)),
        (1i64..20, 2i64..40).prop_map(|(p, q)| ratio(-p, q)),
        number(),
    ]
}

/// The spec's X^k.
fn spec_coverage(p: &Params<Rational>, start: &[Rational], k: u64) -> Vec<Rational> {
    kth_step(p, State::initial(start.to_vec(), p.n, Phase::First), k).drones
}

fn coverage_case() -> impl Strategy<Value = (Params<Rational>, Vec<Rational>)> {
    (weight(), number(), number(), prop::collection::vec(number(), 1..9)).prop_map(
        |(eps, min, max, inner)| {
            let start = [min.clone()].into_iter().chain(inner).chain([max.clone()]).collect();
            (Params { min, max, eps, n: 0 }, start)
        },
    )
}

#[test]
fn jump_is_stepping_is_the_spec() {
    const CASES: u32 = 300;
    let (ran, above_half, negative, wrapped) =
        (Cell::new(0), Cell::new(0), Cell::new(0), Cell::new(0));
    let case = (coverage_case(), prop::collection::vec(0u64..60, 1..4));
    TestRunner::new(ProptestConfig::with_cases(CASES))
        .run(&case, |((p, start), steps)| {
            let line = Line::coverage(&p, &start).unwrap();
            let stepped = step::at(&line, &steps).unwrap();
            let jumped = jump::at(&line, &steps, &NumBigint).unwrap();
            prop_assert_eq!(stepped.len(), steps.len());
            prop_assert_eq!(&stepped, &jumped);
            for (answer, &k) in stepped.iter().zip(&steps) {
                prop_assert_eq!(answer.k, k);
                prop_assert_eq!(answer.positions(&NumBigint), spec_coverage(&p, &start, k));
                wrapped.set(wrapped.get() + u32::from(k > 2 * start.len() as u64));
            }
            ran.set(ran.get() + 1);
            above_half.set(above_half.get() + u32::from(p.eps > ratio(1, 2)));
            negative.set(negative.get() + u32::from(p.eps < ratio(0, 1)));
            Ok(())
        })
        .unwrap();
    assert_eq!(ran.get(), CASES);
    // Every kind of sign pattern occurred, and kernels that went round the ring.
    assert!(above_half.get() > 20 && negative.get() > 20 && wrapped.get() > 100);
}

#[test]
fn consensus_jump_is_stepping_is_the_spec() {
    const CASES: u32 = 150;
    let ran = Cell::new(0);
    let case = (weight(), prop::collection::vec(number(), 3..9), 0u64..50);
    TestRunner::new(ProptestConfig::with_cases(CASES))
        .run(&case, |(eps, start, k)| {
            let line = Line::consensus(&eps, &start).unwrap();
            let path = Path { count: start.len() };
            let spec = (0..k).fold(start, |x, _| exec_consensus(&eps, &path, &x));
            for answers in [step::at(&line, &[k]), jump::at(&line, &[k], &NumBigint)] {
                let answers = answers.unwrap();
                prop_assert_eq!(answers[0].positions(&NumBigint), spec.clone());
            }
            ran.set(ran.get() + 1);
            Ok(())
        })
        .unwrap();
    assert_eq!(ran.get(), CASES);
}

/// Lengths of line and runs around every corner of the engines: the least line, kernels that
/// just reach the end of the ring, powers of two and their neighbours.
#[test]
fn every_small_line_and_step_count() {
    let mut cases = 0;
    for count in 3..=9usize {
        for eps in [ratio(1, 5), ratio(1, 2), ratio(7, 10), ratio(-1, 3), ratio(0, 1), ratio(3, 4)]
        {
            let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps, n: 0 };
            let place = |i| if i + 1 == count { ratio(100, 1) } else { ratio(40 * i as i64, 8) };
            let start: Vec<_> = (0..count).map(place).collect();
            let line = Line::coverage(&p, &start).unwrap();
            let steps: Vec<u64> = (0..=40).rev().collect();
            let stepped = step::at(&line, &steps).unwrap();
            assert_eq!(stepped, jump::at(&line, &steps, &NumBigint).unwrap(), "{p:?}");
            let last = &stepped[0];
            assert_eq!(last.positions(&NumBigint), spec_coverage(&p, &start, 40));
            cases += steps.len();
        }
    }
    assert_eq!(cases, 7 * 6 * 41);
}

/// A mirrored start has the mirrored run.
#[test]
fn mirrored_starts_mirror() {
    let start = [0, 3, 4, 40, 41, 42, 100].map(|x| ratio(x, 1));
    let mirrored: Vec<_> = start.iter().rev().map(|x| ratio(100, 1) - x).collect();
    let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(2, 7), n: 0 };
    let after = |start: &[Rational]| {
        let line = Line::coverage(&p, start).unwrap();
        jump::at(&line, &[777], &NumBigint).unwrap()[0].positions(&NumBigint)
    };
    let back: Vec<_> = after(&mirrored).iter().rev().map(|x| ratio(100, 1) - x).collect();
    assert_eq!(after(&start), back);
}

#[test]
fn answers_beyond_memory_are_refused_with_their_size() {
    let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(1, 5), n: 0 };
    let line = Line::coverage(&p, &[0, 10, 100].map(|x| ratio(x, 1))).unwrap();
    for k in [10_000_000_000, u64::MAX] {
        for refusal in [step::at(&line, &[1, k]), jump::at(&line, &[1, k], &NumBigint)] {
            let said = refusal.unwrap_err().to_string();
            let wanted = format!("at: `{k}`: the exact positions of 3 drones");
            assert!(said.starts_with(&wanted), "{said}");
        }
    }
}
