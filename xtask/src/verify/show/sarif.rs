//! For CI: SARIF 2.1.0. A result is something to look at: a refutation or rejection (error), a
//! stale record or an inconclusive run (warning), a tier that was not run (note).

use serde_json::{Value, json};

use super::described;
use crate::verify::matrix::{Cell, Matrix};
use cordon_core::theorems;

/// The matrix as SARIF.
pub fn sarif(matrix: &Matrix) -> String {
    let rules: Vec<Value> = matrix
        .theorems
        .iter()
        .map(|t| {
            let words = theorems::words(*t);
            json!({
                "id": t.number(),
                "name": words.name,
                "shortDescription": { "text": words.sharp },
            })
        })
        .chain([json!({
            "id": "certificate",
            "name": "certificates about no theorem",
            "shortDescription": { "text": "every committed certificate is accepted" },
        })])
        .collect();
    let mut results = Vec::new();
    for column in &matrix.columns {
        for (theorem, cell) in matrix.theorems.iter().zip(&column.cells) {
            if let Some(level) = level(cell) {
                let message = format!(
                    "{} ({}): {}{}: {}",
                    column.name,
                    column.kind.text(),
                    cell.status(),
                    cell.result().map(|r| format!(", {r}")).unwrap_or_default(),
                    cell.detail()
                );
                results.push(result(theorem.number(), level, &message));
            }
        }
        for problem in &column.problems {
            let message = format!("{}: {}", column.name, described(problem));
            results.push(result("certificate", "error", &message));
        }
    }
    let driver = json!({
        "name": "cordon",
        "version": env!("CARGO_PKG_VERSION"),
        "rules": rules,
    });
    let page = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{ "tool": { "driver": driver }, "results": results }],
    });
    format!("{page:#}\n")
}

fn level(cell: &Cell) -> Option<&'static str> {
    match (cell, cell.result()) {
        (_, Some("refuted" | "rejected")) => Some("error"),
        (_, Some("inconclusive")) | (Cell::Stale { .. }, _) => Some("warning"),
        (Cell::NotRun(_), _) => Some("note"),
        _ => None,
    }
}

fn result(rule: &str, level: &str, message: &str) -> Value {
    // The statement of a theorem stands in the spec.
    let location = json!({
        "physicalLocation": { "artifactLocation": { "uri": "spec/src/theorems/mod.rs" } },
    });
    json!({
        "ruleId": rule,
        "level": level,
        "message": { "text": message },
        "locations": [location],
    })
}
