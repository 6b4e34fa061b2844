//! Vectors as data: tab-separated values and JSON.

use cordon_spec::Phase;
use serde_json::{Map, json};

use super::{Value, Vector};
use cordon_core::Rational;

/// The columns of [`tsv`].
const COLUMNS: &str = "kind\tname\targuments\texpected\n";

/// Tab-separated values with a heading. An argument is `name=value`; arguments are separated by `; `,
/// members of a list by one space.
pub fn tsv(vectors: &[Vector]) -> String {
    let mut text = COLUMNS.to_owned();
    for v in vectors {
        let arguments: Vec<_> =
            v.arguments.iter().map(|(name, a)| format!("{name}={}", word(a))).collect();
        let row = [v.kind, &v.name, &arguments.join("; "), &spaced(&v.expected)];
        text.push_str(&row.join("\t"));
        text.push('\n');
    }
    text
}

fn word(value: &Value) -> String {
    match value {
        Value::Number(x) => x.to_string(),
        Value::Count(n) => n.to_string(),
        Value::Phase(phase) => phase_name(*phase).to_owned(),
        Value::Numbers(xs) => spaced(xs),
        Value::Edges(edges) => {
            edges.iter().map(|(i, j)| format!("{i}-{j}")).collect::<Vec<_>>().join(" ")
        }
        Value::Flags(flags) => {
            flags.iter().map(|&f| if f { "1" } else { "0" }).collect::<Vec<_>>().join(" ")
        }
    }
}

/// The constructor of a phase, which Rocq and Lean share.
pub(super) fn phase_name(phase: Phase) -> &'static str {
    match phase {
        Phase::First => "First",
        Phase::Last => "Last",
    }
}

fn spaced(xs: &[Rational]) -> String {
    xs.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

fn fractions(xs: &[Rational]) -> Vec<String> {
    xs.iter().map(ToString::to_string).collect()
}

/// JSON, schema `cordon-vectors/2`: numbers as exact fractions in strings.
pub fn json(vectors: &[Vector]) -> String {
    let list: Vec<_> = vectors
        .iter()
        .map(|v| {
            let arguments: Map<_, _> =
                v.arguments.iter().map(|(name, a)| ((*name).to_owned(), plain(a))).collect();
            json!({
                "name": v.name,
                "kind": v.kind,
                "arguments": arguments,
                "expected": fractions(&v.expected),
            })
        })
        .collect();
    format!("{:#}\n", json!({ "schema": "cordon-vectors/2", "vectors": list }))
}

fn plain(value: &Value) -> serde_json::Value {
    match value {
        Value::Number(x) => x.to_string().into(),
        Value::Count(n) => (*n).into(),
        Value::Phase(phase) => phase_name(*phase).to_lowercase().into(),
        Value::Numbers(xs) => fractions(xs).into(),
        Value::Edges(edges) => json!(edges),
        Value::Flags(flags) => flags.clone().into(),
    }
}
