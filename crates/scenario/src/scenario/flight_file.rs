//! The tables `[flight]` and `[[fault]]` of a scenario file.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use toml::{Spanned, Value};

use super::file::Source;
use super::flight::{Fault, FaultKind, Flight, Parameter, Substitute, UnitName};
use cordon_core::Result;
use cordon_core::exact::{self, Rational};

/// The table `[flight]` as written.
#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields)]
pub(super) struct FlightTable {
    #[serde(rename = "lambda_P", alias = "lambda_p")]
    lambda_p: Option<Spanned<Value>>,
    #[serde(rename = "lambda_A", alias = "lambda_a")]
    lambda_a: Option<Spanned<Value>>,
    integrator: Option<String>,
    master: Option<String>,
    exchange: Option<String>,
    on_loss: Option<String>,
    duration: Option<Spanned<Value>>,
    start: Option<Vec<Spanned<Value>>>,
    z_d: Option<Spanned<Value>>,
    order: Option<String>,
    seed: Option<u64>,
}

/// A table `[[fault]]` as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FaultTable {
    kind: Spanned<String>,
    link: Option<(usize, usize)>,
    probability: Option<Spanned<Value>>,
    ticks: Option<u32>,
    drone: Option<usize>,
    from: Option<Spanned<Value>>,
    until: Option<Spanned<Value>>,
}

/// A table `[[unit]]` as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct UnitTable {
    drone: usize,
    unit: Spanned<String>,
    fmu: PathBuf,
    #[serde(default)]
    names: BTreeMap<String, String>,
    #[serde(default)]
    parameters: BTreeMap<String, Spanned<Value>>,
}

/// The flight that a file describes.
pub(super) fn flight(
    source: &Source<'_>,
    table: FlightTable,
    faults: &[FaultTable],
    units: Vec<UnitTable>,
) -> Result<Flight> {
    let number = |field: &str, value: &Option<Spanned<Value>>| -> Result<Option<Rational>> {
        value.as_ref().map(|v| source.number(field, v)).transpose()
    };
    let start = table.start.as_ref().map(|list| {
        list.iter().map(|v| source.number("flight.start", v)).collect::<Result<Vec<_>>>()
    });
    Ok(Flight {
        lambda_p: number("lambda_P", &table.lambda_p)?,
        lambda_a: number("lambda_A", &table.lambda_a)?,
        duration: number("duration", &table.duration)?,
        z_d: number("z_d", &table.z_d)?,
        start: start.transpose()?,
        integrator: table.integrator,
        master: table.master,
        exchange: table.exchange,
        on_loss: table.on_loss,
        order: table.order,
        seed: table.seed,
        faults: faults.iter().map(|f| fault(source, f)).collect::<Result<_>>()?,
        units: units.into_iter().map(|u| substitute(source, u)).collect::<Result<_>>()?,
    })
}

fn fault(source: &Source<'_>, t: &FaultTable) -> Result<Fault> {
    let at = t.kind.span();
    let name = t.kind.get_ref().as_str();
    let number = |field: &str, value: &Option<Spanned<Value>>| -> Result<Option<Rational>> {
        value.as_ref().map(|v| source.number(field, v)).transpose()
    };
    let wants: &[&str] = match name {
        "loss" => &["link", "probability"],
        "delay" => &["link", "ticks"],
        "drop-out" => &["drone"],
        other => {
            let message =
                format!("fault: `{other}` is unknown: expected `loss`, `delay` or `drop-out`");
            return Err(source.error(&at, &message));
        }
    };
    let given = [
        ("link", t.link.is_some()),
        ("probability", t.probability.is_some()),
        ("ticks", t.ticks.is_some()),
        ("drone", t.drone.is_some()),
    ];
    if let Some((field, _)) = given.iter().find(|(field, is)| *is && !wants.contains(field)) {
        return Err(source.error(&at, &format!("fault: `{field}` is not a field of a `{name}`")));
    }
    let missing = |field: &str| source.error(&at, &format!("fault: {field} is missing"));
    let kind = match name {
        "loss" => FaultKind::Loss {
            link: t.link,
            probability: number("probability", &t.probability)?
                .ok_or_else(|| missing("probability"))?,
        },
        "delay" => {
            FaultKind::Delay { link: t.link, ticks: t.ticks.ok_or_else(|| missing("ticks"))? }
        }
        _ => FaultKind::DropOut { drone: t.drone.ok_or_else(|| missing("drone"))? },
    };
    Ok(Fault { kind, from: number("from", &t.from)?, until: number("until", &t.until)? })
}

/// An FMU's path is relative to the scenario file.
fn substitute(source: &Source<'_>, t: UnitTable) -> Result<Substitute> {
    let name = t.unit.get_ref().as_str();
    let unit = UnitName::ALL.into_iter().find(|u| u.name() == name).ok_or_else(|| {
        let message =
            format!("unit: `{name}` is unknown: expected `coordination`, `control` or `plant`");
        source.error(&t.unit.span(), &message)
    })?;
    let fmu = match Path::new(source.name).parent() {
        Some(folder) => folder.join(t.fmu),
        None => t.fmu,
    };
    let (mut parameters, mut ranges) = (BTreeMap::new(), BTreeMap::new());
    for (name, value) in t.parameters {
        let field = format!("unit.parameters.{name}");
        match value.get_ref() {
            Value::Array(list) => {
                ranges.insert(name, listed(source, &field, value.span(), list)?);
            }
            Value::Table(range) => {
                ranges.insert(name, spread(source, &field, value.span(), range)?);
            }
            Value::Boolean(b) => {
                parameters.insert(name, Parameter::Boolean(*b));
            }
            Value::String(text) => {
                parameters.insert(name, Parameter::Text(text.clone()));
            }
            _ => {
                parameters.insert(name, Parameter::Number(source.number(&field, &value)?));
            }
        }
    }
    Ok(Substitute { drone: t.drone, unit, fmu, names: t.names, parameters, ranges })
}

/// A number inside a list or a table, read exactly.
fn inner(source: &Source<'_>, field: &str, at: &Range<usize>, value: &Value) -> Result<Rational> {
    let text = match value {
        Value::String(text) => text.clone(),
        Value::Integer(_) | Value::Float(_) => value.to_string(),
        _ => return Err(source.error(at, &format!("{field}: expected numbers"))),
    };
    exact::parse(field, &text).map_err(|e| source.error(at, &e.to_string()))
}

/// The values of a list.
fn listed(
    source: &Source<'_>,
    field: &str,
    at: Range<usize>,
    list: &[Value],
) -> Result<Vec<Rational>> {
    if list.is_empty() {
        return Err(source.error(&at, &format!("{field}: expected at least one value")));
    }
    list.iter().map(|value| inner(source, field, &at, value)).collect()
}

/// The values of a range, `{ from = 0, to = 1, runs = 5 }`: that many, equidistant, including both
/// ends.
fn spread(
    source: &Source<'_>,
    field: &str,
    at: Range<usize>,
    range: &toml::Table,
) -> Result<Vec<Rational>> {
    let fail = |what: &str| source.error(&at, &format!("{field}: {what}"));
    if range.keys().any(|key| !["from", "to", "runs"].contains(&key.as_str())) {
        return Err(fail("expected `from`, `to` and `runs`"));
    }
    let end = |key: &str| {
        let value = range.get(key).ok_or_else(|| fail(&format!("{key} is missing")))?;
        inner(source, &format!("{field}.{key}"), &at, value)
    };
    let (from, to) = (end("from")?, end("to")?);
    let runs = range.get("runs").and_then(Value::as_integer);
    let runs = runs.filter(|runs| (2..=MOST_VALUES).contains(runs));
    let Some(runs) = runs else {
        return Err(fail(&format!("runs: expected 2 to {MOST_VALUES}")));
    };
    let step = (&to - &from) / Rational::from_integer((runs - 1).into());
    Ok((0..runs).map(|k| &from + &step * Rational::from_integer(k.into())).collect())
}

/// Most values of a parameter: each run takes milliseconds at least.
const MOST_VALUES: i64 = 10_000;
