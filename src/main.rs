//! The program `cordon`.

mod cli;

use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches};
use cli::Cli;
use cli::edge::Call;
use cordon_core::text::Printable;
use cordon_core::{Error, Outcome, Result};

fn main() -> ExitCode {
    let mut command = Cli::command();
    let matches = command.get_matches_mut();
    let cli = match Cli::from_arg_matches(&matches) {
        Ok(cli) => cli,
        Err(e) => e.format(&mut command).exit(),
    };
    let call = Call::of(&command, &matches);
    match run(cli, &call) {
        Ok(outcome) => outcome.into(),
        // The reader has seen what it wanted (`cordon trace ... | head`).
        Err(e) if e.is_broken_pipe() => Outcome::Holds.into(),
        Err(e) => {
            let e = call.blame(e);
            report(&e);
            e.code().into()
        }
    }
}

/// Runs the command. What it says goes to stdout, or to stderr where a file goes to stdout.
fn run(cli: Cli, call: &Call<'_>) -> Result<Outcome> {
    let edge: Box<dyn Write> = if call.output()? {
        Box::new(io::stderr())
    } else {
        Box::new(BufWriter::new(io::stdout().lock()))
    };
    let mut out = Printable(edge);
    let outcome = cli.run(&mut out)?;
    out.flush()?;
    Ok(outcome)
}

fn report(error: &Error) {
    // Nothing is left to be done where stderr is closed too.
    let _ = writeln!(Printable(io::stderr()), "error: {error}");
}
