//! Runs that differ in parameters of FMUs: one for each of the values that a scenario gives them.

use super::cosimulation::Cosimulation;
use super::seat::Seat;
use cordon_core::{Error, Rational, Result};
use cordon_run::scenario::{Parameter, Substitute};

/// Most runs of a batch.
const MOST_RUNS: usize = 10_000;

/// Runs of a swarm.
pub struct Batch {
    /// The parameters that have several values, `plant2.drag`.
    pub names: Vec<String>,
    /// Their values in each run, the last one changing from run to run.
    pub runs: Vec<Vec<Rational>>,
    /// Which unit each of them belongs to, and its name there.
    places: Vec<(usize, String)>,
}

impl Batch {
    /// The runs that a swarm stands for; `None` where every parameter has one value.
    ///
    /// # Errors
    /// There are more than ten thousand.
    pub fn of(swarm: &Cosimulation) -> Result<Option<Self>> {
        let ranges = |(place, unit): (usize, &Substitute)| {
            let seat = Seat { drone: unit.drone, unit: unit.unit };
            let of_unit = unit.ranges.iter().map(move |(name, values)| {
                (format!("{}.{name}", seat.name()), (place, name.clone()), values.clone())
            });
            of_unit.collect::<Vec<_>>()
        };
        let all: Vec<_> = swarm.units.iter().enumerate().flat_map(ranges).collect();
        if all.is_empty() {
            return Ok(None);
        }
        let count = all.iter().try_fold(1, |n: usize, (_, _, values)| n.checked_mul(values.len()));
        let Some(count) = count.filter(|n| *n <= MOST_RUNS) else {
            return Err(Error::input(format!(
                "unit.parameters: too many runs, one for each combination of values: expected at most \
                 {MOST_RUNS}"
            )));
        };
        let run = |k: usize| {
            let mut rest = k;
            let mut row: Vec<Rational> = Vec::with_capacity(all.len());
            for (_, _, values) in all.iter().rev() {
                row.extend(values.get(rest % values.len()).cloned());
                rest /= values.len();
            }
            row.reverse();
            row
        };
        let runs = (0..count).map(run).collect();
        let names = all.iter().map(|(name, _, _)| name.clone()).collect();
        Ok(Some(Self { names, runs, places: all.into_iter().map(|(_, p, _)| p).collect() }))
    }

    /// The swarm with the values of a run.
    pub fn swarm(&self, swarm: &Cosimulation, values: &[Rational]) -> Cosimulation {
        let mut one = swarm.clone();
        for ((place, name), value) in self.places.iter().zip(values) {
            if let Some(unit) = one.units.get_mut(*place) {
                unit.ranges.clear();
                unit.parameters.insert(name.clone(), Parameter::Number(value.clone()));
            }
        }
        one
    }
}
