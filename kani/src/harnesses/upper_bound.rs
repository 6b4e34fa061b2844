//! Theorem 7.3: no drone passes its target; its mirror image and the box.

use cordon_spec::theorems::Theorem::UpperBound;
use cordon_spec::theorems::{Setting, Verdict, WeightRange, above_targets, in_box};

use crate::bodies::{along_a_run, preserved};
use crate::bounds::{
    BYTE, Bounds, FIVE_BITS, FOUR_BITS, QUOTIENTS, THREE_TENTHS, UP_TO_HALF, WORD,
};
use crate::fraction::Fraction;
use crate::harness::{covering, harnesses};
use crate::line::{Line, same};
use crate::source::{Case, Source, Witness};

const FUNCTIONS: &[&str] = &[
    "placement::gaps",
    "placement::scaled_error",
    "theorems::hypothesis::upper_bounded",
    "theorems::upper_bound::above_targets",
    "theorems::upper_bound::conclusion",
    "theorems::upper_bound::for_each_drone",
    "theorems::upper_bound::in_box",
];

/// As for the order: see `ordering.rs`.
const STEP: Bounds = Bounds { positions: BYTE, weights: UP_TO_HALF };
const FREE: Bounds = Bounds { positions: FIVE_BITS, weights: QUOTIENTS };
const WIDE: Bounds = Bounds { positions: WORD, weights: THREE_TENTHS };
const RUN: Bounds = Bounds { positions: BYTE, weights: THREE_TENTHS };
const RUN_NARROW: Bounds = Bounds { positions: FOUR_BITS, weights: UP_TO_HALF };

/// A property of a placement.
type Property = fn(&Setting<Fraction>, &[Fraction]) -> Verdict;

/// The induction step of a property that is no start set of a theorem. Witness: a drone has moved.
fn kept<const N: usize, S: Source>(source: &mut S, property: Property, bounds: &Bounds) -> Case {
    let line = Line::<N>::draw(source, bounds)?;
    let (num, den) = (&line.setting.eps_num, &line.setting.eps_den);
    source.assume(WeightRange::UpToHalf.contains(num, den, N).is_true())?;
    source.assume(property(&line.setting, line.start()) == Verdict::Holds)?;
    let next = line.next();
    assert!(property(&line.setting, &next) == Verdict::Holds, "the property holds after a step");
    Some(Witness(!same(line.start(), &next)))
}

harnesses! {
    functions FUNCTIONS;
    /// One step takes none of three drones beyond its target.
    step_3("7.3", unwind 4): covering!("N = 3, one step, {STEP}")
        => |s| preserved::<3, _>(s, UpperBound, &STEP);
    /// One step takes none of four drones beyond its target.
    step_4("7.3", unwind 5): covering!("N = 4, one step, {STEP}")
        => |s| preserved::<4, _>(s, UpperBound, &STEP);
    /// One step takes none of five drones beyond its target.
    step_5("7.3", unwind 6): covering!("N = 5, one step, {STEP}")
        => |s| preserved::<5, _>(s, UpperBound, &STEP);
    /// One step takes none of six drones beyond its target.
    step_6("7.3", unwind 7): covering!("N = 6, one step, {STEP}")
        => |s| preserved::<6, _>(s, UpperBound, &STEP);
    /// One step takes none of three drones beyond its target, both parts of the weight free.
    step_free_3("7.3", unwind 4): covering!("N = 3, one step, {FREE}")
        => |s| preserved::<3, _>(s, UpperBound, &FREE);
    /// One step takes none of four drones beyond its target, both parts of the weight free.
    step_free_4("7.3", unwind 5): covering!("N = 4, one step, {FREE}")
        => |s| preserved::<4, _>(s, UpperBound, &FREE);
    /// One step takes none of four drones beyond its target, on a fine scale.
    step_wide_4("7.3", unwind 5): covering!("N = 4, one step, {WIDE}")
        => |s| preserved::<4, _>(s, UpperBound, &WIDE);
    /// Three steps take none of three drones beyond its target.
    run_3("7.3", unwind 5): covering!("N = 3, three steps, {RUN}")
        => |s| along_a_run::<3, 4, _>(s, UpperBound, &RUN);
    /// Three steps take none of four drones beyond its target.
    run_4("7.3", unwind 5): covering!("N = 4, three steps, {RUN}")
        => |s| along_a_run::<4, 4, _>(s, UpperBound, &RUN);
    /// Two steps of any weight take none of five drones beyond its target.
    run_5("7.3", unwind 6): covering!("N = 5, two steps, {RUN_NARROW}")
        => |s| along_a_run::<5, 3, _>(s, UpperBound, &RUN_NARROW);
    /// The mirror image: four drones beyond their targets stay there.
    mirror_4("7.3", unwind 5): covering!("N = 4, one step, {STEP}")
        => |s| kept::<4, _>(s, above_targets, &STEP);
    /// The mirror image: six drones beyond their targets stay there.
    mirror_6("7.3", unwind 7): covering!("N = 6, one step, {STEP}")
        => |s| kept::<6, _>(s, above_targets, &STEP);
    /// The box: three drones between the ends stay there, in any order.
    box_3("7.3", unwind 4): covering!("N = 3, one step, {STEP}")
        => |s| kept::<3, _>(s, in_box, &STEP);
    /// The box: four drones between the ends stay there, in any order.
    box_4("7.3", unwind 5): covering!("N = 4, one step, {STEP}")
        => |s| kept::<4, _>(s, in_box, &STEP);
    /// The box: six drones between the ends stay there, in any order.
    box_6("7.3", unwind 7): covering!("N = 6, one step, {STEP}")
        => |s| kept::<6, _>(s, in_box, &STEP);
}
