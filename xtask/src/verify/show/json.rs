//! The matrix as JSON, schema `cordon-verify/1`.

use serde_json::{Value, json as value};

use super::described;
use crate::verify::matrix::Matrix;

/// The matrix as JSON.
pub fn json(matrix: &Matrix) -> String {
    let tiers: Vec<Value> = matrix
        .columns
        .iter()
        .map(|column| {
            let cells: Vec<Value> = matrix
                .theorems
                .iter()
                .zip(&column.cells)
                .map(|(theorem, cell)| {
                    let origin = cell
                        .origin()
                        .map(|o| value!({ "date": o.date, "tool": o.tool, "sources": o.sources }));
                    value!({
                        "theorem": theorem.number(),
                        "form": "sharp",
                        "status": cell.status(),
                        "result": cell.result(),
                        "detail": cell.detail(),
                        "seconds": cell.seconds(),
                        "record": origin,
                    })
                })
                .collect();
            let problems: Vec<_> = column.problems.iter().map(described).collect();
            value!({
                "tier": column.name,
                "kind": column.kind.text(),
                "cells": cells,
                "problems": problems,
            })
        })
        .collect();
    let outcome = matrix.outcome().code();
    format!("{:#}\n", value!({ "schema": "cordon-verify/1", "exit": outcome, "tiers": tiers }))
}
