//! Stepping against jumping over a grid of drones, steps and weights (`cargo bench --bench
//! crossover`): microseconds of both, and of the engine `jump`, which steps where the cost model
//! expects that to be faster; how much longer it takes than the better one. The last line is the
//! worst of the grid, but for differences of a microsecond or two.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::time::{Duration, Instant};

use cordon_core::Rational;
use cordon_run::fast::ntt::Ntt;
use cordon_run::fast::{Answer, Engine, Line, engine, jump, step};
use cordon_spec::Params;

const COUNTS: [i64; 6] = [3, 10, 40, 150, 500, 2000];
const STEPS: [u64; 7] = [1, 5, 20, 70, 300, 1000, 4000];
const WEIGHTS: [(i64, i64); 3] =
    [(1, 5), (123_457, 987_655), (123_456_789_012_345_678, 987_654_321_098_765_433)];

/// Runs of more limbs than this are left out: they take minutes.
const MOST_LIMBS: u64 = 400_000_000;

/// Microseconds that planning may cost, which no one sees.
const UNSEEN: f64 = 2.0;

/// How long a cell is repeated.
const ENOUGH: Duration = Duration::from_millis(150);

fn main() {
    println!(
        "{:>6} {:>6}  {:<6} {:>12} {:>12} {:>12}  times",
        "N", "k", "eps", "every step", "no step", "jump"
    );
    let (mut worst, mut cells) = (0f64, 0);
    for (p, q) in WEIGHTS {
        for count in COUNTS {
            for k in STEPS {
                let line = line(count, (p, q));
                let limbs = (line.numerator_bits(k) / 64 + 1) * k * count as u64;
                if limbs > MOST_LIMBS {
                    continue;
                }
                let [stepping, jumping, chosen] = microseconds([
                    &|| step::at(&line, &[k]).unwrap(),
                    &|| jump::at(&line, &[k], &Ntt).unwrap(),
                    &|| engine::positions(&line, &[k], Engine::Jump).unwrap(),
                ]);
                let better = stepping.min(jumping);
                let times = chosen / better;
                let bits = format!("{}b", line.side.bits());
                println!(
                    "{count:>6} {k:>6}  {bits:<6} {stepping:>12.1} {jumping:>12.1} {chosen:>12.1}  {times:.2}"
                );
                if chosen > better + UNSEEN {
                    worst = worst.max(times);
                }
                cells += 1;
            }
        }
    }
    println!("{cells} cells; `jump` takes at most {worst:.2} times the better of both");
}

fn line(count: i64, (p, q): (i64, i64)) -> Line {
    let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
    let place = |i| if i + 1 == count { ratio(100, 1) } else { ratio(40 * i, count - 1) };
    let start: Vec<_> = (0..count).map(place).collect();
    let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(p, q), n: 0 };
    Line::coverage(&p, &start).unwrap()
}

/// The least of several runs of each: others that run meanwhile only make some longer.
fn microseconds<const T: usize>(runs: [&dyn Fn() -> Vec<Answer>; T]) -> [f64; T] {
    let (mut least, mut rounds, begun) = ([f64::MAX; T], 0, Instant::now());
    while rounds < 4 || begun.elapsed() < ENOUGH {
        for (least, run) in least.iter_mut().zip(runs) {
            let (cpu, clock) = (cpu_seconds(), Instant::now());
            std::hint::black_box(run());
            // Asking the scheduler takes some microseconds: short runs go by the clock.
            let (wall, cpu) = (clock.elapsed().as_secs_f64(), cpu_seconds() - cpu);
            *least = least.min(if wall < 0.0005 { wall } else { cpu });
        }
        rounds += 1;
    }
    least.map(|seconds| seconds * 1e6)
}

/// How long this thread has run (Linux: the first number of schedstat, in nanoseconds; the
/// scheduler brings it up to date as it is asked for another thread to run).
fn cpu_seconds() -> f64 {
    std::thread::yield_now();
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap();
    text.split(' ').next().unwrap().parse::<f64>().unwrap() * 1e-9
}
