//! Vectors as Lean guards.

use super::show::phase_name;
use super::{Kind, Vector};
use cordon_core::Rational;

/// What precedes the guards: how the definitions that are proved about are executed.
const HEAD: &str = include_str!("head.lean");

/// The file `lean-mirror/CordonMirror/Vectors.lean`: one guard a vector, so that building the
/// mirror replays them.
pub fn lean(vectors: &[Vector]) -> String {
    let mut text = HEAD.to_owned();
    for v in vectors {
        let (eps, start) = (fraction(&v.eps), list(&v.start));
        let run = match v.kind {
            Kind::Coverage { min, max, n, phase } => {
                let phase = phase_name(phase);
                format!("coverage ({min} / 1) ({max} / 1) ({eps}) {n} Phase.{phase} {start}")
            }
            Kind::Local { min, max, ratio, phase } => {
                let (num, den, phase) = (ratio.num, ratio.den, phase_name(phase));
                format!(
                    "local_swarm ({min} / 1) ({max} / 1) ({eps}) {num} {den} Phase.{phase} {start}"
                )
            }
            Kind::Consensus => format!("consensus ({eps}) {start}"),
        };
        let (name, k, expected) = (&v.name, v.k, list(&v.expected));
        text.push_str(&format!("#guard agree ({run} {k}) {expected} -- {name}\n"));
    }
    text.push_str("\nend CordonMirror.Vectors\n");
    text
}

fn fraction(x: &Rational) -> String {
    format!("{} / {}", x.numer(), x.denom())
}

fn list(xs: &[Rational]) -> String {
    format!("[{}]", xs.iter().map(fraction).collect::<Vec<_>>().join(", "))
}
