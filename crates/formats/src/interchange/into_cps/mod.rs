//! INTO-CPS multi-models: the JSON files of Maestro and the INTO-CPS application.
//!
//! One file holds both the multi-model (`fmus`, `connections`, `parameters`) and the configuration of
//! the co-simulation (`algorithm`, `endTime`, `logVariables`), as Maestro accepts it.

mod locate;
mod write;

pub use locate::holds_multi_model;
pub(super) use locate::system;
pub use write::{FILE_NAME, fmu_file, multi_model};

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// A multi-model with its configuration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct MultiModel {
    /// Files of the FMUs by their keys, `{key}`.
    pub fmus: BTreeMap<String, String>,
    /// From an output `{key}.instance.variable` to inputs.
    pub connections: BTreeMap<String, Vec<String>>,
    /// Values of parameters, and of unconnected inputs.
    #[serde(default)]
    pub parameters: BTreeMap<String, serde_json::Value>,
    /// The master's algorithm.
    #[serde(default)]
    pub algorithm: Option<MasterAlgorithm>,
    /// Start time in seconds.
    #[serde(default)]
    pub start_time: Option<f64>,
    /// End time in seconds.
    #[serde(default)]
    pub end_time: Option<f64>,
    /// Variables to log, by instance `{key}.instance`.
    #[serde(default)]
    pub log_variables: BTreeMap<String, Vec<String>>,
}

/// The master's algorithm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MasterAlgorithm {
    /// The kind of algorithm: only `fixed-step` is supported.
    #[serde(rename = "type")]
    pub kind: String,
    /// Length of a step in seconds.
    #[serde(default)]
    pub size: Option<f64>,
}
