//! An instance of an FMU and the calls that a unit needs, in both versions of the standard.

use std::ffi::CString;

use fmi::fmi2::import::Fmi2Import;
use fmi::fmi2::instance::{CoSimulation as _, Common as _, InstanceCS as Instance2};
use fmi::fmi3::import::Fmi3Import;
use fmi::fmi3::instance::InstanceCS as Instance3;
use fmi::fmi3::{CoSimulation as _, Common as _, Fmi3Model as _, GetSet as _};
use fmi::traits::FmiImport as _;

use super::adapter::Counterpart;
use super::log;
use crate::fmi::archive::Fmu;
use crate::fmi::interface::FmiVersion;
use crate::unit::Value;

/// What a unit asks of its FMU. `set` comes first, `get` last.
pub(super) enum Order {
    /// Begin at time 0, for a run until `stop`.
    Initialise {
        /// Parameters and inputs.
        set: Vec<(Counterpart, Value)>,
        /// Outputs.
        get: Vec<Counterpart>,
        /// Seconds.
        stop: f64,
    },
    /// Advance from `from` by `size`.
    Step {
        /// Inputs.
        set: Vec<(Counterpart, Value)>,
        /// Outputs.
        get: Vec<Counterpart>,
        /// Seconds.
        from: f64,
        /// Seconds.
        size: f64,
    },
}

/// An instance. The import, whose folder the binary is in, lives as long.
pub(super) enum Session {
    V2(Box<Instance2>, #[allow(dead_code, reason = "kept, not read")] Box<Fmi2Import>),
    V3(Box<Instance3>, #[allow(dead_code, reason = "kept, not read")] Box<Fmi3Import>),
}

/// A call's failure with what the FMU said about it.
fn explained(call: &str, status: impl std::fmt::Display) -> String {
    let said = log::take();
    // Statuses of the standard are words like `Error`; anything else is shown as it is.
    let status = match status.to_string() {
        word if word.chars().all(char::is_alphabetic) => word.to_lowercase(),
        text => text,
    };
    match said.is_empty() {
        true => format!("{call}: {status}, without a message"),
        false => format!("{call}: {}", said.join("; ")),
    }
}

impl Session {
    /// Loads the binary and makes an instance.
    pub(super) fn load(fmu: &Fmu, name: &str) -> Result<Self, String> {
        let failed = |e: fmi::Error| explained("loading", e);
        let folder = fmu.extract()?;
        let description = fmu.bare_description();
        match fmu.version {
            FmiVersion::V2 => {
                let import = Fmi2Import::new(folder, &description).map_err(failed)?;
                let instance = import.instantiate_cs(name, false, true).map_err(failed)?;
                Ok(Self::V2(Box::new(instance), Box::new(import)))
            }
            FmiVersion::V3 => {
                let import = Fmi3Import::new(folder, &description).map_err(failed)?;
                let instance =
                    import.instantiate_cs(name, false, true, false, false, &[]).map_err(failed)?;
                Ok(Self::V3(Box::new(instance), Box::new(import)))
            }
        }
    }

    /// Carries out an order; the outputs' values.
    pub(super) fn carry_out(&mut self, order: &Order) -> Result<Vec<Value>, String> {
        match order {
            Order::Initialise { set, get, stop } => {
                self.set_all(set)?;
                self.initialise(*stop)?;
                self.get_all(get)
            }
            Order::Step { set, get, from, size } => {
                self.set_all(set)?;
                self.step(*from, *size)?;
                self.get_all(get)
            }
        }
    }

    fn initialise(&mut self, stop: f64) -> Result<(), String> {
        match self {
            Self::V2(i, _) => i
                .setup_experiment(None, 0.0, Some(stop))
                .and_then(|_| i.enter_initialization_mode())
                .and_then(|_| i.exit_initialization_mode())
                .map(drop)
                .map_err(|e| explained("initialising", e)),
            Self::V3(i, _) => i
                .enter_initialization_mode(None, 0.0, Some(stop))
                .and_then(|_| i.exit_initialization_mode())
                .map(drop)
                .map_err(|e| explained("initialising", e)),
        }
    }

    fn step(&mut self, from: f64, size: f64) -> Result<(), String> {
        match self {
            Self::V2(i, _) => {
                i.do_step(from, size, true).map(drop).map_err(|e| explained("stepping", e))
            }
            Self::V3(i, _) => {
                let (mut event, mut end, mut early, mut last) = (false, false, false, from);
                i.do_step(from, size, true, &mut event, &mut end, &mut early, &mut last)
                    .map_err(|e| explained("stepping", e))?;
                if end || early {
                    return Err(format!("stepping: it stopped at {last} s on its own"));
                }
                Ok(())
            }
        }
    }

    fn set_all(&mut self, values: &[(Counterpart, Value)]) -> Result<(), String> {
        values.iter().try_for_each(|(counterpart, value)| self.set(counterpart, value))
    }

    fn set(&mut self, to: &Counterpart, value: &Value) -> Result<(), String> {
        let at = [to.reference];
        let text = |t: &str| CString::new(t).map_err(|_| "a text with a zero byte".to_owned());
        let narrow =
            |n: i64| i32::try_from(n).map_err(|_| format!("`{n}`: expected a number of 32 bits"));
        match (self, value) {
            (Self::V2(i, _), Value::Real(x)) => fmi2(i.set_real(&at, &[*x])),
            (Self::V2(i, _), Value::Integer(n)) => fmi2(i.set_integer(&at, &[narrow(*n)?])),
            (Self::V2(i, _), Value::Boolean(b)) => fmi2(i.set_boolean(&at, &[i32::from(*b)])),
            (Self::V2(i, _), Value::Text(t)) => fmi2(i.set_string(&at, &[text(t)?])),
            (Self::V3(i, _), Value::Real(x)) => fmi3(i.set_float64(&at, &[*x])),
            (Self::V3(i, _), Value::Integer(n)) if to.fmu_kind == "Int32" => {
                fmi3(i.set_int32(&at, &[narrow(*n)?]))
            }
            (Self::V3(i, _), Value::Integer(n)) => fmi3(i.set_int64(&at, &[*n])),
            (Self::V3(i, _), Value::Boolean(b)) => fmi3(i.set_boolean(&at, &[*b])),
            (Self::V3(i, _), Value::Text(t)) => fmi3(i.set_string(&at, &[text(t)?])),
            (_, Value::Exact(_)) => Err("an exact number that is no text".to_owned()),
        }
    }

    fn get_all(&mut self, from: &[Counterpart]) -> Result<Vec<Value>, String> {
        from.iter().map(|counterpart| self.get(counterpart)).collect()
    }

    fn get(&mut self, from: &Counterpart) -> Result<Value, String> {
        let at = [from.reference];
        let (mut x, mut n, mut wide, mut b, mut c_bool) = ([0.0], [0], [0], [false], [0]);
        let mut text = [CString::default()];
        let read = |text: &[CString; 1]| Value::Text(text[0].to_string_lossy().into());
        match (self, from.fmu_kind.as_str()) {
            (Self::V2(i, _), "Real") => fmi2(i.get_real(&at, &mut x)).map(|()| Value::Real(x[0])),
            (Self::V2(i, _), "Integer") => {
                fmi2(i.get_integer(&at, &mut n)).map(|()| Value::Integer(n[0].into()))
            }
            (Self::V2(i, _), "Boolean") => {
                fmi2(i.get_boolean(&at, &mut c_bool)).map(|()| Value::Boolean(c_bool[0] != 0))
            }
            (Self::V2(i, _), "String") => fmi2(i.get_string(&at, &mut text)).map(|()| read(&text)),
            (Self::V3(i, _), "Float64") => {
                fmi3(i.get_float64(&at, &mut x)).map(|()| Value::Real(x[0]))
            }
            (Self::V3(i, _), "Int32") => {
                fmi3(i.get_int32(&at, &mut n)).map(|()| Value::Integer(n[0].into()))
            }
            (Self::V3(i, _), "Int64") => {
                fmi3(i.get_int64(&at, &mut wide)).map(|()| Value::Integer(wide[0]))
            }
            (Self::V3(i, _), "Boolean") => {
                fmi3(i.get_boolean(&at, &mut b)).map(|()| Value::Boolean(b[0]))
            }
            (Self::V3(i, _), "String") => fmi3(i.get_string(&at, &mut text)).map(|()| read(&text)),
            (_, other) => Err(format!("variables of type {other} cannot be read")),
        }
    }
}

fn fmi2<T>(result: Result<T, fmi::fmi2::Fmi2Error>) -> Result<(), String> {
    result.map(drop).map_err(|e| explained("setting or reading variables", e))
}

fn fmi3<T>(result: Result<T, fmi::fmi3::Fmi3Error>) -> Result<(), String> {
    result.map(drop).map_err(|e| explained("setting or reading variables", e))
}
