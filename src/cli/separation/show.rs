//! The certified gaps, in words and as JSON.

use std::io::Write;

use num_traits::Signed;
use serde_json::{Value, json};

use super::gaps::most_weight;
use super::{Flight, Report};
use crate::cli::certificates;
use cordon_core::exact::{decimal_string, fraction};
use cordon_core::{Rational, Result};
use cordon_cosim::plant::Integrator;

/// A lower bound in a few decimals.
fn short(x: &Rational) -> String {
    let exact = fraction(x);
    if exact.len() <= 12 {
        return exact;
    }
    let thousand = Rational::from_integer(1000.into());
    decimal_string(&((x * &thousand).floor() / thousand), 3)
}

/// An upper bound in a few decimals.
fn above(x: &Rational) -> String {
    let thousand = Rational::from_integer(1000.into());
    decimal_string(&((x * &thousand).ceil() / thousand), 3)
}

/// Decimal places of the negative mass, which is a multiple of that unit.
const PLACES: usize = 9;

pub(super) fn text(report: &Report<'_>, out: &mut dyn Write) -> Result<()> {
    let swarm = report.swarm;
    writeln!(out, "{}", swarm.scenario.title)?;
    match &report.gap {
        Some(gap) if gap.is_positive() => writeln!(
            out,
            "no two drones ever come closer than {} m ({})",
            short(gap),
            report.evidence
        )?,
        Some(gap) => writeln!(
            out,
            "not certified: no lower bound above 0 for the gaps (the bound obtained is {} m)",
            short(gap)
        )?,
        None => writeln!(out, "not certified: no bound of the gaps is known")?,
    }
    let gap = &report.smallest;
    writeln!(
        out,
        "  start    smallest gap {} m, of drones {} and {}",
        fraction(&gap.size),
        gap.after,
        gap.after + 1
    )?;
    let most = most_weight(swarm.count(), swarm.order.is_some());
    let eps = &swarm.scenario.weight;
    let (relation, what) = match *eps <= most && !eps.is_negative() {
        true => ("in", "no step lowers the smallest gap or raises the largest"),
        false => ("not in", "a step may lower the smallest gap"),
    };
    writeln!(out, "  desired  eps = {} is {relation} [0, {most}]: {what}", fraction(eps))?;
    writeln!(
        out,
        "  flight   lambda_P = {}, lambda_A = {}, tau = {} s; {} plant, {} master",
        fraction(&swarm.lambda_p),
        fraction(&swarm.lambda_a),
        fraction(swarm.grid.tau()),
        swarm.integrator.name(),
        swarm.algorithm.name()
    )?;
    flight(report, out)?;
    if let Some(wind) = &report.wind {
        let most = fraction(&wind.most);
        let what = match &wind.costs {
            Some(costs) if wind.is_exact => {
                format!("costs {} m of every gap, 2 W/lambda_P^2", fraction(costs))
            }
            Some(costs) => {
                format!(
                    "costs at most {} m of every gap, as its response sums up without signs",
                    above(costs)
                )
            }
            None => "its cost is not known".to_owned(),
        };
        writeln!(out, "  wind     at most {most} m/s2 on each drone: {what}")?;
    }
    if report.gap.is_some() {
        writeln!(
            out,
            "  rests on identical drones that start at rest, prompt messages, exact arithmetic"
        )?;
    }
    let number = report.certificates;
    if number > 0 {
        writeln!(out, "  checked  {}", certificates::accepted(number))?;
    }
    certificates::list("wrote    ", &report.files, out)
}

fn flight(report: &Report<'_>, out: &mut dyn Write) -> Result<()> {
    let between = match report.swarm.integrator {
        Integrator::Euler => "in between it is straight",
        Integrator::Exact => "nor is it in between",
    };
    match &report.flight {
        Flight::Convex(cone) => {
            writeln!(
                out,
                "           the response is never negative: each place is a mean of desired ones and the start"
            )?;
            writeln!(
                out,
                "           a cone of {} rows, kept by every step, entered after {}; {between}",
                cone.rows.len(),
                cone.entered
            )
        }
        Flight::Partly(sample, mass) => {
            writeln!(
                out,
                "           the response is negative, first after {} steps; in all by n <= {}",
                sample.step,
                decimal_string(&mass.negative, PLACES)
            )?;
            writeln!(
                out,
                "           n: {} samples executed, the rest is below {} in all (certified: below {} ({})^k)",
                mass.samples,
                decimal_string(&mass.tail, 6),
                decimal_string(&mass.scale, PLACES),
                fraction(&mass.rate)
            )?;
            writeln!(
                out,
                "           gaps stay above m - n (M - m), desired ones being in [m, M] = [{}, {}]",
                fraction(&report.smallest.size),
                fraction(&report.largest)
            )
        }
        Flight::Unknown(Some(sample)) => writeln!(
            out,
            "           the response is negative, first after {} steps, and no bound of that was found",
            sample.step
        ),
        Flight::Unknown(None) => writeln!(
            out,
            "           neither a cone nor a negative sample of the response was found"
        ),
    }?;
    Ok(())
}

pub(super) fn json(report: &Report<'_>) -> Value {
    let swarm = report.swarm;
    let certified = report.gap.as_ref().filter(|gap| gap.is_positive());
    let sample =
        |step: usize, value: &Rational| json!({ "step": step, "value": decimal_string(value, 15) });
    let response = match &report.flight {
        Flight::Convex(cone) => json!({
            "nonnegative": true,
            "rows": cone.rows.len(),
            "entered": cone.entered,
        }),
        Flight::Partly(found, mass) => json!({
            "nonnegative": false,
            "sample": sample(found.step, &found.value),
            "negative_mass": fraction(&mass.negative),
            "samples": mass.samples,
        }),
        Flight::Unknown(Some(found)) => json!({
            "nonnegative": false,
            "sample": sample(found.step, &found.value),
        }),
        Flight::Unknown(None) => json!({ "nonnegative": null }),
    };
    json!({
        "schema": "cordon-separation/1",
        "title": swarm.scenario.title,
        "drones": swarm.count(),
        "eps": fraction(&swarm.scenario.weight),
        "gap": report.gap.as_ref().map(fraction),
        "holds": certified.is_some(),
        "evidence": certified.map(|_| report.evidence.text()),
        "start": {
            "smallest": fraction(&report.smallest.size),
            "drone": report.smallest.after,
            "largest": fraction(&report.largest),
        },
        "flight": {
            "lambda_p": fraction(&swarm.lambda_p),
            "lambda_a": fraction(&swarm.lambda_a),
            "tau": fraction(swarm.grid.tau()),
            "integrator": swarm.integrator.name(),
            "master": swarm.algorithm.name(),
        },
        "response": response,
        "wind": report.wind.as_ref().map(|w| json!({ "most": fraction(&w.most), "costs": w.costs.as_ref().map(fraction) })),
        "files": report.files,
    })
}
