//! The master: steps units along a grid and carries values between them.

use std::ops::Range;

use num_traits::ToPrimitive;
use rayon::prelude::*;

use super::grid::Grid;
use super::order;
use super::unit::{Kind, Unit, UnitError, Value, at_variable};
use super::wiring::{Connection, Link, Port, Timing, Wiring};
use cordon_core::exact::decimal_string;
use cordon_core::{Error, Result};

/// How values travel within a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Algorithm {
    /// Read all outputs, set all inputs, step all units: every value is one step old.
    #[default]
    Jacobi,
    /// Immediate connections carry the value after the source's step.
    GaussSeidel,
}

impl Algorithm {
    /// Its name in scenario files and flags.
    pub fn name(self) -> &'static str {
        match self {
            Self::Jacobi => "jacobi",
            Self::GaussSeidel => "gauss-seidel",
        }
    }

    /// The algorithm with this name.
    pub fn named(name: &str) -> Option<Self> {
        [Self::Jacobi, Self::GaussSeidel].into_iter().find(|a| a.name() == name)
    }
}

/// Number of units from which the work is spread over threads.
const PARALLEL_FROM: usize = 512;

/// Units and connections, ready to run. The step is fixed; time is an exact rational.
pub struct Master {
    grid: Grid,
    cells: Vec<Cell>,
    /// Connected outputs of every unit, at the current grid point.
    sent: Vec<Vec<Value>>,
    /// Sampled doubles without faults, at the current grid point, grouped by unit (see [`Lane`]).
    doubles: Vec<f64>,
    /// How many of them are reserved per unit.
    room: usize,
    /// Whether a unit's outputs may have changed in the last step.
    fresh: Vec<bool>,
    /// Whether some unit has an outage at some time.
    outages: bool,
    schedule: Schedule,
}

/// A unit with its incoming and outgoing connections.
struct Cell {
    unit: Box<dyn Unit>,
    /// Indices of the connected outputs.
    outputs: Vec<usize>,
    inputs: Vec<Input>,
    lane: Lane,
    outages: Vec<Range<u64>>,
}

/// The doubles that a unit sends and receives directly, without a [`Value`].
#[derive(Default)]
struct Lane {
    /// Indices of the outputs.
    outputs: Vec<usize>,
    /// Indices of the inputs.
    inputs: Vec<usize>,
    /// For each input the index of its source among the doubles of all units.
    from: Vec<usize>,
    /// Buffer for the values of the inputs.
    received: Vec<f64>,
}

struct Input {
    variable: usize,
    from: Port,
    /// Index among the source's connected outputs.
    slot: usize,
    timing: Timing,
    link: Option<Box<dyn Link>>,
}

/// The order of events in a step.
enum Schedule {
    /// All units at once.
    AtOnce,
    /// First the sampled values, as (unit, input); then the units one by one.
    InOrder { sampled: Vec<(usize, usize)>, units: Vec<usize> },
}

impl Master {
    /// Checks the wiring, initialises the units and gives every input the initial value of
    /// its source.
    ///
    /// # Errors
    /// An unknown, unconnected or doubly driven variable, a mismatch of causality, type or
    /// physical unit, an algebraic loop, or a unit that refuses: the message names unit and
    /// variable.
    pub fn new(wiring: Wiring, grid: Grid, algorithm: Algorithm) -> Result<Self> {
        wiring.check()?;
        let mut wiring = wiring;
        if algorithm == Algorithm::Jacobi {
            let immediate = wiring.connections.iter_mut().filter(|c| c.timing == Timing::Immediate);
            immediate.for_each(|c| c.timing = Timing::Sampled);
        }
        let sampled = order::connections(&wiring, |c| c.timing == Timing::Sampled)?;
        let in_order = order::units(&wiring)?;
        let all_sampled = wiring.connections.iter().all(|c| c.timing == Timing::Sampled);
        let feeds_through = wiring.connections.iter().any(|c| {
            let unit = wiring.units.get(c.from.unit);
            let variable = unit.and_then(|u| u.variables().get(c.from.variable));
            variable.is_some_and(|v| !v.feedthrough.is_empty())
        });
        let at_once = algorithm == Algorithm::Jacobi && all_sampled && !feeds_through;
        let in_order = if at_once { None } else { Some((sampled, in_order)) };
        let mut master = Self::assemble(wiring, grid, in_order)?;
        master.initialise()?;
        Ok(master)
    }

    /// `in_order` has the sampled connections and the units in their order; `None` where all units step
    /// at once.
    fn assemble(
        wiring: Wiring,
        grid: Grid,
        in_order: Option<(Vec<usize>, Vec<usize>)>,
    ) -> Result<Self> {
        let undisturbed = in_order.is_none() && wiring.outages.is_empty();
        let in_lane = |c: &Connection, units: &[Box<dyn Unit>]| {
            let variable = units.get(c.to.unit).and_then(|u| u.variables().get(c.to.variable));
            let real = variable.is_some_and(|v| v.kind() == Kind::Real);
            undisturbed && c.link.is_none() && real
        };
        let lanes: Vec<bool> =
            wiring.connections.iter().map(|c| in_lane(c, &wiring.units)).collect();
        let Wiring { units, connections, held, outages } = wiring;
        let mut cells: Vec<Cell> = units
            .into_iter()
            .map(|unit| Cell {
                unit,
                outputs: Vec::new(),
                inputs: Vec::new(),
                lane: Lane::default(),
                outages: Vec::new(),
            })
            .collect();
        for (index, steps) in outages {
            if let Some(cell) = cells.get_mut(index) {
                cell.outages = steps;
            }
        }
        let slot_of = |outputs: &mut Vec<usize>, variable: usize| {
            let known = outputs.iter().position(|o| *o == variable);
            known.unwrap_or_else(|| {
                outputs.push(variable);
                outputs.len() - 1
            })
        };
        for (c, _) in connections.iter().zip(&lanes).filter(|(_, lane)| **lane) {
            if let Some(source) = cells.get_mut(c.from.unit) {
                slot_of(&mut source.lane.outputs, c.from.variable);
            }
        }
        // Each unit reserves as many doubles as the largest needs.
        let room =
            cells.iter().map(|cell| cell.lane.outputs.len()).max().unwrap_or_default().max(1);
        let mut places = Vec::with_capacity(connections.len());
        for (c, lane) in connections.into_iter().zip(lanes) {
            let source = cells.get_mut(c.from.unit);
            let slot = source.map_or(0, |source| match lane {
                true => slot_of(&mut source.lane.outputs, c.from.variable),
                false => slot_of(&mut source.outputs, c.from.variable),
            });
            if lane && let Some(target) = cells.get_mut(c.to.unit) {
                target.lane.inputs.push(c.to.variable);
                target.lane.from.push(c.from.unit * room + slot);
                target.lane.received.push(0.0);
            } else if let Some(target) = cells.get_mut(c.to.unit) {
                places.push((c.to.unit, target.inputs.len()));
                target.inputs.push(Input {
                    variable: c.to.variable,
                    from: c.from,
                    slot,
                    timing: c.timing,
                    link: c.link,
                });
            }
        }
        for (port, value) in held {
            if let Some(cell) = cells.get_mut(port.unit) {
                cell.unit.set(port.variable, &value)?;
            }
        }
        let blank: Vec<Vec<Value>> =
            cells.iter().map(|c| vec![Value::Boolean(false); c.outputs.len()]).collect();
        let schedule = in_order.map_or(Schedule::AtOnce, |(sampled, units)| {
            let sampled = sampled.iter().filter_map(|c| places.get(*c).copied()).collect();
            Schedule::InOrder { sampled, units }
        });
        let fresh = vec![true; cells.len()];
        let outages = cells.iter().any(|c| !c.outages.is_empty());
        let doubles = vec![0.0; room * cells.len()];
        Ok(Self { grid, cells, sent: blank, doubles, room, fresh, outages, schedule })
    }

    fn initialise(&mut self) -> Result<()> {
        let grid = &self.grid;
        let lanes = self.doubles.chunks_mut(self.room);
        for ((cell, sent), lane) in self.cells.iter_mut().zip(&mut self.sent).zip(lanes) {
            cell.unit.initialise(grid)?;
            cell.send(sent, lane, grid, 0)?;
        }
        for cell in &mut self.cells {
            cell.receive_doubles(&self.doubles)?;
            for input in &cell.inputs {
                if let Some(value) = self.sent.get(input.from.unit).and_then(|s| s.get(input.slot))
                {
                    cell.unit.set(input.variable, value)?;
                }
            }
        }
        Ok(())
    }

    /// The communication grid.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The current value of a variable.
    ///
    /// # Errors
    /// There is no such variable.
    pub fn value(&self, port: Port) -> Result<Value> {
        match self.cells.get(port.unit) {
            Some(cell) => Ok(cell.unit.get(port.variable)?),
            None => Err(self.no_such_unit(port.unit)),
        }
    }

    /// The current values of numeric variables of a unit, as doubles.
    ///
    /// # Errors
    /// There is no such variable, or one is not a number or not finite at grid point `step`.
    pub fn numbers(
        &self,
        unit: usize,
        variables: &[usize],
        into: &mut [f64],
        step: u64,
    ) -> Result<()> {
        let Some(cell) = self.cells.get(unit) else {
            return Err(self.no_such_unit(unit));
        };
        Ok(cell.finite_numbers(variables, into, &self.grid, step)?)
    }

    fn no_such_unit(&self, unit: usize) -> Error {
        Error::internal(format!(
            "unit number {unit}: expected one of the {} units",
            self.cells.len()
        ))
    }

    /// Notes of the units for the user, each with the unit's name.
    pub fn notes(&self) -> Vec<String> {
        let of = |cell: &Cell| {
            let name = cell.unit.name().to_owned();
            let note = move |note: &String| format!("unit `{name}`: {note}");
            cell.unit.notes().iter().map(note).collect::<Vec<_>>()
        };
        self.cells.iter().flat_map(of).collect()
    }

    /// Runs along the whole grid. `observe` is called at every grid point, including the first and the
    /// last.
    ///
    /// # Errors
    /// A unit fails, sends a number that is not finite, or `observe` fails.
    pub fn run(&mut self, mut observe: impl FnMut(&Self, u64) -> Result<()>) -> Result<()> {
        let last = self.grid.steps();
        for step in 0..=last {
            self.sample(step)?;
            observe(self, step)?;
            if step < last {
                self.advance(step)?;
            }
        }
        Ok(())
    }

    /// Carries the sampled values, unless [`Self::advance`] does everything at once.
    fn sample(&mut self, step: u64) -> Result<()> {
        let Schedule::InOrder { sampled, .. } = &self.schedule else {
            return Ok(());
        };
        for &(unit, index) in sampled {
            carry_live(&mut self.cells, unit, index, &self.grid, step)?;
        }
        Ok(())
    }

    fn advance(&mut self, step: u64) -> Result<()> {
        match &self.schedule {
            Schedule::AtOnce => self.advance_at_once(step),
            Schedule::InOrder { units, .. } => {
                for &unit in units {
                    let immediate: Vec<usize> =
                        self.cells.get(unit).map_or_else(Vec::new, |cell| {
                            let inputs = cell.inputs.iter().enumerate();
                            let immediate = inputs.filter(|(_, i)| i.timing != Timing::Sampled);
                            immediate.map(|(index, _)| index).collect()
                        });
                    for index in immediate {
                        carry_live(&mut self.cells, unit, index, &self.grid, step)?;
                    }
                    if let Some(cell) = self.cells.get_mut(unit) {
                        cell.begin(&self.grid, step)?;
                        cell.end(&self.grid, step)?;
                    }
                }
                Ok(())
            }
        }
    }

    /// Jacobi without feedthrough: every unit reads the values of the current grid point and steps;
    /// then all publish those of the next. No unit sees another's progress, so the result does not
    /// depend on the number of threads.
    fn advance_at_once(&mut self, step: u64) -> Result<()> {
        let (grid, sent, fresh, doubles) = (&self.grid, &self.sent, &self.fresh, &self.doubles);
        let down: Vec<bool> = match self.outages {
            true => self.cells.iter().map(|c| c.is_down(step)).collect(),
            false => Vec::new(),
        };
        let begin = |cell: &mut Cell| {
            cell.receive(sent, fresh, &down, step)?;
            cell.receive_doubles(doubles)?;
            cell.begin(grid, step)
        };
        let end = |cell: &mut Cell| cell.end(grid, step);
        let many = self.cells.len() >= PARALLEL_FROM;
        match many {
            false => {
                self.cells.iter_mut().try_for_each(begin)?;
                self.cells.iter_mut().try_for_each(end)?;
            }
            true => {
                first_error(self.cells.par_iter_mut().with_min_len(64).map(begin))?;
                first_error(self.cells.par_iter_mut().with_min_len(64).map(end))?;
            }
        }
        // With outages, an input may not have what its source last sent.
        let always = self.outages;
        let send = |cell: &mut Cell, sent: &mut [Value], fresh: &mut bool, lane: &mut [f64]| {
            *fresh = always || cell.unit.moved();
            if *fresh { cell.send(sent, lane, grid, step + 1) } else { Ok(()) }
        };
        let (cells, sent, fresh, lanes) =
            (&mut self.cells, &mut self.sent, &mut self.fresh, &mut self.doubles);
        match many {
            false => {
                let lanes = lanes.chunks_mut(self.room);
                let mut cells = cells.iter_mut().zip(sent).zip(fresh).zip(lanes);
                cells
                    .try_for_each(|(((cell, sent), fresh), lane)| send(cell, sent, fresh, lane))?;
            }
            true => {
                let lanes = lanes.par_chunks_mut(self.room);
                let cells = cells.par_iter_mut().zip(sent).zip(fresh).zip(lanes);
                let cells = cells.with_min_len(64);
                first_error(
                    cells.map(|(((cell, sent), fresh), lane)| send(cell, sent, fresh, lane)),
                )?;
            }
        }
        Ok(())
    }
}

/// The first error, in the order of the units.
fn first_error(
    results: impl IndexedParallelIterator<Item = Result<(), UnitError>>,
) -> Result<(), UnitError> {
    results.find_first(Result::is_err).unwrap_or(Ok(()))
}

impl Cell {
    fn is_down(&self, step: u64) -> bool {
        self.outages.iter().any(|steps| steps.contains(&step))
    }

    fn begin(&mut self, grid: &Grid, step: u64) -> Result<(), UnitError> {
        if self.is_down(step) { Ok(()) } else { self.unit.begin_step(grid, step) }
    }

    fn end(&mut self, grid: &Grid, step: u64) -> Result<(), UnitError> {
        if self.is_down(step) { Ok(()) } else { self.unit.do_step(grid, step) }
    }

    /// Sets the inputs to the values that were sent.
    fn receive(
        &mut self,
        sent: &[Vec<Value>],
        fresh: &[bool],
        down: &[bool],
        step: u64,
    ) -> Result<(), UnitError> {
        if self.is_down(step) {
            return Ok(());
        }
        for input in &mut self.inputs {
            // The input has this value already.
            if input.link.is_none() && fresh.get(input.from.unit) == Some(&false) {
                continue;
            }
            let Some(value) = sent.get(input.from.unit).and_then(|s| s.get(input.slot)) else {
                continue;
            };
            let silent = down.get(input.from.unit).copied().unwrap_or(false);
            deliver(self.unit.as_mut(), input, value, silent, step)?;
        }
        Ok(())
    }

    /// Sets the inputs of the lane from the doubles sent by all units.
    fn receive_doubles(&mut self, doubles: &[f64]) -> Result<(), UnitError> {
        let Lane { inputs, from, received, .. } = &mut self.lane;
        for (&index, x) in from.iter().zip(received.iter_mut()) {
            *x = doubles.get(index).copied().unwrap_or_default();
        }
        self.unit.set_reals(inputs, received)
    }

    /// Puts the connected outputs into `sent`, those in the lane into `doubles`.
    fn send(
        &self,
        sent: &mut [Value],
        doubles: &mut [f64],
        grid: &Grid,
        step: u64,
    ) -> Result<(), UnitError> {
        for (&variable, slot) in self.outputs.iter().zip(sent) {
            *slot = finite(self.unit.as_ref(), variable, grid, step)?;
        }
        self.finite_numbers(&self.lane.outputs, doubles, grid, step)
    }

    /// The current values of numeric variables, refused where they are not finite.
    fn finite_numbers(
        &self,
        variables: &[usize],
        into: &mut [f64],
        grid: &Grid,
        step: u64,
    ) -> Result<(), UnitError> {
        self.unit.get_reals(variables, into)?;
        match variables.iter().zip(into).find(|(_, x)| !x.is_finite()) {
            None => Ok(()),
            Some((&variable, _)) => {
                let value = self.unit.get(variable)?;
                Err(not_finite(self.unit.as_ref(), variable, &value, grid, step))
            }
        }
    }
}

/// Carries the current value of an input's source to the input.
fn carry_live(
    cells: &mut [Cell],
    unit: usize,
    index: usize,
    grid: &Grid,
    step: u64,
) -> Result<(), UnitError> {
    let Some(from) = cells.get(unit).and_then(|c| c.inputs.get(index)).map(|i| i.from) else {
        return Ok(());
    };
    let Some(source) = cells.get(from.unit) else {
        return Ok(());
    };
    let value = finite(source.unit.as_ref(), from.variable, grid, step)?;
    let silent = source.is_down(step);
    match cells.get_mut(unit) {
        Some(cell) if !cell.is_down(step) => match cell.inputs.get_mut(index) {
            Some(input) => deliver(cell.unit.as_mut(), input, &value, silent, step),
            None => Ok(()),
        },
        _ => Ok(()),
    }
}

/// Sets an input, unless the value is lost on the way.
fn deliver(
    unit: &mut dyn Unit,
    input: &mut Input,
    value: &Value,
    silent: bool,
    step: u64,
) -> Result<(), UnitError> {
    match (&mut input.link, silent) {
        (_, true) => unit.lost(input.variable),
        (None, false) => unit.set(input.variable, value)?,
        (Some(link), false) => match link.carry(step, value) {
            Some(arrived) => unit.set(input.variable, &arrived)?,
            None => unit.lost(input.variable),
        },
    }
    Ok(())
}

/// An output's value, refused where it is a number that is not finite.
fn finite(unit: &dyn Unit, variable: usize, grid: &Grid, step: u64) -> Result<Value, UnitError> {
    let value = unit.get(variable)?;
    match value {
        Value::Real(x) if !x.is_finite() => Err(not_finite(unit, variable, &value, grid, step)),
        value => Ok(value),
    }
}

fn not_finite(
    unit: &dyn Unit,
    variable: usize,
    value: &Value,
    grid: &Grid,
    step: u64,
) -> UnitError {
    let digits = if grid.tau().denom().to_u64() == Some(1) { 0 } else { 3 };
    let time = decimal_string(&grid.time(step), digits);
    at_variable(unit, variable, format!("`{value}` at {time} s: expected a finite number"))
}
