//! One drone's part of a protocol file: the rows of its own variables.

use std::collections::BTreeSet;

use cordon_spec::{Phase, Scalar};
use num_traits::Zero;

use super::Law;
use crate::quotient::Quotient;
use crate::unit::Value;
use cordon_core::Rational;
use cordon_core::system::{Map, System};
use cordon_run::scenario::Own;

/// The state variable that is the position along the line, in m.
pub(crate) const POSITION: &str = "x";

/// Which variable of an agent is its position: `x`, or the only one.
pub(crate) fn position_of(system: &System) -> usize {
    system.variables.iter().position(|v| v.name == POSITION).unwrap_or(0)
}

/// The state variable that is the desired position across the line, in m.
pub(crate) const ACROSS: &str = "y";

/// Which variable of an agent of a planar protocol is its position across the line.
pub(crate) fn across_of(system: &System) -> Option<usize> {
    let found = system.variables.iter().position(|v| v.name == ACROSS);
    found.filter(|index| *index != position_of(system))
}

/// A protocol file's rule for one drone: the same in every step, or several in turn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OwnLaw {
    /// Names of the state variables of an agent.
    pub variables: Vec<String>,
    /// Which of them is the position.
    pub position: usize,
    /// Which of them is the position across the line, of planar protocols.
    pub across: Option<usize>,
    /// The drone's own variables at the start.
    pub start: Vec<Rational>,
    /// What it hears, as (drone, variable), in the order of its inputs.
    pub heard: Vec<(usize, usize)>,
    /// For each update in turn, a row for each variable: the constant, the coefficients of the own
    /// variables, the coefficients of what is heard.
    pub updates: Vec<Vec<[Vec<Rational>; 3]>>,
    /// The protocol and the drone, for a unit whose parameters select the drone and the values of the
    /// protocol's parameters.
    pub open: Option<(Own, usize)>,
}

impl OwnLaw {
    /// The part of one drone. Choices of the protocol are set to normal operation: every link works,
    /// every drone acts and no message is late. Faults are modelled by the flight instead.
    pub fn of(own: &Own, start: &[Rational], drone: usize) -> Self {
        let maps = own.cycle().unwrap_or_default();
        let mine = places(own, drone);
        let rows = maps.iter().flat_map(|map| map.rows.get(mine.clone()).unwrap_or_default());
        let columns = rows.flat_map(|(_, row)| row.iter().map(|(j, _)| *j));
        let others: BTreeSet<usize> = columns.filter(|j| !mine.contains(j)).collect();
        let per_agent = own.system.variables.len();
        let heard = others.iter().map(|j| (j / per_agent, j % per_agent)).collect();
        Self::hearing(own, start, drone, heard)
    }

    /// The part of a drone that hears every variable of every drone, itself included, but reads only
    /// those in its rule: such a unit can become any drone's.
    pub fn open(own: &Own, start: &[Rational], drone: usize) -> Self {
        let variables = 0..own.system.variables.len();
        let every = |j: usize| variables.clone().map(move |v| (j, v));
        let heard = (0..own.system.agents).flat_map(every).collect();
        let open = Some((own.clone(), drone));
        Self { open, ..Self::hearing(own, start, drone, heard) }
    }

    fn hearing(own: &Own, start: &[Rational], drone: usize, heard: Vec<(usize, usize)>) -> Self {
        Self {
            variables: own.system.variables.iter().map(|v| v.name.clone()).collect(),
            position: position_of(&own.system),
            across: across_of(&own.system),
            start: start.get(places(own, drone)).unwrap_or_default().to_vec(),
            updates: updates(own, drone, &heard),
            heard,
            open: None,
        }
    }

    /// Derives the rule of an open unit again, from the current values of its parameters.
    ///
    /// # Errors
    /// There is no such drone; the error is the number of drones.
    pub(super) fn settle(&mut self) -> Result<(), usize> {
        let Some((own, drone)) = &self.open else { return Ok(()) };
        if *drone >= own.system.agents {
            return Err(own.system.agents);
        }
        self.updates = updates(own, *drone, &self.heard);
        Ok(())
    }

    /// Whether a variable is a position.
    pub(super) fn is_position(&self, variable: usize) -> bool {
        variable == self.position || Some(variable) == self.across
    }

    /// The name of the input at which variable `v` of drone `j` is heard.
    pub fn input(&self, j: usize, v: usize) -> String {
        self.named(&format!("heard_{j}"), v)
    }

    /// The name of a variable that exists once per state variable: for the position it is the plain
    /// name.
    pub fn named(&self, plain: &str, v: usize) -> String {
        match self.variables.get(v).filter(|_| v != self.position) {
            Some(name) => format!("{plain}_{name}"),
            None => plain.to_owned(),
        }
    }
}

/// The indices of a drone's variables in the state.
fn places(own: &Own, drone: usize) -> std::ops::Range<usize> {
    let per_agent = own.system.variables.len();
    drone * per_agent..(drone + 1) * per_agent
}

/// The rows of a drone, for each update in turn.
fn updates(own: &Own, drone: usize, heard: &[(usize, usize)]) -> Vec<Vec<[Vec<Rational>; 3]>> {
    let per_agent = own.system.variables.len();
    let mine = places(own, drone);
    let others = heard.iter().map(|(j, v)| j * per_agent + v);
    // What it hears of itself is known already.
    let others: Vec<_> = others.map(|j| Some(j).filter(|j| !mine.contains(j))).collect();
    let coefficient = |row: &[(usize, Rational)], column: Option<usize>| {
        let found = row.iter().find(|(j, _)| Some(*j) == column);
        found.map_or_else(Rational::zero, |(_, a)| a.clone())
    };
    let of = |(constant, row): &(Rational, Vec<(usize, Rational)>)| {
        let own = mine.clone().map(|j| coefficient(row, Some(j))).collect();
        let heard = others.iter().map(|&j| coefficient(row, j)).collect();
        [vec![constant.clone()], own, heard]
    };
    let rows = |map: &Map| map.rows.get(mine.clone()).unwrap_or_default().iter().map(of).collect();
    own.cycle().unwrap_or_default().iter().map(rows).collect()
}

impl Law {
    /// Whether input `i` is a position.
    pub(super) fn hears_position(&self, i: usize) -> bool {
        match self {
            Self::Own(law) => law.heard.get(i).is_none_or(|(_, v)| law.is_position(*v)),
            _ => true,
        }
    }

    /// The variable that is the position across the line, of planar protocols.
    pub(super) fn across(&self) -> Option<usize> {
        match self {
            Self::Own(law) => law.across,
            _ => None,
        }
    }
}

/// The state machine of a drone under a protocol file.
#[derive(Clone, Debug)]
pub(super) struct OwnMachine {
    law: OwnLaw,
    limit: u32,
    /// Ticks since the last update.
    pub counter: u32,
    /// Updates made so far.
    updates: u64,
    /// The drone's own variables.
    pub state: Vec<Quotient>,
    /// Its own variables before the last update.
    before: Vec<Quotient>,
}

impl OwnMachine {
    pub fn new(law: &OwnLaw, position: Quotient, limit: u32, phase: Phase) -> Self {
        let mut state: Vec<Quotient> = law.start.iter().map(Quotient::from).collect();
        if let Some(x) = state.get_mut(law.position) {
            *x = position;
        }
        let counter = match phase {
            Phase::First => limit,
            Phase::Last => 0,
        };
        Self { law: law.clone(), limit, counter, updates: 0, before: state.clone(), state }
    }

    pub fn fires(&self) -> bool {
        self.counter == self.limit
    }

    /// Whether some rule reads an input.
    pub fn looks_at(&self, input: usize) -> bool {
        let mut rows = self.law.updates.iter().flatten();
        rows.any(|[_, _, heard]| heard.get(input).is_some_and(|a| !a.is_zero()))
    }

    /// The desired position, which is one of the state variables.
    pub fn position(&self) -> Option<&Quotient> {
        self.state.get(self.law.position)
    }

    /// One tick. `heard` is read only where the tick is an update.
    pub fn tick(&mut self, heard: &[Quotient]) {
        if !self.fires() {
            self.counter += 1;
            return;
        }
        self.counter = 0;
        let turn = self.updates % (self.law.updates.len() as u64).max(1);
        let rows = self.law.updates.get(turn as usize).map_or(&[][..], Vec::as_slice);
        let row = |[constant, own, others]: &[Vec<Rational>; 3]| {
            let constant = constant.iter().map(Quotient::from).next();
            let inputs = own.iter().zip(&self.state).chain(others.iter().zip(heard));
            inputs
                .filter(|(a, _)| !a.is_zero())
                .fold(constant.unwrap_or_else(|| Quotient::from_int(0)), |sum, (a, x)| {
                    sum + &(Quotient::from(a) * x)
                })
        };
        let next = rows.iter().map(row).collect();
        self.before = std::mem::replace(&mut self.state, next);
        self.updates += 1;
    }

    /// Undoes the last update of all variables: it was skipped.
    pub fn put_back(&mut self, own: Quotient) {
        self.state = self.before.clone();
        if let Some(x) = self.state.get_mut(self.law.position) {
            *x = own;
        }
    }

    /// The number of updates so far, and all variables.
    pub fn memory(&self) -> Vec<Value> {
        let updates = Value::Integer(i64::try_from(self.updates).unwrap_or(i64::MAX));
        let state = self.state.iter().map(|x| Value::Exact(x.clone()));
        std::iter::once(updates).chain(state).collect()
    }

    /// Restores the memory; returns whether it fits.
    pub fn recall(&mut self, memory: &[Value]) -> bool {
        let [Value::Integer(updates), state @ ..] = memory else { return false };
        let numbers = state.iter().map(|value| match value {
            Value::Exact(x) => Some(x.clone()),
            _ => None,
        });
        let numbers: Option<Vec<Quotient>> = numbers.collect();
        match (u64::try_from(*updates), numbers) {
            (Ok(updates), Some(state)) if state.len() == self.state.len() => {
                (self.updates, self.before) = (updates, state.clone());
                self.state = state;
                true
            }
            _ => false,
        }
    }
}
