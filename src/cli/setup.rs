//! `cordon completions` and `cordon man`.

use std::io::Write;

use clap_complete::Shell;

use super::help;
use cordon_core::{Outcome, Result};

/// Arguments of `cordon completions`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The shell whose language the script is in
    #[arg(value_enum)]
    shell: Shell,
}

/// Prints a completion script.
pub(super) fn completions(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    // Into a buffer first: the generator panics if a write fails.
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut help::command(), "cordon", &mut script);
    out.write_all(&script)?;
    Ok(Outcome::Holds)
}

/// Prints the manual page: that of `cordon`, then those of its commands.
pub(super) fn man(out: &mut dyn Write) -> Result<Outcome> {
    let mut command = help::command();
    command.build();
    clap_mangen::Man::new(command.clone()).render(out)?;
    for sub in command.get_subcommands().filter(|s| s.get_name() != "help") {
        clap_mangen::Man::new(sub.clone()).render(out)?;
    }
    Ok(Outcome::Holds)
}
