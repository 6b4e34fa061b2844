//! Locating the files of a multi-model.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Value as Json;

use super::MultiModel;
use crate::fmi::archive::Fmu;
use crate::interchange::ports::Ports;
use crate::interchange::read::{Clock, System};
use cordon_core::files::{self, Limit};
use cordon_core::{Error, Result};
use cordon_cosim::fmi::uri;

/// Whether a JSON file is a multi-model, or a co-simulation configuration that names one, judged by its
/// fields: recorded runs are JSON too.
///
/// # Errors
/// The file cannot be read.
pub fn holds_multi_model(path: &Path) -> Result<bool> {
    #[derive(Deserialize)]
    struct Fields {
        fmus: Option<IgnoredAny>,
        multimodel_path: Option<IgnoredAny>,
        multimodel_crc: Option<IgnoredAny>,
    }
    let text = files::read_text(path, Limit::RUN)?;
    let fields = serde_json::from_str::<Fields>(&text);
    Ok(fields.is_ok_and(|f| {
        f.fmus.is_some() || f.multimodel_path.is_some() || f.multimodel_crc.is_some()
    }))
}

/// The system of a multi-model, or of a co-simulation configuration that names one.
///
/// # Errors
/// A file cannot be read or is something else; a name is malformed.
pub(in super::super) fn system(path: &Path) -> Result<System> {
    let named = |e: Error| match e {
        Error::Input(what) => Error::input(format!("{}: {what}", path.display())),
        e => e,
    };
    let Found { model, folder } = model(path)?;
    let ports = Ports::of(&model).map_err(named)?;
    let mut fmus = BTreeMap::new();
    // Projects may list FMUs that no longer have instances.
    let used = |key: &str| ports.settings.keys().any(|instance| instance.fmu == key);
    for (key, name) in model.fmus.iter().filter(|(key, _)| used(key)) {
        fmus.insert(key.clone(), Fmu::open(&file(&folder, name).map_err(named)?)?);
    }
    let MultiModel { algorithm, start_time: start, end_time: end, .. } = model;
    Ok(System { title: None, fmus, ports, clock: Clock::Said(algorithm), start, end })
}

/// A multi-model with the configuration of its co-simulation.
struct Found {
    model: MultiModel,
    /// Folder of the multi-model's file.
    folder: PathBuf,
}

/// Reads a multi-model, or a co-simulation configuration (`coe.json`) that names one in
/// `multimodel_path`, relative to the project's folder; where that file is missing or not named, the
/// multi-model is the one in the folder above the configuration.
///
/// # Errors
/// A file cannot be read or is something else.
fn model(path: &Path) -> Result<Found> {
    let fail = |what: String| Error::input(format!("{}: {what}", path.display()));
    let folder = path.parent().unwrap_or(Path::new("."));
    let text = files::read_json(path, Limit::MULTI_MODEL)?;
    let mut json: Json = serde_json::from_str(&text)
        .map_err(|e| fail(format!("expected an INTO-CPS multi-model: {e}")))?;
    if json.get("fmus").is_some() || CONFIGURATION.iter().all(|key| json.get(key).is_none()) {
        let model = serde_json::from_value(json)
            .map_err(|e| fail(format!("expected an INTO-CPS multi-model: {e}")))?;
        return Ok(Found { model, folder: folder.to_owned() });
    }
    let named = json.get("multimodel_path").and_then(Json::as_str).unwrap_or_default();
    let named = file(folder, named).map_err(|e| fail(e.to_string()))?;
    let path = if named.is_file() { named } else { above(folder).unwrap_or(named) };
    let text = files::read_json(&path, Limit::MULTI_MODEL)?;
    let fail =
        |e| Error::input(format!("{}: expected an INTO-CPS multi-model: {e}", path.display()));
    let mut model: Json = serde_json::from_str(&text).map_err(fail)?;
    // The configuration overrides the multi-model.
    if let (Some(model), Some(configuration)) = (model.as_object_mut(), json.as_object_mut()) {
        configuration
            .retain(|key, value| !CONFIGURATION.contains(&key.as_str()) && !value.is_null());
        model.append(configuration);
    }
    let model = serde_json::from_value(model).map_err(fail)?;
    Ok(Found { model, folder: path.parent().unwrap_or(Path::new(".")).to_owned() })
}

/// The fields by which a configuration identifies its multi-model: its path, or its checksum.
const CONFIGURATION: [&str; 2] = ["multimodel_path", "multimodel_crc"];

/// The only multi-model in the folder above a configuration: the layout of the INTO-CPS application.
fn above(folder: &Path) -> Option<PathBuf> {
    let absolute = std::path::absolute(folder).ok()?;
    let entries = std::fs::read_dir(absolute.parent()?).ok()?;
    let files = entries.flatten().map(|entry| entry.path());
    let named = |path: &PathBuf| path.to_string_lossy().ends_with("mm.json");
    let mut found: Vec<PathBuf> = files.filter(named).collect();
    found.pop().filter(|_| found.is_empty())
}

/// Finds a file named by a path or a `file:` URI: beside the multi-model, in a folder above it or that
/// folder's `FMUs` (the layout of the INTO-CPS application), or relative to the working directory.
///
/// # Errors
/// There is no such file, or the URI does not denote a file on this machine.
fn file(folder: &Path, name: &str) -> Result<PathBuf> {
    // Projects made on Windows have backslashes.
    let path = uri::path(&name.replace('\\', "/"))?;
    let absolute = std::path::absolute(folder).unwrap_or(folder.to_owned());
    let above =
        absolute.ancestors().skip(1).flat_map(|a| [a.join(&path), a.join("FMUs").join(&path)]);
    let beside = folder.join(&path);
    let elsewhere = above.chain([path.clone()]).find(|candidate| candidate.is_file());
    match elsewhere {
        Some(found) if !beside.is_file() => Ok(found),
        // If none exists, report the one beside the multi-model as missing.
        _ => Ok(beside),
    }
}
