//! Co-simulation in process: `cargo bench --bench cosim`.
#![allow(missing_docs, clippy::unwrap_used)]

use cordon_core::Rational;
use cordon_cosim::cosimulation::Cosimulation;
use cordon_cosim::{exact_run, run};
use cordon_run::scenario::{Draft, Flight, Start};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn fraction(num: i64, den: i64) -> Rational {
    Rational::new(num.into(), den.into())
}

fn swarm(drones: usize, seconds: i64, integrator: &str) -> Cosimulation {
    let draft = Draft {
        drones: Some(drones),
        start: Some(Start::SpreadTo(fraction(40, 1))),
        max: Some(fraction(100, 1)),
        weight: Some(fraction(1, 5)),
        period: Some(4),
        tau: Some(fraction(1, 20)),
        ..Draft::default()
    };
    let flight = Flight {
        duration: Some(fraction(seconds, 1)),
        integrator: Some(integrator.to_owned()),
        ..Flight::default()
    };
    Cosimulation::new(draft.finish().unwrap(), flight).unwrap()
}

/// 15 units, 501 grid points. Wanted: under 5 ms.
#[divan::bench(args = ["euler", "exact"])]
fn five_drones_25_s(bencher: Bencher<'_, '_>, integrator: &str) {
    let swarm = swarm(5, 25, integrator);
    bencher.bench_local(|| run::run(black_box(&swarm)).unwrap());
}

/// The same in exact arithmetic, and the comparison.
#[divan::bench(sample_count = 10)]
fn five_drones_25_s_exactly(bencher: Bencher<'_, '_>) {
    let swarm = swarm(5, 25, "euler");
    let record = run::run(&swarm).unwrap();
    bencher.bench_local(|| exact_run::difference(black_box(&swarm), &record).unwrap());
}

/// 3,000 units, 2,001 grid points. Wanted: under 2 s.
#[divan::bench(sample_count = 3, sample_size = 1)]
fn thousand_drones_100_s(bencher: Bencher<'_, '_>) {
    let swarm = swarm(1000, 100, "euler");
    bencher.bench_local(|| run::run(black_box(&swarm)).unwrap());
}
