//! The fast engines against plain runs of the spec.
use std::cell::Cell;

use cordon_core::Rational;
use cordon_core::exact::decimal_string;
use cordon_run::fast::digits::{self, Digits, enclose};
use cordon_run::fast::multiply::NumBigint;
use cordon_run::fast::ntt::Ntt;
use cordon_run::fast::verify::verify;
use cordon_run::fast::{self, Engine, Line, Rule, jump, step};
use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::kth_step;
use cordon_spec::graph::Path;
use cordon_spec::{Params, Phase, State};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};

/// So many cases; a fifth of them where the build is slow.
const fn cases(release: u32) -> u32 {
    if cfg!(debug_assertions) { release / 5 } else { release }
}

/// The same cases in every run.
fn runner(cases: u32) -> TestRunner {
    let random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    TestRunner::new_with_rng(ProptestConfig::with_cases(cases), random)
}

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
    const CASES: u32 = cases(200);
    let (ran, above_half, negative, wrapped) =
        (Cell::new(0), Cell::new(0), Cell::new(0), Cell::new(0));
    let case = (coverage_case(), prop::collection::vec(0u64..50, 1..4));
    runner(CASES)
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
    assert!(
        above_half.get() > CASES / 10 && negative.get() > CASES / 10 && wrapped.get() > CASES / 4
    );
}

#[test]
fn consensus_jump_is_stepping_is_the_spec() {
    const CASES: u32 = cases(150);
    let ran = Cell::new(0);
    let case = (weight(), prop::collection::vec(number(), 3..9), 0u64..50);
    runner(CASES)
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

/// A verification draws primes from its seed, passes what is right and finds what is wrong,
/// wherever it is wrong.
#[test]
fn random_primes_catch_an_injected_fault() {
    const CASES: u32 = cases(100);
    let ran = Cell::new(0);
    let case = (
        coverage_case(),
        prop::collection::vec(0u64..40, 1..3),
        any::<prop::sample::Index>(),
        any::<prop::sample::Index>(),
        -1000i64..1000,
        any::<u64>(),
    );
    runner(CASES)
        .run(&case, |((p, start), steps, row, drone, fault, seed)| {
            let rule = Rule::Coverage { min: p.min, max: p.max, eps: p.eps };
            let mut answers = jump::at(&rule.line(&start).unwrap(), &steps, &Ntt).unwrap();
            let right = verify(&rule, &start, &answers, 2, seed).unwrap();
            prop_assert_eq!(right.disagreement, None);
            prop_assert_eq!(right.primes.len(), 2);
            prop_assert!(right.primes.iter().all(|p| p >> 60 == 1));
            prop_assert_eq!(right.compared, 2 * (steps.len() * start.len()) as u64);
            prop_assert!(right.log2_chance < -59.0);
            prop_assert_eq!(&verify(&rule, &start, &answers, 2, seed).unwrap(), &right);

            let row = row.index(answers.len());
            let drone = drone.index(start.len());
            answers[row].numerators[drone] += if fault >= 0 { fault + 1 } else { fault };
            let wrong = verify(&rule, &start, &answers, 1, seed).unwrap();
            let found = wrong.disagreement.expect("a fault that no prime shows");
            prop_assert_eq!((found.k, found.drone), (answers[row].k, drone));
            ran.set(ran.get() + 1);
            Ok(())
        })
        .unwrap();
    assert_eq!(ran.get(), CASES);
}

/// More drones than positions, or fewer, never pass.
#[test]
fn an_answer_of_another_length_is_a_disagreement() {
    let rule = Rule::Consensus { eps: ratio(1, 3) };
    let start = [0, 1, 5, 9].map(|x| ratio(x, 1));
    let line = rule.line(&start).unwrap();
    let mut answers = fast::engine::positions(&line, &[9], Engine::Jump).unwrap();
    assert_eq!(verify(&rule, &start, &answers, 1, 7).unwrap().disagreement, None);
    let last = answers[0].numerators.pop().unwrap();
    assert!(verify(&rule, &start, &answers, 1, 7).unwrap().disagreement.is_some());
    answers[0].numerators.extend([last.clone(), last]);
    assert!(verify(&rule, &start, &answers, 1, 7).unwrap().disagreement.is_some());
}

/// Enclosures contain the exact positions, are as narrow as asked, and the certain digits are
/// those of the exact positions.
#[test]
fn certain_digits_are_those_of_the_exact_positions() {
    const CASES: u32 = cases(200);
    let (ran, ties) = (Cell::new(0), Cell::new(0));
    let small = (-50i64..50, 1i64..8).prop_map(|(p, q)| ratio(p, q));
    let case = (weight(), prop::collection::vec(small, 3..9), 0u64..120, 0usize..40, any::<bool>());
    runner(CASES)
        .run(&case, |(eps, start, k, digits, coverage)| {
            let rule = if coverage {
                let (min, max) = (start[0].clone(), start[start.len() - 1].clone());
                Rule::Coverage { min, max, eps }
            } else {
                Rule::Consensus { eps }
            };
            let line = rule.line(&start).unwrap();
            let exact = step::at(&line, &[k]).unwrap()[0].positions(&NumBigint);
            let width = Rational::new(1.into(), num_bigint::BigInt::from(1) << 100u32);
            for (e, x) in enclose(&line, k, 100, &NumBigint).unwrap().iter().zip(&exact) {
                prop_assert!(e.lo <= *x && *x <= e.hi && &e.hi - &e.lo <= width);
            }
            let found = digits::at(&line, &[k], digits, &NumBigint).unwrap();
            prop_assert_eq!(found.len(), 1);
            for (p, x) in found[0].positions.iter().zip(&exact) {
                prop_assert_eq!(&p.decimal, &decimal_string(x, p.digits));
            }
            prop_assert!(found[0].certain() >= digits);
            let tie = found[0].positions.iter().any(|p| p.digits > digits);
            ties.set(ties.get() + u32::from(tie));
            ran.set(ran.get() + 1);
            Ok(())
        })
        .unwrap();
    assert_eq!(ran.get(), CASES);
    assert!(ties.get() <= CASES / 4, "{} ties", ties.get());
}

/// A position exactly between two decimals has a place more, and is certain too.
#[test]
fn ties_have_one_place_more() {
    let rule = Rule::Consensus { eps: ratio(1, 4) };
    let line = rule.line(&[ratio(6, 1), ratio(6, 1), ratio(8, 1)]).unwrap();
    let found = digits::at(&line, &[1], 0, &Ntt).unwrap();
    let decimals: Vec<_> = found[0].positions.iter().map(|p| p.decimal.as_str()).collect();
    assert_eq!(decimals, ["6", "6.5", "7.5"]);
}

/// Numbers of steps that no exact run reaches.
#[test]
fn digits_after_any_number_of_steps() {
    let rule = |eps| Rule::Coverage { min: ratio(0, 1), max: ratio(100, 1), eps };
    let start = [0, 10, 20, 30, 100].map(|x| ratio(x, 1));
    let line = rule(ratio(1, 5)).line(&start).unwrap();
    let found = digits::at(&line, &[u64::MAX, 0, 1], 30, &Ntt).unwrap();
    let decimals = |d: &Digits| d.positions.iter().map(|p| p.decimal.clone()).collect::<Vec<_>>();
    let zeros = "0".repeat(30);
    let wanted = |x: [u32; 5]| x.map(|n| format!("{n}.{zeros}")).to_vec();
    assert_eq!(decimals(&found[0]), wanted([0, 25, 50, 75, 100]));
    assert_eq!(decimals(&found[1]), wanted([0, 10, 20, 30, 100]));
    assert_eq!(decimals(&found[2]), wanted([0, 10, 20, 42, 100]));
    // A weight beyond 1/2 cancels away as many bits as there are steps, and says so.
    let beyond = rule(ratio(7, 10)).line(&start).unwrap();
    let said = digits::at(&beyond, &[u64::MAX], 30, &Ntt).unwrap_err().to_string();
    assert!(said.contains("certain digits of 5 drones take about"), "{said}");
    assert_eq!(digits::at(&beyond, &[500], 5, &Ntt).unwrap()[0].certain(), 5);
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
