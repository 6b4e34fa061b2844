//! The program `cordon`.

mod cli;

use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use clap::FromArgMatches;
use cli::Cli;
use cli::edge::Call;
use cli::help;
use cli::progress::{Beside, Heartbeat};
use cordon_core::text::{Printable, printable, short_numbers};
use cordon_core::{Error, Outcome, Result};

fn main() -> ExitCode {
    let mut command = help::command();
    let matches = match command.try_get_matches_from_mut(std::env::args_os()) {
        Ok(matches) => matches,
        Err(e) => return usage(&e),
    };
    let cli = match Cli::from_arg_matches(&matches) {
        Ok(cli) => cli,
        Err(e) => return usage(&e.format(&mut command)),
    };
    let call = Call::of(&command, &matches);
    match run(cli, &call) {
        Ok(outcome) => outcome.into(),
        // The reader of the pipe has seen enough (`cordon trace ... | head`).
        Err(e) if e.is_broken_pipe() => Outcome::Holds.into(),
        Err(e) => {
            let e = call.blame(e);
            report(&e);
            e.code().into()
        }
    }
}

/// Prints help, or the error in the command line.
fn usage(error: &clap::Error) -> ExitCode {
    let text = error.render().to_string();
    let plain = text
        .replace("invalid digit found in string", "expected a whole number")
        .replace("cannot parse integer from empty string", "expected a whole number")
        .replace("number too large to fit in target type", "expected a smaller number")
        .replace("invalid float literal", "expected a number");
    // What clap prints itself has colours, and what was typed as it is.
    let printed = match plain == text && printable(&text) == text {
        true => error.print(),
        false => Printable(io::stderr()).write_all(plain.as_bytes()),
    };
    let numbers: Vec<String> = std::env::args().filter(|a| a.starts_with("7.")).collect();
    if error.use_stderr() && numbers.len() > 1 {
        let _ = writeln!(
            io::stderr(),
            "\ntip: numbers of theorems are separated by commas: {}",
            numbers.join(",")
        );
    }
    match printed {
        _ if error.use_stderr() => ExitCode::from(2),
        Err(e) if e.kind() != io::ErrorKind::BrokenPipe => Error::Output(e).code().into(),
        _ => ExitCode::SUCCESS,
    }
}

/// Runs the command. Its output goes to stdout, or to stderr where a file goes to stdout.
fn run(cli: Cli, call: &Call<'_>) -> Result<Outcome> {
    call.complete()?;
    let to_stderr = call.output()?;
    let beat = Heartbeat::start();
    let heartbeat = beat.as_ref();
    let edge: Box<dyn Write> = if to_stderr {
        Box::new(Beside { stream: io::stderr(), heartbeat })
    } else {
        Box::new(BufWriter::new(Beside { stream: io::stdout().lock(), heartbeat }))
    };
    let mut out = Printable(edge);
    let outcome = if call.writes_files() && !to_stderr {
        // Said once all is written: where that fails, nothing is. A run that broke off is written, too.
        let mut held = Printable(Vec::new());
        let ended = cli.run(&mut held);
        if !ended.as_ref().is_err_and(is_about_files) {
            out.write_all(&held.0)?;
            out.flush()?;
        }
        ended?
    } else {
        cli.run(&mut out)?
    };
    out.flush()?;
    Ok(outcome)
}

/// Whether a file could not be read or written, or may not be.
fn is_about_files(error: &Error) -> bool {
    match error {
        Error::File { .. } => true,
        Error::Input(message) => message.starts_with("out: "),
        _ => false,
    }
}

fn report(error: &Error) {
    // If stderr is closed too there is nothing left to do.
    let _ = writeln!(Printable(io::stderr()), "error: {}", short_numbers(&error.to_string()));
}
