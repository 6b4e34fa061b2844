//! `cordon trace`.

mod at;
mod show;

use std::io::Write;

use cordon_spec::theorems::{Form, Theorem};

use crate::cli::scenario_args::ScenarioArgs;
use crate::cli::select::FormArg;
use at::{AtArgs, Shape};
use cordon_core::theorems;
use cordon_core::{Error, Outcome, Result};
use cordon_run::fast::verify::Verification;
use cordon_run::scenario::{Own, Scenario};
use cordon_run::trace::{
    Checked, CheckedClaim, Counted, Row, Selection, applicable, check, check_claims, select,
};
use show::Numbers;

/// Arguments of `cordon trace`.
#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    scenario: ScenarioArgs,
    /// Last protocol step [default: the scenario's, or 20]
    #[arg(long, value_name = "K", conflicts_with = "ticks")]
    steps: Option<u64>,
    /// Count ticks instead of protocol steps, up to this one
    #[arg(long, value_name = "K")]
    ticks: Option<u64>,
    /// First row, a step or tick
    #[arg(long, value_name = "K", default_value_t = 0)]
    from: u64,
    /// Last row [default: the last step or tick]
    #[arg(long, value_name = "K")]
    to: Option<u64>,
    /// Distance between rows
    #[arg(long, value_name = "K", default_value_t = 1)]
    every: u64,
    /// Theorems to check at every step: numbers like 7.2,7.3 or `all`; of a protocol file its
    /// claims: `all`, or 1 for the first
    #[arg(long, value_name = "NUMBERS")]
    check: Option<String>,
    /// Form of the checked theorems
    #[arg(long, value_enum, default_value_t = FormArg::Sharp)]
    form: FormArg,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
    /// How numbers are written [default: decimal in tables, both in csv]
    #[arg(long, value_enum)]
    numbers: Option<Numbers>,
    /// Decimal places, rounded half to even, up to 10000 [default: 4]
    #[arg(long, value_name = "D")]
    digits: Option<usize>,
    /// Draw a small plot below the table
    #[arg(long)]
    plot: bool,
    /// Draws what a protocol file leaves open in each step: lost and late messages, skipped
    /// updates, modes [default: none is lost, late or skipped; the first mode]; with `--verify` the
    /// random primes [default: fresh ones, printed]
    #[arg(long, value_name = "SEED")]
    seed: Option<u64>,
    #[command(flatten)]
    at: AtArgs,
}

#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    /// Aligned columns
    Table,
    /// Comma-separated values
    Csv,
    /// JSON, schema cordon-trace/1
    Json,
    /// Informal Trace Format (Apalache, Quint)
    Itf,
}

/// Most decimal places: more than any use needs, few enough to print.
pub(in crate::cli) const MAX_DIGITS: usize = 10_000;

/// Prints the trace of a scenario.
pub(in crate::cli) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    if let Some(digits) = args.digits.filter(|digits| *digits > MAX_DIGITS) {
        return Err(Error::input(format!("digits: `{digits}`: expected at most {MAX_DIGITS}")));
    }
    if args.numbers.is_some() && matches!(args.format, Format::Json | Format::Itf) {
        return Err(Error::input(
            "numbers: expected together with the formats `table` and `csv` only",
        ));
    }
    let no_decimals = args.format == Format::Itf
        || (args.format == Format::Table && args.numbers == Some(Numbers::Fraction));
    if args.digits.is_some() && no_decimals {
        return Err(Error::input("digits: expected where decimals are written"));
    }
    if args.plot && args.format != Format::Table {
        return Err(Error::input("plot: expected together with the format `table` only"));
    }
    if args.check.is_some() && matches!(args.format, Format::Csv | Format::Itf) {
        return Err(Error::input(
            "check: expected together with the formats `table` and `json` only",
        ));
    }
    let scenario = args.seeded()?;
    if !args.at.at.is_empty() {
        return chosen_steps(args, &scenario, out);
    }
    let (unit, last) = match args.ticks {
        Some(ticks) => (Counted::Ticks, ticks),
        None => (Counted::Steps, args.steps.unwrap_or(scenario.steps)),
    };
    let selection =
        Selection { unit, from: args.from, to: args.to.unwrap_or(last), every: args.every };
    let rows = select(&scenario, selection)?;
    if args.plot && selection.len() < 2 {
        return Err(Error::input("plot: expected a selection of at least two rows"));
    }
    let form: Form = args.form.into();
    let mut foreign = Vec::new();
    let (_, last_step) = unit.tick_and_step(&scenario, selection.last());
    let claims = match (&args.check, scenario.own()) {
        (Some(list), Some(_)) => check_claims(&scenario, claims(list)?.as_deref(), last_step)?,
        _ => Vec::new(),
    };
    let checks = match &args.check {
        Some(_) if scenario.own().is_some() => Vec::new(),
        Some(list) => {
            let named = theorems::named(list)?;
            let named = match list.trim() {
                "all" => {
                    let (about, other) = applicable(&scenario, &named, form)?;
                    foreign = other;
                    about
                }
                _ => named,
            };
            check(&scenario, &named, form, last_step)?
        }
        None => Vec::new(),
    };
    let mut plotted = Vec::new();
    let keep = |row: &Row| {
        if args.plot {
            plotted.push(row.clone());
        }
    };
    let found = Checks { along: &checks, claims: &claims, verified: None };
    print(args, &scenario, &mut rows.inspect(keep), Some(selection), found, out)?;
    not_applicable(args, &foreign, out)?;
    if args.plot {
        show::plot(unit, &plotted, out)?;
    }
    let outcomes = checks.iter().map(Checked::outcome);
    let outcomes = outcomes.chain(claims.iter().map(CheckedClaim::outcome));
    Ok(outcomes.fold(Outcome::Holds, Outcome::worst))
}

/// The numbers of claims; `None` for all.
fn claims(list: &str) -> Result<Option<Vec<usize>>> {
    if list.trim() == "all" {
        return Ok(None);
    }
    let number = |text: &str| {
        text.trim().parse::<usize>().map_err(|_| {
            Error::input(format!("check: `{text}`: expected `all` or numbers of the file's claims"))
        })
    };
    list.split(',').map(number).collect::<Result<_>>().map(Some)
}

/// Reports the theorems that do not apply to this start: below the table, or on stderr.
fn not_applicable(
    args: &Args,
    theorems: &[(Theorem, &'static str)],
    out: &mut dyn Write,
) -> Result<()> {
    let form = Form::from(args.form).label();
    let mut stderr = std::io::stderr();
    let out = if args.format == Format::Table { out } else { &mut stderr };
    for (theorem, starts) in theorems {
        let number = theorem.number();
        writeln!(
            out,
            "{number} ({form} form) is not applicable: it is about starts with {starts}"
        )?;
    }
    Ok(())
}

impl Args {
    /// The scenario; the seed draws the choices that a protocol file leaves open.
    fn seeded(&self) -> Result<Scenario> {
        if self.seed.is_none() {
            return self.scenario.scenario();
        }
        // A seed that is used for random primes only does not affect the run.
        let drawn = self.scenario.drawn(self.seed);
        if self.at.verify.is_some() && !drawn.as_ref().is_ok_and(has_choices) {
            return self.scenario.scenario();
        }
        match drawn {
            Ok(scenario) if !has_choices(&scenario) => Err(Error::input(
                "seed: expected together with `--verify`, or with a protocol file that leaves choices",
            )),
            drawn => drawn,
        }
    }

    /// Number of decimal places.
    fn places(&self) -> usize {
        self.digits.unwrap_or(4)
    }
}

fn has_choices(scenario: &Scenario) -> bool {
    scenario.own().is_some_and(Own::has_choices)
}

/// The checks made on a trace.
#[derive(Clone, Copy)]
struct Checks<'c> {
    /// Theorems, along the run.
    along: &'c [Checked],
    /// Claims of a protocol file, along the run.
    claims: &'c [CheckedClaim],
    /// The comparison of positions with the plain spec.
    verified: Option<&'c Verification>,
}

/// Writes the trace in the requested format.
fn print(
    args: &Args,
    scenario: &Scenario,
    rows: &mut dyn Iterator<Item = Row>,
    selection: Option<Selection>,
    checks: Checks<'_>,
    out: &mut dyn Write,
) -> Result<()> {
    let (digits, numbers) = (args.places(), args.numbers);
    match args.format {
        Format::Table => {
            let numbers = numbers.unwrap_or(Numbers::Decimal);
            show::table(scenario, rows, checks, numbers, digits, selection, out)
        }
        Format::Csv => show::csv(scenario, rows, numbers.unwrap_or(Numbers::Both), digits, out),
        Format::Json => show::json(scenario, rows, checks, digits, out),
        Format::Itf => show::itf(scenario, rows, out),
    }
}

/// `--at`: the chosen steps only.
fn chosen_steps(args: &Args, scenario: &Scenario, out: &mut dyn Write) -> Result<Outcome> {
    if let Some((rows, verified)) = at::exact(scenario, &args.at, args.seed)? {
        let (rows, verified) = (&mut rows.into_iter(), verified.as_ref());
        print(args, scenario, rows, None, Checks { along: &[], claims: &[], verified }, out)?;
        let disagrees = verified.is_some_and(|v| v.disagreement.is_some());
        return Ok(if disagrees { Outcome::Refuted } else { Outcome::Holds });
    }
    let shape = match args.format {
        Format::Table => Shape::Table,
        Format::Csv => Shape::Csv,
        Format::Json => Shape::Json,
        Format::Itf => {
            return Err(Error::input("format: `itf`: expected together with exact engines only"));
        }
    };
    if matches!(args.numbers, Some(Numbers::Fraction | Numbers::Both)) {
        return Err(Error::input("numbers: fractions: expected together with exact engines only"));
    }
    at::certain(scenario, &args.at, args.places(), shape, out)
}
