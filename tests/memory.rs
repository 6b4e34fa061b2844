//! Peak memory of a jump, as a multiple of its answer. One test in a binary of its own: nothing
//! else allocates meanwhile.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use cordon_core::Rational;
use cordon_run::fast::ntt::Ntt;
use cordon_run::fast::{Line, jump};
use cordon_spec::Params;
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

#[test]
fn a_jump_needs_at_most_six_times_its_answer() {
    // The product of the last squaring is a little longer than 2^20 limbs (2^18 where the build
    // is slow): the length for which the transform is the longest in proportion.
    let k = if cfg!(debug_assertions) { 36_700 } else { 146_500 };
    let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
    let place = |i: i64| if i == 99 { ratio(100, 1) } else { ratio(40 * i, 99) };
    let start: Vec<_> = (0i64..100).map(place).collect();
    let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(1, 5), n: 0 };
    let line = Line::coverage(&p, &start).unwrap();
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let answers = jump::at(&line, &[k], &Ntt).unwrap();
    let peak = (MEMORY.peak_usage() - before) as u64;
    // As fractions: numerators and denominators.
    let answer = answers[0].bits() / 8;
    assert!(answer > 1_000_000 && peak > answer / 2, "answer {answer}, peak {peak} bytes");
    eprintln!("answer {answer} bytes, peak {peak}: {:.2} times", peak as f64 / answer as f64);
    assert!(peak <= 6 * answer, "answer {answer}, peak {peak} bytes");
}
