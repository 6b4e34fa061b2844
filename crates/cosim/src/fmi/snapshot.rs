//! The saved state of an instance, which can be restored or serialised.

use serde::{Deserialize, Serialize};

use crate::quotient::Quotient;
use crate::unit::Value;
use cordon_core::exact;

/// Version of the serialised form.
const SCHEMA: &str = "cordon-fmu-state/1";

/// The state of an instance at a communication point.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The identifier of the FMU that it belongs to.
    pub(super) token: String,
    /// The mode of the instance.
    pub(super) mode: Mode,
    /// Start time in seconds.
    pub(super) start_time: f64,
    /// End of the run in seconds, where the importer gave it.
    pub(super) stop_time: Option<f64>,
    /// Number of steps of tau so far.
    pub(super) step: u64,
    /// Values of parameters and inputs, by value reference; `None` for outputs.
    pub(super) settable: Vec<Option<Value>>,
    /// The rest of the unit's memory.
    pub(super) memory: Vec<Value>,
}

/// The modes of the standards' state machine for co-simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Mode {
    /// Created; parameters can be set.
    Instantiated,
    /// Between entering and leaving the initialisation.
    Initialisation,
    /// Initialised, between two steps.
    Step,
    /// The run is over.
    Terminated,
    /// No longer usable.
    Fatal,
}

impl Mode {
    /// The mode in words, for messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Instantiated => "not initialised",
            Self::Initialisation => "being initialised",
            Self::Step => "running",
            Self::Terminated => "terminated",
            Self::Fatal => "no longer usable",
        }
    }
}

/// A serialised value: doubles by their bits, exact numbers as `p/q`.
#[derive(Serialize, Deserialize)]
enum Stored {
    Real(u64),
    Integer(i64),
    Boolean(bool),
    Text(String),
    Exact(String),
}

#[derive(Serialize, Deserialize)]
struct Document {
    schema: String,
    token: String,
    mode: Mode,
    start_time: u64,
    stop_time: Option<u64>,
    step: u64,
    settable: Vec<Option<Stored>>,
    memory: Vec<Stored>,
}

impl From<&Value> for Stored {
    fn from(value: &Value) -> Self {
        match value {
            Value::Real(x) => Self::Real(x.to_bits()),
            Value::Integer(n) => Self::Integer(*n),
            Value::Boolean(b) => Self::Boolean(*b),
            Value::Text(t) => Self::Text(t.to_string()),
            Value::Exact(x) => Self::Exact(x.to_string()),
        }
    }
}

impl Stored {
    fn value(self) -> Option<Value> {
        Some(match self {
            Self::Real(bits) => Value::Real(f64::from_bits(bits)),
            Self::Integer(n) => Value::Integer(n),
            Self::Boolean(b) => Value::Boolean(b),
            Self::Text(t) => Value::Text(t.into()),
            Self::Exact(text) => {
                let number = exact::parse("state", &text).ok()?;
                Value::Exact(Quotient::from(&number))
            }
        })
    }
}

impl Snapshot {
    /// The bytes that [`Snapshot::from_bytes`] reads back: JSON.
    pub fn to_bytes(&self) -> Vec<u8> {
        let document = Document {
            schema: SCHEMA.to_owned(),
            token: self.token.clone(),
            mode: self.mode,
            start_time: self.start_time.to_bits(),
            stop_time: self.stop_time.map(f64::to_bits),
            step: self.step,
            settable: self.settable.iter().map(|v| v.as_ref().map(Stored::from)).collect(),
            memory: self.memory.iter().map(Stored::from).collect(),
        };
        // Strings, numbers and lists always serialise.
        serde_json::to_vec(&document).unwrap_or_default()
    }

    /// Reads the state of an instance whose FMU has this identifier.
    ///
    /// # Errors
    /// Not a serialised state, or the state of another FMU.
    pub fn from_bytes(token: &str, bytes: &[u8]) -> Result<Self, String> {
        let document: Document = serde_json::from_slice(bytes)
            .map_err(|e| format!("the serialised state cannot be read: {e}"))?;
        if document.schema != SCHEMA {
            let found = document.schema;
            return Err(format!("serialised state of schema `{found}`: expected `{SCHEMA}`"));
        }
        if document.token != token {
            let found = document.token;
            return Err(format!("serialised state of the FMU `{found}`: expected `{token}`"));
        }
        let value = |v: Stored| v.value().ok_or("the serialised state has a broken number");
        let settable = document.settable.into_iter().map(|v| v.map(value).transpose());
        Ok(Self {
            token: document.token,
            mode: document.mode,
            start_time: f64::from_bits(document.start_time),
            stop_time: document.stop_time.map(f64::from_bits),
            step: document.step,
            settable: settable.collect::<Result<_, _>>()?,
            memory: document.memory.into_iter().map(value).collect::<Result<_, _>>()?,
        })
    }
}
