//! The units of a co-simulation: models with typed variables that advance in steps.

use std::fmt;
use std::sync::Arc;

use super::grid::Grid;
use super::quotient::Quotient;

/// A unit of a co-simulation: the plant of a drone, its controller, a third-party model.
///
/// Units know nothing of each other. The master reads a unit's outputs, sets its inputs and then lets
/// it advance by one communication step; between two steps nothing in it changes. Variables are
/// addressed by their index in [`variables`](Unit::variables).
pub trait Unit: Send {
    /// The instance's name, unique in its co-simulation.
    fn name(&self) -> &str;

    /// The variables, always the same ones in the same order.
    fn variables(&self) -> &[Variable];

    /// Sets a parameter (before [`initialise`](Unit::initialise)) or an input.
    ///
    /// # Errors
    /// There is no such variable, it cannot be set, or the value has another type or is
    /// outside the variable's range.
    fn set(&mut self, variable: usize, value: &Value) -> Result<(), UnitError>;

    /// The current value of any variable.
    ///
    /// # Errors
    /// There is no such variable, or its value is not available.
    fn get(&self, variable: usize) -> Result<Value, UnitError>;

    /// The current values of several variables as doubles; NaN for one that is not a number.
    ///
    /// # Errors
    /// As for [`get`](Unit::get).
    fn get_reals(&self, variables: &[usize], into: &mut [f64]) -> Result<(), UnitError> {
        for (&variable, x) in variables.iter().zip(into) {
            *x = self.get(variable)?.to_f64().unwrap_or(f64::NAN);
        }
        Ok(())
    }

    /// Sets several real parameters or inputs.
    ///
    /// # Errors
    /// As for [`set`](Unit::set).
    fn set_reals(&mut self, variables: &[usize], values: &[f64]) -> Result<(), UnitError> {
        for (&variable, &x) in variables.iter().zip(values) {
            self.set(variable, &Value::Real(x))?;
        }
        Ok(())
    }

    /// Called once, after the parameters are set and before the first exchange: the unit is given the
    /// communication grid and enters its initial state.
    ///
    /// # Errors
    /// A parameter is out of range, or the unit cannot follow the grid (its own step does not divide
    /// the communication step).
    fn initialise(&mut self, grid: &Grid) -> Result<(), UnitError>;

    /// Called before [`do_step`](Unit::do_step), with the inputs of that step; where units step at
    /// once, for all of them first, so that units in other processes compute in parallel.
    ///
    /// # Errors
    /// The unit cannot begin the step.
    fn begin_step(&mut self, _grid: &Grid, _step: u64) -> Result<(), UnitError> {
        Ok(())
    }

    /// Advances by the communication step that begins at grid point `step`, with the current inputs.
    ///
    /// # Errors
    /// The unit cannot compute the step.
    fn do_step(&mut self, grid: &Grid, step: u64) -> Result<(), UnitError>;

    /// Whether some output may have changed since the last step began. A unit that rarely changes saves
    /// the master work by returning false.
    fn moved(&self) -> bool {
        true
    }

    /// Notes on the unit for the user, so far: warnings of an FMU.
    fn notes(&self) -> &[String] {
        &[]
    }

    /// Called instead of [`set`](Unit::set) where a message to this input was lost. The input keeps its
    /// value; a unit that needs to know overrides this.
    fn lost(&mut self, _input: usize) {}
}

/// A unit whose state can be saved and restored.
pub trait Resumable: Unit {
    /// The state of the unit besides its parameters and inputs.
    fn memory(&self) -> Vec<Value>;

    /// Restores the state that [`memory`](Resumable::memory) returned. Called after
    /// [`initialise`](Unit::initialise), with the same parameters and inputs.
    ///
    /// # Errors
    /// This is not the state of such a unit.
    fn recall(&mut self, memory: &[Value]) -> Result<(), UnitError>;
}

/// The doubles of a saved state that has `N` of them.
///
/// # Errors
/// It has another shape.
pub fn recalled_reals<const N: usize>(
    unit: &dyn Unit,
    memory: &[Value],
) -> Result<[f64; N], UnitError> {
    let reals: Option<Vec<f64>> = memory
        .iter()
        .map(|v| match v {
            Value::Real(x) => Some(*x),
            _ => None,
        })
        .collect();
    reals.and_then(|r| <[f64; N]>::try_from(r).ok()).ok_or_else(|| no_memory(unit))
}

/// The error of [`Resumable::recall`].
pub fn no_memory(unit: &dyn Unit) -> UnitError {
    UnitError::new(unit.name(), None, "not a saved state of such a unit")
}

/// A variable of a unit, as an FMI model description has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Name, unique in its unit.
    pub name: String,
    /// Physical unit of the values (`m`, `m/s`, `rad`), [`Dimension::NONE`] for pure numbers.
    pub dimension: Dimension,
    /// Who sets it.
    pub causality: Causality,
    /// The values' type and the value before the first step.
    pub start: Value,
    /// A description, for display.
    pub description: &'static str,
    /// Indices of the inputs that this output depends on within a step (direct feedthrough). Empty for
    /// units whose outputs change in `do_step` only.
    pub feedthrough: Vec<usize>,
}

impl Variable {
    /// A variable without feedthrough.
    pub fn new(
        name: impl Into<String>,
        dimension: Dimension,
        causality: Causality,
        start: Value,
        description: &'static str,
    ) -> Self {
        Self {
            name: name.into(),
            dimension,
            causality,
            start,
            description,
            feedthrough: Vec::new(),
        }
    }

    /// The type of the values.
    pub fn kind(&self) -> Kind {
        self.start.kind()
    }
}

/// A physical unit by its symbol, in SI base symbols as FMI writes them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension(pub &'static str);

impl Dimension {
    /// A pure number.
    pub const NONE: Self = Self("");
    /// Metres.
    pub const METRE: Self = Self("m");
    /// Metres per second.
    pub const METRE_PER_SECOND: Self = Self("m/s");
    /// Metres per second squared.
    pub const METRE_PER_SECOND_SQUARED: Self = Self("m/s2");
    /// Radians.
    pub const RADIAN: Self = Self("rad");
    /// Radians per second.
    pub const RADIAN_PER_SECOND: Self = Self("rad/s");
    /// Per second: gains.
    pub const PER_SECOND: Self = Self("1/s");
    /// Kilograms.
    pub const KILOGRAM: Self = Self("kg");
    /// Moments of inertia.
    pub const KILOGRAM_METRE_SQUARED: Self = Self("kg.m2");
    /// Thrust per squared rotor speed.
    pub const THRUST_FACTOR: Self = Self("kg.m");
    /// Torque per squared rotor speed.
    pub const TORQUE_FACTOR: Self = Self("kg.m2");
    /// Seconds.
    pub const SECOND: Self = Self("s");
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_empty() { "1" } else { self.0 })
    }
}

/// Who sets a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Causality {
    /// The user, before the run.
    Parameter,
    /// The master, from a connected output.
    Input,
    /// The unit; can be connected to inputs.
    Output,
    /// The unit; for inspection only.
    Local,
}

impl Causality {
    /// Its name in messages and model descriptions.
    pub fn name(self) -> &'static str {
        match self {
            Self::Parameter => "parameter",
            Self::Input => "input",
            Self::Output => "output",
            Self::Local => "local",
        }
    }
}

/// The type of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A double, with a unit of measurement.
    Real,
    /// A 64-bit integer.
    Integer,
    /// True or false.
    Boolean,
    /// Text of any length.
    Text,
    /// An exact rational; outside the program it travels as text `p/q`.
    Exact,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Real => "real",
            Self::Integer => "integer",
            Self::Boolean => "boolean",
            Self::Text => "text",
            Self::Exact => "exact rational",
        })
    }
}

/// The value of a variable. Cheap to clone.
// A whole word for the tag: values are moved word by word, millions of times.
#[repr(u64)]
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A double.
    Real(f64),
    /// An integer.
    Integer(i64),
    /// True or false.
    Boolean(bool),
    /// Text.
    Text(Arc<str>),
    /// An exact number, sent as text over FMI.
    Exact(Quotient),
}

impl Value {
    /// The type of a variable that can hold it.
    pub fn kind(&self) -> Kind {
        match self {
            Self::Real(_) => Kind::Real,
            Self::Integer(_) => Kind::Integer,
            Self::Boolean(_) => Kind::Boolean,
            Self::Text(_) => Kind::Text,
            Self::Exact(_) => Kind::Exact,
        }
    }

    /// The nearest double of a number.
    pub fn to_f64(&self) -> Option<f64> {
        match self {
            Self::Real(x) => Some(*x),
            // Exact below 2^53, rounded above: the caller asked for a double.
            Self::Integer(n) => Some(*n as f64),
            Self::Exact(x) => Some(x.to_f64()),
            Self::Boolean(_) | Self::Text(_) => None,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Real(x) => write!(f, "{x}"),
            Self::Integer(n) => write!(f, "{n}"),
            Self::Boolean(b) => write!(f, "{b}"),
            Self::Text(t) => f.write_str(t),
            Self::Exact(x) => write!(f, "{x}"),
        }
    }
}

/// Why a unit could not do what was asked, as a message for the user. Small, because every `get` and
/// `set` may return one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitError(Box<UnitErrorParts>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct UnitErrorParts {
    unit: String,
    variable: Option<String>,
    what: String,
}

impl UnitError {
    /// An error of a unit, optionally about one of its variables; `what` says what was found and what
    /// was expected.
    pub fn new(unit: &str, variable: Option<&str>, what: impl Into<String>) -> Self {
        Self(Box::new(UnitErrorParts {
            unit: unit.to_owned(),
            variable: variable.map(str::to_owned),
            what: what.into(),
        }))
    }

    /// The name of the unit that failed.
    pub fn unit(&self) -> &str {
        &self.0.unit
    }

    /// The name of the variable, if the error is about one.
    pub fn variable(&self) -> Option<&str> {
        self.0.variable.as_deref()
    }
}

impl std::error::Error for UnitError {}

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unit `{}`", self.0.unit)?;
        if let Some(variable) = &self.0.variable {
            write!(f, ", variable `{variable}`")?;
        }
        write!(f, ": {}", self.0.what)
    }
}

impl From<UnitError> for cordon_core::Error {
    fn from(e: UnitError) -> Self {
        Self::input(e.to_string())
    }
}

/// An error about a variable of a unit, given by its index.
pub fn at_variable(unit: &dyn Unit, variable: usize, what: impl Into<String>) -> UnitError {
    let name = unit.variables().get(variable).map(|v| v.name.clone());
    let name = name.unwrap_or_else(|| format!("number {variable}"));
    UnitError::new(unit.name(), Some(&name), what)
}

/// The error of [`Unit::get`] for an index beyond the table.
pub fn no_such_variable(unit: &dyn Unit, variable: usize) -> UnitError {
    let count = unit.variables().len();
    at_variable(unit, variable, format!("expected one of its {count} variables"))
}

/// The double that a real variable is set to.
///
/// # Errors
/// The value has another type.
pub fn expect_real(unit: &dyn Unit, variable: usize, value: &Value) -> Result<f64, UnitError> {
    match value {
        Value::Real(x) => Ok(*x),
        other => Err(wrong_kind(unit, variable, Kind::Real, other)),
    }
}

/// The error of [`Unit::set`] for a value of another type.
pub fn wrong_kind(unit: &dyn Unit, variable: usize, expected: Kind, value: &Value) -> UnitError {
    at_variable(unit, variable, format!("`{value}`: expected {expected}, found {}", value.kind()))
}

/// The error of [`Unit::set`] for outputs and locals.
pub fn not_settable(unit: &dyn Unit, variable: usize) -> UnitError {
    match unit.variables().get(variable) {
        Some(v) => {
            let what = format!("is {}: expected a parameter or an input", v.causality.name());
            at_variable(unit, variable, what)
        }
        None => no_such_variable(unit, variable),
    }
}
