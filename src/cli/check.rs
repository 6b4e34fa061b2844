//! `cordon check`.

use std::fs::File;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use cordon_check::Verdict;
use cordon_check::format::MAX_BYTES;
use serde_json::json;

use super::select::OutputFormat;
use cordon_core::files::kind;
use cordon_core::{Error, Outcome, Result, progress};

/// Arguments of `cordon check`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Certificates to check (proofs/checker/FORMAT.md describes them)
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub format: OutputFormat,
}

/// Runs the independent checker on certificates; the worst verdict decides the outcome.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let mut outcome = Outcome::Holds;
    let (mut verdicts, mut unreadable, mut unread) = (Vec::new(), Vec::new(), None);
    progress::expect(args.files.len() as u64);
    for path in &args.files {
        let judged = judge(path);
        progress::advance(1);
        let verdict = match judged {
            Ok(verdict) => verdict,
            // The remaining files are judged all the same.
            Err(e) => {
                match args.format {
                    OutputFormat::Text => writeln!(out, "{}: not read", path.display())?,
                    OutputFormat::Json => verdicts.push(json!({
                        "file": path.display().to_string(),
                        "verdict": "not read",
                        "message": e.to_string(),
                    })),
                }
                unread.get_or_insert(e);
                continue;
            }
        };
        outcome = outcome.worst(match verdict {
            Verdict::Valid { .. } | Verdict::Unreadable { .. } => Outcome::Holds,
            Verdict::Invalid { .. } => Outcome::Rejected,
        });
        if matches!(verdict, Verdict::Unreadable { .. }) {
            unreadable.push(path.display().to_string());
        }
        match args.format {
            OutputFormat::Text => writeln!(out, "{}: {verdict}", path.display())?,
            OutputFormat::Json => verdicts.push(json!({
                "file": path.display().to_string(),
                "verdict": verdict.label(),
                "message": verdict.to_string(),
            })),
        }
    }
    if args.format == OutputFormat::Json {
        let page = json!({ "schema": "cordon-verdicts/1", "verdicts": verdicts });
        writeln!(out, "{page:#}")?;
    }
    out.flush()?;
    if let Some(e) = unread.filter(|_| outcome == Outcome::Holds) {
        return Err(e);
    }
    if outcome == Outcome::Holds && !unreadable.is_empty() {
        let files = unreadable.join("`, `");
        return Err(Error::input(format!("`{files}`: expected a certificate, which is JSON")));
    }
    Ok(outcome)
}

/// Judges a file, reading no more than the largest certificate.
fn judge(path: &Path) -> Result<Verdict> {
    let fail = |e| Error::file("read", path, e);
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(fail)?;
    if file.metadata().map_err(fail)?.is_dir() {
        let message = "a folder: expected a certificate";
        return Err(fail(io::Error::new(io::ErrorKind::IsADirectory, message)));
    }
    file.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes).map_err(fail)?;
    if let Some(kind) = kind::binary(&bytes) {
        return Ok(Verdict::Unreadable { reason: kind.into() });
    }
    let text = String::from_utf8_lossy(&bytes);
    Ok(match kind::foreign(&text) {
        Some(kind) if kind != kind::JSON => Verdict::Unreadable { reason: kind.into() },
        _ => cordon_check::check(&text),
    })
}
