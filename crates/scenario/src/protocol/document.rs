//! A protocol file as written.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

use serde::Deserialize;
use toml::{Spanned, Value};

use super::claims::Claims;
use super::links::{Links, Topology};
use crate::scenario::file::Source;
use cordon_core::system::{
    Convergence, MOST_VARIABLES, Parameter, ParameterKind, Switching, Variable,
};
use cordon_core::{Error, Rational, Result, range};

/// The keys of a protocol file.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Document {
    pub format: Option<Spanned<String>>,
    pub title: Option<String>,
    pub time: Option<Spanned<String>>,
    pub agents: Option<Spanned<Value>>,
    pub state: Option<Spanned<Value>>,
    pub topology: Option<Spanned<Value>>,
    pub start: Option<Vec<Spanned<String>>>,
    #[serde(default)]
    pub claims: Vec<Spanned<Value>>,
    pub converges: Option<Spanned<String>>,
    pub target: Option<Spanned<Value>>,
    pub switching: Option<Spanned<Vec<Spanned<String>>>>,
    pub every: Option<Spanned<Value>>,
    pub dwell: Option<Spanned<Value>>,
    #[serde(default)]
    pub parameters: BTreeMap<Spanned<String>, Spanned<Value>>,
    pub rules: Option<Spanned<RuleTable>>,
    #[serde(default)]
    pub modes: BTreeMap<Spanned<String>, RuleTable>,
    #[serde(default)]
    pub departures: Departures,
}

/// Rules by class of agents.
pub(super) type RuleTable = BTreeMap<Spanned<String>, Spanned<Value>>;

/// How runs may depart from the rules.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Departures {
    /// Any agents keep their state in a step.
    pub skip: Option<Spanned<bool>>,
    /// Any links fail in a step.
    pub loss: Option<Spanned<String>>,
    /// A message is up to so many steps old.
    pub delay: Option<Spanned<usize>>,
}

/// How many agents a file speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agents {
    /// So many.
    Exactly(usize),
    /// So many, or any number above.
    From(usize),
}

impl Departures {
    /// Whether any agents may keep their state in a step.
    pub fn skips(&self) -> bool {
        self.skip.as_ref().is_some_and(|skip| *skip.get_ref())
    }
}

impl Agents {
    /// The smallest number.
    pub fn fewest(self) -> usize {
        match self {
            Self::Exactly(n) | Self::From(n) => n,
        }
    }

    /// Whether the file speaks of `count` agents.
    pub fn allow(self, count: usize) -> bool {
        match self {
            Self::Exactly(n) => count == n,
            Self::From(n) => (n..=MOST_VARIABLES).contains(&count),
        }
    }
}

impl fmt::Display for Agents {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exactly(n) => write!(f, "{n}"),
            Self::From(n) => write!(f, "{n} to {MOST_VARIABLES}"),
        }
    }
}

/// What keys were called before `cordon-protocol/1`, and what stands in their place.
const FORMER: [(&str, &str); 7] = [
    ("drones", "`agents = 5`, or `agents = \"3..\"` for every number"),
    ("eps", "`eps = \"0..1/2\"` under `[parameters]`"),
    ("graph", "`topology`"),
    ("weight", "`all = \"x + eps*sum(their.x - x)\"` under `[rules]`"),
    ("weights", "a rule an agent under `[rules]`"),
    ("claim", "`claims`"),
    ("update", "`[rules]`, with the agent's number as key"),
];

/// An error of reading, where it is about a former key, with the key in its place.
pub(super) fn with_present_keys(error: Error) -> Error {
    let Error::Input(message) = &error else { return error };
    let former = FORMER.iter().find_map(|(key, now)| {
        let (place, _) = message.split_once(&format!("unknown field `{key}`"))?;
        Some(format!("{place}{key}: is no longer a key: expected {now}"))
    });
    former.map_or(error, Error::input)
}

/// Words that mean something in rules and claims, so that nothing else may be called so.
const RESERVED: [&str; 9] = ["sum", "prev", "next", "their", "weight", "N", "i", "k", "last"];

/// Most steps that a message may be old.
const LONGEST_DELAY: usize = 10;

impl Document {
    /// Refuses files of another format.
    pub fn refuse_other_formats(&self, source: &Source<'_>) -> Result<()> {
        match &self.format {
            Some(format) if format.get_ref() != "cordon-protocol/1" => {
                let message =
                    format!("format: `{}`: expected `cordon-protocol/1`", format.get_ref());
                Err(source.error(&format.span(), &message))
            }
            _ => Ok(()),
        }
    }

    /// Whether rules are derivatives. What is about steps does not go with that, nor the other way round.
    pub fn is_continuous(&self, source: &Source<'_>) -> Result<bool> {
        let refuse = |place: Range<usize>, message: &str| Err(source.error(&place, message));
        let continuous = match self.time.as_ref().map(|t| (t.get_ref().as_str(), t.span())) {
            None | Some(("steps", _)) => false,
            Some(("continuous", _)) => true,
            Some((other, place)) => {
                let message = format!("time: `{other}`: expected `steps` or `continuous`");
                return refuse(place, &message);
            }
        };
        let departures = &self.departures;
        if continuous {
            if let Some(loss) = &departures.loss {
                return refuse(loss.span(), "departures.loss: expected none in continuous time");
            }
            if let Some(delay) = &departures.delay {
                return refuse(delay.span(), "departures.delay: expected none in continuous time");
            }
            if let Some(skip) = departures.skip.as_ref().filter(|skip| *skip.get_ref()) {
                return refuse(skip.span(), "departures.skip: expected none in continuous time");
            }
        } else if let Some(key) = self.every.as_ref().or(self.dwell.as_ref()) {
            return refuse(
                key.span(),
                "expected `time = \"continuous\"` with a time between switches",
            );
        }
        Ok(continuous)
    }

    /// In continuous time, when modes change.
    pub fn flow_switching(&self, source: &Source<'_>) -> Result<Switching> {
        let time = |field: &str, value: &Spanned<Value>| {
            let time = source.number(field, value)?;
            if time > Rational::default() {
                return Ok(time);
            }
            let message = format!("{field}: `{time}`: expected a time above 0");
            Err(source.error(&value.span(), &message))
        };
        match (&self.every, &self.dwell, &self.switching) {
            (None, None, None) => Ok(Switching::Any),
            (None, Some(dwell), None) => time("dwell", dwell).map(Switching::Dwell),
            (Some(every), None, Some(_)) => time("every", every).map(Switching::Every),
            (Some(every), None, None) => {
                Err(source
                    .error(&every.span(), "every: expected `switching` too: the modes in turn"))
            }
            (None, _, Some(list)) => Err(source
                .error(&list.span(), "switching: expected `every` too: how long each mode acts")),
            (Some(every), Some(_), _) => {
                Err(source.error(&every.span(), "every: expected `every` or `dwell`"))
            }
        }
    }

    /// Where the number of agents stands.
    pub fn agents_place(&self) -> Range<usize> {
        self.agents.as_ref().map_or(0..0, Spanned::span)
    }

    pub fn agents(&self, source: &Source<'_>) -> Result<Agents> {
        let Some(value) = &self.agents else {
            return Err(Error::input(format!(
                "{}: agents: is missing: expected their number, or `\"3..\"` for every number from 3 on",
                source.name
            )));
        };
        let fail = |given: &str| {
            let message = format!(
                "agents: `{given}`: expected a number from 1 to {MOST_VARIABLES}, or `\"3..\"` for \
                 every number from 3 on"
            );
            source.error(&value.span(), &message)
        };
        let within = |n: usize| (1..=MOST_VARIABLES).contains(&n);
        match value.get_ref() {
            Value::Integer(n) => usize::try_from(*n)
                .ok()
                .filter(|&n| within(n))
                .map(Agents::Exactly)
                .ok_or_else(|| fail(&n.to_string())),
            Value::String(text) => {
                let number = |t: &str| t.trim().parse().ok().filter(|&n| within(n));
                let read = match text.strip_suffix("..") {
                    Some(from) => number(from).map(Agents::From),
                    None => number(text).map(Agents::Exactly),
                };
                read.ok_or_else(|| fail(text))
            }
            other => Err(fail(&other.to_string())),
        }
    }

    /// The state variables of an agent.
    pub fn variables(&self, source: &Source<'_>) -> Result<Vec<Variable>> {
        let Some(value) = &self.state else {
            return Ok(vec![Variable { name: "x".to_owned(), unit: None }]);
        };
        let fail = |message: &str| source.error(&value.span(), &format!("state: {message}"));
        let texts: Vec<(String, Option<String>)> = match value.get_ref() {
            Value::String(text) => {
                text.split(',').map(|name| (name.trim().to_owned(), None)).collect()
            }
            Value::Array(list) => list
                .iter()
                .map(|v| Some((v.as_str()?.to_owned(), None)))
                .collect::<Option<_>>()
                .ok_or_else(|| fail("expected names in quotes"))?,
            Value::Table(table) => {
                let written = source.text.get(value.span()).unwrap_or_default();
                let mut pairs: Vec<(String, Option<String>)> = table
                    .iter()
                    .map(|(name, unit)| Some((name.clone(), Some(unit.as_str()?.to_owned()))))
                    .collect::<Option<_>>()
                    .ok_or_else(|| fail("expected units in quotes, like `{ x = \"m\" }`"))?;
                // In the order in which they are written, which the table does not keep.
                pairs.sort_by_key(|(name, _)| key_place(written, name));
                pairs
            }
            _ => return Err(fail("expected a name, a list of names, or names with units")),
        };
        let mut variables: Vec<Variable> = Vec::new();
        for (name, unit) in texts {
            let letters = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphabetic());
            if !letters || name.len() > 20 || RESERVED.contains(&name.as_str()) {
                return Err(fail(&format!(
                    "`{name}`: expected a name of letters, none of {}",
                    RESERVED.join(", ")
                )));
            }
            if variables.iter().any(|v| v.name == name) {
                return Err(fail(&format!("`{name}`: occurs twice")));
            }
            variables.push(Variable { name, unit });
        }
        if variables.is_empty() { Err(fail("expected at least one name")) } else { Ok(variables) }
    }

    /// The parameters that the file names.
    pub fn parameters(
        &self,
        source: &Source<'_>,
        variables: &[Variable],
    ) -> Result<Vec<Parameter>> {
        let parameter = |(key, value): (&Spanned<String>, &Spanned<Value>)| {
            let name = key.get_ref();
            let field = format!("parameters.{name}");
            let fail = |e: &str| source.error(&value.span(), &format!("{field}: {e}"));
            let sound = name.starts_with(|c: char| c.is_ascii_alphabetic())
                && name.chars().all(|c| c.is_ascii_alphanumeric())
                && name.len() <= 20
                && !RESERVED.contains(&name.as_str());
            let is_state = |v: &Variable| {
                name.strip_prefix(&v.name).is_some_and(|n| n.chars().all(|c| c.is_ascii_digit()))
            };
            // Names that departures give to what they bring.
            let is_brought = ["acts", "link", "late"].iter().any(|w| {
                name.strip_prefix(w).is_some_and(|n| n.starts_with(|c: char| c.is_ascii_digit()))
            }) || name.contains("ago");
            if !sound || is_brought || variables.iter().any(is_state) {
                let message = format!(
                    "{field}: expected a name of letters and digits, no state variable and none of {}",
                    RESERVED.join(", ")
                );
                return Err(source.error(&key.span(), &message));
            }
            let (range, kind) = match value.get_ref() {
                Value::String(text) => (text.clone(), ParameterKind::Constant),
                Value::Table(table) => {
                    match (table.get("varying").and_then(Value::as_str), table.len()) {
                        (Some(text), 1) => (text.to_owned(), ParameterKind::Varying),
                        _ => return Err(fail("expected `{ varying = \"-1..1\" }`")),
                    }
                }
                _ => {
                    let number = source.number(&field, value)?;
                    let (low, high) = (number.clone(), number);
                    let kind = ParameterKind::Constant;
                    return Ok(Parameter { name: name.clone(), low, high, kind });
                }
            };
            let (low, high) = range::closed(&field, &range)
                .map_err(|e| source.error(&value.span(), &e.to_string()))?;
            Ok(Parameter { name: name.clone(), low, high, kind })
        };
        self.parameters.iter().map(parameter).collect()
    }

    pub fn links(&self, source: &Source<'_>, count: usize) -> Result<Links> {
        match &self.topology {
            None => Ok(Links { topology: Topology::None, heard: vec![Vec::new(); count] }),
            Some(value) => Links::read(value.get_ref(), count)
                .map_err(|e| source.error(&value.span(), &format!("topology: {e}"))),
        }
    }

    /// Of a message, how many steps it may be old.
    pub fn delay(&self, source: &Source<'_>) -> Result<usize> {
        match &self.departures.delay {
            None => Ok(0),
            Some(delay) if *delay.get_ref() <= LONGEST_DELAY => Ok(*delay.get_ref()),
            Some(delay) => {
                let message = format!(
                    "departures.delay: `{}`: expected a number from 0 to {LONGEST_DELAY}",
                    delay.get_ref()
                );
                Err(source.error(&delay.span(), &message))
            }
        }
    }

    /// Whether links fail, and whether both ways at once.
    pub fn loss(&self, source: &Source<'_>) -> Result<Option<Loss>> {
        let Some(loss) = &self.departures.loss else { return Ok(None) };
        match loss.get_ref().as_str() {
            "symmetric" => Ok(Some(Loss::Symmetric)),
            "one-sided" => Ok(Some(Loss::OneSided)),
            other => {
                let message =
                    format!("departures.loss: `{other}`: expected `symmetric` or `one-sided`");
                Err(source.error(&loss.span(), &message))
            }
        }
    }

    pub fn converges(
        &self,
        source: &Source<'_>,
        claims: &Claims<'_>,
    ) -> Result<Option<Convergence>> {
        let Some(to) = &self.converges else {
            return match &self.target {
                None => Ok(None),
                Some(target) => {
                    Err(source
                        .error(&target.span(), "target: expected `converges = \"target\"` too"))
                }
            };
        };
        match (to.get_ref().as_str(), &self.target) {
            ("agreement", None) => Ok(Some(Convergence::Agreement)),
            ("target", Some(target)) => claims.targets(target).map(|t| Some(Convergence::To(t))),
            ("target", None) => {
                Err(source.error(&to.span(), "converges: expected a key `target` too"))
            }
            ("agreement", Some(target)) => {
                Err(source.error(&target.span(), "target: expected none where agents agree"))
            }
            (other, _) => {
                let message = format!("converges: `{other}`: expected `agreement` or `target`");
                Err(source.error(&to.span(), &message))
            }
        }
    }
}

/// Where a key stands in a table as written.
fn key_place(table: &str, key: &str) -> Option<usize> {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let stands = |at: usize| {
        let (before, after) = (table.get(..at)?, table.get(at + key.len()..)?);
        let after = after.trim_start_matches(['"', '\'']).trim_start();
        (!before.ends_with(is_letter) && after.starts_with('=')).then_some(at)
    };
    table.match_indices(key).find_map(|(at, _)| stands(at))
}

/// How links fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Loss {
    /// Both directions at once.
    Symmetric,
    /// Each direction by itself.
    OneSided,
}
