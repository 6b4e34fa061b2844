//! `cargo xtask`: what works inside the repository only.

use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use clap::Parser;
use cordon_core::Outcome;
use xtask::cli::Cli;

fn main() -> ExitCode {
    let cli = Cli::parse();
    let mut out = BufWriter::new(io::stdout().lock());
    let ended = cli.run(&mut out).and_then(|outcome| {
        out.flush()?;
        Ok(outcome)
    });
    match ended {
        Ok(outcome) => outcome.into(),
        Err(e) if e.is_broken_pipe() => Outcome::Holds.into(),
        Err(e) => {
            // Nothing is left to be done where stderr is closed too.
            let _ = writeln!(io::stderr(), "error: {e}");
            e.code().into()
        }
    }
}
