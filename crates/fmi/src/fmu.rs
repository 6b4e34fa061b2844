//! The data needed to instantiate an FMU.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

/// A version of the standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Version {
    /// FMI 2.0.
    V2,
    /// FMI 3.0.
    V3,
}

/// An unpacked FMU, and the instance to be made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fmu {
    /// Folder of the unpacked archive, absolute.
    pub folder: PathBuf,
    /// The shared library in it.
    pub binary: PathBuf,
    /// Version of the standard.
    pub version: Version,
    /// Identifier required to make instances: `guid` or `instantiationToken`.
    pub token: String,
    /// Name of the instance.
    pub name: String,
}

/// The type of a variable, by its name in FMI 3.0. In FMI 2.0, `Real` is [`Type::Float64`], `Integer`
/// and `Enumeration` are [`Type::Int32`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum Type {
    Float64,
    Float32,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Boolean,
    String,
}

/// A variable of an FMU.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Variable {
    /// Name of the variable, for messages.
    pub name: String,
    /// Value reference, which identifies the variable in the C functions.
    pub reference: u32,
    /// The type used to read and write its value.
    pub kind: Type,
}

/// The value of a variable.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Datum {
    /// For both floating-point types.
    Real(f64),
    /// For all integer types.
    Integer(i64),
    /// True or false.
    Boolean(bool),
    /// Text.
    Text(String),
}
