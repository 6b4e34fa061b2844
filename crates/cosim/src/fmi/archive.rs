//! Reading FMUs: the archive, the model description, the binaries in it.

use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};

use serde::Deserialize;
use zip::ZipArchive;

use super::interface::{FmiVersion, Model};
use super::package::platform;
use cordon_core::{Error, Result};

/// An FMU on disk, its model description read.
#[derive(Clone, Debug, PartialEq)]
pub struct Fmu {
    /// Where it is.
    pub path: PathBuf,
    /// Version of the standard.
    pub version: FmiVersion,
    /// Name of the model.
    pub model_name: String,
    /// Identifier with which instances are made.
    pub token: String,
    /// Name of the binary, where the FMU is for co-simulation.
    identifier: Option<String>,
    /// Variables, in the description's order.
    pub variables: Vec<FmuVariable>,
    /// Platforms that it has binaries for.
    platforms: Vec<String>,
    /// Paths of all its files.
    files: Vec<String>,
}

/// A variable of an FMU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FmuVariable {
    /// Name.
    pub name: String,
    /// Value reference.
    pub reference: u32,
    /// The element of the model description: `Real`, `Float64`, ...
    pub kind: String,
    /// `input`, `output`, `parameter`, `local`, ...
    pub causality: String,
    /// Physical unit.
    pub unit: Option<String>,
}

#[derive(Deserialize)]
#[serde(rename = "fmiModelDescription")]
struct Description {
    #[serde(rename = "@fmiVersion")]
    version: String,
    #[serde(rename = "@modelName", default)]
    model_name: String,
    #[serde(rename = "@guid", alias = "@instantiationToken", default)]
    token: String,
    #[serde(rename = "CoSimulation")]
    co_simulation: Option<CoSimulation>,
    #[serde(rename = "ModelVariables", default)]
    variables: ModelVariables,
}

#[derive(Deserialize)]
struct CoSimulation {
    #[serde(rename = "@modelIdentifier")]
    identifier: String,
}

#[derive(Deserialize, Default)]
struct ModelVariables {
    #[serde(rename = "$value", default)]
    list: Vec<Entry>,
}

/// An element of the list of variables: FMI 2.0 says the type inside, FMI 3.0 by its name.
#[derive(Deserialize)]
enum Entry {
    ScalarVariable(Scalar),
    Float64(Typed),
    Float32(Typed),
    Int64(Typed),
    Int32(Typed),
    Boolean(Typed),
    String(Typed),
    #[serde(other)]
    Other,
}

#[derive(Deserialize)]
struct Scalar {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@valueReference")]
    reference: u32,
    #[serde(rename = "@causality", default)]
    causality: Option<String>,
    #[serde(rename = "Real")]
    real: Option<RealType>,
    #[serde(rename = "Integer")]
    integer: Option<AnyType>,
    #[serde(rename = "Boolean")]
    boolean: Option<AnyType>,
    #[serde(rename = "String")]
    string: Option<AnyType>,
}

#[derive(Deserialize)]
struct RealType {
    #[serde(rename = "@unit")]
    unit: Option<String>,
}

#[derive(Deserialize)]
struct AnyType {}

#[derive(Deserialize)]
struct Typed {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@valueReference")]
    reference: u32,
    #[serde(rename = "@causality", default)]
    causality: Option<String>,
    #[serde(rename = "@unit", default)]
    unit: Option<String>,
}

impl Fmu {
    /// Reads an FMU.
    ///
    /// # Errors
    /// There is no such file; it is no archive, or a truncated one; it has no model description,
    /// or one of another version of the standard. The message names the file.
    pub fn open(path: &Path) -> Result<Self> {
        let bytes = std::fs::read(path).map_err(|e| Error::file("read", path, e))?;
        let fail = |what: String| Error::input(format!("`{}`: {what}", path.display()));
        let mut archive = ZipArchive::new(Cursor::new(bytes))
            .map_err(|e| fail(format!("expected an FMU, a whole zip archive: {e}")))?;
        let files: Vec<String> = archive.file_names().map(str::to_owned).collect();
        let mut text = String::new();
        archive
            .by_name("modelDescription.xml")
            .map_err(|e| fail(format!("expected an FMU with a `modelDescription.xml`: {e}")))?
            .read_to_string(&mut text)
            .map_err(|e| fail(format!("its `modelDescription.xml` cannot be read: {e}")))?;
        Self::from_description(path, &text, files).map_err(fail)
    }

    fn from_description(path: &Path, text: &str, files: Vec<String>) -> Result<Self, String> {
        // The version comes first: other versions have other elements.
        let version = fmi_version(text)?;
        let description: Description = quick_xml::de::from_str(text)
            .map_err(|e| format!("its `modelDescription.xml` cannot be read: {e}"))?;
        debug_assert!(description.version.starts_with(version.name()));
        let mut platforms: Vec<String> = files
            .iter()
            .filter_map(|f| f.strip_prefix("binaries/")?.split_once('/'))
            .map(|(platform, _)| platform.to_owned())
            .collect();
        platforms.sort();
        platforms.dedup();
        Ok(Self {
            path: path.to_owned(),
            version,
            model_name: description.model_name,
            token: description.token,
            identifier: description.co_simulation.map(|c| c.identifier),
            variables: description.variables.list.into_iter().filter_map(variable).collect(),
            platforms,
            files,
        })
    }

    /// The model of this program that the FMU was exported from.
    pub fn model(&self) -> Option<Model> {
        Model::ALL.into_iter().find(|m| m.token(self.version) == self.token)
    }

    /// A variable by name.
    pub fn variable(&self, name: &str) -> Option<&FmuVariable> {
        self.variables.iter().find(|v| v.name == name)
    }

    /// Checks that it can be co-simulated on this platform.
    ///
    /// # Errors
    /// It is not for co-simulation, or has no binary for this platform.
    pub fn expect_runnable(&self) -> Result<()> {
        let fail = |what: String| Err(Error::input(format!("`{}`: {what}", self.path.display())));
        let Some(identifier) = &self.identifier else {
            return fail("expected an FMU for co-simulation; it is for model exchange".to_owned());
        };
        let Some((folder, ending)) = platform(self.version) else {
            return fail("FMI has no name for this platform".to_owned());
        };
        let binary = format!("binaries/{folder}/{identifier}{ending}");
        if self.files.contains(&binary) {
            return Ok(());
        }
        let others = match self.platforms.as_slice() {
            [] => "no binaries at all".to_owned(),
            list => format!("binaries for {}", list.join(", ")),
        };
        fail(format!("expected `{binary}`, a binary for this platform; it has {others}"))
    }
}

#[cfg(feature = "fmi-import")]
impl Fmu {
    /// Extracts the archive into a temporary folder.
    ///
    /// # Errors
    /// It cannot be extracted, in words.
    pub(super) fn extract(&self) -> Result<tempfile::TempDir, String> {
        let failed = |e: &dyn std::fmt::Display| format!("it cannot be extracted: {e}");
        let folder = tempfile::Builder::new().prefix("cordon-fmu-").tempdir();
        let folder = folder.map_err(|e| failed(&e))?;
        let file = std::fs::File::open(&self.path).map_err(|e| failed(&e))?;
        let mut archive = ZipArchive::new(file).map_err(|e| failed(&e))?;
        archive.extract(&folder).map_err(|e| failed(&e))?;
        Ok(folder)
    }

    /// As much of the model description as it takes to make an instance. The crate `fmi` 0.8
    /// refuses whole ones: it does not know the attribute `unit` of FMI 3.0 variables.
    pub(super) fn bare_description(&self) -> String {
        let token_name = match self.version {
            FmiVersion::V2 => "guid",
            FmiVersion::V3 => "instantiationToken",
        };
        let text = |t: &str| quick_xml::escape::escape(t).into_owned();
        format!(
            "<fmiModelDescription fmiVersion=\"{}\" modelName=\"{}\" {token_name}=\"{}\">\
             <CoSimulation modelIdentifier=\"{}\"/><ModelVariables/><ModelStructure/>\
             </fmiModelDescription>",
            self.version,
            text(&self.model_name),
            text(&self.token),
            text(self.identifier.as_deref().unwrap_or_default())
        )
    }
}

/// The version that a model description says.
fn fmi_version(text: &str) -> Result<FmiVersion, String> {
    #[derive(Deserialize)]
    struct Root {
        #[serde(rename = "@fmiVersion")]
        version: String,
    }
    let root: Root = quick_xml::de::from_str(text)
        .map_err(|e| format!("its `modelDescription.xml` cannot be read: {e}"))?;
    match root.version.as_str() {
        "2.0" => Ok(FmiVersion::V2),
        v if v.starts_with("3.0") => Ok(FmiVersion::V3),
        other => Err(format!("fmiVersion `{other}`: expected 2.0 or 3.0")),
    }
}

fn variable(entry: Entry) -> Option<FmuVariable> {
    let (kind, v) = match entry {
        Entry::ScalarVariable(s) => {
            let kind = match (&s.real, &s.integer, &s.boolean, &s.string) {
                (Some(_), ..) => "Real",
                (_, Some(_), ..) => "Integer",
                (_, _, Some(_), _) => "Boolean",
                (_, _, _, Some(_)) => "String",
                _ => return None,
            };
            let unit = s.real.and_then(|r| r.unit);
            (kind, Typed { name: s.name, reference: s.reference, causality: s.causality, unit })
        }
        Entry::Float64(v) => ("Float64", v),
        Entry::Float32(v) => ("Float32", v),
        Entry::Int64(v) => ("Int64", v),
        Entry::Int32(v) => ("Int32", v),
        Entry::Boolean(v) => ("Boolean", v),
        Entry::String(v) => ("String", v),
        Entry::Other => return None,
    };
    Some(FmuVariable {
        name: v.name,
        reference: v.reference,
        kind: kind.to_owned(),
        causality: v.causality.unwrap_or_else(|| "local".to_owned()),
        unit: v.unit,
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::fmi::description::model_description;

    #[test]
    fn reads_back_every_model_description() {
        let mut compared = 0;
        for model in Model::ALL {
            for version in [FmiVersion::V2, FmiVersion::V3] {
                let text = String::from_utf8(model_description(model, version).unwrap()).unwrap();
                let fmu = Fmu::from_description(Path::new("x.fmu"), &text, Vec::new()).unwrap();
                assert_eq!((fmu.version, fmu.model()), (version, Some(model)));
                assert_eq!(fmu.model_name, model.identifier());
                for (place, v) in model.variables().iter().enumerate() {
                    let read = fmu.variable(&v.name).unwrap();
                    assert_eq!(read.reference as usize, place);
                    assert_eq!(read.causality, v.causality.name());
                    compared += 1;
                }
                let time = usize::from(version == FmiVersion::V3);
                assert_eq!(fmu.variables.len(), model.variables().len() + time);
            }
        }
        assert_eq!(compared, 2 * (14 + 13 + 13 + 32 + 30));
    }
}
