//! `cordon cosim`.

mod batch;
mod summary;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::cli::choice::{Choice, choice};
use crate::cli::fmu::HOST;
use crate::cli::progress;
use crate::cli::scenario_args::ScenarioArgs;
use crate::cli::separation;
use cordon_core::text::Printable;
use cordon_core::{Error, Outcome, Result};
use cordon_core::{exact, files};
use cordon_cosim::batch::Batch;
use cordon_cosim::cosimulation::{Cosimulation, Loader};
use cordon_cosim::store::{self, Format};
use cordon_cosim::{exact_run, run as engine};
use cordon_formats::fmi::import::{Isolation, substitute};
use cordon_run::scenario::{Flight, Own, Places};

/// Arguments of `cordon cosim`.
#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    scenario: ScenarioArgs,
    #[command(flatten)]
    flight: FlightArgs,
    /// Write the run into this file; the summary goes to stdout
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Also record these variables of units: patterns over names like plant0.theta, where `*` stands
    /// for any text, as in '*.w1,*.theta'
    #[arg(long, value_name = "PATTERNS", value_delimiter = ',')]
    variables: Vec<String>,
    /// Format of the run [default: by the name of `--out`; without it a summary is printed]
    #[arg(long, value_parser = choice::<Format>())]
    format: Option<Format>,
    /// Show progress from the start, on a terminal; else after two seconds
    #[arg(long)]
    progress: bool,
    /// Also run in exact arithmetic and report the error of the doubles
    #[arg(long)]
    exact: bool,
}

/// The flags of a co-simulation.
#[derive(clap::Args, Debug, Default)]
pub struct FlightArgs {
    /// Length of the run in seconds [default: 25]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true, help_heading = "Flight")]
    duration: Option<String>,
    /// Plant integrator: euler or exact [default: euler]
    #[arg(long, value_name = "NAME", help_heading = "Flight")]
    integrator: Option<String>,
    /// Master: jacobi or gauss-seidel [default: jacobi]
    #[arg(long, value_name = "NAME", help_heading = "Flight")]
    master: Option<String>,
    /// How positions travel between drones: exact or double [default: exact]
    #[arg(long, value_name = "NAME", help_heading = "Flight")]
    exchange: Option<String>,
    /// Order in which drones update, each with the new positions of those before it: at-once,
    /// ascending, descending, or a list like 2,0,1 [default: at-once]
    #[arg(long, value_name = "ORDER", help_heading = "Flight")]
    order: Option<String>,
    /// Seed of the random faults [default: 0], and of what a protocol file leaves open in each step
    /// [default: none is lost, late or skipped; the first mode]
    #[arg(long, value_name = "NUMBER", help_heading = "Flight")]
    seed: Option<u64>,
    /// Arithmetic of the authors' recorded runs, to the last bit
    #[arg(long, value_enum, help_heading = "Flight")]
    compat: Option<Compat>,
    /// Run FMUs in this process: faster, but a crash of the FMU ends this program too
    #[arg(long, help_heading = "FMUs")]
    in_process: bool,
    /// Longest time that an FMU may take for a step [default: 60]
    #[arg(
        long,
        value_name = "SECONDS",
        allow_hyphen_values = true,
        help_heading = "FMUs",
        conflicts_with = "in_process"
    )]
    step_limit: Option<f64>,
}

/// Arithmetics of earlier programs.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compat {
    /// The authors' recorded runs
    Recorded,
}

impl FlightArgs {
    /// Refuses these flags where a recorded run is read from a file.
    ///
    /// # Errors
    /// One of them is given.
    pub(in crate::cli) fn refuse_for(&self, run: &Path) -> Result<()> {
        match self.given().next() {
            Some(flag) => Err(Error::input(format!(
                "{flag}: expected a scenario to fly, found a run, `{}`",
                run.display()
            ))),
            None => Ok(()),
        }
    }

    /// Refuses the flags with these names.
    ///
    /// # Errors
    /// One of them is given.
    pub(in crate::cli) fn refuse(&self, flags: &[&str], why: &str) -> Result<()> {
        match self.given().find(|flag| flags.contains(flag)) {
            Some(flag) => Err(Error::input(format!("{flag}: expected none: {why}"))),
            None => Ok(()),
        }
    }

    /// Where FMUs of other tools run: in separate processes or in this one.
    fn isolation(&self) -> Result<Isolation> {
        if self.in_process {
            return Ok(Isolation::InProcess);
        }
        let seconds = self.step_limit.unwrap_or(60.0);
        let limit = Duration::try_from_secs_f64(seconds).ok().filter(|limit| !limit.is_zero());
        Ok(Isolation::Process {
            program: std::env::current_exe()
                .map_err(|e| Error::file("find", Path::new("cordon"), e))?,
            arguments: HOST.map(str::to_owned).to_vec(),
            limit: limit.ok_or_else(|| {
                Error::input(format!(
                    "step-limit: `{seconds}`: expected a positive number of seconds"
                ))
            })?,
        })
    }

    fn given(&self) -> impl Iterator<Item = &'static str> {
        let flags = [
            ("duration", self.duration.is_some()),
            ("integrator", self.integrator.is_some()),
            ("master", self.master.is_some()),
            ("exchange", self.exchange.is_some()),
            ("order", self.order.is_some()),
            ("seed", self.seed.is_some()),
            ("compat", self.compat.is_some()),
            ("in-process", self.in_process),
            ("step-limit", self.step_limit.is_some()),
        ];
        flags.into_iter().filter(|(_, is)| *is).map(|(flag, _)| flag)
    }

    /// The swarm that a scenario and these flags describe.
    ///
    /// # Errors
    /// The scenario cannot be read, or a field is wrong.
    pub(in crate::cli) fn swarm(&self, scenario: &ScenarioArgs) -> Result<Cosimulation> {
        Ok(self.swarm_exchanging(scenario, "exact")?.0)
    }

    /// As [`Self::swarm`], with the locations of the file's fields; where neither the scenario nor a flag
    /// says how positions travel, they travel as `exchange`.
    ///
    /// # Errors
    /// The scenario cannot be read, or a field is wrong.
    pub(in crate::cli) fn swarm_exchanging(
        &self,
        scenario: &ScenarioArgs,
        exchange: &str,
    ) -> Result<(Cosimulation, Places)> {
        let (checked, flight, mut places) = scenario.scenario_and_flight(self.seed)?;
        let chosen = checked.own().is_some_and(Own::has_choices);
        if self.seed.is_some() && flight.faults.is_empty() && !chosen {
            return Err(Error::input(
                "seed: expected together with faults, or with a protocol file that leaves choices",
            ));
        }
        let flags = Flight {
            duration: self.duration.as_deref().map(|t| exact::parse("duration", t)).transpose()?,
            integrator: self.integrator.clone(),
            master: self.master.clone(),
            exchange: self.exchange.clone(),
            order: self.order.clone(),
            seed: self.seed,
            ..Flight::default()
        };
        self.given().for_each(|flag| places.replaced(flag));
        let mut flight = flight.replaced_by(flags);
        flight.exchange.get_or_insert(exchange.to_owned());
        let swarm = Cosimulation::new(checked, flight);
        let mut swarm = swarm.map_err(|e| places.point(e))?;
        let isolation = self.isolation()?;
        swarm.load = Loader::new(move |fmu, unit| substitute(&isolation, fmu, unit));
        swarm.units.iter().for_each(|unit| files::is_input(&unit.fmu));
        let swarm = match self.compat {
            Some(Compat::Recorded) => swarm.as_recorded()?,
            None => swarm,
        };
        Ok((swarm, places))
    }
}

/// Runs a scenario or a batch, and prints the results.
pub(in crate::cli) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let out_format = args.out.as_deref().map(|path| args.format_of(path)).transpose()?;
    let mut swarm = args.flight.swarm(&args.scenario)?;
    swarm.recorded_variables.clone_from(&args.variables);
    if let Some(batch) = Batch::of(&swarm)? {
        return batch::run(args, &swarm, &batch, out);
    }
    if args.exact && !swarm.units.is_empty() {
        return Err(Error::input("exact: expected units of this program: FMUs compute in doubles"));
    }
    if let (Some(path), Some(format)) = (&args.out, out_format) {
        // Checked again, now that the files named by the scenario are known.
        store::written(path, format).iter().try_for_each(|file| files::expect_writable(file))?;
    }
    if args.progress {
        progress::at_once();
    }
    let (record, ended) = engine::run_as_far_as_it_goes(&swarm)?;
    for note in &record.notes {
        eprint_all(format!("warning: {note}\n").as_bytes());
    }
    let difference = match args.exact && ended.is_ok() {
        true => Some(exact_run::difference(&swarm, &record)?),
        false => None,
    };
    let mut about = Vec::new();
    let known = if ended.is_ok() { separation::known_gap(&swarm) } else { None };
    summary::text(&record, known.as_ref(), &mut about)?;
    if let Some(d) = &difference {
        writeln!(about, "\n{d}")?;
    }
    match (&args.out, out_format.or(args.format)) {
        (Some(path), Some(format)) => {
            store::save(&record, format, path)?;
            out.write_all(&about)?;
        }
        (None, Some(format)) => {
            // stdout carries only the run.
            store::save(&record, format, Path::new(files::STREAM))?;
            eprint_all(&about);
        }
        (_, None) => out.write_all(&about)?,
    }
    // The run up to a unit's failure is written, and marked; the command still fails.
    ended.map(|()| Outcome::Holds)
}

fn eprint_all(text: &[u8]) {
    // If stderr is closed there is nothing left to do.
    let _ = Printable(std::io::stderr()).write_all(text);
}

impl Args {
    /// The format of the run file: as requested, or by the file's name.
    fn format_of(&self, path: &Path) -> Result<Format> {
        match (self.format.or(Format::of(path)), path.extension()) {
            (Some(format), _) => Ok(format),
            (None, None) => Ok(Format::Csv),
            (None, Some(_)) => Err(Error::input(format!(
                "out: `{}`: expected a name that ends in .csv, .json or .parquet, or --format",
                path.display()
            ))),
        }
    }
}

impl Choice for Format {
    const ALL: &'static [(&'static str, Self, &'static str)] = &[
        ("csv", Self::Csv, "Comma-separated values: time, positions, other variables"),
        (
            "json",
            Self::Json,
            "JSON, schema cordon-cosim/1, with collisions and violations of the order",
        ),
        (
            "parquet",
            Self::Parquet,
            "Apache Parquet, the columns of the CSV (needs the cargo feature `parquet`)",
        ),
    ];
}
