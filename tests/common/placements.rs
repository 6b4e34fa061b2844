//! Exact numbers, starts and runs, written or generated.

use std::cell::Cell;
use std::fmt::Debug;

use cordon_core::Rational;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::{Params, Scalar, State};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// The exact rational that the text says.
pub fn q(text: &str) -> Rational {
    cordon_core::exact::parse("test", text).unwrap()
}

/// Exact rationals from a list like `0, 1/2, 3`.
pub fn qs(list: &str) -> Vec<Rational> {
    list.split(',').map(q).collect()
}

/// Parameters on the segment between the ends of the start; every tick is a protocol step.
pub fn params_for<S: Scalar>(eps: S, start: &[S]) -> Params<S> {
    Params { min: start[0].clone(), max: start[start.len() - 1].clone(), eps, n: 0 }
}

/// X^0, .., X^k.
pub fn placements<S: Scalar>(p: &Params<S>, start: Vec<S>, k: usize) -> Vec<Vec<S>> {
    let mut state = State { drones: start, timesteps: 0 };
    let mut run = vec![state.drones.clone()];
    for _ in 0..k {
        state = exec_coverage(p, &state);
        run.push(state.drones.clone());
    }
    run
}

/// Runs a property on exactly `cases` generated values (the same ones each time) and asserts
/// that so many ran.
pub fn for_cases<T: Debug>(
    cases: u32,
    strategy: impl Strategy<Value = T>,
    property: impl Fn(T) -> Result<(), TestCaseError>,
) {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, b"cordon: the seed of the property");
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let ran = Cell::new(0);
    TestRunner::new_with_rng(config, rng)
        .run(&strategy, |value| {
            ran.set(ran.get() + 1);
            property(value)
        })
        .unwrap();
    assert_eq!(ran.get(), cases, "cases that ran");
}

/// Rationals with small numerators and denominators.
pub fn rational() -> impl Strategy<Value = Rational> {
    (-60i32..=60, 1i32..=12).prop_map(|(n, d)| Rational::new(n.into(), d.into()))
}

/// Weights p/q in [0, 1].
pub fn weight() -> impl Strategy<Value = Rational> {
    (1i32..=12)
        .prop_flat_map(|d| (0..=d, Just(d)))
        .prop_map(|(n, d)| Rational::new(n.into(), d.into()))
}

/// Any placements of 3 to 9 drones with min < max.
pub fn start() -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec(rational(), 3..=9).prop_filter("min < max", |x| x[0] < x[x.len() - 1])
}
