//! Checking and searching certificates.
//!
//! Figures to reach: checking all committed certificates in less than 1 s and 100 MB; searching
//! them anew in less than 60 s; checking a contraction for N = 1,000 in less than 1 s.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::collections::BTreeSet;
use std::fs;
use std::time::Instant;

use cordon_core::Rational;
use cordon_proof::prove::{CLAIMS, Claim, Scope};
use cordon_proof::sweep::Item;
use cordon_proof::sweep::exhaust::{Exhaust, Trial};
use cordon_proof::sweep::grid::Grid;
use cordon_spec::theorems::{Form, Theorem};
use divan::AllocProfiler;

#[global_allocator]
static ALLOC: AllocProfiler = AllocProfiler::system();

fn main() {
    divan::main();
    if !std::env::args().any(|a| a == "--list" || a == "--test") {
        compare_with_sweep();
    }
}

/// 7.2 for every N, k and eps, by its certificate, against 7.2 on a grid: N <= 7, eps = p/q with
/// q <= 12, k <= 30, starts on 24 units.
fn compare_with_sweep() {
    let begin = Instant::now();
    let mut updates = 0;
    for drones in 3..=7 {
        let weights: BTreeSet<Rational> = (1..=12)
            .flat_map(|q| (0..=q).map(move |p| Rational::new(p.into(), q.into())))
            .filter(|eps| drones == 3 || *eps <= Rational::new(1.into(), 2.into()))
            .collect();
        let starts = Theorem::Ordering.hypothesis(Form::Sharp).starts;
        let grid = Grid::new(starts, drones, 24).expect("small");
        for eps in weights {
            let item =
                Item { number: 0, theorem: Theorem::Ordering, form: Form::Sharp, drones, eps };
            let engine = Exhaust::new(&item, 30, grid.length);
            let mut trial = Trial::new(&engine, Grid::mirrored(item.theorem, starts));
            trial.sweep(&grid, &grid.whole());
            let tally = trial.end();
            assert_eq!(tally.counts.violations, 0);
            updates += tally.counts.updates;
        }
    }
    let swept = begin.elapsed();
    let begin = Instant::now();
    for _ in 0..100 {
        assert_eq!(check_ordering_for_every_n(), 0);
    }
    let checked = begin.elapsed() / 100;
    println!(
        "7.2 swept (N <= 7, q <= 12, k <= 30, {updates} drone updates, one core): {swept:?}; \
         its certificate (every N, k and eps) checked: {checked:?}; ratio {:.0}",
        swept.as_secs_f64() / checked.as_secs_f64()
    );
}

fn committed() -> Vec<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/proofs/certificates");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    files.iter().map(|f| fs::read_to_string(f).unwrap()).collect()
}

/// The time of one certificate, for the ratio to the bounded sweep of 7.2 (benches/sweep.rs).
#[divan::bench]
fn check_ordering_for_every_n() -> u8 {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/proofs/certificates/7.2-sharp.json");
    cordon_check::check(&fs::read_to_string(file).unwrap()).code()
}

#[divan::bench]
fn check_all_committed(bencher: divan::Bencher<'_, '_>) {
    let texts = committed();
    bencher.bench(|| texts.iter().map(|t| cordon_check::check(t).code()).max());
}

/// w_i = i(N-1-i) at eps = 1/2, where the rate is 1 - 4/(N-1)^2.
#[divan::bench(args = [100, 1_000, 10_000])]
fn check_contraction(bencher: divan::Bencher<'_, '_>, drones: u64) {
    let last = drones - 1;
    let vector: Vec<String> = (1..last).map(|i| format!("\"{}\"", i * (last - i))).collect();
    let square = u128::from(last) * u128::from(last);
    let (mut num, mut den) = (square - 4, square);
    while num % 2 == 0 && den % 2 == 0 {
        (num, den) = (num / 2, den / 2);
    }
    let text = format!(
        "{{\"schema\": \"cordon-certificate/2\", \"certificate\": {{\"contraction\": {{\"drones\": {drones}, \
         \"eps\": \"1/2\", \"rate\": \"{num}/{den}\", \"vector\": [{}]}}}}}}",
        vector.join(",")
    );
    assert_eq!(cordon_check::check(&text).code(), 0, "{}", cordon_check::check(&text));
    bencher.bench(|| cordon_check::check(&text).code());
}

fn search(claim: &Claim) -> usize {
    let scope = Scope { form: Form::Sharp, weights: None, drones: None };
    claim.prove(&scope).unwrap().to_string().len()
}

#[divan::bench(sample_count = 1, sample_size = 1)]
fn search_all_anew() -> usize {
    CLAIMS.iter().map(search).sum()
}

#[divan::bench(args = ["7.2", "7.5i", "7.7", "7.8"], sample_count = 10)]
fn search_one(name: &str) -> usize {
    search(CLAIMS.iter().find(|c| c.name == name).unwrap())
}
