//! The flags that describe a scenario.

use std::collections::BTreeMap;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use cordon_spec::Phase;

use cordon_core::exact::{self, Rational, shortened};
use cordon_core::text::Printable;
use cordon_core::{Error, Result, range};
use cordon_formats::interchange;
use cordon_run::protocol;
use cordon_run::scenario::{self, Draft, Flight, Places, Scenario, Start};

/// A scenario file, flags, or a file with flags in place of some of its fields.
#[derive(clap::Args, Clone, Debug, Default, PartialEq, Eq)]
pub struct ScenarioArgs {
    /// Scenario file (TOML), see `scenarios/`, INTO-CPS multi-model (.json) or SSP archive (.ssp);
    /// `-`: stdin; flags replace its fields
    #[arg(value_name = "SCENARIO")]
    pub file: Option<PathBuf>,
    /// Number of drones, 3 to 1000000 [default: the length of the start]
    #[arg(long, value_name = "N", help_heading = "Scenario")]
    pub drones: Option<usize>,
    /// Start: positions separated by commas (0,10,20,30,100), fractions and decimals allowed; for a
    /// protocol file, all state variables drone by drone (x0,v0,x1,v1,...)
    #[arg(long, value_name = "X,...", allow_hyphen_values = true, help_heading = "Scenario")]
    pub start: Option<String>,
    /// Start: drone i at min + i*(TO - min)/(N-1), the last drone at max
    #[arg(
        long,
        value_name = "TO",
        allow_hyphen_values = true,
        conflicts_with = "start",
        help_heading = "Scenario"
    )]
    pub spread_to: Option<String>,
    /// Left end of the segment [default: the first position]
    #[arg(long, value_name = "X", allow_hyphen_values = true, help_heading = "Scenario")]
    pub min: Option<String>,
    /// Right end of the segment [default: the last position]
    #[arg(long, value_name = "X", allow_hyphen_values = true, help_heading = "Scenario")]
    pub max: Option<String>,
    /// Weight of the neighbours in the update: a fraction or a decimal, read exactly (0.2 is 1/5)
    #[arg(long, value_name = "E", allow_hyphen_values = true, help_heading = "Scenario")]
    pub eps: Option<String>,
    /// coverage, consensus, formation, or a protocol file (.toml, see `scenarios/own/`) [default:
    /// coverage]
    #[arg(long, value_name = "NAME|FILE", help_heading = "Scenario")]
    pub protocol: Option<String>,
    /// Value of a protocol file's parameter: `eps=1/3`
    #[arg(long, value_name = "NAME=X", allow_hyphen_values = true, help_heading = "Scenario")]
    pub set: Vec<String>,
    /// Graph of consensus and formation: path, ring or complete [default: path]
    #[arg(long, value_name = "NAME", help_heading = "Scenario")]
    pub graph: Option<String>,
    /// Ticks between updates, 1 to 4294967295 [default: 1]
    #[arg(long, value_name = "TICKS", help_heading = "Scenario")]
    pub period: Option<u32>,
    /// Tick of the first update: first (tick 1) or last (tick `period`) [default: first]
    #[arg(long, value_name = "PHASE", help_heading = "Scenario")]
    pub phase: Option<String>,
    /// Length of a tick in seconds [default: none; 1/20 in co-simulation]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true, help_heading = "Scenario")]
    pub tau: Option<String>,
}

impl ScenarioArgs {
    /// The checked scenario.
    ///
    /// # Errors
    /// The file cannot be read or a field is wrong.
    pub fn scenario(&self) -> Result<Scenario> {
        self.drawn(None)
    }

    /// The checked scenario; for a protocol file without a start all variables are 0, for the number of
    /// agents in the flags or the file.
    ///
    /// # Errors
    /// The file cannot be read or a field is wrong.
    pub fn scenario_at_rest(&self) -> Result<Scenario> {
        let (None, None, Some(path)) = (&self.file, &self.start, &self.protocol) else {
            return self.scenario();
        };
        if !scenario::names_file(path) {
            return self.scenario();
        }
        let file = protocol::read(Path::new(path))?;
        let system = file.with_agents(self.drones.unwrap_or(file.agents.fewest()))?;
        let zeros = vec!["0"; system.state.len() - system.past.len()].join(",");
        Self { start: Some(zeros), ..self.clone() }.scenario()
    }

    /// The checked scenario; a seed draws the choices that its protocol file leaves open in each step.
    ///
    /// # Errors
    /// The file cannot be read or a field is wrong.
    pub fn drawn(&self, seed: Option<u64>) -> Result<Scenario> {
        let (scenario, flight, places) = self.read(seed)?;
        if flight.faults.is_empty() {
            return Ok(scenario);
        }
        Err(places.point(Error::input(
            "fault: expected none, since the protocol runs without drones here: `cordon cosim` flies the scenario with its faults",
        )))
    }

    /// The checked scenario, its flight, and the locations of their fields; a seed draws the choices
    /// that its protocol file leaves open in each step.
    ///
    /// # Errors
    /// The file cannot be read or a field is wrong.
    pub fn scenario_and_flight(&self, seed: Option<u64>) -> Result<(Scenario, Flight, Places)> {
        self.read(seed)
    }

    fn read(&self, seed: Option<u64>) -> Result<(Scenario, Flight, Places)> {
        let file = match &self.file {
            Some(path) if interchange::is_system(path) => interchange::read(path)?,
            Some(path) => scenario::read(path)?,
            None => Draft::default(),
        };
        let flags = Draft { choices: seed, ..self.draft()? };
        let draft = file.replaced_by(flags);
        let (flight, places) = (draft.flight.clone(), draft.places.clone());
        let scenario = draft.finish()?;
        if let Some(own) = scenario.own()
            && let Some(choices) = own.choices()
        {
            // If stderr is closed there is nothing left to do.
            let _ = writeln!(Printable(std::io::stderr()), "{}: {choices}", own.file);
        }
        Ok((scenario, flight, places))
    }

    fn draft(&self) -> Result<Draft> {
        let number = |field: &str, text: &Option<String>| {
            text.as_deref().map(|t| exact::parse(field, t)).transpose()
        };
        let start = match (&self.start, number("spread-to", &self.spread_to)?) {
            (Some(list), _) => Some(Start::Listed(positions(list)?)),
            (None, to) => to.map(Start::SpreadTo),
        };
        Ok(Draft {
            protocol: self.protocol.clone(),
            min: number("min", &self.min)?,
            max: number("max", &self.max)?,
            drones: self.drones,
            start,
            weight: number("eps", &self.eps)?,
            period: self.period,
            phase: self.phase.as_deref().map(phase).transpose()?,
            tau: number("tau", &self.tau)?,
            graph: self.graph.clone(),
            parameters: self.parameters()?,
            ..Draft::default()
        })
    }
}

impl ScenarioArgs {
    /// The parameters that flags set, each once.
    fn parameters(&self) -> Result<BTreeMap<String, Rational>> {
        let mut all = BTreeMap::new();
        for (name, value) in
            self.set.iter().map(|set| parameter(set)).collect::<Result<Vec<_>>>()?
        {
            let shown = shortened(&name);
            if all.insert(name, value).is_some() {
                return Err(Error::input(format!("set: `{shown}` occurs twice: expected it once")));
            }
        }
        Ok(all)
    }
}

/// The positions of a list like `0,10,20.5,1/3`.
///
/// # Errors
/// An entry that is not a number.
pub(super) fn positions(list: &str) -> Result<Vec<Rational>> {
    range::list(|i| format!("start: drone {i}"), list)
}

/// A parameter and its value, like `eps=1/3`.
fn parameter(set: &str) -> Result<(String, Rational)> {
    let (name, value) = set.split_once('=').ok_or_else(|| {
        let set = shortened(set);
        Error::input(format!("set: `{set}`: expected a parameter and its value, like `eps=1/3`"))
    })?;
    Ok((name.to_owned(), exact::parse(&format!("set: {}", shortened(name)), value)?))
}

fn phase(text: &str) -> Result<Phase> {
    match text {
        "first" => Ok(Phase::First),
        "last" => Ok(Phase::Last),
        _ => Err(Error::input(format!("phase: `{}`: expected `first` or `last`", shortened(text)))),
    }
}
