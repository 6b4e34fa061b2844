//! Drone updates a second of the exact sweep: one work item, every start of its grid, every
//! step, hypothesis and conclusion included, on one core. `cargo bench --bench sweep`.
//!
//! The aim is 2 billion a second on 32-bit integers, 1 billion on 64-bit ones.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use cordon_core::Rational;
use cordon_proof::sweep::exhaust::{Exhaust, Tally, Trial};
use cordon_proof::sweep::grid::Grid;
use cordon_proof::sweep::run::{Progress, run};
use cordon_proof::sweep::{Config, Item, StartSpace, WeightSet};
use cordon_spec::theorems::{Form, Theorem};
use divan::counter::ItemsCount;

/// A work item in the sharp form: its name, theorem, number of drones, weight p/q, the grid's
/// resolution and the last step.
struct Work(&'static str, Theorem, usize, (i64, i64), u32, usize);

impl std::fmt::Display for Work {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.0)
    }
}

const WORKS: [Work; 9] = [
    Work("7.2 N=5 eps=1/3 k<=30, 64 bits", Theorem::Ordering, 5, (1, 3), 36, 30),
    Work("7.2 N=7 eps=1/5 k<=20, 64 bits", Theorem::Ordering, 7, (1, 5), 18, 20),
    Work("7.3 N=5 eps=1/3 k<=30, 64 bits", Theorem::UpperBound, 5, (1, 3), 32, 30),
    Work("7.4i N=5 eps=1/3 k<=30, 64 bits", Theorem::SumBounded, 5, (1, 3), 32, 30),
    Work("7.5i N=5 eps=1/3 k<=30, 64 bits", Theorem::SumNonDecreasing, 5, (1, 3), 32, 30),
    Work("7.6ii N=5 eps=1/3 k<=30, 64 bits", Theorem::ConstantSum, 5, (1, 3), 32, 30),
    Work("7.2 N=5 eps=5/12 k<=30, 64 then 128 bits", Theorem::Ordering, 5, (5, 12), 36, 30),
    Work("7.8 N=5 eps=1/2 k<=12, 64 bits", Theorem::Limit, 5, (1, 2), 16, 12),
    Work("7.8 N=5 eps=5/12 k<=30, up to 256 bits", Theorem::Limit, 5, (5, 12), 12, 30),
];

fn main() {
    divan::main();
}

#[divan::bench(args = &WORKS, sample_count = 10, sample_size = 1)]
fn drone_updates(bencher: divan::Bencher, work: &Work) {
    let Work(_, theorem, drones, (p, q), resolution, steps) = *work;
    let eps = Rational::new(p.into(), q.into());
    let item = Item { number: 0, theorem, form: Form::Sharp, drones, eps };
    let starts = theorem.hypothesis(Form::Sharp).starts;
    let grid = Grid::new(starts, drones, resolution).expect("small");
    let engine = Exhaust::new(&item, steps, grid.length);
    let run = || -> Tally {
        let mut trial = Trial::new(&engine, Grid::mirrored(theorem, starts));
        trial.sweep(&grid, &grid.whole());
        trial.end()
    };
    let tally = run();
    assert_eq!(tally.counts.violations, 0);
    assert!(tally.counts.non_vacuous > 0);
    bencher.counter(ItemsCount::new(tally.counts.updates)).bench(run);
}

/// The whole engine on all cores, as `cordon sweep` runs it: several work items, pieces, sums.
#[divan::bench(sample_count = 5, sample_size = 1)]
fn all_cores(bencher: divan::Bencher) {
    let weights = WeightSet::List(
        [(1, 5), (1, 3), (2, 5)]
            .map(|(p, q): (i32, i32)| Rational::new(p.into(), q.into()))
            .to_vec(),
    );
    let theorems = [Theorem::Ordering, Theorem::SumBounded];
    let starts = StartSpace::Grid { resolution: 24 };
    let config = Config::new(&theorems, &[Form::Sharp], [5, 7], weights, 20, starts);
    let items = config.items().expect("valid");
    let whole = || -> u64 {
        let mut updates = 0;
        run(&config, &items, 0, &Progress::default(), |finding| {
            assert_eq!(finding.counts.violations, 0);
            updates += finding.counts.updates;
            Ok(())
        })
        .expect("runs");
        updates
    };
    bencher.counter(ItemsCount::new(whole())).bench(whole);
}
