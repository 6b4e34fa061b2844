//! Function contracts of the single-drone update, which Kani checks against the spec's own
//! function: callers may then use them in its place.
//!
//! Kani takes contracts of concrete functions. [`next`] is `exec_cvg` of an internal drone on the
//! exact scalar; the attributes are there for Kani only, and for an ordinary build `next` is the
//! call and nothing else. The clauses are functions, so that the tests without Kani hold the same
//! clauses against the same function.

use cordon_spec::coverage::exec_cvg;
use cordon_spec::{Params, Scalar};

use crate::bounds::{FIVE_BITS, THREE_TENTHS};
use crate::fraction::Fraction;
use crate::harness::{Expected, Harness, covering, path};
use crate::source::{Case, Source, Witness};

/// The weight, numerator and denominator: the solver multiplies by constants then.
const WEIGHT: (i32, i32) = (3, 10);

/// Ten times the next position of an internal drone at eps = 3/10, from the predecessor's, its
/// own and the successor's position.
#[cfg_attr(kani, kani::requires(are_short(a, b, c)))]
#[cfg_attr(kani, kani::ensures(|next| between(a, b, c, *next)))]
#[cfg_attr(kani, kani::ensures(|next| moved_by_the_gaps(a, b, c, *next)))]
pub fn next(a: i32, b: i32, c: i32) -> i32 {
    let (num, den) = WEIGHT;
    // No array: what a contract watches, the model checker follows through every write to memory.
    let (xp, x, xf) = (Fraction::from_int(a), Fraction::from_int(b), Fraction::from_int(c));
    let p = Params { min: xp, max: xf, eps: Fraction::quotient(num, den), n: 0 };
    // Drone 1 of 3 is internal.
    exec_cvg(&p, 3, &xp, &x, &xf, 1).over_base()
}

/// Required: positions of 5 bits.
pub fn are_short(a: i32, b: i32, c: i32) -> bool {
    let short = |x| (0..=FIVE_BITS.high).contains(&x);
    short(a) && short(b) && short(c)
}

/// Ensured: the next position is a weighted mean, at least the least of the three positions and
/// at most the greatest. The box follows.
pub fn between(a: i32, b: i32, c: i32, next: i32) -> bool {
    let (_, den) = WEIGHT;
    den * a.min(b).min(c) <= next && next <= den * a.max(b).max(c)
}

/// Ensured: the drone moves by the weight times the difference of its gaps.
pub fn moved_by_the_gaps(a: i32, b: i32, c: i32, next: i32) -> bool {
    let (num, den) = WEIGHT;
    next - den * b == num * ((c - b) - (b - a))
}

/// The contract as a body. Witness: the drone moves.
fn upheld<S: Source>(source: &mut S) -> Case {
    let [a, b, c] = source.integers::<3>(FIVE_BITS);
    source.assume(are_short(a, b, c))?;
    let next = next(a, b, c);
    assert!(between(a, b, c, next), "the next position is a mean");
    assert!(moved_by_the_gaps(a, b, c, next), "moved by the gaps");
    Some(Witness(next != WEIGHT.1 * b))
}

const FUNCTIONS: &[&str] = &["coverage::exec_cvg"];

/// The harnesses of the contracts.
pub const HARNESSES: &[Harness] = &[Harness {
    name: path(concat!(module_path!(), "::update")),
    subject: "7.3",
    claim: "The update is a weighted mean of the three positions: its contract.",
    bounds: covering!("one drone, positions {FIVE_BITS}, eps {THREE_TENTHS}"),
    expected: Expected::Holds,
    functions: FUNCTIONS,
    exhaustive: |s| upheld(s),
    from_bytes: |s| upheld(s),
}];

#[cfg(kani)]
#[kani::proof_for_contract(next)]
#[kani::unwind(4)]
#[kani::solver(minisat)]
fn update() {
    let (a, b, c) = (kani::any(), kani::any(), kani::any());
    let next = next(a, b, c);
    kani::cover!(next != WEIGHT.1 * b, "the witness is reached");
}
