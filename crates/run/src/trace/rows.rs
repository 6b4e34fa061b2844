//! Which states of a run become rows.

use num_traits::ToPrimitive;

use crate::scenario::Scenario;
use crate::simulate;
use cordon_core::exact::Rational;
use cordon_core::{Error, Result};

/// What the rows count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Protocol steps: one row an update.
    Steps,
    /// Ticks: one row a co-simulation step.
    Ticks,
}

impl Unit {
    /// The unit's name, for column heads and messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Steps => "step",
            Self::Ticks => "tick",
        }
    }
}

/// The rows `from`, `from + every`, ... up to `to`, in the given unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Selection {
    /// What is counted.
    pub unit: Unit,
    /// First row.
    pub from: u64,
    /// Last row.
    pub to: u64,
    /// Distance from row to row, at least 1.
    pub every: u64,
}

/// One shown state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Ticks so far.
    pub tick: u64,
    /// Protocol steps so far.
    pub step: u64,
    /// Ticks since the last update.
    pub timesteps: u32,
    /// Position of every drone.
    pub positions: Vec<Rational>,
}

/// The shown part of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trace<'s> {
    /// What was run.
    pub scenario: &'s Scenario,
    /// What was selected.
    pub selection: Selection,
    /// The rows, in order.
    pub rows: Vec<Row>,
}

impl Trace<'_> {
    /// The time of a row in seconds, where the scenario has a clock.
    pub fn time(&self, row: &Row) -> Option<Rational> {
        let tau = self.scenario.tau.as_ref()?;
        Some(tau * Rational::from_integer(row.tick.into()))
    }
}

/// Most rows of one trace: more is a slip of the keyboard, and would fill the memory.
const MAX_ROWS: u64 = 10_000_000;

/// Most limb operations of one trace, about ten minutes of stepping. An exact run of k steps
/// with weight p/q makes numbers of k*log2(q) bits, hence N*k^2*log2(q)/128 limb operations.
const MAX_WORK: f64 = 1e12;

/// Runs the scenario and keeps the selected rows.
///
/// # Errors
/// A selection without rows, with too many, or with a run too long to step through.
pub fn select(scenario: &Scenario, selection: Selection) -> Result<Trace<'_>> {
    let Selection { unit, from, to, every } = selection;
    if every == 0 {
        return Err(Error::input("every: `0`: expected 1 or more"));
    }
    if from > to {
        return Err(Error::input(format!("from: `{from}`: expected at most the last row, {to}")));
    }
    refuse_endless(scenario, unit, to)?;
    if (to - from) / every >= MAX_ROWS {
        return Err(Error::input(format!(
            "every: `{every}`: expected at most {MAX_ROWS} rows between {from} and {to}"
        )));
    }
    let mut rows = Vec::new();
    let mut last_step = None;
    for s in simulate::run(scenario) {
        let (at, is_new) = match unit {
            Unit::Ticks => (s.tick, true),
            // A step's row is the state right after its update.
            Unit::Steps => (s.step, last_step != Some(s.step)),
        };
        last_step = Some(s.step);
        if at > to {
            break;
        }
        if is_new && at >= from && (at - from) % every == 0 {
            rows.push(Row {
                tick: s.tick,
                step: s.step,
                timesteps: s.state.timesteps,
                positions: s.state.drones,
            });
        }
        if at == to {
            break;
        }
    }
    Ok(Trace { scenario, selection, rows })
}

fn refuse_endless(scenario: &Scenario, unit: Unit, to: u64) -> Result<()> {
    let steps = match unit {
        Unit::Steps => to as f64,
        Unit::Ticks => to as f64 / f64::from(scenario.period),
    };
    let drones = scenario.count() as f64;
    let bits = scenario.weight.denom().to_f64().unwrap_or(f64::MAX).log2().max(1.0);
    let work = drones * steps * (steps * bits / 128.0 + 1.0) + to as f64;
    if work <= MAX_WORK {
        return Ok(());
    }
    let name = unit.name();
    Err(Error::input(format!(
        "{name}s: `{to}`: expected fewer: {} drones with weight {} make numbers of {:.0} bits by then",
        scenario.count(),
        scenario.weight,
        steps * bits
    )))
}
