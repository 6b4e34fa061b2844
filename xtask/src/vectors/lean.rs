//! Vectors as Lean guards.

use super::show::phase_name;
use super::{Value, Vector};
use cordon_core::Rational;

/// The preamble: how the definitions that the proofs are about are executed.
const HEAD: &str = include_str!("head.lean");

/// The file `lean-mirror/CordonMirror/Vectors.lean`: one guard per vector, so that building the mirror
/// replays them.
pub fn lean(vectors: &[Vector]) -> String {
    let mut text = HEAD.to_owned();
    for v in vectors {
        let arguments: String = v.arguments.iter().map(|(_, a)| format!(" {}", term(a))).collect();
        // `local` is a reserved word in Lean.
        let kind = if v.kind == "local" { "local_swarm" } else { v.kind };
        let (name, expected) = (&v.name, numbers(&v.expected));
        text.push_str(&format!("#guard agree ({kind}{arguments}) {expected} -- {name}\n"));
    }
    text.push_str("\nend CordonMirror.Vectors\n");
    text
}

fn term(value: &Value) -> String {
    match value {
        Value::Number(x) => format!("({})", fraction(x)),
        Value::Count(n) => n.to_string(),
        Value::Phase(phase) => format!("Phase.{}", phase_name(*phase)),
        Value::Numbers(xs) => numbers(xs),
        Value::Edges(edges) => {
            let pairs = edges.iter().map(|(i, j)| format!("({i}, {j})"));
            format!("[{}]", pairs.collect::<Vec<_>>().join(", "))
        }
        Value::Flags(flags) => {
            format!("[{}]", flags.iter().map(bool::to_string).collect::<Vec<_>>().join(", "))
        }
    }
}

fn fraction(x: &Rational) -> String {
    format!("{} / {}", x.numer(), x.denom())
}

fn numbers(xs: &[Rational]) -> String {
    format!("[{}]", xs.iter().map(fraction).collect::<Vec<_>>().join(", "))
}
