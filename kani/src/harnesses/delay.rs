//! Steps that read stale messages (PROTOCOL section 2): the bounds survive, the order does not.

use cordon_spec::coverage::getx;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::Theorem::{Ordering, UpperBound};
use cordon_spec::theorems::{Form, Setting, Verdict, WeightRange, in_box};
use cordon_spec::{Scalar, State};

use crate::bounds::{Bounds, HALF, UP_TO_HALF};
use crate::fraction::Fraction;
use crate::harness::{covering, harnesses};
use crate::line::{Line, same};
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &["delay::exec_coverage_delayed"];

/// Two placements are drawn, so that an exhaustive test affords few positions.
const STEP: Bounds = Bounds { positions: Domain::new(0, 255, 2), weights: UP_TO_HALF };
/// The counterexample that `cordon refute 7.2 --delay` finds, 0, 1/16, 1/8, 15/16, 1 at eps = 1/2,
/// is among these, in sixteenths.
const GAPS: [Domain; 4] =
    [Domain::whole(1, 2), Domain::whole(1, 2), Domain::whole(1, 15), Domain::whole(1, 2)];

/// Two placements that both have the property, the later of which a step reads or not, link by
/// link: the property holds after the step. Witness: a stale position was read that mattered.
fn kept<const N: usize, S: Source>(
    source: &mut S,
    property: fn(&Setting<Fraction>, &[Fraction; N]) -> Verdict,
) -> Case {
    let line = Line::<N>::draw(source, &STEP)?;
    let (num, den) = (&line.setting.eps_num, &line.setting.eps_den);
    source.assume(WeightRange::UpToHalf.contains(num, den, N).is_true())?;
    // The end drones have been in place all the time.
    let mut stale = source.integers::<N>(STEP.positions).map(Fraction::from_int);
    (stale[0], stale[N - 1]) = (line.setting.min, line.setting.max);
    // Drone i sees drone j now or then, whichever way j lies.
    let late_left: [bool; N] = core::array::from_fn(|_| source.flag());
    let late_right: [bool; N] = core::array::from_fn(|_| source.flag());
    source.assume(property(&line.setting, &line.state.drones) == Verdict::Holds)?;
    source.assume(property(&line.setting, &stale) == Verdict::Holds)?;
    let next = exec_coverage_delayed(&line.params, &line.state, |i, j| {
        let late = if j < i { late_left[i] } else { late_right[i] };
        if late { &stale[j] } else { getx(&line.state, j) }
    });
    assert!(property(&line.setting, &next.drones) == Verdict::Holds, "kept by a stale step");
    Some(Witness(!same(&line.next(), &next.drones)))
}

fn upper_bounded<const N: usize>(setting: &Setting<Fraction>, x: &[Fraction; N]) -> Verdict {
    UpperBound.conclusion(Form::Sharp, setting, &[*x])
}

/// A drone knows itself, and sees the others where it is told: with present positions this is a
/// step without delay. Witness: a drone has moved.
fn present<const N: usize, S: Source>(source: &mut S) -> Case {
    let line = Line::<N>::draw(source, &STEP)?;
    let astray = Fraction::from_int(-1);
    let next = exec_coverage_delayed(&line.params, &line.state, |i, j| {
        // Its own position it is never told.
        if i == j { &astray } else { getx(&line.state, j) }
    });
    assert!(same(&next.drones, &line.next()), "present positions: a step without delay");
    assert!(next.timesteps == line.state.timesteps, "the tick counter is kept");
    Some(Witness(!same(line.start(), &next.drones)))
}

/// Five drones of which 2 and 3 see each other two steps late: three steps from an ordered start
/// that all have always known. Witness: they are still in order.
fn crossing<S: Source>(source: &mut S) -> Case {
    let line = Line::<5>::from_gaps(source, GAPS, HALF)?;
    let ordered = |x: [Fraction; 5]| Ordering.conclusion(Form::Sharp, &line.setting, &[x]);
    source.assume(ordered(*line.start()) == Verdict::Holds)?;
    let mut history = [*line.start(); 3];
    for _ in 0..3 {
        let [then, between, now] = history;
        let state = State { drones: now, timesteps: 0 };
        let next = exec_coverage_delayed(&line.params, &state, |i, j| {
            if (i, j) == (2, 3) || (i, j) == (3, 2) { &then[j] } else { &now[j] }
        });
        history = [between, now, next.drones];
    }
    let holds = ordered(history[2]) == Verdict::Holds;
    assert!(holds, "the order is kept");
    Some(Witness(holds))
}

harnesses! {
    functions FUNCTIONS;
    /// Four drones that read stale positions do not pass their targets.
    upper_bound_4("7.3", unwind 5): covering!("N = 4, one step, any link stale, {STEP}")
        => |s| kept::<4, _>(s, upper_bounded);
    /// Four drones that read stale positions stay between the ends.
    box_4("7.3", unwind 5): covering!("N = 4, one step, any link stale, {STEP}")
        => |s| kept::<4, _>(s, |setting, x| in_box(setting, x));
    /// With present positions a step is one without delay.
    present_4("delay", unwind 5): covering!("N = 4, one step, {STEP}")
        => |s| present::<4, _>(s);
    /// Five drones cross where two of them see each other two steps late.
    ordering_fails("7.2", unwind 6, fails): covering!("N = 5, three steps, eps {HALF}")
        => |s| crossing(s);
}
