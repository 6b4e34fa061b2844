//! A unit backed by an FMU.

use cordon_fmi::fmu::{self, Datum, Type, Version};
use cordon_fmi::instance::Instance;
use cordon_fmi::message::{Beginning, Reply};
#[cfg(unix)]
use cordon_fmi::remote::Remote;

use super::Isolation;
use super::adapter::{Counterpart, Map};
use super::folder::Folder;
use crate::fmi::archive::Fmu;
use crate::fmi::model_description::FmuVariable;
use cordon_core::{Result, exact};
use cordon_cosim::fmi::interface::FmiVersion;
use cordon_cosim::grid::Grid;
use cordon_cosim::quotient::Quotient;
use cordon_cosim::unit::{
    Causality, Kind, Unit, UnitError, Value, Variable, at_variable, no_such_variable, not_settable,
    wrong_kind,
};

/// Most notes kept of a run.
const MOST_NOTES: usize = 20;

/// A unit backed by an FMU.
pub(super) struct Foreign {
    name: String,
    fmu: String,
    variables: Vec<Variable>,
    /// Values of all variables: as last set or read.
    values: Vec<Value>,
    counterparts: Vec<Counterpart>,
    /// Parameters that only the FMU has.
    parameters: Vec<(FmuVariable, Value)>,
    notes: Vec<String>,
    session: Session,
    /// The unpacked archive; dropped after the session that uses it.
    _folder: Folder,
}

/// Where the instance runs.
enum Session {
    /// With the reply to the step that was begun.
    Here(Box<Instance>, Option<Reply>),
    #[cfg(unix)]
    There(Remote),
}

impl Session {
    fn load(isolation: &Isolation, fmu: fmu::Fmu) -> Result<Self, String> {
        match isolation {
            Isolation::InProcess => Ok(Self::Here(Box::new(Instance::load(&fmu)?), None)),
            #[cfg(unix)]
            Isolation::Process { program, arguments, limit } => {
                let mut command = std::process::Command::new(program);
                command.args(arguments);
                Ok(Self::There(Remote::load(command, fmu, *limit)?))
            }
            #[cfg(not(unix))]
            Isolation::Process { .. } => {
                Err("this system runs FMUs with `--in-process` only".to_owned())
            }
        }
    }

    fn initialise(&mut self, beginning: Beginning) -> Reply {
        match self {
            Self::Here(instance, _) => instance.initialise(beginning),
            #[cfg(unix)]
            Self::There(remote) => remote.initialise(beginning),
        }
    }

    fn begin_step(&mut self, from: f64, size: f64, inputs: Vec<Datum>) -> Result<(), String> {
        match self {
            Self::Here(instance, answer) => {
                *answer = Some(instance.step(from, size, &inputs));
                Ok(())
            }
            #[cfg(unix)]
            Self::There(remote) => remote.begin_step(from, size, inputs),
        }
    }

    fn end_step(&mut self) -> Reply {
        match self {
            Self::Here(_, answer) => {
                answer.take().unwrap_or_else(|| Reply::failed("no step was begun".to_owned()))
            }
            #[cfg(unix)]
            Self::There(remote) => remote.end_step(),
        }
    }
}

impl Foreign {
    /// Loads an FMU to replace `unit`; the unit's parameters are passed on as far as the FMU has them.
    pub(super) fn new(isolation: &Isolation, fmu: Fmu, unit: &dyn Unit, map: Map) -> Result<Self> {
        let mut values = Vec::with_capacity(unit.variables().len());
        for index in 0..unit.variables().len() {
            values.push(unit.get(index)?);
        }
        let (name, path) = (unit.name().to_owned(), fmu.path.display().to_string());
        let failed = |what: String| UnitError::new(&name, None, format!("`{path}`: {what}"));
        let folder = fmu.unpack()?;
        let root = std::path::absolute(folder.path()).map_err(|e| failed(e.to_string()))?;
        let instance = fmu::Fmu {
            binary: root.join(fmu.binary()?),
            folder: root,
            version: match fmu.version() {
                FmiVersion::V2 => Version::V2,
                FmiVersion::V3 => Version::V3,
            },
            token: fmu.token().to_owned(),
            name: name.clone(),
        };
        let session = Session::load(isolation, instance).map_err(failed)?;
        let mut foreign = Self {
            name,
            fmu: path,
            variables: unit.variables().to_vec(),
            values,
            counterparts: map.counterparts,
            parameters: map.parameters,
            notes: Vec::new(),
            session,
            _folder: folder,
        };
        foreign.note(map.notes);
        Ok(foreign)
    }

    fn note(&mut self, notes: Vec<String>) {
        for note in notes {
            let length = self.notes.len();
            if length < MOST_NOTES {
                self.notes.push(format!("`{}`: {note}", self.fmu));
            } else if length == MOST_NOTES {
                self.notes.push(format!("`{}`: there is more", self.fmu));
            }
        }
    }

    /// The values of all variables that are sent to the FMU, under its names.
    fn told(&self, causality: Causality) -> Vec<(fmu::Variable, Datum)> {
        let counterparts = self.counterparts.iter().filter(|c| c.causality == causality);
        let pair =
            |c: &Counterpart| Some((foreign(&c.theirs)?, outward(c, self.values.get(c.index)?)));
        counterparts.filter_map(pair).collect()
    }

    /// Processes a reply: stores its notes and the outputs' values.
    fn take(&mut self, answer: Reply, when: impl Fn() -> String) -> Result<(), UnitError> {
        self.note(answer.notes);
        let read = answer.result.map_err(|what| self.failed(&format!("{}{what}", when())))?;
        let outputs = self.counterparts.iter().filter(|c| c.causality == Causality::Output);
        let mut values = Vec::with_capacity(read.len());
        for (counterpart, datum) in outputs.zip(read) {
            values.push((counterpart.index, self.inward(counterpart, datum)?));
        }
        for (index, value) in values {
            if let Some(slot) = self.values.get_mut(index) {
                *slot = value;
            }
        }
        Ok(())
    }

    fn failed(&self, what: &str) -> UnitError {
        UnitError::new(&self.name, None, format!("`{}`: {what}", self.fmu))
    }

    /// A value received from the FMU, in the unit's type.
    fn inward(&self, counterpart: &Counterpart, datum: Datum) -> Result<Value, UnitError> {
        match (counterpart.kind, datum) {
            (Kind::Exact, Datum::Text(text)) => match exact::parse("value", &text) {
                Ok(number) => Ok(Value::Exact(Quotient::from(&number))),
                Err(_) => {
                    let what = format!("`{text}` from `{}`: expected a number p/q", self.fmu);
                    Err(at_variable(self, counterpart.index, what))
                }
            },
            (_, Datum::Real(x)) => {
                Ok(Value::Real(counterpart.conversion.map_or(x, |c| c.inward(x))))
            }
            (_, Datum::Integer(n)) => Ok(Value::Integer(n)),
            (_, Datum::Boolean(b)) => Ok(Value::Boolean(b)),
            (_, Datum::Text(t)) => Ok(Value::Text(t.into())),
        }
    }
}

/// A value as the FMU expects it: in its physical unit, exact numbers as text.
fn outward(counterpart: &Counterpart, value: &Value) -> Datum {
    match (value, counterpart.conversion) {
        (Value::Real(x), Some(conversion)) => Datum::Real(conversion.outward(*x)),
        // Parameters: identifiers, counts and periods, far below 2^53.
        (Value::Integer(n), _) if counterpart.theirs.is_real() => Datum::Real(*n as f64),
        _ => plain(value),
    }
}

/// A value in FMI types: exact numbers as text.
fn plain(value: &Value) -> Datum {
    match value {
        Value::Real(x) => Datum::Real(*x),
        Value::Integer(n) => Datum::Integer(*n),
        Value::Boolean(b) => Datum::Boolean(*b),
        Value::Text(t) => Datum::Text(t.to_string()),
        Value::Exact(x) => Datum::Text(x.to_string()),
    }
}

/// A variable as the calls need it. (Types without calls were refused before.)
fn foreign(variable: &FmuVariable) -> Option<fmu::Variable> {
    let kind = match variable.kind.as_str() {
        "Real" | "Float64" => Type::Float64,
        "Float32" => Type::Float32,
        "Int8" => Type::Int8,
        "UInt8" => Type::UInt8,
        "Int16" => Type::Int16,
        "UInt16" => Type::UInt16,
        "Integer" | "Int32" => Type::Int32,
        "UInt32" => Type::UInt32,
        "Int64" => Type::Int64,
        "UInt64" => Type::UInt64,
        "Boolean" => Type::Boolean,
        "String" => Type::String,
        _ => return None,
    };
    Some(fmu::Variable { name: variable.name.clone(), reference: variable.reference, kind })
}

/// The step in which something happened, in words.
fn during(grid: &Grid, step: u64) -> String {
    format!("step {step}, from {} s: ", grid.time_f64(step))
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
        if let Some(slot) = self.values.get_mut(variable) {
            *slot = value.clone();
        }
        Ok(())
    }

    fn get(&self, variable: usize) -> Result<Value, UnitError> {
        self.values.get(variable).cloned().ok_or_else(|| no_such_variable(self, variable))
    }

    fn initialise(&mut self, grid: &Grid) -> Result<(), UnitError> {
        let outputs = self.counterparts.iter().filter(|c| c.causality == Causality::Output);
        let mut parameters = self.told(Causality::Parameter);
        let own = self.parameters.iter();
        parameters.extend(own.filter_map(|(v, value)| Some((foreign(v)?, plain(value)))));
        let beginning = Beginning {
            parameters,
            inputs: self.told(Causality::Input),
            outputs: outputs.filter_map(|c| foreign(&c.theirs)).collect(),
            stop: grid.time_f64(grid.steps()),
        };
        let answer = self.session.initialise(beginning);
        self.take(answer, String::new)
    }

    fn begin_step(&mut self, grid: &Grid, step: u64) -> Result<(), UnitError> {
        let (from, size) = (grid.time_f64(step), grid.tau_f64());
        let inputs = self.counterparts.iter().filter(|c| c.causality == Causality::Input);
        let inputs = inputs.filter_map(|c| Some(outward(c, self.values.get(c.index)?)));
        let begun = self.session.begin_step(from, size, inputs.collect());
        begun.map_err(|what| self.failed(&format!("{}{what}", during(grid, step))))
    }

    fn do_step(&mut self, grid: &Grid, step: u64) -> Result<(), UnitError> {
        let answer = self.session.end_step();
        self.take(answer, || during(grid, step))
    }

    fn notes(&self) -> &[String] {
        &self.notes
    }
}
