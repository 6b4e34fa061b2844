//! Engine settings as values of flags, so that engines need not know about flags.

use std::fmt;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// A setting with a few values, each with the name and the help shown to the user.
pub trait Choice: Copy + Send + Sync + 'static {
    /// Every choice: its name, value and help.
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

/// The error for a name that clap accepted and that is not a choice: it cannot happen.
#[derive(Debug)]
struct NoChoice;

impl fmt::Display for NoChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("expected one of the possible values")
    }
}

impl std::error::Error for NoChoice {}
