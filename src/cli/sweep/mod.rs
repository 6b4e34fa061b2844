//! `cordon sweep`, `cordon sweep status` and `cordon sweep merge`.

mod options;
mod show;
mod submit;
mod watch;

use std::io::Write;
use std::path::PathBuf;

use super::own_protocol;
use super::select::OutputFormat;
use cordon_core::{Error, Outcome, Result, files, theorems};
use cordon_proof::sweep::run::{Progress, run as run_items, work};
use cordon_proof::sweep::shard::Shard;
use cordon_proof::sweep::store::{Header, Store, line_of};
use cordon_proof::sweep::{Config, Finding, Item, merge};

/// Arguments of `cordon sweep`.
#[derive(clap::Args, Debug)]
#[command(args_conflicts_with_subcommands = true, after_help = MORE)]
pub struct Args {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    options: options::Options,
}

const MORE: &str = "\
Every start on the grid is tried at every step k = 0 .. K, or with --complete all real starts \
at once. A row says which kind of evidence it is. Segments are [0, L] with L the smallest \
multiple of N-1 of at least G grid units; for theorems whose starts lie in the first subsegment \
(assumption 3) that subsegment has G units.

Swept are the sharp forms, which hold. Printed forms (`--form paper`) of some theorems fail beyond \
their true range: then the exit code is 1, and the output says that it was to be expected.

Examples:
  cordon sweep                                    all theorems, every start on a small grid
  cordon sweep --form paper                       as printed: where do they fail?
  cordon sweep 7.2,7.3 --complete --drones 3..12  from all real starts
  cordon sweep 7.8 --shard 1/4 --out part-1.jsonl one part of four, which goes on after a crash
  cordon sweep --protocol FILE --grid 4           the claims of a protocol of your own
  cordon sweep merge part-*.jsonl --audit 5       the parts together, five items recomputed
  cordon sweep 7.2 --drones 3..8 --submit slurm --shards 64 --out big
                                                  as a job array of Slurm, and its merge
  cordon sweep status big                         what of it is done

Limits: 3 to 64 drones, 100,000 steps, 1,000,000 weights, 1,000,000 work items, 1,024 threads.

Exit codes: 0 every claim holds, 1 some claim is refuted (a counterexample is printed, with the \
command that replays it), 2 bad usage or input, 3 some claim is vacuous or undecided, 74 I/O error";

#[derive(clap::Subcommand, Debug)]
enum Command {
    /// Merge the result files of all parts of a sweep
    Merge(MergeArgs),
    /// Show the state of a submitted sweep, and how to run the rest
    Status(submit::status::Args),
}

/// Arguments of `cordon sweep merge`.
#[derive(clap::Args, Debug)]
struct MergeArgs {
    /// Result files of `cordon sweep --out`
    #[arg(required = true, value_name = "FILES")]
    files: Vec<PathBuf>,
    /// Write the whole sweep to this result file
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Recompute N random work items, and refuse files that disagree
    #[arg(long, value_name = "N", default_value_t = 0)]
    audit: usize,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
}

/// Sweeps, or merges the parts of a sweep.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    match &args.command {
        Some(Command::Merge(m)) => merged(m, out),
        Some(Command::Status(s)) => submit::status::run(s, out),
        None if args.options.cluster.asked() => submit::run(&args.options, out),
        None => match args.options.own.system()? {
            Some((_, system)) => {
                let (options, own) = (&args.options, &args.options.own);
                own_protocol::sweep(own, &system, options.extent()?, options.format, out)
            }
            None => swept(&args.options, out),
        },
    }
}

fn merged(args: &MergeArgs, out: &mut dyn Write) -> Result<Outcome> {
    let (config, findings) = merge::merge(&args.files)?;
    if args.audit > 0 {
        let seed = options::fresh_seed();
        let drawn = merge::audit(&config, &findings, args.audit, seed)?;
        // If stderr is closed there is nothing left to do.
        let _ = writeln!(
            std::io::stderr(),
            "audited: {} of {} work items recomputed, all equal (seed {seed})",
            drawn.len(),
            findings.len()
        );
    }
    let header = Header::new(&config, Shard::WHOLE, findings.len());
    if let Some(path) = &args.out {
        let mut content = line_of(&header)?;
        for finding in &findings {
            content.push_str(&line_of(finding)?);
        }
        files::write_atomically(path, content.as_bytes())?;
    }
    show::report(&header, &findings, args.format, out)
}

fn swept(options: &options::Options, out: &mut dyn Write) -> Result<Outcome> {
    let config = options.config()?;
    let shard = options.shard()?;
    let all = listed(&config)?;
    let header = Header::new(&config, shard, all.len());
    let items = shard.of_items(&config, all)?;
    let total = work(&config, &items)?;
    if options.out.as_ref().is_some_and(|path| path.as_os_str() == files::STREAM) {
        return Err(Error::input("out: `-`: expected a file, so that a later run can continue"));
    }
    let (mut store, mut findings) = match &options.out {
        Some(path) => {
            let (store, findings) = Store::open(path, &header, &items)?;
            (Some(store), findings)
        }
        None => (None, Vec::new()),
    };
    let left = items.get(findings.len()..).unwrap_or_default();
    let resumed = items.len() - left.len();
    let total = if resumed == 0 { total } else { work(&config, left)? };
    let progress = Progress::default();
    let emit = |finding: Finding| {
        if let Some(store) = &mut store {
            store.add(&finding)?;
        }
        findings.push(finding);
        Ok(())
    };
    watch::watched(&progress, total, watch::WorkUnit::of(&config), resumed, || {
        run_items(&config, left, options.threads()?, &progress, emit)
    })?;
    if let Some(store) = store {
        store.finish()?;
    }
    let outcome = show::report(&header, &findings, options.format, out)?;
    out.flush()?;
    options.say_how_to_repeat(&config);
    Ok(outcome)
}

/// The work items of a sweep, at least one.
fn listed(config: &Config) -> Result<Vec<Item>> {
    let items = config.items()?;
    if items.is_empty() {
        return Err(Error::input(format!(
            "eps: no weight is in the range of {}: expected one, or `--any-weight`",
            theorems::numbers(&config.theorems, ", ")
        )));
    }
    Ok(items)
}
