//! The program `cordon`.

mod cli;

use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use clap::Parser;
use cli::Cli;
use cordon_core::{Error, Outcome};

fn main() -> ExitCode {
    let cli = Cli::parse();
    let mut out = BufWriter::new(io::stdout().lock());
    let ended = cli.run(&mut out).and_then(|outcome| {
        out.flush()?;
        Ok(outcome)
    });
    match ended {
        Ok(outcome) => outcome.into(),
        // The reader has seen what it wanted (`cordon trace ... | head`).
        Err(e) if e.is_broken_pipe() => Outcome::Holds.into(),
        Err(e) => {
            report(&e);
            e.code().into()
        }
    }
}

fn report(error: &Error) {
    // Nothing is left to be done where stderr is closed too.
    let _ = writeln!(io::stderr(), "error: {error}");
}
