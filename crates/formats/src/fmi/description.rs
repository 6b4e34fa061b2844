//! `modelDescription.xml`, in both versions of the standard.

use std::io::{Cursor, Result};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

use super::units::{self, Xml, has_unit};
use cordon_core::exact;
use cordon_core::text::one_line;
use cordon_cosim::fmi::interface::{FmiVersion, Model, default_tau};
use cordon_cosim::unit::{Causality, Kind, Value, Variable};

/// Stop time proposed to importers, in seconds: that of the paper's figures.
const STOP_TIME: &str = "25";

/// XML elements of the unit definitions.
const UNITS: units::Elements =
    units::Elements { list: "UnitDefinitions", unit: "Unit", base: "BaseUnit" };

/// The model description of an exported unit.
///
/// # Errors
/// None: writing to memory cannot fail. The signature is that of the XML writer.
pub fn model_description(model: &Model, version: FmiVersion) -> Result<Vec<u8>> {
    let variables = model.variables();
    let mut xml = Writer::new_with_indent(Cursor::new(Vec::new()), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let token = model.token(version);
    let (key, generation_tool) = match version {
        FmiVersion::V2 => ("guid", concat!("cordon ", env!("CARGO_PKG_VERSION"))),
        FmiVersion::V3 => ("instantiationToken", concat!("cordon ", env!("CARGO_PKG_VERSION"))),
    };
    xml.create_element("fmiModelDescription")
        .with_attribute(("fmiVersion", version.name()))
        .with_attribute(("modelName", model.identifier()))
        .with_attribute((key, token.as_str()))
        .with_attribute(("description", one_line(&model.description()).as_str()))
        .with_attribute(("version", env!("CARGO_PKG_VERSION")))
        .with_attribute(("license", env!("CARGO_PKG_LICENSE")))
        .with_attribute(("generationTool", generation_tool))
        .with_attribute(("variableNamingConvention", "structured"))
        .write_inner_content(|xml| {
            capabilities(xml, model, version)?;
            units::write(xml, &UNITS, &variables)?;
            log_categories(xml)?;
            let tau = exact::to_f64(&default_tau()).to_string();
            xml.create_element("DefaultExperiment")
                .with_attribute(("startTime", "0"))
                .with_attribute(("stopTime", STOP_TIME))
                .with_attribute(("stepSize", tau.as_str()))
                .write_empty()?;
            xml.create_element("ModelVariables").write_inner_content(|xml| {
                for (reference, variable) in variables.iter().enumerate() {
                    match version {
                        FmiVersion::V2 => variable_2(xml, reference, variable)?,
                        FmiVersion::V3 => variable_3(xml, reference, variable)?,
                    }
                }
                match version {
                    FmiVersion::V2 => Ok(()),
                    FmiVersion::V3 => time_3(xml, variables.len()),
                }
            })?;
            structure(xml, model, version, &variables)
        })?;
    let mut bytes = xml.into_inner().into_inner();
    bytes.push(b'\n');
    Ok(bytes)
}

fn capabilities(xml: &mut Xml, model: &Model, version: FmiVersion) -> Result<()> {
    let element = xml
        .create_element("CoSimulation")
        .with_attribute(("modelIdentifier", model.identifier()))
        .with_attribute(("canHandleVariableCommunicationStepSize", "false"))
        .with_attribute(("canBeInstantiatedOnlyOncePerProcess", "false"));
    let element = match version {
        FmiVersion::V2 => element
            .with_attribute(("canNotUseMemoryManagementFunctions", "true"))
            .with_attribute(("canGetAndSetFMUstate", "true"))
            .with_attribute(("canSerializeFMUstate", "true")),
        FmiVersion::V3 => element
            .with_attribute(("canGetAndSetFMUState", "true"))
            .with_attribute(("canSerializeFMUState", "true")),
    };
    element.write_empty()?;
    Ok(())
}

fn log_categories(xml: &mut Xml) -> Result<()> {
    xml.create_element("LogCategories").write_inner_content(|xml| {
        xml.create_element("Category")
            .with_attribute(("name", "logStatusError"))
            .with_attribute(("description", "why a call was refused"))
            .write_empty()?;
        Ok(())
    })?;
    Ok(())
}

/// Variability: parameters are fixed, doubles continuous unless they change only at some steps.
fn variability(variable: &Variable) -> &'static str {
    match (variable.causality, variable.kind()) {
        (Causality::Parameter, _) => "fixed",
        (_, Kind::Real) => "continuous",
        _ => "discrete",
    }
}

/// The attribute `initial`, which inputs do not have.
fn initial(variable: &Variable) -> Option<&'static str> {
    match variable.causality {
        Causality::Parameter => Some("exact"),
        Causality::Input => None,
        Causality::Output | Causality::Local => Some("calculated"),
    }
}

/// The start value, where the importer can change it.
fn start(variable: &Variable) -> Option<String> {
    match variable.causality {
        Causality::Parameter | Causality::Input => Some(match &variable.start {
            Value::Real(x) => x.to_string(),
            other => other.to_string(),
        }),
        Causality::Output | Causality::Local => None,
    }
}

fn variable_2(xml: &mut Xml, reference: usize, variable: &Variable) -> Result<()> {
    let mut element = xml
        .create_element("ScalarVariable")
        .with_attribute(("name", variable.name.as_str()))
        .with_attribute(("valueReference", reference.to_string().as_str()))
        .with_attribute(("description", variable.description))
        .with_attribute(("causality", variable.causality.name()))
        .with_attribute(("variability", variability(variable)));
    if let Some(initial) = initial(variable) {
        element = element.with_attribute(("initial", initial));
    }
    element.write_inner_content(|xml| {
        let mut value = xml.create_element(match variable.kind() {
            Kind::Real => "Real",
            Kind::Integer => "Integer",
            Kind::Boolean => "Boolean",
            Kind::Text | Kind::Exact => "String",
        });
        if has_unit(variable) {
            value = value.with_attribute(("unit", variable.dimension.0));
        }
        if let Some(start) = start(variable) {
            value = value.with_attribute(("start", start.as_str()));
        }
        value.write_empty()?;
        Ok(())
    })?;
    Ok(())
}

fn variable_3(xml: &mut Xml, reference: usize, variable: &Variable) -> Result<()> {
    let mut element = xml
        .create_element(match variable.kind() {
            Kind::Real => "Float64",
            Kind::Integer => "Int64",
            Kind::Boolean => "Boolean",
            Kind::Text | Kind::Exact => "String",
        })
        .with_attribute(("name", variable.name.as_str()))
        .with_attribute(("valueReference", reference.to_string().as_str()))
        .with_attribute(("description", variable.description))
        .with_attribute(("causality", variable.causality.name()))
        .with_attribute(("variability", variability(variable)));
    if let Some(initial) = initial(variable) {
        element = element.with_attribute(("initial", initial));
    }
    if has_unit(variable) {
        element = element.with_attribute(("unit", variable.dimension.0));
    }
    match (start(variable), variable.kind()) {
        (Some(start), Kind::Text | Kind::Exact) => {
            element.write_inner_content(|xml| {
                xml.create_element("Start")
                    .with_attribute(("value", start.as_str()))
                    .write_empty()?;
                Ok(())
            })?;
        }
        (Some(start), _) => {
            element.with_attribute(("start", start.as_str())).write_empty()?;
        }
        (None, _) => {
            element.write_empty()?;
        }
    }
    Ok(())
}

/// The independent variable, which FMI 3.0 lists among the variables.
fn time_3(xml: &mut Xml, reference: usize) -> Result<()> {
    xml.create_element("Float64")
        .with_attribute(("name", "time"))
        .with_attribute(("valueReference", reference.to_string().as_str()))
        .with_attribute(("description", "time in seconds"))
        .with_attribute(("causality", "independent"))
        .with_attribute(("variability", "continuous"))
        .write_empty()?;
    Ok(())
}

/// The reference to a variable in the model structure: in FMI 2.0 an index from 1, in FMI 3.0 the value
/// reference.
fn pointer(version: FmiVersion, index: usize) -> String {
    match version {
        FmiVersion::V2 => (index + 1).to_string(),
        FmiVersion::V3 => index.to_string(),
    }
}

fn structure(
    xml: &mut Xml,
    model: &Model,
    version: FmiVersion,
    variables: &[Variable],
) -> Result<()> {
    let attribute = match version {
        FmiVersion::V2 => "index",
        FmiVersion::V3 => "valueReference",
    };
    let outputs: Vec<(usize, &Variable)> =
        variables.iter().enumerate().filter(|(_, v)| v.causality == Causality::Output).collect();
    let unknown = |xml: &mut Xml, element: &str, index: usize, on: &[usize]| -> Result<()> {
        let on: Vec<String> = on.iter().map(|p| pointer(version, *p)).collect();
        xml.create_element(element)
            .with_attribute((attribute, pointer(version, index).as_str()))
            .with_attribute(("dependencies", on.join(" ").as_str()))
            .write_empty()?;
        Ok(())
    };
    let initially = |output: &Variable| -> Vec<usize> {
        let on = model.initial_dependencies(&output.name);
        let index = variables.iter().position(|v| Some(&v.name) == on.as_ref());
        index.into_iter().collect()
    };
    xml.create_element("ModelStructure").write_inner_content(|xml| {
        match version {
            FmiVersion::V2 => {
                xml.create_element("Outputs").write_inner_content(|xml| {
                    outputs
                        .iter()
                        .try_for_each(|(p, v)| unknown(xml, "Unknown", *p, &v.feedthrough))
                })?;
                xml.create_element("InitialUnknowns").write_inner_content(|xml| {
                    outputs.iter().try_for_each(|(p, v)| unknown(xml, "Unknown", *p, &initially(v)))
                })?;
            }
            FmiVersion::V3 => {
                for (index, v) in &outputs {
                    unknown(xml, "Output", *index, &v.feedthrough)?;
                }
                for (index, v) in &outputs {
                    unknown(xml, "InitialUnknown", *index, &initially(v))?;
                }
            }
        }
        Ok(())
    })?;
    Ok(())
}
