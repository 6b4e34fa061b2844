//! A theorem's violation in words: the one wording, for traces, sweeps and refutations.

use cordon_spec::placement::{scaled_energy, scaled_target, sum};
use cordon_spec::theorems::{Subject, Violation};

use crate::Rational;
use crate::text::cut;

/// Longest number shown, in characters: a longer one helps no reader, and the run has it.
const LONGEST: usize = 200;

fn shown(x: &Rational) -> String {
    cut(&x.to_string(), LONGEST)
}

/// The violation in words, with exact values: `at step 3 drones 1 and 2: ...`. `run` begins with
/// the placement of `step`, the step that the violated conclusion is about.
pub fn in_words(
    [min, max]: [&Rational; 2],
    run: &[Vec<Rational>],
    step: u64,
    violation: Violation,
) -> String {
    let at = step + violation.step as u64;
    let Some(x) = run.get(violation.step) else {
        return format!("at step {at}");
    };
    let position = |i: usize| x.get(i).map_or_else(String::new, shown);
    match violation.subject {
        Subject::Pair(i) => {
            let j = i + 1;
            let (a, b) = (position(i), position(j));
            format!("at step {at} drones {i} and {j}: X_{i} = {a} is not below X_{j} = {b}")
        }
        Subject::Drone(i) => {
            let gaps = Rational::from_integer((x.len().max(2) - 1).into());
            let target = shown(&(scaled_target(min, max, x.len(), i) / gaps));
            format!("at step {at} drone {i}: X_{i} = {}, target T_{i} = {target}", position(i))
        }
        Subject::Sum => {
            let value = |(h, x): (usize, &Vec<Rational>)| {
                format!("c^{} = {}", step + h as u64, shown(&sum(x)))
            };
            let sums: Vec<_> = run.iter().enumerate().map(value).collect();
            format!("at step {at} the sum of the positions: {}", sums.join(", "))
        }
        Subject::Energy => {
            let energy = |x: &[Rational]| shown(&scaled_energy(min, max, x));
            let values: Vec<_> = run.iter().take(2).map(|x| energy(x)).collect();
            format!(
                "at step {at} the sum of the squared errors, times (N-1)^2, does not fall: {}",
                values.join(", then ")
            )
        }
    }
}
