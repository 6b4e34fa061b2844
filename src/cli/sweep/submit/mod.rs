//! `cordon sweep --submit`: a sweep as jobs of an existing scheduler.
//!
//! The folder of a submitted sweep has this program, a script that runs one part, a script that merges
//! all parts, the scheduler's files, and a result file for each part. The result files are created
//! before anything is submitted: each names the configuration, the program's version and its part, and
//! cannot be continued by a sweep of another configuration or version.

mod kubernetes;
mod scripts;
mod slurm;
pub(super) mod status;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::options::arguments;
use cordon_core::fingerprint::Fingerprint;
use cordon_core::text::shell_word;
use cordon_core::{Error, Outcome, Result, files};
use cordon_proof::sweep::Config;
use cordon_proof::sweep::shard::{Shard, imbalance, parts};
use cordon_proof::sweep::store::{Header, Store, line_of};

/// Options of `cordon sweep --submit`.
#[derive(clap::Args, Debug)]
pub(in super::super) struct Options {
    /// Run the sweep as jobs of this scheduler: a job for each part, and one that merges them
    #[arg(long, value_enum, conflicts_with_all = ["shard", "format", "protocol"])]
    submit: Option<Scheduler>,
    /// Number of parts, at most one for each work item
    #[arg(long, value_name = "N")]
    shards: Option<usize>,
    /// Partitions of Slurm, separated by commas
    #[arg(long, value_name = "P")]
    partition: Option<String>,
    /// Limit of each job's time, as Slurm reads it: 90 (minutes), 1:30:00 or 2-12 (days and hours)
    #[arg(long, value_name = "T")]
    time: Option<String>,
    /// Print the files that would be run; write and submit nothing
    #[arg(long)]
    dry_run: bool,
}

#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Scheduler {
    /// A job array, and a job that depends on it
    Slurm,
    /// An Indexed Job and a merging one as YAML, and the container file; for you to apply
    Kubernetes,
}

impl Options {
    pub(super) fn asked(&self) -> bool {
        self.submit.is_some()
    }
}

/// The data that every scheduler needs.
struct Jobs<'a> {
    /// `cordon-` and the hash of the configuration.
    name: String,
    /// The arguments of `cordon sweep` for the whole sweep.
    arguments: String,
    /// Number of shards.
    parts: usize,
    /// Cores of each part.
    threads: usize,
    /// Partition and limit of time.
    limits: [(&'static str, Option<&'a str>); 2],
}

/// Most parts: the largest job array that Slurm can be configured for.
const MAX_PARTS: usize = 4_000_000;

pub(super) fn run(given: &super::options::Options, out: &mut dyn Write) -> Result<Outcome> {
    let Options { submit, shards, partition, time, dry_run } = &given.cluster;
    let config = given.config()?;
    let items = super::listed(&config)?;
    let (count, of) = (items.len(), shards.unwrap_or(1));
    if !(1..=count.min(MAX_PARTS)).contains(&of) {
        return Err(Error::input(format!(
            "shards: `{of}`: expected 1 to {}, the sweep's number of work items",
            count.min(MAX_PARTS)
        )));
    }
    let jobs = Jobs {
        name: named(&config)?,
        arguments: arguments(&config),
        parts: of,
        threads: given.threads()?.max(1),
        limits: [("partition", partition.as_deref()), ("time", time.as_deref())],
    };
    let slurm = *submit == Some(Scheduler::Slurm);
    let told = if slurm { slurm::files(&jobs)? } else { kubernetes::files(&jobs)? };
    let texts = scripts::files(&jobs).into_iter().chain(told);
    let folder = given.out.clone().unwrap_or_else(|| PathBuf::from(&jobs.name));
    if *dry_run {
        for (name, text) in texts {
            writeln!(out, "==> {} <==\n{text}", folder.join(name).display())?;
        }
        return Ok(Outcome::Holds);
    }
    fs::create_dir_all(&folder).map_err(|e| Error::file("make", &folder, e))?;
    let parts = parts(&config, items, of)?;
    for (i, part) in parts.iter().enumerate() {
        let header = Header::new(&config, Shard { index: i + 1, of }, count);
        Store::open(&scripts::result(&folder, i + 1), &header, &part.items)?.0.finish()?;
    }
    copy_of_this_program(&folder.join("cordon"))?;
    for (name, text) in texts {
        files::write_atomically(&folder.join(name), text.as_bytes())?;
    }
    writeln!(
        out,
        "{of} parts of {count} work items in `{}`: the largest costs {} times the mean",
        folder.display(),
        imbalance(&parts)
    )?;
    if slurm {
        submitted(&folder, out)?;
    } else {
        kubernetes::next(&jobs, &folder, out)?;
    }
    writeln!(
        out,
        "what is done: cordon sweep status {}",
        shell_word(&folder.display().to_string())
    )?;
    Ok(Outcome::Holds)
}

fn named(config: &Config) -> Result<String> {
    let mut hash = Fingerprint::default();
    hash.add_text(&line_of(config)?);
    Ok(format!("cordon-{}", hash.hex()))
}

/// The program is copied with the sweep: a later build on the submitting machine has no effect.
fn copy_of_this_program(to: &Path) -> Result<()> {
    let fail = |e| Error::file("write", to, e);
    let this = std::env::current_exe().map_err(fail)?;
    let fresh = to.with_extension("new");
    fs::copy(this, &fresh).map_err(fail)?;
    // A running program can be replaced, but not written to.
    fs::rename(&fresh, to).map_err(fail)
}

/// Runs the script that submits, and passes on its output.
fn submitted(folder: &Path, out: &mut dyn Write) -> Result<()> {
    let script = folder.join(slurm::SUBMIT);
    let ran =
        Command::new("sh").arg(&script).output().map_err(|e| Error::file("run", &script, e))?;
    out.write_all(&ran.stdout)?;
    if ran.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&ran.stderr);
    Err(Error::input(format!(
        "submit: `slurm`: {}; everything is ready in `{}`: expected a machine on which `sh {}` submits it",
        said.trim_end().lines().last().unwrap_or("no reason given"),
        folder.display(),
        script.display()
    )))
}
