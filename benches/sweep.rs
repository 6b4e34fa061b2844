//! Drone updates a second of the exact sweep: one work item, every start of its grid, every
//! step, hypothesis and conclusion included, on one core. `cargo bench --bench sweep`.
//!
//! The aim is 100 million a second on 64-bit integers.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use cordon::Rational;
use cordon::sweep::Item;
use cordon::sweep::exhaust::{Tally, engine, sweep};
use cordon::sweep::grid::Grid;
use cordon_spec::theorems::{Form, Theorem};
use divan::counter::ItemsCount;

/// A work item in the sharp form, its grid resolution and its last step.
struct Work {
    name: &'static str,
    theorem: Theorem,
    drones: usize,
    eps: (i64, i64),
    resolution: u32,
    steps: usize,
}

impl std::fmt::Display for Work {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

const fn work(
    name: &'static str,
    theorem: Theorem,
    drones: usize,
    eps: (i64, i64),
    resolution: u32,
    steps: usize,
) -> Work {
    Work { name, theorem, drones, eps, resolution, steps }
}

const WORKS: [Work; 9] = [
    work("7.2 N=5 eps=1/3 k<=30, 64 bits", Theorem::Ordering, 5, (1, 3), 36, 30),
    work("7.2 N=7 eps=1/5 k<=20, 64 bits", Theorem::Ordering, 7, (1, 5), 18, 20),
    work("7.3 N=5 eps=1/3 k<=30, 64 bits", Theorem::UpperBound, 5, (1, 3), 32, 30),
    work("7.4i N=5 eps=1/3 k<=30, 64 bits", Theorem::SumBounded, 5, (1, 3), 32, 30),
    work("7.5i N=5 eps=1/3 k<=30, 64 bits", Theorem::SumNonDecreasing, 5, (1, 3), 32, 30),
    work("7.6ii N=5 eps=1/3 k<=30, 64 bits", Theorem::ConstantSum, 5, (1, 3), 32, 30),
    work("7.2 N=5 eps=5/12 k<=30, 64 then 128 bits", Theorem::Ordering, 5, (5, 12), 36, 30),
    work("7.8 N=5 eps=1/2 k<=12, 64 bits", Theorem::Limit, 5, (1, 2), 16, 12),
    work("7.8 N=5 eps=5/12 k<=30, up to 256 bits", Theorem::Limit, 5, (5, 12), 12, 30),
];

fn main() {
    divan::main();
}

#[divan::bench(args = &WORKS, sample_count = 10, sample_size = 1)]
fn drone_updates(bencher: divan::Bencher, work: &Work) {
    let item = Item {
        number: 0,
        theorem: work.theorem,
        form: Form::Sharp,
        drones: work.drones,
        eps: Rational::new(work.eps.0.into(), work.eps.1.into()),
    };
    let starts = work.theorem.hypothesis(Form::Sharp).starts;
    let grid = Grid::new(starts, work.drones, work.resolution).expect("small");
    let run = || -> Tally { sweep(&*engine(&item, work.steps, grid.length), &grid, &[]) };
    let tally = run();
    assert_eq!(tally.counts.violations, 0);
    assert!(tally.counts.non_vacuous > 0);
    bencher.counter(ItemsCount::new(tally.counts.updates)).bench(run);
}
