//! Vectors as data: tab-separated values and JSON.

use cordon_spec::Phase;
use cordon_spec::local::TickRatio;
use serde_json::{Value, json};

use super::{Kind, Vector};
use cordon_core::Rational;

/// The columns of [`tsv`].
const COLUMNS: &str = "kind\tname\tdrones\tmin\tmax\teps\tn\tphase\tstart\tk\texpected\n";

/// Tab-separated values with a heading; lists are separated by spaces, what a kind does not
/// have is `-`. Column `n` holds the counter limit, or the quotient eps/stepsize of a local run.
pub fn tsv(vectors: &[Vector]) -> String {
    let mut text = COLUMNS.to_owned();
    for v in vectors {
        let (min, max, n, phase) = columns(v.kind);
        let row = [
            v.kind.name().to_owned(),
            v.name.clone(),
            v.start.len().to_string(),
            min,
            max,
            v.eps.to_string(),
            n,
            phase.to_owned(),
            spaced(&v.start),
            v.k.to_string(),
            spaced(&v.expected),
        ];
        text.push_str(&row.join("\t"));
        text.push('\n');
    }
    text
}

fn columns(kind: Kind) -> (String, String, String, &'static str) {
    let none = || "-".to_owned();
    match kind {
        Kind::Coverage { min, max, n, phase } => {
            (min.to_string(), max.to_string(), n.to_string(), phase_name(phase))
        }
        Kind::Local { min, max, ratio, phase } => {
            (min.to_string(), max.to_string(), quotient(ratio), phase_name(phase))
        }
        Kind::Consensus => (none(), none(), none(), "-"),
    }
}

fn quotient(ratio: TickRatio) -> String {
    Rational::new(ratio.num.into(), ratio.den.get().into()).to_string()
}

/// The constructor of a phase in Rocq and Lean, too.
pub(super) fn phase_name(phase: Phase) -> &'static str {
    match phase {
        Phase::First => "First",
        Phase::Last => "Last",
    }
}

fn spaced(xs: &[Rational]) -> String {
    xs.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// JSON, schema `cordon-vectors/1`: numbers as exact fractions in strings.
pub fn json(vectors: &[Vector]) -> String {
    let fractions = |xs: &[Rational]| xs.iter().map(ToString::to_string).collect::<Vec<_>>();
    let list: Vec<Value> = vectors
        .iter()
        .map(|v| {
            let mut entry = json!({
                "name": v.name,
                "kind": v.kind.name(),
                "eps": v.eps.to_string(),
                "start": fractions(&v.start),
                "k": v.k,
                "expected": fractions(&v.expected),
            });
            let (min, max, n, phase) = columns(v.kind);
            match v.kind {
                Kind::Coverage { .. } | Kind::Local { .. } => {
                    let limit = if matches!(v.kind, Kind::Local { .. }) { "ratio" } else { "n" };
                    entry["min"] = min.into();
                    entry["max"] = max.into();
                    entry[limit] = n.into();
                    entry["phase"] = phase.to_lowercase().into();
                }
                Kind::Consensus => entry["graph"] = "path".into(),
            }
            entry
        })
        .collect();
    format!("{:#}\n", json!({ "schema": "cordon-vectors/1", "vectors": list }))
}
