//! Serialisation of exact numbers (as fractions), theorems (by number) and forms (by label).
//!
//! `#[serde(with = "cordon_core::serial")]` serialises a field in this way, and `#[serde(with =
//! "cordon_core::serial::list")]` each item of a list.

use cordon_spec::theorems::{Form, Theorem};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serializer};

use crate::exact::{self, Rational};
use crate::theorems;
use crate::{Error, Result};

/// A value that is stored as text.
pub trait Textual: Sized {
    /// The text of the value.
    fn to_text(&self) -> String;

    /// The value that a text denotes.
    ///
    /// # Errors
    /// The text denotes no value.
    fn from_text(text: &str) -> Result<Self>;
}

impl Textual for Rational {
    fn to_text(&self) -> String {
        exact::fraction(self)
    }

    fn from_text(text: &str) -> Result<Self> {
        exact::parse("number", text)
    }
}

impl Textual for Theorem {
    fn to_text(&self) -> String {
        self.number().to_owned()
    }

    fn from_text(text: &str) -> Result<Self> {
        match theorems::named(text)?.as_slice() {
            [one] if one.number() == text => Ok(*one),
            _ => Err(Error::input(format!("theorem: `{text}`: expected one number, like 7.4ii"))),
        }
    }
}

impl Textual for Form {
    fn to_text(&self) -> String {
        self.label().to_owned()
    }

    fn from_text(text: &str) -> Result<Self> {
        let form = Self::ALL.into_iter().find(|form| form.label() == text);
        form.ok_or_else(|| Error::input(format!("form: `{text}`: expected `paper` or `sharp`")))
    }
}

/// Writes the value as its text.
///
/// # Errors
/// Those of the serializer.
pub fn serialize<T: Textual, S: Serializer>(value: &T, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&value.to_text())
}

/// Reads the value from its text.
///
/// # Errors
/// Those of the deserializer, and a text that denotes no value.
pub fn deserialize<'de, T: Textual, D: Deserializer<'de>>(from: D) -> Result<T, D::Error> {
    T::from_text(&String::deserialize(from)?).map_err(D::Error::custom)
}

/// Lists of such values.
pub mod list {
    use super::{Deserialize, Deserializer, Result, Serializer, Textual};
    use serde::de::Error as _;

    /// Writes each item as its text.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<T: Textual, S: Serializer>(list: &[T], to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(list.iter().map(Textual::to_text))
    }

    /// Reads each item from its text.
    ///
    /// # Errors
    /// Those of the deserializer, and a text that denotes no value.
    pub fn deserialize<'de, T: Textual, D: Deserializer<'de>>(from: D) -> Result<Vec<T>, D::Error> {
        let texts = Vec::<String>::deserialize(from)?;
        texts.iter().map(|t| T::from_text(t)).collect::<Result<_>>().map_err(D::Error::custom)
    }
}
