//! Traces as JSON, schema `cordon-trace/1`.

use std::io::Write;

use cordon_spec::Phase;
use cordon_spec::theorems::Verdict;
use serde_json::{Value, json};

use cordon_core::exact;
use cordon_core::{Evidence, Result};
use cordon_run::fast::verify::Verification;
use cordon_run::scenario::{Protocol, Scenario};
use cordon_run::trace::{Checked, CheckedClaim, Row};

use super::page::Page;
use crate::cli::trace::Checks;

/// Writes one object: the scenario, the rows (fractions and decimals), the checks.
///
/// # Errors
/// `out` cannot be written.
pub fn json(
    of: &Scenario,
    rows: &mut dyn Iterator<Item = Row>,
    checks: Checks<'_>,
    digits: usize,
    out: &mut dyn Write,
) -> Result<()> {
    let mut page = Page::begin(out)?;
    page.field("checks", &checks.along.iter().map(checked).collect())?;
    if of.own().is_some() {
        page.field("claims", &checks.claims.iter().map(claim).collect())?;
    }
    page.list("rows", rows.map(|r| row(of, &r, digits)))?;
    page.field("scenario", &scenario(of))?;
    page.field("schema", &json!("cordon-trace/1"))?;
    if let Some(verification) = checks.verified {
        page.field("verified", &verified(verification))?;
    }
    page.end()
}

fn scenario(s: &Scenario) -> Value {
    let segment = match &s.protocol {
        Protocol::Coverage { min, max } => json!([min.to_string(), max.to_string()]),
        _ => Value::Null,
    };
    let mut page = json!({
        "title": s.title,
        "protocol": s.protocol.name(),
        "segment": segment,
        "start": s.start.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "weight": s.weight.to_string(),
        "period": s.period,
        "phase": match s.phase { Phase::First => "first", Phase::Last => "last" },
        "tau": s.tau.as_ref().map(ToString::to_string),
    });
    if let Some(own) = s.own() {
        let values = own.values().map(|(p, value)| (p.name.clone(), json!(exact::fraction(value))));
        page["choices"] = json!(own.choices());
        page["parameters"] = Value::Object(values.collect());
        page["state"] = json!(own.columns());
        page["weight"] = Value::Null;
    }
    page
}

fn row(scenario: &Scenario, r: &Row, digits: usize) -> Value {
    json!({
        "step": r.step,
        "tick": r.tick,
        "timesteps": r.timesteps,
        "time": scenario.time(r.tick).map(|t| t.to_string()),
        "positions": r.positions.lowest().iter().map(exact::fraction).collect::<Vec<_>>(),
        "decimals": r.positions.decimals(digits),
    })
}

/// The check of the positions against the plain spec modulo random primes.
fn verified(v: &Verification) -> Value {
    json!({
        "agrees": v.disagreement.is_none(),
        "compared": v.compared,
        "log2_chance_of_missing": v.log2_chance,
        // Larger than the integers that every JSON reader supports.
        "primes": v.primes.iter().map(u64::to_string).collect::<Vec<_>>(),
        "seed": v.seed.to_string(),
    })
}

fn claim(c: &CheckedClaim) -> Value {
    json!({
        "claim": c.text,
        "evidence": Evidence::ThisRunOnly,
        "steps": c.holds.len(),
        "violated": c.holds.values().filter(|holds| !**holds).count(),
        "first_violation": c.first_violation.as_ref().map(|(step, what)| json!({ "step": step, "what": what })),
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
