//! Arguments that several commands share.

use cordon_spec::theorems::{Form, Theorem};

use crate::{Error, Result};

/// Form of a command's output.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutputFormat {
    /// For people.
    Text,
    /// For programs, with a versioned schema.
    Json,
}

/// The theorems of a list like `7.2,7.4ii`; a number without its part (`7.4`) names all parts,
/// `all` all theorems.
///
/// # Errors
/// A number that no theorem has.
pub fn theorems_named(list: &str) -> Result<Vec<Theorem>> {
    if list.trim() == "all" {
        return Ok(Theorem::ALL.to_vec());
    }
    let mut named = Vec::new();
    for number in list.split(',').map(str::trim) {
        let found = Theorem::ALL.iter().filter(|t| {
            let full = t.text().number;
            full == number || full.trim_end_matches('i') == number
        });
        let before = named.len();
        named.extend(found);
        if named.len() == before {
            let known: Vec<_> = Theorem::ALL.iter().map(|t| t.text().number).collect();
            return Err(Error::input(format!(
                "theorem: `{number}` is unknown: expected `all` or some of {}",
                known.join(", ")
            )));
        }
    }
    named.sort_unstable();
    named.dedup();
    Ok(named)
}

/// A form of a theorem, as a flag.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormArg {
    /// As printed.
    Paper,
    /// Under the weakest known hypothesis.
    Sharp,
}

impl From<FormArg> for Form {
    fn from(form: FormArg) -> Self {
        match form {
            FormArg::Paper => Self::Paper,
            FormArg::Sharp => Self::Sharp,
        }
    }
}
