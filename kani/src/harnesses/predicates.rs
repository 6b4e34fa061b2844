//! Conclusions against slow and obvious readings of the theorems, on placements that need not
//! follow from one another: what a predicate lets pass, and where it says that it fails.

use cordon_spec::coverage::exec_coverage;
use cordon_spec::theorems::Theorem::{GloballyIncreasing, Limit, TargetsFixed};
use cordon_spec::theorems::{Form, Setting, Subject, Theorem, Verdict, Violation};
use cordon_spec::{Params, State};

use crate::harness::{covering, harnesses};
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &[
    "theorems::increasing::as_printed",
    "theorems::increasing::first_off_target_is_late",
    "theorems::limit::at_rate",
    "theorems::limit::bounded_by",
    "theorems::limit::conclusion",
    "theorems::limit::magnitude",
    "theorems::limit::weighed",
];

/// Errors are squared and multiplied by one another.
const SQUARED: Domain = Domain::whole(0, 3);
/// Weights in eighths, on both sides of 1/2.
const EIGHTHS: Domain = Domain::new(1, 6, 6);
/// Five drones whose targets are 0 to 4.
const AROUND: Domain = Domain::whole(0, 5);
/// Six drones whose targets are 0 to 5: each at its target, or one off it.
const ONE_OFF: [Domain; 4] =
    [Domain::whole(0, 2), Domain::whole(1, 3), Domain::whole(2, 4), Domain::whole(3, 5)];

fn error(x: &[i32; 4], i: usize) -> i32 {
    // Three times the target less three times the position, the ends being 0 and x_3.
    i32::try_from(i).unwrap_or(i32::MAX) * x[3] - 3 * x[i]
}

/// 7.8 says of four drones: the squared errors fall, and in the sharp form, up to eps = 1/2, every
/// error is within the rate of some error before: 9 q |e_i'| w_j <= (9 q - 8 p) |e_j| w_i, the
/// weights w of the two internal drones being equal. Witness: the rate alone is missed.
fn reads_the_limit<S: Source>(source: &mut S) -> Case {
    let [a, b, c, d, last] = source.integers::<5>(SQUARED);
    let (now, next) = ([0, a, b, last], [0, c, d, last]);
    let (p, q) = (source.integer(EIGHTHS), 8);
    source.assume(last > 0)?;
    let setting = Setting { min: 0, max: last, eps_num: p, eps_den: q };
    let energy = |x: &[i32; 4]| error(x, 1) * error(x, 1) + error(x, 2) * error(x, 2);
    let falls = energy(&next) < energy(&now);
    let within = |i| {
        let after = 9 * q * error(&next, i).abs();
        let kept = 9 * q - 8 * p;
        after <= kept * error(&now, 1).abs() || after <= kept * error(&now, 2).abs()
    };
    let at_rate = 2 * p > q || within(1) && within(2);
    let off = energy(&now) > 0;
    let printed = Limit.conclusion(Form::Paper, &setting, &[now, next]);
    let sharp = Limit.conclusion(Form::Sharp, &setting, &[now, next]);
    assert!((printed == Verdict::Vacuous) != off, "vacuous at the targets");
    assert!((printed == Verdict::Holds) == (off && falls), "the energy falls");
    assert!((sharp == Verdict::Holds) == (off && falls && at_rate), "and at the rate");
    Some(Witness(printed == Verdict::Holds && sharp != Verdict::Holds))
}

/// 7.7 as printed says of six drones: if the sum stays for a step and the first drone off its
/// target is behind it and has index 3 or more, the sum increases later. With eps = 0 it does
/// not. Witness: the premise is met.
fn reads_the_printed_growth<S: Source>(source: &mut S, eps: i32) -> Case {
    let [a, b, c, d] = ONE_OFF.map(|domain| source.integer(domain));
    let x = [0, a, b, c, d, 5];
    let p = Params { min: 0, max: 5, eps, n: 0 };
    let mut state = State { drones: x, timesteps: 0 };
    let run: [[i32; 6]; 6] = core::array::from_fn(|k| {
        if k > 0 {
            state = exec_coverage(&p, &state);
        }
        state.drones
    });
    let sums = run.map(|x| x.iter().sum::<i32>());
    let mut first_off = None;
    for (j, xj) in x.iter().enumerate().rev() {
        let target = i32::try_from(j).unwrap_or(i32::MAX);
        if *xj != target {
            first_off = Some((j, *xj < target));
        }
    }
    let premise = sums[1] == sums[0] && matches!(first_off, Some((3.., true)));
    let mut increases = false;
    for h in 1..5 {
        increases |= sums[h + 1] > sums[h];
    }
    let verdict = GloballyIncreasing.conclusion(Form::Paper, &Setting::from(&p), &run);
    assert!((verdict == Verdict::Vacuous) != premise, "the premise");
    assert!((verdict == Verdict::Holds) == (premise && increases), "the conclusion");
    Some(Witness(premise))
}

/// 7.6 (i) names the step at which drones that were at their targets are not (sharp), or the sum
/// is another (paper). Witness: the second step.
fn names_the_step<S: Source>(source: &mut S) -> Case {
    let [a, b, c, d] = source.integers::<4>(AROUND);
    let setting = Setting { min: 0, max: 4, eps_num: 1, eps_den: 2 };
    // Five drones, for which both forms look two steps ahead at least.
    let now = [0, 1, 2, 3, 4];
    let run = [now, [0, a, b, 3, 4], [0, 1, c, d, 4], now];
    let violated = |step| Verdict::Violated(Violation { step, subject: Subject::Sum });
    let first = |stays: [bool; 2]| match stays {
        [false, _] => violated(1),
        [true, false] => violated(2),
        [true, true] => Verdict::Holds,
    };
    let sharp = TargetsFixed.conclusion(Form::Sharp, &setting, &run[..3]);
    assert!(sharp == first([(a, b) == (1, 2), (c, d) == (2, 3)]), "the first step off a target");
    let printed = TargetsFixed.conclusion(Form::Paper, &setting, &run);
    assert!(printed == first([a + b == 3, c + d == 5]), "the first step with another sum");
    Some(Witness(sharp == violated(2)))
}

/// How many steps ahead each statement looks. Witness: an even number of drones.
fn look_ahead<S: Source>(source: &mut S) -> Case {
    let count = source.integer(Domain::whole(3, 10)).unsigned_abs() as usize;
    let span = |t: Theorem| (t.span(Form::Paper, count), t.span(Form::Sharp, count));
    let half = count.div_ceil(2) - 1;
    for theorem in [Theorem::TargetsFixed, Theorem::ConstantSum] {
        assert!(span(theorem) == (count - 2, half), "N - 2, and half of it rounded up");
    }
    let growth = span(Theorem::GloballyIncreasing);
    assert!(growth == (count - 1, (count - 1) / 2), "N - 1, and half of it rounded down");
    for theorem in [Theorem::SumNonDecreasing, Theorem::SumStationary, Theorem::Limit] {
        assert!(span(theorem) == (1, 1), "one step");
    }
    for theorem in
        [Theorem::Ordering, Theorem::UpperBound, Theorem::SumBounded, Theorem::SumMaximal]
    {
        assert!(span(theorem) == (0, 0), "no step");
    }
    Some(Witness(count.is_multiple_of(2)))
}

harnesses! {
    functions FUNCTIONS;
    /// The limit's conclusion is the fall of the squared errors, and the rate.
    limit("7.8", unwind 6): covering!("N = 4, any two placements, positions {SQUARED}, eps {EIGHTHS}/8")
        => |s| reads_the_limit(s);
    /// 7.7 as printed is what it says: of drones that move.
    growth("7.7", unwind 7): covering!("N = 6, five steps, positions at most 1 off the targets, eps 1")
        => |s| reads_the_printed_growth(s, 1);
    /// 7.7 as printed is what it says: of drones that stand still.
    growth_still("7.7", unwind 7): covering!("N = 6, five steps, positions at most 1 off the targets, eps 0")
        => |s| reads_the_printed_growth(s, 0);
    /// A violation of 7.6 (i) is named by its step.
    fixed("7.6i", unwind 6): covering!("N = 5, any three placements, positions {AROUND}")
        => |s| names_the_step(s);
    /// Statements look as many steps ahead as they say.
    spans("theorems", unwind 5): covering!("N in 3..=10") => |s| look_ahead(s);
}
