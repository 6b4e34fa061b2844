//! Running a swarm and keeping what happened.

use super::collision::{Sample, Watch};
use super::coordination::Slot;
use super::cosimulation::Cosimulation;
use super::physics::Body;
use super::plant::{Integrator, var};
use super::record::Record;
use super::seat::Seat;
use super::wiring::Port;
use cordon_core::{Error, Result, progress};

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
    let rows = u128::from(swarm.grid.steps()) + 1;
    if rows * count as u128 * 2 > MAX_NUMBERS {
        return Err(Error::input(format!(
            "duration: {count} drones at {rows} grid points: expected at most {} positions",
            MAX_NUMBERS
        )));
    }
    let mut master = swarm.master()?;
    progress::expect(swarm.grid.steps() + 1);
    // The limit above is far below what a usize holds.
    let numbers = usize::try_from(rows).unwrap_or_default() * count;
    let mut record = Record {
        title: swarm.scenario.title.clone(),
        count,
        times: Vec::with_capacity(numbers / count.max(1)),
        desired: Vec::with_capacity(numbers),
        actual: Vec::with_capacity(numbers),
        events: None,
        setup: Some(swarm.setup()),
        notes: Vec::new(),
        broken_off: None,
    };
    let desired = (0..count).map(|i| swarm.port(i, Slot::Desired)).collect::<Result<Vec<_>>>()?;
    let mut watch = Watch::new(swarm.integrator, swarm.grid.tau_f64());
    let gravity = Body::default().gravity;
    let mut samples = vec![Sample::default(); count];
    let mut accumulated = 0.0;
    let ended = master.run(|master, step| {
        let last = record.times.last().copied().unwrap_or_default();
        let mut wanted = Vec::with_capacity(count);
        for (i, (sample, desired)) in samples.iter_mut().zip(&desired).enumerate() {
            wanted.push(master.number(*desired, step)?);
            let plant = |variable| Port { unit: Seat::plant(i).place(), variable };
            let number = |variable| master.number(plant(variable), step);
            sample.x = number(var::X)?;
            // Euler's motion is a straight line between the positions.
            if swarm.integrator == Integrator::Exact {
                sample.v = number(var::VX)?;
                sample.a = gravity * number(var::THETA)?;
                sample.jerk = gravity * number(var::VTHETA)?;
            }
        }
        // Whole rows only.
        record.desired.extend(wanted);
        record.actual.extend(samples.iter().map(|s| s.x));
        // The recorded runs added up their time in doubles.
        let time = if swarm.recorded { accumulated } else { master.grid().time_f64(step) };
        accumulated += master.grid().tau_f64();
        record.times.push(time);
        watch.next(last, &samples);
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
