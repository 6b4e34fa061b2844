//! Scenario files (TOML).

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use cordon_spec::Phase;
use serde::Deserialize;
use toml::{Spanned, Value};

use super::document::{document, written};
use super::draft::names_file;
use super::flight_file::{self, FaultTable, FlightTable, UnitTable};
use super::{Draft, Places, Start};
use cordon_core::exact::{self, Rational};
use cordon_core::files::Limit;
use cordon_core::{Error, Result};

/// A scenario file as written. Numbers keep their location, so that they can be read exactly from the
/// text (`0.2` is 1/5) and errors can point at them.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    title: Option<String>,
    protocol: Option<String>,
    min: Option<Spanned<Value>>,
    max: Option<Spanned<Value>>,
    drones: Option<usize>,
    start: Option<Vec<Spanned<Value>>>,
    spread_to: Option<Spanned<Value>>,
    eps: Option<Spanned<Value>>,
    weight: Option<Spanned<Value>>,
    period: Option<u32>,
    phase: Option<Spanned<String>>,
    tau: Option<Spanned<Value>>,
    steps: Option<u64>,
    graph: Option<Spanned<Value>>,
    displacement: Option<Vec<Spanned<Value>>>,
    #[serde(default)]
    parameters: BTreeMap<String, Spanned<Value>>,
    #[serde(default)]
    flight: FlightTable,
    #[serde(default)]
    fault: Vec<FaultTable>,
    #[serde(default)]
    unit: Vec<UnitTable>,
}

/// Reads a scenario file.
///
/// # Errors
/// The file cannot be read, is not TOML, has an unknown key or a value of the wrong type: the message
/// has file, line and column.
pub fn read(path: &Path) -> Result<Draft> {
    parse(&path.display().to_string(), &written(path, Limit::SCENARIO)?)
}

/// Whether the text is a protocol file.
fn is_protocol(text: &str) -> bool {
    let table = text.parse::<toml::Table>().unwrap_or_default();
    ["agents", "claims", "rules"].iter().any(|key| table.contains_key(*key))
}

fn no_scenario(name: &str) -> Error {
    Error::input(format!(
        "{name}: a protocol file: expected a scenario, or --protocol {name} where the command has it"
    ))
}

/// Reads a scenario from text; `name` stands for the file in messages.
///
/// # Errors
/// As [`read`], except for reading.
pub fn parse(name: &str, text: &str) -> Result<Draft> {
    let source = Source { name, text };
    let (doc, places): (Document, Places) =
        document(&source).map_err(|e| if is_protocol(text) { no_scenario(name) } else { e })?;
    let number = |field: &str, value: Option<Spanned<Value>>| {
        value.map(|v| source.number(field, &v)).transpose()
    };
    let numbers = |field: &str, list: Option<Vec<Spanned<Value>>>| {
        list.map(|l| l.iter().map(|v| source.number(field, v)).collect::<Result<Vec<_>>>())
            .transpose()
    };
    if let (Some(_), Some(to)) = (&doc.start, &doc.spread_to) {
        return Err(source.error(&to.span(), "start and spread_to: expected one of them"));
    }
    let spread_to = number("spread_to", doc.spread_to)?.map(Start::SpreadTo);
    let start = numbers("start", doc.start)?.map(Start::Listed).or(spread_to);
    // Two names of the same field.
    if let (Some(_), Some(weight)) = (&doc.eps, &doc.weight) {
        return Err(source.error(&weight.span(), "eps and weight: expected one of them"));
    }
    let parameter = |(name, value): (String, Spanned<Value>)| {
        let value = source.number(&format!("parameters.{name}"), &value)?;
        Ok((name, value))
    };
    let (graph, edges) = match doc.graph {
        None => (None, None),
        Some(value) => source.graph(&value)?,
    };
    Ok(Draft {
        title: doc.title,
        protocol: doc.protocol.map(|p| beside(name, p)),
        protocol_text: None,
        min: number("min", doc.min)?,
        max: number("max", doc.max)?,
        drones: doc.drones,
        start,
        weight: number("weight", doc.weight)?.or(number("eps", doc.eps)?),
        period: doc.period,
        phase: doc.phase.map(|p| source.phase(&p)).transpose()?,
        tau: number("tau", doc.tau)?,
        steps: doc.steps,
        graph,
        edges,
        displacement: numbers("displacement", doc.displacement)?,
        parameters: doc.parameters.into_iter().map(parameter).collect::<Result<_>>()?,
        choices: None,
        flight: flight_file::flight(&source, doc.flight, &doc.fault, doc.unit)?,
        places,
    })
}

/// A protocol file's path is relative to the scenario file.
fn beside(scenario: &str, protocol: String) -> String {
    match Path::new(scenario).parent() {
        Some(folder) if names_file(&protocol) => folder.join(&protocol).display().to_string(),
        _ => protocol,
    }
}

/// The file's name and text, for errors that point into it.
pub struct Source<'t> {
    /// The file's name, as messages give it.
    pub name: &'t str,
    /// All of its text.
    pub text: &'t str,
}

/// A graph by name, or by its edges.
pub type GraphFields = (Option<String>, Option<Vec<(usize, usize)>>);

impl Source<'_> {
    /// An error located in the text, by line and column.
    pub fn error(&self, at: &Range<usize>, message: &str) -> Error {
        let (line, column) = self.place(at.start);
        Error::input(format!("{}:{line}:{column}: {message}", self.name))
    }

    /// Line and column of a byte of the text, counted from 1.
    pub(super) fn place(&self, at: usize) -> (usize, usize) {
        let before = self.text.get(..at).unwrap_or_default();
        let line = before.matches('\n').count() + 1;
        (line, before.rsplit('\n').next().unwrap_or_default().chars().count() + 1)
    }

    /// A number in the file, read exactly: an integer, a decimal or a fraction in quotes.
    ///
    /// # Errors
    /// It is not a number.
    pub fn number(&self, field: &str, value: &Spanned<Value>) -> Result<Rational> {
        let written = match value.get_ref() {
            Value::String(s) => s.clone(),
            Value::Integer(n) => n.to_string(),
            // The digits as written, before they became a double.
            Value::Float(_) => self.text.get(value.span()).unwrap_or_default().replace('_', ""),
            other => {
                let message = format!("{field}: expected a number, found {}", other.type_str());
                return Err(self.error(&value.span(), &message));
            }
        };
        exact::parse(field, &written).map_err(|e| self.error(&value.span(), &e.to_string()))
    }

    fn phase(&self, value: &Spanned<String>) -> Result<Phase> {
        match value.get_ref().as_str() {
            "first" => Ok(Phase::First),
            "last" => Ok(Phase::Last),
            other => {
                let message = format!("phase: `{other}`: expected `first` or `last`");
                Err(self.error(&value.span(), &message))
            }
        }
    }

    /// A graph: its name, or its edges.
    ///
    /// # Errors
    /// It is neither.
    pub fn graph(&self, value: &Spanned<Value>) -> Result<GraphFields> {
        let fail = || self.error(&value.span(), "graph: expected a name or a list of pairs");
        match value.get_ref() {
            Value::String(name) => Ok((Some(name.clone()), None)),
            Value::Array(pairs) => {
                let index = |v: &Value| v.as_integer().and_then(|n| usize::try_from(n).ok());
                let pair = |v: &Value| match v.as_array().map(Vec::as_slice) {
                    Some([a, b]) => index(a).zip(index(b)),
                    _ => None,
                };
                let edges: Option<Vec<_>> = pairs.iter().map(pair).collect();
                Ok((None, Some(edges.ok_or_else(fail)?)))
            }
            _ => Err(fail()),
        }
    }
}
