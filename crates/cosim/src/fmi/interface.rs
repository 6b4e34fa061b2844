//! What an exported unit shows to importers: which unit it is, its variables, its identifier.

use std::fmt;

use cordon_spec::Phase;

use crate::control::{Control, Gains};
use crate::coordination::{Coordination, Exchange, Law, OnLoss, Settings};
use crate::fingerprint::Fingerprint;
use crate::plant::{Integrator, Plant};
use crate::quotient::Quotient;
use crate::unit::{Causality, Dimension, Resumable, Value, Variable};
use cordon_core::exact::{self, Rational};

/// A version of the FMI standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FmiVersion {
    /// FMI 2.0, of 2014.
    V2,
    /// FMI 3.0, of 2022.
    V3,
}

impl FmiVersion {
    /// The version as model descriptions say it.
    pub fn name(self) -> &'static str {
        match self {
            Self::V2 => "2.0",
            Self::V3 => "3.0",
        }
    }
}

/// A unit that can be exported.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Model {
    /// The coordination unit of the coverage protocol; positions travel as said.
    Coordination(Positions),
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
    /// As doubles: rounded once on their way.
    Double,
    /// As doubles read with six significant digits, as in the recorded runs.
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
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Coordination(Positions::Exact),
        Self::Coordination(Positions::Double),
        Self::Coordination(Positions::SixDigits),
        Self::Control,
        Self::Plant,
    ];

    /// The name of the model, which is also that of its binary: a C identifier.
    pub fn identifier(self) -> &'static str {
        match self {
            Self::Coordination(Positions::Exact) => "cordon_coordination",
            Self::Coordination(Positions::Double) => "cordon_coordination_double",
            Self::Coordination(Positions::SixDigits) => "cordon_coordination_six_digits",
            Self::Control => "cordon_control",
            Self::Plant => "cordon_plant",
        }
    }

    /// The model of that name.
    pub fn named(identifier: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|m| m.identifier() == identifier)
    }

    /// What it is, for people.
    pub fn description(self) -> &'static str {
        match self {
            Self::Coordination(Positions::Exact) => {
                "Coordination of one drone: the coverage protocol, exact positions as text p/q"
            }
            Self::Coordination(Positions::Double) => {
                "Coordination of one drone: the coverage protocol, positions as doubles"
            }
            Self::Coordination(Positions::SixDigits) => {
                "Coordination of one drone: the coverage protocol, positions read with six digits"
            }
            Self::Control => "Cascaded controller of a quadcopter near hover",
            Self::Plant => "Quadcopter near hover",
        }
    }

    /// A unit of this kind with the parameters' start values.
    pub fn unit(self, name: &str) -> Box<dyn Resumable> {
        match self {
            Self::Coordination(positions) => {
                Box::new(Coordination::new(name, default_settings(positions.into())))
            }
            Self::Control => Box::new(Control::new(name, Gains::default())),
            Self::Plant => Box::new(Plant::new(name, [0.0; 3], Integrator::default())),
        }
    }

    /// The variables that importers see: those of the unit, then [`TAU`]. A variable's value
    /// reference is its place here.
    pub fn variables(self) -> Vec<Variable> {
        let mut variables = self.unit(self.identifier()).variables().to_vec();
        variables.push(tau(self.exact_numbers()));
        variables
    }

    /// Whether its exact numbers travel as text `p/q`. Otherwise they are doubles, which stand for
    /// [simple fractions](Quotient::simplest_of).
    pub fn exact_numbers(self) -> bool {
        self == Self::Coordination(Positions::Exact)
    }

    /// The value of [`TAU`] that means so many seconds.
    pub fn tau_value(self, tau: &Rational) -> Value {
        tau_value(self.exact_numbers(), tau)
    }

    /// The parameters on which an output depends right after the initialisation.
    pub fn initial_dependencies(self, output: &str) -> &'static [&'static str] {
        match (self, output) {
            (Self::Plant, "x") => &["x0"],
            (Self::Plant, "y") => &["y0"],
            (Self::Plant, "z") => &["z0"],
            (Self::Coordination(_), "x_d" | "own") => &["start"],
            _ => &[],
        }
    }

    /// The identifier (FMI 2.0: guid; FMI 3.0: instantiationToken) with which importers make
    /// instances. It names the model and fingerprints the variables, so that a model description
    /// is never used with a binary that reads other variables into it.
    pub fn token(self, version: FmiVersion) -> String {
        let mut print = Fingerprint::default();
        for v in self.variables() {
            print.add_text(&v.name);
            print.add_text(v.dimension.0);
            print.add_text(v.causality.name());
            print.add_text(&v.kind().to_string());
            print.add_text(&v.start.to_string());
        }
        format!("cordon-fmi{}:{}:{}", version.name(), self.identifier(), print.hex())
    }
}

/// What the binary inside exported FMUs has in it, every bit turned over, so that it is not mistaken
/// for another one.
pub const BINARY_MARK: &str = concat!("\u{7f}cordon-fmu ", env!("CARGO_PKG_VERSION"), "\u{7f}");

/// Name of the parameter that every exported unit has besides its own: the length of a step in
/// seconds, exact.
pub const TAU: &str = "tau";

/// The step that exported units are made for unless told otherwise: 0.05 s, as in the paper.
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
