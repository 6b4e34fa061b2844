//! Writes multi-models.

use serde_json::{Value as Json, json};

use super::{MasterAlgorithm, MultiModel};
use crate::interchange::{Assembly, End, Instance};
use cordon_core::exact;
use cordon_cosim::fmi::interface::Model;
use cordon_cosim::unit::Value;

/// Name of the multi-model in an exported folder.
pub const FILE_NAME: &str = "multi-model.json";

/// File name of a model's FMU, which is stored beside the multi-model.
pub fn fmu_file(model: &Model) -> String {
    format!("{}.fmu", model.identifier())
}

/// The key of a model.
fn key(model: &Model) -> String {
    format!("{{{}}}", model.identifier())
}

fn instance_key(instance: &Instance) -> String {
    format!("{}.{}", key(&instance.model), instance.name)
}

/// The multi-model of a co-simulation, with its FMUs beside it.
pub fn multi_model(assembly: &Assembly) -> MultiModel {
    let mut model = MultiModel {
        fmus: assembly.models().into_iter().map(|m| (key(m), fmu_file(m))).collect(),
        connections: Default::default(),
        parameters: Default::default(),
        algorithm: Some(MasterAlgorithm {
            kind: "fixed-step".to_owned(),
            size: Some(exact::to_f64(&assembly.tau)),
        }),
        start_time: Some(0.0),
        end_time: Some(exact::to_f64(&assembly.end_time())),
        log_variables: Default::default(),
    };
    let port = |end: &End| {
        let instance = assembly.instances.get(end.instance).map(instance_key).unwrap_or_default();
        format!("{instance}.{}", end.variable)
    };
    for (from, to) in &assembly.connections {
        model.connections.entry(port(from)).or_default().push(port(to));
    }
    for instance in &assembly.instances {
        let name = instance_key(instance);
        for (variable, value) in &instance.settings {
            model.parameters.insert(format!("{name}.{variable}"), to_json(value));
        }
        if let Some(variable) = Assembly::position_of(instance) {
            model.log_variables.insert(name, vec![variable.to_owned()]);
        }
    }
    model
}

/// The JSON value; exact numbers are text.
fn to_json(value: &Value) -> Json {
    match value {
        Value::Real(x) => json!(x),
        Value::Integer(n) => json!(n),
        Value::Boolean(b) => json!(b),
        Value::Text(_) | Value::Exact(_) => json!(value.to_string()),
    }
}
