//! The options of `cordon sweep`.

use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::Write;
use std::path::PathBuf;

use cordon_spec::theorems::Form;

use crate::cli::own_protocol::{Extent, ProtocolArgs};
use crate::cli::select::OutputFormat;
use cordon_core::theorems;
use cordon_core::{Error, Result, range};
use cordon_proof::counterexample::list as comma_list;
use cordon_proof::sweep::config::DRONES;
use cordon_proof::sweep::shard::Shard;
use cordon_proof::sweep::{Config, StartSpace, WeightSet};

/// Options of `cordon sweep`.
#[derive(clap::Args, Debug)]
pub(super) struct Options {
    /// Which theorems: numbers like 7.2 or 7.4ii, separated by commas [default: all]
    #[arg(value_name = "THEOREMS", conflicts_with = "protocol")]
    theorems: Option<String>,
    #[command(flatten)]
    pub(super) own: ProtocolArgs,
    /// Which form of the theorems
    #[arg(long, value_enum, default_value_t = Forms::Sharp, conflicts_with = "protocol")]
    form: Forms,
    /// Numbers of drones, both ends included, from 3 to 64
    #[arg(long, value_name = "LO..HI", default_value = "3..5", conflicts_with = "protocol")]
    drones: String,
    /// Sweep all weights eps = p/q of the range with q up to this
    #[arg(long, value_name = "Q", default_value_t = 6)]
    max_denominator: u32,
    /// Range of the weights, both ends included
    #[arg(
        long,
        value_name = "LO..HI",
        default_value = "0..1",
        allow_hyphen_values = true,
        conflicts_with = "protocol"
    )]
    eps_range: String,
    /// Use these weights instead, separated by commas: fractions or decimals
    #[arg(long, value_name = "LIST", conflicts_with_all = ["max_denominator", "eps_range", "protocol"], allow_hyphen_values = true)]
    eps: Option<String>,
    /// Ignore the theorems' own ranges of weights: shows why they are needed
    #[arg(long, conflicts_with = "protocol")]
    any_weight: bool,
    /// Least number of grid units across the region where internal drones start; with --protocol the parts
    /// into which each variable's range is divided
    #[arg(long, value_name = "G", default_value_t = 8)]
    grid: u32,
    /// Last protocol step k, up to 100000; with --protocol up to 1000
    #[arg(long, value_name = "K", default_value_t = 20)]
    steps: usize,
    /// Decide for all real starts instead of trying a grid
    #[arg(long, conflicts_with_all = ["grid", "sample"])]
    complete: bool,
    /// Draw this many random starts a work item instead of trying the whole grid
    #[arg(long, value_name = "M", conflicts_with = "protocol")]
    sample: Option<u64>,
    /// Seed of the draws [default: a new one]
    #[arg(long, value_name = "S")]
    seed: Option<u64>,
    /// Threads, 1 to 1024 [default: one for each core]
    #[arg(long, value_name = "T", conflicts_with = "protocol")]
    threads: Option<usize>,
    /// Run part I of N; together the parts cover every work item once
    #[arg(long, value_name = "I/N", conflicts_with = "protocol")]
    shard: Option<String>,
    /// Result file, one JSON line for each work item; finished items in it are reused. With
    /// --submit, the folder of the parts' files [default: cordon-, and a hash of the sweep]
    #[arg(long, value_name = "FILE", conflicts_with = "protocol")]
    pub(super) out: Option<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub(super) format: OutputFormat,
    #[command(flatten)]
    pub(super) cluster: super::submit::Options,
}

#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Forms {
    /// As printed
    Paper,
    /// Under the weakest known hypothesis
    Sharp,
    /// Both
    Both,
}

/// An arbitrary seed, which is printed to stderr.
pub(super) fn fresh_seed() -> u64 {
    RandomState::new().build_hasher().finish() >> 32
}

/// Most threads: more than any machine has, few enough to start.
const MAX_THREADS: usize = 1024;

/// Most steps of a sweep of a protocol file.
const MOST_OWN_STEPS: usize = 1_000;

impl Options {
    pub(super) fn config(&self) -> Result<Config> {
        let theorems = theorems::named(self.theorems.as_deref().unwrap_or("all"))?;
        let forms: &[Form] = match self.form {
            Forms::Paper => &[Form::Paper],
            Forms::Sharp => &[Form::Sharp],
            Forms::Both => &Form::ALL,
        };
        let drones = range::whole("drones", &self.drones, DRONES)?.into_inner();
        let starts = match (self.complete, self.sample) {
            (true, _) => StartSpace::Complete,
            (false, None) => StartSpace::Grid { resolution: self.grid },
            (false, Some(samples)) => StartSpace::Sample {
                resolution: self.grid,
                samples,
                seed: self.seed.unwrap_or_else(fresh_seed),
            },
        };
        let config =
            Config::new(&theorems, forms, drones.into(), self.weights()?, self.steps, starts);
        Ok(Config { only_weights_of_the_theorem: !self.any_weight, ..config })
    }

    fn weights(&self) -> Result<WeightSet> {
        if let Some(list) = &self.eps {
            return Ok(WeightSet::List(range::list(|_| "eps".into(), list)?));
        }
        let (from, to) = range::closed("eps-range", &self.eps_range)?;
        Ok(WeightSet::Range { from, to, max_denominator: self.max_denominator })
    }

    pub(super) fn shard(&self) -> Result<Shard> {
        self.shard.as_deref().map_or(Ok(Shard::WHOLE), Shard::parse)
    }

    /// The extent of a sweep of a protocol file.
    pub(super) fn extent(&self) -> Result<Extent> {
        if self.grid == 0 {
            return Err(Error::input("grid: `0`: expected at least 1"));
        }
        if self.max_denominator == 0 {
            return Err(Error::input("max-denominator: `0`: expected at least 1"));
        }
        if self.steps > MOST_OWN_STEPS {
            return Err(Error::input(format!(
                "steps: `{}`: expected at most {MOST_OWN_STEPS} with --protocol",
                self.steps
            )));
        }
        let grid = (!self.complete).then_some(self.grid);
        Ok(Extent { grid, denominators: self.max_denominator, steps: self.steps })
    }

    /// Number of threads; 0 means one for each core.
    pub(super) fn threads(&self) -> Result<usize> {
        match self.threads {
            None => Ok(0),
            Some(t) if (1..=MAX_THREADS).contains(&t) => Ok(t),
            Some(t) => Err(Error::input(format!("threads: `{t}`: expected 1 to {MAX_THREADS}"))),
        }
    }

    /// Prints on stderr how to draw the same starts again.
    pub(super) fn say_how_to_repeat(&self, config: &Config) {
        if !matches!(config.starts, StartSpace::Sample { .. }) {
            return;
        }
        let shard = self.shard.as_ref().map_or_else(String::new, |s| format!(" --shard {s}"));
        // If stderr is closed there is nothing left to do.
        let _ = writeln!(std::io::stderr(), "reproduce: cordon sweep {}{shard}", arguments(config));
    }
}

/// The arguments of `cordon sweep` for this configuration.
pub(super) fn arguments(config: &Config) -> String {
    let theorems = theorems::numbers(&config.theorems, ",");
    let form = match config.forms.as_slice() {
        [one] => one.label(),
        _ => "both",
    };
    let [fewest, most] = config.drones;
    let weights = match &config.weights {
        WeightSet::List(list) => format!("--eps {}", comma_list(list)),
        WeightSet::Range { from, to, max_denominator } => {
            format!("--eps-range {from}..{to} --max-denominator {max_denominator}")
        }
    };
    let any = if config.only_weights_of_the_theorem { "" } else { " --any-weight" };
    let starts = match config.starts {
        StartSpace::Complete => "--complete".to_owned(),
        StartSpace::Grid { resolution } => format!("--grid {resolution}"),
        StartSpace::Sample { resolution, samples, seed } => {
            format!("--grid {resolution} --sample {samples} --seed {seed}")
        }
    };
    let steps = config.steps;
    format!(
        "{theorems} --form {form} --drones {fewest}..{most} {weights}{any} --steps {steps} {starts}"
    )
}
