//! Every harness body without the model checker: on every combination of small values, and on
//! random values of the full size.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook};

use cordon_kani::harness::Tally;
use cordon_kani::source::{Bytes, Case, Enumerator};
use cordon_kani::{Expected, Harness, all};
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Random cases for each harness.
const RANDOM: u32 = 4_000;

/// More than the longest body reads: 16 positions of two bytes, and some flags.
const BYTES: usize = 64;

/// How many cases the exhaustive test runs, those discarded included.
const EXHAUSTIVE: u64 = 52_125_446;

/// How many of them reach their assertions.
const CHECKED: u64 = 45_973_919;

/// Which harnesses a run of the model checker has to report; a smaller number means that a
/// module has fallen out of the list.
const HARNESSES: usize = 128;

/// The case, or nothing where an assertion failed.
fn attempt(body: impl FnOnce() -> Case) -> Result<Case, String> {
    catch_unwind(AssertUnwindSafe(body)).map_err(|why| {
        let text = why.downcast_ref::<&str>().map(|s| (*s).to_owned());
        text.or_else(|| why.downcast_ref::<String>().cloned()).unwrap_or_default()
    })
}

/// Assertions that fail in a body are counted, and reported by these tests where they should have
/// held: a message of each would fill the screen. Those of the tests themselves are printed.
fn without_messages_of_bodies() {
    set_hook(Box::new(|why| {
        if !why.location().is_some_and(|at| at.file().starts_with("kani/src")) {
            eprintln!("{why}");
        }
    }));
}

/// Runs the body on every combination of small values. A harness that has to fail is tried to
/// the end all the same.
fn enumerate(harness: &Harness) -> Result<(Tally, u64), String> {
    let (mut tally, mut failed) = (Tally::default(), 0);
    let mut source = Enumerator::default();
    loop {
        match attempt(|| (harness.exhaustive)(&mut source)) {
            Ok(case) => tally.count(case),
            Err(why) if harness.expected == Expected::Holds => {
                return Err(format!("{}: {why}, at {source:?}", harness.name));
            }
            Err(_) => failed += 1,
        }
        if !source.advance() {
            return Ok((tally, failed));
        }
    }
}

#[test]
fn on_every_combination_of_small_values() {
    without_messages_of_bodies();
    let (mut ran, mut checked) = (0, 0);
    let mut problems = Vec::new();
    for harness in all() {
        match enumerate(harness) {
            Err(why) => problems.push(why),
            Ok((tally, failed)) => {
                if (failed > 0) != (harness.expected == Expected::Fails) {
                    problems.push(format!("{}: {failed} cases fail", harness.name));
                }
                if tally.witnessed == 0 {
                    problems.push(format!("{}: no witness among {tally:?}", harness.name));
                }
                ran += tally.discarded + tally.checked + failed;
                checked += tally.checked + failed;
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert_eq!((ran, checked), (EXHAUSTIVE, CHECKED), "cases that ran, and were checked");
}

#[test]
fn on_random_values_of_the_full_size() {
    without_messages_of_bodies();
    let mut problems = Vec::new();
    let mut ran = 0;
    for harness in all().filter(|h| h.expected == Expected::Holds) {
        let seed = b"cordon: the seed of the harness.";
        let rng = TestRng::from_seed(RngAlgorithm::ChaCha, seed);
        let config = Config { cases: RANDOM, failure_persistence: None, ..Config::default() };
        let tally = RefCell::new(Tally::default());
        let found = TestRunner::new_with_rng(config, rng).run(&vec(any::<u8>(), BYTES), |bytes| {
            let case = attempt(|| (harness.from_bytes)(&mut Bytes::new(&bytes)));
            tally.borrow_mut().count(case.map_err(TestCaseError::fail)?);
            Ok(())
        });
        if let Err(why) = found {
            problems.push(format!("{}: {why}", harness.name));
        }
        let tally = tally.into_inner();
        if tally.checked == 0 {
            problems.push(format!("{}: nothing checked: {tally:?}", harness.name));
        }
        ran += tally.discarded + tally.checked;
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    let holding = all().filter(|h| h.expected == Expected::Holds).count() as u64;
    assert_eq!(ran, holding * u64::from(RANDOM), "random cases");
}

#[test]
fn the_list_is_whole() {
    let names: Vec<_> = all().map(|h| h.name).collect();
    assert_eq!(names.len(), HARNESSES, "harnesses");
    assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len(), "names are unique");
    let subjects: BTreeSet<_> = all().map(|h| h.subject).collect();
    for theorem in cordon_spec::theorems::Theorem::ALL {
        let number = theorem.number();
        assert!(subjects.contains(number), "no harness about {number}");
    }
    for harness in all() {
        assert!(harness.claim.ends_with('.'), "{}: {}", harness.name, harness.claim);
        assert!(!(harness.bounds)().is_empty(), "{} has no bounds", harness.name);
    }
    assert_eq!(all().filter(|h| h.expected == Expected::Fails).count(), 9, "counterexamples");
}
