//! Reading model descriptions of FMUs: version, identifiers, variables and their physical units.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::units::Si;
use cordon_cosim::fmi::interface::FmiVersion;

/// A model description, as far as a co-simulation needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelDescription {
    /// Version of the standard.
    pub version: FmiVersion,
    /// Name of the model.
    pub model_name: String,
    /// Identifier required to make instances.
    pub token: String,
    /// Name of the binary, where the FMU is for co-simulation.
    pub identifier: Option<String>,
    /// Variables, in the description's order.
    pub variables: Vec<FmuVariable>,
}

impl ModelDescription {
    /// Reads the text of a `modelDescription.xml`.
    ///
    /// # Errors
    /// It is not a model description, or of another version of the standard; the error is the reason.
    pub fn read(text: &str) -> Result<Self, String> {
        // The version comes first: other versions have other elements.
        let version = fmi_version(text)?;
        let description: Description = quick_xml::de::from_str(text)
            .map_err(|e| format!("its `modelDescription.xml` cannot be read: {e}"))?;
        debug_assert!(description.version.starts_with(version.name()));
        let definitions = Definitions::new(description.units, description.types);
        let variables = description.variables.list.into_iter();
        Ok(Self {
            version,
            model_name: description.model_name,
            token: description.token,
            identifier: description.co_simulation.map(|c| c.identifier),
            variables: variables.filter_map(|entry| variable(entry, &definitions)).collect(),
        })
    }
}

/// A variable of an FMU.
#[derive(Clone, Debug, PartialEq)]
pub struct FmuVariable {
    /// Its name, unique in the FMU.
    pub name: String,
    /// Value reference, which identifies the variable in the C functions.
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

/// Types of real variables.
pub(super) const REALS: &[&str] = &["Real", "Float64", "Float32"];

impl FmuVariable {
    /// Whether its type is real.
    pub fn is_real(&self) -> bool {
        REALS.contains(&self.kind.as_str())
    }
}

/// The physical unit of a variable of an FMU.
#[derive(Clone, Debug, PartialEq)]
pub struct FmuUnit {
    /// Its name in the model description.
    pub name: String,
    /// Its definition in SI base units; `None` where neither a definition nor the name gives one.
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

/// Exponents of the SI base units, and the conversion of values.
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

/// A declared type: FMI 2.0 gives the kind in a child element, FMI 3.0 in the element's name.
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

/// An element of the list of variables: FMI 2.0 gives the type in a child element, FMI 3.0 in its name.
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

/// The version that a model description declares.
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
