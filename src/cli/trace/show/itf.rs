//! Traces in the Informal Trace Format of Apalache and Quint.

use std::io::Write;

use serde_json::{Value, json};

use cordon_core::Result;
use cordon_core::exact::Rational;
use cordon_run::scenario::Scenario;
use cordon_run::trace::Row;

use super::page::Page;

/// Writes one ITF object: one state per row, with the variables `step`, `tick`, `timesteps` and `x`, a
/// list of records `{num, den}` (ITF has integers but no fractions); for a protocol file a list for
/// every state variable of an agent.
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
    let own = scenario.own().map(|own| own.system.variables.iter().map(|v| v.name.as_str()));
    let names: Vec<&str> = own.map_or_else(|| vec!["x"], Iterator::collect);
    let mut page = Page::begin(out)?;
    page.field("#meta", &meta)?;
    page.field("params", &json!([]))?;
    page.list("states", rows.enumerate().map(|(i, r)| state(&names, i, &r)))?;
    let vars: Vec<&str> = ["step", "tick", "timesteps"].into_iter().chain(names).collect();
    page.field("vars", &json!(vars))?;
    page.end()
}

fn state(names: &[&str], index: usize, r: &Row) -> Value {
    let mut state = json!({
        "#meta": { "index": index },
        "step": big(r.step),
        "tick": big(r.tick),
        "timesteps": big(r.timesteps),
    });
    let numbers = r.positions.lowest();
    for (v, name) in names.iter().enumerate() {
        let of_all = numbers.iter().skip(v).step_by(names.len()).map(fraction);
        state[*name] = of_all.collect();
    }
    state
}

fn fraction(x: &Rational) -> Value {
    json!({ "num": big(x.numer()), "den": big(x.denom()) })
}

fn big(n: impl std::fmt::Display) -> Value {
    json!({ "#bigint": n.to_string() })
}
