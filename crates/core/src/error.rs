//! How a command ends: with a verdict, or with an error that names the user's mistake.

use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What a command that ran to its end has found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Everything asked for was done, every claim asked about holds (exit code 0).
    Holds,
    /// A claim was refuted; the counterexample is on stdout (exit code 1).
    Refuted,
    /// Neither a proof nor a counterexample, or the engine was not run (exit code 3).
    Inconclusive,
    /// A certificate was rejected (exit code 4).
    Rejected,
}

impl Outcome {
    /// The worse of two outcomes: rejected, then refuted, then inconclusive, then holds.
    pub fn worst(self, other: Self) -> Self {
        let rank = |o| match o {
            Self::Holds => 0,
            Self::Inconclusive => 1,
            Self::Refuted => 2,
            Self::Rejected => 3,
        };
        if rank(self) >= rank(other) { self } else { other }
    }

    /// The process exit code.
    pub fn code(self) -> u8 {
        match self {
            Self::Holds => 0,
            Self::Refuted => 1,
            Self::Inconclusive => 3,
            Self::Rejected => 4,
        }
    }
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        outcome.code().into()
    }
}

/// Why a command did not run to its end.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Bad usage or bad input (exit code 2). The message is in the user's words: what was
    /// given (in backticks), what was expected, and where.
    #[error("{0}")]
    Input(String),
    /// A file could not be read or written (exit code 74, `EX_IOERR`).
    #[error("cannot {action} `{}`: {source}", path.display())]
    File {
        /// The operation, as a verb that goes with the path: `read`, `create`, `lock`.
        action: &'static str,
        /// The file, as the user named it.
        path: PathBuf,
        /// The operating system's error.
        source: io::Error,
    },
    /// stdout or stderr could not be written (exit code 74).
    #[error("cannot write the output: {0}")]
    Output(#[from] io::Error),
    /// The independent checker rejects what one of Cordon's own searches found (exit code 4).
    #[error(
        "the independent checker rejects what was found: {0}; the fault is cordon's, not the input's: please report it with the command"
    )]
    Rejected(String),
    /// A fault inside Cordon (exit code 70, `EX_SOFTWARE`): never caused by bad input, and nothing that
    /// the user can mend.
    #[error(
        "internal fault: {0}; the fault is cordon's, not the input's: please report it with the command"
    )]
    Internal(String),
}

impl Error {
    /// An [`Error::Input`] with this message.
    pub fn input(message: impl Into<String>) -> Self {
        Self::Input(message.into())
    }

    /// An [`Error::Internal`] with this message.
    pub fn internal(message: impl Into<String>) -> Self {
        Self::Internal(message.into())
    }

    /// An [`Error::File`]: `action` is a verb, as in "cannot read".
    pub fn file(action: &'static str, path: &Path, source: io::Error) -> Self {
        Self::File { action, path: path.to_owned(), source }
    }

    /// The process exit code.
    pub fn code(&self) -> u8 {
        match self {
            Self::Input(_) => 2,
            Self::Rejected(_) => 4,
            Self::Internal(_) => 70,
            Self::File { .. } | Self::Output(_) => 74,
        }
    }

    /// Whether the reader of stdout has gone away, which deserves no message.
    pub fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Output(e) if e.kind() == io::ErrorKind::BrokenPipe)
    }
}

/// The result of every fallible function in Cordon.
pub type Result<T, E = Error> = std::result::Result<T, E>;
