//! Traces in the Informal Trace Format of Apalache and Quint.

use std::io::Write;

use serde_json::{Value, json};

use cordon_core::Result;
use cordon_core::exact::Rational;
use cordon_run::scenario::Scenario;
use cordon_run::trace::Row;

use super::page::Page;

/// Writes one ITF object: one state a row, with the variables `step`, `tick`, `timesteps` and
/// `x`, a list of records `{num, den}` (ITF has integers, and no fractions of its own).
///
/// # Errors
/// `out` cannot be written.
pub fn itf(
    scenario: &Scenario,
    rows: &mut dyn Iterator<Item = Row>,
    out: &mut dyn Write,
) -> Result<()> {
    let meta = json!({
        "format": "ITF",
        "format-description": "https://apalache-mc.org/docs/adr/015adr-trace.html",
        "source": scenario.title,
    });
    let mut page = Page::begin(out)?;
    page.field("#meta", &meta)?;
    page.field("params", &json!([]))?;
    page.list("states", rows.enumerate().map(|(i, r)| state(i, &r)))?;
    page.field("vars", &json!(["step", "tick", "timesteps", "x"]))?;
    page.end()
}

fn state(index: usize, r: &Row) -> Value {
    json!({
        "#meta": { "index": index },
        "step": big(r.step),
        "tick": big(r.tick),
        "timesteps": big(r.timesteps),
        "x": r.positions.lowest().iter().map(fraction).collect::<Vec<_>>(),
    })
}

fn fraction(x: &Rational) -> Value {
    json!({ "num": big(x.numer()), "den": big(x.denom()) })
}

fn big(n: impl std::fmt::Display) -> Value {
    json!({ "#bigint": n.to_string() })
}
