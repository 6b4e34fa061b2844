//! The sweep kernel against the spec, and the range that is promised for its integers.
use std::cell::RefCell;
use std::ops::{Add, Mul, Sub};

use cordon_core::Rational;
use cordon_core::stencil::Stencil;
use cordon_proof::sweep::Item;
use cordon_proof::sweep::exhaust::{Exhaust, Tally, Trial};
use cordon_proof::sweep::grid::Grid;
use cordon_proof::sweep::kernel::{Update, Window};
use cordon_proof::sweep::lanes::Lanes;
use cordon_proof::sweep::machine::{Machine, Wide};
use cordon_proof::sweep::range::Range;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::theorems::{Form, Setting, StartSet, Theorem, Truth, Verdict};
use cordon_spec::{Ordered, Params, Scalar, State};
use num_bigint::{BigInt, BigUint};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

fn item(theorem: Theorem, form: Form, drones: usize, eps: (i64, i64)) -> Item {
    Item { number: 0, theorem, form, drones, eps: Rational::new(eps.0.into(), eps.1.into()) }
}

/// What the spec says at every step, on exact rationals.
fn by_the_spec(item: &Item, start: &[i64], steps: usize) -> Option<Vec<Verdict>> {
    let x: Vec<Rational> = start.iter().map(|x| Rational::from(BigInt::from(*x))).collect();
    let p = Params { min: x[0].clone(), max: x[x.len() - 1].clone(), eps: item.eps.clone(), n: 0 };
    let setting = Setting::from(&p);
    let starts = item.theorem.hypothesis(item.form).starts;
    if starts.contains(&setting, &x) != Truth::True {
        return None;
    }
    let span = item.theorem.span(item.form, item.drones);
    let mut placements = vec![x];
    for _ in 0..steps + span {
        let last = State { drones: placements.last().unwrap().clone(), timesteps: 0 };
        placements.push(exec_coverage(&p, &last).drones);
    }
    let verdict = |k: usize| item.theorem.conclusion(item.form, &setting, &placements[k..]);
    Some((0..=steps).map(verdict).collect())
}

fn tally(item: &Item, start: &[i64], steps: usize) -> Tally {
    let engine = Exhaust::new(item, steps, *start.last().unwrap());
    let mut trial = Trial::new(&engine, false);
    trial.start(start);
    trial.end()
}

/// Counts and first violation of the kernel are those of the spec, whatever the theorem, the
/// weight, the start and the widths of integers that the run goes through.
#[test]
fn kernel_is_the_spec_on_random_runs() {
    let strategy = (
        prop::sample::select(Theorem::ALL.to_vec()),
        prop::sample::select(Form::ALL.to_vec()),
        3usize..=10,
        (-3i64..=40, 1i64..=30),
        1u32..12,
        0usize..36,
        any::<u64>(),
    );
    let config =
        ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() };
    let mut runner = TestRunner::new_with_rng(
        config,
        proptest::test_runner::TestRng::deterministic_rng(
            proptest::test_runner::RngAlgorithm::ChaCha,
        ),
    );
    // Runs, violations, vacuous steps, and runs that end on each width of integers.
    let seen = RefCell::new((0, 0, 0, [0; 6]));
    runner
        .run(&strategy, |(theorem, form, drones, eps, resolution, steps, random)| {
            let item = item(theorem, form, drones, eps);
            let starts = theorem.hypothesis(form).starts;
            let grid = Grid::new(starts, drones, resolution + drones as u32).unwrap();
            let mut state = random;
            let mut below = |bound: u64| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (state >> 33) % bound
            };
            let mut start = Vec::new();
            prop_assert!(grid.draw(&mut below, &mut start));
            let expected = by_the_spec(&item, &start, steps).unwrap();
            let tally = tally(&item, &start, steps);
            let count = |f: fn(&Verdict) -> bool| expected.iter().filter(|v| f(v)).count() as u64;
            let violated = |v: &Verdict| matches!(v, Verdict::Violated(_));
            prop_assert_eq!(tally.counts.starts, 1);
            prop_assert_eq!(tally.counts.cases, steps as u64 + 1);
            prop_assert_eq!(tally.counts.undecided, 0);
            prop_assert_eq!(tally.counts.violations, count(violated));
            prop_assert_eq!(
                tally.counts.non_vacuous,
                count(|v| *v == Verdict::Holds) + count(violated)
            );
            let first = expected.iter().position(violated);
            prop_assert_eq!(tally.first.as_ref().map(|f| f.0), first);
            let lasts = Exhaust::new(&item, steps, grid.length).last_steps();
            let width = lasts.iter().position(|last| *last == Some(steps)).unwrap();
            let mut seen = seen.borrow_mut();
            seen.0 += 1;
            seen.1 += tally.counts.violations;
            seen.2 += tally.counts.cases - tally.counts.non_vacuous;
            seen.3[width] += 1;
            Ok(())
        })
        .unwrap();
    let (runs, violations, vacuous, widths) = seen.into_inner();
    assert_eq!(runs, 600);
    assert!(violations > 100, "{violations}");
    assert!(vacuous > 100, "{vacuous}");
    assert!(widths.iter().all(|w| *w > 20), "{widths:?}");
}

/// Many at once come to what each comes to alone, whatever they disagree about: all starts of a
/// set and others beside them, in any order, in batches full and not.
#[test]
fn starts_run_together_come_to_what_they_come_to_alone() {
    let (mut compared, mut violations, mut refused) = (0, 0, 0);
    for theorem in Theorem::ALL {
        for form in Form::ALL {
            for eps in [(1, 3), (1, 2), (3, 5), (5, 4), (7, 29)] {
                let item = item(theorem, form, 4, eps);
                let starts = theorem.hypothesis(form).starts;
                let engine = Exhaust::new(&item, 25, 9);
                let run = |starts: &[Vec<i64>]| {
                    let mut trial = Trial::new(&engine, false);
                    starts.iter().for_each(|start| trial.start(start));
                    trial.end()
                };
                let set = Grid::of_length(starts, 4, 9).unwrap();
                let mut all = Vec::new();
                for grid in [&set, &Grid::of_length(StartSet::Any, 4, 9).unwrap()] {
                    grid.for_each(&grid.whole(), |start| {
                        all.push(start.to_vec());
                        true
                    });
                }
                let each: Vec<_> =
                    all.iter().map(|start| run(std::slice::from_ref(start))).collect();
                for batch in [7, 16, 40] {
                    for (starts, tallies) in all.chunks(batch).zip(each.chunks(batch)) {
                        let alone = tallies.iter().cloned().fold(Tally::default(), Tally::merge);
                        assert_eq!(run(starts), alone, "{theorem:?} {form:?} {eps:?} {starts:?}");
                        compared += starts.len();
                        violations += alone.counts.violations;
                        refused += starts.len() as u64 - alone.counts.starts;
                    }
                }
            }
        }
    }
    assert_eq!(compared, 38_400);
    assert!(violations > 1000 && refused > 1000, "{violations} {refused}");
}

/// A start outside the theorem's set is not tried.
#[test]
fn starts_outside_the_hypothesis_are_refused() {
    let ordering = item(Theorem::Ordering, Form::Sharp, 4, (1, 3));
    assert_eq!(tally(&ordering, &[0, 2, 2, 6], 5), Tally::default());
    assert_eq!(tally(&ordering, &[0, 2, 3, 6], 5).counts.cases, 6);
    let bounded = item(Theorem::UpperBound, Form::Sharp, 4, (1, 3));
    assert_eq!(tally(&bounded, &[0, 3, 4, 6], 5), Tally::default());
    let subsegment = item(Theorem::UpperBound, Form::Paper, 4, (1, 3));
    assert_eq!(tally(&subsegment, &[0, 1, 2, 6], 5), Tally::default());
    assert_eq!(tally(&subsegment, &[0, 1, 2, 9], 5).counts.cases, 6);
}

/// Mirror pairs are run once and counted twice: the counts are those of all starts.
#[test]
fn mirror_reduction_changes_no_count() {
    let mut pairs = 0;
    for theorem in Theorem::ALL {
        for eps in [(1, 3), (1, 2), (3, 5), (1, 1)] {
            let item = item(theorem, Form::Sharp, 5, eps);
            let starts = theorem.hypothesis(Form::Sharp).starts;
            let grid = Grid::new(starts, 5, 8).unwrap();
            let engine = Exhaust::new(&item, 6, grid.length);
            let run = |mirrored| {
                let mut trial = Trial::new(&engine, mirrored);
                trial.sweep(&grid, &grid.whole());
                trial.end()
            };
            let (whole, mut reduced) = (run(false), run(Grid::mirrored(theorem, starts)));
            let saved = whole.counts.updates - reduced.counts.updates;
            assert_eq!(saved > 0, Grid::mirrored(theorem, starts), "{theorem:?}");
            pairs += u32::from(saved > 0);
            reduced.counts.updates = whole.counts.updates;
            assert_eq!(reduced, whole, "{theorem:?} {eps:?}");
        }
    }
    assert_eq!(pairs, 16);
}

thread_local! {
    /// The largest magnitude that a [`Recorded`] has had on this thread.
    static LARGEST: RefCell<BigUint> = const { RefCell::new(BigUint::ZERO) };
}

/// An integer that records the largest magnitude any of its kind ever had.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Recorded(BigInt);

fn recorded(x: BigInt) -> Recorded {
    LARGEST.with_borrow_mut(|largest| {
        if x.magnitude() > largest {
            largest.clone_from(x.magnitude());
        }
    });
    Recorded(x)
}

impl Add<&Self> for Recorded {
    type Output = Self;
    fn add(self, rhs: &Self) -> Self {
        recorded(self.0 + &rhs.0)
    }
}

impl Sub<&Self> for Recorded {
    type Output = Self;
    fn sub(self, rhs: &Self) -> Self {
        recorded(self.0 - &rhs.0)
    }
}

impl Mul<&Self> for Recorded {
    type Output = Self;
    fn mul(self, rhs: &Self) -> Self {
        recorded(self.0 * &rhs.0)
    }
}

impl Scalar for Recorded {
    fn from_int(n: i32) -> Self {
        recorded(n.into())
    }
}

impl Ordered for Recorded {
    fn compare(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.0.cmp(&other.0))
    }
}

impl Machine for Recorded {
    const MAGNITUDE_BITS: Option<u64> = None;

    type Weight = Self;

    fn from_i64(x: i64) -> Self {
        recorded(x.into())
    }

    fn narrow(x: &BigInt) -> Option<Self> {
        Some(Self(x.clone()))
    }

    fn weight(x: &BigInt) -> Option<Self> {
        Self::narrow(x)
    }

    fn weigh<const T: usize>(terms: [(&Self, &Self); T]) -> Self {
        let terms = terms.into_iter().map(|(w, x)| w.clone() * x);
        terms.fold(Self::from_int(0), |sum, term| sum + &term)
    }
}

/// No number that kernel and predicates ever compute exceeds the bound, whatever the theorem;
/// and the bound is no wild guess: some run comes within a factor of 2^8 of it.
#[test]
fn no_number_exceeds_the_bound() {
    let mut runs = 0;
    let mut closest = u64::MAX;
    for theorem in Theorem::ALL {
        for form in Form::ALL {
            for drones in [3usize, 4, 5, 8] {
                for eps in [(0, 1), (1, 5), (5, 12), (1, 2), (3, 5), (1, 1), (-1, 2), (7, 3)] {
                    for extreme in 0..4 {
                        let item = item(theorem, form, drones, eps);
                        let far: i64 = 1_000_003;
                        let x = |i: usize| match (i, extreme) {
                            (0, _) => 0,
                            (i, _) if i == drones - 1 => far,
                            (i, 0) => far * (i as i64 % 2),
                            (i, 1) => far * ((i as i64 + 1) % 2),
                            (i, 2) => i as i64,
                            (i, _) => far * i as i64 / (drones as i64 - 1),
                        };
                        let start: Vec<_> = (0..drones).map(|i| Recorded(x(i).into())).collect();
                        let range = Range::new(theorem, form, drones, &item.eps, &far.into());
                        LARGEST.with_borrow_mut(|largest| *largest = BigUint::ZERO);
                        let update =
                            Update::of(&Stencil::of(&item.eps)).try_map(Recorded::weight).unwrap();
                        let setting = Setting {
                            min: Recorded(0.into()),
                            max: Recorded(far.into()),
                            eps_num: Recorded(item.eps.numer().clone()),
                            eps_den: Recorded(item.eps.denom().clone()),
                        };
                        let span = theorem.span(form, drones);
                        let mut window = Window::new(setting, start, span, &update);
                        for k in 0..6 {
                            if k > 0 {
                                window.advance(&update);
                            }
                            window.verdict(theorem, form);
                            let largest = LARGEST.with_borrow(Clone::clone);
                            let bound = range.bound(k);
                            assert!(largest <= bound, "{theorem:?} {form:?} {drones} {eps:?} {k}");
                            closest = closest.min(bound.bits() - largest.bits());
                            runs += 1;
                        }
                    }
                }
            }
        }
    }
    assert_eq!(runs, 10 * 2 * 4 * 8 * 4 * 6);
    assert!(closest <= 8, "{closest}");
}

/// At the edge: the last step of each width fits, the next does not, and the runs that cross
/// it agree with the spec on both sides.
#[test]
fn widths_hand_over_at_their_edge() {
    let mut crossed = [0; 5];
    for theorem in [Theorem::Ordering, Theorem::ConstantSum, Theorem::Limit] {
        for eps in [(5, 12), (2, 5), (1, 3)] {
            let item = item(theorem, Form::Sharp, 5, eps);
            let range = Range::new(theorem, Form::Sharp, 5, &item.eps, &8.into());
            let lasts = [
                range.last_step::<Lanes<i32>>(500).unwrap(),
                range.last_step::<Lanes<f64>>(500).unwrap(),
                range.last_step::<Lanes<i64>>(500).unwrap(),
                range.last_step::<i128>(500).unwrap(),
                range.last_step::<Wide>(500).unwrap(),
            ];
            assert!(lasts.is_sorted());
            for ((last, bits), crossed) in
                lasts.into_iter().zip([31, 53, 63, 127, 255]).zip(&mut crossed)
            {
                assert!(range.bound(last).bits() <= bits);
                assert!(range.bound(last + 1).bits() > bits);
                let start = [0, 1, 2, 3, 8];
                if theorem == Theorem::ConstantSum && start[2] > 4 {
                    continue;
                }
                let expected = by_the_spec(&item, &start, last + 2).unwrap();
                let tally = tally(&item, &start, last + 2);
                let held = expected.iter().filter(|v| **v == Verdict::Holds).count() as u64;
                assert_eq!(tally.counts.non_vacuous, held);
                assert_eq!(tally.counts.violations, 0);
                assert_eq!(tally.counts.cases, last as u64 + 3);
                *crossed += 1;
            }
        }
    }
    assert_eq!(crossed, [9; 5]);
}

/// Weights too large for a width are left to the next.
#[test]
fn huge_weights_are_run_on_big_integers() {
    let huge: BigInt = BigInt::from(10).pow(90);
    let eps = Rational::new(huge.clone() / 3, huge);
    let item = Item { number: 0, theorem: Theorem::Ordering, form: Form::Sharp, drones: 4, eps };
    let lasts = Exhaust::new(&item, 4, 6).last_steps();
    assert_eq!(lasts, [None, None, None, None, None, Some(4)]);
    let expected = by_the_spec(&item, &[0, 1, 2, 6], 4).unwrap();
    assert!(expected.iter().all(|v| *v == Verdict::Holds));
    assert_eq!(tally(&item, &[0, 1, 2, 6], 4).counts.non_vacuous, 5);
}
