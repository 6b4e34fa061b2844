//! Reading SSP archives: components that are FMUs, connections of their connectors, parameter bindings.
//!
//! Other elements of a system structure are refused by name where they would change the run.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde_json::{Value as Json, json};

use super::STRUCTURE;
use crate::fmi::archive::{self, Archive, Fmu};
use crate::interchange::ports::{Instance, Port, Ports};
use crate::interchange::read::{Clock, System};
use cordon_core::{Error, Result};

/// The types of FMU components and of parameter files, which are also the defaults.
const FMU: &str = "application/x-fmu-sharedlibrary";
const PARAMETER_SET: &str = "application/x-ssp-parameter-set";

#[derive(Deserialize)]
#[serde(rename = "SystemStructureDescription")]
struct Structure {
    #[serde(rename = "@name")]
    name: Option<String>,
    #[serde(rename = "System")]
    system: Root,
    #[serde(rename = "DefaultExperiment")]
    experiment: Option<Experiment>,
}

#[derive(Deserialize)]
struct Experiment {
    #[serde(rename = "@startTime")]
    start: Option<f64>,
    #[serde(rename = "@stopTime")]
    stop: Option<f64>,
}

#[derive(Deserialize)]
struct Root {
    #[serde(rename = "Elements", default)]
    elements: Elements,
    #[serde(rename = "Connections", default)]
    connections: Connections,
    #[serde(rename = "ParameterBindings", default)]
    bindings: Bindings,
}

#[derive(Deserialize, Default)]
struct Elements {
    #[serde(rename = "Component", default)]
    components: Vec<Component>,
    #[serde(rename = "System", default)]
    systems: Vec<Named>,
    #[serde(rename = "SignalDictionaryReference", default)]
    dictionaries: Vec<Named>,
}

#[derive(Deserialize)]
struct Named {
    #[serde(rename = "@name", default)]
    name: String,
}

#[derive(Deserialize)]
struct Component {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@type")]
    kind: Option<String>,
    #[serde(rename = "@source")]
    source: String,
    #[serde(rename = "@implementation")]
    implementation: Option<String>,
    #[serde(rename = "ParameterBindings", default)]
    bindings: Bindings,
}

#[derive(Deserialize, Default)]
struct Connections {
    #[serde(rename = "Connection", default)]
    list: Vec<Connection>,
}

#[derive(Deserialize)]
struct Connection {
    #[serde(rename = "@startElement")]
    start_element: Option<String>,
    #[serde(rename = "@startConnector")]
    start_connector: String,
    #[serde(rename = "@endElement")]
    end_element: Option<String>,
    #[serde(rename = "@endConnector")]
    end_connector: String,
    #[serde(rename = "LinearTransformation")]
    linear: Option<Nothing>,
    #[serde(rename = "BooleanMappingTransformation")]
    boolean: Option<Nothing>,
    #[serde(rename = "IntegerMappingTransformation")]
    integer: Option<Nothing>,
    #[serde(rename = "EnumerationMappingTransformation")]
    enumeration: Option<Nothing>,
}

/// An element whose content is ignored.
#[derive(Deserialize)]
struct Nothing {}

#[derive(Deserialize, Default)]
struct Bindings {
    #[serde(rename = "ParameterBinding", default)]
    list: Vec<Binding>,
}

#[derive(Deserialize)]
struct Binding {
    #[serde(rename = "@type")]
    kind: Option<String>,
    #[serde(rename = "@source")]
    source: Option<String>,
    #[serde(rename = "@sourceBase")]
    base: Option<String>,
    #[serde(rename = "@prefix", default)]
    prefix: String,
    #[serde(rename = "ParameterValues")]
    values: Option<Values>,
    #[serde(rename = "ParameterMapping")]
    mapping: Option<Nothing>,
}

#[derive(Deserialize)]
struct Values {
    #[serde(rename = "ParameterSet", default)]
    sets: Vec<ParameterSet>,
}

#[derive(Deserialize)]
struct ParameterSet {
    #[serde(rename = "Parameters", default)]
    parameters: Parameters,
}

#[derive(Deserialize, Default)]
struct Parameters {
    #[serde(rename = "Parameter", default)]
    list: Vec<Parameter>,
}

#[derive(Deserialize)]
struct Parameter {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "Real")]
    real: Option<Real>,
    #[serde(rename = "Integer")]
    integer: Option<Integer>,
    #[serde(rename = "Boolean")]
    boolean: Option<Boolean>,
    #[serde(rename = "String")]
    text: Option<Text>,
}

#[derive(Deserialize)]
struct Real {
    #[serde(rename = "@value")]
    value: f64,
}

#[derive(Deserialize)]
struct Integer {
    #[serde(rename = "@value")]
    value: i64,
}

#[derive(Deserialize)]
struct Boolean {
    #[serde(rename = "@value")]
    value: bool,
}

#[derive(Deserialize)]
struct Text {
    #[serde(rename = "@value")]
    value: String,
}

/// The system of an archive.
///
/// # Errors
/// It cannot be read, or has an unsupported element that would change the run: the message names it.
pub(in super::super) fn system(path: &Path) -> Result<System> {
    let fail = |what: String| Error::input(format!("{}: {what}", path.display()));
    let mut archive = archive::opened(path)?;
    let text = archive::entry(&mut archive, STRUCTURE, "an SSP archive").map_err(fail)?;
    let structure: Structure = xml(STRUCTURE, &text).map_err(fail)?;
    let Root { elements, connections, bindings } = structure.system;
    let refused = [("system", &elements.systems), ("signal dictionary", &elements.dictionaries)];
    for (what, list) in refused {
        if let Some(Named { name }) = list.first() {
            return Err(fail(format!("{what} `{name}`: expected components that are FMUs")));
        }
    }
    let mut fmus = BTreeMap::new();
    let mut instances = BTreeMap::new();
    let mut ports = Ports::default();
    for component in &elements.components {
        let instance = component.instance().map_err(fail)?;
        if !fmus.contains_key(&instance.fmu) {
            fmus.insert(instance.fmu.clone(), Fmu::open(&path.join(&component.source))?);
        }
        ports.settings.entry(instance.clone()).or_default();
        if instances.insert(component.name.as_str(), instance).is_some() {
            let name = &component.name;
            return Err(fail(format!("component `{name}` occurs twice: expected different names")));
        }
    }
    let of = |name: Option<&str>, variable: &str| {
        let instance = name.and_then(|n| instances.get(n));
        let port = |i: &Instance| Port { instance: i.clone(), variable: variable.to_owned() };
        instance.map(port).ok_or_else(|| {
            let name = name.unwrap_or("the system");
            fail(format!("`{name}.{variable}`: expected a connector of a component"))
        })
    };
    for c in &connections.list {
        let from = of(c.start_element.as_deref(), &c.start_connector)?;
        let to = of(c.end_element.as_deref(), &c.end_connector)?;
        if let Some(what) = c.transformation() {
            return Err(fail(format!("connection to `{to}`: {what}: expected none")));
        }
        ports.connect(from, to);
    }
    // Values set on a component override those set on the system.
    for (name, value) in all_parameters(&mut archive, &bindings).map_err(fail)? {
        let (component, variable) = name.split_once('.').unwrap_or(("the system", &name));
        ports.set(of(Some(component), variable)?, value);
    }
    for component in &elements.components {
        for (name, value) in all_parameters(&mut archive, &component.bindings).map_err(fail)? {
            ports.set(of(Some(&component.name), &name)?, value);
        }
    }
    let Experiment { start, stop } =
        structure.experiment.unwrap_or(Experiment { start: None, stop: None });
    let title = structure.name;
    Ok(System { title, fmus, ports, clock: Clock::Units, start, end: stop })
}

fn xml<T: for<'d> Deserialize<'d>>(name: &str, text: &str) -> std::result::Result<T, String> {
    quick_xml::de::from_str(text).map_err(|e| format!("its `{name}` cannot be read: {e}"))
}

impl Component {
    fn instance(&self) -> std::result::Result<Instance, String> {
        let Self { name, source, .. } = self;
        let fail = |field: &str, found: &str, expected: &str| {
            Err(format!("component `{name}`: {field} `{found}`: expected {expected}"))
        };
        if let Some(kind) = self.kind.as_deref().filter(|kind| *kind != FMU) {
            return fail("type", kind, &format!("`{FMU}`"));
        }
        match self.implementation.as_deref() {
            Some("ModelExchange") => {
                return fail("implementation", "ModelExchange", "`CoSimulation`");
            }
            _ if source.contains(':') || source.split('/').any(|part| part == "..") => {
                return fail("source", source, "a file in the archive");
            }
            _ => {}
        }
        Ok(Instance { fmu: format!("{{{source}}}"), name: name.clone() })
    }
}

impl Connection {
    fn transformation(&self) -> Option<&'static str> {
        let Self { linear, boolean, integer, enumeration, .. } = self;
        let known = [
            ("LinearTransformation", linear),
            ("BooleanMappingTransformation", boolean),
            ("IntegerMappingTransformation", integer),
            ("EnumerationMappingTransformation", enumeration),
        ];
        known.into_iter().find(|(_, found)| found.is_some()).map(|(name, _)| name)
    }
}

/// The parameters of all bindings, in order.
fn all_parameters(
    archive: &mut Archive,
    bindings: &Bindings,
) -> std::result::Result<Vec<(String, Json)>, String> {
    let mut all = Vec::new();
    for binding in &bindings.list {
        let Binding { kind, source, base, prefix, values, mapping } = binding;
        if mapping.is_some() {
            return Err("ParameterMapping: expected parameters by their own names".to_owned());
        }
        if let Some(kind) = kind.as_deref().filter(|kind| *kind != PARAMETER_SET) {
            return Err(format!("parameter binding of type `{kind}`: expected `{PARAMETER_SET}`"));
        }
        let mut inline = Vec::new();
        match (source, values) {
            (Some(file), _) if base.as_deref().is_none_or(|b| b == "SSD") => {
                let text = archive::entry(archive, file, "an SSP archive")?;
                inline.push(xml(file, &text)?);
            }
            (Some(file), _) => {
                return Err(format!("parameters `{file}`: expected a file in the archive"));
            }
            (None, _) => {}
        }
        let sets = inline.iter().chain(values.iter().flat_map(|v| &v.sets));
        for parameter in sets.flat_map(|set| &set.parameters.list) {
            all.push((format!("{prefix}{}", parameter.name), parameter.value()?));
        }
    }
    Ok(all)
}

impl Parameter {
    fn value(&self) -> std::result::Result<Json, String> {
        let Self { name, real, integer, boolean, text } = self;
        Ok(match (real, integer, boolean, text) {
            (Some(Real { value }), None, None, None) if value.is_finite() => json!(value),
            (None, Some(Integer { value }), None, None) => json!(value),
            (None, None, Some(Boolean { value }), None) => json!(value),
            (None, None, None, Some(Text { value })) => json!(value),
            _ => {
                return Err(format!(
                    "parameter `{name}`: expected a finite number, true, false or a text"
                ));
            }
        })
    }
}
