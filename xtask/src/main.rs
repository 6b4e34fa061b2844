//! `cargo xtask`: tasks that work only inside the repository.

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
            // If stderr is closed too there is nothing left to do.
            let _ = writeln!(io::stderr(), "error: {e}");
            e.code().into()
        }
    }
}
