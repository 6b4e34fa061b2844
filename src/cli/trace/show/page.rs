//! A JSON object written field by field, so that a long list need not fit in memory and its first
//! entries appear immediately. The text is that of `serde_json`'s pretty form.

use std::io::Write;

use cordon_core::Result;
use serde_json::Value;

/// A JSON object being written.
pub struct Page<'o> {
    out: &'o mut dyn Write,
    fields: usize,
}

impl<'o> Page<'o> {
    /// Opens the JSON object.
    pub fn begin(out: &'o mut dyn Write) -> Result<Self> {
        write!(out, "{{")?;
        Ok(Self { out, fields: 0 })
    }

    fn name(&mut self, name: &str) -> Result<()> {
        let comma = if self.fields == 0 { "" } else { "," };
        self.fields += 1;
        write!(self.out, "{comma}\n  {}: ", Value::from(name))?;
        Ok(())
    }

    /// Writes a field of the object.
    pub fn field(&mut self, name: &str, value: &Value) -> Result<()> {
        self.name(name)?;
        write!(self.out, "{}", indented(value, "  "))?;
        Ok(())
    }

    /// Writes a field with a list of at least one entry.
    pub fn list(&mut self, name: &str, entries: impl Iterator<Item = Value>) -> Result<()> {
        self.name(name)?;
        for (i, entry) in entries.enumerate() {
            let before = if i == 0 { "[" } else { "," };
            write!(self.out, "{before}\n    {}", indented(&entry, "    "))?;
        }
        write!(self.out, "\n  ]")?;
        Ok(())
    }

    /// Closes the JSON object.
    pub fn end(self) -> Result<()> {
        writeln!(self.out, "\n}}")?;
        Ok(())
    }
}

/// The pretty form, its lines after the first indented; strings have no line breaks in JSON.
fn indented(value: &Value, by: &str) -> String {
    format!("{value:#}").replace('\n', &format!("\n{by}"))
}
