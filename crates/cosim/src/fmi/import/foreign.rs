//! A unit with an FMU behind it.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::JoinHandle;

use super::adapter::Counterpart;
use super::session::{Order, Session};
use crate::fmi::archive::Fmu;
use crate::grid::Grid;
use crate::quotient::Quotient;
use crate::unit::{
    Causality, Kind, Unit, UnitError, Value, Variable, at_variable, no_such_variable, not_settable,
    wrong_kind,
};
use cordon_core::{Error, Result, exact};

/// A unit with an FMU behind it.
///
/// The FMU lives on a thread of its own: pointers into foreign libraries do not travel between
/// threads, units do.
pub(super) struct Foreign {
    name: String,
    fmu: String,
    variables: Vec<Variable>,
    /// Values of all variables: as set, as last read.
    values: Vec<Value>,
    map: Vec<Counterpart>,
    worker: Worker,
}

/// The thread of an FMU: it ends when no more orders can come.
struct Worker {
    orders: Option<Sender<Order>>,
    answers: Receiver<Result<Vec<Value>, String>>,
    thread: Option<JoinHandle<()>>,
}

impl Foreign {
    /// Loads an FMU in the place of `unit`, whose parameters it gets as far as it has them.
    pub(super) fn new(fmu: Fmu, unit: &dyn Unit, map: Vec<Counterpart>) -> Result<Self> {
        super::log::listen();
        let mut values = Vec::with_capacity(unit.variables().len());
        for place in 0..unit.variables().len() {
            values.push(unit.get(place)?);
        }
        let name = unit.name().to_owned();
        let path = fmu.path.display().to_string();
        let (orders, inbox) = channel();
        let (outbox, answers) = channel();
        let (at, instance) = (fmu.path.clone(), name.clone());
        let thread = std::thread::Builder::new().name(name.clone()).spawn(move || {
            let mut session = Session::load(&fmu, &instance);
            for order in inbox {
                let answer = match &mut session {
                    Ok(session) => session.carry_out(&order),
                    Err(why) => Err(why.clone()),
                };
                if outbox.send(answer).is_err() {
                    break;
                }
            }
        });
        let thread = Some(thread.map_err(|e| Error::file("load", &at, e))?);
        Ok(Self {
            name,
            fmu: path,
            variables: unit.variables().to_vec(),
            values,
            map,
            worker: Worker { orders: Some(orders), answers, thread },
        })
    }

    /// Sends an order with the present values; takes the outputs.
    fn order(
        &mut self,
        of: Causality,
        order: impl FnOnce(Vec<(Counterpart, Value)>, Vec<Counterpart>) -> Order,
    ) -> Result<(), UnitError> {
        let told = self
            .map
            .iter()
            .filter(|c| {
                c.causality == of || (of == Causality::Parameter && c.causality == Causality::Input)
            })
            .filter_map(|c| self.values.get(c.place).map(|v| (c.clone(), outward(v))))
            .collect();
        let outputs: Vec<Counterpart> =
            self.map.iter().filter(|c| c.causality == Causality::Output).cloned().collect();
        let sent = self.worker.orders.as_ref().map(|o| o.send(order(told, outputs.clone())));
        let answer = match sent {
            Some(Ok(())) => self.worker.answers.recv(),
            _ => return Err(self.failed("its thread has ended")),
        };
        let read = match answer {
            Ok(Ok(read)) => read,
            Ok(Err(what)) => return Err(self.failed(&what)),
            Err(_) => return Err(self.failed("its thread has ended")),
        };
        for (counterpart, value) in outputs.iter().zip(read) {
            let value = self.inward(counterpart, value)?;
            if let Some(place) = self.values.get_mut(counterpart.place) {
                *place = value;
            }
        }
        Ok(())
    }

    fn failed(&self, what: &str) -> UnitError {
        UnitError::new(&self.name, None, format!("`{}`: {what}", self.fmu))
    }

    /// A value that the FMU gave, as the unit's type has it.
    fn inward(&self, counterpart: &Counterpart, value: Value) -> Result<Value, UnitError> {
        match (counterpart.kind, value) {
            (Kind::Exact, Value::Text(text)) => match exact::parse("value", &text) {
                Ok(number) => Ok(Value::Exact(Quotient::from(&number))),
                Err(_) => {
                    let what = format!("`{text}` from `{}`: expected a number p/q", self.fmu);
                    Err(at_variable(self, counterpart.place, what))
                }
            },
            (_, value) => Ok(value),
        }
    }
}

/// A value as FMUs take it: exact numbers as text.
fn outward(value: &Value) -> Value {
    match value {
        Value::Exact(x) => Value::Text(x.to_string().into()),
        other => other.clone(),
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // Without senders the thread's loop ends, and with it the FMU's instance.
        self.orders = None;
        if let Some(thread) = self.thread.take() {
            // A panic over there has been reported there.
            let _ = thread.join();
        }
    }
}

impl Unit for Foreign {
    fn name(&self) -> &str {
        &self.name
    }

    fn variables(&self) -> &[Variable] {
        &self.variables
    }

    fn set(&mut self, variable: usize, value: &Value) -> Result<(), UnitError> {
        match self.variables.get(variable) {
            None => return Err(no_such_variable(self, variable)),
            Some(v) if !matches!(v.causality, Causality::Parameter | Causality::Input) => {
                return Err(not_settable(self, variable));
            }
            Some(v) if v.kind() != value.kind() => {
                return Err(wrong_kind(self, variable, v.kind(), value));
            }
            Some(_) => {}
        }
        if let Some(place) = self.values.get_mut(variable) {
            *place = value.clone();
        }
        Ok(())
    }

    fn get(&self, variable: usize) -> Result<Value, UnitError> {
        self.values.get(variable).cloned().ok_or_else(|| no_such_variable(self, variable))
    }

    fn initialise(&mut self, grid: &Grid) -> Result<(), UnitError> {
        let stop = grid.time_f64(grid.steps());
        self.order(Causality::Parameter, |set, get| Order::Initialise { set, get, stop })
    }

    fn do_step(&mut self, grid: &Grid, step: u64) -> Result<(), UnitError> {
        let (from, size) = (grid.time_f64(step), grid.tau_f64());
        self.order(Causality::Input, |set, get| Order::Step { set, get, from, size })
    }
}
