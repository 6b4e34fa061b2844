//! A scenario before it is checked.

use std::collections::BTreeMap;
use std::path::Path;

use cordon_spec::Phase;

use super::document::is_title;
use super::{Flight, MAX_DRONES, MIN_DRONES, Own, Places, Protocol, Scenario, Topology};
use crate::protocol::{self, Agents};
use cordon_core::exact::{Rational, shortened};
use cordon_core::system::Variable;
use cordon_core::{Error, Result};

/// Where the drones start, as specified by the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Start {
    /// The position of every drone, from drone 0 on.
    Listed(Vec<Rational>),
    /// Drone i at `min + i*(to - min)/(N-1)`, the last drone at max.
    SpreadTo(Rational),
}

/// The fields of a scenario; those not given are `None`. Later sources override earlier ones
/// ([`Draft::replaced_by`]): flags override the file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Draft {
    /// A title, for display.
    pub title: Option<String>,
    /// `coverage` (default), `consensus`, `formation`, or a protocol file (ends in `.toml`).
    pub protocol: Option<String>,
    /// The text of the protocol file, where it is contained in another file.
    pub protocol_text: Option<String>,
    /// Left end of the segment; the first drone's start by default.
    pub min: Option<Rational>,
    /// Right end of the segment; the last drone's start by default.
    pub max: Option<Rational>,
    /// Number of drones; the length of the start by default.
    pub drones: Option<usize>,
    /// Where the drones are at step 0.
    pub start: Option<Start>,
    /// Weight eps of the neighbours, dimensionless.
    pub weight: Option<Rational>,
    /// Ticks from one update to the next; 1 by default.
    pub period: Option<u32>,
    /// Phase of the first update.
    pub phase: Option<Phase>,
    /// Length of a tick in seconds.
    pub tau: Option<Rational>,
    /// Number of protocol steps in a trace; 20 by default.
    pub steps: Option<u64>,
    /// The communication graph, by name.
    pub graph: Option<String>,
    /// The communication graph, by its edges.
    pub edges: Option<Vec<(usize, usize)>>,
    /// Desired displacements of a formation, one per agent.
    pub displacement: Option<Vec<Rational>>,
    /// Values of the parameters of a protocol file, by name.
    pub parameters: BTreeMap<String, Rational>,
    /// Seed for the choices that a protocol file leaves open in each step; built-in protocols leave
    /// none.
    pub choices: Option<u64>,
    /// The drones' bodies, for co-simulation.
    pub flight: Flight,
    /// The location of each field.
    pub places: Places,
}

/// Default number of protocol steps in a trace.
const DEFAULT_STEPS: u64 = 20;

impl Draft {
    /// This draft, with every field given in `other` replaced by that of `other`.
    #[must_use]
    pub fn replaced_by(mut self, other: Self) -> Self {
        for (field, given) in other.given() {
            if given {
                self.places.replaced(field);
            }
        }
        for name in other.parameters.keys() {
            self.places.replaced(&format!("parameters.{name}"));
        }
        self.parameters.extend(other.parameters);
        // A graph is given by its name or by its edges, not by both.
        if other.graph.is_some() || other.edges.is_some() {
            (self.graph, self.edges) = (None, None);
        }
        Self {
            title: other.title.or(self.title),
            // A protocol's text belongs to the name beside it.
            protocol_text: match other.protocol {
                Some(_) => other.protocol_text,
                None => self.protocol_text,
            },
            protocol: other.protocol.or(self.protocol),
            min: other.min.or(self.min),
            max: other.max.or(self.max),
            drones: other.drones.or(self.drones),
            start: other.start.or(self.start),
            weight: other.weight.or(self.weight),
            period: other.period.or(self.period),
            phase: other.phase.or(self.phase),
            tau: other.tau.or(self.tau),
            steps: other.steps.or(self.steps),
            graph: other.graph.or(self.graph),
            edges: other.edges.or(self.edges),
            displacement: other.displacement.or(self.displacement),
            parameters: self.parameters,
            choices: other.choices.or(self.choices),
            flight: self.flight.replaced_by(other.flight),
            places: self.places,
        }
    }

    /// The fields by their names in messages, and whether they are given.
    fn given(&self) -> [(&'static str, bool); 16] {
        let flight = &self.flight;
        [
            ("protocol", self.protocol.is_some()),
            ("min", self.min.is_some()),
            ("max", self.max.is_some()),
            ("drones", self.drones.is_some()),
            ("start", self.start.is_some()),
            ("spread_to", self.start.is_some()),
            ("weight", self.weight.is_some()),
            ("period", self.period.is_some()),
            ("phase", self.phase.is_some()),
            ("tau", self.tau.is_some()),
            ("graph", self.graph.is_some() || self.edges.is_some()),
            ("duration", flight.duration.is_some()),
            ("integrator", flight.integrator.is_some()),
            ("master", flight.master.is_some()),
            ("exchange", flight.exchange.is_some()),
            ("seed", flight.seed.is_some()),
        ]
    }

    /// The checked scenario.
    ///
    /// # Errors
    /// A missing, contradictory or meaningless field, by name.
    pub fn finish(self) -> Result<Scenario> {
        let places = self.places.clone();
        self.checked().map_err(|e| places.point(e))
    }

    fn checked(self) -> Result<Scenario> {
        let protocol = self.protocol.as_deref().unwrap_or("coverage");
        if names_file(protocol) {
            let (own, start) = self.own(protocol)?;
            let weight = own.value("eps").cloned().unwrap_or_default();
            let title = own.system.title.clone();
            return self.scenario(Protocol::Own(Box::new(own)), start, weight, title);
        }
        if !["coverage", "consensus", "formation"].contains(&protocol) {
            return Err(Error::input(format!(
                "protocol: `{}` is unknown: expected `coverage`, `consensus`, `formation` or a \
                 protocol file, which ends in `.toml`",
                shortened(protocol)
            )));
        }
        let start = self.positions()?;
        let count = start.len();
        let protocol = match protocol {
            "coverage" => self.coverage(&start)?,
            "consensus" => Protocol::Consensus { graph: self.topology(count)? },
            _ => {
                let graph = self.topology(count)?;
                Protocol::Formation { graph, displacement: self.displacements(count)? }
            }
        };
        self.refuse_fields_foreign_to(&protocol)?;
        let weight = self.weight.clone().ok_or_else(|| missing("weight (eps)", "--eps"))?;
        let title = format!("{} of {count} drones", protocol.name());
        self.scenario(protocol, start, weight, title)
    }

    fn scenario(
        self,
        protocol: Protocol,
        start: Vec<Rational>,
        weight: Rational,
        title: String,
    ) -> Result<Scenario> {
        let period = self.period.unwrap_or(1);
        if period == 0 {
            return Err(Error::input(
                "period: `0`: expected at least one tick from update to update",
            ));
        }
        if let Some(tau) = self.tau.as_ref().filter(|tau| **tau <= Rational::default()) {
            return Err(Error::input(format!(
                "tau: `{tau}`: expected a positive number of seconds"
            )));
        }
        Ok(Scenario {
            title: self.title.filter(|t| is_title(t)).unwrap_or(title),
            protocol,
            start,
            weight,
            period,
            phase: self.phase.unwrap_or_default(),
            tau: self.tau,
            steps: self.steps.unwrap_or(DEFAULT_STEPS),
        })
    }

    /// The system of a protocol file with values for its parameters, and its start.
    fn own(&self, path: &str) -> Result<(Own, Vec<Rational>)> {
        let foreign = [
            ("graph", self.graph.is_some() || self.edges.is_some()),
            ("displacement", self.displacement.is_some()),
            ("min", self.min.is_some()),
            ("max", self.max.is_some()),
            ("spread_to", matches!(self.start, Some(Start::SpreadTo(_)))),
        ];
        if let Some((field, _)) = foreign.into_iter().find(|(_, is)| *is) {
            return Err(Error::input(format!(
                "{field}: not a field of a protocol file's scenario"
            )));
        }
        let file = match &self.protocol_text {
            Some(text) => protocol::parse(path, text)?,
            None => protocol::read(Path::new(path))?,
        };
        let variables = file.variables()?;
        let Some(Start::Listed(start)) = &self.start else {
            return Err(missing(&format!("start ({})", in_order(&variables)), "--start"));
        };
        let per_agent = variables.len().max(1);
        let agents = match (self.drones, file.agents) {
            (Some(drones), _) => drones,
            (None, Agents::Exactly(agents)) => agents,
            (None, Agents::From(fewest)) => (start.len() / per_agent).max(fewest),
        };
        if start.len() != agents * per_agent {
            return Err(Error::input(format!(
                "start: {} numbers given: expected {per_agent} for each of {agents} agents: {}",
                start.len(),
                in_order(&variables)
            )));
        }
        let mut given = self.parameters.clone();
        if let Some(weight) = &self.weight
            && given.insert("eps".to_owned(), weight.clone()).is_some()
        {
            return Err(Error::input("parameters.eps: given as weight too: expected one of them"));
        }
        let system = file.with_agents(agents)?;
        if self.weight.is_some() && system.parameters.iter().all(|p| p.name != "eps") {
            return Err(Error::input(format!(
                "weight: expected none: `{path}` has no parameter `eps`"
            )));
        }
        let named = (path.to_owned(), file.text().to_owned());
        let own = Own::new(named, system, &given, self.choices)?;
        Ok((own, start.clone()))
    }

    fn positions(&self) -> Result<Vec<Rational>> {
        let start = self.start.as_ref().ok_or_else(|| missing("start", FLAGS))?;
        let count = match (self.drones, start) {
            (Some(n), _) => n,
            (None, Start::Listed(list)) => list.len(),
            (None, Start::SpreadTo(_)) => return Err(missing("drones (their number)", "--drones")),
        };
        if !(MIN_DRONES..=MAX_DRONES).contains(&count) {
            return Err(Error::input(format!(
                "drones: `{count}`: expected {MIN_DRONES} to {MAX_DRONES} drones"
            )));
        }
        match start {
            Start::Listed(list) if list.len() == count => Ok(list.clone()),
            Start::Listed(list) => Err(Error::input(format!(
                "start: {} positions given: expected one for each of the {count} drones",
                list.len()
            ))),
            Start::SpreadTo(to) => {
                let min = self.min.clone().unwrap_or_default();
                let max = self
                    .max
                    .clone()
                    .ok_or_else(|| missing("max, which `spread_to` needs", "--max"))?;
                let gaps = Rational::from_integer((count - 1).into());
                let spacing = (to - &min) / gaps;
                let place = |i: usize| &min + &spacing * Rational::from_integer(i.into());
                Ok((0..count - 1).map(place).chain([max]).collect())
            }
        }
    }

    fn coverage(&self, start: &[Rational]) -> Result<Protocol> {
        let (Some(first), Some(last)) = (start.first(), start.last()) else {
            return Err(missing("start", FLAGS));
        };
        let min = self.min.clone().unwrap_or_else(|| first.clone());
        let max = self.max.clone().unwrap_or_else(|| last.clone());
        if min >= max {
            return Err(Error::input(match (&self.min, &self.max) {
                (None, None) => format!(
                    "start: the last drone is at `{max}`: expected more than `{min}`, where the first is"
                ),
                _ => format!("max: `{max}`: expected more than min, which is `{min}`"),
            }));
        }
        for (name, end, drone, at) in
            [("min", &min, 0, first), ("max", &max, start.len() - 1, last)]
        {
            if at != end {
                return Err(Error::input(format!(
                    "start: drone {drone} is at `{at}`: expected {name}, which is `{end}`: \
                     the end drones stay at the ends of the segment"
                )));
            }
        }
        Ok(Protocol::Coverage { min, max })
    }

    fn topology(&self, count: usize) -> Result<Topology> {
        match (&self.edges, &self.graph) {
            (Some(edges), _) => Topology::from_edges(edges, count),
            (None, name) => Topology::named(name.as_deref().unwrap_or("path"), count),
        }
    }

    fn displacements(&self, count: usize) -> Result<Vec<Rational>> {
        let b = self.displacement.as_ref().ok_or_else(|| {
            Error::input("displacement is missing: expected it in a scenario file, as there is no flag for it")
        })?;
        if b.len() == count {
            Ok(b.clone())
        } else {
            Err(Error::input(format!(
                "displacement: {} numbers given: expected one for each of the {count} drones",
                b.len()
            )))
        }
    }

    fn refuse_fields_foreign_to(&self, protocol: &Protocol) -> Result<()> {
        let name = protocol.name();
        let coverage = matches!(protocol, Protocol::Coverage { .. });
        // Spread-out drones start from min, with the last one at max.
        let spread = matches!(self.start, Some(Start::SpreadTo(_)));
        let parameters = self.parameters.keys().next().map(|name| format!("parameters.{name}"));
        if let Some(field) = parameters {
            return Err(Error::input(format!("{field}: not a field of protocol `{name}`")));
        }
        let foreign = [
            ("graph", coverage && (self.graph.is_some() || self.edges.is_some())),
            ("displacement", self.displacement.is_some() && name != "formation"),
            ("min", !coverage && self.min.is_some() && !spread),
            ("max", !coverage && self.max.is_some() && !spread),
        ];
        for (field, is_foreign) in foreign {
            if is_foreign {
                return Err(Error::input(format!("{field}: not a field of protocol `{name}`")));
            }
        }
        Ok(())
    }
}

/// Whether a protocol's name is that of a file.
pub fn names_file(protocol: &str) -> bool {
    Path::new(protocol).extension().is_some_and(|end| end.eq_ignore_ascii_case("toml"))
}

/// The flags that set the start.
const FLAGS: &str = "--start or --spread-to";

/// The order of the numbers in a start: `x0,v0,x1,v1 and so on`.
fn in_order(variables: &[Variable]) -> String {
    let names = (0..2).flat_map(|i| variables.iter().map(move |v| format!("{}{i}", v.name)));
    format!("{} and so on", names.collect::<Vec<_>>().join(","))
}

fn missing(field: &str, flag: &str) -> Error {
    Error::input(format!("{field} is missing: expected {flag}, or a field of the scenario file"))
}
