//! A swarm as the user describes it, turned into 3 N units and their connections.

mod loader;
mod units;
mod wired;

use num_traits::Signed;

use super::coordination::{Exchange, OnLoss};
use super::faults;
use super::grid::Grid;
use super::master::Algorithm;
use super::own_flight;
use super::plant::Integrator;
use super::record::{Axis, Flown, Setup};
use super::seat::Seat;
use cordon_core::{Error, Rational, Result};
use cordon_run::scenario::{Fault, Flight, Protocol, Scenario, Substitute};

pub use self::loader::Loader;
pub(super) use self::wired::Body;

/// A checked co-simulation scenario.
#[derive(Clone, Debug)]
pub struct Cosimulation {
    /// The protocol, its parameters and the desired start.
    pub scenario: Scenario,
    /// The times at which units exchange values.
    pub grid: Grid,
    /// Positions of the drones at the start, in m.
    pub start: Vec<Rational>,
    /// Positions across the line, for planar protocols.
    pub across: Option<Vec<Rational>>,
    /// Gain lambda_P in 1/s.
    pub lambda_p: Rational,
    /// Gain lambda_A in 1/s.
    pub lambda_a: Rational,
    /// Desired height in m.
    pub z_d: Rational,
    /// Integrator of the plants.
    pub integrator: Integrator,
    /// How values travel within a step.
    pub algorithm: Algorithm,
    /// How positions travel between drones.
    pub exchange: Exchange,
    /// What a drone does when a message was lost.
    pub on_loss: OnLoss,
    /// The order in which drones update, each using the new positions of those before it; `None` where
    /// all update at once, as in the protocol.
    pub order: Option<Vec<usize>>,
    /// Lost and late messages, and drones that drop out, in the order of the scenario.
    pub faults: Vec<Fault>,
    /// FMUs that replace units.
    pub units: Vec<Substitute>,
    /// What loads the FMUs when the units are wired.
    pub load: Loader,
    /// Seed of all random choices.
    pub seed: u64,
    /// The variables that are recorded besides the positions: patterns over `unit.variable`.
    pub recorded_variables: Vec<String>,
    /// Whether to use the arithmetic of the recorded runs, to the last bit.
    pub recorded: bool,
}

/// Defaults of the paper's runs: communication step in s as a fraction, length of a run in s, gains.
const TAU: (i32, i32) = (1, 20);
const DURATION: i32 = 25;
const LAMBDA_P: (i32, i32) = (2, 5);
const LAMBDA_A: i32 = 4;
const Z_D: i32 = 1;

fn fraction((num, den): (i32, i32)) -> Rational {
    Rational::new(num.into(), den.into())
}

impl Cosimulation {
    /// Checks the flight settings of a scenario; those left out default to the paper's runs (tau 0.05
    /// s, 25 s, lambda_P 0.4, lambda_A 4, Euler, Jacobi).
    ///
    /// # Errors
    /// A contradictory or meaningless field, by name.
    pub fn new(scenario: Scenario, flight: Flight) -> Result<Self> {
        let tau = scenario.tau.clone().unwrap_or_else(|| fraction(TAU));
        let grid = match &flight.duration {
            Some(duration) => Grid::lasting(duration, tau)?,
            // As many whole steps as fit.
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
            load: Loader::default(),
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

    /// Whether faults and FMUs refer to drones that exist, and to links between them.
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
    /// Another integrator, master or exchange than that of the recorded runs was asked for.
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

    /// The axes along which the protocol commands the drones.
    pub fn axes(&self) -> &'static [Axis] {
        if self.across.is_some() { &[Axis::X, Axis::Y] } else { &[Axis::X] }
    }

    /// The position of a drone at the start along an axis, in m.
    pub fn start_of(&self, drone: usize, axis: Axis) -> Rational {
        let places = match axis {
            Axis::X => Some(&self.start),
            Axis::Y => self.across.as_ref(),
        };
        places.and_then(|places| places.get(drone)).cloned().unwrap_or_default()
    }

    /// The set-up of the run, for its record.
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

/// The starts given in a scenario: one position per drone, or x and y.
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

/// The order of updates given in a scenario; `None` for all at once.
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

/// A field with one of a few names; the first one is the default.
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
