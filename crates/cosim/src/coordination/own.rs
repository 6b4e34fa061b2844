//! One drone's share of a protocol file: the rows of its own variables.

use cordon_spec::{Phase, Scalar};
use num_traits::Zero;

use super::Law;
use crate::quotient::Quotient;
use crate::unit::Value;
use cordon_core::Rational;

/// What a protocol file has one drone do: the same in every step, or rules in turn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OwnLaw {
    /// Names of an agent's state variables.
    pub variables: Vec<String>,
    /// Which of them is the position.
    pub position: usize,
    /// The drone's own variables at the start.
    pub start: Vec<Rational>,
    /// What it hears: of whom, which variable; in the order of its inputs.
    pub heard: Vec<(usize, usize)>,
    /// Of each update in turn a row for each variable: the constant, coefficients of the own
    /// variables, coefficients of what is heard.
    pub updates: Vec<Vec<[Vec<Rational>; 3]>>,
}

impl OwnLaw {
    /// The name of the input at which variable `v` of drone `j` is heard.
    pub fn input(&self, j: usize, v: usize) -> String {
        match self.variables.get(v).filter(|_| v != self.position) {
            Some(name) => format!("heard_{j}_{name}"),
            None => format!("heard_{j}"),
        }
    }
}

impl Law {
    /// Whether input `i` is a position.
    pub(super) fn hears_position(&self, i: usize) -> bool {
        match self {
            Self::Own(law) => law.heard.get(i).is_none_or(|(_, v)| *v == law.position),
            _ => true,
        }
    }
}

/// The machine that a drone is, by a protocol file.
#[derive(Clone, Debug)]
pub(super) struct OwnMachine {
    law: OwnLaw,
    limit: u32,
    /// Ticks since the last update.
    pub counter: u32,
    /// Updates so far.
    updates: u64,
    /// The drone's own variables.
    pub state: Vec<Quotient>,
    /// They, before the last update.
    before: Vec<Quotient>,
}

impl OwnMachine {
    pub fn new(law: &OwnLaw, position: Quotient, limit: u32, phase: Phase) -> Self {
        let mut state: Vec<Quotient> = law.start.iter().map(Quotient::from).collect();
        if let Some(place) = state.get_mut(law.position) {
            *place = position;
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

    /// One tick; the new position. `heard` is read where the tick is an update.
    pub fn tick(&mut self, heard: &[Quotient]) -> Option<Quotient> {
        if !self.fires() {
            self.counter += 1;
            return self.state.get(self.law.position).cloned();
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
        self.state.get(self.law.position).cloned()
    }

    /// Undoes the last update of every variable: it was skipped.
    pub fn put_back(&mut self, own: Quotient) {
        self.state = self.before.clone();
        if let Some(place) = self.state.get_mut(self.law.position) {
            *place = own;
        }
    }

    /// The updates so far, and all variables.
    pub fn memory(&self) -> Vec<Value> {
        let updates = Value::Integer(i64::try_from(self.updates).unwrap_or(i64::MAX));
        let state = self.state.iter().map(|x| Value::Exact(x.clone()));
        std::iter::once(updates).chain(state).collect()
    }

    /// Takes up what was remembered; whether it could.
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
