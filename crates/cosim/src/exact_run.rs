//! The co-simulation in exact arithmetic, and the error of the doubles.

use std::fmt;

use super::cosimulation::{Body, Cosimulation};
use super::exact_units::{ExactControl, ExactPlant, control_var, plant_var};
use super::master::Master;
use super::record::{Axis, Record, Track};
use super::seat::Seat;
use super::unit::Value;
use super::wiring::Port;
use cordon_core::{Error, Result};

/// The largest difference between the doubles of a run and the exact values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Of the desired positions.
    pub desired: Largest,
    /// Of the actual positions.
    pub actual: Largest,
}

/// A largest difference, and where it was found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Largest {
    /// Its size in m.
    pub size: f64,
    /// The drone with that difference, from 0.
    pub drone: usize,
    /// Its grid point, from 0.
    pub step: u64,
}

impl Largest {
    fn note(&mut self, size: f64, drone: usize, step: u64) {
        if size > self.size {
            *self = Self { size, drone, step };
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let one = |l: &Largest| format!("{:.3e} m (drone {}, step {})", l.size, l.drone, l.step);
        write!(
            f,
            "largest difference from the run in exact arithmetic: desired {}, actual {}",
            one(&self.desired),
            one(&self.actual)
        )
    }
}

/// The master of the swarm's co-simulation along an axis in exact arithmetic: with a desired yaw of 0
/// the loops along x and y are the same system.
///
/// # Errors
/// The swarm cannot be wired.
pub fn master(swarm: &Cosimulation, axis: Axis) -> Result<Master> {
    let start = |i: usize| swarm.start_of(i, axis);
    let wiring = swarm.wired(&Body {
        coordination: &|i| swarm.exact_coordination(i),
        control: &|i| {
            let name = Seat::control(i).name();
            Box::new(ExactControl::new(name, &swarm.lambda_p, &swarm.lambda_a))
        },
        plant: &|i| Box::new(ExactPlant::new(Seat::plant(i).name(), &start(i), swarm.integrator)),
        desired: vec![(swarm.exact_slot(axis), control_var::WANTED)],
        state: control_var::CHAIN..control_var::SNAP,
        first_output: plant_var::X,
        rotors: control_var::SNAP..control_var::SNAP + 1,
        first_rotor: plant_var::SNAP,
        held: Vec::new(),
    })?;
    Master::new(wiring, swarm.grid.clone(), swarm.algorithm)
}

/// Runs the swarm exactly and compares the result with the recorded run.
///
/// # Errors
/// The swarm cannot be wired, or the record is that of another swarm.
pub fn difference(swarm: &Cosimulation, record: &Record) -> Result<Difference> {
    let mut found = Difference { desired: Largest::default(), actual: Largest::default() };
    for (axis, track) in record.tracks() {
        along(swarm, axis, record, track, &mut found)?;
    }
    Ok(found)
}

fn along(
    swarm: &Cosimulation,
    axis: Axis,
    record: &Record,
    track: &Track,
    found: &mut Difference,
) -> Result<()> {
    let slot = swarm.exact_slot(axis);
    let port = |i| swarm.exact_port(i, slot);
    let own = (0..swarm.count()).map(port).collect::<Result<Vec<_>>>()?;
    master(swarm, axis)?.run(|master, step| {
        let row = usize::try_from(step).unwrap_or(usize::MAX);
        let pairs = record.at(&track.desired, row).iter().zip(record.at(&track.actual, row));
        for (i, ((desired, actual), own)) in pairs.zip(&own).enumerate() {
            let distance = |port: Port, x: f64| -> Result<f64> {
                match master.value(port)? {
                    Value::Exact(exact) => Ok(exact.distance_from(x)),
                    _ => Err(Error::internal("expected an exact value")),
                }
            };
            let desired = distance(*own, *desired)?;
            found.desired.note(desired, i, step);
            let plant = Port { unit: Seat::plant(i).index(), variable: plant_var::X };
            let actual = distance(plant, *actual)?;
            found.actual.note(actual, i, step);
        }
        Ok(())
    })
}
