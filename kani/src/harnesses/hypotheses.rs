//! What the theorems assume: ranges of weights against plain inequalities, and the start sets
//! against one another.

use cordon_spec::theorems::{Form, Setting, StartSet, Theorem, Verdict, WeightRange, in_box};
use cordon_spec::{Ordered, Scalar};

use crate::bounds::{Bounds, ZERO};
use crate::fraction::Fraction;
use crate::harness::{covering, harnesses};
use crate::line::{Line, same};
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &[
    "theorems::Setting::from",
    "theorems::hypothesis::Hypothesis::met_by",
    "theorems::hypothesis::StartSet::contains",
    "theorems::hypothesis::WeightRange::contains",
    "theorems::hypothesis::below_critical",
    "theorems::hypothesis::in_first_subsegment",
    "theorems::hypothesis::ordered",
    "theorems::hypothesis::upper_bounded",
];

const NUMERATORS: Domain = Domain::new(-16, 127, 20);
const DENOMINATORS: Domain = Domain::new(1, 255, 20);
/// Where minors multiply them: 6 bits.
const SHORT_NUMERATORS: Domain = Domain::new(-4, 59, 20);
const SHORT_DENOMINATORS: Domain = Domain::new(1, 63, 12);
const COUNTS: Domain = Domain::whole(3, 6);
/// The least segment on which five drones meet assumption 3 has length 16.
const POSITIONS: Bounds = Bounds { positions: Domain::new(0, 255, 16), weights: ZERO };
/// Four drones meet assumption 3 from length 7 on.
const ENDS: Domain = Domain::new(0, 31, 7);
const SHORT: Bounds = Bounds { positions: Domain::new(0, 7, 6), weights: ZERO };

/// Each range is its inequality. Witness: a weight within [0, 1/3), which all ranges hold.
fn are_inequalities<S: Source>(source: &mut S) -> Case {
    let (p, q) = (source.integer(NUMERATORS), source.integer(DENOMINATORS));
    let count = source.integer(COUNTS).unsigned_abs() as usize;
    let contains = |range: WeightRange| range.contains(&p, &q, count).is_true();
    assert!(contains(WeightRange::Any), "any");
    assert!(contains(WeightRange::Unit) == (0 <= p && p <= q), "0 <= p/q <= 1");
    assert!(contains(WeightRange::BelowThird) == (0 <= p && 3 * p < q), "0 <= p/q < 1/3");
    assert!(contains(WeightRange::BelowHalf) == (0 <= p && 2 * p < q), "0 <= p/q < 1/2");
    let up_to_half = 0 <= p && 2 * p <= q;
    assert!(contains(WeightRange::UpToHalf) == up_to_half, "0 <= p/q <= 1/2");
    let or_one = if count == 3 { 0 <= p && p <= q } else { up_to_half };
    assert!(contains(WeightRange::UpToHalfOrOne) == or_one, "up to 1 for three drones");
    let positive = 0 < p && 2 * p <= q;
    assert!(contains(WeightRange::PositiveUpToHalf) == positive, "0 < p/q <= 1/2");
    Some(Witness(3 * p < q && p > 0))
}

/// The critical weights: 1 for N = 3, 2/3 for N = 4, 2 - sqrt 2 for N = 5. Witness: one that is
/// below 1 and 2/3 only.
fn are_critical<S: Source>(source: &mut S) -> Case {
    let (p, q) = (source.integer(SHORT_NUMERATORS), source.integer(SHORT_DENOMINATORS));
    let below = |count| WeightRange::BelowCritical.contains(&p, &q, count).is_true();
    assert!(below(3) == (0 < p && p < q), "0 < p/q < 1");
    assert!(below(4) == (0 < p && 3 * p < 2 * q), "0 < p/q < 2/3");
    // p/q < 2 - sqrt 2 is sqrt 2 q < 2 q - p, both sides positive.
    let left = 2 * q - p;
    let below_5 = 0 < p && left > 0 && left * left > 2 * q * q;
    assert!(below(5) == below_5, "0 < p/q < 2 - sqrt 2");
    Some(Witness(below(4) && !below(5)))
}

/// Assumption 3 implies UB and the order; the order implies the box; UB and its mirror image meet
/// at the targets. Witness: assumption 3 is met.
fn implied<const N: usize, S: Source>(source: &mut S) -> Case {
    let line = Line::<N>::draw(source, &POSITIONS)?;
    let (setting, x) = (&line.setting, line.start());
    let contains = |set: StartSet| set.contains(setting, x).is_true();
    assert!(contains(StartSet::Any), "the ends are in place");
    let first = contains(StartSet::FirstSubsegment);
    assert!(!first || contains(StartSet::UpperBounded), "assumption 3 implies UB");
    assert!(!first || contains(StartSet::Ordered), "assumption 3 contains assumption 2");
    let ordered = contains(StartSet::Ordered);
    assert!(!ordered || in_box(setting, x) == Verdict::Holds, "order implies the box");
    Some(Witness(first))
}

/// The start sets by plain inequalities on integers, ends out of place included. Witness: in all
/// of them.
fn defined<S: Source>(source: &mut S) -> Case {
    let x = source.integers::<4>(ENDS);
    let (min, max) = (source.integer(ENDS), source.integer(ENDS));
    source.assume(min < max)?;
    let setting = Setting { min, max, eps_num: 0, eps_den: 1 };
    let contains = |set: StartSet| set.contains(&setting, &x).is_true();
    let anchored = x[0] == min && x[3] == max;
    assert!(contains(StartSet::Any) == anchored, "the ends are in place");
    let ordered = anchored && x[0] < x[1] && x[1] < x[2] && x[2] < x[3];
    assert!(contains(StartSet::Ordered) == ordered, "strictly ordered");
    // min + l, times 3.
    let first = 2 * min + max;
    let before = ordered && 3 * x[1] < first && 3 * x[2] < first;
    assert!(contains(StartSet::FirstSubsegment) == before, "before the first target");
    let bounded = anchored && 3 * x[1] <= first && 3 * x[2] <= min + 2 * max;
    assert!(contains(StartSet::UpperBounded) == bounded, "at most the targets");
    assert!(!StartSet::Any.contains(&setting, &x[..1]).is_true(), "one drone has no two ends");
    Some(Witness(before && bounded))
}

/// A hypothesis is met where weight and start are in its ranges; the setting of protocol
/// parameters has the weight over 1. Witness: met.
fn met<S: Source>(source: &mut S) -> Case {
    let line = Line::<3>::draw(source, &SHORT)?;
    let (num, den) = (source.integer(Domain::whole(-1, 4)), source.integer(Domain::whole(1, 4)));
    let setting = Setting {
        eps_num: Fraction::from_int(num),
        eps_den: Fraction::from_int(den),
        ..line.setting.clone()
    };
    let mut all = true;
    for theorem in [Theorem::Ordering, Theorem::ConstantSum] {
        for form in Form::ALL {
            let hypothesis = theorem.hypothesis(form);
            let weights = hypothesis.weights.contains(&setting.eps_num, &setting.eps_den, 3);
            let starts = hypothesis.starts.contains(&setting, line.start());
            let met = hypothesis.met_by(&setting, line.start()).is_true();
            assert!(met == (weights.is_true() && starts.is_true()), "weight and start");
            all &= met;
        }
    }
    let from = Setting::from(&line.params);
    assert!(same(&[from.min, from.max], &[line.setting.min, line.setting.max]), "the ends");
    let one = Fraction::from_int(1);
    assert!(same(&[from.eps_num, from.eps_den], &[line.params.eps, one]), "the weight over 1");
    assert!(from.eps_den.compare(&one) == Some(core::cmp::Ordering::Equal), "over 1");
    Some(Witness(all))
}

harnesses! {
    functions FUNCTIONS;
    /// Ranges of weights are their inequalities.
    ranges("hypotheses", unwind 2): covering!("p/q, p in {NUMERATORS}, q in {DENOMINATORS}, N in {COUNTS}")
        => |s| are_inequalities(s);
    /// The critical weights of three, four and five drones.
    critical("hypotheses", unwind 5): covering!("p/q, p in {SHORT_NUMERATORS}, q in {SHORT_DENOMINATORS}")
        => |s| are_critical(s);
    /// Assumption 3 implies UB, order implies the box: four drones.
    implied_4("hypotheses", unwind 5): covering!("N = 4, {POSITIONS}")
        => |s| implied::<4, _>(s);
    /// Assumption 3 implies UB, order implies the box: five drones.
    implied_5("hypotheses", unwind 6): covering!("N = 5, {POSITIONS}")
        => |s| implied::<5, _>(s);
    /// The start sets are their inequalities.
    defined_4("hypotheses", unwind 5): covering!("N = 4, positions and ends {ENDS}")
        => |s| defined(s);
    /// A hypothesis is met where weight and start meet theirs.
    met_3("hypotheses", unwind 4): covering!("N = 3, positions {}, p/q, p in -1..=4, q in 1..=4, both forms", SHORT.positions)
        => |s| met(s);
}
