//! Theorem 7.2: drones never cross.

use cordon_spec::theorems::Theorem::Ordering;

use crate::bodies::{along_a_run, preserved};
use crate::bounds::{
    BYTE, Bounds, FIVE_BITS, FOUR_BITS, HALF, QUOTIENTS, THIRD, THREE_TENTHS, UP_TO_HALF,
    UP_TO_ONE, WORD,
};
use crate::harness::{covering, harnesses};

const FUNCTIONS: &[&str] = &[
    "coverage::exec_cvg",
    "coverage::exec_coverage",
    "coverage::next_placement",
    "coverage::update",
    "drone_map::DroneMap::lambda",
    "drone_map::DroneMap::count",
    "theorems::Theorem::hypothesis",
    "theorems::Theorem::span",
    "theorems::Theorem::conclusion",
    "theorems::ordering::conclusion",
    "theorems::hypothesis::Hypothesis::met_by",
    "theorems::hypothesis::ordered",
];

/// All weights of the table, positions of 8 bits: N = 4 holds the whole local window of the
/// update (two drones and their neighbours); 3 has both ends adjacent.
const STEP: Bounds = Bounds { positions: BYTE, weights: UP_TO_HALF };
const STEP_OF_THREE: Bounds = Bounds { positions: BYTE, weights: UP_TO_ONE };
/// Numerator and denominator free.
const FREE: Bounds = Bounds { positions: FIVE_BITS, weights: QUOTIENTS };
/// Millimetres on 65 m.
const WIDE: Bounds = Bounds { positions: WORD, weights: THREE_TENTHS };
const WIDE_HALF: Bounds = Bounds { positions: WORD, weights: HALF };
/// Denominators grow with every step: fewer weights, narrower positions.
const RUN: Bounds = Bounds { positions: BYTE, weights: THREE_TENTHS };
const RUN_THIRD: Bounds = Bounds { positions: BYTE, weights: THIRD };
const RUN_NARROW: Bounds = Bounds { positions: FOUR_BITS, weights: THREE_TENTHS };
const RUN_HALF: Bounds = Bounds { positions: FOUR_BITS, weights: HALF };

harnesses! {
    functions FUNCTIONS;
    /// One step keeps three drones in order, for weights up to 1.
    step_3("7.2", unwind 4): covering!("N = 3, one step, {STEP_OF_THREE}")
        => |s| preserved::<3, _>(s, Ordering, &STEP_OF_THREE);
    /// One step keeps four drones in order.
    step_4("7.2", unwind 5): covering!("N = 4, one step, {STEP}")
        => |s| preserved::<4, _>(s, Ordering, &STEP);
    /// One step keeps five drones in order.
    step_5("7.2", unwind 6): covering!("N = 5, one step, {STEP}")
        => |s| preserved::<5, _>(s, Ordering, &STEP);
    /// One step keeps six drones in order.
    step_6("7.2", unwind 7): covering!("N = 6, one step, {STEP}")
        => |s| preserved::<6, _>(s, Ordering, &STEP);
    /// One step keeps three drones in order, numerator and denominator of the weight free.
    step_free_3("7.2", unwind 4): covering!("N = 3, one step, {FREE}")
        => |s| preserved::<3, _>(s, Ordering, &FREE);
    /// One step keeps four drones in order, numerator and denominator of the weight free.
    step_free_4("7.2", unwind 5): covering!("N = 4, one step, {FREE}")
        => |s| preserved::<4, _>(s, Ordering, &FREE);
    /// One step keeps five drones in order, numerator and denominator of the weight free.
    step_free_5("7.2", unwind 6): covering!("N = 5, one step, {FREE}")
        => |s| preserved::<5, _>(s, Ordering, &FREE);
    /// One step keeps six drones in order, numerator and denominator of the weight free.
    step_free_6("7.2", unwind 7): covering!("N = 6, one step, {FREE}")
        => |s| preserved::<6, _>(s, Ordering, &FREE);
    /// One step keeps four drones in order on a fine scale.
    step_wide_4("7.2", unwind 5): covering!("N = 4, one step, {WIDE}")
        => |s| preserved::<4, _>(s, Ordering, &WIDE);
    /// One step keeps six drones in order on a fine scale.
    step_wide_6("7.2", unwind 7): covering!("N = 6, one step, {WIDE}")
        => |s| preserved::<6, _>(s, Ordering, &WIDE);
    /// One step of the largest safe weight keeps six drones in order on a fine scale.
    step_wide_half_6("7.2", unwind 7): covering!("N = 6, one step, {WIDE_HALF}")
        => |s| preserved::<6, _>(s, Ordering, &WIDE_HALF);
    /// Four steps from any ordered start keep three drones in order.
    run_3("7.2", unwind 6): covering!("N = 3, four steps, {RUN}")
        => |s| along_a_run::<3, 5, _>(s, Ordering, &RUN);
    /// Two steps from any ordered start keep four drones in order.
    run_4("7.2", unwind 5): covering!("N = 4, two steps, {RUN}")
        => |s| along_a_run::<4, 3, _>(s, Ordering, &RUN);
    /// Three steps of the paper's bound from any ordered start keep four drones in order.
    run_third_4("7.2", unwind 5): covering!("N = 4, three steps, {RUN_THIRD}")
        => |s| along_a_run::<4, 4, _>(s, Ordering, &RUN_THIRD);
    /// Four steps of the largest safe weight from any ordered start keep four drones in order.
    run_half_4("7.2", unwind 6): covering!("N = 4, four steps, {RUN_HALF}")
        => |s| along_a_run::<4, 5, _>(s, Ordering, &RUN_HALF);
    /// Two steps from any ordered start keep five drones in order.
    run_5("7.2", unwind 6): covering!("N = 5, two steps, {RUN_NARROW}")
        => |s| along_a_run::<5, 3, _>(s, Ordering, &RUN_NARROW);
    /// Two steps from any ordered start keep six drones in order.
    run_6("7.2", unwind 7): covering!("N = 6, two steps, {RUN_NARROW}")
        => |s| along_a_run::<6, 3, _>(s, Ordering, &RUN_NARROW);
}
