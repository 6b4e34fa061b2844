//! The fast engines (`cargo bench --bench fast`). `benches/peers/run.sh` compares with others.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use cordon_core::Rational;
use cordon_run::fast::multiply::{Multiply, NumBigint};
use cordon_run::fast::ntt::Ntt;
use cordon_run::fast::{Answer, Line, digits, jump, step};
use cordon_run::swarm::Swarm;
use cordon_spec::Params;
use divan::{Bencher, black_box};

/// Reports peak memory too.
#[global_allocator]
static MEMORY: divan::AllocProfiler = divan::AllocProfiler::system();

fn main() {
    divan::main();
}

fn ratio(p: i64, q: i64) -> Rational {
    Rational::new(p.into(), q.into())
}

/// N drones on \[0, 100\], drone i at 40i/(N-1), the last at 100, eps = 1/5.
fn line(count: i64) -> Line {
    let place = |i| if i + 1 == count { ratio(100, 1) } else { ratio(40 * i, count - 1) };
    let start: Vec<_> = (0..count).map(place).collect();
    let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(1, 5), n: 0 };
    Line::coverage(&p, &start).unwrap()
}

const WORK: [(i64, u64); 5] =
    [(20, 1000), (20, 10_000), (100, 1000), (100, 10_000), (100, 100_000)];

#[divan::bench(args = WORK, sample_count = 5)]
fn jump_over_transforms((count, k): (i64, u64)) -> Vec<Answer> {
    jump::at(&line(count), &[k], &Ntt).unwrap()
}

#[divan::bench(args = &WORK[..4], sample_count = 5)]
fn jump_over_num_bigint((count, k): (i64, u64)) -> Vec<Answer> {
    jump::at(&line(count), &[k], &NumBigint).unwrap()
}

#[divan::bench(args = &WORK[..4], sample_count = 5)]
fn stepping((count, k): (i64, u64)) -> Vec<Answer> {
    step::at(&line(count), &[k]).unwrap()
}

#[divan::bench(args = [20, 200], sample_count = 5)]
fn certain_digits_after_a_trillion_steps(places: usize) -> Vec<digits::Digits> {
    digits::at(&line(100), &[1_000_000_000_000], places, &Ntt).unwrap()
}

#[divan::bench(args = [1000, 10_000, 100_000, 1_000_000], sample_count = 3)]
fn squares_by_transforms(bencher: Bencher, limbs: u64) {
    bencher.with_inputs(|| number(limbs)).bench_values(|x| Ntt.square(black_box(x)));
}

#[divan::bench(args = [1000, 10_000, 100_000], sample_count = 3)]
fn squares_by_num_bigint(bencher: Bencher, limbs: u64) {
    bencher.with_inputs(|| number(limbs)).bench_values(|x| NumBigint.square(black_box(x)));
}

fn number(limbs: u64) -> Vec<u64> {
    (1..=limbs).map(|i| i.wrapping_mul(0x9e37_79b9_7f4a_7c15)).collect()
}

/// A million drones: drone updates a second are the items.
#[divan::bench(sample_count = 3)]
fn swarm_of_a_million_100_steps(bencher: Bencher) {
    let [min, max, to] = [0, 100, 40].map(|x| ratio(x, 1));
    let swarm = Swarm::spread(&ratio(1, 5), 1_000_000, [&min, &max, &to]).unwrap();
    bencher
        .counter(divan::counter::ItemsCount::new(100_000_000u64))
        .with_inputs(|| swarm.clone())
        .bench_values(|mut s| {
            s.advance(100);
            s
        });
}
