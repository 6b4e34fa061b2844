//! Errors about the co-simulated runs: the desired positions, tick by tick.

use cordon_spec::Phase;
use cordon_spec::Scalar;
use num_traits::Signed;

use super::{Erratum, Recomputed, recomputed};
use cordon_core::exact::{Rational, decimal_string};
use cordon_run::scenario::{Protocol, Scenario, Topology};
use cordon_run::simulate;

pub(super) const ERRATA: &[Erratum] = &[
    Erratum {
        number: 4,
        place: "section 6, Fig. 11",
        printed: "eps = 0.7: the desired position of drone 3 after eps is very close to 100",
        compute: drone_three_after_one_update,
    },
    Erratum {
        number: 5,
        place: "section 6, Fig. 10",
        printed: "the system does not converge for high values of eps (0.1, 0.3, 0.5 are shown)",
        compute: half_converges_fastest,
    },
    Erratum {
        number: 6,
        place: "section 6, Fig. 8",
        printed: "the desired positions converge to the target positions after four seconds",
        compute: error_after_four_seconds,
    },
    Erratum {
        number: 7,
        place: "section 6, Fig. 15",
        printed: "after 10 seconds all drones had the desired coordinate of 32",
        compute: consensus_after_ten_seconds,
    },
];

/// Ticks per second at the paper's co-simulation step of 0.05 s.
const TICKS_PER_SECOND: u64 = 20;

/// The start of the paper's runs, in m: 0, 10, 20, 30, 100.
pub(super) fn paper_start() -> Vec<Rational> {
    [0, 10, 20, 30, 100].map(Rational::from_int).to_vec()
}

/// The paper's coverage scenario with weight eps = tenths/10 and the period that the paper couples to
/// it: eps seconds, in ticks of 0.05 s.
fn coverage(tenths: i32) -> Scenario {
    scenario(
        Protocol::Coverage { min: Rational::from_int(0), max: Rational::from_int(100) },
        tenths,
    )
}

fn scenario(protocol: Protocol, tenths: i32) -> Scenario {
    Scenario {
        title: String::new(),
        protocol,
        start: paper_start(),
        weight: Rational::new(tenths.into(), 10.into()),
        period: 2 * tenths.unsigned_abs(),
        phase: Phase::First,
        tau: Some(Rational::new(1.into(), 20.into())),
        steps: 0,
    }
}

/// The desired positions after some seconds.
fn at_second(scenario: &Scenario, second: u64) -> Vec<Rational> {
    let ticks = second * TICKS_PER_SECOND;
    simulate::run(scenario).find(|s| s.tick == ticks).map_or_else(Vec::new, |s| s.state.drones)
}

/// The largest distance from the given positions.
fn farthest(x: &[Rational], places: impl Fn(usize) -> Rational) -> Rational {
    let distances = x.iter().enumerate().map(|(i, xi)| (xi - places(i)).abs());
    distances.max().unwrap_or_default()
}

fn drone_three_after_one_update() -> Recomputed {
    let positions = at_second(&coverage(7), 0);
    let after = simulate::run(&coverage(7)).find(|s| s.step == 1);
    let x3 = after.and_then(|s| s.state.drones.get(3).cloned()).unwrap_or_default();
    let far = Rational::from_int(100) - &x3 > Rational::from_int(10);
    let from = positions.get(3).cloned().unwrap_or_default();
    recomputed(far, format!("the first update takes drone 3 from {from} to {x3}"))
}

fn half_converges_fastest() -> Recomputed {
    let centre = |tenths| at_second(&coverage(tenths), 8).get(2).cloned().unwrap_or_default();
    let [slow, middle, fast] = [1, 3, 5].map(centre);
    let target = Rational::from_int(50);
    let distance = |x: &Rational| (x - &target).abs();
    let fastest = distance(&fast) < distance(&middle) && distance(&middle) < distance(&slow);
    recomputed(
        fastest,
        format!(
            "at 8 s the centre drone's desired position is {}, {}, {} for eps = 0.1, 0.3, 0.5: the highest is nearest to 50",
            decimal_string(&slow, 2),
            decimal_string(&middle, 2),
            decimal_string(&fast, 2)
        ),
    )
}

fn error_after_four_seconds() -> Recomputed {
    let target = |i: usize| Rational::from_int(25) * Rational::from_index(i);
    let error = farthest(&at_second(&coverage(2), 4), target);
    let visible = error > Rational::from_int(1);
    recomputed(
        visible,
        format!("eps = 0.2: at 4 s the largest error is {}", decimal_string(&error, 2)),
    )
}

fn consensus_after_ten_seconds() -> Recomputed {
    let graph = Topology::Path(paper_start().len());
    let x = at_second(&scenario(Protocol::Consensus { graph }, 3), 10);
    let off = farthest(&x, |_| Rational::from_int(32));
    let shown: Vec<_> = x.iter().map(|xi| decimal_string(xi, 2)).collect();
    recomputed(
        off > Rational::new(1.into(), 10.into()),
        format!("at 10 s they are {}: within {} of 32", shown.join(", "), decimal_string(&off, 2)),
    )
}
