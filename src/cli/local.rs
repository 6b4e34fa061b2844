//! `cordon local`.

use std::io::Write;
use std::num::NonZeroU32;

use cordon_spec::local::TickRatio;
use num_traits::ToPrimitive;
use serde_json::json;

use super::scenario_args::ScenarioArgs;
use super::select::OutputFormat;
use super::table;
use super::trace::MAX_DIGITS;
use cordon_core::exact;
use cordon_core::{Error, Evidence, Outcome, Result};
use cordon_run::projection::{self, Pair, Setup};
use cordon_run::scenario::{Own, Scenario};

/// Arguments of `cordon local`.
#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    scenario: ScenarioArgs,
    /// Ticks to run, up to 100000 [default: up to the scenario's last protocol step]
    #[arg(long, value_name = "K")]
    ticks: Option<u64>,
    /// Ticks between exchanges of positions; the theorem requires 1
    #[arg(long, value_name = "TICKS", default_value_t = 1)]
    exchange_every: u64,
    /// Quotient eps/stepsize that the local machines count against, e.g. 7/2 [default: period - 1]
    #[arg(long, value_name = "P/Q", allow_hyphen_values = true)]
    ratio: Option<String>,
    /// Draws what a protocol file leaves open in each step: lost and late messages, skipped updates,
    /// modes [default: none is lost, late or skipped; the first mode]
    #[arg(long, value_name = "SEED")]
    seed: Option<u64>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
    /// Decimal places, rounded half to even, up to 10000 [default: 4]
    #[arg(long, value_name = "D")]
    digits: Option<usize>,
}

/// Most ticks: every tick is a row.
const MAX_TICKS: u64 = 100_000;

/// Runs the local machines and the global protocol side by side, and compares them.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    if args.digits.is_some() && args.format == OutputFormat::Json {
        return Err(Error::input("digits: expected together with the format `text` only"));
    }
    let digits = args.digits.unwrap_or(4);
    if digits > MAX_DIGITS {
        return Err(Error::input(format!("digits: `{digits}`: expected at most {MAX_DIGITS}")));
    }
    let scenario = args.scenario.drawn(args.seed)?;
    if args.seed.is_some() && !scenario.own().is_some_and(Own::has_choices) {
        return Err(Error::input(
            "seed: expected together with a protocol file that leaves choices",
        ));
    }
    let last = scenario.tick_of_step(scenario.steps).unwrap_or(0);
    let setup = Setup {
        ticks: args.ticks.unwrap_or(last),
        exchange_every: args.exchange_every,
        ratio: args.ratio.as_deref().map(ratio).transpose()?,
    };
    if setup.ticks > MAX_TICKS {
        return Err(Error::input(format!(
            "ticks: `{}`: expected at most {MAX_TICKS}",
            setup.ticks
        )));
    }
    let pairs = projection::run(&scenario, setup)?;
    let different = pairs.iter().find_map(|p| p.difference().map(|i| (p, i)));
    match args.format {
        OutputFormat::Text => {
            text(&scenario, &pairs, digits, out)?;
            writeln!(out, "\n{}", verdict(&scenario, &pairs, different))?;
        }
        OutputFormat::Json => {
            let difference = different.map(|(p, i)| {
                json!({
                    "tick": p.tick,
                    "drone": i * scenario.count() / p.local.len().max(1),
                    "local": p.local.get(i).map(exact::fraction),
                    "global": p.global.get(i).map(exact::fraction),
                })
            });
            let page = json!({
                "schema": "cordon-local/1",
                "drones": scenario.count(),
                "ticks": setup.ticks,
                "evidence": Evidence::ThisRunOnly,
                "equal": different.is_none(),
                "first_difference": difference,
            });
            writeln!(out, "{page:#}")?;
        }
    }
    Ok(if different.is_some() { Outcome::Refuted } else { Outcome::Holds })
}

fn ratio(text: &str) -> Result<TickRatio> {
    let quotient = exact::parse("ratio", text)?;
    let num = quotient.numer().to_u32();
    let den = quotient.denom().to_u32().and_then(NonZeroU32::new);
    match num.zip(den) {
        Some((num, den)) => Ok(TickRatio { num, den }),
        None => Err(Error::input(format!(
            "ratio: `{text}`: expected a quotient of numbers from 0 to {}",
            u32::MAX
        ))),
    }
}

fn text(scenario: &Scenario, pairs: &[Pair], digits: usize, out: &mut dyn Write) -> Result<()> {
    let columns = scenario.columns();
    let mut head = vec!["tick".to_owned()];
    head.extend(columns.iter().cloned());
    head.push("global".to_owned());
    let lines = pairs.iter().map(|p| {
        let mut cells = vec![p.tick.to_string()];
        cells.extend(p.local.iter().map(|x| exact::decimal_string(x, digits)));
        cells.push(p.difference().map_or("equal".to_owned(), |i| {
            format!("differs at {}", columns.get(i).map_or("?", String::as_str))
        }));
        cells
    });
    table::stream(&head, None, lines, out)
}

fn verdict(scenario: &Scenario, pairs: &[Pair], different: Option<(&Pair, usize)>) -> String {
    let machines = scenario.count();
    match different.and_then(|(p, i)| Some((p.tick, i, p.local.get(i)?, p.global.get(i)?))) {
        Some((tick, i, local, global)) => {
            let drone = i * machines / scenario.start.len().max(1);
            format!(
                "first difference at tick {tick}, drone {drone}: local {local}, global {global}"
            )
        }
        None => {
            let ticks = pairs.len().saturating_sub(1);
            format!(
                "{machines} local machines compute the global kth_step exactly, at the start and \
                 after each of {ticks} ticks ({})",
                Evidence::ThisRunOnly
            )
        }
    }
}
