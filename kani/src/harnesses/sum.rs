//! Theorems 7.4 to 7.8: the sum of the positions, its fixed point, its growth, and the limit.

use core::cmp::Ordering::Equal;

use cordon_spec::coverage::exec_coverage;
use cordon_spec::placement::sum;
use cordon_spec::theorems::Theorem::{
    ConstantSum, GloballyIncreasing, Limit, SumBounded, SumMaximal, SumNonDecreasing,
    SumStationary, TargetsFixed,
};
use cordon_spec::theorems::telescoping_residual;
use cordon_spec::{Ordered, Params, Scalar, State};

use crate::bodies::along_a_run;
use crate::bounds::{
    Bounds, FIVE_BITS, FOUR_BITS, HALF, POSITIVE_UP_TO_HALF, QUOTIENTS, THIRD, THREE_TENTHS,
    UP_TO_HALF, Weights,
};
use crate::fraction::Fraction;
use crate::harness::{covering, harnesses};
use crate::line::{Line, same};
use crate::residue::Residue;
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &[
    "placement::contraction_weight",
    "placement::gap",
    "placement::scaled_energy",
    "placement::sum",
    "theorems::fixed_point::constant_sum",
    "theorems::fixed_point::remain",
    "theorems::fixed_point::stays",
    "theorems::fixed_point::targets_fixed",
    "theorems::hypothesis::at_target",
    "theorems::hypothesis::at_targets",
    "theorems::increasing::exact",
    "theorems::limit::at_rate",
    "theorems::limit::bounded_by",
    "theorems::limit::conclusion",
    "theorems::limit::magnitude",
    "theorems::limit::weighed",
    "theorems::verdict::Truth::any",
    "theorems::non_decreasing::conclusion",
    "theorems::non_decreasing::stationary",
    "theorems::non_decreasing::telescoping_residual",
    "theorems::sum::bounded",
    "theorems::sum::doubled",
    "theorems::sum::maximal",
];

/// All weights of the table.
const TABLE: Bounds = Bounds { positions: FIVE_BITS, weights: UP_TO_HALF };
const POSITIVE: Bounds = Bounds { positions: FIVE_BITS, weights: POSITIVE_UP_TO_HALF };
/// Any weight, beyond 1/2 and 1 too.
const FREE: Bounds = Bounds { positions: FIVE_BITS, weights: QUOTIENTS };
/// One weight: identities of products are the dearest for the solver.
const SINGLE: Bounds = Bounds { positions: FIVE_BITS, weights: THREE_TENTHS };
/// The step of the first increase is the solver's to find.
const SHORT: Bounds = Bounds { positions: Domain::new(0, 7, 6), weights: THIRD };
const SHORT_HALF: Bounds = Bounds { positions: Domain::new(0, 7, 6), weights: HALF };
/// Errors are squared.
const SQUARED: Bounds = Bounds { positions: FOUR_BITS, weights: POSITIVE_UP_TO_HALF };
const SQUARED_4: Bounds = Bounds { positions: Domain::new(0, 7, 6), weights: THIRD };
/// Between 1/2 and the critical weight, which is 1 for three drones and 2/3 for four.
const BEYOND_HALF_3: Bounds =
    Bounds { positions: FOUR_BITS, weights: Weights::Table(&[(2, 3), (9, 10)]) };
const BEYOND_HALF_4: Bounds =
    Bounds { positions: Domain::new(0, 7, 6), weights: Weights::Table(&[(3, 5)]) };

/// c^{k+1} - c^k = eps (g_{N-2} - g_0), whatever weight and start. Witness: the sum has changed.
fn telescopes<const N: usize, S: Source>(source: &mut S, bounds: &Bounds) -> Case {
    let line = Line::<N>::draw(source, bounds)?;
    let next = line.next();
    let residual = telescoping_residual(&line.params.eps, line.start(), &next);
    assert!(residual.compare(&Fraction::from_int(0)) == Some(Equal), "the identity holds");
    Some(Witness(!same(line.start(), &next)))
}

/// The same identity in the ring of integers modulo 4: every weight, every placement. Witness: the
/// sum has changed.
fn telescopes_in_a_ring<const N: usize, S: Source>(source: &mut S) -> Case {
    let drones: [Residue<2>; N] = core::array::from_fn(|_| Residue::draw(source));
    let eps = Residue::draw(source);
    let p = Params { min: drones[0], max: drones[N - 1], eps, n: 0 };
    let next = exec_coverage(&p, &State { drones, timesteps: 0 }).drones;
    let residual = telescoping_residual(&eps, &drones, &next);
    assert!(residual == Residue::from_int(0), "the identity holds");
    Some(Witness(sum(&next) != sum(&drones)))
}

harnesses! {
    functions FUNCTIONS;
    /// The sum of four positions is at most its bound, before and after a step.
    bounded_4("7.4i", unwind 5): covering!("N = 4, one step, {TABLE}")
        => |s| along_a_run::<4, 2, _>(s, SumBounded, &TABLE);
    /// The sum of six positions is at most its bound, before and after a step.
    bounded_6("7.4i", unwind 7): covering!("N = 6, one step, {TABLE}")
        => |s| along_a_run::<6, 2, _>(s, SumBounded, &TABLE);
    /// The sum of four positions meets its bound at the targets only.
    maximal_4("7.4ii", unwind 5): covering!("N = 4, one step, {TABLE}")
        => |s| along_a_run::<4, 2, _>(s, SumMaximal, &TABLE);
    /// The sum of five positions meets its bound at the targets only.
    maximal_5("7.4ii", unwind 6): covering!("N = 5, one step, {TABLE}")
        => |s| along_a_run::<5, 2, _>(s, SumMaximal, &TABLE);
    /// The sum of three positions changes by eps (g_1 - g_0).
    telescopes_3("7.5i", unwind 4): covering!("N = 3, one step, {SINGLE}")
        => |s| telescopes::<3, _>(s, &SINGLE);
    /// The sum of four positions changes by eps (g_2 - g_0).
    telescopes_4("7.5i", unwind 5): covering!("N = 4, one step, {SINGLE}")
        => |s| telescopes::<4, _>(s, &SINGLE);
    /// The sum of three positions changes by eps (g_1 - g_0), in a ring.
    telescopes_ring_3("7.5i", unwind 4): covering!("N = 3, all positions and weights modulo 4")
        => |s| telescopes_in_a_ring::<3, _>(s);
    /// The sum of five positions changes by eps (g_3 - g_0), in a ring.
    telescopes_ring_5("7.5i", unwind 6): covering!("N = 5, all positions and weights modulo 4")
        => |s| telescopes_in_a_ring::<5, _>(s);
    /// The sum of four positions does not decrease.
    increases_4("7.5i", unwind 5): covering!("N = 4, one step, {TABLE}")
        => |s| along_a_run::<4, 2, _>(s, SumNonDecreasing, &TABLE);
    /// The sum of six positions does not decrease.
    increases_6("7.5i", unwind 7): covering!("N = 6, one step, {SINGLE}")
        => |s| along_a_run::<6, 2, _>(s, SumNonDecreasing, &SINGLE);
    /// At the targets the sum of four positions stays.
    stationary_4("7.5ii", unwind 5): covering!("N = 4, one step, {FREE}")
        => |s| along_a_run::<4, 2, _>(s, SumStationary, &FREE);
    /// Three drones at their targets stay there, whatever the weight.
    fixed_3("7.6i", unwind 4): covering!("N = 3, one step, {FREE}")
        => |s| along_a_run::<3, 2, _>(s, TargetsFixed, &FREE);
    /// Five drones at their targets stay there, whatever the weight.
    fixed_5("7.6i", unwind 6): covering!("N = 5, two steps, {POSITIVE}")
        => |s| along_a_run::<5, 3, _>(s, TargetsFixed, &POSITIVE);
    /// A sum of four positions that stays for a step means that all are at their targets.
    constant_4("7.6ii", unwind 5): covering!("N = 4, one step, {POSITIVE}")
        => |s| along_a_run::<4, 2, _>(s, ConstantSum, &POSITIVE);
    /// A sum of five positions that stays for two steps means that all are at their targets.
    constant_5("7.6ii", unwind 6): covering!("N = 5, two steps, {POSITIVE}")
        => |s| along_a_run::<5, 3, _>(s, ConstantSum, &POSITIVE);
    /// Off the targets the sum of four positions increases when the theorem says.
    growth_4("7.7", unwind 5): covering!("N = 4, one step, {POSITIVE}")
        => |s| along_a_run::<4, 2, _>(s, GloballyIncreasing, &POSITIVE);
    /// Off the targets the sum of five positions increases when the theorem says.
    growth_5("7.7", unwind 6): covering!("N = 5, two steps, {SHORT}")
        => |s| along_a_run::<5, 3, _>(s, GloballyIncreasing, &SHORT);
    /// Off the targets the sum of six positions increases when the theorem says.
    growth_6("7.7", unwind 7): covering!("N = 6, two steps, {SHORT_HALF}")
        => |s| along_a_run::<6, 3, _>(s, GloballyIncreasing, &SHORT_HALF);
    /// The squared error of three drones falls in every step, at the rate of the theorem.
    limit_3("7.8", unwind 4): covering!("N = 3, one step, {SQUARED}")
        => |s| along_a_run::<3, 2, _>(s, Limit, &SQUARED);
    /// The squared error of four drones falls in every step, at the rate of the theorem.
    limit_4("7.8", unwind 5): covering!("N = 4, one step, {SQUARED_4}")
        => |s| along_a_run::<4, 2, _>(s, Limit, &SQUARED_4);
    /// The squared error of three drones falls for weights between 1/2 and 1 too.
    limit_beyond_half_3("7.8", unwind 4): covering!("N = 3, one step, {BEYOND_HALF_3}")
        => |s| along_a_run::<3, 2, _>(s, Limit, &BEYOND_HALF_3);
    /// The squared error of four drones falls for weights between 1/2 and 2/3 too.
    limit_beyond_half_4("7.8", unwind 5): covering!("N = 4, one step, {BEYOND_HALF_4}")
        => |s| along_a_run::<4, 2, _>(s, Limit, &BEYOND_HALF_4);
}
