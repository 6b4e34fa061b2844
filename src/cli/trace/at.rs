//! `cordon trace --at`: chosen steps, without the steps in between.

use std::io::Write;

use serde_json::json;

use super::show;
use crate::cli::table;
use cordon_core::{Error, Outcome, Result};
use cordon_run::fast::verify::{self, Verification};
use cordon_run::fast::{Answer, Engine, Motion, Rule, digits, engine};
use cordon_run::scenario::Scenario;
use cordon_run::trace::{Row, shown};

/// The flags of `cordon trace` that jump to chosen steps.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct AtArgs {
    /// Only these protocol steps, in this order, without the steps in between (coverage, consensus
    /// on the path, and protocol files)
    #[arg(
        long,
        value_name = "K,...",
        value_delimiter = ',',
        conflicts_with_all = ["steps", "ticks", "from", "to", "every", "check", "plot"],
        help_heading = "Chosen steps"
    )]
    pub at: Vec<u64>,
    /// How chosen steps are computed
    #[arg(long, value_enum, default_value_t, help_heading = "Chosen steps")]
    pub engine: Method,
    /// Compare with the plain spec modulo random primes, as many as given, 1 to 64 [default: 3]
    #[arg(
        long,
        value_name = "PRIMES",
        num_args = 0..=1,
        default_missing_value = "3",
        value_parser = clap::value_parser!(u8).range(1..=64),
        help_heading = "Chosen steps"
    )]
    pub verify: Option<u8>,
}

/// The engines that a user can choose.
#[derive(clap::ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Exact: no steps between, except where making them is expected to be faster
    #[default]
    #[value(alias = "auto")]
    Jump,
    /// Exact: every step
    Step,
    /// Decimals of which every digit is certain, for any number of steps
    Digits,
}

impl Method {
    /// The exact engine; `None` for `Digits`.
    fn exact(self) -> Option<Engine> {
        match self {
            Self::Jump => Some(Engine::Jump),
            Self::Step => Some(Engine::Step),
            Self::Digits => None,
        }
    }
}

/// The evidence for certain digits.
const EVIDENCE: &str = "enclosed in fixed point, every digit certain";

/// Output formats of certain digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Aligned columns.
    Table,
    /// Comma-separated values.
    Csv,
    /// JSON, schema `cordon-digits/1`.
    Json,
}

/// Rows, and the check against the spec if requested.
pub type Exact = (Vec<Row>, Option<Verification>);

/// The exact rows of the chosen steps; `None` where only digits are requested.
pub fn exact(scenario: &Scenario, args: &AtArgs, seed: Option<u64>) -> Result<Option<Exact>> {
    let Some(chosen) = args.engine.exact() else { return Ok(None) };
    let last = args.at.iter().copied().max().unwrap_or(0);
    let answers = Motion::of(scenario, last)?.positions(&args.at, chosen)?;
    let check = |primes| cross_check(scenario, &answers, primes, seed);
    let verified = args.verify.map(check).transpose()?;
    let rows = answers.into_iter().map(|answer| row(scenario, answer)).collect::<Result<_>>()?;
    Ok(Some((rows, verified)))
}

fn row(scenario: &Scenario, answer: Answer) -> Result<Row> {
    let (tick, timesteps) = tick_of(scenario, answer.k)?;
    Ok(Row { tick, step: answer.k, timesteps, positions: shown(scenario, answer) })
}

/// The tick of a step, and the tick counter after it.
fn tick_of(scenario: &Scenario, k: u64) -> Result<(u64, u32)> {
    match k {
        0 => Ok((0, scenario.initial().timesteps)),
        k => match scenario.tick_of_step(k) {
            Some(tick) => Ok((tick, 0)),
            None => Err(Error::input(format!(
                "at: `{k}`: expected a step whose tick, {} times as late, fits 64 bits",
                scenario.period
            ))),
        },
    }
}

/// Compares with the spec and reports the result on stderr.
fn cross_check(
    scenario: &Scenario,
    answers: &[Answer],
    primes: u8,
    seed: Option<u64>,
) -> Result<Verification> {
    let seed = seed.unwrap_or_else(verify::fresh_seed);
    let found = verify::verify(
        &Rule::of(scenario)?,
        &scenario.whole_start(),
        answers,
        primes.into(),
        seed,
    )?;
    eprint!("{}", report(&found));
    Ok(found)
}

fn report(found: &Verification) -> String {
    let primes: Vec<_> = found.primes.iter().map(u64::to_string).collect();
    let drawn = format!("modulo {}, drawn from --seed {}", primes.join(", "), found.seed);
    match found.disagreement {
        None => format!(
            "verified: all {} residues are those of the plain spec {drawn}\n\
             chance that a wrong answer passes: at most 2^{:.0}\n",
            found.compared,
            found.log2_chance.ceil()
        ),
        Some(d) => format!(
            "NOT verified: step {} of drone {} differs from the plain spec {drawn}: a fault of \
             this program, please report it\n",
            d.k, d.drone
        ),
    }
}

/// Writes the chosen steps with the requested number of certain digits.
pub fn certain(
    scenario: &Scenario,
    args: &AtArgs,
    places: usize,
    shape: Shape,
    out: &mut dyn Write,
) -> Result<Outcome> {
    if args.verify.is_some() {
        return Err(Error::input(
            "verify: expected together with the exact engines only: digits are enclosed, not \
             checked",
        ));
    }
    let line = Motion::of(scenario, 0)?.into_line("engine: `digits`")?;
    let found = digits::at(&line, &args.at, places, engine::multiplier())?;
    let decimals = |d: &digits::Digits| -> Vec<String> {
        d.positions.iter().map(|p| p.decimal.clone()).collect()
    };
    match shape {
        Shape::Json => {
            let rows: Vec<_> = found
                .iter()
                .map(|d| json!({ "step": d.k, "certain_places": d.certain(), "decimals": decimals(d) }))
                .collect();
            let page = json!({
                "schema": "cordon-digits/1",
                "evidence": EVIDENCE,
                "places": places,
                "rows": rows,
            });
            writeln!(out, "{page:#}")?;
        }
        Shape::Csv => {
            let head: Vec<_> = scenario.columns().iter().map(|x| format!("{x}_decimal")).collect();
            writeln!(out, "step,{}", head.join(","))?;
            for d in &found {
                writeln!(out, "{},{}", d.k, decimals(d).join(","))?;
            }
        }
        Shape::Table => {
            show::heading(scenario, out)?;
            let mut head = vec![String::from("step")];
            head.extend(scenario.columns());
            let line = |d: &digits::Digits| [vec![d.k.to_string()], decimals(d)].concat();
            table::stream(&head, None, found.iter().map(line), out)?;
            writeln!(out, "\n({EVIDENCE})")?;
        }
    }
    let short = found.iter().any(|d| d.certain() < places);
    if short {
        eprintln!(
            "some positions have fewer certain places than {places}: those shown are certain"
        );
    }
    Ok(if short { Outcome::Inconclusive } else { Outcome::Holds })
}
