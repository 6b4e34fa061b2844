//! Result files: a header line with the configuration, then one JSON line for each finished
//! work item, in the order of the items.
//!
//! A file grows by whole lines only. A sweep that was killed leaves at most its last line torn;
//! opening the file again cuts that off, takes over what is finished and goes on. Two processes
//! do not write one file: it is locked while it is open.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::Duration;

use serde::{Deserialize, Serialize};

use super::config::{Config, Item};
use super::consistent::contradiction;
use super::finding::Finding;
use super::shard::Shard;
use cordon_core::files::{self, Limit};
use cordon_core::{Error, Result};

/// Name and version of the file format.
pub const SCHEMA: &str = "cordon-sweep/1";

/// The first line of a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Header {
    /// Name and version of the format, [`SCHEMA`].
    pub schema: String,
    /// The sweep: theorems, swarms, weights, steps, starts.
    pub config: Config,
    /// Which part of it.
    pub shard: Shard,
    /// Number of work items of the whole sweep.
    pub items: usize,
}

impl Header {
    /// The header of a part of a sweep of this many items.
    pub fn new(config: &Config, shard: Shard, items: usize) -> Self {
        Self { schema: SCHEMA.into(), config: config.clone(), shard, items }
    }
}

/// A result file with what it holds so far.
#[derive(Debug)]
pub struct Read {
    /// Its first line: which sweep, and which part of it.
    pub header: Header,
    /// Its findings, in the order of the file.
    pub findings: Vec<Finding>,
    /// Length of the whole lines, in bytes.
    whole: u64,
}

/// Reads a result file; a torn last line is left out.
///
/// # Errors
/// The file cannot be read, does not begin with a whole header of this format, or has a bad
/// line.
pub fn read(path: &Path) -> Result<Read> {
    parsed(path, &files::read(path, Limit::SWEEP)?)
}

fn parsed(path: &Path, bytes: &[u8]) -> Result<Read> {
    let bad = |line: usize, why: String| {
        Error::input(format!("`{}`, line {line}: {why}", path.display()))
    };
    let mut lines = bytes.split_inclusive(|b| *b == b'\n').take_while(|l| l.ends_with(b"\n"));
    let first = lines.next().unwrap_or_default();
    let schema: Schema = serde_json::from_slice(first)
        .map_err(|_| bad(1, format!("expected the header of a result file, schema `{SCHEMA}`")))?;
    if schema.schema != SCHEMA {
        return Err(bad(1, format!("schema `{}`: expected `{SCHEMA}`", schema.schema)));
    }
    let header = serde_json::from_slice(first).map_err(|e| bad(1, format!("bad header: {e}")))?;
    let mut whole = first.len() as u64;
    let mut findings = Vec::new();
    for (i, line) in lines.enumerate() {
        let finding = serde_json::from_slice(line)
            .map_err(|e| bad(i + 2, format!("expected a finding of a sweep: {e}")))?;
        findings.push(finding);
        whole += line.len() as u64;
    }
    Ok(Read { header, findings, whole })
}

/// The one field that every version of the format has.
#[derive(Deserialize)]
struct Schema {
    schema: String,
}

/// A result file open for more findings, locked: no other process writes it.
#[derive(Debug)]
pub struct Store {
    path: PathBuf,
    file: File,
}

impl Store {
    /// Opens the file of a part of a sweep, or begins it. Answers with the findings it already
    /// holds, which are those of the first of `items`.
    ///
    /// # Errors
    /// The file holds another sweep or is damaged, another process is writing it, or it cannot
    /// be read or written.
    pub fn open(path: &Path, header: &Header, items: &[Item]) -> Result<(Self, Vec<Finding>)> {
        if std::fs::metadata(path).is_ok_and(|meta| !meta.is_file()) {
            return Self::through(path, header);
        }
        let fail = |e| Error::file("write", path, e);
        let mut options = OpenOptions::new();
        let mut file = options.write(true).create(true).truncate(false).open(path).map_err(fail)?;
        lock(path, &file)?;
        let line = line_of(header)?;
        let bytes = files::read(path, Limit::SWEEP)?;
        let torn = bytes.len() < line.len() && line.as_bytes().starts_with(&bytes);
        let (findings, whole) = if torn {
            file.set_len(0).map_err(fail)?;
            file.write_all(line.as_bytes()).map_err(fail)?;
            (Vec::new(), line.len() as u64)
        } else {
            let old = parsed(path, &bytes)?;
            same(path, header, &old.header)?;
            in_order(path, &header.config, &old.findings, items)?;
            (old.findings, old.whole)
        };
        file.set_len(whole).map_err(fail)?;
        file.seek(SeekFrom::End(0)).map_err(fail)?;
        Ok((Self { path: path.to_owned(), file }, findings))
    }

    /// A pipe or a device: written through, and never read again.
    fn through(path: &Path, header: &Header) -> Result<(Self, Vec<Finding>)> {
        let fail = |e| Error::file("write", path, e);
        let mut file = OpenOptions::new().write(true).open(path).map_err(fail)?;
        file.write_all(line_of(header)?.as_bytes()).map_err(fail)?;
        Ok((Self { path: path.to_owned(), file }, Vec::new()))
    }

    /// Adds a finding, as one write.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn add(&mut self, finding: &Finding) -> Result<()> {
        let line = line_of(finding)?;
        self.file.write_all(line.as_bytes()).map_err(|e| Error::file("write", &self.path, e))
    }

    /// Waits until everything is on the disk.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn finish(self) -> Result<()> {
        match self.file.sync_all() {
            // What is no regular file may have nothing to wait for.
            Err(_) if !files::is_regular(&self.path) => Ok(()),
            ended => ended.map_err(|e| Error::file("write", &self.path, e)),
        }
    }
}

/// How often a lock is asked for, and how long is waited in between: whoever only looks
/// ([`is_being_written`]) holds it for a moment.
const TRIES: usize = 5;
const WAIT: Duration = Duration::from_millis(100);

/// Locks the file until it is closed.
fn lock(path: &Path, file: &File) -> Result<()> {
    for _ in 0..TRIES {
        match file.try_lock() {
            Ok(()) => return Ok(()),
            Err(TryLockError::WouldBlock) => sleep(WAIT),
            Err(TryLockError::Error(e)) => return Err(Error::file("lock", path, e)),
        }
    }
    Err(Error::input(format!(
        "out: `{}`: another process is writing it: expected its end, or another file",
        path.display()
    )))
}

/// Whether a process has the result file open for more findings.
///
/// # Errors
/// The file cannot be opened, or its file system has no locks.
pub fn is_being_written(path: &Path) -> Result<bool> {
    let file = File::open(path).map_err(|e| Error::file("read", path, e))?;
    match file.try_lock_shared() {
        Ok(()) => Ok(false),
        Err(TryLockError::WouldBlock) => Ok(true),
        Err(TryLockError::Error(e)) => Err(Error::file("lock", path, e)),
    }
}

/// A value as one line of JSON.
pub fn line_of(value: &impl Serialize) -> Result<String> {
    let mut line = serde_json::to_string(value).map_err(|e| Error::internal(e.to_string()))?;
    line.push('\n');
    Ok(line)
}

/// Refuses another configuration, naming the first field that differs.
fn same(path: &Path, wanted: &Header, found: &Header) -> Result<()> {
    match difference(wanted, found)? {
        None => Ok(()),
        Some((field, there, here)) => Err(Error::input(format!(
            "out: `{}` holds another sweep: {field} is {there} there and {here} here: expected the same configuration or another file",
            path.display()
        ))),
    }
}

/// The first field in which two headers differ, with both values.
///
/// # Errors
/// None in practice: headers can be written as JSON.
pub fn difference(a: &Header, b: &Header) -> Result<Option<(String, String, String)>> {
    let fields = |h: &Header| -> Result<Vec<(String, String)>> {
        let config = serde_json::to_value(&h.config).map_err(|e| Error::internal(e.to_string()))?;
        let config = config.as_object().into_iter().flatten();
        let mut fields: Vec<_> =
            config.map(|(name, value)| (name.replace('_', " "), value.to_string())).collect();
        fields.push(("shard".into(), format!("{}/{}", h.shard.index, h.shard.of)));
        fields.push(("number of work items".into(), h.items.to_string()));
        Ok(fields)
    };
    let both = fields(a)?.into_iter().zip(fields(b)?);
    let differs = both.into_iter().find(|((_, here), (_, there))| here != there);
    Ok(differs.map(|((name, here), (_, there))| (name, there, here)))
}

/// Refuses findings that are not those of the first items, in order, or cannot be so.
fn in_order(path: &Path, config: &Config, findings: &[Finding], items: &[Item]) -> Result<()> {
    for (i, finding) in findings.iter().enumerate() {
        let expected = items.get(i);
        if !expected.is_some_and(|item| belongs(finding, item)) {
            return Err(Error::input(format!(
                "`{}`, line {}: work item {} is out of place: expected {}",
                path.display(),
                i + 2,
                finding.item,
                expected.map_or("no more".to_owned(), |item| format!("item {}", item.number)),
            )));
        }
        if let Some(item) = expected {
            consistent(path, i + 2, config, item, finding)?;
        }
    }
    Ok(())
}

/// Refuses a line that contradicts its sweep or itself.
pub(super) fn consistent(
    path: &Path,
    line: usize,
    config: &Config,
    item: &Item,
    finding: &Finding,
) -> Result<()> {
    match contradiction(config, item, finding)? {
        None => Ok(()),
        Some(why) => Err(Error::input(format!("`{}`, line {line}: {why}", path.display()))),
    }
}

/// Whether a finding is about this item.
pub fn belongs(finding: &Finding, item: &Item) -> bool {
    finding.item == item.number
        && (finding.theorem, finding.form) == (item.theorem, item.form)
        && finding.drones == item.drones
        && finding.eps == item.eps
}
