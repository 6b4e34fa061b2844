//! The coordination unit: one drone's part of a protocol, by executing the spec.
//!
//! Positions are exact inside. Where units [exchange](Exchange) exact numbers, N of them under a master
//! that exchanges after every tick compute exactly the spec's global run (the projection theorem); the
//! double for the controller is rounded once, at the output.

mod machine;
pub(crate) mod own;
mod table;

use cordon_spec::Phase;

use self::machine::Machine;
use super::grid::Grid;
use super::quotient::Quotient;
use super::unit::{
    Kind, Resumable, Unit, UnitError, Value, Variable, at_variable, no_memory, no_such_variable,
    not_settable, wrong_kind,
};
use cordon_core::exact::{self, Rational};

pub use self::own::OwnLaw;
pub use self::table::Slot;

/// How positions travel from coordination unit to coordination unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Exchange {
    /// As exact rationals: the run is the spec's run.
    #[default]
    Exact,
    /// As doubles, each taken as the exact number that it represents.
    Double,
    /// As doubles parsed from decimal text with six significant digits (C's `%g`), as in the recorded
    /// runs; outputs are double(numerator)/double(denominator).
    SixDigits,
}

impl Exchange {
    /// The type of the neighbours' positions.
    pub fn kind(self) -> Kind {
        match self {
            Self::Exact => Kind::Exact,
            Self::Double | Self::SixDigits => Kind::Real,
        }
    }

    /// A parameter's value in units with this exchange: exact where positions are, otherwise a double
    /// that stands for a [simple fraction](Quotient::simplest_of).
    pub fn parameter(self, x: &Rational) -> Value {
        match self {
            Self::Exact => Value::Exact(Quotient::from(x)),
            Self::Double | Self::SixDigits => Value::Real(exact::to_f64(x)),
        }
    }

    /// A received position as an exact number; `None` where it is not finite or of another type.
    fn receive(self, value: &Value) -> Option<Quotient> {
        match (self, value) {
            (Self::Exact, Value::Exact(x)) => Some(x.clone()),
            (Self::Double, Value::Real(x)) => Quotient::from_f64(*x),
            (Self::SixDigits, Value::Real(x)) if x.is_finite() => {
                let text = format!("{x:.5e}");
                exact::parse("position", &text).ok().map(|r| Quotient::from(&r))
            }
            _ => None,
        }
    }

    /// A number as it is sent to other drones.
    fn send(self, x: &Quotient) -> Value {
        match self {
            Self::Exact => Value::Exact(x.clone()),
            Self::Double | Self::SixDigits => Value::Real(self.round(x)),
        }
    }

    /// The position as a double.
    fn round(self, x: &Quotient) -> f64 {
        match self {
            Self::Exact | Self::Double => x.to_f64(),
            Self::SixDigits => x.to_f64_by_terms(),
        }
    }
}

/// What a drone does when a message was lost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OnLoss {
    /// It keeps using the position last received.
    #[default]
    HoldLast,
    /// It skips the update, if one is due in this step.
    Skip,
}

/// The protocol, and the drone's place in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Law {
    /// Equation 10. Inputs `prec` and `foll`; the end drones ignore one of them.
    Coverage {
        /// Identifier in `0 .. count`.
        id: usize,
        /// Number of drones in the line, at least 3.
        count: usize,
        /// Left end of the segment.
        min: Rational,
        /// Right end of the segment.
        max: Rational,
    },
    /// Equation 6. Inputs `heard_j`, one per neighbour.
    Consensus {
        /// Identifiers of the neighbours.
        neighbours: Vec<usize>,
    },
    /// Equation 8. Inputs as for consensus.
    Formation {
        /// Identifiers of the neighbours.
        neighbours: Vec<usize>,
        /// Sum of the desired displacements from the neighbours, in m.
        displacement: Rational,
    },
    /// A protocol file's rule for this drone. Inputs `heard_j` and, for variables other than the
    /// position, `heard_j_v`.
    Own(Box<OwnLaw>),
}

/// The settings of a coordination unit, fixed before the run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    /// The protocol, and the drone's place in it.
    pub law: Law,
    /// Weight eps of the neighbours, dimensionless.
    pub weight: Rational,
    /// Desired position at the start, in m.
    pub start: Rational,
    /// Ticks (communication steps) from one update to the next, at least 1.
    pub period: u32,
    /// The tick of the first update.
    pub phase: Phase,
    /// How positions travel to other drones: exactly, or as doubles.
    pub exchange: Exchange,
    /// What the drone does when a message was lost.
    pub on_loss: OnLoss,
}

/// The coordination unit of one drone.
#[derive(Clone, Debug)]
pub struct Coordination {
    name: String,
    settings: Settings,
    variables: std::sync::Arc<[Variable]>,
    slots: std::sync::Arc<[Slot]>,
    /// The neighbours' positions as last received.
    heard: Vec<Value>,
    machine: Machine,
    /// The drone's own position: exact, and as the doubles of the outputs, including the one across the
    /// line.
    own: Quotient,
    x_d: f64,
    y_d: f64,
    missed: bool,
    moved: bool,
}

impl Coordination {
    /// A coordination unit at its start, called `name` in messages.
    pub fn new(name: impl Into<String>, settings: Settings) -> Self {
        let (variables, slots) = table::table(&settings);
        let heard = table::starts(&settings);
        let own = Quotient::from(&settings.start);
        let mut unit = Self {
            name: name.into(),
            machine: Machine::new(&settings),
            variables,
            slots,
            heard,
            own,
            x_d: 0.0,
            y_d: 0.0,
            settings,
            missed: false,
            moved: true,
        };
        unit.round();
        unit
    }

    /// Rounds the current position to the doubles of the outputs.
    fn round(&mut self) {
        let exchange = self.settings.exchange;
        self.x_d = exchange.round(&self.own);
        let across = self.settings.law.across().and_then(|v| self.machine.beside(v));
        self.y_d = across.map_or(0.0, |y| exchange.round(y));
    }

    /// The settings, including changes made through parameters.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The index of a variable in the table.
    pub fn index(&self, slot: Slot) -> Option<usize> {
        self.slots.iter().position(|s| *s == slot)
    }

    fn exact(&self, variable: usize, value: &Value) -> Result<Rational, UnitError> {
        let expected = self.settings.exchange.kind();
        match value {
            Value::Exact(x) if expected == Kind::Exact => Ok(x.to_rational()),
            Value::Real(x) if expected == Kind::Real => match Quotient::simplest_of(*x) {
                Some(fraction) => Ok(fraction.to_rational()),
                None => {
                    let what = format!("`{x}`: expected a finite number");
                    Err(at_variable(self, variable, what))
                }
            },
            other => Err(wrong_kind(self, variable, expected, other)),
        }
    }

    fn whole(&self, variable: usize, value: &Value, least: i64) -> Result<u32, UnitError> {
        match value {
            Value::Integer(n) => match u32::try_from(*n) {
                Ok(whole) if *n >= least => Ok(whole),
                _ => {
                    let what = format!("`{n}`: expected {least} to {}", u32::MAX);
                    Err(at_variable(self, variable, what))
                }
            },
            other => Err(wrong_kind(self, variable, Kind::Integer, other)),
        }
    }

    fn set_parameter(
        &mut self,
        variable: usize,
        slot: Slot,
        value: &Value,
    ) -> Result<(), UnitError> {
        match slot {
            Slot::Weight => self.settings.weight = self.exact(variable, value)?,
            Slot::Start => self.settings.start = self.exact(variable, value)?,
            Slot::StartOf(v) => {
                let start = self.exact(variable, value)?;
                if let Law::Own(law) = &mut self.settings.law
                    && let Some(own) = law.start.get_mut(v)
                {
                    *own = start;
                }
            }
            Slot::Constant(k) => {
                let value = self.exact(variable, value)?;
                if let Law::Own(law) = &mut self.settings.law
                    && let Some((own, _)) = &mut law.open
                {
                    own.set(k, value);
                }
            }
            Slot::Period => self.settings.period = self.whole(variable, value, 1)?,
            Slot::FirstUpdate => {
                let is_exact = self.settings.exchange == Exchange::Exact;
                self.settings.phase = match value {
                    Value::Text(text) if is_exact => match &**text {
                        "first" => Phase::First,
                        "last" => Phase::Last,
                        other => {
                            let what = format!("`{other}`: expected `first` or `last`");
                            return Err(at_variable(self, variable, what));
                        }
                    },
                    Value::Boolean(false) if !is_exact => Phase::First,
                    Value::Boolean(true) if !is_exact => Phase::Last,
                    other => {
                        let expected = if is_exact { Kind::Text } else { Kind::Boolean };
                        return Err(wrong_kind(self, variable, expected, other));
                    }
                };
            }
            Slot::SkipLost => {
                let Value::Boolean(skip) = value else {
                    return Err(wrong_kind(self, variable, Kind::Boolean, value));
                };
                self.settings.on_loss = if *skip { OnLoss::Skip } else { OnLoss::HoldLast };
            }
            Slot::Id | Slot::Count => {
                let whole = self.whole(variable, value, 0)? as usize;
                match &mut self.settings.law {
                    Law::Coverage { id, count, .. } => {
                        *(if slot == Slot::Id { id } else { count }) = whole;
                    }
                    Law::Own(law) => {
                        if let Some((_, drone)) = &mut law.open {
                            *drone = whole;
                        }
                    }
                    Law::Consensus { .. } | Law::Formation { .. } => {}
                }
            }
            Slot::Min | Slot::Max => {
                let end = self.exact(variable, value)?;
                if let Law::Coverage { min, max, .. } = &mut self.settings.law {
                    *(if slot == Slot::Min { min } else { max }) = end;
                }
            }
            Slot::Displacement => {
                let sum = self.exact(variable, value)?;
                if let Law::Formation { displacement, .. } = &mut self.settings.law {
                    *displacement = sum;
                }
            }
            Slot::Heard(_) | Slot::Desired | Slot::DesiredAcross | Slot::Own | Slot::Beside(_) => {
                return Err(not_settable(self, variable));
            }
        }
        Ok(())
    }

    fn parameter(&self, slot: Slot) -> Option<Value> {
        let exact = |x: &Rational| self.settings.exchange.parameter(x);
        let whole = |n: usize| i64::try_from(n).ok().map(Value::Integer);
        let s = &self.settings;
        match (slot, &s.law) {
            (Slot::Weight, _) => Some(exact(&s.weight)),
            (Slot::Start, _) => Some(exact(&s.start)),
            (Slot::Period, _) => Some(Value::Integer(s.period.into())),
            (Slot::FirstUpdate, _) => Some(table::phase_value(s.exchange, s.phase)),
            (Slot::SkipLost, _) => Some(Value::Boolean(s.on_loss == OnLoss::Skip)),
            (Slot::Id, Law::Coverage { id, .. }) => whole(*id),
            (Slot::Count, Law::Coverage { count, .. }) => whole(*count),
            (Slot::Min, Law::Coverage { min, .. }) => Some(exact(min)),
            (Slot::Max, Law::Coverage { max, .. }) => Some(exact(max)),
            (Slot::Displacement, Law::Formation { displacement, .. }) => Some(exact(displacement)),
            (Slot::StartOf(v), Law::Own(law)) => law.start.get(v).map(exact),
            (Slot::Id, Law::Own(law)) => whole(law.open.as_ref()?.1),
            (Slot::Constant(k), Law::Own(law)) => {
                law.open.as_ref()?.0.constants().nth(k).map(|(_, x)| exact(x))
            }
            _ => None,
        }
    }
}

impl Unit for Coordination {
    fn name(&self) -> &str {
        &self.name
    }

    fn variables(&self) -> &[Variable] {
        &self.variables
    }

    fn set(&mut self, variable: usize, value: &Value) -> Result<(), UnitError> {
        let Some(&slot) = self.slots.get(variable) else {
            return Err(no_such_variable(self, variable));
        };
        let Slot::Heard(i) = slot else {
            return self.set_parameter(variable, slot, value);
        };
        if value.kind() != self.settings.exchange.kind() {
            return Err(wrong_kind(self, variable, self.settings.exchange.kind(), value));
        }
        match self.heard.get_mut(i) {
            Some(heard) => *heard = value.clone(),
            None => return Err(no_such_variable(self, variable)),
        }
        Ok(())
    }

    fn get(&self, variable: usize) -> Result<Value, UnitError> {
        let value = match self.slots.get(variable) {
            Some(Slot::Heard(i)) => self.heard.get(*i).cloned(),
            Some(Slot::Desired) => Some(Value::Real(self.x_d)),
            Some(Slot::DesiredAcross) => Some(Value::Real(self.y_d)),
            Some(Slot::Own) => Some(Value::Exact(self.own.clone())),
            Some(Slot::Beside(v)) => {
                self.machine.beside(*v).map(|x| self.settings.exchange.send(x))
            }
            Some(slot) => self.parameter(*slot),
            None => None,
        };
        value.ok_or_else(|| no_such_variable(self, variable))
    }

    fn get_reals(&self, variables: &[usize], into: &mut [f64]) -> Result<(), UnitError> {
        for (&variable, x) in variables.iter().zip(into) {
            *x = match self.slots.get(variable) {
                Some(Slot::Desired) => self.x_d,
                Some(Slot::DesiredAcross) => self.y_d,
                _ => self.get(variable)?.to_f64().unwrap_or(f64::NAN),
            };
        }
        Ok(())
    }

    fn initialise(&mut self, _: &Grid) -> Result<(), UnitError> {
        let beyond = match &mut self.settings.law {
            Law::Coverage { id, count, .. } => (*id >= *count).then_some((*id, *count)),
            Law::Own(law) => {
                let settled = law.settle().err();
                settled.zip(law.open.as_ref()).map(|(count, (_, id))| (*id, count))
            }
            Law::Consensus { .. } | Law::Formation { .. } => None,
        };
        if let Some((id, count)) = beyond {
            let index = self.index(Slot::Id).unwrap_or(usize::MAX);
            let what = format!("`{id}`: expected less than the number of drones, `{count}`");
            return Err(at_variable(self, index, what));
        }
        self.machine = Machine::new(&self.settings);
        self.own = Quotient::from(&self.settings.start);
        self.round();
        self.missed = false;
        self.moved = true;
        Ok(())
    }

    fn do_step(&mut self, _: &Grid, _: u64) -> Result<(), UnitError> {
        let missed = std::mem::take(&mut self.missed);
        self.moved = self.machine.fires();
        if self.moved {
            let mut received = Vec::with_capacity(self.heard.len());
            for (i, value) in self.heard.iter().enumerate() {
                if !self.machine.looks_at(i) {
                    received.push(Quotient::from(&Rational::default()));
                    continue;
                }
                let Some(x) = self.settings.exchange.receive(value) else {
                    let index = self.index(Slot::Heard(i)).unwrap_or(usize::MAX);
                    let what = format!("`{value}`: expected a finite position");
                    return Err(at_variable(self, index, what));
                };
                received.push(x);
            }
            self.machine.tick(received);
            if missed && self.settings.on_loss == OnLoss::Skip {
                self.machine.put_back(self.own.clone());
            } else if let Some(own) = self.machine.position() {
                self.own = own.clone();
                self.round();
            }
        } else {
            self.machine.tick(Vec::new());
        }
        Ok(())
    }

    fn moved(&self) -> bool {
        self.moved
    }

    fn lost(&mut self, _: usize) {
        self.missed = true;
    }
}

impl Resumable for Coordination {
    fn memory(&self) -> Vec<Value> {
        let mut memory = vec![
            Value::Exact(self.own.clone()),
            Value::Integer(self.machine.counter().into()),
            Value::Boolean(self.missed),
        ];
        memory.extend(self.machine.besides());
        memory
    }

    fn recall(&mut self, memory: &[Value]) -> Result<(), UnitError> {
        let [Value::Exact(own), Value::Integer(counter), Value::Boolean(missed), besides @ ..] =
            memory
        else {
            return Err(no_memory(self));
        };
        if !self.machine.recall_besides(besides) {
            return Err(no_memory(self));
        }
        match u32::try_from(*counter) {
            Ok(counter) if counter < self.settings.period => {
                self.machine.resume(own.clone(), counter);
            }
            _ => return Err(no_memory(self)),
        }
        self.own = own.clone();
        self.round();
        self.missed = *missed;
        Ok(())
    }
}
