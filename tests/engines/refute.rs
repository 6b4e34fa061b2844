//! The search for counterexamples: what it finds replays, what it excludes does not exist.
use crate::common::{q, qs, run};
use cordon_check::{Verdict, check};
use cordon_core::Rational;
use cordon_core::linear::simplest::{fractions_within, strictly_between};
use cordon_proof::certificate::{Departure, refutation};
use cordon_proof::counterexample::Counterexample;
use cordon_proof::refute::departing::{self, Departures};
use cordon_proof::refute::{Extent, SearchSpace, search};
use cordon_spec::theorems::{Form, Theorem};
use num_traits::{One, Zero};

/// Weights, and whether they count beyond the theorem's range.
type Weights = (Vec<Rational>, bool);

fn space(theorem: Theorem, form: Form, drones: &[usize], weights: Weights) -> SearchSpace {
    let (weights, any_weight) = weights;
    SearchSpace { theorem, form, drones: drones.to_vec(), weights, any_weight, steps: 4 }
}

fn given(weights: &str) -> Weights {
    (qs(weights), true)
}

fn valid(found: &Counterexample) -> bool {
    matches!(check(&refutation(found).to_string()), Verdict::Valid { .. })
}

/// All starts on the segment [0, 1] with internal positions that are multiples of 1/parts
/// within [-1/2, 3/2].
fn lattice(count: usize, parts: i32) -> Vec<Vec<Rational>> {
    let places: Vec<Rational> =
        (-parts / 2..=parts * 3 / 2).map(|n| Rational::new(n.into(), parts.into())).collect();
    let internal = u32::try_from(count - 2).unwrap();
    (0..places.len().pow(internal))
        .map(|code| {
            let digit = |i: u32| places[code / places.len().pow(i) % places.len()].clone();
            let inner = (0..internal).map(digit);
            [Rational::zero()].into_iter().chain(inner).chain([Rational::one()]).collect()
        })
        .collect()
}

#[test]
fn the_search_misses_nothing_that_a_lattice_of_starts_has() {
    let (mut excluded, mut found, mut on_lattice, mut runs) = (0, 0, 0, 0);
    for theorem in Theorem::ALL {
        for form in Form::ALL {
            for count in [3, 4] {
                for eps in ["0", "1/4", "1/2", "2/3", "1", "5/4", "-1/3"] {
                    let answer = search(&space(theorem, form, &[count], given(eps)));
                    let eps = q(eps);
                    let bound = match &answer.found {
                        Some(c) => {
                            assert!(valid(c), "{theorem:?} {form:?} {count} {eps}");
                            found += 1;
                            c.step
                        }
                        None => {
                            excluded += 1;
                            5
                        }
                    };
                    // Nothing on the lattice at an earlier step than the one found.
                    let complete = answer.covered.iter().all(|c| c.extent >= Extent::EveryStart)
                        && theorem != Theorem::Limit;
                    for start in lattice(count, if count == 3 { 24 } else { 6 }) {
                        for k in 0..=4 {
                            runs += 1;
                            let run = Counterexample::replay(theorem, form, &eps, start.clone(), k);
                            if run.is_some() {
                                on_lattice += 1;
                                assert!(
                                    k >= bound || !complete,
                                    "{theorem:?} {form:?} {count} {eps} {k} {start:?}"
                                );
                                assert!(answer.found.is_some(), "{theorem:?} {form:?} {eps}");
                            }
                        }
                    }
                }
            }
        }
    }
    assert_eq!(excluded + found, 10 * 2 * 2 * 7);
    assert_eq!(runs, 10 * 2 * 7 * 5 * (49 + 169));
    assert!(
        excluded >= 100 && found >= 60 && on_lattice >= 1_000,
        "{excluded} {found} {on_lattice}"
    );
}

#[test]
fn every_theorem_stands_in_its_own_range() {
    let weights = fractions_within(&Rational::zero(), &Rational::one(), 6);
    let mut pairs = 0;
    for theorem in Theorem::ALL {
        let own = (weights.clone(), false);
        let answer = search(&space(theorem, Form::Sharp, &[3, 4, 5], own));
        assert!(answer.found.is_none(), "{theorem:?}");
        let for_ever = |c: &cordon_proof::refute::Coverage| c.extent == Extent::EveryStartAndStep;
        assert!(answer.covered.iter().all(for_ever), "{theorem:?}");
        pairs += answer.covered.len();
    }
    // Of 13 fractions up to 1: 7 up to 1/2, 6 of them positive.
    let ordering = 13 + 7 + 7;
    let limit = 11 + 7 + 6;
    assert_eq!(pairs, ordering + 4 * 21 + 2 * 39 + 2 * 18 + limit);
}

#[test]
fn printed_forms_fail_at_zero_weight() {
    for (theorem, drones) in
        [(Theorem::ConstantSum, 3), (Theorem::GloballyIncreasing, 5), (Theorem::Limit, 3)]
    {
        let weights = (qs("0, 1/4"), false);
        let found = search(&space(theorem, Form::Paper, &[3, 4, 5], weights)).found.unwrap();
        assert_eq!((found.start().len(), found.eps.clone()), (drones, q("0")), "{theorem:?}");
        assert!(found.weight_is_in_range() && valid(&found));
    }
}

#[test]
fn beyond_one_half_the_smallest_counterexamples_are_one_step_long() {
    let mut seen = 0;
    for (theorem, smallest) in [(Theorem::Ordering, 4), (Theorem::UpperBound, 3)] {
        for eps in ["501/1000", "4/7", "3/4", "1"] {
            let drones = [3, 4, 5];
            let found = search(&space(theorem, Form::Sharp, &drones, given(eps))).found.unwrap();
            assert_eq!((found.start().len(), found.step), (smallest, 1), "{theorem:?} {eps}");
            assert!(!found.weight_is_in_range() && valid(&found));
            seen += 1;
        }
    }
    assert_eq!(seen, 8);
}

fn skipping(space: &SearchSpace) -> cordon_core::Result<cordon_proof::refute::SearchResult> {
    departing::search(space, Departures::Skips)
}

#[test]
fn skipped_updates_break_nothing_up_to_one_half() {
    let weights = fractions_within(&Rational::zero(), &q("1/2"), 5);
    for theorem in [Theorem::Ordering, Theorem::UpperBound, Theorem::SumBounded] {
        let own = (weights.clone(), true);
        let answer = skipping(&space(theorem, Form::Sharp, &[3, 4, 5], own)).unwrap();
        assert!(answer.found.is_none());
        assert_eq!(answer.covered.len(), 3 * weights.len());
        assert!(answer.covered.iter().all(|c| c.extent == Extent::EveryStartAndStep));
    }
    let found = skipping(&space(Theorem::Ordering, Form::Sharp, &[3, 4], given("2/3")));
    let found = found.unwrap().found.unwrap();
    assert_eq!((found.start().len(), found.step), (4, 1));
    assert!(matches!(found.departure, Departure::Activation(_)) && valid(&found));
    let refused = space(Theorem::SumNonDecreasing, Form::Sharp, &[3], given("1/3"));
    assert!(skipping(&refused).is_err());
}

#[test]
fn stale_messages_break_ordering_and_never_the_bounds() {
    let own = || (fractions_within(&Rational::zero(), &Rational::one(), 4), false);
    let ordering = |drones: &[usize], weights| {
        departing::search(
            &space(Theorem::Ordering, Form::Sharp, drones, weights),
            Departures::Late(3),
        )
        .unwrap()
    };
    let answer = ordering(&[3, 4, 5], own());
    let found = answer.found.unwrap();
    // At least as small as the known one: N = 5, delay 3, step 4.
    assert_eq!(found.start().len(), 5);
    assert!(found.step <= 4 && found.weight_is_in_range() && valid(&found));
    assert!(answer.covered.iter().all(|c| c.count < 5));
    let found = ordering(&[5], given("1/3")).found.unwrap();
    assert_eq!(found.step, 4);
    assert!(valid(&found));
    // The known one itself.
    let mutual = |age: usize| vec![(1, 2, age), (2, 1, age)];
    let stale = Departure::Delay(vec![vec![], mutual(1), mutual(2), mutual(3)]);
    let known = Counterexample::replay_departing(
        Theorem::Ordering,
        Form::Sharp,
        &q("1/3"),
        qs("0, 1/100, 98/100, 99/100, 1"),
        4,
        stale,
    );
    assert!(valid(&known.unwrap()));
    for theorem in [Theorem::UpperBound, Theorem::SumBounded] {
        let space = space(theorem, Form::Sharp, &[3, 4, 5], own());
        let answer = departing::search(&space, Departures::Late(3)).unwrap();
        assert!(answer.found.is_none());
        assert!(answer.covered.iter().all(|c| c.extent == Extent::EveryStartAndStep));
        assert!(!answer.covered.is_empty());
    }
}

#[test]
fn drones_cross_where_messages_are_as_late_as_the_guide_says() {
    let late = |drones, eps, ages| {
        let space = space(Theorem::Ordering, Form::Sharp, &[drones], given(eps));
        departing::search(&space, Departures::Late(ages)).unwrap()
    };
    let found = late(6, "31/100", 2).found.unwrap();
    assert!(found.step == 3 && found.weight_is_in_range() && valid(&found));
    let answer = late(5, "2/5", 1);
    assert!(answer.found.is_none());
    assert_eq!(answer.covered[0].extent, Extent::EveryStartAndStep);
}

#[test]
fn ages_before_the_start_replay_nothing() {
    let replay = |stale| {
        Counterexample::replay_departing(
            Theorem::Ordering,
            Form::Sharp,
            &q("1/3"),
            qs("0, 1/100, 98/100, 99/100, 1"),
            1,
            Departure::Delay(stale),
        )
    };
    assert_eq!(replay(vec![vec![(1, 2, 1)]]), None);
    assert_eq!(replay(vec![]), None);
}

#[test]
fn counterexamples_replay_from_the_command_line() {
    let mut replayed = 0;
    for (theorem, args) in [
        ("7.2", "--eps 3/5"),
        ("7.3", "--eps 0.5..0.75"),
        ("7.3", "--eps 1/2.."),
        ("7.5i", "--eps 1"),
        ("7.7", "--eps 3/4 --drones 3"),
        ("7.6ii", "--form paper"),
        ("7.8", "--form paper --eps 5/6"),
    ] {
        let words: Vec<&str> = ["refute", theorem].into_iter().chain(args.split(' ')).collect();
        let (code, out, err) = run(&words);
        assert_eq!((code, err.as_str()), (1, ""), "{theorem} {args}: {out}");
        let replay = out.lines().find_map(|l| l.trim().strip_prefix("replay: cordon ")).unwrap();
        let (code, trace, err) = run(&replay.split(' ').collect::<Vec<_>>());
        assert_eq!(code, 1, "{replay}\n{trace}{err}");
        assert!(trace.contains("FAILS"), "{trace}");
        replayed += 1;
    }
    assert_eq!(replayed, 7);
}

#[test]
fn certificate_and_json_say_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("crossing.json");
    let args = ["refute", "7.2", "--delay", "3", "--drones", "5", "--eps", "1/3"];
    let (code, out, _) = run(&[&args[..], &["--out", path.to_str().unwrap()]].concat());
    assert_eq!(code, 1);
    assert!(out.contains("late") && out.contains("wrote"), "{out}");
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(matches!(check(&text), Verdict::Valid { .. }));
    // Without the delays the same run keeps the order: the departure is part of the claim.
    let mut page: serde_json::Value = serde_json::from_str(&text).unwrap();
    let body = page["certificate"]["refutation"].as_object_mut().unwrap();
    body.remove("delay");
    assert!(matches!(check(&page.to_string()), Verdict::Invalid { .. }));
    let (code, out, _) = run(&[&args[..], &["--format", "json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(code, 1);
    assert_eq!(json["schema"], "cordon-refute/1");
    assert_eq!(json["results"][0]["counterexample"]["step"], 4);
}

#[test]
fn nothing_found_is_inconclusive_and_says_what_was_covered() {
    let (code, out, err) = run(&["refute", "7.2", "--drones", "4", "--eps", "1/2"]);
    assert_eq!((code, err.as_str()), (3, ""));
    assert!(out.contains("N = 4, eps = 1/2: none exists: complete for all starts and all steps"));
    let args = ["refute", "7.2", "--drones", "4", "--eps", "1/2", "--delay", "2", "--steps", "6"];
    let (code, out, _) = run(&args);
    assert_eq!(code, 3);
    assert!(
        out.contains("none exists: complete for all starts, steps and delays up to 2"),
        "{out}"
    );
}

#[test]
fn mistakes_are_named() {
    let cases = [
        ("9.9", "theorem: `9.9` is unknown"),
        ("7.2 --drones 2", "drones: `2`: expected a number from 3 to 50"),
        ("7.2 --drones 5..3", "drones: `5..3`: expected a range that is not empty"),
        ("7.2 --drones x", "drones: `x`"),
        ("7.2 --eps 1/0", "eps: `1/0` divides by zero"),
        ("7.2 --eps 2..", "eps: `2..`: expected a range that is not empty"),
        ("7.2 --eps 1..0", "eps: `1..0`: expected a range"),
        ("7.2 --eps 0..1000000", "expected a range of length 100 or less"),
        ("7.2 --eps 10/101..10/100.5", "is not a number"),
        ("7.2 --eps 100/1001..101/1003", "has no fraction with a denominator up to 8"),
        ("7.2 --steps 100000", "steps: `100000`: expected at most 1000"),
        ("7.2 --denominators 0", "denominators: `0`"),
        ("7.8 --activation", "theorem: `7.8` reads several placements: expected 7.2, 7.3 or 7.4i"),
        ("7.8 --delay 1", "theorem: `7.8` reads several placements: expected 7.2, 7.3 or 7.4i"),
        (
            "7.2 --drones 12 --delay 50",
            "of which 51 placements are remembered: expected at most 600",
        ),
        ("7.2,7.3 --out x.json", "out: 2 theorems are named: expected one"),
    ];
    for (args, expected) in &cases {
        let words: Vec<&str> = ["refute"].into_iter().chain(args.split(' ')).collect();
        let (code, out, err) = run(&words);
        assert_eq!((code, out.as_str()), (2, ""), "{args}");
        assert!(err.contains(expected), "{args}: {err}");
    }
    assert_eq!(cases.len(), 16);
}

#[test]
fn simple_fractions() {
    let between = |a: &str, b: &str| strictly_between(&q(a), &q(b)).map(|x| x.to_string());
    assert_eq!(between("0", "1").as_deref(), Some("1/2"));
    assert_eq!(between("1/3", "1/2").as_deref(), Some("2/5"));
    assert_eq!(between("-1/2", "1/100").as_deref(), Some("0"));
    assert_eq!(between("-3", "-3/2").as_deref(), Some("-2"));
    assert_eq!(between("0", "1/100").as_deref(), Some("1/101"));
    assert_eq!(between("7/2", "9/2").as_deref(), Some("4"));
    assert_eq!(between("1", "1"), None);
    // Against all fractions: none with a smaller denominator lies between.
    let mut pairs = 0;
    let all = fractions_within(&q("-1"), &q("2"), 9);
    for a in &all {
        for b in all.iter().filter(|b| *b > a) {
            let found = strictly_between(a, b).unwrap();
            assert!(*a < found && found < *b);
            let simpler = fractions_within(a, b, 60).into_iter().find(|x| x != a && x != b);
            assert_eq!(simpler.unwrap().denom(), found.denom(), "{a} {b}");
            pairs += 1;
        }
    }
    assert_eq!(pairs, all.len() * (all.len() - 1) / 2);
}
