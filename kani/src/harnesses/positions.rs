//! The quantities of a placement, against their definitions.

use cordon_spec::Scalar;
use cordon_spec::placement::{
    contraction_weight, gap, gaps, scaled_energy, scaled_error, scaled_target, sum,
};
use cordon_spec::theorems::StartSet;

use crate::bounds::THREE_TENTHS;
use crate::fraction::Fraction;
use crate::harness::{covering, harnesses};
use crate::line::{Line, same};
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &[
    "placement::contraction_weight",
    "placement::gap",
    "placement::gaps",
    "placement::scaled_energy",
    "placement::scaled_error",
    "placement::scaled_target",
    "placement::sum",
];

/// 3 bits and a sign: identities of sums are dear to the solver.
const POSITIONS: Domain = Domain::new(-8, 7, -5);
/// Where they are squared.
const SMALL: Domain = Domain::new(-4, 3, 0);
/// Positions and distance of a translation: a free distance in every sum is dear.
const SHIFTED: Domain = Domain::new(0, 7, 3);
/// Swarms up to this size, for what is said of an index.
const COUNTS: Domain = Domain::whole(2, 63);

/// Gaps add up to the distance of the ends; targets begin at min, end at max and are evenly
/// spaced; the error is what is left to the target. Witness: a drone off its target.
fn defined<const N: usize, S: Source>(source: &mut S) -> Case {
    let x = source.integers::<N>(POSITIONS);
    let (min, max) = (source.integer(POSITIONS), source.integer(POSITIONS));
    let last = i32::try_from(N - 1).unwrap_or(i32::MAX);
    let (mut length, mut total, mut off) = (0, x[N - 1], false);
    for i in 0..N - 1 {
        length += gap(&x, i);
        total += x[i];
        let step = scaled_target(&min, &max, N, i + 1) - scaled_target(&min, &max, N, i);
        assert!(step == max - min, "evenly spaced");
    }
    assert!(length == x[N - 1] - x[0], "the gaps add up");
    assert!(sum(&x) == total, "the sum");
    assert!(gaps::<i32>(&x) == last, "the number of gaps");
    assert!(scaled_target(&min, &max, N, 0) == last * min, "the first target");
    assert!(scaled_target(&min, &max, N, N - 1) == last * max, "the last target");
    for (i, xi) in x.iter().enumerate() {
        let target = scaled_target(&min, &max, N, i);
        let error = scaled_error(&min, &max, &x, i);
        assert!(error + last * xi == target, "what is left to the target");
        off |= error != 0;
    }
    Some(Witness(off))
}

/// The energy is the sum of the squared errors. Witness: it is 0.
fn squares<S: Source>(source: &mut S) -> Case {
    let x = source.integers::<3>(SMALL);
    let (min, max) = (source.integer(SMALL), source.integer(SMALL));
    let error = |i| scaled_error(&min, &max, &x, i);
    let energy = scaled_energy(&min, &max, &x);
    assert!(energy == error(0) * error(0) + error(1) * error(1) + error(2) * error(2), "squares");
    let at_targets = x[0] == min && 2 * x[1] == min + max && x[2] == max;
    assert!((energy == 0) == at_targets, "0 at the targets only");
    Some(Witness(energy == 0))
}

/// The contraction vector is positive on the internal drones, 0 at the ends, symmetric, and its
/// second difference is -2 (PROTOCOL section 2: A w = w - 2 eps). Witness: an internal drone.
fn contracts<S: Source>(source: &mut S) -> Case {
    let count = source.integer(COUNTS).unsigned_abs() as usize;
    let i = source.integer(Domain::whole(0, 62)).unsigned_abs() as usize;
    source.assume(i < count)?;
    let w = contraction_weight(count, i);
    let internal = i > 0 && i + 1 < count;
    assert!((w > 0) == internal, "positive on the internal drones only");
    assert!(w == contraction_weight(count, count - 1 - i), "symmetric");
    if internal {
        let around = contraction_weight(count, i - 1) + contraction_weight(count, i + 1);
        assert!(around + 2 == 2 * w, "the second difference");
    }
    Some(Witness(internal))
}

/// A translation of the line by any distance translates the next placement, and changes no
/// answer of the predicates; so the first drone may be at 0 elsewhere. Witness: a drone moves.
fn translated<const N: usize, S: Source>(source: &mut S) -> Case {
    let x = source.integers::<N>(SHIFTED);
    let by = source.integer(SHIFTED);
    let (num, den) = THREE_TENTHS.draw(source);
    source.assume(x[0] < x[N - 1])?;
    let (here, there) = (Line::at(x, (num, den)), Line::at(x.map(|xi| xi + by), (num, den)));
    let (next, moved) = (here.next(), there.next());
    let distance = Fraction::from_int(by);
    for (a, b) in next.iter().zip(&moved) {
        assert!(same(&[*a + &distance], &[*b]), "a step commutes with a translation");
    }
    for set in [StartSet::Ordered, StartSet::UpperBounded] {
        let answer = set.contains(&here.setting, &next);
        assert!(answer == set.contains(&there.setting, &moved), "no answer changes");
    }
    Some(Witness(!same(here.start(), &next)))
}

harnesses! {
    functions FUNCTIONS;
    /// Gaps, sum, targets and errors of three drones are what they are defined to be.
    defined_3("placement", unwind 4): covering!("N = 3, positions {POSITIONS}")
        => |s| defined::<3, _>(s);
    /// Gaps, sum, targets and errors of four drones are what they are defined to be.
    defined_4("placement", unwind 5): covering!("N = 4, positions {POSITIONS}")
        => |s| defined::<4, _>(s);
    /// The squared errors add up, and vanish at the targets only.
    energy("placement", unwind 4): covering!("N = 3, positions {SMALL}") => |s| squares(s);
    /// The contraction vector is positive inside, symmetric, with second difference -2.
    contraction("placement", unwind 5): covering!("N in {COUNTS}, every drone")
        => |s| contracts(s);
    /// A step commutes with translations, and the start sets do not see them: three drones.
    translation_3("placement", unwind 4): covering!("N = 3, positions and distance {SHIFTED}, eps {THREE_TENTHS}")
        => |s| translated::<3, _>(s);
    /// A step commutes with translations, and the start sets do not see them: four drones.
    translation_4("placement", unwind 5): covering!("N = 4, positions and distance {SHIFTED}, eps {THREE_TENTHS}")
        => |s| translated::<4, _>(s);
}
