//! What a scenario says about the drones' bodies: the table `[flight]`, the lists `[[fault]]`
//! and `[[unit]]`.

use std::collections::BTreeMap;
use std::path::PathBuf;

use cordon_core::exact::Rational;

/// The fields of the co-simulation; what is not given is `None`.
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
    /// `hold` or `skip`: what a drone does where a message was lost.
    pub on_loss: Option<String>,
    /// Length of the run in seconds.
    pub duration: Option<Rational>,
    /// Where the drones are at the start, in m; their desired positions by default.
    pub start: Option<Vec<Rational>>,
    /// Wanted height in m.
    pub z_d: Option<Rational>,
    /// `at-once`, `ascending`, `descending` or a list: in which order drones update.
    pub order: Option<String>,
    /// Seed of everything random.
    pub seed: Option<u64>,
    /// Lost and late messages, and drones that drop out.
    pub faults: Vec<Fault>,
    /// FMUs in the place of units.
    pub units: Vec<Substitute>,
}

/// An FMU in the place of a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Substitute {
    /// The drone whose unit it replaces, from 0.
    pub drone: usize,
    /// Which of its units.
    pub unit: UnitName,
    /// Path of the FMU, as seen from where the program runs.
    pub fmu: PathBuf,
    /// The FMU's names of variables that it calls otherwise than the unit does.
    pub names: BTreeMap<String, String>,
    /// Parameters of the FMU, by its own names for them.
    pub parameters: BTreeMap<String, Parameter>,
    /// Parameters with several values: a run for each.
    pub ranges: BTreeMap<String, Vec<Rational>>,
}

/// The value of a parameter of an FMU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// A number, whole where the FMU's is.
    Number(Rational),
    /// True or false.
    Boolean(bool),
    /// Text.
    Text(String),
}

/// The units of a drone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum UnitName {
    /// Its share of the protocol.
    Coordination,
    /// The cascaded controller: position and attitude to rotors.
    Control,
    /// The quadcopter, linear around hover.
    Plant,
}

impl UnitName {
    /// All of them, in the order in which a drone has them.
    pub const ALL: [Self; 3] = [Self::Coordination, Self::Control, Self::Plant];

    /// Its place in [`UnitName::ALL`].
    pub fn place(self) -> usize {
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
    /// What happens, and to whom.
    pub kind: FaultKind,
    /// From when on, in seconds; from the start by default.
    pub from: Option<Rational>,
    /// Until when, in seconds; to the end by default.
    pub until: Option<Rational>,
}

/// What can happen to messages and drones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// Messages get lost, each with a probability.
    Loss {
        /// From which drone to which; every link by default.
        link: Option<(usize, usize)>,
        /// Between 0 and 1.
        probability: Rational,
    },
    /// Messages arrive so many steps late.
    Delay {
        /// From which drone to which; every link by default.
        link: Option<(usize, usize)>,
        /// How much later, in ticks.
        ticks: u32,
    },
    /// A drone neither sends nor hears nor updates.
    DropOut {
        /// The drone that neither updates nor sends, from 0.
        drone: usize,
    },
}

impl Flight {
    /// This flight, with every field that `other` says taken from `other`.
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
