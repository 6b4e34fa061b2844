//! One exact run for the benchmark against the peers (`benches/peers/run.sh`).
//!
//! `at N K ENGINE`: N drones on \[0, 100\], drone i at 40i/(N-1) and the last at 100, eps = 1/5,
//! K protocol steps. ENGINE is `step`, `jump` (by transforms) or `num-bigint` (a jump by that
//! library). Prints the CPU seconds of the computation (numerators over the common denominator,
//! start to finish) and a hash of the positions that does not depend on their denominators.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::time::Instant;

use cordon_core::Rational;
use cordon_core::scalar::Modulus;
use cordon_run::fast::multiply::{Multiply, NumBigint};
use cordon_run::fast::ntt::Ntt;
use cordon_run::fast::{Answer, Line, jump, step};
use cordon_spec::Params;

/// The prime of the hash: 2^61 - 1.
const HASH_PRIME: u64 = (1 << 61) - 1;

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let [_, count, k, engine] = args.as_slice() else {
        panic!("expected N K ENGINE");
    };
    let (count, k): (i64, u64) = (count.parse().unwrap(), k.parse().unwrap());
    let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
    let place = |i| if i + 1 == count { ratio(100, 1) } else { ratio(40 * i, count - 1) };
    let start: Vec<_> = (0..count).map(place).collect();
    let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(1, 5), n: 0 };
    let (begun, clock) = (cpu_seconds(), Instant::now());
    let line = Line::coverage(&p, &start).unwrap();
    let answers = match backend(engine) {
        Some(by) => jump::at(&line, &[k], by),
        None => step::at(&line, &[k]),
    };
    // The scheduler's count is some milliseconds coarse: short runs go by the clock.
    let (cpu, wall) = (cpu_seconds() - begun, clock.elapsed().as_secs_f64());
    let seconds = if wall < 0.05 { wall } else { cpu };
    let [answer] = answers.unwrap().try_into().unwrap();
    println!("{seconds:.6} {:015x} {}", hash(&answer), answer.bits());
}

/// How long this thread has run (Linux: the first number of schedstat, in nanoseconds).
fn cpu_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap();
    text.split(' ').next().unwrap().parse::<f64>().unwrap() * 1e-9
}

fn backend(engine: &str) -> Option<&'static dyn Multiply> {
    match engine {
        "step" => None,
        "jump" => Some(&Ntt),
        "num-bigint" => Some(&NumBigint),
        other => panic!("engine `{other}`: expected step, jump or num-bigint"),
    }
}

/// The positions as elements of the field of 2^61 - 1 elements, folded.
fn hash(answer: &Answer) -> u64 {
    let p = Modulus::new(HASH_PRIME).unwrap();
    let residues = answer.residues(p).unwrap();
    residues.iter().fold(0, |h, r| {
        let mixed = u128::from(h) * 1_000_003 + u128::from(r.value().unwrap());
        (mixed % u128::from(HASH_PRIME)) as u64
    })
}
