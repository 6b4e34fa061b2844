//! Where the files of a multi-model are.

use std::path::{Path, PathBuf};

use serde_json::Value as Json;

use super::MultiModel;
use crate::fmi::uri;
use cordon_core::files::{self, Limit};
use cordon_core::{Error, Result};

/// A multi-model with the configuration of its co-simulation.
pub(super) struct Found {
    pub model: MultiModel,
    /// Folder of the multi-model's file.
    pub folder: PathBuf,
}

/// Reads a multi-model, or the configuration of a co-simulation (`.coe.json`), which names one
/// in `multimodel_path`.
///
/// # Errors
/// A file cannot be read or is something else.
pub(super) fn model(path: &Path) -> Result<Found> {
    let fail = |what: String| Error::input(format!("{}: {what}", path.display()));
    let folder = path.parent().unwrap_or(Path::new("."));
    let text = files::read_text(path, Limit::MULTI_MODEL)?;
    let mut json: Json = serde_json::from_str(&text)
        .map_err(|e| fail(format!("expected an INTO-CPS multi-model: {e}")))?;
    let named = json.get("multimodel_path").and_then(Json::as_str);
    let Some(named) = named.filter(|_| json.get("fmus").is_none()).map(str::to_owned) else {
        let model = serde_json::from_value(json)
            .map_err(|e| fail(format!("expected an INTO-CPS multi-model: {e}")))?;
        return Ok(Found { model, folder: folder.to_owned() });
    };
    let path = file(folder, &named).map_err(|e| fail(e.to_string()))?;
    let text = files::read_text(&path, Limit::MULTI_MODEL)?;
    let fail =
        |e| Error::input(format!("{}: expected an INTO-CPS multi-model: {e}", path.display()));
    let mut model: Json = serde_json::from_str(&text).map_err(fail)?;
    // What the configuration says goes before what the multi-model says.
    if let (Some(model), Some(configuration)) = (model.as_object_mut(), json.as_object_mut()) {
        configuration.remove("multimodel_path");
        model.append(configuration);
    }
    let model = serde_json::from_value(model).map_err(fail)?;
    Ok(Found { model, folder: path.parent().unwrap_or(Path::new(".")).to_owned() })
}

/// A file that is named by a path or a `file:` URI: beside the multi-model, in a folder above it
/// or that folder's `FMUs`, as projects of the INTO-CPS application have them, or from where the
/// program runs.
///
/// # Errors
/// There is none, or the URI is none of a file here.
pub(super) fn file(folder: &Path, name: &str) -> Result<PathBuf> {
    let path = uri::path(name)?;
    let absolute = std::path::absolute(folder).unwrap_or(folder.to_owned());
    let above =
        absolute.ancestors().skip(1).flat_map(|a| [a.join(&path), a.join("FMUs").join(&path)]);
    let beside = folder.join(&path);
    let elsewhere = above.chain([path.clone()]).find(|candidate| candidate.is_file());
    match elsewhere {
        Some(found) if !beside.is_file() => Ok(found),
        // Where there is none anywhere, that beside it is the one that is missing.
        _ => Ok(beside),
    }
}
