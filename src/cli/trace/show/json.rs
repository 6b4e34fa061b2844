//! Traces as JSON, schema `cordon-trace/1`.

use std::io::Write;

use cordon_spec::Phase;
use cordon_spec::theorems::Verdict;
use serde_json::{Value, json};

use cordon_core::exact;
use cordon_core::{Evidence, Result};
use cordon_run::scenario::{Protocol, Scenario};
use cordon_run::trace::{Checked, Row, Trace};

/// Writes one object: the scenario, the rows (fractions and decimals), the checks.
///
/// # Errors
/// `out` cannot be written.
pub fn json(
    trace: &Trace<'_>,
    checks: &[Checked],
    digits: usize,
    out: &mut dyn Write,
) -> Result<()> {
    let rows: Vec<_> = trace.rows.iter().map(|r| row(trace, r, digits)).collect();
    let checks: Vec<_> = checks.iter().map(checked).collect();
    let page = json!({
        "schema": "cordon-trace/1",
        "scenario": scenario(trace.scenario),
        "rows": rows,
        "checks": checks,
    });
    writeln!(out, "{page:#}")?;
    Ok(())
}

fn scenario(s: &Scenario) -> Value {
    let segment = match &s.protocol {
        Protocol::Coverage { min, max } => json!([min.to_string(), max.to_string()]),
        _ => Value::Null,
    };
    json!({
        "title": s.title,
        "protocol": s.protocol.name(),
        "segment": segment,
        "start": s.start.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "weight": s.weight.to_string(),
        "period": s.period,
        "phase": match s.phase { Phase::First => "first", Phase::Last => "last" },
        "tau": s.tau.as_ref().map(ToString::to_string),
    })
}

fn row(trace: &Trace<'_>, r: &Row, digits: usize) -> Value {
    json!({
        "step": r.step,
        "tick": r.tick,
        "timesteps": r.timesteps,
        "time": trace.time(r).map(|t| t.to_string()),
        "positions": r.positions.iter().map(exact::fraction).collect::<Vec<_>>(),
        "decimals": r.positions.iter().map(|x| exact::decimal_string(x, digits)).collect::<Vec<_>>(),
    })
}

fn checked(c: &Checked) -> Value {
    let steps = |wanted: fn(&Verdict) -> bool| c.verdicts.values().filter(|v| wanted(v)).count();
    json!({
        "theorem": c.theorem.number(),
        "form": c.form.label(),
        "weight_in_range": c.weight_in_range,
        "evidence": Evidence::ThisRunOnly,
        "steps": c.verdicts.len(),
        "met": c.met(),
        "vacuous": steps(|v| *v == Verdict::Vacuous),
        "violated": steps(|v| matches!(v, Verdict::Violated(_))),
        "first_violation": c.first_violation.as_ref().map(|(step, what)| json!({ "step": step, "what": what })),
    })
}
