//! The location of a scenario's fields in its file, for errors found after reading.

use std::collections::{BTreeMap, BTreeSet};

use cordon_core::Error;

/// The location of each field given in a file, by the field's name, and the fields overridden by flags.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Places {
    file: Option<String>,
    fields: BTreeMap<String, (usize, usize)>,
    replaced: BTreeSet<String>,
}

impl Places {
    /// The locations in a file; messages use this name for it.
    pub fn of(file: &str, fields: impl IntoIterator<Item = (String, (usize, usize))>) -> Self {
        // Of a field that occurs again, in a list of tables, the first location is kept.
        let mut found = BTreeMap::new();
        for (name, place) in fields {
            let own = name.rsplit('.').next().unwrap_or_default().to_owned();
            found.entry(own).or_insert(place);
            found.entry(name).or_insert(place);
        }
        Self { file: Some(file.to_owned()), fields: found, replaced: BTreeSet::new() }
    }

    /// Forgets the location of a field: a flag has overridden it.
    pub fn replaced(&mut self, field: &str) {
        self.fields.remove(field);
        self.replaced.insert(field.to_owned());
    }

    /// Adds the location to an error. A message about bad input begins with the name of the field, then
    /// a colon.
    #[must_use]
    pub fn point(&self, error: Error) -> Error {
        let (Some(file), Error::Input(message)) = (&self.file, &error) else { return error };
        if message.starts_with(file.as_str()) {
            return error;
        }
        let field = message.split([':', ' ']).next().unwrap_or_default();
        // One of several tables is named with its number: `fault 2`.
        let numbered = message.split(':').next().unwrap_or_default();
        let place = self.fields.get(numbered).or_else(|| self.fields.get(field));
        match place.or_else(|| self.fields.get(&format!("flight.{field}"))) {
            Some((line, column)) => Error::input(format!("{file}:{line}:{column}: {message}")),
            None if self.replaced.contains(field) => error,
            None => Error::input(format!("{file}: {message}")),
        }
    }
}
