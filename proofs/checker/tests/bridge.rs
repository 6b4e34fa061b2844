//! The checker's symbols and the spec agree: the representatives of the case split stand for
//! every drone of every swarm tried, and the facts and goals that the checker writes down are
//! the comparisons that the spec's predicates make.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::{Add, Mul, Sub};

use cordon_check::model::{Class, Family, Mode, Place, Swarm, Weights, start_facts};
use cordon_check::poly::{Poly, Var};
use cordon_check::rules::{Fact, Relation};
use cordon_spec::coverage::exec_coverage;
use cordon_spec::placement::{contraction_weight, contraction_weight_at, scaled_error};
use cordon_spec::theorems::{
    Form, Setting, StartSet, Theorem, Truth, Verdict, WeightRange, above_targets, in_box,
    telescoping_residual,
};
use cordon_spec::{Ordered, Params, Scalar, State};
use num_traits::Signed;

/// Largest swarm tried.
const MOST: usize = 16;

fn named(name: &'static str) -> Poly {
    Poly::named(name)
}

/// Drone j of a swarm, the ends in place.
fn position(count: usize, j: usize) -> Poly {
    match j {
        0 => named("min"),
        _ if j + 1 == count => named("max"),
        _ => Poly::var(Var::At("x", i32::try_from(j).unwrap())),
    }
}

/// What a class's polynomial says of drone i of `count`.
fn special(p: &Poly, count: usize, i: usize) -> Poly {
    p.substitute(|v| match v {
        Var::Named("i") => Some(Poly::from(i)),
        Var::Named("last") => Some(Poly::from(count - 1)),
        Var::At("x", o) => {
            let j = i64::try_from(i).unwrap() + i64::from(o);
            Some(position(count, usize::try_from(j).unwrap()))
        }
        _ => None,
    })
}

fn class(count: usize, i: usize, width: usize) -> Class {
    match i {
        0 => Class::First,
        _ if i + width == count => Class::Last,
        _ => Class::Inner,
    }
}

#[test]
fn representatives_stand_for_every_drone_of_every_swarm() {
    let params = Params { min: named("min"), max: named("max"), eps: named("eps"), n: 0 };
    let mut compared = 0;
    for count in 3..=MOST {
        let drones: Vec<Poly> = (0..count).map(|j| position(count, j)).collect();
        let next = exec_coverage(&params, &State { drones, timesteps: 0 }).drones;
        for width in [1, 2] {
            for i in 0..=count - width {
                let swarm = Swarm::new(class(count, i, width), width == 2, Mode::Plain);
                let [(_, after)] = swarm.after(Mode::Plain).try_into().unwrap();
                assert_eq!(special(&after.index, count, i), Poly::from(i));
                for (o, x) in &after.x {
                    let j = i + usize::try_from(*o).unwrap();
                    assert_eq!(special(x, count, i), next[j], "drone {j} of {count}");
                    compared += 1;
                }
            }
        }
    }
    assert_eq!(compared, (3..=MOST).map(|n| n + 2 * (n - 1)).sum::<usize>());
}

#[test]
fn the_classes_that_the_checker_enumerates_are_those_that_occur() {
    for count in 3..=MOST {
        let classes = |width| (0..=count - width).map(move |i| class(count, i, width).label());
        let all: BTreeSet<_> = classes(1).collect();
        assert_eq!(all.len(), 3);
        let pairs: BTreeSet<_> = classes(2).collect();
        assert_eq!(pairs.contains("inner"), count > 3);
        assert!(pairs.contains("first") && pairs.contains("last"));
    }
}

#[test]
fn index_facts_hold_of_every_member() {
    for count in 3..=MOST {
        for width in [1, 2] {
            for i in 0..=count - width {
                let class = class(count, i, width);
                for fact in Swarm::new(class, width == 2, Mode::Plain).index_facts(class) {
                    let value = special(&fact.poly, count, i);
                    let constant = value.terms().next().map(|(m, c)| (m.len(), c.clone()));
                    let fine = match constant {
                        None => true,
                        Some((size, c)) => size == 0 && c.is_positive(),
                    };
                    assert!(fine, "{} at drone {i} of {count}", fact.name);
                }
            }
        }
    }
}

#[test]
fn contraction_weights_agree() {
    for count in 3..=MOST {
        for i in 0..count {
            let symbolic = contraction_weight_at(&named("last"), &named("i"));
            let value = special(&symbolic, count, i);
            assert_eq!(value, Poly::from(contraction_weight(count, i)));
        }
    }
}

#[test]
fn the_telescoping_identity_of_the_spec_is_zero() {
    let params = Params { min: named("min"), max: named("max"), eps: named("eps"), n: 0 };
    for count in 3..=MOST {
        let drones: Vec<Poly> = (0..count).map(|j| position(count, j)).collect();
        let state = State { drones, timesteps: 0 };
        let next = exec_coverage(&params, &state);
        let rest = telescoping_residual(&params.eps, &state.drones, &next.drones);
        assert!(rest.is_zero(), "{count}");
    }
}

// The spec's predicates, probed: a scalar that writes down every comparison and answers as told.

thread_local! {
    static ASKED: RefCell<Vec<Poly>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Option<(usize, Ordering)>> = const { RefCell::new(None) };
}

#[derive(Clone)]
struct Probe(Poly);

impl Add<&Self> for Probe {
    type Output = Self;
    fn add(self, other: &Self) -> Self {
        Self(self.0 + &other.0)
    }
}

impl Sub<&Self> for Probe {
    type Output = Self;
    fn sub(self, other: &Self) -> Self {
        Self(self.0 - &other.0)
    }
}

impl Mul<&Self> for Probe {
    type Output = Self;
    fn mul(self, other: &Self) -> Self {
        Self(self.0 * &other.0)
    }
}

impl Scalar for Probe {
    fn from_int(n: i32) -> Self {
        Self(Poly::from_int(n))
    }
}

impl Ordered for Probe {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        let at = ASKED.with_borrow_mut(|asked| {
            asked.push(self.0.clone() - &other.0);
            asked.len() - 1
        });
        ANSWER.with_borrow(|answer| answer.filter(|(k, _)| *k == at).map(|(_, o)| o))
    }
}

/// A statement about a polynomial, comparable.
type Atom = (String, &'static str);

fn atom(p: &Poly, relation: Relation) -> Option<Atom> {
    let label = match relation {
        Relation::Positive => ">",
        Relation::NonNegative => ">=",
        Relation::Zero => "=",
    };
    // The sign of an equation is free: take the first coefficient positive.
    let zero = Poly::from_int(0);
    let first = p.terms().next().map(|(_, c)| c.clone());
    let flipped = relation == Relation::Zero && first?.is_negative();
    let p = if flipped { zero - p } else { p.clone() };
    // What is true of the zero polynomial says nothing.
    (!p.is_zero()).then(|| (format!("{:?}", p.terms().collect::<Vec<_>>()), label))
}

/// The comparisons that a conjunction consists of: each is answered alone, all others being
/// unknown; the conjunction is false just if that answer is not accepted.
fn atoms(conjunction: impl Fn() -> Truth) -> BTreeSet<Atom> {
    let ask = |answer| {
        ASKED.with_borrow_mut(Vec::clear);
        ANSWER.with_borrow_mut(|a| *a = answer);
        (conjunction(), ASKED.with_borrow(Clone::clone))
    };
    let (_, asked) = ask(None);
    let mut atoms = BTreeSet::new();
    for (k, difference) in asked.iter().enumerate() {
        let accepted = [Ordering::Less, Ordering::Equal, Ordering::Greater]
            .map(|o| ask(Some((k, o))).0 != Truth::False);
        let negated = Poly::from_int(0) - difference;
        let (p, relation) = match accepted {
            [true, false, false] => (&negated, Relation::Positive),
            [true, true, false] => (&negated, Relation::NonNegative),
            [false, true, false] => (difference, Relation::Zero),
            [false, true, true] => (difference, Relation::NonNegative),
            [false, false, true] => (difference, Relation::Positive),
            other => panic!("no single comparison: {other:?}"),
        };
        atoms.extend(atom(p, relation));
    }
    atoms
}

fn setting() -> Setting<Probe> {
    Setting {
        min: Probe(named("min")),
        max: Probe(named("max")),
        eps_num: Probe(named("eps")),
        eps_den: Probe(Poly::from_int(1)),
    }
}

fn placement(count: usize) -> Vec<Probe> {
    (0..count).map(|j| Probe(position(count, j))).collect()
}

/// What the checker's facts say of all drones, or all pairs, of a swarm.
fn said(count: usize, width: usize, facts: impl Fn(Class, &Place) -> Vec<Fact>) -> BTreeSet<Atom> {
    let mut all = BTreeSet::new();
    for i in 0..=count - width {
        let class = class(count, i, width);
        let swarm = Swarm::new(class, width == 2, Mode::Plain);
        for fact in facts(class, &swarm.place) {
            all.extend(atom(&special(&fact.poly, count, i), fact.relation));
        }
    }
    all
}

#[test]
fn start_sets_are_what_the_checker_says() {
    for count in 3..=8 {
        for set in
            [StartSet::Any, StartSet::Ordered, StartSet::FirstSubsegment, StartSet::UpperBounded]
        {
            let spec = atoms(|| set.contains(&setting(), &placement(count)));
            let single = said(count, 1, |class, place| start_facts(set, class, place));
            let pairs = said(count, 2, |class, place| {
                if set == StartSet::Ordered { start_facts(set, class, place) } else { Vec::new() }
            });
            assert_eq!(spec, single.union(&pairs).cloned().collect(), "{set:?} of {count}");
            assert_eq!(spec.is_empty(), set == StartSet::Any);
        }
    }
}

#[test]
fn weights_are_what_the_checker_says() {
    let ranges = [
        WeightRange::Any,
        WeightRange::Unit,
        WeightRange::BelowThird,
        WeightRange::BelowHalf,
        WeightRange::UpToHalf,
        WeightRange::UpToHalfOrOne,
        WeightRange::PositiveUpToHalf,
    ];
    for range in ranges {
        for count in 3..=6 {
            let (num, den) = (Probe(named("eps")), Probe(Poly::from_int(1)));
            let spec = atoms(|| range.contains(&num, &den, count));
            let facts = Weights::Range(range).facts(count == 3).unwrap();
            let said = facts.iter().filter_map(|f| atom(&f.poly, f.relation)).collect();
            assert_eq!(spec, said, "{range:?} of {count}");
        }
    }
    assert!(Weights::Range(WeightRange::BelowCritical).facts(false).is_err());
}

#[test]
fn conclusions_are_what_the_checker_says() {
    let truth = |verdict| match verdict {
        Verdict::Violated(_) => Truth::False,
        Verdict::Holds => Truth::True,
        _ => Truth::Unknown,
    };
    type Conclusion = fn(&Setting<Probe>, &[Probe]) -> Verdict;
    let ordering: Conclusion = |s, x| Theorem::Ordering.conclusion(Form::Sharp, s, &[x]);
    let upper: Conclusion = |s, x| Theorem::UpperBound.conclusion(Form::Sharp, s, &[x]);
    let cases: [(Conclusion, &[Family]); 4] = [
        (ordering, &[Family::Ordered]),
        (upper, &[Family::UpperBound]),
        (|s, x| above_targets(s, x), &[Family::LowerBound]),
        (|s, x| in_box(s, x), &[Family::AboveMin, Family::BelowMax]),
    ];
    for count in 3..=8 {
        for (conclusion, families) in cases {
            let spec = atoms(|| truth(conclusion(&setting(), &placement(count))));
            let width = if families[0].of_pairs() { 2 } else { 1 };
            let own = said(count, width, |_, place| {
                families
                    .iter()
                    .map(|f| {
                        let (label, relation) = f.label();
                        Fact::new(label, f.at(place, 0).unwrap(), relation)
                    })
                    .collect()
            });
            assert_eq!(spec, own, "{families:?} of {count}");
            assert!(spec.len() >= count - 2);
        }
        let sum = atoms(|| {
            truth(Theorem::SumBounded.conclusion(Form::Sharp, &setting(), &[placement(count)]))
        });
        // 7.4 (i) with c the sum: N(min + max) - 2c >= 0.
        let c = (0..count).fold(Poly::from_int(0), |c, j| c + &position(count, j));
        let ends = Poly::from(count) * &(named("min") + &named("max"));
        let deficit = ends - &(Poly::from_int(2) * &c);
        assert_eq!(sum, atom(&deficit, Relation::NonNegative).into_iter().collect());
        // And the sum of the errors is (N-1)/2 times it, by which 7.4 is proved.
        let x: Vec<Poly> = (0..count).map(|j| position(count, j)).collect();
        let errors = (0..count)
            .fold(Poly::from_int(0), |e, i| e + &scaled_error(&named("min"), &named("max"), &x, i));
        assert_eq!(Poly::from_int(2) * &errors, Poly::from(count - 1) * &deficit);
    }
}
