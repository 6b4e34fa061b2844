//! Files of recorded runs: written atomically, refused where damaged.

mod csv;
mod json;
#[cfg(feature = "parquet")]
mod parquet;

use std::io::Write;
use std::path::{Path, PathBuf};

use super::record::Record;
use cordon_core::files::{self, Limit};
use cordon_core::fingerprint::Fingerprint;
use cordon_core::{Error, Result};

pub use csv::csv;
pub use json::json;

/// The format of a run file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated values: time, positions, other variables
    Csv,
    /// JSON, schema cordon-cosim/1, with collisions and violations of the order
    Json,
    /// Apache Parquet, the columns of the CSV (needs the cargo feature `parquet`)
    Parquet,
}

impl Format {
    /// The format given by a file name's extension, in upper or lower case.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "csv" => Some(Self::Csv),
            "json" => Some(Self::Json),
            "parquet" => Some(Self::Parquet),
            _ => None,
        }
    }
}

/// Writes a record to a stream.
///
/// # Errors
/// The stream cannot be written, or the format needs a feature that this build lacks.
pub fn write(record: &Record, format: Format, out: &mut dyn Write) -> Result<()> {
    match format {
        Format::Csv => csv(record, out),
        Format::Json => json(record, out),
        Format::Parquet => columns(record, out),
    }
}

#[cfg(feature = "parquet")]
fn columns(record: &Record, out: &mut dyn Write) -> Result<()> {
    parquet::parquet(record, out)
}

#[cfg(not(feature = "parquet"))]
fn columns(_: &Record, _: &mut dyn Write) -> Result<()> {
    Err(Error::input(
        "format: `parquet`: expected `csv` or `json`: this build has no Parquet; \
         `cargo build --features parquet` makes one that has",
    ))
}

/// Writes a record to a file, atomically. What CSV and Parquet columns cannot hold (title, set-up,
/// events) goes into a [companion](companion_of) beside it.
///
/// # Errors
/// As for [`write()`].
pub fn save(record: &Record, format: Format, path: &Path) -> Result<()> {
    let mut fingerprint = Fingerprint::default();
    files::write_whole(path, |file| {
        write(record, format, &mut Fingerprinted { file, fingerprint: &mut fingerprint })
    })?;
    match format {
        Format::Json => Ok(()),
        // A pipe or a device has no room for a companion.
        _ if !files::is_regular(path) => Ok(()),
        Format::Csv | Format::Parquet => {
            let companion = json::companion(record, fingerprint)?;
            files::write_atomically(&companion_of(path), &companion)
        }
    }
}

/// The companion of a run file: `run.csv.json` for `run.csv`.
pub fn companion_of(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".json");
    name.into()
}

/// The files that [`save`] writes: the run and, if any, its companion.
pub fn written(path: &Path, format: Format) -> Vec<PathBuf> {
    let companion = (format != Format::Json).then(|| companion_of(path));
    std::iter::once(path.to_owned()).chain(companion).collect()
}

/// A file whose content is fingerprinted while it is written.
struct Fingerprinted<'f> {
    file: &'f mut dyn Write,
    fingerprint: &'f mut Fingerprint,
}

impl Write for Fingerprinted<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let written = self.file.write(bytes)?;
        self.fingerprint.add(bytes.get(..written).unwrap_or_default());
        Ok(written)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.flush()
    }
}

/// Reads a run file in CSV, with its companion if there is one, or in JSON.
///
/// # Errors
/// The file cannot be read or is incomplete, or its companion belongs to another run: the message names
/// it and says where.
pub fn load(path: &Path) -> Result<Record> {
    let name = path.display().to_string();
    match Format::of(path).unwrap_or(Format::Csv) {
        Format::Csv => {
            let text = files::read_text(path, Limit::RUN)?;
            let mut record = csv::parse(&name, &text)?;
            let companion = companion_of(path);
            if companion.exists() {
                let mut fingerprint = Fingerprint::default();
                fingerprint.add(text.as_bytes());
                let about = files::read_text(&companion, Limit::RUN)?;
                let name = companion.display().to_string();
                json::accompany(&mut record, fingerprint, &name, &about)?;
            }
            Ok(record)
        }
        Format::Json => json::parse(&name, &files::read_text(path, Limit::RUN)?),
        Format::Parquet => Err(Error::input(format!(
            "`{name}`: expected a run file in CSV or JSON; Parquet is written only"
        ))),
    }
}

/// The conditions that every record read must meet. `place` names where a row of the record is in the file.
fn check(name: &str, record: &Record, place: impl Fn(usize) -> String) -> Result<()> {
    let fail = |what: String| Err(Error::input(format!("`{name}`: {what}")));
    let at = |row: usize, what: &str| Err(Error::input(format!("{}: {what}", place(row))));
    if record.count < 2 || record.rows() < 2 {
        return fail(format!(
            "{} drones at {} times: expected at least 2 of each",
            record.count,
            record.rows()
        ));
    }
    let numbers = record.rows() * record.count;
    for (_, track) in record.tracks() {
        if track.desired.len() != numbers || track.actual.len() != numbers {
            return fail(format!(
                "{} desired and {} actual positions: expected {numbers} of each, {} drones at {} times",
                track.desired.len(),
                track.actual.len(),
                record.count,
                record.rows()
            ));
        }
    }
    let heights = record.height.iter().map(|h| ("heights", h.actual.len(), numbers));
    let series = record.series.iter().map(|s| (s.name.as_str(), s.values.len(), record.rows()));
    if let Some((what, found, expected)) = heights.chain(series).find(|(_, n, wanted)| n != wanted)
    {
        return fail(format!("{what}: {found} numbers: expected {expected}"));
    }
    // JSON has no other numbers, and the CSV reader accepts none.
    let not_finite = |x: &f64| !x.is_finite();
    if let Some(row) = record.times.iter().position(not_finite) {
        return at(row, "expected a finite time");
    }
    let pairs = record.times.windows(2);
    match pairs.zip(1..).find(|(pair, _)| matches!(pair, [a, b] if a >= b)) {
        Some((_, row)) => at(row, "expected a time after that before"),
        None => Ok(()),
    }
}
