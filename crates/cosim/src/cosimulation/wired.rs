//! The three units of each drone, and their connections.

use std::collections::BTreeSet;

use cordon_spec::graph::Graph;

use super::Cosimulation;
use super::units::port;
use crate::control;
use crate::coordination::{Coordination, OwnLaw, Slot};
use crate::faults;
use crate::master::Master;
use crate::plant;
use crate::seat::Seat;
use crate::unit::{Unit, Value};
use crate::wiring::{Port, Timing, Wiring};
use cordon_core::{Error, Rational, Result, exact};
use cordon_run::scenario::Protocol;

impl Cosimulation {
    /// The drones that a drone hears, in the order of its inputs; for coverage the end drones have only
    /// one.
    pub fn neighbours(&self, drone: usize) -> Vec<usize> {
        match &self.scenario.protocol {
            Protocol::Coverage { .. } => {
                let before = drone.checked_sub(1);
                let after = Some(drone + 1).filter(|&j| j < self.count());
                before.into_iter().chain(after).collect()
            }
            Protocol::Consensus { graph } | Protocol::Formation { graph, .. } => {
                graph.neighbourhood(drone).filter(|&j| graph.linked(drone, j)).collect()
            }
            Protocol::Own(own) => {
                let heard = OwnLaw::of(own, &self.scenario.start, drone).heard;
                heard.iter().map(|(j, _)| *j).collect::<BTreeSet<_>>().into_iter().collect()
            }
        }
    }

    /// What a drone hears: from whom, the output that is sent, and the input that receives it.
    fn heard(&self, drone: usize, position: Slot) -> Vec<(usize, Slot, Slot)> {
        let hears = |(k, j): (usize, usize)| {
            let input = match &self.scenario.protocol {
                Protocol::Coverage { .. } => Slot::Heard(usize::from(j > drone)),
                _ => Slot::Heard(k),
            };
            (j, position, input)
        };
        let Protocol::Own(own) = &self.scenario.protocol else {
            return self.neighbours(drone).into_iter().enumerate().map(hears).collect();
        };
        let law = OwnLaw::of(own, &self.scenario.start, drone);
        let sent = |v| if v == law.position { position } else { Slot::Beside(v) };
        let heard = law.heard.iter().enumerate();
        heard.map(|(k, &(j, v))| (j, sent(v), Slot::Heard(k))).collect()
    }

    /// Units and connections; every unit is at the index given by its [`Seat`].
    ///
    /// # Errors
    /// A fault that does not fit the swarm, or an FMU that does not fit its place.
    pub fn wiring(&self) -> Result<Wiring> {
        let mut wiring = self.wired_here()?;
        for substitute in &self.units {
            if let Some((name, values)) = substitute.ranges.first_key_value() {
                return Err(Error::input(format!(
                    "unit.parameters.{name}: {} values: expected one in a run: `cordon cosim` flies a run \
                     for each",
                    values.len()
                )));
            }
            let seat = Seat { drone: substitute.drone, unit: substitute.unit };
            wiring.substitute(seat.index(), |unit| self.load.load(substitute, unit))?;
        }
        Ok(wiring)
    }

    /// The units of this program and their connections.
    fn wired_here(&self) -> Result<Wiring> {
        let number = |x: &Rational| Value::Real(exact::to_f64(x));
        let mut held = vec![(control::var::Z_D, number(&self.z_d))];
        let mut desired = vec![(Slot::Desired, control::var::X_D)];
        match self.across {
            Some(_) => desired.push((Slot::DesiredAcross, control::var::Y_D)),
            None => held.push((control::var::Y_D, Value::Real(0.0))),
        }
        self.wired(&Body {
            coordination: &|i| self.coordination(i),
            control: &|i| Box::new(self.control(i)),
            plant: &|i| Box::new(self.plant(i)),
            desired,
            state: control::var::STATE..control::var::ROTORS,
            first_output: plant::var::X,
            rotors: control::var::ROTORS..control::var::LAMBDA_P,
            first_rotor: plant::var::ROTORS,
            held,
        })
    }

    pub(crate) fn wired(&self, body: &Body<'_>) -> Result<Wiring> {
        let mut wiring = Wiring::default();
        let count = self.count();
        let mut coordination = Vec::with_capacity(count);
        for i in 0..count {
            let unit = (body.coordination)(i);
            coordination.push(unit.clone());
            wiring.add(Box::new(unit));
            wiring.add((body.control)(i));
            wiring.add((body.plant)(i));
        }
        let port = |drone: usize, slot: Slot| -> Result<Port> {
            let unit = coordination.get(drone);
            let missing = || Error::internal(format!("drone {drone} of {count} has no unit"));
            port(unit.ok_or_else(missing)?, drone, slot)
        };
        let faults = faults::Plan::new(&self.faults, self.seed, count, &self.grid)?;
        let sent = coordination
            .first()
            .and_then(|u| u.index(Slot::Own))
            .map_or(Slot::Desired, |_| Slot::Own);
        for i in 0..count {
            for (j, output, input) in self.heard(i, sent) {
                let (from, to) = (port(j, output)?, port(i, input)?);
                // Positions are exchanged all at once, whatever the master, unless an order is given.
                let timing = match &self.order {
                    Some(order) if before(order, j, i) => Timing::Ordered,
                    _ => Timing::Sampled,
                };
                match faults.link(j, i) {
                    Some(link) => wiring.connect_through(from, to, timing, Box::new(link)),
                    None => wiring.connect(from, to, timing),
                }
            }
            if matches!(self.scenario.protocol, Protocol::Coverage { .. }) {
                for (end, slot) in [(0, Slot::Heard(0)), (count - 1, Slot::Heard(1))] {
                    if i == end {
                        // What an end drone would hear from beyond the line; it does not read it.
                        let at = port(i, slot)?;
                        if let Some(unit) = coordination.get(i) {
                            wiring.hold(at, unit.get(at.variable)?);
                        }
                    }
                }
            }
            for &(output, input) in &body.desired {
                let to = Port { unit: Seat::control(i).index(), variable: input };
                wiring.connect(port(i, output)?, to, Timing::Sampled);
            }
            body.connect(&mut wiring, i);
        }
        for (drone, steps) in faults.drop_outs {
            wiring.outage(Seat::coordination(drone).index(), steps);
        }
        Ok(wiring)
    }

    /// The master of the swarm's co-simulation.
    ///
    /// # Errors
    /// As for [`Cosimulation::wiring`] and [`Master::new`].
    pub fn master(&self) -> Result<Master> {
        Master::new(self.wiring()?, self.grid.clone(), self.algorithm)
    }
}

/// Whether a drone updates before another.
fn before(order: &[usize], drone: usize, other: usize) -> bool {
    let place = |i: usize| order.iter().position(|d| *d == i);
    place(drone) < place(other)
}

/// The three units of a drone, and which of their variables are connected.
pub(crate) struct Body<'b> {
    pub(crate) coordination: &'b dyn Fn(usize) -> Coordination,
    pub(crate) control: &'b dyn Fn(usize) -> Box<dyn Unit>,
    pub(crate) plant: &'b dyn Fn(usize) -> Box<dyn Unit>,
    /// The outputs that the controller follows, each with the controller's input.
    pub(crate) desired: Vec<(Slot, usize)>,
    /// The controller's inputs from the plant, and the plant's first output.
    pub(crate) state: std::ops::Range<usize>,
    pub(crate) first_output: usize,
    /// The controller's outputs, and the plant's first input.
    pub(crate) rotors: std::ops::Range<usize>,
    pub(crate) first_rotor: usize,
    /// Inputs of the controller that nothing is connected to.
    pub(crate) held: Vec<(usize, Value)>,
}

impl Body<'_> {
    fn connect(&self, wiring: &mut Wiring, drone: usize) {
        let control = |variable| Port { unit: Seat::control(drone).index(), variable };
        let plant = |variable| Port { unit: Seat::plant(drone).index(), variable };
        for (k, input) in self.state.clone().enumerate() {
            wiring.connect(plant(self.first_output + k), control(input), Timing::Sampled);
        }
        for (k, output) in self.rotors.clone().enumerate() {
            wiring.connect(control(output), plant(self.first_rotor + k), Timing::Immediate);
        }
        for (input, value) in &self.held {
            wiring.hold(control(*input), value.clone());
        }
    }
}
