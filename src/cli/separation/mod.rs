//! `cordon separation`.

mod gaps;
mod show;
pub mod threshold;

use std::io::Write;
use std::path::PathBuf;

use num_traits::{Signed, Zero};
use serde_json::Value;

use self::gaps::{Gap, smallest};
use super::cosim::FlightArgs;
use super::scenario_args::ScenarioArgs;
use super::select::OutputFormat;
use crate::cli::certificates;
use cordon_core::{Error, Evidence, Outcome, Rational, Result, exact};
use cordon_cosim::closed_loop::{ClosedLoop, Tuning};
use cordon_cosim::coordination::Exchange;
use cordon_cosim::cosimulation::Cosimulation;
use cordon_cosim::plant::Integrator;
use cordon_proof::certificate;
use cordon_proof::separation::desired::{Update, smallest_gap};
use cordon_proof::separation::{
    Cone, Finding, Mass, Negative, Response, decide, masses, nonnegative,
};
use cordon_run::scenario::Protocol;

/// Arguments of `cordon separation`.
#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    scenario: ScenarioArgs,
    #[command(flatten)]
    flight: FlightArgs,
    /// Wind on every drone, independent and arbitrary in time: at most W m/s2 of acceleration
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    wind: Option<String>,
    /// Folder for the certificates
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
}

/// The results about the gaps of a scenario in flight.
struct Report<'s> {
    swarm: &'s Cosimulation,
    /// The smallest gap of the start, desired or actual, and the largest.
    smallest: Gap,
    largest: Rational,
    wind: Option<Wind>,
    flight: Flight,
    /// A lower bound for all gaps, positive or not; `None` where nothing is known.
    gap: Option<Rational>,
    evidence: Evidence,
    files: Vec<String>,
    certificates: usize,
}

/// The wind, and by how much it can reduce a gap, if that is known.
struct Wind {
    most: Rational,
    costs: Option<Rational>,
    /// Whether that is sharp: steady winds from both sides attain it.
    is_exact: bool,
}

/// The relation of actual gaps to desired ones.
enum Flight {
    /// Drones fly along convex combinations of desired positions.
    Convex(Cone),
    /// Drones fly along combinations with some negative weights.
    Partly(Negative, Box<Mass>),
    /// Neither is proved; with a negative sample if one was found.
    Unknown(Option<Negative>),
}

/// Certifies the smallest gap.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    args.flight
        .refuse(&["duration", "seed", "in-process", "step-limit"], "nothing is simulated")?;
    let (swarm, places) = args.flight.swarm_exchanging(&args.scenario, "exact")?;
    let wind = args.wind.as_deref().map(|w| exact::parse("wind", w)).transpose()?;
    if let Some(w) = wind.as_ref().filter(|w| w.is_negative()) {
        return Err(Error::input(format!("wind: `{w}`: expected 0 or more m/s2")));
    }
    expect_exact(&swarm)?;
    applies(&swarm).map_err(|e| places.point(e))?;
    let Judged { mut report, certificates: pages } = judged(&swarm, wind)?;
    report.files = certificates::written(args.out.as_deref(), pages)?;
    match args.format {
        OutputFormat::Text => show::text(&report, out)?,
        OutputFormat::Json => writeln!(out, "{:#}", show::json(&report))?,
    }
    Ok(match &report.gap {
        Some(gap) if gap.is_positive() => Outcome::Holds,
        _ => Outcome::Inconclusive,
    })
}

/// A lower bound for all gaps, if `cordon separation` finds it immediately: where the response is never
/// negative.
pub(super) fn known_gap(swarm: &Cosimulation) -> Option<Rational> {
    let one_by_one = swarm.order.is_some();
    if expect_exact(swarm).is_err()
        || applies(swarm).is_err()
        || !gaps::kept(swarm.count(), &swarm.scenario.weight, one_by_one)
    {
        return None;
    }
    let response = response(&ClosedLoop::of(&tuning(swarm)).ok()?, false);
    let Finding::NonNegative(_) = decide(&response) else { return None };
    let (smallest, _) = smallest(&swarm.scenario.start, &swarm.start);
    Some(smallest.size).filter(Signed::is_positive)
}

/// Refuses the rounded constants and positions of the recorded runs.
fn expect_exact(swarm: &Cosimulation) -> Result<()> {
    let expected = "expected none: what is certified has exact constants and positions";
    match (swarm.recorded, swarm.exchange) {
        (true, _) => Err(Error::input(format!("compat: `recorded`: {expected}"))),
        (false, Exchange::Exact) => Ok(()),
        (false, _) => Err(Error::input(format!("exchange: `double`: {expected}"))),
    }
}

/// Refuses scenarios outside the theory.
fn applies(swarm: &Cosimulation) -> Result<()> {
    let Protocol::Coverage { .. } = &swarm.scenario.protocol else {
        return Err(Error::input(format!(
            "protocol: `{}`: expected `coverage`: only there the smallest gap never falls",
            swarm.scenario.protocol.name()
        )));
    };
    if let Some(unit) = swarm.units.first() {
        return Err(Error::input(format!(
            "unit: `{}`: expected units of this program: drones that differ are not one linear system",
            unit.fmu.display()
        )));
    }
    expect_exact(swarm)?;
    if !swarm.faults.is_empty() {
        return Err(Error::input(
            "fault: expected none: where messages are lost or late the smallest gap may fall",
        ));
    }
    Ok(())
}

/// A report, with the certificates by name.
struct Judged<'s> {
    report: Report<'s>,
    certificates: Vec<(String, Value)>,
}

fn judged(swarm: &Cosimulation, wind: Option<Rational>) -> Result<Judged<'_>> {
    let found = ClosedLoop::of(&tuning(swarm))?;
    let response = response(&found, wind.is_some());
    let (smallest, largest) = smallest(&swarm.scenario.start, &swarm.start);
    let mut certificates = Vec::new();
    let update = if swarm.order.is_some() { Update::OneByOne } else { Update::AtOnce };
    let eps = &swarm.scenario.weight;
    let kept = gaps::kept(swarm.count(), eps, swarm.order.is_some());
    let mut evidence = Evidence::Certified;
    if kept {
        let page = smallest_gap(&swarm.scenario.start, eps, &smallest.size, update);
        push(&mut certificates, "desired", page, &mut evidence);
    }
    let found_of = decide(&response);
    let steady = matches!(found_of, Finding::NonNegative(_));
    let flight = match (found_of, &wind) {
        (Finding::NonNegative(cone), _) => {
            push(&mut certificates, "response", nonnegative(&response, &cone), &mut evidence);
            Flight::Convex(cone)
        }
        (other, None) => still_air(other, &response, &mut certificates, &mut evidence),
        (_, Some(_)) => {
            let plain = self::response(&found, false);
            still_air(decide(&plain), &plain, &mut certificates, &mut evidence)
        }
    };
    for (name, page) in std::mem::take(&mut certificates) {
        match certificate::judged(&page) {
            Ok(_) => certificates.push((name, page)),
            // Beyond the limits of the checker.
            Err(Error::Input(_)) => evidence = Evidence::Inductive,
            Err(e) => return Err(e),
        }
    }
    let two = Rational::from_integer(2.into());
    let wind = wind.map(|most| {
        // A steady wind of 1 m/s2 displaces a drone by as much as the trim state.
        let shift = match steady {
            true => found.trim.first().cloned(),
            false => carried(&found, swarm),
        };
        let costs = shift.map(|shift| &two * &most * shift);
        Wind { most, costs, is_exact: steady }
    });
    if wind.is_some() && !steady {
        evidence = Evidence::Inductive;
    }
    let costs = match &wind {
        None => Some(Rational::zero()),
        Some(wind) => wind.costs.clone(),
    };
    let gap = match &flight {
        _ if !kept => None,
        Flight::Convex(_) => costs.map(|costs| &smallest.size - costs),
        Flight::Partly(_, mass) => {
            costs.map(|costs| &smallest.size - &mass.negative * (&largest - &smallest.size) - costs)
        }
        Flight::Unknown(_) => None,
    };
    let count = certificates.len();
    let files = Vec::new();
    let report = Report {
        swarm,
        smallest,
        largest,
        wind,
        flight,
        gap,
        evidence,
        files,
        certificates: count,
    };
    Ok(Judged { report, certificates })
}

/// The result for a flight without wind, from the result for the response.
fn still_air(
    found: Finding,
    response: &Response,
    certificates: &mut Vec<(String, Value)>,
    evidence: &mut Evidence,
) -> Flight {
    let sample = match found {
        Finding::NonNegative(cone) => {
            push(certificates, "response", nonnegative(response, &cone), evidence);
            return Flight::Convex(cone);
        }
        Finding::Negative(sample) => sample,
        Finding::Undecided => return Flight::Unknown(None),
    };
    let Some(mass) = masses(response) else { return Flight::Unknown(Some(sample)) };
    push(certificates, "tail", nonnegative(&mass.bounded, &mass.cone), evidence);
    *evidence = Evidence::Inductive;
    Flight::Partly(sample, Box::new(mass))
}

/// The largest displacement of a drone by a varying wind of at most 1 m/s2: the sum of the magnitudes
/// of its response. `None` where no bound was found.
fn carried(found: &ClosedLoop, swarm: &Cosimulation) -> Option<Rational> {
    let tau = swarm.grid.tau();
    let of = |push: &Vec<Rational>| {
        let starts = vec![("push".to_owned(), push.clone())];
        Some(masses(&Response { starts, ..response(found, false) })?.absolute)
    };
    let sum = found.pushes.iter().map(of).sum::<Option<Rational>>()?;
    let mean = sum / Rational::from_integer(found.pushes.len().into());
    // Between grid points, add the effect of the wind within the step.
    let within = match swarm.integrator {
        Integrator::Euler => Rational::zero(),
        Integrator::Exact => tau * tau / Rational::from_integer(2.into()),
    };
    Some(mean * tau + within)
}

/// Adds a certificate. Without one, the result rests on the search alone, which decides exactly.
fn push(all: &mut Vec<(String, Value)>, name: &str, page: Option<Value>, evidence: &mut Evidence) {
    match page {
        Some(page) => all.push((name.to_owned(), page)),
        None => *evidence = Evidence::Inductive,
    }
}

fn tuning(swarm: &Cosimulation) -> Tuning {
    Tuning {
        lambda_p: swarm.lambda_p.clone(),
        lambda_a: swarm.lambda_a.clone(),
        tau: swarm.grid.tau().clone(),
        integrator: swarm.integrator,
        algorithm: swarm.algorithm,
    }
}

/// The forms that must never be negative for a drone to fly along convex combinations: its position at
/// and between grid points, in response to a command, to its start and, with wind, to pushes; and its
/// distance from where a steady wind displaces it.
fn response(found: &ClosedLoop, wind: bool) -> Response {
    let mut starts = vec![
        ("command".to_owned(), found.command.clone()),
        ("start".to_owned(), found.rest.clone()),
    ];
    if wind {
        let names = ["push", "earlyPush"].map(str::to_owned);
        starts.extend(names.into_iter().zip(found.pushes.iter().cloned()));
        starts.push(("steadyWind".to_owned(), found.trim.clone()));
    }
    Response {
        state: found.state.iter().map(|name| (*name).to_owned()).collect(),
        matrix: found.matrix.clone(),
        starts,
        readouts: found.places.clone(),
    }
}
