//! Files: read up to a limit, written so that they appear whole or not at all.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::{Error, Result};

pub mod kind;
#[cfg(feature = "output")]
mod output;
#[cfg(feature = "output")]
pub use output::{
    expect_folder, expect_writable, is_regular, is_stdout, same, write_atomically,
    write_regardless, write_whole,
};

/// The name that stands for stdin where a file is read, and for stdout where one is written.
pub const STREAM: &str = "-";

/// The size limit for a kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limit {
    /// The kind of file, for messages.
    pub what: &'static str,
    /// Largest size accepted, in bytes.
    pub bytes: u64,
}

const MIB: u64 = 1 << 20;

impl Limit {
    /// Scenarios: room for a million drones.
    pub const SCENARIO: Self = Self { what: "a scenario", bytes: 64 * MIB };
    /// User-defined protocols.
    pub const PROTOCOL: Self = Self { what: "a protocol", bytes: 4 * MIB };
    /// Multi-models of INTO-CPS, which may carry a setting for every variable.
    pub const MULTI_MODEL: Self = Self { what: "a multi-model", bytes: 64 * MIB };
    /// Recorded runs of co-simulations.
    pub const RUN: Self = Self { what: "a run", bytes: 1024 * MIB };
    /// Result files of sweeps.
    pub const SWEEP: Self = Self { what: "a sweep's result file", bytes: 1024 * MIB };
    /// Output of a solver, including a model of all variables.
    pub const ANSWER: Self = Self { what: "a solver's answer", bytes: 64 * MIB };
    /// FMUs, and the binaries inside.
    pub const FMU: Self = Self { what: "an FMU", bytes: 512 * MIB };
    /// Records and reports that belong to the repository.
    pub const RECORD: Self = Self { what: "a record", bytes: 64 * MIB };
}

/// The files that this process has read: no output may replace them.
static INPUTS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Marks a file as an input of this process, which [`write_whole`] will then refuse to replace.
/// [`read`] does this itself.
pub fn is_input(path: &Path) {
    if let Ok(whole) = fs::canonicalize(path) {
        let mut inputs = INPUTS.lock().unwrap_or_else(PoisonError::into_inner);
        if !inputs.contains(&whole) {
            inputs.push(whole);
        }
    }
}

/// Reads a file (`-`: stdin) of at most `limit` bytes. The size is checked before memory is allocated;
/// from a source without a size, such as a pipe, no more than the limit is read.
///
/// # Errors
/// The file cannot be read, or is larger.
pub fn read(path: &Path, limit: Limit) -> Result<Vec<u8>> {
    let fail = |e| Error::file("read", path, e);
    let too_large = |kind: Option<&str>| {
        let found = kind.map(|kind| format!("{kind}: ")).unwrap_or_default();
        let (name, what, most) = (path.display(), limit.what, limit.bytes / MIB);
        Error::input(format!("`{name}`: {found}expected {what} of at most {most} MiB"))
    };
    let mut bytes = Vec::new();
    if path == Path::new(STREAM) {
        io::stdin().lock().take(limit.bytes + 1).read_to_end(&mut bytes).map_err(fail)?;
    } else {
        let mut file = File::open(path).map_err(fail)?;
        let found = file.metadata().map_err(fail)?;
        if found.is_dir() {
            let message = format!("a folder: expected {}", limit.what);
            return Err(fail(io::Error::new(io::ErrorKind::IsADirectory, message)));
        }
        if found.len() > limit.bytes {
            let mut first = [0; 16];
            let known =
                file.read_exact(&mut first).ok().and_then(|()| kind::by_first_bytes(&first));
            return Err(too_large(known));
        }
        is_input(path);
        file.take(limit.bytes + 1).read_to_end(&mut bytes).map_err(fail)?;
    }
    if bytes.len() as u64 > limit.bytes { Err(too_large(None)) } else { Ok(bytes) }
}

/// Reads a UTF-8 text file, without its byte order mark.
///
/// # Errors
/// As [`read`], or the file is no UTF-8 text.
pub fn read_text(path: &Path, limit: Limit) -> Result<String> {
    let bytes = read(path, limit)?;
    let (name, what) = (path.display(), limit.what);
    if let Some(kind) = kind::binary(&bytes) {
        return Err(Error::input(format!(
            "`{name}`: {kind}: expected {what}, which is UTF-8 text"
        )));
    }
    let mut text = String::from_utf8(bytes)
        .map_err(|_| Error::input(format!("`{name}`: expected {what}, which is UTF-8 text")))?;
    if text.starts_with('\u{feff}') {
        text.drain(..'\u{feff}'.len_utf8());
    }
    Ok(text)
}

/// Reads a file that a program has written as an object in JSON; whether it is whole is not looked at.
///
/// # Errors
/// As [`read_text`], or the file is of another kind.
pub fn read_json(path: &Path, limit: Limit) -> Result<String> {
    let text = read_text(path, limit)?;
    match kind::no_json(&text) {
        Some(kind) => {
            let (name, what) = (path.display(), limit.what);
            Err(Error::input(format!("`{name}`: {kind}: expected {what}, which is JSON")))
        }
        None => Ok(text),
    }
}
