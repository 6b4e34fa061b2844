//! Stepping against jumping over a grid of drones, steps and weights (`cargo bench --bench
//! crossover`): microseconds of both, which one the cost model chooses, and how much longer
//! that takes than the better one. The last line is the worst of the grid.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::time::{Duration, Instant};

use cordon_core::Rational;
use cordon_run::fast::ntt::Ntt;
use cordon_run::fast::{Answer, Line, engine, jump, step};
use cordon_spec::Params;

const COUNTS: [i64; 6] = [3, 10, 40, 150, 500, 2000];
const STEPS: [u64; 7] = [1, 5, 20, 70, 300, 1000, 4000];
const WEIGHTS: [(i64, i64); 3] =
    [(1, 5), (123_457, 987_655), (123_456_789_012_345_678, 987_654_321_098_765_433)];

/// Runs of more limbs than this are left out: they take minutes.
const MOST_LIMBS: u64 = 400_000_000;

/// How long a cell is repeated.
const ENOUGH: Duration = Duration::from_millis(40);

fn main() {
    println!("{:>6} {:>6}  {:<6} {:>12} {:>12}  chosen  times", "N", "k", "eps", "step", "jump");
    let (mut worst, mut cells) = (0f64, 0);
    for (p, q) in WEIGHTS {
        for count in COUNTS {
            for k in STEPS {
                let line = line(count, (p, q));
                let limbs = (line.numerator_bits(k) / 64 + 1) * k * count as u64;
                if limbs > MOST_LIMBS {
                    continue;
                }
                let stepping = microseconds(|| step::at(&line, &[k]).unwrap());
                let jumping = microseconds(|| jump::at(&line, &[k], &Ntt).unwrap());
                let jumps = engine::jump_is_faster(&line, k, [k]);
                let (name, chosen) = if jumps { ("jump", jumping) } else { ("step", stepping) };
                let times = chosen / stepping.min(jumping);
                let bits = format!("{}b", line.side.bits());
                println!(
                    "{count:>6} {k:>6}  {bits:<6} {stepping:>12.1} {jumping:>12.1}  {name}  {times:.2}"
                );
                worst = worst.max(times);
                cells += 1;
            }
        }
    }
    println!("{cells} cells; the choice takes at most {worst:.2} times the better engine");
}

fn line(count: i64, (p, q): (i64, i64)) -> Line {
    let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
    let place = |i| if i + 1 == count { ratio(100, 1) } else { ratio(40 * i, count - 1) };
    let start: Vec<_> = (0..count).map(place).collect();
    let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(p, q), n: 0 };
    Line::coverage(&p, &start).unwrap()
}

/// The least of several runs, by the clock: others that run meanwhile only make some longer.
fn microseconds(run: impl Fn() -> Vec<Answer>) -> f64 {
    let (mut least, mut runs, begun) = (f64::MAX, 0, Instant::now());
    while runs < 3 || begun.elapsed() < ENOUGH {
        let start = Instant::now();
        std::hint::black_box(run());
        least = least.min(start.elapsed().as_secs_f64());
        runs += 1;
    }
    least * 1e6
}
