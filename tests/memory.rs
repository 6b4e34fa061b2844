//! Peak memory of a jump, as a multiple of its answer: what the system had to give the process.
//! One test in a binary of its own: nothing else allocates meanwhile.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use cordon_core::Rational;
use cordon_run::fast::ntt::Ntt;
use cordon_run::fast::{Line, jump};
use cordon_spec::Params;

/// A line of `/proc/self/status`, in bytes.
fn status(name: &str) -> u64 {
    let text = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = text.lines().find_map(|line| line.strip_prefix(name)).unwrap();
    line.trim_matches(|c: char| !c.is_ascii_digit()).parse::<u64>().unwrap() * 1024
}

/// Bytes of the positions after k steps as fractions, and bytes that the process had to be given.
fn answer_and_peak(k: u64) -> (u64, u64) {
    let ratio = |p: i64, q: i64| Rational::new(p.into(), q.into());
    let place = |i: i64| if i == 99 { ratio(100, 1) } else { ratio(40 * i, 99) };
    let start: Vec<_> = (0i64..100).map(place).collect();
    let p = Params { min: ratio(0, 1), max: ratio(100, 1), eps: ratio(1, 5), n: 0 };
    let line = Line::coverage(&p, &start).unwrap();
    let before = status("VmRSS:");
    let answers = jump::at(&line, &[k], &Ntt).unwrap();
    let (answer, peak) = (answers[0].bits() / 8, status("VmHWM:") - before);
    eprintln!("answer {answer} bytes, peak {peak}: {:.2} times", peak as f64 / answer as f64);
    assert!(answer > 1_000_000 && peak > answer, "answer {answer}, peak {peak} bytes");
    (answer, peak)
}

#[test]
fn a_jump_needs_about_four_times_its_answer() {
    if cfg!(debug_assertions) {
        // A shorter one where the build is slow, of whose product there is a copy.
        let (answer, peak) = answer_and_peak(38_000);
        return assert!(peak <= 5 * answer);
    }
    let (answer, peak) = answer_and_peak(100_000);
    assert!(peak <= 4 * answer);
    // A last product a little longer than 3*2^18 digits: the length for which the transform is the
    // longest in proportion.
    let (answer, peak) = answer_and_peak(152_000);
    assert!(10 * peak <= 42 * answer);
}
