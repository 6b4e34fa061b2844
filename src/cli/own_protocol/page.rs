//! What a command says of a system, and the certificates that it writes.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::ProtocolArgs;
use super::show::headline;
use crate::cli::certificates;
use crate::cli::select::OutputFormat;
use cordon_core::Result;
use cordon_core::exact::fraction;
use cordon_core::system::{Parameter, System};

/// The schema of these commands' JSON.
const SCHEMA: &str = "cordon-own-protocol/2";

/// Lines of text as they come, or a page of JSON at the end.
pub struct Page<'o> {
    /// None where text is wanted.
    fields: Option<BTreeMap<&'static str, Value>>,
    out: &'o mut dyn Write,
    folder: Option<&'o Path>,
    /// What certificates are named after.
    stem: String,
}

impl<'o> Page<'o> {
    /// A page about a system; certificates go to `folder`, if there is one.
    pub fn new(
        args: &ProtocolArgs,
        system: &System,
        folder: Option<&'o Path>,
        format: OutputFormat,
        out: &'o mut dyn Write,
    ) -> Self {
        let range = |p: &Parameter| (p.name.clone(), json!([fraction(&p.low), fraction(&p.high)]));
        let parameters: serde_json::Map<_, _> = system.parameters.iter().map(range).collect();
        let head = || {
            BTreeMap::from([
                ("schema", json!(SCHEMA)),
                ("title", json!(system.title)),
                ("agents", json!(system.agents)),
                ("parameters", parameters.into()),
            ])
        };
        let fields = (format == OutputFormat::Json).then(head);
        let stem = args.path().file_stem().map(|s| s.to_string_lossy().into_owned());
        Self { fields, out, folder, stem: stem.unwrap_or_else(|| "own".into()) }
    }

    /// The writer, where text is wanted.
    pub fn text(&mut self) -> Option<&mut dyn Write> {
        if self.fields.is_none() { Some(&mut *self.out) } else { None }
    }

    /// A line of text.
    pub fn line(&mut self, line: impl Display) -> Result<()> {
        if let Some(out) = self.text() {
            writeln!(out, "{line}")?;
        }
        Ok(())
    }

    /// The system in a line, before a search that takes a while.
    pub fn headline(&mut self, system: &System) -> Result<()> {
        self.line(headline(system))?;
        self.flush()
    }

    /// What was said so far is seen.
    pub fn flush(&mut self) -> Result<()> {
        Ok(self.out.flush()?)
    }

    /// A field of the JSON.
    pub fn field(&mut self, name: &'static str, value: Value) {
        if let Some(fields) = &mut self.fields {
            fields.insert(name, value);
        }
    }

    /// Where a certificate about something goes.
    pub fn file(&self, what: &str) -> Option<PathBuf> {
        self.folder.map(|folder| folder.join(format!("{}{what}.json", self.stem)))
    }

    /// Writes a certificate, if certificates are wanted, and says so; its file.
    pub fn certificate(&mut self, what: &str, certificate: &Value) -> Result<Option<String>> {
        let named = (format!("{}{what}", self.stem), certificate);
        let files = certificates::written(self.folder, [named])?;
        if let Some(out) = self.text() {
            certificates::list("wrote ", &files, out)?;
        }
        Ok(files.into_iter().next())
    }

    /// Ends the page.
    pub fn end(self) -> Result<()> {
        if let Some(fields) = self.fields {
            writeln!(self.out, "{:#}", json!(fields))?;
        }
        Ok(())
    }
}
