//! Engine settings as the values of flags, without the engines knowing of flags.

use std::fmt;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// A setting with a few values, each with the name and the help that a user sees.
pub trait Choice: Copy + Send + Sync + 'static {
    /// Each choice by name, value and what the help says of it.
    const ALL: &'static [(&'static str, Self, &'static str)];
}

/// The parser of a flag with the values of `T`.
pub fn choice<T: Choice>() -> impl TypedValueParser<Value = T> {
    let names = T::ALL.iter().map(|(name, _, help)| PossibleValue::new(*name).help(*help));
    PossibleValuesParser::new(names).try_map(|given| {
        let value = T::ALL.iter().find(|(name, ..)| *name == given).map(|(_, value, _)| *value);
        value.ok_or(NoChoice)
    })
}

/// A name that clap let pass and that is none of the choices: never made.
#[derive(Debug)]
struct NoChoice;

impl fmt::Display for NoChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("expected one of the possible values")
    }
}

impl std::error::Error for NoChoice {}
