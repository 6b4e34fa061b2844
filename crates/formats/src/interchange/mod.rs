//! Whole co-simulations in the formats of other tools: INTO-CPS multi-models ([`into_cps`], both
//! ways) and SSP systems ([`ssp`]).

pub mod into_cps;
mod ports;
mod read;
pub mod ssp;

pub use read::{is_system, read};

use cordon_core::exact::Rational;
use cordon_core::{Error, Result};
use cordon_cosim::cosimulation::Cosimulation;
use cordon_cosim::fmi::interface::{Model, START_INPUTS, TAU, default_tau};
use cordon_cosim::master::Algorithm;
use cordon_cosim::seat::Seat;
use cordon_cosim::unit::{Causality, Unit, Value};
use cordon_cosim::wiring::Port;
use cordon_run::scenario::{Own, UnitName};

/// Instances of exported units and their connections.
#[derive(Clone, Debug, PartialEq)]
pub struct Assembly {
    /// A title, for display.
    pub title: String,
    /// Length of a communication step in seconds.
    pub tau: Rational,
    /// Number of communication steps.
    pub steps: u64,
    /// The instances, each at the index given by its [`Seat`].
    pub instances: Vec<Instance>,
    /// From output to input.
    pub connections: Vec<(End, End)>,
}

/// An instance of an exported unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// Its name, unique in the co-simulation.
    pub name: String,
    /// The unit of this program that it is an instance of.
    pub model: Model,
    /// Parameters, and unconnected inputs, where they differ from the model's start values.
    pub settings: Vec<(String, Value)>,
}

/// One end of a connection.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct End {
    /// Index of the instance.
    pub instance: usize,
    /// Name of the variable.
    pub variable: String,
}

impl Assembly {
    /// The co-simulation of a swarm.
    ///
    /// # Errors
    /// It has features that masters of other tools lack: consensus or formation, faults, a Gauss-Seidel
    /// master.
    pub fn of(swarm: &Cosimulation) -> Result<Self> {
        expect_plain(swarm)?;
        let coordination = Model::coordination(swarm.exchange.into(), &swarm.scenario);
        let coordination = coordination.ok_or_else(|| {
            let name = swarm.scenario.protocol.name();
            Error::input(format!(
                "protocol: `{name}`: expected `coverage` or a protocol file: there is no FMU of another \
                 coordination unit"
            ))
        })?;
        let wiring = swarm.wiring()?;
        let mut instances = Vec::with_capacity(wiring.units().len());
        for (seat, unit) in Seat::all(swarm.count()).zip(wiring.units()) {
            let model = match seat.unit {
                UnitName::Coordination => coordination.clone(),
                UnitName::Control => Model::Control,
                UnitName::Plant => Model::Plant,
            };
            // The unit of a protocol file selects its drone by parameters.
            let mut settings = match swarm.open_coordination(seat.drone) {
                Some(open) if seat.unit == UnitName::Coordination => parameters(&model, &open)?,
                _ => parameters(&model, unit.as_ref())?,
            };
            if *swarm.grid.tau() != default_tau() {
                settings.push((TAU.to_owned(), model.tau_value(swarm.grid.tau())));
            }
            instances.push(Instance { name: unit.name().to_owned(), model, settings });
        }
        let end = |port: Port| -> Result<End> {
            let unit = wiring.units().get(port.unit);
            let variable = unit.and_then(|u| u.variables().get(port.variable));
            let missing = || Error::internal(format!("unit {}: expected a variable", port.unit));
            let variable = variable.ok_or_else(missing)?;
            Ok(End { instance: port.unit, variable: variable.name.clone() })
        };
        for (port, value) in wiring.held() {
            let end = end(port)?;
            let Some(instance) = instances.get_mut(end.instance) else { continue };
            let start = instance.model.variables().into_iter().find(|v| v.name == end.variable);
            if start.is_some_and(|v| v.start != *value) {
                instance.settings.push((end.variable, value.clone()));
            }
        }
        let connections = wiring
            .connections()
            .map(|(from, to)| Ok((end(from)?, end(to)?)))
            .collect::<Result<_>>()?;
        Ok(Self {
            title: swarm.scenario.title.clone(),
            tau: swarm.grid.tau().clone(),
            steps: swarm.grid.steps(),
            instances,
            connections,
        })
    }

    /// The assembly with the first value of every connected input as its start value, for importers
    /// that send something else in the first step ([`START_INPUTS`]).
    ///
    /// # Errors
    /// As for [`Assembly::of`].
    pub fn with_first_inputs(mut self, swarm: &Cosimulation) -> Result<Self> {
        let mut wiring = swarm.wiring()?;
        wiring.initialise(&swarm.grid)?;
        for ((from, _), (_, to)) in wiring.connections().zip(&self.connections) {
            let Some(unit) = wiring.units().get(from.unit) else { continue };
            let sent = unit.get(from.variable)?;
            let Some(instance) = self.instances.get_mut(to.instance) else { continue };
            let start = instance.model.variables().into_iter().find(|v| v.name == to.variable);
            if start.is_some_and(|v| v.start != sent) {
                instance.settings.push((to.variable.clone(), sent));
            }
        }
        for instance in &mut self.instances {
            instance.settings.push((START_INPUTS.to_owned(), Value::Boolean(true)));
        }
        Ok(self)
    }

    /// The models of its instances, each once, in the order of a drone's units.
    pub fn models(&self) -> Vec<&Model> {
        self.instances.iter().take(UnitName::ALL.len()).map(|i| &i.model).collect()
    }

    /// The end of the run in seconds.
    pub fn end_time(&self) -> Rational {
        &self.tau * Rational::from_integer(self.steps.into())
    }

    /// The output of an instance whose curve is of interest, if any: a position.
    pub fn position_of(instance: &Instance) -> Option<&'static str> {
        match instance.model {
            Model::Coordination(_) | Model::Protocol(..) => Some("x_d"),
            Model::Plant => Some("x"),
            Model::Control => None,
        }
    }
}

fn expect_plain(swarm: &Cosimulation) -> Result<()> {
    if swarm.algorithm != Algorithm::Jacobi {
        return Err(Error::input(format!(
            "master: `{}`: expected `jacobi`, the order of steps that other tools have",
            swarm.algorithm.name()
        )));
    }
    if swarm.order.is_some() {
        return Err(Error::input(
            "order: expected `at-once`, the order of steps that other tools have",
        ));
    }
    if let Some(substitute) = swarm.units.first() {
        return Err(Error::input(format!(
            "unit: `{}` replaces the {} of drone {}: expected units of this program only",
            substitute.fmu.display(),
            substitute.unit.name(),
            substitute.drone
        )));
    }
    if swarm.scenario.own().is_some_and(Own::is_drawn) {
        return Err(Error::input(
            "seed: choices are drawn anew in each step: expected none: exported units have no random numbers",
        ));
    }
    if swarm.faults.is_empty() {
        return Ok(());
    }
    Err(Error::input(format!(
        "fault: {} faults: expected none: other tools' connections have no faults to export to",
        swarm.faults.len()
    )))
}

/// The parameters that differ from the model's start values.
fn parameters(model: &Model, unit: &dyn Unit) -> Result<Vec<(String, Value)>> {
    let mut changed = Vec::new();
    for (index, (variable, start)) in unit.variables().iter().zip(model.variables()).enumerate() {
        if variable.causality != Causality::Parameter {
            continue;
        }
        let value = unit.get(index)?;
        if value != start.start {
            changed.push((variable.name.clone(), value));
        }
    }
    Ok(changed)
}
