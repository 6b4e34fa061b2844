//! One product for the benchmark against the peers (`benches/peers/run.sh`).
//!
//! `product BITS`: two integers of so many bits by the default transforms. Prints CPU seconds, the
//! best of several.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::time::{Duration, Instant};

use cordon_core::random::SplitMix;
use cordon_run::fast::Multiply;
use cordon_run::fast::ntt::Ntt;

fn main() {
    let bits: usize = std::env::args().nth(1).expect("expected BITS").parse().unwrap();
    let mut random = SplitMix::new(1);
    let mut number =
        || -> Vec<u64> { (0..bits.div_ceil(64)).map(|_| random.below(u64::MAX)).collect() };
    let (a, b) = (number(), number());
    let (mut best, mut rounds, begun) = (f64::MAX, 0, Instant::now());
    while rounds < 5 || begun.elapsed() < Duration::from_millis(300) {
        let before = cpu_seconds();
        std::hint::black_box(Ntt.product(&a, &b));
        best = best.min(cpu_seconds() - before);
        rounds += 1;
    }
    println!("{best:.6}");
}

/// How long this thread has run (Linux: the first number of schedstat, in nanoseconds; the
/// scheduler brings it up to date as it is asked for another thread to run).
fn cpu_seconds() -> f64 {
    std::thread::yield_now();
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap();
    text.split(' ').next().unwrap().parse::<f64>().unwrap() * 1e-9
}
