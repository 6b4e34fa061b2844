//! The units and connections of a co-simulation.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::grid::Grid;
use super::unit::{Causality, Unit, UnitError, Value, Variable, at_variable};
use cordon_core::Result;

/// A variable of a unit, by index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Port {
    /// Index of the unit.
    pub unit: usize,
    /// Index of the variable in the unit's table.
    pub variable: usize,
}

/// Which value a connection carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timing {
    /// The source's value at the beginning of the step.
    Sampled,
    /// The source's value after its step, under a Gauss-Seidel master: the source is stepped
    /// before the target. Under a Jacobi master it is sampled.
    Immediate,
    /// The source's value after its step, under any master.
    Ordered,
}

/// Carries messages along a connection; a perfect connection has no link.
pub trait Link: Send {
    /// The message that arrives at grid point `step`, when `value` is sent; `None` where it is lost.
    fn carry(&mut self, step: u64, value: &Value) -> Option<Value>;
}

/// A connection from an output to an input.
pub(super) struct Connection {
    pub(super) from: Port,
    pub(super) to: Port,
    pub(super) timing: Timing,
    pub(super) link: Option<Box<dyn Link>>,
}

/// Units and connections under construction.
#[derive(Default)]
pub struct Wiring {
    pub(super) units: Vec<Box<dyn Unit>>,
    pub(super) connections: Vec<Connection>,
    pub(super) held: Vec<(Port, Value)>,
    /// Steps in which a unit has an outage, by its index.
    pub(super) outages: BTreeMap<usize, Vec<Range<u64>>>,
}

impl Wiring {
    /// Adds a unit and returns its index.
    pub fn add(&mut self, unit: Box<dyn Unit>) -> usize {
        self.units.push(unit);
        self.units.len() - 1
    }

    /// Initialises every unit, as if it received nothing yet.
    ///
    /// # Errors
    /// A unit refuses.
    pub fn initialise(&mut self, grid: &Grid) -> Result<()> {
        Ok(self.units.iter_mut().try_for_each(|unit| unit.initialise(grid))?)
    }

    /// The units, in the order in which they were added.
    pub fn units(&self) -> &[Box<dyn Unit>] {
        &self.units
    }

    /// A variable, by the name in its unit.
    ///
    /// # Errors
    /// The unit has no such variable.
    pub fn port(&self, unit: usize, variable: &str) -> Result<Port> {
        let Some(named) = self.units.get(unit) else {
            let what = format!("expected one of the {} units", self.units.len());
            return Err(UnitError::new(&format!("number {unit}"), Some(variable), what).into());
        };
        let table = named.variables();
        match table.iter().position(|v| v.name == variable) {
            Some(index) => Ok(Port { unit, variable: index }),
            None => {
                let known: Vec<_> = table.iter().map(|v| v.name.as_str()).collect();
                let what = format!("is unknown: expected one of {}", known.join(", "));
                Err(UnitError::new(named.name(), Some(variable), what).into())
            }
        }
    }

    /// Connects an output to an input.
    pub fn connect(&mut self, from: Port, to: Port, timing: Timing) {
        self.connections.push(Connection { from, to, timing, link: None });
    }

    /// Connects an output to an input through a link.
    pub fn connect_through(&mut self, from: Port, to: Port, timing: Timing, link: Box<dyn Link>) {
        self.connections.push(Connection { from, to, timing, link: Some(link) });
    }

    /// Holds an unconnected input at a value.
    pub fn hold(&mut self, input: Port, value: Value) {
        self.held.push((input, value));
    }

    /// Gives a unit an outage in some steps: it does not advance, and what it sends is lost.
    pub fn outage(&mut self, unit: usize, steps: Range<u64>) {
        self.outages.entry(unit).or_default().push(steps);
    }

    /// Replaces a unit. The new one must have the same variables.
    ///
    /// # Errors
    /// The new unit cannot be created.
    pub fn substitute(
        &mut self,
        index: usize,
        other: impl FnOnce(Box<dyn Unit>) -> Result<Box<dyn Unit>>,
    ) -> Result<()> {
        if index < self.units.len() {
            let unit = self.units.remove(index);
            self.units.insert(index, other(unit)?);
        }
        Ok(())
    }

    /// The connections, each from an output to an input.
    pub fn connections(&self) -> impl Iterator<Item = (Port, Port)> {
        self.connections.iter().map(|c| (c.from, c.to))
    }

    /// The unconnected inputs, with the values that they are held at.
    pub fn held(&self) -> impl Iterator<Item = (Port, &Value)> {
        self.held.iter().map(|(port, value)| (*port, value))
    }

    /// Checks everything that can be checked before the run.
    pub(super) fn check(&self) -> Result<()> {
        self.check_names()?;
        let mut driven = BTreeSet::new();
        for c in &self.connections {
            self.check_connection(c)?;
            self.check_driven_once(&mut driven, c.to)?;
        }
        for (port, value) in &self.held {
            let input = self.expect(*port, Causality::Input)?;
            if input.kind() != value.kind() {
                let what = format!("`{value}`: expected {}, found {}", input.kind(), value.kind());
                return Err(self.at(*port, what));
            }
            self.check_driven_once(&mut driven, *port)?;
        }
        for (index, unit) in self.units.iter().enumerate() {
            for (variable, v) in unit.variables().iter().enumerate() {
                let port = Port { unit: index, variable };
                if v.causality == Causality::Input && !driven.contains(&port) {
                    let what = "is an input that nothing is connected to: expected a connection or a value to hold";
                    return Err(self.at(port, what));
                }
            }
        }
        Ok(())
    }

    fn check_names(&self) -> Result<()> {
        let mut names = BTreeSet::new();
        for unit in &self.units {
            if !names.insert(unit.name()) {
                let what = "is the name of two units: expected different names";
                return Err(UnitError::new(unit.name(), None, what).into());
            }
        }
        Ok(())
    }

    fn check_connection(&self, c: &Connection) -> Result<()> {
        let (from, to) =
            (self.expect(c.from, Causality::Output)?, self.expect(c.to, Causality::Input)?);
        let source = self.full_name(c.from);
        if from.kind() != to.kind() {
            let what = format!("expected {}, found {} from {source}", to.kind(), from.kind());
            return Err(self.at(c.to, what));
        }
        if from.dimension != to.dimension {
            let what = format!(
                "expected a value in `{}`, found one in `{}` from {source}",
                to.dimension, from.dimension
            );
            return Err(self.at(c.to, what));
        }
        Ok(())
    }

    fn check_driven_once(&self, driven: &mut BTreeSet<Port>, input: Port) -> Result<()> {
        if driven.insert(input) {
            Ok(())
        } else {
            Err(self.at(input, "is driven twice: expected one connection or one value to hold"))
        }
    }

    fn expect(&self, port: Port, causality: Causality) -> Result<&Variable> {
        let variable = self.units.get(port.unit).and_then(|u| u.variables().get(port.variable));
        match variable {
            Some(v) if v.causality == causality => Ok(v),
            Some(v) => {
                let what = format!("is {}: expected {}", v.causality.name(), causality.name());
                Err(self.at(port, what))
            }
            None => Err(self.at(port, "is unknown: expected a variable of the unit")),
        }
    }

    /// An error about a variable.
    pub(super) fn at(&self, port: Port, what: impl Into<String>) -> cordon_core::Error {
        match self.units.get(port.unit) {
            Some(unit) => at_variable(unit.as_ref(), port.variable, what).into(),
            None => {
                let what = format!("expected one of the {} units", self.units.len());
                UnitError::new(&format!("number {}", port.unit), None, what).into()
            }
        }
    }

    /// Unit and variable, as messages name them: `plant0.x`.
    pub(super) fn full_name(&self, port: Port) -> String {
        let named = self.units.get(port.unit).and_then(|u| {
            let v = u.variables().get(port.variable)?;
            Some(format!("`{}.{}`", u.name(), v.name))
        });
        named.unwrap_or_else(|| format!("`{}.{}`", port.unit, port.variable))
    }
}
