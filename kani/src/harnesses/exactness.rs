//! That the bounds of the theorems are exact: beyond them Kani finds what they exclude.
//!
//! Each is there twice. Once the theorem is asserted and has to fail (`#[kani::should_panic]`):
//! the harnesses above could fail, then. Once nothing is asserted and the cover is the violation
//! itself.

use cordon_spec::theorems::Theorem::{
    self, ConstantSum, GloballyIncreasing, Limit, Ordering, UpperBound,
};
use cordon_spec::theorems::{Form, Verdict};

use crate::bounds::{ABOVE_HALF, Bounds, FOUR_BITS, SEVEN_TENTHS, Weights, ZERO};
use crate::harness::{covering, harnesses};
use crate::line::Line;
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &["theorems::hypothesis::StartSet::contains"];

/// A crossing at eps takes a gap of more than 2 eps / (2 eps - 1) times its neighbours: 3.5 at
/// 7/10, 501 at 501/1000.
const WIDE_MIDDLE: [Domain; 3] =
    [Domain::whole(1, 2), Domain::new(1, 1023, 600), Domain::whole(1, 2)];
/// With eps > 1/2 a drone behind its target jumps beyond it if its neighbours are at theirs.
const NARROW: [Domain; 3] = [Domain::new(0, 15, 3), Domain::new(0, 15, 3), Domain::new(0, 15, 6)];
const NARROW_BOUNDS: Bounds = Bounds { positions: FOUR_BITS, weights: ZERO };
/// Beyond 1 even three drones cross.
const BEYOND_ONE: Bounds =
    Bounds { positions: Domain::new(0, 255, 25), weights: Weights::Table(&[(11, 10)]) };
/// The critical weight of four drones.
const CRITICAL: Bounds = Bounds { positions: FOUR_BITS, weights: Weights::Table(&[(2, 3)]) };

/// Whether the conclusion holds of the run from a start in the theorem's start set, the weight
/// being outside its range.
fn verdict<const N: usize, S: Source>(
    source: &mut S,
    theorem: Theorem,
    line: &Line<N>,
) -> Option<bool> {
    let hypothesis = theorem.hypothesis(Form::Sharp);
    source.assume(hypothesis.starts.contains(&line.setting, line.start()).is_true())?;
    // The conclusions of 7.2 and 7.3 are about X^1 here, the others about X^0 and what follows.
    let run = line.run::<2>();
    let from = usize::from(theorem.span(Form::Sharp, N) == 0);
    let verdict = theorem.conclusion(Form::Sharp, &line.setting, &run[from..]);
    Some(!matches!(verdict, Verdict::Violated(_)))
}

/// Asserts the conclusion. Witness: a start from which it holds all the same.
fn asserted<const N: usize, S: Source>(
    source: &mut S,
    theorem: Theorem,
    line: Option<Line<N>>,
) -> Case {
    let holds = verdict(source, theorem, &line?)?;
    assert!(holds, "the conclusion holds");
    Some(Witness(holds))
}

/// Asserts nothing. Witness: the conclusion fails.
fn found<const N: usize, S: Source>(
    source: &mut S,
    theorem: Theorem,
    line: Option<Line<N>>,
) -> Case {
    Some(Witness(!verdict(source, theorem, &line?)?))
}

/// Four drones by their gaps.
fn gaps<S: Source>(source: &mut S, gaps: [Domain; 3], weights: Weights) -> Option<Line<4>> {
    Line::from_gaps(source, gaps, weights)
}

harnesses! {
    functions FUNCTIONS;
    /// Four ordered drones cross in one step at eps = 7/10.
    ordering_fails_at_7_10("7.2", unwind 5, fails): covering!("N = 4, one step, eps {SEVEN_TENTHS}")
        => |s| { let line = gaps(s, WIDE_MIDDLE, SEVEN_TENTHS); asserted(s, Ordering, line) };
    /// Four ordered drones cross in one step at eps = 501/1000.
    ordering_fails_at_501_1000("7.2", unwind 5, fails): covering!("N = 4, one step, eps {ABOVE_HALF}")
        => |s| { let line = gaps(s, WIDE_MIDDLE, ABOVE_HALF); asserted(s, Ordering, line) };
    /// The crossing at eps = 7/10 itself.
    crossing_at_7_10("7.2", unwind 5): covering!("N = 4, one step, eps {SEVEN_TENTHS}")
        => |s| { let line = gaps(s, WIDE_MIDDLE, SEVEN_TENTHS); found(s, Ordering, line) };
    /// The crossing at eps = 501/1000 itself.
    crossing_at_501_1000("7.2", unwind 5): covering!("N = 4, one step, eps {ABOVE_HALF}")
        => |s| { let line = gaps(s, WIDE_MIDDLE, ABOVE_HALF); found(s, Ordering, line) };
    /// Three ordered drones cross in one step at eps = 11/10.
    ordering_of_three_fails_beyond_1("7.2", unwind 4, fails): covering!("N = 3, one step, {BEYOND_ONE}")
        => |s| { let line = Line::<3>::draw(s, &BEYOND_ONE); asserted(s, Ordering, line) };
    /// A drone passes its target in one step at eps = 7/10.
    bound_fails_at_7_10("7.3", unwind 5, fails): covering!("N = 4, one step, eps {SEVEN_TENTHS}")
        => |s| { let line = gaps(s, NARROW, SEVEN_TENTHS); asserted(s, UpperBound, line) };
    /// A drone passes its target in one step at eps = 501/1000.
    bound_fails_at_501_1000("7.3", unwind 5, fails): covering!("N = 4, one step, eps {ABOVE_HALF}")
        => |s| { let line = gaps(s, NARROW, ABOVE_HALF); asserted(s, UpperBound, line) };
    /// The drone beyond its target at eps = 7/10 itself.
    violation_at_7_10("7.3", unwind 5): covering!("N = 4, one step, eps {SEVEN_TENTHS}")
        => |s| { let line = gaps(s, NARROW, SEVEN_TENTHS); found(s, UpperBound, line) };
    /// The drone beyond its target at eps = 501/1000 itself.
    violation_at_501_1000("7.3", unwind 5): covering!("N = 4, one step, eps {ABOVE_HALF}")
        => |s| { let line = gaps(s, NARROW, ABOVE_HALF); found(s, UpperBound, line) };
    /// At eps = 0 a constant sum means nothing.
    constant_sum_fails_at_0("7.6ii", unwind 5, fails): covering!("N = 4, one step, {NARROW_BOUNDS}")
        => |s| { let line = Line::<4>::draw(s, &NARROW_BOUNDS); asserted(s, ConstantSum, line) };
    /// At eps = 0 the sum never increases.
    growth_fails_at_0("7.7", unwind 4, fails): covering!("N = 3, one step, {NARROW_BOUNDS}")
        => |s| { let line = Line::<3>::draw(s, &NARROW_BOUNDS); asserted(s, GloballyIncreasing, line) };
    /// At the critical weight 2/3 of four drones the squared error does not always fall.
    limit_fails_at_the_critical_weight("7.8", unwind 5, fails): covering!("N = 4, one step, {CRITICAL}")
        => |s| { let line = Line::<4>::draw(s, &CRITICAL); asserted(s, Limit, line) };
}
