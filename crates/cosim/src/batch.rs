//! Batches: a run for every combination of the parameter values that a scenario lists for FMUs.

use super::cosimulation::Cosimulation;
use super::seat::Seat;
use cordon_core::{Error, Rational, Result};
use cordon_run::scenario::{Parameter, Substitute};

/// Most runs of a batch.
const MOST_RUNS: usize = 10_000;

/// The runs of a batch.
pub struct Batch {
    /// The parameters with several values, such as `plant2.drag`.
    pub names: Vec<String>,
    /// Their values in each run; the last parameter changes fastest.
    pub runs: Vec<Vec<Rational>>,
    /// For each of them the index of its unit, and its name there.
    chosen: Vec<(usize, String)>,
}

impl Batch {
    /// The runs that a swarm expands to; `None` where every parameter has one value.
    ///
    /// # Errors
    /// There are more than ten thousand runs.
    pub fn of(swarm: &Cosimulation) -> Result<Option<Self>> {
        let ranges = |(index, unit): (usize, &Substitute)| {
            let seat = Seat { drone: unit.drone, unit: unit.unit };
            let of_unit = unit.ranges.iter().map(move |(name, values)| {
                (format!("{}.{name}", seat.name()), (index, name.clone()), values.clone())
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
        Ok(Some(Self { names, runs, chosen: all.into_iter().map(|(_, p, _)| p).collect() }))
    }

    /// The swarm with the parameter values of one run.
    pub fn swarm(&self, swarm: &Cosimulation, values: &[Rational]) -> Cosimulation {
        let mut one = swarm.clone();
        for ((index, name), value) in self.chosen.iter().zip(values) {
            if let Some(unit) = one.units.get_mut(*index) {
                unit.ranges.clear();
                unit.parameters.insert(name.clone(), Parameter::Number(value.clone()));
            }
        }
        one
    }
}
