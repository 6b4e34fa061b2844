//! The evaluations: the shipped scenarios, both phases, non-integer ratios, small and large weights,
//! and every other definition for 3 to 7 drones.

use core::num::NonZeroU32;

use cordon_spec::local::TickRatio;
use cordon_spec::{Params, Phase};

use super::{Vector, kinds};
use cordon_core::Rational;

/// A fraction as written in the tables.
type Fraction = (i64, i64);

/// The model that a series runs.
#[derive(Clone, Copy)]
enum Kind {
    Coverage { min: i64, max: i64, n: u32, phase: Phase },
    Local { min: i64, max: i64, ratio: TickRatio, phase: Phase },
    Consensus,
}

/// A run evaluated at several steps k.
struct Series {
    name: &'static str,
    kind: Kind,
    eps: Fraction,
    start: &'static [Fraction],
    ks: &'static [u64],
}

/// The start of the paper's figures.
const PAPER: &[Fraction] = &[(0, 1), (10, 1), (20, 1), (30, 1), (100, 1)];

const ONE: NonZeroU32 = NonZeroU32::MIN;
const TWO: NonZeroU32 = NonZeroU32::MIN.saturating_add(1);

const fn paper(n: u32, phase: Phase) -> Kind {
    Kind::Coverage { min: 0, max: 100, n, phase }
}

const SERIES: &[Series] = &[
    // Fig. 8, with both readings of the first update.
    Series {
        name: "paper_first",
        kind: paper(3, Phase::First),
        eps: (1, 5),
        start: PAPER,
        ks: &[0, 1, 2, 4, 5, 8, 9, 13, 20, 21, 37, 40],
    },
    Series {
        name: "paper_last",
        kind: paper(3, Phase::Last),
        eps: (1, 5),
        start: PAPER,
        ks: &[0, 1, 3, 4, 5, 8, 12, 20, 40],
    },
    // Fig. 11.
    Series {
        name: "high_weight",
        kind: paper(13, Phase::First),
        eps: (7, 10),
        start: PAPER,
        ks: &[0, 1, 14, 15, 29, 57, 99, 150],
    },
    // The authors' recorded run.
    Series {
        name: "recorded",
        kind: Kind::Coverage { min: 0, max: 10, n: 5, phase: Phase::First },
        eps: (1, 4),
        start: &[(0, 1), (1, 1), (2, 1), (3, 1), (10, 1)],
        ks: &[0, 1, 6, 7, 60, 121],
    },
    Series {
        name: "three_drones",
        kind: Kind::Coverage { min: -1, max: 2, n: 0, phase: Phase::First },
        eps: (1, 1),
        start: &[(-1, 1), (-1, 4), (2, 1)],
        ks: &[0, 1, 2, 3],
    },
    Series {
        name: "three_drones_last",
        kind: Kind::Coverage { min: -1, max: 2, n: 1, phase: Phase::Last },
        eps: (1, 3),
        start: &[(-1, 1), (-1, 4), (2, 1)],
        ks: &[1, 2, 3, 4, 7],
    },
    // Erratum 11: the approach is not monotonic.
    Series {
        name: "not_monotonic",
        kind: paper(0, Phase::First),
        eps: (1, 5),
        start: &[(0, 1), (10, 1), (11, 1), (24, 1), (100, 1)],
        ks: &[1],
    },
    // Beyond 1/2 drones cross.
    Series {
        name: "crossing",
        kind: Kind::Coverage { min: 0, max: 1, n: 0, phase: Phase::First },
        eps: (3, 5),
        start: &[(0, 1), (1, 10), (9, 10), (1, 1)],
        ks: &[0, 1],
    },
    Series {
        name: "seven_drones",
        kind: Kind::Coverage { min: 0, max: 6, n: 0, phase: Phase::First },
        eps: (1, 2),
        start: &[(0, 1), (1, 7), (2, 7), (3, 7), (4, 7), (5, 7), (6, 1)],
        ks: &[1, 2, 3, 10],
    },
    Series {
        name: "local_first",
        kind: Kind::Local {
            min: 0,
            max: 100,
            ratio: TickRatio { num: 7, den: TWO },
            phase: Phase::First,
        },
        eps: (1, 5),
        start: PAPER,
        ks: &[0, 1, 5, 6, 11, 20],
    },
    Series {
        name: "local_last",
        kind: Kind::Local {
            min: 0,
            max: 100,
            ratio: TickRatio { num: 4, den: ONE },
            phase: Phase::Last,
        },
        eps: (1, 5),
        start: PAPER,
        ks: &[0, 4, 5, 10, 20],
    },
    // Figs 15 and 16.
    Series {
        name: "rendezvous",
        kind: Kind::Consensus,
        eps: (3, 10),
        start: PAPER,
        ks: &[0, 1, 2, 5, 10],
    },
];

fn rational((num, den): Fraction) -> Rational {
    Rational::new(num.into(), den.into())
}

fn rationals(xs: &[Fraction]) -> Vec<Rational> {
    xs.iter().map(|&x| rational(x)).collect()
}

fn params(min: i64, max: i64, eps: Fraction, n: u32) -> Params<Rational> {
    Params { min: rational((min, 1)), max: rational((max, 1)), eps: rational(eps), n }
}

impl Series {
    fn vector(&self, k: u64) -> Vector {
        let (name, start) = (format!("{}_{k}", self.name), rationals(self.start));
        match self.kind {
            Kind::Coverage { min, max, n, phase } => {
                kinds::coverage(&name, &params(min, max, self.eps, n), phase, start, k)
            }
            Kind::Local { min, max, ratio, phase } => {
                kinds::local(&name, &params(min, max, self.eps, 0), ratio, phase, start, k)
            }
            Kind::Consensus => kinds::consensus(&name, &rational(self.eps), start, k),
        }
    }
}

/// Ordered starts on [-1, 8]: the first drones of these, then drone N-1 at 8.
const ORDERED: [Fraction; 6] = [(-1, 1), (1, 2), (2, 3), (3, 1), (7, 2), (27, 4)];
/// Starts that are not ordered, and leave the segment.
const MIXED: [Fraction; 6] = [(-1, 1), (4, 1), (1, 5), (9, 1), (-5, 3), (6, 1)];
const LAST: Fraction = (8, 1);

fn start(of: &[Fraction; 6], count: usize) -> Vec<Rational> {
    of.iter().take(count - 1).chain([&LAST]).map(|&x| rational(x)).collect()
}

/// A star with a loop. (The ring below has a duplicate edge.)
fn star(count: usize) -> Vec<(usize, usize)> {
    (1..count).map(|i| (i, 0)).chain([(1, 1)]).collect()
}

fn ring(count: usize) -> Vec<(usize, usize)> {
    (0..count).map(|i| (i, (i + 1) % count)).chain([(1, 0)]).collect()
}

/// The i-th of scattered numbers: no two nearby ones are equal.
fn scattered(i: usize) -> Rational {
    let i = i64::try_from(i).unwrap_or_default();
    rational((7 * i % 11 - 4, 3))
}

/// Every definition for this many drones.
fn of_count(count: usize) -> Vec<Vector> {
    let p = params(-1, 8, (2, 5), 2);
    let eps = &p.eps;
    let (ordered, mixed) = (start(&ORDERED, count), start(&MIXED, count));
    let mut all = Vec::new();
    for (phase, word) in [(Phase::First, "first"), (Phase::Last, "last")] {
        for k in [1, 3, 7] {
            let name = format!("drones{count}_{word}_{k}");
            all.push(kinds::coverage(&name, &p, phase, mixed.clone(), k));
        }
    }
    for (turn, word) in ["first", "second", "third"].iter().enumerate() {
        let flags = (0..count).map(|i| i % 3 != turn).collect();
        all.push(kinds::active(&format!("rest{count}_{word}"), &p, mixed.clone(), flags));
    }
    let seen = (0..count * count).map(scattered).collect();
    all.push(kinds::delayed(&format!("late{count}"), &p, ordered.clone(), seen));
    for (graph, word) in [(star(count), "star"), (ring(count), "ring")] {
        let name = format!("{word}{count}");
        all.push(kinds::meeting(&format!("meet_{name}"), eps, &graph, mixed.clone(), 2));
        let input = (0..count).map(scattered).collect();
        all.push(kinds::formation(&format!("form_{name}"), eps, &graph, ordered.clone(), input));
    }
    for id in [0, 1, count - 1] {
        let heard = [scattered(0), scattered(1), scattered(2)];
        all.push(kinds::alone(&format!("alone{count}_{id}"), &p, count, heard, id, 6));
    }
    all.push(kinds::quantities(&format!("quantities{count}"), &p, mixed.clone()));
    let after = (0..count).map(scattered).collect();
    all.push(kinds::residual(&format!("residual{count}"), eps, mixed.clone(), after));
    let targets: Vec<_> = (0..count)
        .map(|i| {
            let (i, gaps) = (i64::try_from(i).unwrap_or(0), i64::try_from(count - 1).unwrap_or(1));
            rational((9 * i - gaps, gaps))
        })
        .collect();
    // Slightly behind and before the targets, all in the first gap, and with an end drone elsewhere.
    let moved = |by: Fraction| {
        let last = targets.len() - 1;
        let internal = |(i, x): (usize, &Rational)| {
            if i == 0 || i == last { x.clone() } else { x.clone() + rational(by) }
        };
        targets.iter().enumerate().map(internal).collect::<Vec<_>>()
    };
    let crowd = (0..count).map(|i| {
        let i = i64::try_from(i).unwrap_or(0);
        rational((i - 100, 100))
    });
    let crowd: Vec<_> = crowd.take(count - 1).chain([rational(LAST)]).collect();
    let unanchored = (0..count).map(scattered).collect();
    for (x, word) in [
        (moved((0, 1)), "targets"),
        (moved((-1, 9)), "behind"),
        (moved((1, 9)), "before"),
        (crowd, "crowd"),
        (mixed, "mixed"),
        (unanchored, "loose"),
    ] {
        all.push(kinds::predicates(&format!("{word}{count}"), &p, x));
    }
    // One half, and both sides of the critical weights 1, 2/3, 2 - sqrt 2, 0.5528.., 0.5359..
    for (weight, word) in [
        ((1, 2), "half"),
        ((53, 100), "low"),
        ((55, 100), "five"),
        ((58, 100), "four"),
        ((60, 100), "middle"),
        ((2, 3), "high"),
        ((1, 1), "one"),
        ((0, 1), "zero"),
    ] {
        let (num, den) = (rational((weight.0, 1)), rational((weight.1, 1)));
        all.push(kinds::critical(&format!("critical{count}_{word}"), &num, &den, count));
    }
    all
}

/// The vectors of every definition.
pub(super) fn all() -> Vec<Vector> {
    let runs = SERIES.iter().flat_map(|s| s.ks.iter().map(|&k| s.vector(k)));
    runs.chain((3..=7).flat_map(of_count)).collect()
}
