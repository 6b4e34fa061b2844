//! Running a swarm and keeping what happened.

use super::collision::{Sample, Watch};
use super::coordination::Slot;
use super::cosimulation::Cosimulation;
use super::master::Master;
use super::physics::Body;
use super::plant::{Integrator, var};
use super::record::{Axis, Height, Record, Track};
use super::seat::Seat;
use super::selection;
use cordon_core::{Error, Result, exact, progress};

/// Most numbers of one record, half a gigabyte of doubles.
const MAX_NUMBERS: u128 = 1 << 26;

/// Runs a swarm from its start to its end. Its pieces of [`progress`] are grid points.
///
/// # Errors
/// The swarm cannot be wired, a unit fails or sends a number that is not finite, or the
/// record would be too large.
pub fn run(swarm: &Cosimulation) -> Result<Record> {
    let (record, ended) = run_as_far_as_it_goes(swarm)?;
    ended.map(|()| record)
}

/// As [`run`]; where a unit fails on the way, what happened until then is kept beside the error.
///
/// # Errors
/// The swarm cannot be wired, fails in its first step, or the record would be too
/// large.
pub fn run_as_far_as_it_goes(swarm: &Cosimulation) -> Result<(Record, Result<()>)> {
    let count = swarm.count();
    let wiring = swarm.wiring()?;
    let (selected, mut series) = selection::select(&swarm.recorded_variables, wiring.units())?;
    let rows = u128::from(swarm.grid.steps()) + 1;
    let a_row = count * swarm.axes().len() * 2 + series.len();
    if rows * a_row as u128 > MAX_NUMBERS {
        return Err(Error::input(format!(
            "duration: {count} drones at {rows} grid points: expected at most {MAX_NUMBERS} \
             positions and other values"
        )));
    }
    let mut master = Master::new(wiring, swarm.grid.clone(), swarm.algorithm)?;
    progress::expect(swarm.grid.steps() + 1);
    // The limit above is far below what a usize holds.
    let rows = usize::try_from(rows).unwrap_or_default();
    let numbers = || Vec::with_capacity(rows * count);
    let track = || Track { desired: numbers(), actual: numbers() };
    series.iter_mut().for_each(|s| s.values.reserve_exact(rows));
    let mut record = Record {
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
    let mut row = Row::new(swarm)?;
    let mut watch = swarm.watch();
    let mut others = vec![0.0; record.series.len()];
    let mut accumulated = 0.0;
    let ended = master.run(|master, step| {
        row.read(master, step)?;
        let mut rest = others.as_mut_slice();
        for unit in &selected {
            let values;
            (values, rest) = rest.split_at_mut(unit.variables.len());
            master.numbers(unit.unit, &unit.variables, values, step)?;
        }
        // Whole rows only.
        let last = record.times.last().copied().unwrap_or_default();
        row.keep(&mut record);
        record.series.iter_mut().zip(&others).for_each(|(s, x)| s.values.push(*x));
        // The recorded runs added up their time in doubles.
        let time = if swarm.recorded { accumulated } else { master.grid().time_f64(step) };
        accumulated += master.grid().tau_f64();
        record.times.push(time);
        watch.next(last, &row.samples);
        progress::advance(1);
        Ok(())
    });
    record.events = Some(watch.finish());
    record.notes = master.notes();
    match ended {
        // A run file has two grid points at least.
        Err(e) if record.rows() < 2 => Err(e),
        Err(e) => {
            record.broken_off = Some(e.to_string());
            Ok((record, Err(e)))
        }
        Ok(()) => Ok((record, Ok(()))),
    }
}

impl Cosimulation {
    /// What looks for collisions of this swarm.
    fn watch(&self) -> Watch {
        let tau = self.grid.tau_f64();
        match self.across {
            None => Watch::new(self.integrator, tau),
            Some(_) => Watch::in_plane(self.integrator, tau, Body::default().touching()),
        }
    }
}

/// What is read at a grid point.
struct Row {
    axes: &'static [Axis],
    /// Of each drone the place of the desired positions, axis by axis, in its coordination unit.
    desired: Vec<Vec<usize>>,
    /// What is read of every plant: axis by axis the place and, unless it moves on straight lines,
    /// speed, attitude and turning; then the height.
    plant: Vec<usize>,
    wanted: Vec<Vec<f64>>,
    samples: Vec<Vec<Sample>>,
    heights: Vec<f64>,
}

impl Row {
    fn new(swarm: &Cosimulation) -> Result<Self> {
        let (axes, count) = (swarm.axes(), swarm.count());
        let slot = |axis: &Axis| match axis {
            Axis::X => Slot::Desired,
            Axis::Y => Slot::DesiredAcross,
        };
        let desired = (0..count).map(|i| {
            let unit = swarm.coordination(i);
            let place = |axis| {
                unit.place(slot(axis)).ok_or_else(|| Error::internal("expected a desired position"))
            };
            axes.iter().map(place).collect::<Result<_>>()
        });
        let mut plant = Vec::new();
        for axis in axes {
            plant.push(var::X + axis.place());
            if swarm.integrator == Integrator::Exact {
                let (attitude, turning) = match axis {
                    Axis::X => (var::THETA, var::VTHETA),
                    Axis::Y => (var::PHI, var::VPHI),
                };
                plant.extend([var::VX + axis.place(), attitude, turning]);
            }
        }
        plant.push(var::Z);
        Ok(Self {
            axes,
            desired: desired.collect::<Result<_>>()?,
            plant,
            wanted: vec![vec![0.0; count]; axes.len()],
            samples: vec![vec![Sample::default(); count]; axes.len()],
            heights: vec![0.0; count],
        })
    }

    fn read(&mut self, master: &Master, step: u64) -> Result<()> {
        let gravity = Body::default().gravity;
        let mut wanted = vec![0.0; self.axes.len()];
        let mut read = vec![0.0; self.plant.len()];
        let members = (read.len() - 1) / self.axes.len().max(1);
        for (i, (places, height)) in self.desired.iter().zip(&mut self.heights).enumerate() {
            master.numbers(Seat::coordination(i).place(), places, &mut wanted, step)?;
            master.numbers(Seat::plant(i).place(), &self.plant, &mut read, step)?;
            *height = read.last().copied().unwrap_or_default();
            let axes = self.axes.iter().zip(read.chunks(members)).zip(&wanted);
            let kept = self.samples.iter_mut().zip(&mut self.wanted);
            for (((axis, read), x_d), (samples, wanted)) in axes.zip(kept) {
                // A roll to the right, phi > 0, is a push towards -y.
                let push = match axis {
                    Axis::X => gravity,
                    Axis::Y => -gravity,
                };
                let sample = match *read {
                    [x, v, angle, turning] => {
                        Sample { x, v, a: push * angle, jerk: push * turning }
                    }
                    // Euler's motion is a straight line between the positions.
                    [x, ..] => Sample { x, ..Sample::default() },
                    [] => Sample::default(),
                };
                if let (Some(kept), Some(d)) = (samples.get_mut(i), wanted.get_mut(i)) {
                    (*kept, *d) = (sample, *x_d);
                }
            }
        }
        Ok(())
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
