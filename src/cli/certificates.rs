//! The certificates that commands find: where they are written, and what is said of them.

use std::borrow::Borrow;
use std::io::Write;
use std::path::Path;

use serde_json::Value;

use super::table::counted;
use cordon_core::Result;
use cordon_proof::certificate;

/// A certificate with the name of its file.
pub type Named = (String, Value);

/// Writes certificates into a folder, where one is wanted; the files.
///
/// # Errors
/// A file cannot be written.
pub fn written<N: AsRef<str>, C: Borrow<Value>>(
    folder: Option<&Path>,
    all: impl IntoIterator<Item = (N, C)>,
) -> Result<Vec<String>> {
    let Some(folder) = folder else { return Ok(Vec::new()) };
    let file = |(name, c): (N, C)| {
        Ok(certificate::write(folder, name.as_ref(), c.borrow())?.display().to_string())
    };
    all.into_iter().map(file).collect()
}

/// How many the independent checker accepted.
pub fn accepted(number: usize) -> String {
    format!("{} accepted by the independent checker", counted(number, "certificate"))
}

/// A line for each file, in the place that `column` sets.
///
/// # Errors
/// `out` cannot be written.
pub fn list(column: &str, files: &[String], out: &mut dyn Write) -> Result<()> {
    files.iter().try_for_each(|file| Ok(writeln!(out, "  {column}{file}")?))
}
