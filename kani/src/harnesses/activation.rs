//! Steps in which some drones skip their update (PROTOCOL section 2, activation).

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::theorems::Theorem::{self, Ordering, UpperBound};
use cordon_spec::theorems::{Form, Verdict};

use crate::bodies::meeting;
use crate::bounds::{Bounds, FOUR_BITS, HALF, Weights};
use crate::harness::{covering, harnesses};
use crate::line::{Line, same};
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &["activation::exec_coverage_active", "coverage::getx"];

/// Every subset of the drones multiplies what the solver goes through: few bits, and the weights
/// at which the theorems' bounds are.
const STEP: Bounds = Bounds { positions: FOUR_BITS, weights: Weights::Table(&[(1, 3), (1, 2)]) };
const STEP_5: Bounds = Bounds { positions: Domain::new(0, 7, 6), weights: HALF };

/// Which drones move.
fn subset<const N: usize, S: Source>(source: &mut S) -> [bool; N] {
    source.integers::<N>(Domain::whole(0, 1)).map(|bit| bit == 1)
}

/// The induction step, whichever drones move. Witness: one has moved and one has skipped its move.
fn preserved<const N: usize, S: Source>(source: &mut S, theorem: Theorem, bounds: &Bounds) -> Case {
    let line = meeting::<N, S>(source, theorem, bounds)?;
    let active = subset::<N, S>(source);
    let next = exec_coverage_active(&line.params, &line.state, |i| active[i]).drones;
    let verdict = theorem.conclusion(Form::Sharp, &line.setting, &[next]);
    assert!(verdict == Verdict::Holds, "the conclusion holds after a step");
    let kept = theorem.hypothesis(Form::Sharp).starts.contains(&line.setting, &next);
    assert!(kept.is_true(), "the start set contains the placement after a step");
    let one_skips = active[1..N - 1].contains(&false);
    Some(Witness(one_skips && !same(line.start(), &next)))
}

/// A drone that is active moves as in a step of all, the others stay. Witness: as above.
fn pointwise<const N: usize, S: Source>(source: &mut S) -> Case {
    let line = Line::<N>::draw(source, &STEP)?;
    let active = subset::<N, S>(source);
    let next = exec_coverage_active(&line.params, &line.state, |i| active[i]);
    let all = line.next();
    for i in 0..N {
        let expected = if active[i] { all[i] } else { line.start()[i] };
        assert!(same(&[next.drones[i]], &[expected]), "an active drone moves, another stays");
    }
    assert!(next.timesteps == line.state.timesteps, "the tick counter is kept");
    Some(Witness(!same(line.start(), &next.drones) && !same(&all, &next.drones)))
}

harnesses! {
    functions FUNCTIONS;
    /// Four drones of which any may skip an update stay in order.
    ordering_4("7.2", unwind 5): covering!("N = 4, one step, any subset moves, {STEP}")
        => |s| preserved::<4, _>(s, Ordering, &STEP);
    /// Five drones of which any may skip an update stay in order.
    ordering_5("7.2", unwind 6): covering!("N = 5, one step, any subset moves, {STEP_5}")
        => |s| preserved::<5, _>(s, Ordering, &STEP_5);
    /// Four drones of which any may skip an update do not pass their targets.
    upper_bound_4("7.3", unwind 5): covering!("N = 4, one step, any subset moves, {STEP}")
        => |s| preserved::<4, _>(s, UpperBound, &STEP);
    /// Five drones of which any may skip an update do not pass their targets.
    upper_bound_5("7.3", unwind 6): covering!("N = 5, one step, any subset moves, {STEP_5}")
        => |s| preserved::<5, _>(s, UpperBound, &STEP_5);
    /// A drone that moves does so as in a step of all drones.
    pointwise_4("activation", unwind 5): covering!("N = 4, one step, any subset moves, {STEP}")
        => |s| pointwise::<4, _>(s);
}
