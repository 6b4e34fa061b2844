//! `cordon-check FILE...`: one line a file; the exit code is the worst verdict's.

use std::fs::File;
use std::io::{self, Read, Write};
use std::process::ExitCode;

use cordon_check::{Verdict, check, format::MAX_BYTES};

/// Exit code of a file that cannot be read (`EX_IOERR`); worse than every verdict.
const IO_ERROR: u8 = 74;

fn main() -> ExitCode {
    let files: Vec<String> = std::env::args().skip(1).collect();
    if files.is_empty() || files.iter().any(|f| f.starts_with('-')) {
        let _ = writeln!(io::stderr(), "usage: cordon-check FILE...");
        return ExitCode::from(2);
    }
    let mut out = io::stdout().lock();
    let mut worst = 0;
    for path in &files {
        match read(path) {
            Ok(verdict) => {
                worst = worst.max(verdict.code());
                if writeln!(out, "{path}: {verdict}").is_err() {
                    return ExitCode::from(IO_ERROR);
                }
            }
            Err(e) => {
                let _ = writeln!(io::stderr(), "error: cannot read `{path}`: {e}");
                worst = IO_ERROR;
            }
        }
    }
    ExitCode::from(worst)
}

/// Reads no more than the largest certificate.
fn read(path: &str) -> io::Result<Verdict> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(match String::from_utf8(bytes) {
        Ok(text) => check(&text),
        Err(_) => Verdict::Unreadable { reason: "no UTF-8 text".into() },
    })
}
