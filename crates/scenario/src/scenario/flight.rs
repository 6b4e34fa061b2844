//! The co-simulation part of a scenario: the table `[flight]`, the lists `[[fault]]` and `[[unit]]`.

use std::collections::BTreeMap;
use std::path::PathBuf;

use cordon_core::exact::Rational;

/// The fields of the co-simulation; those not given are `None`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Flight {
    /// Gain lambda_P of the position, in 1/s.
    pub lambda_p: Option<Rational>,
    /// Gain lambda_A of the attitude, in 1/s.
    pub lambda_a: Option<Rational>,
    /// How plants integrate: `euler` or `exact`.
    pub integrator: Option<String>,
    /// How the master exchanges values: `jacobi` or `gauss-seidel`.
    pub master: Option<String>,
    /// `exact` or `double`: how positions travel between drones.
    pub exchange: Option<String>,
    /// `hold` or `skip`: what a drone does when a message was lost.
    pub on_loss: Option<String>,
    /// Length of the run in seconds.
    pub duration: Option<Rational>,
    /// Positions of the drones at the start, in m; the desired positions by default.
    pub start: Option<Vec<Rational>>,
    /// Desired height in m.
    pub z_d: Option<Rational>,
    /// `at-once`, `ascending`, `descending` or a list: the order in which drones update.
    pub order: Option<String>,
    /// Seed of all random choices.
    pub seed: Option<u64>,
    /// Lost and late messages, and drones that drop out.
    pub faults: Vec<Fault>,
    /// FMUs that replace units.
    pub units: Vec<Substitute>,
}

/// An FMU that replaces a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Substitute {
    /// The drone whose unit it replaces, from 0.
    pub drone: usize,
    /// Which of the drone's units it replaces.
    pub unit: UnitName,
    /// Path of the FMU, relative to the working directory.
    pub fmu: PathBuf,
    /// The FMU's names for variables, where they differ from the unit's.
    pub names: BTreeMap<String, String>,
    /// Parameters of the FMU, by the FMU's names.
    pub parameters: BTreeMap<String, Parameter>,
    /// Parameters with several values: a run for each.
    pub ranges: BTreeMap<String, Vec<Rational>>,
}

/// The value of a parameter of an FMU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// A number, an integer where the FMU's parameter is one.
    Number(Rational),
    /// True or false.
    Boolean(bool),
    /// Text.
    Text(String),
}

/// The units of a drone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum UnitName {
    /// The drone's part of the protocol.
    Coordination,
    /// The cascaded controller: position and attitude to rotors.
    Control,
    /// The quadcopter, linearised around hover.
    Plant,
}

impl UnitName {
    /// All of them, in their order within a drone.
    pub const ALL: [Self; 3] = [Self::Coordination, Self::Control, Self::Plant];

    /// Its index in [`UnitName::ALL`].
    pub fn index(self) -> usize {
        match self {
            Self::Coordination => 0,
            Self::Control => 1,
            Self::Plant => 2,
        }
    }

    /// Its name in scenario files and messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Coordination => "coordination",
            Self::Control => "control",
            Self::Plant => "plant",
        }
    }
}

/// Something that goes wrong during a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The kind of fault, and whom it affects.
    pub kind: FaultKind,
    /// When it begins, in seconds; at the start by default.
    pub from: Option<Rational>,
    /// When it ends, in seconds; at the end by default.
    pub until: Option<Rational>,
}

/// The kinds of faults.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// Messages get lost, each with a probability.
    Loss {
        /// From which drone to which; every link by default.
        link: Option<(usize, usize)>,
        /// Between 0 and 1.
        probability: Rational,
    },
    /// Messages arrive late by a number of steps.
    Delay {
        /// From which drone to which; every link by default.
        link: Option<(usize, usize)>,
        /// The delay, in ticks.
        ticks: u32,
    },
    /// A drone neither sends nor hears nor updates.
    DropOut {
        /// The drone that neither updates nor sends, from 0.
        drone: usize,
    },
}

impl Flight {
    /// This flight, with every field given in `other` replaced by that of `other`.
    #[must_use]
    pub fn replaced_by(self, other: Self) -> Self {
        Self {
            lambda_p: other.lambda_p.or(self.lambda_p),
            lambda_a: other.lambda_a.or(self.lambda_a),
            integrator: other.integrator.or(self.integrator),
            master: other.master.or(self.master),
            exchange: other.exchange.or(self.exchange),
            on_loss: other.on_loss.or(self.on_loss),
            duration: other.duration.or(self.duration),
            start: other.start.or(self.start),
            z_d: other.z_d.or(self.z_d),
            order: other.order.or(self.order),
            seed: other.seed.or(self.seed),
            faults: if other.faults.is_empty() { self.faults } else { other.faults },
            units: if other.units.is_empty() { self.units } else { other.units },
        }
    }
}
