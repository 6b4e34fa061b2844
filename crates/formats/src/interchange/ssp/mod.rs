//! SSP 1.0: the system structure and its FMUs in one archive.

mod read;

pub(super) use read::system;

use std::io::{Cursor, Result};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

use super::{Assembly, Instance};
use crate::fmi::package;
use crate::fmi::units::{self, Xml, has_unit};
use cordon_core::exact;
use cordon_core::text::one_line;
use cordon_cosim::fmi::interface::{FmiVersion, Model};
use cordon_cosim::seat::Seat;
use cordon_cosim::unit::{Causality, Kind, Value, Variable};

/// File name extension of archives.
pub const ENDING: &str = "ssp";

/// The system structure in an archive.
const STRUCTURE: &str = "SystemStructure.ssd";

/// XML elements of the unit definitions.
const UNITS: units::Elements =
    units::Elements { list: "ssd:Units", unit: "ssc:Unit", base: "ssc:BaseUnit" };

/// The archive: `SystemStructure.ssd`, and the FMU of every model under `resources/`.
///
/// # Errors
/// The standards have no name for this platform, or something is too large for an archive.
pub fn archive(
    assembly: &Assembly,
    version: FmiVersion,
    binary: &[u8],
) -> cordon_core::Result<Vec<u8>> {
    let structure = structure(assembly)?;
    let mut files = vec![
        (STRUCTURE.to_owned(), structure),
        (PARAMETERS_FILE.to_owned(), parameters(assembly)?),
    ];
    for model in assembly.models() {
        files.push((source(model), package::fmu(model, version, binary)?));
    }
    let files: Vec<(&str, &[u8])> =
        files.iter().map(|(path, content)| (path.as_str(), content.as_slice())).collect();
    package::archive(&files)
}

/// All parameters in one file, for importers that take a separate file.
const PARAMETERS_FILE: &str = "resources/parameters.ssv";

/// The common name of all parameter sets: importers apply the sets of one name.
const PARAMETERS_NAME: &str = "parameters";

/// Names of the components, with numbers padded to equal length: importers match the prefix
/// `plant1.x0`, which must not match `plant10.x0`.
fn names(assembly: &Assembly) -> Vec<String> {
    let last = Seat::at(assembly.instances.len().saturating_sub(1)).drone;
    let width = last.to_string().len();
    let name = |(index, _): (usize, &Instance)| {
        let Seat { drone, unit } = Seat::at(index);
        format!("{}{drone:0width$}", unit.name())
    };
    assembly.instances.iter().enumerate().map(name).collect()
}

/// `resources/parameters.ssv`: every parameter as `component.parameter`.
///
/// # Errors
/// None: writing to memory cannot fail. The signature is that of the XML writer.
fn parameters(assembly: &Assembly) -> Result<Vec<u8>> {
    let mut xml = Writer::new_with_indent(Cursor::new(Vec::new()), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let mut all = Vec::new();
    for (name, instance) in names(assembly).iter().zip(&assembly.instances) {
        all.extend(instance.settings.iter().map(|(n, v)| (format!("{name}.{n}"), v.clone())));
    }
    parameter_set(&mut xml, &all, true)?;
    let mut bytes = xml.into_inner().into_inner();
    bytes.push(b'\n');
    Ok(bytes)
}

fn source(model: &Model) -> String {
    format!("resources/{}.fmu", model.identifier())
}

/// The system structure description.
///
/// # Errors
/// None: writing to memory cannot fail. The signature is that of the XML writer.
pub fn structure(assembly: &Assembly) -> Result<Vec<u8>> {
    let mut xml = Writer::new_with_indent(Cursor::new(Vec::new()), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    xml.create_element("ssd:SystemStructureDescription")
        .with_attribute(("xmlns:ssd", namespace("Description").as_str()))
        .with_attribute(("xmlns:ssc", namespace("Common").as_str()))
        .with_attribute(("xmlns:ssv", namespace("ParameterValues").as_str()))
        .with_attribute(("version", "1.0"))
        .with_attribute(("name", one_line(&assembly.title).as_str()))
        .with_attribute(("generationTool", concat!("cordon ", env!("CARGO_PKG_VERSION"))))
        .write_inner_content(|xml| {
            xml.create_element("ssd:System")
                .with_attribute(("name", "swarm"))
                .write_inner_content(|xml| swarm(xml, assembly))?;
            let variables: Vec<Variable> =
                assembly.models().into_iter().flat_map(Model::variables).collect();
            units::write(xml, &UNITS, variables.iter().filter(|v| is_connector(v)))?;
            let end = exact::to_f64(&assembly.end_time()).to_string();
            xml.create_element("ssd:DefaultExperiment")
                .with_attribute(("startTime", "0"))
                .with_attribute(("stopTime", end.as_str()))
                .write_empty()?;
            Ok(())
        })?;
    let mut bytes = xml.into_inner().into_inner();
    bytes.push(b'\n');
    Ok(bytes)
}

fn swarm(xml: &mut Xml, assembly: &Assembly) -> Result<()> {
    let names = names(assembly);
    xml.create_element("ssd:Elements").write_inner_content(|xml| {
        let named = names.iter().zip(&assembly.instances).enumerate();
        named.into_iter().try_for_each(|(index, (name, instance))| {
            let connected = |variable: &str| {
                let ends = assembly.connections.iter().flat_map(|(from, to)| [from, to]);
                ends.into_iter().any(|e| e.instance == index && e.variable == variable)
            };
            component(xml, name, instance, &connected)
        })
    })?;
    let name = |index: usize| names.get(index).map_or("", String::as_str);
    xml.create_element("ssd:Connections").write_inner_content(|xml| {
        for (from, to) in &assembly.connections {
            xml.create_element("ssd:Connection")
                .with_attribute(("startElement", name(from.instance)))
                .with_attribute(("startConnector", from.variable.as_str()))
                .with_attribute(("endElement", name(to.instance)))
                .with_attribute(("endConnector", to.variable.as_str()))
                .write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}

/// Writes a component. Unconnected inputs are written as parameters only: some importers send zeros to
/// every input among the connectors.
fn component(
    xml: &mut Xml,
    name: &str,
    instance: &Instance,
    connected: &dyn Fn(&str) -> bool,
) -> Result<()> {
    xml.create_element("ssd:Component")
        .with_attribute(("name", name))
        .with_attribute(("type", "application/x-fmu-sharedlibrary"))
        .with_attribute(("source", source(&instance.model).as_str()))
        .with_attribute(("implementation", "CoSimulation"))
        .write_inner_content(|xml| {
            xml.create_element("ssd:Connectors").write_inner_content(|xml| {
                for variable in instance.model.variables() {
                    let output = variable.causality == Causality::Output;
                    if is_connector(&variable) && (output || connected(&variable.name)) {
                        connector(xml, &variable)?;
                    }
                }
                Ok(())
            })?;
            if instance.settings.is_empty() {
                return Ok(());
            }
            nested(
                xml,
                &["ssd:ParameterBindings", "ssd:ParameterBinding", "ssd:ParameterValues"],
                &|xml| parameter_set(xml, &instance.settings, false),
            )
        })?;
    Ok(())
}

/// Nested elements without attributes.
fn nested(xml: &mut Xml, names: &[&str], inner: &dyn Fn(&mut Xml) -> Result<()>) -> Result<()> {
    match names {
        [] => inner(xml),
        [first, rest @ ..] => {
            xml.create_element(*first).write_inner_content(|xml| nested(xml, rest, inner))?;
            Ok(())
        }
    }
}

fn parameter_set(xml: &mut Xml, parameters: &[(String, Value)], is_root: bool) -> Result<()> {
    let mut set = xml
        .create_element("ssv:ParameterSet")
        .with_attribute(("version", "1.0"))
        .with_attribute(("name", PARAMETERS_NAME));
    if is_root {
        for (key, part) in [("xmlns:ssv", "ParameterValues"), ("xmlns:ssc", "Common")] {
            set = set.with_attribute((key, namespace(part).as_str()));
        }
    }
    set.write_inner_content(|xml| {
        xml.create_element("ssv:Parameters").write_inner_content(|xml| {
            for (name, value) in parameters {
                xml.create_element("ssv:Parameter")
                    .with_attribute(("name", name.as_str()))
                    .write_inner_content(|xml| {
                        xml.create_element(value_element(value))
                            .with_attribute(("value", value.to_string().as_str()))
                            .write_empty()?;
                        Ok(())
                    })?;
            }
            Ok(())
        })?;
        Ok(())
    })?;
    Ok(())
}

fn namespace(part: &str) -> String {
    format!("http://ssp-standard.org/SSP1/SystemStructure{part}")
}

fn value_element(value: &Value) -> &'static str {
    match value {
        Value::Real(_) => "ssv:Real",
        Value::Integer(_) => "ssv:Integer",
        Value::Boolean(_) => "ssv:Boolean",
        Value::Text(_) | Value::Exact(_) => "ssv:String",
    }
}

fn is_connector(variable: &Variable) -> bool {
    matches!(variable.causality, Causality::Input | Causality::Output)
}

fn connector(xml: &mut Xml, variable: &Variable) -> Result<()> {
    xml.create_element("ssd:Connector")
        .with_attribute(("name", variable.name.as_str()))
        .with_attribute(("kind", variable.causality.name()))
        .write_inner_content(|xml| {
            let mut kind = xml.create_element(match variable.kind() {
                Kind::Real => "ssc:Real",
                Kind::Integer => "ssc:Integer",
                Kind::Boolean => "ssc:Boolean",
                Kind::Text | Kind::Exact => "ssc:String",
            });
            if has_unit(variable) {
                kind = kind.with_attribute(("unit", variable.dimension.0));
            }
            kind.write_empty()?;
            Ok(())
        })?;
    Ok(())
}
