//! `cordon threshold --property separation`.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::response;
use crate::cli::certificates;
use crate::cli::select::OutputFormat;
use cordon_core::exact::{decimal_string, fraction, parse};
use cordon_core::{Error, Evidence, Outcome, Rational, Result};
use cordon_cosim::closed_loop::{ClosedLoop, Tuning};
use cordon_cosim::master::Algorithm;
use cordon_cosim::plant::Integrator;
use cordon_proof::threshold::separation::{Bracket, Side, bracket};
use num_traits::Signed;

/// The flags of a gain's threshold.
#[derive(clap::Args, Debug)]
pub struct LoopArgs {
    /// Gain lambda_A in 1/s, up to 1000 [default: 4]
    #[arg(long, value_name = "GAIN", help_heading = "Separation")]
    lambda_a: Option<String>,
    /// Communication step in seconds [default: 1/20]
    #[arg(long, value_name = "SECONDS", help_heading = "Separation")]
    tau: Option<String>,
    /// Plant integrator: euler or exact [default: euler]
    #[arg(long, value_name = "NAME", help_heading = "Separation")]
    integrator: Option<String>,
    /// Master: jacobi or gauss-seidel [default: jacobi]
    #[arg(long, value_name = "NAME", help_heading = "Separation")]
    master: Option<String>,
}

/// Default number of decimal places of the bracket, and the largest.
const DIGITS: usize = 2;
const MOST_DIGITS: usize = 4;

/// Decimal places of a sample.
const VALUE_PLACES: usize = 15;

impl LoopArgs {
    /// The first flag that is given.
    pub(in crate::cli) fn given(&self) -> Option<&'static str> {
        let flags = [
            ("lambda-a", &self.lambda_a),
            ("tau", &self.tau),
            ("integrator", &self.integrator),
            ("master", &self.master),
        ];
        flags.into_iter().find(|(_, value)| value.is_some()).map(|(name, _)| name)
    }

    fn tuning(&self) -> Result<Tuning> {
        let or =
            |given: &Option<String>, usual: &str| given.clone().unwrap_or_else(|| usual.to_owned());
        let (integrator, master) = (or(&self.integrator, "euler"), or(&self.master, "jacobi"));
        let positive = |what: &str, text: String| {
            let x = parse(what, &text)?;
            match x.is_positive() {
                true => Ok(x),
                false => Err(Error::input(format!("{what}: `{x}`: expected a positive number"))),
            }
        };
        let lambda_a = positive("lambda-a", or(&self.lambda_a, "4"))?;
        if lambda_a > Rational::from_integer(1000.into()) {
            return Err(Error::input(format!("lambda-a: `{lambda_a}`: expected at most 1000")));
        }
        let unknown = |what: &str, given: &str, known: &str| {
            Error::input(format!("{what}: `{given}`: expected {known}"))
        };
        Ok(Tuning {
            lambda_p: lambda_a.clone(),
            lambda_a,
            tau: positive("tau", or(&self.tau, "1/20"))?,
            integrator: Integrator::named(&integrator)
                .ok_or_else(|| unknown("integrator", &integrator, "`euler` or `exact`"))?,
            algorithm: Algorithm::named(&master)
                .ok_or_else(|| unknown("master", &master, "`jacobi` or `gauss-seidel`"))?,
        })
    }
}

/// Brackets the gain above which a response is negative.
pub(in crate::cli) fn run(
    flags: &LoopArgs,
    digits: Option<usize>,
    folder: Option<&Path>,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let digits = digits.unwrap_or(DIGITS);
    if !(1..=MOST_DIGITS).contains(&digits) {
        return Err(Error::input(format!(
            "digits: `{digits}`: expected a number from 1 to {MOST_DIGITS} for a gain"
        )));
    }
    let tuning = flags.tuning()?;
    let found = bracket(&tuning.lambda_a, digits, |gain| {
        let tuned = Tuning { lambda_p: gain.clone(), ..tuning.clone() };
        Ok(response(&ClosedLoop::of(&tuned)?, false))
    })?;
    let pages = [
        ("separation-below", found.below.as_ref().map(|side| &side.certificate)),
        ("separation-above", found.above.as_ref().map(|side| &side.certificate)),
    ];
    let pages = pages.into_iter().filter_map(|(name, page)| Some((name, page?)));
    let files = certificates::written(folder, pages)?;
    match format {
        OutputFormat::Text => text(&tuning, digits, &found, &files, out)?,
        OutputFormat::Json => writeln!(out, "{:#}", as_json(&tuning, digits, &found, &files))?,
    }
    let both = found.below.is_some() && found.above.is_some();
    Ok(if both { Outcome::Holds } else { Outcome::Inconclusive })
}

fn text(
    tuning: &Tuning,
    digits: usize,
    found: &Bracket,
    files: &[String],
    out: &mut dyn Write,
) -> Result<()> {
    writeln!(
        out,
        "separation in flight, lambda_A = {}, tau = {} s, {} plant, {} master: critical lambda_P",
        fraction(&tuning.lambda_a),
        fraction(&tuning.tau),
        tuning.integrator.name(),
        tuning.algorithm.name()
    )?;
    match &found.below {
        Some(Side { gain, found: cone, .. }) => writeln!(
            out,
            "  below  at lambda_P = {} no sample of the response is negative: a cone of {} rows, entered after {} steps",
            decimal_string(gain, digits),
            cone.rows.len(),
            cone.entered
        )?,
        None => {
            writeln!(out, "  below  no gain was found at which the response is never negative")?
        }
    }
    match &found.above {
        Some(Side { gain, found: sample, .. }) => writeln!(
            out,
            "  above  at lambda_P = {} sample h_{} of the response is negative: {}",
            decimal_string(gain, digits),
            sample.step + 1,
            decimal_string(&sample.value, VALUE_PLACES)
        )?,
        None => writeln!(out, "  above  no gain was found at which a sample is negative")?,
    }
    let number = [found.below.is_some(), found.above.is_some()].iter().filter(|x| **x).count();
    writeln!(out, "  checked: {}", certificates::accepted(number))?;
    certificates::list("wrote  ", files, out)
}

fn as_json(tuning: &Tuning, digits: usize, found: &Bracket, files: &[String]) -> Value {
    json!({
        "schema": "cordon-threshold/1",
        "property": "separation",
        "lambda_a": fraction(&tuning.lambda_a),
        "tau": fraction(&tuning.tau),
        "integrator": tuning.integrator.name(),
        "master": tuning.algorithm.name(),
        "digits": digits,
        "critical": null,
        "exact": false,
        "below": found.below.as_ref().map(|side| json!({
            "lambda_p": fraction(&side.gain),
            "evidence": Evidence::Certified,
            "rows": side.found.rows.len(),
            "entered": side.found.entered,
        })),
        "above": found.above.as_ref().map(|side| json!({
            "lambda_p": fraction(&side.gain),
            "evidence": Evidence::Certified,
            // The first sample, h_1, comes after the command's own step.
            "sample": side.found.step + 1,
            "value": decimal_string(&side.found.value, VALUE_PLACES),
        })),
        "files": files,
    })
}
