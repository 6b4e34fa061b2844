//! Rules for files and messages that apply to every command.

use std::path::{Path, PathBuf};

use clap::ArgMatches;
use clap::parser::ValueSource;

use cordon_core::{Error, Result, files};

/// Flags that need another flag: the command, the flag's id, the other flag.
const NEEDS: [(&str, &str, &str); 28] = [
    ("trace", "form", "check"),
    ("trace", "engine", "at"),
    ("trace", "verify", "at"),
    ("sweep", "seed", "sample"),
    ("sweep", "submit", "shards"),
    ("sweep", "shards", "submit"),
    ("sweep", "partition", "submit"),
    ("sweep", "time", "submit"),
    ("sweep", "dry_run", "submit"),
    ("theorems", "known", "protocol"),
    ("sweep", "agents", "protocol"),
    ("sweep", "set", "protocol"),
    ("theorems", "agents", "protocol"),
    ("theorems", "set", "protocol"),
    ("smt2", "agents", "protocol"),
    ("smt2", "set", "protocol"),
    ("smt2", "steps", "negate"),
    ("smt2", "answer", "negate"),
    ("prove", "agents", "protocol"),
    ("prove", "set", "protocol"),
    ("refute", "agents", "protocol"),
    ("refute", "set", "protocol"),
    ("refute", "start", "protocol"),
    ("settle", "agents", "protocol"),
    ("settle", "set", "protocol"),
    ("threshold", "agents", "protocol"),
    ("threshold", "set", "protocol"),
    ("threshold", "parameter", "protocol"),
];

/// The command that was called, with its arguments.
pub struct Call<'a> {
    command: &'a clap::Command,
    matches: &'a ArgMatches,
}

impl<'a> Call<'a> {
    /// The innermost subcommand of a call.
    pub fn of(mut command: &'a clap::Command, mut matches: &'a ArgMatches) -> Self {
        while let Some((name, inner)) = matches.subcommand() {
            let Some(sub) = command.find_subcommand(name) else { break };
            (command, matches) = (sub, inner);
        }
        Self { command, matches }
    }

    /// Refuses a flag that has no effect without another one. (clap's own `requires` is waived where
    /// that other flag conflicts with one that is given; the flag would then be ignored silently.)
    ///
    /// # Errors
    /// The other flag is missing.
    pub fn complete(&self) -> Result<()> {
        let given = |id: &str| {
            let known = self.command.get_arguments().any(|a| a.get_id() == id);
            known && self.matches.value_source(id) == Some(ValueSource::CommandLine)
        };
        let here = NEEDS.iter().filter(|(command, ..)| *command == self.command.get_name());
        let Some((_, flag, other)) = here.into_iter().find(|(_, f, o)| given(f) && !given(o))
        else {
            return Ok(());
        };
        let named = self.command.get_arguments().find(|a| a.get_id() == *flag);
        let flag = named.and_then(|a| a.get_long()).unwrap_or(flag);
        Err(Error::input(format!("--{flag}: expected --{other} with it")))
    }

    /// Checks `--out` before any work is done. Returns whether the file goes to stdout, which then may
    /// carry nothing else.
    ///
    /// # Errors
    /// It is one of the inputs or read-only, or a folder is expected and `-` was given.
    pub fn output(&self) -> Result<bool> {
        let Some(out) = self.paths("out").into_iter().next() else { return Ok(false) };
        let input = self.inputs().into_iter().find(|input| files::same(input, out));
        if let Some(input) = input {
            return Err(Error::input(format!(
                "out: `{}`: expected another file than the input `{}`",
                out.display(),
                input.display()
            )));
        }
        if self.out_is_folder() {
            if out == Path::new(files::STREAM) {
                return Err(Error::input("out: `-`: expected a folder"));
            }
            files::expect_folder(out)?;
            return Ok(false);
        }
        files::expect_writable(out)?;
        Ok(files::is_stdout(out))
    }

    /// Whether the command writes files with `--out`.
    pub fn writes_files(&self) -> bool {
        !self.paths("out").is_empty()
    }

    /// The error in terms of the command line: a message that begins with the name of a given flag is
    /// about that flag.
    pub fn blame(&self, error: Error) -> Error {
        let Error::Input(message) = &error else { return error };
        let field = message.split([':', ' ']).next().unwrap_or_default();
        let id = field.replace('-', "_");
        let is_flag =
            self.command.get_arguments().any(|a| a.get_id() == id.as_str() && !a.is_positional());
        let given = is_flag && self.matches.value_source(&id) == Some(ValueSource::CommandLine);
        if given {
            let rest = message.get(field.len()..).unwrap_or_default();
            Error::input(format!("--{}{rest}", id.replace('_', "-")))
        } else {
            error
        }
    }

    fn out_is_folder(&self) -> bool {
        let out = self.command.get_arguments().find(|a| a.get_id() == "out");
        let names = out.and_then(|a| a.get_value_names()).unwrap_or_default();
        // A multi-model is a folder with its FMUs; so is a submitted sweep, with its parts.
        names.iter().any(|n| n.as_str() == "DIR")
            || self.command.get_name() == "into-cps"
            || matches!(self.matches.try_contains_id("submit"), Ok(true))
    }

    fn paths(&self, id: &str) -> Vec<&'a PathBuf> {
        let paths = self.matches.try_get_many::<PathBuf>(id);
        paths.ok().flatten().map(Iterator::collect).unwrap_or_default()
    }

    fn inputs(&self) -> Vec<&'a PathBuf> {
        let ids = self.command.get_arguments().map(|a| a.get_id().as_str());
        ids.filter(|id| *id != "out").flat_map(|id| self.paths(id)).collect()
    }
}
