//! Vectors as Rocq examples.

use super::show::phase_name;
use super::{Value, Vector};
use cordon_core::Rational;

/// The preamble: how the definitions that the proofs are about are executed.
const HEAD: &str = include_str!("head.v");

/// The file `proofs/rocq/theories/Vectors.v`: one example per vector, proved by computation.
pub fn rocq(vectors: &[Vector]) -> String {
    let mut text = HEAD.to_owned();
    for v in vectors {
        let arguments: String = v.arguments.iter().map(|(_, a)| format!(" {}", term(a))).collect();
        let (kind, name, expected) = (v.kind, &v.name, numbers(&v.expected));
        text.push_str(&format!(
            "Example {name} : {kind}{arguments} = {expected}. Proof. vm_compute. reflexivity. Qed.\n"
        ));
    }
    text
}

fn term(value: &Value) -> String {
    match value {
        Value::Number(x) => format!("({})", fraction(x)),
        Value::Count(n) => n.to_string(),
        Value::Phase(phase) => phase_name(*phase).to_owned(),
        Value::Numbers(xs) => numbers(xs),
        Value::Edges(edges) => {
            let pairs = edges.iter().map(|(i, j)| format!("({i}, {j})"));
            format!("[{}]%nat", pairs.collect::<Vec<_>>().join("; "))
        }
        Value::Flags(flags) => {
            format!("[{}]", flags.iter().map(bool::to_string).collect::<Vec<_>>().join("; "))
        }
    }
}

fn fraction(x: &Rational) -> String {
    format!("{} # {}", x.numer(), x.denom())
}

fn numbers(xs: &[Rational]) -> String {
    format!("[{}]", xs.iter().map(fraction).collect::<Vec<_>>().join("; "))
}
