//! Vectors as Rocq examples.

use super::show::phase_name;
use super::{Kind, Vector};
use cordon_core::Rational;

/// What precedes the examples: how the definitions that are proved about are executed.
const HEAD: &str = include_str!("head.v");

/// The file `proofs/rocq/theories/Vectors.v`: one example a vector, proved by computation.
pub fn rocq(vectors: &[Vector]) -> String {
    let mut text = HEAD.to_owned();
    for v in vectors {
        let (eps, start) = (parenthesised(&v.eps), list(&v.start));
        let run = match v.kind {
            Kind::Coverage { min, max, n, phase } => {
                let phase = phase_name(phase);
                format!("coverage ({min} # 1) ({max} # 1) {eps} {n} {phase} {start}")
            }
            Kind::Local { min, max, ratio, phase } => {
                let (num, den, phase) = (ratio.num, ratio.den, phase_name(phase));
                format!("local ({min} # 1) ({max} # 1) {eps} {num} {den} {phase} {start}")
            }
            Kind::Consensus => format!("consensus {eps} {start}"),
        };
        let (name, k, expected) = (&v.name, v.k, list(&v.expected));
        text.push_str(&format!(
            "Example {name} : {run} {k} = {expected}. Proof. vm_compute. reflexivity. Qed.\n"
        ));
    }
    text
}

fn fraction(x: &Rational) -> String {
    format!("{} # {}", x.numer(), x.denom())
}

fn parenthesised(x: &Rational) -> String {
    format!("({})", fraction(x))
}

fn list(xs: &[Rational]) -> String {
    format!("[{}]", xs.iter().map(fraction).collect::<Vec<_>>().join("; "))
}
