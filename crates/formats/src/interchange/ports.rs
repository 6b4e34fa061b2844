//! The names in a system: `{fmu}.instance.variable`.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use serde_json::Value as Json;

use super::into_cps::MultiModel;
use cordon_core::{Error, Result};

/// An instance of an FMU.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Instance {
    /// Key of the FMU, in braces.
    pub fmu: String,
    /// Name of the instance.
    pub name: String,
}

/// A variable of an instance.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Port {
    /// The instance, with the FMU that it is one of.
    pub instance: Instance,
    /// Name of the variable.
    pub variable: String,
}

impl fmt::Display for Instance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.fmu, self.name)
    }
}

impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.instance, self.variable)
    }
}

impl Port {
    /// Splits `{fmu}.instance.variable`; the name of the variable may contain dots.
    fn parse(text: &str) -> Result<Self> {
        let parts = || {
            let (fmu, rest) = text.split_once("}.")?;
            let (name, variable) = rest.split_once('.')?;
            fmu.starts_with('{').then(|| Self {
                instance: Instance { fmu: format!("{fmu}}}"), name: name.to_owned() },
                variable: variable.to_owned(),
            })
        };
        parts()
            .ok_or_else(|| Error::input(format!("`{text}`: expected `{{fmu}}.instance.variable`")))
    }
}

/// A system by its ports.
#[derive(Default)]
pub(super) struct Ports {
    /// All connections, from output to input.
    pub wires: BTreeSet<(Port, Port)>,
    /// Values set, by instance and variable.
    pub settings: BTreeMap<Instance, BTreeMap<String, Json>>,
}

impl Ports {
    /// Reads all names of a multi-model.
    ///
    /// # Errors
    /// A malformed name, or an FMU that the multi-model does not have.
    pub fn of(model: &MultiModel) -> Result<Self> {
        let port = |text: &str| {
            let port = Port::parse(text)?;
            if model.fmus.contains_key(&port.instance.fmu) {
                return Ok(port);
            }
            let known: Vec<_> = model.fmus.keys().map(String::as_str).collect();
            Err(Error::input(format!("`{text}`: expected an FMU among {}", known.join(", "))))
        };
        let mut ports = Self::default();
        for (from, targets) in &model.connections {
            let from = port(from)?;
            for to in targets {
                ports.connect(from.clone(), port(to)?);
            }
        }
        for (name, value) in &model.parameters {
            ports.set(port(name)?, value.clone());
        }
        Ok(ports)
    }

    /// Connects an output with an input.
    pub fn connect(&mut self, from: Port, to: Port) {
        for end in [&from, &to] {
            self.settings.entry(end.instance.clone()).or_default();
        }
        self.wires.insert((from, to));
    }

    /// Sets a parameter.
    pub fn set(&mut self, Port { instance, variable }: Port, value: Json) {
        self.settings.entry(instance).or_default().insert(variable, value);
    }

    /// The instances that receive values from an instance (from one variable, or from any).
    pub fn targets(&self, from: &Instance, variable: Option<&str>) -> BTreeSet<Instance> {
        self.wires
            .iter()
            .filter(|(f, _)| f.instance == *from && variable.is_none_or(|v| v == f.variable))
            .map(|(_, to)| to.instance.clone())
            .collect()
    }
}
