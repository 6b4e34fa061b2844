//! The interface of an exported unit: its model, its variables, its identifier.

use std::fmt;
use std::sync::Arc;

use cordon_spec::Phase;

use crate::control::{Control, Gains};
use crate::coordination::{Coordination, Exchange, Law, OnLoss, Settings};
use crate::fmi::carried::Carried;
use crate::plant::{Integrator, Plant};
use crate::quotient::Quotient;
use crate::unit::{Causality, Dimension, Resumable, Value, Variable};
use cordon_core::Result;
use cordon_core::exact::{self, Rational};
use cordon_core::fingerprint::Fingerprint;
use cordon_run::scenario::{Protocol, Scenario};

/// A version of the FMI standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FmiVersion {
    /// FMI 2.0, of 2014.
    V2,
    /// FMI 3.0, of 2022.
    V3,
}

impl FmiVersion {
    /// The version as written in model descriptions.
    pub fn name(self) -> &'static str {
        match self {
            Self::V2 => "2.0",
            Self::V3 => "3.0",
        }
    }
}

/// A unit that can be exported.
#[derive(Clone, Debug, PartialEq)]
pub enum Model {
    /// The coordination unit of the coverage protocol, with the way positions travel.
    Coordination(Positions),
    /// The coordination unit of a protocol file, for any drone.
    Protocol(Positions, Arc<Carried>),
    /// The cascaded controller: position and attitude to rotors.
    Control,
    /// The quadcopter, linear around hover.
    Plant,
}

/// How positions travel between coordination units: the FMI side of [`Exchange`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Positions {
    /// As text `p/q`, exactly.
    Exact,
    /// As doubles, rounded once when sent.
    Double,
    /// As doubles parsed from six significant digits, as in the recorded runs.
    SixDigits,
}

impl From<Positions> for Exchange {
    fn from(positions: Positions) -> Self {
        match positions {
            Positions::Exact => Self::Exact,
            Positions::Double => Self::Double,
            Positions::SixDigits => Self::SixDigits,
        }
    }
}

impl From<Exchange> for Positions {
    fn from(exchange: Exchange) -> Self {
        match exchange {
            Exchange::Exact => Self::Exact,
            Exchange::Double => Self::Double,
            Exchange::SixDigits => Self::SixDigits,
        }
    }
}

impl Model {
    /// The models that carry no files.
    pub const PLAIN: [Self; 5] = [
        Self::Coordination(Positions::Exact),
        Self::Coordination(Positions::Double),
        Self::Coordination(Positions::SixDigits),
        Self::Control,
        Self::Plant,
    ];

    /// The coordination unit of a scenario's protocol; `None` where it cannot be exported.
    pub fn coordination(positions: Positions, scenario: &Scenario) -> Option<Self> {
        match (&scenario.protocol, Carried::of(scenario)) {
            (Protocol::Coverage { .. }, _) => Some(Self::Coordination(positions)),
            (_, carried) => Some(Self::Protocol(positions, Arc::new(carried?))),
        }
    }

    /// How positions travel; `None` where the model is not a coordination unit.
    pub fn positions(&self) -> Option<Positions> {
        match self {
            Self::Coordination(positions) | Self::Protocol(positions, _) => Some(*positions),
            Self::Control | Self::Plant => None,
        }
    }

    /// The name of the model, which is also that of its binary: a C identifier.
    pub fn identifier(&self) -> &'static str {
        match self {
            Self::Coordination(Positions::Exact) => "cordon_coordination",
            Self::Coordination(Positions::Double) => "cordon_coordination_double",
            Self::Coordination(Positions::SixDigits) => "cordon_coordination_six_digits",
            Self::Protocol(Positions::Exact, _) => "cordon_protocol",
            Self::Protocol(Positions::Double, _) => "cordon_protocol_double",
            Self::Protocol(Positions::SixDigits, _) => "cordon_protocol_six_digits",
            Self::Control => "cordon_control",
            Self::Plant => "cordon_plant",
        }
    }

    /// A description, for display.
    pub fn description(&self) -> String {
        let what = match self {
            Self::Coordination(_) => "the coverage protocol",
            Self::Protocol(_, carried) => &carried.own.system.title,
            Self::Control => return "Cascaded controller of a quadcopter near hover".to_owned(),
            Self::Plant => return "Quadcopter near hover".to_owned(),
        };
        let positions = match self.positions() {
            Some(Positions::Double) => "positions as doubles",
            Some(Positions::SixDigits) => "positions read with six digits",
            Some(Positions::Exact) | None => "exact positions as text p/q",
        };
        format!("Coordination of one drone: {what}, {positions}")
    }

    /// A unit of this model, its parameters at their start values.
    pub fn unit(&self, name: &str) -> Box<dyn Resumable> {
        match self {
            Self::Coordination(positions) => {
                Box::new(Coordination::new(name, default_settings((*positions).into())))
            }
            Self::Protocol(positions, carried) => {
                let settings = carried.settings(0, (*positions).into(), OnLoss::default());
                Box::new(Coordination::new(name, settings))
            }
            Self::Control => Box::new(Control::new(name, Gains::default())),
            Self::Plant => Box::new(Plant::new(name, [0.0; 3], Integrator::default())),
        }
    }

    /// The variables that importers see: those of the unit, then [`TAU`] and [`START_INPUTS`]. A
    /// variable's value reference is its index here.
    pub fn variables(&self) -> Vec<Variable> {
        let mut variables = self.unit(self.identifier()).variables().to_vec();
        variables.push(tau(self.exact_numbers()));
        let text = "whether the first step takes the inputs' start values, whatever is set after the \
                    initialisation";
        let start = Value::Boolean(false);
        let (none, parameter) = (Dimension::NONE, Causality::Parameter);
        variables.push(Variable::new(START_INPUTS, none, parameter, start, text));
        variables
    }

    /// Whether its exact numbers travel as text `p/q`. Otherwise they are doubles, which stand for
    /// [simple fractions](Quotient::simplest_of).
    pub fn exact_numbers(&self) -> bool {
        self.positions() == Some(Positions::Exact)
    }

    /// The value of [`TAU`] for a step of this many seconds.
    pub fn tau_value(&self, tau: &Rational) -> Value {
        tau_value(self.exact_numbers(), tau)
    }

    /// The parameters that an output depends on right after initialisation.
    pub fn initial_dependencies(&self, output: &str) -> Option<String> {
        Some(match (self, output) {
            (Self::Plant, "x" | "y" | "z") => format!("{output}0"),
            (Self::Coordination(_) | Self::Protocol(..), "x_d" | "own") => "start".to_owned(),
            (Self::Protocol(..), beside) => beside.replacen("own", "start", 1),
            _ => return None,
        })
    }

    /// The identifier (FMI 2.0: guid; FMI 3.0: instantiationToken) required to make instances. It names
    /// the model and has a fingerprint of the variables and of the files that the FMU carries, so that
    /// a model description is never used with a binary or a protocol with other variables.
    pub fn token(&self, version: FmiVersion) -> String {
        let mut print = Fingerprint::default();
        for v in self.variables() {
            print.add_text(&v.name);
            print.add_text(v.dimension.0);
            print.add_text(v.causality.name());
            print.add_text(&v.kind().to_string());
            print.add_text(&v.start.to_string());
        }
        for (_, text) in self.resources() {
            print.add_text(&text);
        }
        format!("cordon-fmi{}:{}:{}", version.name(), self.identifier(), print.hex())
    }

    /// Names and texts of the files in the FMU's `resources/`.
    pub fn resources(&self) -> Vec<(&'static str, String)> {
        match self {
            Self::Protocol(_, carried) => carried.files().to_vec(),
            Self::Coordination(_) | Self::Control | Self::Plant => Vec::new(),
        }
    }

    /// The model that an identifier belongs to, `None` where it belongs to no model of this program;
    /// `carried` returns the files that the FMU carries.
    ///
    /// # Errors
    /// The FMU should carry a protocol and does not.
    pub fn of_token(
        version: FmiVersion,
        token: &str,
        carried: impl FnOnce() -> Result<Carried>,
    ) -> Result<Option<Self>> {
        if let Some(plain) = Self::PLAIN.into_iter().find(|m| m.token(version) == token) {
            return Ok(Some(plain));
        }
        if !token.starts_with(&format!("cordon-fmi{}:cordon_protocol", version.name())) {
            return Ok(None);
        }
        let carried = Arc::new(carried()?);
        let all = [Positions::Exact, Positions::Double, Positions::SixDigits];
        let mut models = all.into_iter().map(|p| Self::Protocol(p, carried.clone()));
        Ok(models.find(|m| m.token(version) == token))
    }
}

/// A mark that the binary in exported FMUs contains with every bit inverted, so that no other file is
/// mistaken for it.
pub const BINARY_MARK: &str = concat!("\u{7f}cordon-fmu ", env!("CARGO_PKG_VERSION"), "\u{7f}");

/// Name of a parameter that every exported unit has in addition: the exact length of a step in seconds.
pub const TAU: &str = "tau";

/// Name of a parameter that every exported unit has in addition: whether the first step uses the
/// inputs' start values. Some importers send zeros in the first step.
pub const START_INPUTS: &str = "start_inputs";

/// The default step of exported units: 0.05 s, as in the paper.
pub fn default_tau() -> Rational {
    Rational::new(1.into(), 20.into())
}

fn tau_value(exact: bool, tau: &Rational) -> Value {
    match exact {
        true => Value::Exact(Quotient::from(tau)),
        false => Value::Real(exact::to_f64(tau)),
    }
}

fn tau(exact: bool) -> Variable {
    let dimension = if exact { Dimension::NONE } else { Dimension::SECOND };
    let start = tau_value(exact, &default_tau());
    let text = "length of a communication step in seconds";
    Variable::new(TAU, dimension, Causality::Parameter, start, text)
}

/// Drone 1 of the paper's coverage run (Figs 8 and 9).
fn default_settings(exchange: Exchange) -> Settings {
    let whole = |n: i32| Rational::from_integer(n.into());
    Settings {
        law: Law::Coverage { id: 1, count: 5, min: whole(0), max: whole(100) },
        weight: Rational::new(1.into(), 5.into()),
        start: whole(10),
        period: 4,
        phase: Phase::First,
        exchange,
        on_loss: OnLoss::default(),
    }
}

impl fmt::Display for FmiVersion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
