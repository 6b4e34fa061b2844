//! Reading FMUs: the archive, the model description, the binaries in it.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};

use serde::Deserialize;
use zip::ZipArchive;

use super::interface::{FmiVersion, Model};
use super::package::platform;
use super::units::Si;
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
#[derive(Clone, Debug, PartialEq)]
pub struct FmuVariable {
    /// Name.
    pub name: String,
    /// Value reference.
    pub reference: u32,
    /// The element of the model description: `Real`, `Float64`, ...
    pub kind: String,
    /// `input`, `output`, `parameter`, `local`, ...
    pub causality: String,
    /// Physical unit, of the variable or of its declared type.
    pub unit: Option<FmuUnit>,
    /// Whether it is an array.
    pub is_array: bool,
}

/// The physical unit of a variable of an FMU.
#[derive(Clone, Debug, PartialEq)]
pub struct FmuUnit {
    /// Its name.
    pub name: String,
    /// What it is in SI base units; `None` where neither a definition nor the name says so.
    pub(super) si: Option<Si>,
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
    #[serde(rename = "UnitDefinitions", default)]
    units: UnitDefinitions,
    #[serde(rename = "TypeDefinitions", default)]
    types: TypeDefinitions,
    #[serde(rename = "ModelVariables", default)]
    variables: ModelVariables,
}

#[derive(Deserialize, Default)]
struct UnitDefinitions {
    #[serde(rename = "Unit", default)]
    list: Vec<UnitDefinition>,
}

#[derive(Deserialize)]
struct UnitDefinition {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "BaseUnit")]
    base: Option<BaseUnit>,
}

/// Exponents of the SI base units, and how the unit's values become theirs.
#[derive(Deserialize)]
struct BaseUnit {
    #[serde(rename = "@kg", default)]
    kg: i32,
    #[serde(rename = "@m", default)]
    m: i32,
    #[serde(rename = "@s", default)]
    s: i32,
    #[serde(rename = "@A", default)]
    ampere: i32,
    #[serde(rename = "@K", default)]
    kelvin: i32,
    #[serde(rename = "@mol", default)]
    mol: i32,
    #[serde(rename = "@cd", default)]
    cd: i32,
    #[serde(rename = "@rad", default)]
    rad: i32,
    #[serde(rename = "@factor")]
    factor: Option<f64>,
    #[serde(rename = "@offset")]
    offset: Option<f64>,
}

impl BaseUnit {
    fn si(&self) -> Si {
        let exponents = [
            ("kg", self.kg),
            ("m", self.m),
            ("s", self.s),
            ("A", self.ampere),
            ("K", self.kelvin),
            ("mol", self.mol),
            ("cd", self.cd),
            ("rad", self.rad),
        ];
        Si::new(exponents, self.factor.unwrap_or(1.0), self.offset.unwrap_or(0.0))
    }
}

#[derive(Deserialize, Default)]
struct TypeDefinitions {
    #[serde(rename = "$value", default)]
    list: Vec<TypeEntry>,
}

/// A declared type: FMI 2.0 says which inside, FMI 3.0 by the element's name.
#[derive(Deserialize)]
enum TypeEntry {
    SimpleType(SimpleType),
    Float64Type(RealDeclaration),
    Float32Type(RealDeclaration),
    #[serde(other)]
    Other,
}

#[derive(Deserialize)]
struct SimpleType {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "Real")]
    real: Option<RealType>,
}

#[derive(Deserialize)]
struct RealDeclaration {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@unit")]
    unit: Option<String>,
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
    Int8(Typed),
    UInt8(Typed),
    Int16(Typed),
    UInt16(Typed),
    Int32(Typed),
    UInt32(Typed),
    Int64(Typed),
    UInt64(Typed),
    Enumeration(Typed),
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
    #[serde(rename = "Enumeration")]
    enumeration: Option<AnyType>,
}

#[derive(Deserialize)]
struct RealType {
    #[serde(rename = "@unit")]
    unit: Option<String>,
    #[serde(rename = "@declaredType")]
    declared: Option<String>,
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
    #[serde(rename = "@declaredType", default)]
    declared: Option<String>,
    #[serde(rename = "Dimension", default)]
    dimensions: Vec<AnyType>,
}

impl Fmu {
    /// Reads an FMU.
    ///
    /// # Errors
    /// There is no such file; it is no archive, or a truncated one, or unpacks to more than a
    /// gigabyte; it has no model description, one that is too large, or one of another version
    /// of the standard. The message names the file.
    pub fn open(path: &Path) -> Result<Self> {
        let fail = |what: String| Error::input(format!("`{}`: {what}", path.display()));
        let mut archive = opened(path)?;
        let files: Vec<String> = archive.file_names().map(str::to_owned).collect();
        let description = archive
            .by_name("modelDescription.xml")
            .map_err(|e| fail(format!("expected an FMU with a `modelDescription.xml`: {e}")))?;
        let mut text = String::new();
        description
            .take(LARGEST_DESCRIPTION + 1)
            .read_to_string(&mut text)
            .map_err(|e| fail(format!("its `modelDescription.xml` cannot be read: {e}")))?;
        if u64::try_from(text.len()).is_ok_and(|length| length > LARGEST_DESCRIPTION) {
            return Err(fail(format!(
                "its `modelDescription.xml` is too large: expected at most {LARGEST_DESCRIPTION} bytes"
            )));
        }
        Self::from_description(path, &text, files).map_err(fail)
    }

    fn from_description(path: &Path, text: &str, files: Vec<String>) -> Result<Self, String> {
        // The version comes first: other versions have other elements.
        let version = fmi_version(text)?;
        let description: Description = quick_xml::de::from_str(text)
            .map_err(|e| format!("its `modelDescription.xml` cannot be read: {e}"))?;
        debug_assert!(description.version.starts_with(version.name()));
        let definitions = Definitions::new(description.units, description.types);
        let variables = description.variables.list.into_iter();
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
            variables: variables.filter_map(|entry| variable(entry, &definitions)).collect(),
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

    /// The path, inside, of the binary with which it can be co-simulated on this platform.
    ///
    /// # Errors
    /// It is not for co-simulation, or has no binary for this platform.
    pub fn binary(&self) -> Result<String> {
        let fail = |what: String| Err(Error::input(format!("`{}`: {what}", self.path.display())));
        let Some(identifier) = &self.identifier else {
            return fail("expected an FMU for co-simulation; it is for model exchange".to_owned());
        };
        let Some((folder, ending)) = platform(self.version) else {
            return fail("FMI has no name for this platform".to_owned());
        };
        let binary = format!("binaries/{folder}/{identifier}{ending}");
        if self.files.contains(&binary) {
            return Ok(binary);
        }
        let others = match self.platforms.as_slice() {
            [] => "no binaries at all".to_owned(),
            list => format!("binaries for {}", list.join(", ")),
        };
        fail(format!("expected `{binary}`, a binary for this platform; it has {others}"))
    }
}

/// Most bytes of a model description: hundreds of thousands of variables.
const LARGEST_DESCRIPTION: u64 = 1 << 26;

/// Most bytes of all files of an archive, unpacked.
const LARGEST_CONTENT: u64 = 1 << 30;

/// Most files of an archive.
const MOST_FILES: usize = 100_000;

/// Opens an archive, which has to be within the limits.
fn opened(path: &Path) -> Result<ZipArchive<BufReader<File>>> {
    let fail = |what: String| Error::input(format!("`{}`: {what}", path.display()));
    let file = File::open(path).map_err(|e| Error::file("read", path, e))?;
    let archive = ZipArchive::new(BufReader::new(file))
        .map_err(|e| fail(format!("expected an FMU, a whole zip archive: {e}")))?;
    if archive.len() > MOST_FILES {
        let found = archive.len();
        return Err(fail(format!("it has {found} files: expected at most {MOST_FILES}")));
    }
    // Where the archive says less than it has, unpacking stops at what it says.
    match archive.decompressed_size() {
        Some(size) if size > u128::from(LARGEST_CONTENT) => {
            Err(fail(format!("it unpacks to {size} bytes: expected at most {LARGEST_CONTENT}")))
        }
        _ => Ok(archive),
    }
}

#[cfg(feature = "fmi-import")]
impl Fmu {
    /// Unpacks the archive into a temporary folder.
    ///
    /// # Errors
    /// It cannot be unpacked, a path in it leads out of it, or it is too large.
    pub(super) fn unpack(&self) -> Result<tempfile::TempDir> {
        let fail = |what: String| Error::input(format!("`{}`: {what}", self.path.display()));
        let failed = |e: &dyn std::fmt::Display| fail(format!("it cannot be unpacked: {e}"));
        let folder = tempfile::Builder::new().prefix("cordon-fmu-").tempdir();
        let folder = folder.map_err(|e| failed(&e))?;
        let mut archive = opened(&self.path)?;
        let mut left = LARGEST_CONTENT;
        for place in 0..archive.len() {
            let mut file = archive.by_index(place).map_err(|e| failed(&e))?;
            let Some(inside) = file.enclosed_name() else {
                let name = file.name();
                return Err(fail(format!("`{name}`: expected a path inside the archive")));
            };
            let path = folder.path().join(inside);
            if file.is_dir() {
                std::fs::create_dir_all(&path).map_err(|e| failed(&e))?;
                continue;
            }
            if let Some(parent) = path.parent() {
                std::fs::create_dir_all(parent).map_err(|e| failed(&e))?;
            }
            let mut to = File::create(&path).map_err(|e| failed(&e))?;
            let copied = std::io::copy(&mut file.by_ref().take(left + 1), &mut to);
            left = copied.map_err(|e| failed(&e)).and_then(|written| {
                let too_much =
                    || fail(format!("expected at most {LARGEST_CONTENT} bytes, unpacked"));
                left.checked_sub(written).ok_or_else(too_much)
            })?;
            #[cfg(unix)]
            if file.unix_mode().is_some_and(|mode| mode & 0o100 != 0) {
                let executable = std::os::unix::fs::PermissionsExt::from_mode(0o700);
                std::fs::set_permissions(&path, executable).map_err(|e| failed(&e))?;
            }
        }
        Ok(folder)
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

/// Definitions of units and declared types, by their names.
struct Definitions {
    units: BTreeMap<String, Si>,
    types: BTreeMap<String, Option<String>>,
}

impl Definitions {
    fn new(units: UnitDefinitions, types: TypeDefinitions) -> Self {
        let units = units.list.into_iter().filter_map(|u| Some((u.name, u.base?.si())));
        let types = types.list.into_iter().filter_map(|entry| match entry {
            TypeEntry::SimpleType(t) => Some((t.name, t.real?.unit)),
            TypeEntry::Float64Type(t) | TypeEntry::Float32Type(t) => Some((t.name, t.unit)),
            TypeEntry::Other => None,
        });
        Self { units: units.collect(), types: types.collect() }
    }

    /// The unit of a variable: its own, or that of its declared type.
    fn unit(&self, own: Option<String>, declared: Option<String>) -> Option<FmuUnit> {
        let of_type = || self.types.get(&declared?).cloned().flatten();
        let name = own.or_else(of_type)?;
        let si = self.units.get(&name).cloned().or_else(|| Si::named(&name));
        Some(FmuUnit { name, si })
    }
}

fn variable(entry: Entry, definitions: &Definitions) -> Option<FmuVariable> {
    let (kind, v) = match entry {
        Entry::ScalarVariable(s) => {
            let kind = match (&s.real, &s.integer, &s.boolean, &s.string, &s.enumeration) {
                (Some(_), ..) => "Real",
                (_, Some(_), ..) => "Integer",
                (_, _, Some(_), ..) => "Boolean",
                (_, _, _, Some(_), _) => "String",
                (_, _, _, _, Some(_)) => "Enumeration",
                _ => return None,
            };
            let (unit, declared) = s.real.map_or((None, None), |r| (r.unit, r.declared));
            let Scalar { name, reference, causality, .. } = s;
            let dimensions = Vec::new();
            (kind, Typed { name, reference, causality, unit, declared, dimensions })
        }
        Entry::Float64(v) => ("Float64", v),
        Entry::Float32(v) => ("Float32", v),
        Entry::Int8(v) => ("Int8", v),
        Entry::UInt8(v) => ("UInt8", v),
        Entry::Int16(v) => ("Int16", v),
        Entry::UInt16(v) => ("UInt16", v),
        Entry::Int32(v) => ("Int32", v),
        Entry::UInt32(v) => ("UInt32", v),
        Entry::Int64(v) => ("Int64", v),
        Entry::UInt64(v) => ("UInt64", v),
        Entry::Enumeration(v) => ("Enumeration", v),
        Entry::Boolean(v) => ("Boolean", v),
        Entry::String(v) => ("String", v),
        Entry::Other => return None,
    };
    Some(FmuVariable {
        name: v.name,
        reference: v.reference,
        kind: kind.to_owned(),
        causality: v.causality.unwrap_or_else(|| "local".to_owned()),
        unit: definitions.unit(v.unit, v.declared),
        is_array: !v.dimensions.is_empty(),
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
