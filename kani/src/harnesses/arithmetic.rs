//! The spec's own arithmetic: machine integers embed the integers, agree with one another, and
//! do not overflow in the stated ranges.

use core::cmp::Ordering;

use cordon_spec::coverage::{exec_coverage, exec_cvg};
use cordon_spec::{Ordered, Params, Scalar, State};

use crate::harness::{covering, harnesses};
use crate::line::same;
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &[
    "coverage::exec_cvg",
    "scalar::Ordered::compare",
    "scalar::Scalar::from_index",
    "scalar::Scalar::from_int",
];

/// 16 bits and a sign: with weights of 8 bits every product fits 32.
const POSITIONS: Domain = Domain::new(-32_768, 32_767, -32_767);
const WEIGHTS: Domain = Domain::new(-128, 127, -126);

/// `from_int` and `from_index` are the integer itself, in every width. Witness: beyond 31 bits.
fn embeds<S: Source>(source: &mut S) -> Case {
    let word = source.word();
    let n = word.cast_signed();
    assert!(i32::from_int(n) == n, "32 bits");
    assert!(i64::from_int(n) == i64::from(n), "64 bits");
    assert!(i128::from_int(n) == i128::from(n), "128 bits");
    let index = word as usize;
    assert!(i64::from_index(index) == i64::from(word), "an index in 64 bits");
    assert!(i128::from_index(index) == i128::from(word), "an index in 128 bits");
    if n >= 0 {
        assert!(i32::from_index(index) == n, "an index in 32 bits");
    }
    Some(Witness(n < 0))
}

/// The largest indices, of 64 bits. Witness: the last.
fn embeds_last<S: Source>(source: &mut S) -> Case {
    let below = source.integer(Domain::whole(0, 255));
    let index = usize::MAX - below.unsigned_abs() as usize;
    let expected = i128::try_from(index).unwrap_or(i128::MAX);
    assert!(i128::from_index(index) == expected, "an index in 128 bits");
    Some(Witness(index == usize::MAX))
}

/// Three multipliers of different widths compared: 3 bits.
const NARROW: Domain = Domain::new(-4, 3, -2);

/// The three widths of integers compute the same step, none overflowing. Witness: a drone moves.
fn agree<const N: usize, S: Source>(source: &mut S) -> Case {
    let x = source.integers::<N>(NARROW);
    let eps = source.integer(NARROW);
    let step32 = stepped(x, eps);
    let step64 = stepped(x.map(i64::from), i64::from(eps));
    let step128 = stepped(x.map(i128::from), i128::from(eps));
    assert!(same(&step32.map(i64::from), &step64), "32 and 64 bits agree");
    assert!(same(&step64.map(i128::from), &step128), "64 and 128 bits agree");
    Some(Witness(!same(&step32, &x)))
}

fn stepped<S: Scalar, const N: usize>(x: [S; N], eps: S) -> [S; N] {
    let (min, max) = (x[0].clone(), x[N - 1].clone());
    let p = Params { min, max, eps, n: 0 };
    exec_coverage(&p, &State { drones: x, timesteps: 0 }).drones
}

/// `exec_cvg` of any index below any count: the ends stay, the others obey the formula. Witness:
/// an internal drone moves.
fn is_equation_10<S: Source>(source: &mut S) -> Case {
    let (count, i) = (source.word() as usize, source.word() as usize);
    source.assume(i < count)?;
    let [a, b, c, min, max] = source.integers::<5>(NARROW);
    let eps = source.integer(NARROW);
    let next = exec_cvg(&Params { min, max, eps, n: 0 }, count, &a, &b, &c, i);
    let expected = match i {
        0 => min,
        _ if i == count - 1 => max,
        // The same polynomial, written as a displacement.
        _ => b + eps * (a - 2 * b + c),
    };
    assert!(next == expected, "equation 10");
    Some(Witness(next != b && i > 0 && i < count - 1))
}

/// `exec_cvg` overflows neither in the index nor in 32 bits, for positions of 16 bits and weights
/// of 8, signs included. Witness: a large position.
fn fits<S: Source>(source: &mut S) -> Case {
    let (count, i) = (source.word() as usize, source.word() as usize);
    source.assume(i < count)?;
    let [a, b, c] = source.integers::<3>(POSITIONS);
    let eps = source.integer(WEIGHTS);
    let next = exec_cvg(&Params { min: a, max: c, eps, n: 0 }, count, &a, &b, &c, i);
    // (1 + 4 * 128) * 32768, the sum of the coefficients' sizes times the largest position.
    assert!(next.abs() <= 16_809_984, "within 25 bits");
    Some(Witness(next.abs() > 32_768))
}

/// `compare` is the order of the integers, in every width. Witness: less.
fn compares<S: Source>(source: &mut S) -> Case {
    let [a, b] = [source.word().cast_signed(), source.word().cast_signed()];
    let expected = if a < b {
        Ordering::Less
    } else if a > b {
        Ordering::Greater
    } else {
        Ordering::Equal
    };
    assert!(a.compare(&b) == Some(expected), "32 bits");
    assert!(i64::from(a).compare(&i64::from(b)) == Some(expected), "64 bits");
    assert!(i128::from(a).compare(&i128::from(b)) == Some(expected), "128 bits");
    Some(Witness(a < b))
}

harnesses! {
    functions FUNCTIONS;
    /// Integers and indices of up to 32 bits are embedded as themselves.
    embedded("arithmetic", unwind 2): covering!("all words") => |s| embeds(s);
    /// The largest indices are embedded as themselves.
    last_index("arithmetic", unwind 36): covering!("the last 256 of 64 bits") => |s| embeds_last(s);
    /// Integers of 32, 64 and 128 bits compute the same step of three drones.
    agree_3("arithmetic", unwind 5): covering!("N = 3, positions and eps {NARROW}")
        => |s| agree::<3, _>(s);
    /// The update is equation 10, for every index below every count.
    update("arithmetic", unwind 6):
        covering!("all counts and indices of 32 bits, positions and eps {NARROW}")
        => |s| is_equation_10(s);
    /// The update does not overflow, for every index below every count.
    no_overflow("arithmetic", unwind 4):
        covering!("all counts and indices of 32 bits, positions {POSITIONS}, eps {WEIGHTS}")
        => |s| fits(s);
    /// The order of scalars is that of the integers.
    compared("arithmetic", unwind 2): covering!("all words") => |s| compares(s);
}
