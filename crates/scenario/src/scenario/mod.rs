//! What to run: a protocol, its parameters and a start.
//!
//! A scenario comes from a TOML file ([`mod@file`]), from flags, or from a file with some fields
//! overridden by flags ([`Draft`]); all checks are in [`Draft::finish`].

pub mod document;
mod draft;
pub mod file;
mod flight;
mod flight_file;
mod graph;
mod own;
mod places;

use cordon_spec::theorems::Setting;
use cordon_spec::{Params, Phase, State};

pub use draft::{Draft, Start, names_file};
pub use file::{parse, read};
pub use flight::{Fault, FaultKind, Flight, Parameter, Substitute, UnitName};
pub use graph::Topology;
pub use own::Own;
pub use places::Places;

use cordon_core::Rational;

/// Fewest drones of a scenario: two ends and an internal drone (definition 1 of the paper's
/// section 7.1).
pub const MIN_DRONES: usize = 3;

/// Most drones of a scenario: exact positions of more would fit neither a terminal nor memory.
pub const MAX_DRONES: usize = 1_000_000;

/// The rule by which the drones move.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Protocol {
    /// Equation 10 on the segment \[min, max\].
    Coverage {
        /// Left end of the segment, where drone 0 stays.
        min: Rational,
        /// Right end of the segment, where drone N-1 stays.
        max: Rational,
    },
    /// Consensus on a graph (equation 6).
    Consensus {
        /// Which agents each one hears.
        graph: Topology,
    },
    /// Formation on a graph (equation 8).
    Formation {
        /// Which agents each one hears.
        graph: Topology,
        /// Sum of the desired displacements of each drone from its neighbours.
        displacement: Vec<Rational>,
    },
    /// A protocol that a file defines.
    Own(Box<Own>),
}

impl Protocol {
    /// The protocol's name in scenario files and output; for a protocol file its path.
    pub fn name(&self) -> &str {
        match self {
            Self::Coverage { .. } => "coverage",
            Self::Consensus { .. } => "consensus",
            Self::Formation { .. } => "formation",
            Self::Own(own) => &own.file,
        }
    }
}

/// A checked scenario: N >= 3 drones (or what the protocol file allows), consistent lengths, `min <
/// max`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scenario {
    /// A title, for display.
    pub title: String,
    /// The rule by which the drones move.
    pub protocol: Protocol,
    /// Position of every drone at the start; for a protocol file every state variable, drone by drone.
    pub start: Vec<Rational>,
    /// Weight eps of the neighbours in the update, dimensionless; 0 for a protocol file without a
    /// parameter `eps`.
    pub weight: Rational,
    /// Ticks from one update to the next, at least 1.
    pub period: u32,
    /// The tick of the first update.
    pub phase: Phase,
    /// Length of a tick in seconds, where the scenario has a clock.
    pub tau: Option<Rational>,
    /// Default number of protocol steps in a trace.
    pub steps: u64,
}

impl Scenario {
    /// The number of drones N.
    pub fn count(&self) -> usize {
        self.own().map_or(self.start.len(), |own| own.system.agents)
    }

    /// The protocol file's system, if it is one.
    pub fn own(&self) -> Option<&Own> {
        match &self.protocol {
            Protocol::Own(own) => Some(own),
            _ => None,
        }
    }

    /// The columns of a trace: `x0, x1, ...`, or the state variables of the protocol file.
    pub fn columns(&self) -> Vec<String> {
        match self.own() {
            Some(own) => own.columns().to_vec(),
            None => (0..self.count()).map(|i| format!("x{i}")).collect(),
        }
    }

    /// The start, including a protocol file's memory of the past: at rest.
    pub fn whole_start(&self) -> Vec<Rational> {
        let at_rest = self.own().and_then(|own| own.system.at_rest(&self.start));
        at_rest.unwrap_or_else(|| self.start.clone())
    }

    /// The largest value `n` of the tick counter.
    pub fn counter_limit(&self) -> u32 {
        self.period - 1
    }

    /// The spec's initial state.
    pub fn initial(&self) -> State<Vec<Rational>> {
        State::initial(self.whole_start(), self.counter_limit(), self.phase)
    }

    /// The spec's parameters for coverage of the segment \[min, max\].
    pub fn coverage_params(&self, min: &Rational, max: &Rational) -> Params<Rational> {
        Params {
            min: min.clone(),
            max: max.clone(),
            eps: self.weight.clone(),
            n: self.counter_limit(),
        }
    }

    /// The spec's parameters, where the protocol is coverage.
    pub fn params(&self) -> Option<Params<Rational>> {
        match &self.protocol {
            Protocol::Coverage { min, max } => Some(self.coverage_params(min, max)),
            _ => None,
        }
    }

    /// The setting of the theorems, where the protocol is coverage.
    pub fn setting(&self) -> Option<Setting<Rational>> {
        self.params().map(|p| Setting::from(&p))
    }

    /// The tick of the first update.
    fn first_update(&self) -> u64 {
        match self.phase {
            Phase::First => 1,
            Phase::Last => self.period.into(),
        }
    }

    /// The number of protocol steps within `tick` ticks.
    pub fn steps_until(&self, tick: u64) -> u64 {
        tick.checked_sub(self.first_update()).map_or(0, |late| late / u64::from(self.period) + 1)
    }

    /// The tick counter after `tick` ticks: the number of ticks since the last update.
    pub fn timesteps_at(&self, tick: u64) -> u32 {
        match tick.checked_sub(self.first_update()) {
            // Below the period.
            Some(late) => (late % u64::from(self.period)) as u32,
            None => match self.phase {
                Phase::First => self.counter_limit(),
                // Below the period too.
                Phase::Last => tick as u32,
            },
        }
    }

    /// The time after this many ticks, in seconds, where the scenario has a clock.
    pub fn time(&self, tick: u64) -> Option<Rational> {
        Some(self.tau.as_ref()? * Rational::from_integer(tick.into()))
    }

    /// The tick in which protocol step `k >= 1` happens.
    pub fn tick_of_step(&self, k: u64) -> Option<u64> {
        k.checked_sub(1)?.checked_mul(self.period.into())?.checked_add(self.first_update())
    }
}
