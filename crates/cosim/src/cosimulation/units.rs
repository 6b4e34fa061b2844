//! The units of a drone.

use super::Cosimulation;
use crate::control::{Control, Gains};
use crate::coordination::{Coordination, Exchange, Law, OwnLaw, Settings, Slot};
use crate::fmi::carried::Carried;
use crate::own_flight;
use crate::plant::Plant;
use crate::record::Axis;
use crate::seat::Seat;
use crate::unit::Unit;
use crate::wiring::Port;
use cordon_core::{Error, Result, exact};
use cordon_run::scenario::Protocol;

impl Cosimulation {
    /// The coordination unit of a drone.
    pub fn coordination(&self, drone: usize) -> Coordination {
        Coordination::new(Seat::coordination(drone).name(), self.settings(drone, self.exchange))
    }

    fn settings(&self, drone: usize, exchange: Exchange) -> Settings {
        let law = match &self.scenario.protocol {
            Protocol::Coverage { min, max } => {
                Law::Coverage { id: drone, count: self.count(), min: min.clone(), max: max.clone() }
            }
            Protocol::Consensus { .. } => Law::Consensus { neighbours: self.neighbours(drone) },
            Protocol::Formation { displacement, .. } => Law::Formation {
                neighbours: self.neighbours(drone),
                displacement: displacement.get(drone).cloned().unwrap_or_default(),
            },
            Protocol::Own(own) => Law::Own(Box::new(OwnLaw::of(own, &self.scenario.start, drone))),
        };
        let start = match &law {
            Law::Own(law) => law.start.get(law.position),
            _ => self.scenario.start.get(drone),
        };
        let start = start.cloned().unwrap_or_default();
        Settings {
            law,
            weight: self.scenario.weight.clone(),
            start,
            period: self.scenario.period,
            phase: self.scenario.phase,
            exchange,
            on_loss: self.on_loss,
        }
    }

    /// The coordination unit of a drone in a run in exact arithmetic.
    pub(crate) fn exact_coordination(&self, drone: usize) -> Coordination {
        let settings = self.settings(drone, Exchange::Exact);
        Coordination::new(Seat::coordination(drone).name(), settings)
    }

    /// The coordination unit of a drone of a protocol file, as exported: its parameters select the
    /// drone. `None` for the built-in protocols.
    pub fn open_coordination(&self, drone: usize) -> Option<Coordination> {
        let carried = Carried::of(&self.scenario)?;
        let settings = carried.settings(drone, self.exchange, self.on_loss);
        Some(Coordination::new(Seat::coordination(drone).name(), settings))
    }

    /// A variable of a drone's coordination unit.
    ///
    /// # Errors
    /// The unit has no such variable.
    pub fn port(&self, drone: usize, slot: Slot) -> Result<Port> {
        port(&self.coordination(drone), drone, slot)
    }

    /// The variable with the exact desired position of a drone along an axis, in a run in exact
    /// arithmetic.
    pub(crate) fn exact_slot(&self, axis: Axis) -> Slot {
        let across = self.scenario.own().and_then(own_flight::across);
        match (axis, across) {
            (Axis::Y, Some(variable)) => Slot::Beside(variable),
            _ => Slot::Own,
        }
    }

    /// A variable of a drone's coordination unit in a run in exact arithmetic.
    pub(crate) fn exact_port(&self, drone: usize, slot: Slot) -> Result<Port> {
        port(&self.exact_coordination(drone), drone, slot)
    }

    /// The controller of a drone.
    pub fn control(&self, drone: usize) -> Control {
        let gains = Gains {
            position: exact::to_f64(&self.lambda_p),
            attitude: exact::to_f64(&self.lambda_a),
        };
        let control = Control::new(Seat::control(drone).name(), gains);
        if self.recorded { control.as_recorded() } else { control }
    }

    /// The plant of a drone.
    pub fn plant(&self, drone: usize) -> Plant {
        let place = |axis| exact::to_f64(&self.start_of(drone, axis));
        let start = [place(Axis::X), place(Axis::Y), 0.0];
        Plant::new(Seat::plant(drone).name(), start, self.integrator)
    }
}

pub(super) fn port(unit: &Coordination, drone: usize, slot: Slot) -> Result<Port> {
    match unit.index(slot) {
        Some(variable) => Ok(Port { unit: Seat::coordination(drone).index(), variable }),
        None => Err(Error::internal(format!("unit `{}` has no variable {slot:?}", unit.name()))),
    }
}
