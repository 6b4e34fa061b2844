//! Running a swarm and recording the run.

use super::collision::{Sample, Watch};
use super::coordination::Slot;
use super::cosimulation::Cosimulation;
use super::fleet::Fleet;
use super::master::Master;
use super::physics::Body;
use super::plant::{Integrator, STATE, var};
use super::record::{Axis, Height, Record, Series, Track};
use super::seat::Seat;
use super::selection;
use cordon_core::{Error, Result, exact, progress};

/// Most numbers of one record, half a gigabyte of doubles.
const MAX_NUMBERS: u128 = 1 << 26;

/// Runs a swarm from start to end. One piece of [`progress`] is a grid point.
///
/// # Errors
/// The swarm cannot be wired, a unit fails or sends a number that is not finite, or the
/// record would be too large.
pub fn run(swarm: &Cosimulation) -> Result<Record> {
    let (record, ended) = run_as_far_as_it_goes(swarm)?;
    ended.map(|()| record)
}

/// As [`run`]; where a unit fails on the way, returns the record up to then along with the error.
///
/// # Errors
/// The swarm cannot be wired, fails in its first step, or the record would be too
/// large.
pub fn run_as_far_as_it_goes(swarm: &Cosimulation) -> Result<(Record, Result<()>)> {
    match Fleet::of(swarm) {
        Some(fleet) => match together(swarm, fleet)? {
            Some(record) => Ok((record, Ok(()))),
            None => by_units(swarm),
        },
        None => by_units(swarm),
    }
}

/// The run in one loop over all drones; `None` where it fails.
fn together(swarm: &Cosimulation, mut fleet: Fleet<'_>) -> Result<Option<Record>> {
    let mut keeper = Keeper::new(swarm, Vec::new())?;
    for step in 0..=swarm.grid.steps() {
        if step > 0 && fleet.advance_to(step).is_none() {
            return Ok(None);
        }
        keeper.row.take(&fleet);
        keeper.keep(swarm, step, &[]);
    }
    Ok(Some(keeper.finish()))
}

/// The run of units under a master.
pub(super) fn by_units(swarm: &Cosimulation) -> Result<(Record, Result<()>)> {
    let wiring = swarm.wiring()?;
    let (selected, series) = selection::select(&swarm.recorded_variables, wiring.units())?;
    let mut others = vec![0.0; series.len()];
    let mut keeper = Keeper::new(swarm, series)?;
    let desired = indices(swarm)?;
    let mut master = Master::new(wiring, swarm.grid.clone(), swarm.algorithm)?;
    let ended = master.run(|master, step| {
        keeper.row.read(&desired, master, step)?;
        let mut rest = others.as_mut_slice();
        for unit in &selected {
            let values;
            (values, rest) = rest.split_at_mut(unit.variables.len());
            master.numbers(unit.unit, &unit.variables, values, step)?;
        }
        keeper.keep(swarm, step, &others);
        Ok(())
    });
    let mut record = keeper.finish();
    record.notes = master.notes();
    match ended {
        // A run file needs at least two grid points.
        Err(e) if record.rows() < 2 => Err(e),
        Err(e) => {
            record.broken_off = Some(e.to_string());
            Ok((record, Err(e)))
        }
        Ok(()) => Ok((record, Ok(()))),
    }
}

/// The record of a run, filled row by row.
struct Keeper {
    record: Record,
    row: Row,
    watch: Watch,
    /// The time as in the recorded runs, summed up in doubles.
    accumulated: f64,
}

impl Keeper {
    fn new(swarm: &Cosimulation, mut series: Vec<Series>) -> Result<Self> {
        let count = swarm.count();
        let rows = u128::from(swarm.grid.steps()) + 1;
        let a_row = count * swarm.axes().len() * 2 + series.len();
        if rows * a_row as u128 > MAX_NUMBERS {
            return Err(Error::input(format!(
                "duration: {count} drones at {rows} grid points: expected at most {MAX_NUMBERS} \
                 positions and other values"
            )));
        }
        progress::expect(swarm.grid.steps() + 1);
        // The limit above is far below `usize::MAX`.
        let rows = usize::try_from(rows).unwrap_or_default();
        let numbers = || Vec::with_capacity(rows * count);
        let track = || Track { desired: numbers(), actual: numbers() };
        series.iter_mut().for_each(|s| s.values.reserve_exact(rows));
        let record = Record {
            title: swarm.scenario.title.clone(),
            count,
            times: Vec::with_capacity(rows),
            x: track(),
            y: swarm.across.as_ref().map(|_| track()),
            height: Some(Height { desired: exact::to_f64(&swarm.z_d), actual: numbers() }),
            series,
            events: None,
            setup: Some(swarm.setup()),
            notes: Vec::new(),
            broken_off: None,
        };
        Ok(Self { record, row: Row::new(swarm), watch: swarm.watch(), accumulated: 0.0 })
    }

    /// Records the row and the values of the series at a grid point.
    fn keep(&mut self, swarm: &Cosimulation, step: u64, others: &[f64]) {
        let record = &mut self.record;
        let last = record.times.last().copied().unwrap_or_default();
        self.row.keep(record);
        record.series.iter_mut().zip(others).for_each(|(s, x)| s.values.push(*x));
        let time = if swarm.recorded { self.accumulated } else { swarm.grid.time_f64(step) };
        self.accumulated += swarm.grid.tau_f64();
        record.times.push(time);
        self.watch.next(last, &self.row.samples);
        progress::advance(1);
    }

    fn finish(mut self) -> Record {
        self.record.events = Some(self.watch.finish());
        self.record
    }
}

impl Cosimulation {
    /// The watch for collisions in this swarm.
    fn watch(&self) -> Watch {
        let tau = self.grid.tau_f64();
        match self.across {
            None => Watch::new(self.integrator, tau),
            Some(_) => Watch::in_plane(self.integrator, tau, Body::default().touching()),
        }
    }
}

/// For each drone the indices of its desired positions in its coordination unit, axis by axis.
fn indices(swarm: &Cosimulation) -> Result<Vec<Vec<usize>>> {
    let slot = |axis: &Axis| match axis {
        Axis::X => Slot::Desired,
        Axis::Y => Slot::DesiredAcross,
    };
    let of = |i| {
        let unit = swarm.coordination(i);
        let place = |axis| {
            unit.index(slot(axis)).ok_or_else(|| Error::internal("expected a desired position"))
        };
        swarm.axes().iter().map(place).collect::<Result<_>>()
    };
    (0..swarm.count()).map(of).collect()
}

/// The recorded values of all drones at a grid point.
struct Row {
    axes: &'static [Axis],
    /// Whether the drones move on straight lines between grid points, so that only positions matter.
    straight: bool,
    /// The desired positions along each axis.
    wanted: Vec<Vec<f64>>,
    samples: Vec<Vec<Sample>>,
    heights: Vec<f64>,
}

impl Row {
    fn new(swarm: &Cosimulation) -> Self {
        let (axes, count) = (swarm.axes(), swarm.count());
        Self {
            axes,
            straight: swarm.integrator == Integrator::Euler,
            wanted: vec![vec![0.0; count]; axes.len()],
            samples: vec![vec![Sample::default(); count]; axes.len()],
            heights: vec![0.0; count],
        }
    }

    /// Takes the positions from the units after a step.
    fn read(&mut self, desired: &[Vec<usize>], master: &Master, step: u64) -> Result<()> {
        // On straight lines positions are enough.
        let known = if self.straight { var::VX } else { var::X + STATE };
        let state: Vec<usize> = (var::X..known).collect();
        let mut wanted = vec![0.0; self.axes.len()];
        let mut read = [0.0; STATE];
        for (i, indices) in desired.iter().enumerate() {
            master.numbers(Seat::coordination(i).index(), indices, &mut wanted, step)?;
            master.numbers(Seat::plant(i).index(), &state, &mut read, step)?;
            for (kept, x_d) in self.wanted.iter_mut().zip(&wanted) {
                if let Some(kept) = kept.get_mut(i) {
                    *kept = *x_d;
                }
            }
            self.note(i, &read);
        }
        Ok(())
    }

    /// Takes the values from a fleet, which has all drones in one place.
    fn take(&mut self, fleet: &Fleet<'_>) {
        for (kept, desired) in self.wanted.iter_mut().zip(&fleet.desired) {
            kept.copy_from_slice(desired);
        }
        fleet.states.iter().enumerate().for_each(|(i, state)| self.note(i, state));
    }

    /// Records the motion of a drone.
    fn note(&mut self, drone: usize, state: &[f64; STATE]) {
        let [x, y, z, vx, vy, _, phi, theta, _, vphi, vtheta, _] = *state;
        let gravity = Body::default().gravity;
        for (axis, samples) in self.axes.iter().zip(&mut self.samples) {
            // A roll to the right, phi > 0, accelerates towards -y.
            let (x, v, push, angle, turning) = match axis {
                Axis::X => (x, vx, gravity, theta, vtheta),
                Axis::Y => (y, vy, -gravity, phi, vphi),
            };
            let sample = match self.straight {
                true => Sample { x, ..Sample::default() },
                false => Sample { x, v, a: push * angle, jerk: push * turning },
            };
            if let Some(kept) = samples.get_mut(drone) {
                *kept = sample;
            }
        }
        if let Some(height) = self.heights.get_mut(drone) {
            *height = z;
        }
    }

    fn keep(&self, record: &mut Record) {
        let tracks = [Some(&mut record.x), record.y.as_mut()].into_iter().flatten();
        for (track, (samples, wanted)) in tracks.zip(self.samples.iter().zip(&self.wanted)) {
            track.desired.extend_from_slice(wanted);
            track.actual.extend(samples.iter().map(|s| s.x));
        }
        if let Some(height) = &mut record.height {
            height.actual.extend_from_slice(&self.heights);
        }
    }
}
