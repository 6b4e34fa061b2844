//! Protocol files: a user's own protocol as TOML, `cordon-protocol/1`.
//!
//! The page of documentation is `docs/src/protocol-file.md`. A file is read once and made into a
//! [`System`] for any number of agents that it allows.

mod claims;
mod classes;
mod document;
mod links;
mod rules;

use std::path::Path;

use toml::{Spanned, Value};

use cordon_core::files::Limit;
use cordon_core::system::{
    Convergence, Flow, MOST_VARIABLES, Parameter, Schedule, System, Variable,
};
use cordon_core::{Error, Result};

use crate::scenario::Places;
use crate::scenario::document::{document, is_title, written};
use crate::scenario::file::Source;
pub use classes::{Family, FamilyClaim};
pub use document::Agents;
use document::{Document, with_present_keys};
use rules::Unnamed;

/// A protocol file, read and checked as far as that does not depend on the number of agents.
#[derive(Clone, Debug)]
pub struct ProtocolFile {
    name: String,
    text: String,
    document: Document,
    places: Places,
    /// How many agents it speaks of.
    pub agents: Agents,
    /// Whether it is of continuous time.
    pub is_continuous: bool,
}

/// Reads a protocol file.
///
/// # Errors
/// The file cannot be read, is no TOML, or has an unknown key: the message has file, line, column
/// and key.
pub fn read(path: &Path) -> Result<ProtocolFile> {
    parse(&path.display().to_string(), &written(path, Limit::PROTOCOL)?)
}

/// Reads a protocol from text; `name` stands for the file in messages.
///
/// # Errors
/// As for [`read`].
pub fn parse(name: &str, text: &str) -> Result<ProtocolFile> {
    let source = Source { name, text };
    let (document, places): (Document, _) = document(&source)
        .map_err(|e| if is_scenario(text) { no_protocol(name) } else { with_present_keys(e) })?;
    document.refuse_other_formats(&source)?;
    let agents = document.agents(&source)?;
    let is_continuous = document.is_continuous(&source)?;
    let (name, text) = (name.to_owned(), text.to_owned());
    Ok(ProtocolFile { name, text, document, places, agents, is_continuous })
}

/// Whether the text is a scenario.
fn is_scenario(text: &str) -> bool {
    const OF_SCENARIOS: [&str; 11] = [
        "protocol",
        "spread_to",
        "period",
        "phase",
        "tau",
        "steps",
        "displacement",
        "flight",
        "fault",
        "unit",
        "min",
    ];
    let table = text.parse::<toml::Table>().unwrap_or_default();
    let has = |keys: &[&str]| keys.iter().any(|key| table.contains_key(*key));
    let placed = table.get("start").and_then(toml::Value::as_array);
    let placed = placed.and_then(|list| list.first()).is_some_and(|x| !x.is_str());
    (has(&OF_SCENARIOS) || placed) && !has(&["agents", "claims", "claim", "rules", "update"])
}

fn no_protocol(name: &str) -> Error {
    Error::input(format!(
        "{name}: a scenario: expected a protocol file, which has `agents` and `[rules]`"
    ))
}

impl ProtocolFile {
    /// An error about a key of the file, with its place; where the file does not have it, with the file's name.
    pub fn error(&self, key: &str, message: &str) -> Error {
        self.places.point(Error::input(format!("{key}: {message}")))
    }

    /// The system with as many agents as the file names; of a range the fewest.
    ///
    /// # Errors
    /// A rule, an assumption or a claim is wrong: the message has file, line, column and key.
    pub fn system(&self) -> Result<System> {
        self.with_agents(self.agents.fewest())
    }

    /// The system with `count` agents.
    ///
    /// # Errors
    /// As for [`system`](Self::system); or the file does not allow that number, or is of continuous time.
    pub fn with_agents(&self, count: usize) -> Result<System> {
        if self.is_continuous {
            return Err(self.error(
                "time",
                "`continuous`: expected a protocol that acts in steps; `cordon prove` judges those in \
                 continuous time",
            ));
        }
        self.built(count)
    }

    /// The system in continuous time with `count` agents: rules are derivatives.
    ///
    /// # Errors
    /// As for [`with_agents`](Self::with_agents); or the file is of steps, or claims what is about steps.
    pub fn flow(&self, count: usize) -> Result<Flow> {
        let source = Source { name: &self.name, text: &self.text };
        if !self.is_continuous {
            return Err(self.error("time", "expected `continuous`"));
        }
        if let Some(to) = &self.document.converges {
            return Err(source.error(&to.span(), "converges: expected `claims` in continuous time"));
        }
        let switching = self.document.flow_switching(&source)?;
        let system = self.built(count)?;
        if system.claims.iter().any(|c| c.from > 0 || c.until.is_some()) {
            let about_steps = |claim: &&Spanned<Value>| claim.get_ref().is_table();
            let place = self.document.claims.iter().find(about_steps).map_or(0..0, Spanned::span);
            let message = "claims: expected no `from` and no `until` in continuous time";
            return Err(source.error(&place, message));
        }
        Ok(Flow { system, switching })
    }

    fn built(&self, count: usize) -> Result<System> {
        let source = Source { name: &self.name, text: &self.text };
        let doc = &self.document;
        if !self.agents.allow(count) {
            let message = format!("agents: `{count}`: expected {}", self.agents);
            return Err(source.error(&doc.agents_place(), &message));
        }
        let variables = doc.variables(&source)?;
        let links = doc.links(&source, count)?;
        let constants = doc.parameters(&source, &variables)?;
        let unnamed = if self.is_continuous { Unnamed::Zero } else { Unnamed::Kept };
        let rules = rules::Rules::new(&source, doc, count, &variables, constants, links, unnamed)?;
        let built = rules.build()?;
        if built.state.len() > MOST_VARIABLES {
            let message = format!(
                "agents: {count} agents with {} state variables, those of the past included: \
                 expected at most {MOST_VARIABLES}",
                built.state.len()
            );
            return Err(source.error(&doc.agents_place(), &message));
        }
        let claims = claims::Claims { source: &source, agents: count, variables: &variables };
        let claimed = claims.claims(&doc.claims)?;
        let starts = match &doc.start {
            Some(list) => claims.starts(list)?,
            None => claimed.iter().filter(|c| c.from == 0).map(|c| c.predicate.clone()).collect(),
        };
        let mut converges = doc.converges(&source, &claims)?;
        if let Some(Convergence::To(targets)) = &mut converges {
            let past: Vec<_> = built.past.iter().filter_map(|&j| targets.get(j).cloned()).collect();
            targets.extend(past);
        }
        Ok(System {
            title: doc.title.clone().filter(|t| is_title(t)).unwrap_or_else(|| self.name.clone()),
            agents: count,
            variables,
            state: built.state,
            past: built.past,
            parameters: built.parameters,
            schedule: match built.cycle {
                Some(list) => Schedule::Cycle(list),
                None => Schedule::Any,
            },
            modes: built.modes,
            links: built.links,
            starts,
            claims: claimed,
            converges,
        })
    }

    /// The state variables of an agent, whatever the number of agents.
    ///
    /// # Errors
    /// They are no names: the message has file, line, column and key.
    pub fn variables(&self) -> Result<Vec<Variable>> {
        self.document.variables(&Source { name: &self.name, text: &self.text })
    }

    /// The constants that the file names.
    ///
    /// # Errors
    /// As for [`variables`](Self::variables).
    pub fn parameters(&self) -> Result<Vec<Parameter>> {
        let source = Source { name: &self.name, text: &self.text };
        self.document.parameters(&source, &self.variables()?)
    }

    /// Whether the file says what is assumed of the start; else the claims are.
    pub fn has_start(&self) -> bool {
        self.document.start.is_some()
    }

    /// What the file says.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether the file leaves the number of agents open.
    pub fn is_family(&self) -> bool {
        matches!(self.agents, Agents::From(_))
    }
}
