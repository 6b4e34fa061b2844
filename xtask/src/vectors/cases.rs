//! Which runs: the shipped scenarios, both phases, ratios that are no integers, small and
//! large weights.

use core::num::NonZeroU32;

use cordon_spec::Phase;
use cordon_spec::local::TickRatio;

use super::{Fraction, Kind, Series};

/// The start of the paper's figures.
const PAPER: &[Fraction] = &[(0, 1), (10, 1), (20, 1), (30, 1), (100, 1)];

const ONE: NonZeroU32 = NonZeroU32::MIN;
const TWO: NonZeroU32 = NonZeroU32::MIN.saturating_add(1);

const fn paper(n: u32, phase: Phase) -> Kind {
    Kind::Coverage { min: 0, max: 100, n, phase }
}

pub(super) const SERIES: &[Series] = &[
    // Fig. 8, both readings of the first update.
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
