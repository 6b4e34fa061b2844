//! A swarm at the user's level, turned into 3 N units and their connections.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

use cordon_spec::graph::Graph;
use num_traits::Signed;

use super::control::{self, Control, Gains};
use super::coordination::{Coordination, Exchange, Law, OnLoss, OwnLaw, Settings, Slot};
use super::faults;
#[cfg(feature = "package")]
use super::fmi::carried::Carried;
use super::grid::Grid;
use super::master::{Algorithm, Master};
use super::own_flight;
use super::plant::{self, Integrator, Plant};
use super::record::{Axis, Flown, Setup};
use super::seat::Seat;
use super::unit::{Unit, Value};
use super::wiring::{Port, Timing, Wiring};
use cordon_core::exact::{self, Rational};
use cordon_core::{Error, Result};
use cordon_run::scenario::{Fault, Flight, Protocol, Scenario, Substitute};

/// A checked co-simulation scenario.
#[derive(Clone, Debug)]
pub struct Cosimulation {
    /// The protocol, its parameters and the desired start.
    pub scenario: Scenario,
    /// When the units meet.
    pub grid: Grid,
    /// Where the drones are at the start, in m.
    pub start: Vec<Rational>,
    /// Where they are across the line, for planar protocols.
    pub across: Option<Vec<Rational>>,
    /// Gain lambda_P in 1/s.
    pub lambda_p: Rational,
    /// Gain lambda_A in 1/s.
    pub lambda_a: Rational,
    /// Wanted height in m.
    pub z_d: Rational,
    /// Integrator of the plants.
    pub integrator: Integrator,
    /// How values travel within a step.
    pub algorithm: Algorithm,
    /// How positions travel between drones.
    pub exchange: Exchange,
    /// What a drone does where a message was lost.
    pub on_loss: OnLoss,
    /// The order in which drones update, each with the new positions of those before it; `None`
    /// where all update at once, as the protocol has it.
    pub order: Option<Vec<usize>>,
    /// Lost and late messages, and drones that drop out, in the order of the scenario.
    pub faults: Vec<Fault>,
    /// FMUs in the place of units.
    pub units: Vec<Substitute>,
    /// What loads the FMUs when the units are wired.
    pub load: Loader,
    /// Seed of everything random.
    pub seed: u64,
    /// Which variables are recorded beside the positions: patterns over `unit.variable`.
    pub recorded_variables: Vec<String>,
    /// The arithmetic of the recorded runs, to the last bit.
    pub recorded: bool,
}

/// Loads an FMU in the place of a unit: the answer has the unit's name and variables.
#[derive(Clone)]
pub struct Loader(Arc<Load>);

type Load = dyn Fn(&Substitute, Box<dyn Unit>) -> Result<Box<dyn Unit>> + Send + Sync;

impl Loader {
    /// A loader that puts what `load` answers in the place of a unit.
    pub fn new(
        load: impl Fn(&Substitute, Box<dyn Unit>) -> Result<Box<dyn Unit>> + Send + Sync + 'static,
    ) -> Self {
        Self(Arc::new(load))
    }
}

impl fmt::Debug for Loader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Loader")
    }
}

/// Where nothing can load FMUs.
fn no_loader(substitute: &Substitute, unit: Box<dyn Unit>) -> Result<Box<dyn Unit>> {
    Err(Error::input(format!(
        "unit `{}`: `{}`: expected a unit of this program: nothing loads FMUs here",
        unit.name(),
        substitute.fmu.display()
    )))
}

/// Defaults of the paper's runs: seconds a tick as a fraction, seconds of a run, gains.
const TAU: (i32, i32) = (1, 20);
const DURATION: i32 = 25;
const LAMBDA_P: (i32, i32) = (2, 5);
const LAMBDA_A: i32 = 4;
const Z_D: i32 = 1;

fn fraction((num, den): (i32, i32)) -> Rational {
    Rational::new(num.into(), den.into())
}

impl Cosimulation {
    /// Checks what a scenario says about flying; what it does not say is as in the paper's
    /// runs (tau 0.05 s, 25 s, lambda_P 0.4, lambda_A 4, Euler, Jacobi).
    ///
    /// # Errors
    /// A contradictory or senseless field, by name.
    pub fn new(scenario: Scenario, flight: Flight) -> Result<Self> {
        let tau = scenario.tau.clone().unwrap_or_else(|| fraction(TAU));
        let grid = match &flight.duration {
            Some(duration) => Grid::lasting(duration, tau)?,
            // As many whole steps as there are.
            None => {
                let steps = (Rational::from_integer(DURATION.into()) / &tau).to_integer();
                Grid::new(tau, u64::try_from(steps).unwrap_or(u64::MAX))?
            }
        };
        if let (0, Some(duration)) = (grid.steps(), &flight.duration) {
            return Err(Error::input(format!(
                "duration: `{duration}`: expected at least one step, which is {} s",
                grid.tau()
            )));
        }
        if grid.steps() == 0 {
            return Err(Error::input(format!(
                "tau: `{}`: expected at most the length of the run, so that it has a step",
                grid.tau()
            )));
        }
        let count = scenario.count();
        if let Some(own) = scenario.own() {
            own_flight::refuse_what_cannot_fly(own)?;
        }
        let (start, across) = match scenario.own() {
            None => (scenario.start.clone(), None),
            Some(own) => own_flight::positions(own, &scenario.start),
        };
        let (start, across) = match (flight.start, across) {
            (None, across) => (start, across),
            (Some(given), across) => placed(given, count, across.is_some())?,
        };
        let positive = |name: &str, gain: Option<Rational>, default: Rational| match gain {
            None => Ok(default),
            Some(gain) if gain.is_positive() => Ok(gain),
            Some(gain) => {
                Err(Error::input(format!("{name}: `{gain}`: expected a positive number")))
            }
        };
        let whole = |n: i32| Rational::from_integer(n.into());
        let swarm = Self {
            lambda_p: positive("lambda_P", flight.lambda_p, fraction(LAMBDA_P))?,
            lambda_a: positive("lambda_A", flight.lambda_a, whole(LAMBDA_A))?,
            z_d: flight.z_d.unwrap_or_else(|| whole(Z_D)),
            integrator: choice("integrator", flight.integrator, &["euler", "exact"], |n| {
                Integrator::named(n)
            })?,
            algorithm: choice("master", flight.master, &["jacobi", "gauss-seidel"], |n| {
                Algorithm::named(n)
            })?,
            exchange: choice("exchange", flight.exchange, &["exact", "double"], |n| match n {
                "exact" => Some(Exchange::Exact),
                "double" => Some(Exchange::Double),
                _ => None,
            })?,
            on_loss: choice("on_loss", flight.on_loss, &["hold", "skip"], |n| match n {
                "hold" => Some(OnLoss::HoldLast),
                "skip" => Some(OnLoss::Skip),
                _ => None,
            })?,
            order: flight.order.map(|order| ordered(&order, count)).transpose()?.flatten(),
            faults: flight.faults,
            units: flight.units,
            load: Loader::new(no_loader),
            seed: flight.seed.unwrap_or_default(),
            recorded: false,
            scenario,
            grid,
            start,
            across,
            recorded_variables: Vec::new(),
        };
        swarm.check_places()?;
        Ok(swarm)
    }

    /// Whether faults and FMUs are about drones that are there, and about links between them.
    fn check_places(&self) -> Result<()> {
        let count = self.count();
        faults::Plan::new(&self.faults, self.seed, count, &self.grid)?
            .check_links(|i, j| self.neighbours(j).contains(&i))?;
        match self.units.iter().zip(1..).find(|(unit, _)| unit.drone >= count) {
            Some((unit, place)) => Err(Error::input(format!(
                "unit {place}: drone `{}`: expected 0 to {}",
                unit.drone,
                count - 1
            ))),
            None => Ok(()),
        }
    }

    /// The same swarm in the arithmetic of the authors' recorded runs.
    ///
    /// # Errors
    /// The recorded runs had another integrator, master or exchange than was asked for.
    pub fn as_recorded(mut self) -> Result<Self> {
        let expected = [
            ("integrator", self.integrator.name(), Integrator::Euler.name()),
            ("master", self.algorithm.name(), Algorithm::Jacobi.name()),
        ];
        for (field, found, wanted) in expected {
            if found != wanted {
                return Err(Error::input(format!(
                    "{field}: `{found}`: expected `{wanted}` together with `--compat recorded`"
                )));
            }
        }
        self.exchange = Exchange::SixDigits;
        self.recorded = true;
        Ok(self)
    }

    /// The number of drones.
    pub fn count(&self) -> usize {
        self.scenario.count()
    }

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

    /// The coordination unit of a drone in a run whose every value is exact.
    pub(super) fn exact_coordination(&self, drone: usize) -> Coordination {
        let settings = self.settings(drone, Exchange::Exact);
        Coordination::new(Seat::coordination(drone).name(), settings)
    }

    /// The coordination unit of a drone of a protocol file, as it is exported: its parameters say
    /// whose it is. `None` of the program's own protocols.
    #[cfg(feature = "package")]
    pub(crate) fn open_coordination(&self, drone: usize) -> Option<Coordination> {
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

    /// The exact desired position of a drone along an axis, in a run whose every value is exact.
    pub(super) fn exact_slot(&self, axis: Axis) -> Slot {
        let across = self.scenario.own().and_then(own_flight::across);
        match (axis, across) {
            (Axis::Y, Some(variable)) => Slot::Beside(variable),
            _ => Slot::Own,
        }
    }

    /// A variable of a drone's coordination unit in a run whose every value is exact.
    pub(super) fn exact_port(&self, drone: usize, slot: Slot) -> Result<Port> {
        port(&self.exact_coordination(drone), drone, slot)
    }

    /// The axes along which the protocol tells drones where to be.
    pub fn axes(&self) -> &'static [Axis] {
        if self.across.is_some() { &[Axis::X, Axis::Y] } else { &[Axis::X] }
    }

    /// Where a drone is at the start along an axis, in m.
    pub fn start_of(&self, drone: usize, axis: Axis) -> Rational {
        let places = match axis {
            Axis::X => Some(&self.start),
            Axis::Y => self.across.as_ref(),
        };
        places.and_then(|places| places.get(drone)).cloned().unwrap_or_default()
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

    /// The drones that a drone hears, in the order of its inputs; for coverage the end drones
    /// have one only.
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

    /// What a drone hears: of whom, the output that is sent, and the input that receives it.
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

    /// Units and connections; every unit is at its [`Seat`].
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
            wiring.substitute(seat.place(), |unit| (self.load.0)(substitute, unit))?;
        }
        Ok(wiring)
    }

    /// Units of this program and their connections.
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

    pub(super) fn wired(&self, body: &Body<'_>) -> Result<Wiring> {
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
            .and_then(|u| u.place(Slot::Own))
            .map_or(Slot::Desired, |_| Slot::Own);
        for i in 0..count {
            for (j, output, input) in self.heard(i, sent) {
                let (from, to) = (port(j, output)?, port(i, input)?);
                // Positions are exchanged all at once, whatever the master, unless an order is said.
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
                        // What an end drone would hear from beyond; it does not look at it.
                        let at = port(i, slot)?;
                        if let Some(unit) = coordination.get(i) {
                            wiring.hold(at, unit.get(at.variable)?);
                        }
                    }
                }
            }
            for &(output, input) in &body.desired {
                let to = Port { unit: Seat::control(i).place(), variable: input };
                wiring.connect(port(i, output)?, to, Timing::Sampled);
            }
            body.connect(&mut wiring, i);
        }
        for (drone, steps) in faults.drop_outs {
            wiring.outage(Seat::coordination(drone).place(), steps);
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

    /// What the run is made with.
    pub fn setup(&self) -> Setup {
        let segment = match &self.scenario.protocol {
            Protocol::Coverage { min, max } => Some((min.clone(), max.clone())),
            _ => None,
        };
        Setup {
            protocol: self.scenario.protocol.name().to_owned(),
            segment,
            weight: match self.scenario.own() {
                Some(own) => own.value("eps").cloned(),
                None => Some(self.scenario.weight.clone()),
            },
            period: self.scenario.period,
            tau: self.grid.tau().clone(),
            integrator: self.integrator.name().to_owned(),
            master: self.algorithm.name().to_owned(),
            order: self.order.clone(),
            recorded: self.recorded,
            fmus: self.units.iter().map(flown).collect(),
        }
    }
}

/// Starts that a scenario says: a position a drone, or x and y.
fn placed(
    given: Vec<Rational>,
    count: usize,
    planar: bool,
) -> Result<(Vec<Rational>, Option<Vec<Rational>>)> {
    let (axes, expected) = if planar { (2, "x and y") } else { (1, "one") };
    if given.len() != axes * count {
        return Err(Error::input(format!(
            "flight.start: {} positions given: expected {expected} for each of the {count} drones",
            given.len()
        )));
    }
    if !planar {
        return Ok((given, None));
    }
    let of = |axis| given.iter().skip(axis).step_by(axes).cloned().collect();
    Ok((of(0), Some(of(1))))
}

/// Whether a drone updates before another.
fn before(order: &[usize], drone: usize, other: usize) -> bool {
    let place = |i: usize| order.iter().position(|d| *d == i);
    place(drone) < place(other)
}

/// The order of updates that a scenario says; `None` for all at once.
fn ordered(text: &str, count: usize) -> Result<Option<Vec<usize>>> {
    let fail = || {
        Error::input(format!(
            "order: `{text}`: expected `at-once`, `ascending`, `descending`, or each of the \
             drones 0 to {} once, separated by commas",
            count - 1
        ))
    };
    match text {
        "at-once" => Ok(None),
        "ascending" => Ok(Some((0..count).collect())),
        "descending" => Ok(Some((0..count).rev().collect())),
        list => {
            let parsed = list.split(',').map(|d| d.trim().parse::<usize>().map_err(|_| fail()));
            let order: Vec<usize> = parsed.collect::<Result<_>>()?;
            let mut sorted = order.clone();
            sorted.sort_unstable();
            if sorted.into_iter().eq(0..count) { Ok(Some(order)) } else { Err(fail()) }
        }
    }
}

fn flown(substitute: &Substitute) -> Flown {
    let seat = Seat { drone: substitute.drone, unit: substitute.unit };
    let file = substitute.fmu.file_name().unwrap_or(substitute.fmu.as_os_str());
    Flown { unit: seat.name(), fmu: file.to_string_lossy().into_owned() }
}

fn port(unit: &Coordination, drone: usize, slot: Slot) -> Result<Port> {
    match unit.place(slot) {
        Some(variable) => Ok(Port { unit: Seat::coordination(drone).place(), variable }),
        None => Err(Error::internal(format!("unit `{}` has no variable {slot:?}", unit.name()))),
    }
}

/// The three units of a drone and which of their variables go together.
pub(super) struct Body<'b> {
    pub(super) coordination: &'b dyn Fn(usize) -> Coordination,
    pub(super) control: &'b dyn Fn(usize) -> Box<dyn Unit>,
    pub(super) plant: &'b dyn Fn(usize) -> Box<dyn Unit>,
    /// The outputs that the controller follows, each with its input there.
    pub(super) desired: Vec<(Slot, usize)>,
    /// The controller's inputs from the plant, and the plant's first output.
    pub(super) state: std::ops::Range<usize>,
    pub(super) first_output: usize,
    /// The controller's outputs, and the plant's first input.
    pub(super) rotors: std::ops::Range<usize>,
    pub(super) first_rotor: usize,
    /// Inputs of the controller that nothing is connected to.
    pub(super) held: Vec<(usize, Value)>,
}

impl Body<'_> {
    fn connect(&self, wiring: &mut Wiring, drone: usize) {
        let control = |variable| Port { unit: Seat::control(drone).place(), variable };
        let plant = |variable| Port { unit: Seat::plant(drone).place(), variable };
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

/// A field with one of a few names; the first of them by default.
fn choice<T: Default>(
    field: &str,
    name: Option<String>,
    known: &[&str],
    named: impl Fn(&str) -> Option<T>,
) -> Result<T> {
    let Some(name) = name else {
        return Ok(T::default());
    };
    named(&name).ok_or_else(|| {
        let known: Vec<_> = known.iter().map(|k| format!("`{k}`")).collect();
        Error::input(format!("{field}: `{name}`: expected {}", known.join(" or ")))
    })
}
