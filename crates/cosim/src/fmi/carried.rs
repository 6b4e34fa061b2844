//! The contents of a protocol FMU: the protocol file, and a scenario that names it.

use std::fmt::Write;
use std::path::Path;

use cordon_spec::Phase;

use crate::coordination::{Exchange, Law, OnLoss, OwnLaw, Settings};
use cordon_core::exact::Rational;
use cordon_core::{Error, Result, files};
use cordon_run::scenario::{self, Draft, Own, Scenario};

/// The scenario, under the archive's `resources/`.
pub const SCENARIO: &str = "scenario.toml";

/// The protocol file, beside it.
pub const PROTOCOL: &str = "protocol.toml";

/// The content of the FMU of a protocol file's coordination units, for any drone.
#[derive(Clone, Debug, PartialEq)]
pub struct Carried {
    /// The protocol, with values for its parameters.
    pub own: Own,
    /// Every state variable at the start, drone by drone.
    pub start: Vec<Rational>,
    /// Ticks from one update to the next, at least 1.
    pub period: u32,
    /// The tick of the first update.
    pub phase: Phase,
}

impl Carried {
    /// The content for the units of a scenario; `None` for built-in protocols.
    pub fn of(scenario: &Scenario) -> Option<Self> {
        let own = scenario.own()?.clone();
        let Scenario { start, period, phase, .. } = scenario;
        Some(Self { own, start: start.clone(), period: *period, phase: *phase })
    }

    /// Names and texts of the two files.
    pub fn files(&self) -> [(&'static str, String); 2] {
        let phase = match self.phase {
            Phase::First => "first",
            Phase::Last => "last",
        };
        let start: Vec<String> = self.start.iter().map(|x| format!("\"{x}\"")).collect();
        let (start, period) = (start.join(", "), self.period);
        let mut text = format!(
            "protocol = \"{PROTOCOL}\"\nstart = [{start}]\nperiod = {period}\nphase = \"{phase}\"\n\n\
             [parameters]\n"
        );
        for (parameter, value) in self.own.constants() {
            // Writing to memory cannot fail.
            let _ = writeln!(text, "{} = \"{value}\"", parameter.name);
        }
        [(SCENARIO, text), (PROTOCOL, self.own.text.clone())]
    }

    /// Reads the two files from the folder of an FMU's resources.
    ///
    /// # Errors
    /// They cannot be read, or are not as [`files`](Self::files) writes them.
    pub fn read(resources: &Path) -> Result<Self> {
        let limit = files::Limit::PROTOCOL;
        let [scenario, protocol] = [SCENARIO, PROTOCOL].map(|name| resources.join(name));
        Self::parse(
            resources,
            &files::read_text(&scenario, limit)?,
            files::read_text(&protocol, limit)?,
        )
    }

    /// Parses the texts of the two files; `resources` stands for their folder in messages.
    ///
    /// # Errors
    /// They are not as [`files`](Self::files) writes them.
    pub fn parse(resources: &Path, scenario: &str, protocol: String) -> Result<Self> {
        let draft = scenario::parse(&resources.join(SCENARIO).display().to_string(), scenario)?;
        let read = Draft { protocol_text: Some(protocol), ..draft }.finish()?;
        let name = read.protocol.name().to_owned();
        Self::of(&read).ok_or_else(|| {
            Error::input(format!("protocol: `{name}`: expected the file `{PROTOCOL}`"))
        })
    }

    /// Drone `drone` as a unit that can be switched to any other drone.
    pub fn settings(&self, drone: usize, exchange: Exchange, on_loss: OnLoss) -> Settings {
        let law = OwnLaw::open(&self.own, &self.start, drone);
        Settings {
            weight: Rational::default(),
            start: law.start.get(law.position).cloned().unwrap_or_default(),
            law: Law::Own(Box::new(law)),
            period: self.period,
            phase: self.phase,
            exchange,
            on_loss,
        }
    }
}
