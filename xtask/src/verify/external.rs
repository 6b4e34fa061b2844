//! Tiers checked by an external program: a proof assistant, a verifier for Rust.
//!
//! They take minutes, so they run on request (`--run`) and are otherwise shown from their record. Their
//! claims are listed in a table beside their sources: tab-separated, with a heading; first the
//! theorem's number, then its form, last the statement in words.

use std::cell::OnceCell;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Instant;

use cordon_spec::theorems::Theorem;

use super::{Context, Evidence, Status, Tier, TierVerdict};
use cordon_core::files;

/// The parameters of such a tier.
#[derive(Debug)]
struct Tool {
    name: &'static str,
    kind: Evidence,
    /// Folder of the development, below the root.
    folder: &'static str,
    /// Working directory of the program, below the root.
    directory: &'static str,
    program: &'static str,
    arguments: &'static [&'static str],
    /// Command that prints the tool's version.
    version: [&'static str; 3],
    sources: &'static [&'static str],
}

const ROCQ: Tool = Tool {
    name: "rocq",
    kind: Evidence::Mechanised,
    folder: "proofs/rocq",
    directory: "proofs/rocq",
    program: "./check.sh",
    arguments: &[],
    version: ["coqc", "--version", ""],
    sources: &["spec/src", "proofs/rocq"],
};

const LEAN: Tool = Tool {
    name: "lean",
    kind: Evidence::Mechanised,
    folder: "lean-mirror",
    directory: "lean-mirror",
    program: "lake",
    arguments: &["build"],
    version: ["lake", "--version", ""],
    // Lean reads nothing else. That the mirror agrees with the spec is tested separately, by twins and
    // vectors.
    sources: &["lean-mirror"],
};

/// The exported theories, whose general part is in files. The generated part (the theorems in words,
/// one scenario's numbers) occurs only in the proof that replays the scenario.
const PVS: Tool = Tool {
    name: "pvs",
    kind: Evidence::Mechanised,
    folder: "proofs/pvs",
    directory: "proofs/pvs",
    program: "./check.sh",
    arguments: &[],
    version: ["pvs", "--version", ""],
    sources: &["crates/proof/src/export/pvs/theories", "proofs/pvs"],
};

/// The spec's own Rust code with its contracts, and their consequences.
const CREUSOT: Tool = Tool {
    name: "creusot",
    // Proved by solvers, not by a kernel.
    kind: Evidence::Inductive,
    folder: "proofs/creusot",
    directory: ".",
    program: "cargo",
    arguments: &[
        "creusot",
        "prove",
        "-p",
        "cordon-spec",
        "-p",
        "cordon-contracts",
        "--",
        "--features",
        "cordon-spec/contracts,cordon-contracts/contracts",
    ],
    version: ["cargo", "creusot", "version"],
    sources: &["spec/src", "spec/model", "proofs/creusot/src"],
};

/// The table of a tier's claims, in its folder.
const TABLE: &str = "theorems.tsv";

/// A tier that runs an external program.
#[derive(Debug)]
pub struct External {
    tool: Tool,
    root: PathBuf,
    requested: bool,
    ran: OnceCell<Result<Ran, String>>,
}

#[derive(Debug)]
struct Ran {
    verdict: TierVerdict,
    seconds: f64,
}

/// The tier of the Rocq development.
pub fn rocq(context: Context<'_>) -> External {
    External::new(ROCQ, context)
}

/// The tier of the Lean mirror.
pub fn lean(context: Context<'_>) -> External {
    External::new(LEAN, context)
}

/// The exported PVS theories.
pub fn pvs(context: Context<'_>) -> External {
    External::new(PVS, context)
}

/// The contracts of the spec.
pub fn creusot(context: Context<'_>) -> External {
    External::new(CREUSOT, context)
}

impl External {
    fn new(tool: Tool, context: Context<'_>) -> Self {
        let requested = context.run.iter().any(|name| name == tool.name);
        Self { tool, root: context.root.to_owned(), requested, ran: OnceCell::new() }
    }

    /// The rows of the table about a theorem.
    fn rows(&self, theorem: Theorem) -> Result<Vec<Row>, String> {
        let path = self.root.join(self.tool.folder).join(TABLE);
        let text = files::read_text(&path, files::Limit::RECORD).map_err(|_| {
            format!("no `{}/{TABLE}` with the list of what is claimed", self.tool.folder)
        })?;
        Ok(text.lines().skip(1).filter_map(Row::read).filter(|r| r.is_about(theorem)).collect())
    }

    fn run(&self) -> Result<Ran, String> {
        let Tool { program, arguments, directory, .. } = self.tool;
        if version(self.tool.version).is_none() {
            return Err(format!("`{}` is not installed", self.tool.version[0]));
        }
        let started = Instant::now();
        let out = Command::new(program)
            .args(arguments)
            .current_dir(self.root.join(directory))
            .stdin(Stdio::null())
            // Pass its progress on to our stderr.
            .stderr(Stdio::inherit())
            .output()
            .map_err(|e| format!("`{program}` does not run: {e}"))?;
        let seconds = started.elapsed().as_secs_f64();
        let said = String::from_utf8_lossy(&out.stdout);
        let verdict = if out.status.success() {
            TierVerdict::Holds
        } else {
            let last: Vec<_> = said.lines().filter(|l| !l.trim().is_empty()).collect();
            let tail = last.get(last.len().saturating_sub(3)..).unwrap_or_default().join("; ");
            TierVerdict::Rejected(format!("`{program}` ended with {}: {tail}", out.status))
        };
        Ok(Ran { verdict, seconds })
    }
}

struct Row {
    number: String,
    form: String,
}

impl Row {
    fn read(line: &str) -> Option<Self> {
        let mut columns = line.split('\t');
        let (number, form) = (columns.next()?.to_owned(), columns.next()?.to_owned());
        Some(Self { number, form })
    }

    /// Whether the row is about the theorem or, as `7.4`, about all of its parts.
    fn is_about(&self, theorem: Theorem) -> bool {
        let number = theorem.number();
        self.number == number || self.number == number.trim_end_matches('i')
    }
}

fn version(command: [&str; 3]) -> Option<String> {
    let [program, arguments @ ..] = command;
    let out = Command::new(program)
        .args(arguments.iter().filter(|a| !a.is_empty()))
        .stderr(Stdio::null())
        .output()
        .ok()?;
    let text = String::from_utf8(out.stdout).ok()?;
    out.status.success().then(|| text.lines().next().unwrap_or(program).trim().to_owned())
}

impl Tier for External {
    fn name(&self) -> &'static str {
        self.tool.name
    }

    fn kind(&self) -> Evidence {
        self.tool.kind
    }

    fn tool(&self) -> String {
        version(self.tool.version).unwrap_or_else(|| self.tool.version[0].to_owned())
    }

    fn sources(&self) -> &'static [&'static str] {
        self.tool.sources
    }

    fn status(&self, theorem: Theorem) -> Status {
        let Tool { name, folder, .. } = self.tool;
        if !self.root.join(folder).is_dir() {
            return Status::NotRun(format!("no `{folder}` here"));
        }
        let rows = match self.rows(theorem) {
            Ok(rows) => rows,
            Err(why) => return Status::NotRun(why),
        };
        if rows.is_empty() {
            return Status::NotClaimed(format!("no row of `{folder}/{TABLE}` is about it"));
        }
        if !self.requested {
            return Status::NotRun(format!("on request only: `--run {name}`"));
        }
        match self.ran.get_or_init(|| self.run()) {
            Err(why) => Status::NotRun(why.clone()),
            Ok(ran) => {
                let forms: Vec<_> = rows.iter().map(|r| r.form.as_str()).collect();
                Status::Run {
                    verdict: ran.verdict.clone(),
                    scope: forms.join("; "),
                    seconds: ran.seconds,
                }
            }
        }
    }
}
