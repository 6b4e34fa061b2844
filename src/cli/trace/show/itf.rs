//! Traces in the Informal Trace Format of Apalache and Quint.

use std::io::Write;

use serde_json::{Value, json};

use cordon_core::Result;
use cordon_core::exact::Rational;
use cordon_run::trace::{Row, Trace};

/// Writes one ITF object: one state a row, with the variables `step`, `tick`, `timesteps` and
/// `x`, a list of records `{num, den}` (ITF has integers, and no fractions of its own).
///
/// # Errors
/// `out` cannot be written.
pub fn itf(trace: &Trace<'_>, out: &mut dyn Write) -> Result<()> {
    let states: Vec<_> = trace.rows.iter().enumerate().map(|(i, r)| state(i, r)).collect();
    let page = json!({
        "#meta": {
            "format": "ITF",
            "format-description": "https://apalache-mc.org/docs/adr/015adr-trace.html",
            "source": trace.scenario.title,
        },
        "params": [],
        "vars": ["step", "tick", "timesteps", "x"],
        "states": states,
    });
    writeln!(out, "{page:#}")?;
    Ok(())
}

fn state(index: usize, r: &Row) -> Value {
    json!({
        "#meta": { "index": index },
        "step": big(r.step),
        "tick": big(r.tick),
        "timesteps": big(r.timesteps),
        "x": r.positions.iter().map(fraction).collect::<Vec<_>>(),
    })
}

fn fraction(x: &Rational) -> Value {
    json!({ "num": big(x.numer()), "den": big(x.denom()) })
}

fn big(n: impl std::fmt::Display) -> Value {
    json!({ "#bigint": n.to_string() })
}
