//! Bounded model checking: finds Kani, runs it on the harnesses of `kani/`, and reads the results.
//!
//! The list of harnesses is that of the crate ([`cordon_kani::all`]). A harness that Kani does not
//! report, or reports unasked, is a failure just like one that it refutes; so is one with an
//! unsatisfied cover, which Kani itself accepts.

pub mod limits;
pub mod report;
pub mod results;
pub mod tool;

use std::collections::BTreeMap;
use std::io;
use std::os::fd::AsFd;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};

use cordon_kani::Harness;
use time::OffsetDateTime;

pub use self::limits::Limits;
use self::report::{Checked, Report};
use self::results::HarnessResult;
use self::tool::Kani;
use crate::verify::sources;
use cordon_core::{Error, Result, files};

/// The sources of a run: its record is stale when they change.
pub const SOURCES: [&str; 2] = ["spec/src", "kani/src"];

/// Kani's build folder, below the root.
const TARGET: &str = "target/cordon-kani";

/// The folder in it where Kani writes one file per harness (a name chosen by Kani).
const RESULTS: &str = "result_output_dir";

/// Why nothing was run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotRun(pub String);

/// The harnesses whose names contain one of the filters; all if there are no filters.
pub fn selected(filters: &[String]) -> Vec<&'static Harness> {
    let wanted = |h: &&Harness| filters.is_empty() || filters.iter().any(|f| h.name.contains(f));
    cordon_kani::all().filter(wanted).collect()
}

/// Runs Kani on the harnesses that the filters select.
///
/// # Errors
/// No harness is selected, or a file or process of the run cannot be read or started.
pub fn run(
    root: &Path,
    kani: &Kani,
    filters: &[String],
    limits: Limits,
) -> Result<std::result::Result<Report, NotRun>> {
    let expected = selected(filters);
    if expected.is_empty() {
        let filters = filters.join("`, `");
        return Err(Error::input(format!(
            "`{filters}`: expected parts of the names of harnesses, as `cargo xtask kani --list` shows them"
        )));
    }
    // Hashed before the run: a change in the meantime makes the record stale.
    let sources = sources::hash(root, &SOURCES).ok();
    let folder = root.join(TARGET);
    let results = folder.join(RESULTS);
    // Results of an earlier run must not be taken for results of this one.
    if results.exists() {
        std::fs::remove_dir_all(&results).map_err(|e| Error::file("remove", &results, e))?;
    }
    let status = start(root, &folder, filters, limits)?;
    let reported = read(&results)?;
    if reported.is_empty() && !status.success() {
        return Ok(Err(NotRun(format!("`cargo kani` ended with {status} before any harness"))));
    }
    let (harnesses, unexpected) = compare(&expected, reported);
    let date = OffsetDateTime::now_utc().date().to_string();
    Ok(Ok(Report { kani: kani.clone(), date, sources, limits, harnesses, unexpected }))
}

/// Runs `cargo kani` with a memory limit; its output goes to stderr.
fn start(root: &Path, folder: &Path, filters: &[String], limits: Limits) -> Result<ExitStatus> {
    let progress = io::stderr().as_fd().try_clone_to_owned()?;
    let mut command = Command::new("sh");
    // Child processes, the solvers among them, inherit the limit that a process sets for itself.
    command.args(["-c", "ulimit -v \"$1\" && shift && exec \"$@\"", "cordon"]);
    command.arg((limits.mebibytes * 1024).to_string());
    command.args(["cargo", "kani", "--output-into-files", "--output-format", "terse"]);
    command.args(["-Z", "unstable-options", "--harness-timeout"]).arg(limits.seconds.to_string());
    command.arg("--jobs").arg(limits.jobs.to_string());
    command.arg("--target-dir").arg(folder);
    for filter in filters {
        command.arg("--harness").arg(filter);
    }
    command.current_dir(root).stdin(Stdio::null()).stdout(progress);
    command.status().map_err(|e| Error::file("start", Path::new("sh"), e))
}

/// The text of each harness's result file.
fn read(folder: &Path) -> Result<BTreeMap<String, String>> {
    let mut found = BTreeMap::new();
    if !folder.is_dir() {
        return Ok(found);
    }
    let fail = |e| Error::file("read", folder, e);
    for entry in std::fs::read_dir(folder).map_err(fail)? {
        let path: PathBuf = entry.map_err(fail)?.path();
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned());
        found.insert(name.unwrap_or_default(), files::read_text(&path, files::Limit::RECORD)?);
    }
    Ok(found)
}

/// Compares the reported harnesses with the selected ones; also returns those reported unasked.
fn compare(
    expected: &[&'static Harness],
    mut reported: BTreeMap<String, String>,
) -> (Vec<Checked>, Vec<String>) {
    let harnesses = expected.iter().map(|&harness| {
        let finding = match reported.remove(harness.name) {
            Some(text) => results::read(&text, harness.expected),
            None => HarnessResult::missing(),
        };
        Checked { harness, finding }
    });
    let harnesses = harnesses.collect();
    (harnesses, reported.into_keys().collect())
}
