//! A unit under the rules of the FMI standards, as called by the C functions.
//!
//! The state machine of co-simulation (instantiated, initialisation, step, terminated), value
//! references, types, exact time, saved states. FMI 2.0 and 3.0 differ only in their C functions; the
//! rules here serve both.

use std::path::Path;

use num_traits::Signed;

use super::carried::Carried;
use super::interface::{FmiVersion, Model, START_INPUTS, TAU, default_tau};
pub use super::snapshot::Mode;
use super::snapshot::Snapshot;
use crate::grid::Grid;
use crate::quotient::Quotient;
use crate::unit::{Causality, Kind, Resumable, UnitError, Value, Variable};
use cordon_core::Error;
use cordon_core::exact::{self, Rational};

/// Why a call was refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The severity.
    pub severity: Severity,
    /// The message for the user.
    pub message: String,
}

/// The severity of a refusal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The call was refused; the instance is unchanged.
    Error,
    /// The instance can no longer be used.
    Fatal,
}

impl Refusal {
    /// A refused call that leaves the instance unchanged.
    pub fn error(message: impl Into<String>) -> Self {
        Self { severity: Severity::Error, message: message.into() }
    }

    /// A failure after which the instance can no longer be used.
    pub fn fatal(message: impl Into<String>) -> Self {
        Self { severity: Severity::Fatal, message: message.into() }
    }
}

impl From<UnitError> for Refusal {
    fn from(e: UnitError) -> Self {
        Self::error(e.to_string())
    }
}

/// Longest run in steps: the limit of [`Grid`].
const MAX_STEPS: u64 = 10_000_000_000;

/// Longest single call in steps, so that every call returns: six days in steps of 0.05 s.
const MAX_STEPS_A_CALL: f64 = 10_000_000.0;

/// Tolerance, in steps of tau, for an importer's step that should be a whole number of them: importers
/// compute step sizes as differences of times, in doubles.
const STEP_NOISE: f64 = 1e-6;

/// An instance of an exported unit.
pub struct Slave {
    name: String,
    model: Model,
    token: String,
    variables: Vec<Variable>,
    unit: Box<dyn Resumable>,
    mode: Mode,
    tau: Rational,
    /// Whether the first step uses the inputs' start values.
    start_inputs: bool,
    grid: Option<Grid>,
    start_time: f64,
    stop_time: Option<f64>,
    /// Number of steps of tau so far.
    step: u64,
    /// Whether a variable was set since the unit was last initialised.
    stale: bool,
}

impl Slave {
    /// Makes an instance of the model that the identifier belongs to; `resources` is the FMU's folder
    /// of that name, where the importer gives it.
    ///
    /// # Errors
    /// No model of this binary has the identifier, or the files that the FMU should carry are missing.
    pub fn instantiate(
        version: FmiVersion,
        name: &str,
        token: &str,
        resources: Option<&Path>,
    ) -> Result<Self, Refusal> {
        let carried = || match resources {
            Some(folder) => Carried::read(folder),
            None => Err(Error::input("the importer did not say where the resources are")),
        };
        let model = Model::of_token(version, token, carried)
            .map_err(|e| Refusal::error(format!("identifier `{token}`: {e}")))?
            .ok_or_else(|| {
                Refusal::error(format!(
                    "identifier `{token}`: no unit of this binary has it; \
                     expected binary and model description from the same export"
                ))
            })?;
        Ok(Self::of(model, name, token))
    }

    /// An instance that is not set up yet.
    fn of(model: Model, name: &str, token: &str) -> Self {
        Self {
            name: name.to_owned(),
            token: token.to_owned(),
            variables: model.variables(),
            unit: model.unit(name),
            model,
            mode: Mode::Instantiated,
            tau: default_tau(),
            start_inputs: false,
            grid: None,
            start_time: 0.0,
            stop_time: None,
            step: 0,
            stale: true,
        }
    }

    /// The current mode.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The current communication point, as the double nearest to the exact one.
    pub fn time(&self) -> f64 {
        match (&self.grid, self.start_time == 0.0) {
            (Some(grid), true) => grid.time_f64(self.step),
            (Some(grid), false) => self.start_time + grid.time_f64(self.step),
            (None, _) => self.start_time,
        }
    }

    /// Makes the instance refuse all further calls, after an internal failure.
    pub fn give_up(&mut self) {
        self.mode = Mode::Fatal;
    }

    fn expect_mode(&self, call: &str, allowed: &[Mode]) -> Result<(), Refusal> {
        if allowed.contains(&self.mode) {
            return Ok(());
        }
        let state = self.mode.name();
        let message = format!("{call}: the instance is {state}: the call is not allowed now");
        Err(match self.mode {
            Mode::Fatal => Refusal::fatal(message),
            _ => Refusal::error(message),
        })
    }

    /// Sets the start of the run and, optionally, its end.
    ///
    /// # Errors
    /// Wrong mode, or a time that is not finite.
    pub fn set_up(&mut self, start: f64, stop: Option<f64>) -> Result<(), Refusal> {
        self.expect_mode("setting up the experiment", &[Mode::Instantiated])?;
        if !start.is_finite() || stop.is_some_and(|s| s.is_nan() || s < start) {
            let stop = stop.map(|s| format!(" to `{s}` s")).unwrap_or_default();
            return Err(Refusal::error(format!(
                "a run from `{start}` s{stop}: expected times in order"
            )));
        }
        (self.start_time, self.stop_time) = (start, stop);
        Ok(())
    }

    /// Begins the initialisation.
    ///
    /// # Errors
    /// Wrong mode.
    pub fn enter_initialisation(&mut self) -> Result<(), Refusal> {
        self.expect_mode("entering the initialisation", &[Mode::Instantiated])?;
        self.mode = Mode::Initialisation;
        self.stale = true;
        Ok(())
    }

    /// Ends the initialisation: the parameters must be consistent by now.
    ///
    /// # Errors
    /// Wrong mode, or a parameter outside its range.
    pub fn exit_initialisation(&mut self) -> Result<(), Refusal> {
        self.expect_mode("leaving the initialisation", &[Mode::Initialisation])?;
        self.settle()?;
        self.mode = Mode::Step;
        Ok(())
    }

    /// Updates the unit with the values set during initialisation.
    fn settle(&mut self) -> Result<(), Refusal> {
        if self.mode == Mode::Initialisation && self.stale {
            let grid = grid(&self.tau)?;
            self.unit.initialise(&grid)?;
            self.grid = Some(grid);
            self.stale = false;
        }
        Ok(())
    }

    /// Ends the run.
    ///
    /// # Errors
    /// Wrong mode.
    pub fn terminate(&mut self) -> Result<(), Refusal> {
        self.expect_mode("terminating", &[Mode::Initialisation, Mode::Step])?;
        self.mode = Mode::Terminated;
        Ok(())
    }

    /// Returns to the state after instantiation, with every parameter at its start value.
    ///
    /// # Errors
    /// The instance can no longer be used.
    pub fn reset(&mut self) -> Result<(), Refusal> {
        let allowed = [Mode::Instantiated, Mode::Initialisation, Mode::Step, Mode::Terminated];
        self.expect_mode("resetting", &allowed)?;
        *self = Self::of(self.model.clone(), &self.name, &self.token);
        Ok(())
    }

    fn variable(&self, reference: u32) -> Result<(usize, &Variable), Refusal> {
        let index = usize::try_from(reference).unwrap_or(usize::MAX);
        self.variables.get(index).map(|v| (index, v)).ok_or_else(|| {
            let count = self.variables.len();
            Refusal::error(format!("value reference {reference}: expected less than {count}"))
        })
    }

    /// Sets a parameter or an input. Exact numbers come as text.
    ///
    /// # Errors
    /// No such variable, wrong mode, wrong type, not finite, or out of range.
    pub fn set(&mut self, reference: u32, value: &Value) -> Result<(), Refusal> {
        let (index, variable) = self.variable(reference)?;
        let allowed: &[Mode] = match variable.causality {
            Causality::Parameter => &[Mode::Instantiated, Mode::Initialisation],
            _ => &[Mode::Instantiated, Mode::Initialisation, Mode::Step],
        };
        let named = |what: &str| Refusal::error(format!("variable `{}`: {what}", variable.name));
        self.expect_mode(&format!("setting `{}`", variable.name), allowed)?;
        let value = match (variable.kind(), value) {
            (Kind::Exact, Value::Text(text)) => {
                let number = exact::parse(&variable.name, text);
                Value::Exact(Quotient::from(&number.map_err(|e| Refusal::error(e.to_string()))?))
            }
            (_, Value::Real(x)) if !x.is_finite() => {
                return Err(named(&format!("`{x}`: expected a finite number")));
            }
            _ => value.clone(),
        };
        if variable.name == TAU {
            let tau = match (variable.kind(), &value) {
                (Kind::Exact, Value::Exact(tau)) => Some(tau.to_rational()),
                (Kind::Real, Value::Real(tau)) => {
                    Quotient::simplest_of(*tau).map(|t| t.to_rational())
                }
                _ => None,
            };
            let Some(tau) = tau else {
                let expected = if self.model.exact_numbers() { "text `p/q`" } else { "real" };
                return Err(named(&format!("expected {expected}, found {}", value.kind())));
            };
            if !tau.is_positive() {
                return Err(named(&format!("`{tau}`: expected a positive number of seconds")));
            }
            self.tau = tau;
        } else if variable.name == START_INPUTS {
            let Value::Boolean(hold) = value else {
                return Err(named(&format!("expected boolean, found {}", value.kind())));
            };
            self.start_inputs = hold;
        } else if self.start_inputs && self.mode == Mode::Step && self.step == 0 {
            if variable.kind() != value.kind() {
                return Err(named(&format!(
                    "expected {}, found {}",
                    variable.kind(),
                    value.kind()
                )));
            }
        } else {
            self.unit.set(index, &value)?;
        }
        self.stale = true;
        Ok(())
    }

    fn get(&mut self, reference: u32, wanted: &[Kind]) -> Result<Value, Refusal> {
        let (index, variable) = self.variable(reference)?;
        let kind = variable.kind();
        if !wanted.contains(&kind) {
            let name = &variable.name;
            return Err(Refusal::error(format!("variable `{name}`: its type is {kind}")));
        }
        match variable.name.as_str() {
            TAU => return Ok(self.model.tau_value(&self.tau)),
            START_INPUTS => return Ok(Value::Boolean(self.start_inputs)),
            _ => {}
        }
        if self.mode == Mode::Fatal {
            return Err(Refusal::fatal("reading: the instance is no longer usable"));
        }
        self.settle()?;
        Ok(self.unit.get(index)?)
    }

    /// The value of a real variable, or of the time, whose reference follows those of the variables.
    ///
    /// # Errors
    /// No such variable, or another type.
    pub fn real(&mut self, reference: u32) -> Result<f64, Refusal> {
        if usize::try_from(reference) == Ok(self.variables.len()) {
            return Ok(self.time());
        }
        match self.get(reference, &[Kind::Real])? {
            Value::Real(x) => Ok(x),
            other => Err(unexpected(&other)),
        }
    }

    /// The value of an integer variable.
    ///
    /// # Errors
    /// No such variable, or another type.
    pub fn integer(&mut self, reference: u32) -> Result<i64, Refusal> {
        match self.get(reference, &[Kind::Integer])? {
            Value::Integer(n) => Ok(n),
            other => Err(unexpected(&other)),
        }
    }

    /// The value of a Boolean variable.
    ///
    /// # Errors
    /// No such variable, or another type.
    pub fn boolean(&mut self, reference: u32) -> Result<bool, Refusal> {
        match self.get(reference, &[Kind::Boolean])? {
            Value::Boolean(b) => Ok(b),
            other => Err(unexpected(&other)),
        }
    }

    /// The value of a string variable, or of an exact one as `p/q`.
    ///
    /// # Errors
    /// No such variable, or another type.
    pub fn text(&mut self, reference: u32) -> Result<String, Refusal> {
        Ok(self.get(reference, &[Kind::Text, Kind::Exact])?.to_string())
    }

    /// Advances by a step, which is `size` seconds long and begins at `point`.
    ///
    /// Time inside is exact. The importer's doubles only have to round to it: `point` to the end of the
    /// last step, `size` to a whole number of steps of tau.
    ///
    /// # Errors
    /// Wrong mode, wrong time, a size that is not a multiple of tau, a step beyond the end of the run,
    /// or a failure of the unit.
    pub fn do_step(&mut self, point: f64, size: f64) -> Result<(), Refusal> {
        self.expect_mode("stepping", &[Mode::Step])?;
        let Some(grid) = &self.grid else {
            return Err(Refusal::fatal("stepping: the instance was never initialised"));
        };
        let (tau, now) = (grid.tau_f64(), self.time());
        if (point - now).is_nan() || (point - now).abs() >= tau / 2.0 {
            return Err(Refusal::error(format!(
                "a step from `{point}` s: expected `{now}` s, the end of the last step"
            )));
        }
        let count = (size / tau).round();
        if !(count >= 1.0 && (size / tau - count).abs() <= STEP_NOISE * count) {
            return Err(Refusal::error(format!(
                "a step of `{size}` s: expected a whole multiple of the parameter `{TAU}`, `{}` s",
                self.tau
            )));
        }
        if count > MAX_STEPS_A_CALL {
            return Err(Refusal::error(format!(
                "a step of `{size}` s: expected at most {MAX_STEPS_A_CALL} times `{TAU}`, `{}` s",
                self.tau
            )));
        }
        if self.stop_time.is_some_and(|stop| now + size > stop + tau / 2.0) {
            return Err(Refusal::error(format!(
                "a step of `{size}` s from `{now}` s: goes beyond the end of the run"
            )));
        }
        // In range: the loop refuses more steps than the grid has.
        for _ in 0..count as u64 {
            if self.step >= grid.steps() {
                return Err(Refusal::error(format!("the run is longer than {MAX_STEPS} steps")));
            }
            self.unit.do_step(grid, self.step)?;
            self.step += 1;
        }
        Ok(())
    }

    /// Saves the current state.
    ///
    /// # Errors
    /// The instance can no longer be used.
    pub fn save(&self) -> Result<Snapshot, Refusal> {
        let allowed = [Mode::Instantiated, Mode::Initialisation, Mode::Step, Mode::Terminated];
        self.expect_mode("keeping the state", &allowed)?;
        let mut settable = Vec::with_capacity(self.variables.len());
        for (index, variable) in self.variables.iter().enumerate() {
            settable.push(match variable.causality {
                _ if variable.name == TAU => Some(self.model.tau_value(&self.tau)),
                _ if variable.name == START_INPUTS => Some(Value::Boolean(self.start_inputs)),
                Causality::Parameter | Causality::Input => Some(self.unit.get(index)?),
                Causality::Output | Causality::Local => None,
            });
        }
        Ok(Snapshot {
            token: self.token.clone(),
            mode: self.mode,
            start_time: self.start_time,
            stop_time: self.stop_time,
            step: self.step,
            settable,
            memory: self.unit.memory(),
        })
    }

    /// Restores a saved state; where that is impossible the instance is unchanged.
    ///
    /// # Errors
    /// The state of another FMU, or one that was modified.
    pub fn restore(&mut self, snapshot: &Snapshot) -> Result<(), Refusal> {
        if self.mode == Mode::Fatal {
            return Err(Refusal::fatal("restoring: the instance is no longer usable"));
        }
        if snapshot.token != self.token {
            return Err(Refusal::error("this is the state of another FMU"));
        }
        let mut back = Self::of(self.model.clone(), &self.name, &self.token);
        if snapshot.settable.len() != back.variables.len() {
            return Err(Refusal::error("this state has another number of variables"));
        }
        for (reference, value) in (0..).zip(&snapshot.settable) {
            if let Some(value) = value {
                back.set(reference, value)?;
            }
        }
        (back.start_time, back.stop_time) = (snapshot.start_time, snapshot.stop_time);
        if snapshot.mode != Mode::Instantiated {
            back.mode = Mode::Initialisation;
            // Inconsistent parameters are not an error until the initialisation ends.
            let settled = back.settle();
            if snapshot.mode != Mode::Initialisation {
                settled?;
                back.unit.recall(&snapshot.memory)?;
            }
        }
        back.mode = snapshot.mode;
        back.step = snapshot.step;
        *self = back;
        Ok(())
    }

    /// A saved state from its serialised form.
    ///
    /// # Errors
    /// Not a serialised state, or that of another FMU.
    pub fn snapshot_from_bytes(&self, bytes: &[u8]) -> Result<Snapshot, Refusal> {
        Snapshot::from_bytes(&self.token, bytes).map_err(Refusal::error)
    }
}

fn grid(tau: &Rational) -> Result<Grid, Refusal> {
    Grid::new(tau.clone(), MAX_STEPS).map_err(|e| Refusal::error(e.to_string()))
}

fn unexpected(value: &Value) -> Refusal {
    Refusal::error(format!("the unit returned `{value}`, which is not of the declared type"))
}
