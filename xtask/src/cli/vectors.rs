//! `cargo xtask vectors`.

use std::io::Write;
use std::path::PathBuf;

use crate::vectors::{json, lean, rocq, tsv, vectors};
use cordon_core::{Outcome, Result, files};

/// Arguments of `cargo xtask vectors`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Form of the vectors
    #[arg(long, value_enum)]
    pub to: Target,
    /// Write to a file [default: stdout]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// The file to write vectors for.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// proofs/rocq/theories/Vectors.v
    Rocq,
    /// lean-mirror/CordonMirror/Vectors.lean
    Lean,
    /// proofs/rocq/vectors.tsv: tab-separated values
    Tsv,
    /// JSON, schema cordon-vectors/2
    Json,
}

/// Prints the vectors.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let vectors = vectors();
    let text = match args.to {
        Target::Rocq => rocq(&vectors),
        Target::Lean => lean(&vectors),
        Target::Tsv => tsv(&vectors),
        Target::Json => json(&vectors),
    };
    match &args.out {
        Some(path) => files::write_atomically(path, text.as_bytes())?,
        None => out.write_all(text.as_bytes())?,
    }
    Ok(Outcome::Holds)
}
