//! `cordon swarm`.

use std::io::Write;

use serde_json::json;

use super::select::OutputFormat;
use cordon_core::{Error, Outcome, Rational, Result, exact};
use cordon_run::swarm::Swarm;

/// Arguments of `cordon swarm`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Number of drones, 3 to 100000000
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    drones: usize,
    /// Protocol steps; drones times steps up to 10^12
    #[arg(long, value_name = "K", default_value_t = 1000)]
    steps: u64,
    /// Weight of the neighbours in the update: a fraction or a decimal, read exactly
    #[arg(long, value_name = "E", default_value = "1/5", allow_hyphen_values = true)]
    eps: String,
    /// Left end of the segment
    #[arg(long, value_name = "X", default_value = "0", allow_hyphen_values = true)]
    min: String,
    /// Right end of the segment
    #[arg(long, value_name = "X", default_value = "100", allow_hyphen_values = true)]
    max: String,
    /// Start: drone i at min + i*(TO - min)/(N-1), the last drone at max
    #[arg(long, value_name = "TO", default_value = "40", allow_hyphen_values = true)]
    spread_to: String,
    /// Drones whose positions are printed [default: five along the line]
    #[arg(long, value_name = "I,...", value_delimiter = ',')]
    show: Vec<usize>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
}

/// Most drone updates of one run: some ten minutes.
const MAX_UPDATES: u64 = 1_000_000_000_000;

/// Runs a large swarm in doubles and bounds its distance from the exact run.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let updates = (args.drones as u64).saturating_mul(args.steps);
    if updates > MAX_UPDATES {
        return Err(Error::input(format!(
            "steps: `{}`: expected at most {MAX_UPDATES} drone updates, {} drones make more",
            args.steps, args.drones
        )));
    }
    let number = |what: &str, text: &str| exact::parse(what, text);
    let eps = number("eps", &args.eps)?;
    let ends: [Rational; 3] = [
        number("min", &args.min)?,
        number("max", &args.max)?,
        number("spread-to", &args.spread_to)?,
    ];
    let [min, max, to] = &ends;
    if min >= max {
        return Err(Error::input(format!(
            "max: `{max}`: expected more than min, which is `{min}`"
        )));
    }
    let mut swarm = Swarm::spread(&eps, args.drones, [min, max, to])?;
    let shown = drones_shown(args)?;
    swarm.advance(args.steps);
    match args.format {
        OutputFormat::Text => text(&swarm, &eps, &shown, out)?,
        OutputFormat::Json => as_json(&swarm, &eps, &shown, out)?,
    }
    // Without a finite bound the doubles imply nothing about the exact run.
    Ok(if swarm.error().is_finite() { Outcome::Holds } else { Outcome::Inconclusive })
}

fn drones_shown(args: &Args) -> Result<Vec<usize>> {
    let last = args.drones - 1;
    if args.show.is_empty() {
        let mut shown: Vec<usize> =
            (0..=4).map(|quarter| last / 4 * quarter + last % 4 * quarter / 4).collect();
        shown.dedup();
        return Ok(shown);
    }
    match args.show.iter().find(|&&i| i > last) {
        Some(i) => Err(Error::input(format!("show: `{i}`: expected a drone from 0 to {last}"))),
        None => Ok(args.show.clone()),
    }
}

/// Whether the exact run is in order after the last step, as far as the doubles can tell.
fn order(swarm: &Swarm) -> &'static str {
    let (gap, margin) = swarm.smallest_gap();
    if gap > margin {
        "all drones are in order, in the exact run too"
    } else if gap < -margin {
        "some drones have crossed, in the exact run too"
    } else {
        "whether all drones are in order is closer than the error bound"
    }
}

fn text(swarm: &Swarm, eps: &Rational, shown: &[usize], out: &mut dyn Write) -> Result<()> {
    let positions = swarm.positions();
    writeln!(out, "{} drones, eps = {eps}, step {}, in doubles", positions.len(), swarm.steps())?;
    if !swarm.error().is_finite() {
        writeln!(out, "the doubles may have overflowed: nothing is known of the exact run")?;
        return Ok(());
    }
    let error = swarm.error();
    writeln!(out, "error bound {error:.2e}: every position is as close to the exact run\n")?;
    for &i in shown {
        if let Some(x) = positions.get(i) {
            writeln!(out, "  x{i:<12} {x}")?;
        }
    }
    let (gap, margin) = swarm.smallest_gap();
    let (deviation, around) = swarm.largest_deviation();
    writeln!(out, "\nsmallest gap            {gap:.6e}, within {margin:.2e}")?;
    writeln!(out, "largest deviation       {deviation:.6e}, within {around:.2e}")?;
    writeln!(out, "{}", order(swarm))?;
    Ok(())
}

fn as_json(swarm: &Swarm, eps: &Rational, shown: &[usize], out: &mut dyn Write) -> Result<()> {
    let positions: Vec<_> = shown
        .iter()
        .filter_map(|&i| Some(json!({ "drone": i, "position": swarm.positions().get(i)? })))
        .collect();
    let (gap, gap_within) = swarm.smallest_gap();
    let (deviation, deviation_within) = swarm.largest_deviation();
    let page = json!({
        "schema": "cordon-swarm/1",
        "evidence": "doubles, error bound proved by forward error analysis",
        "drones": swarm.positions().len(),
        "weight": eps.to_string(),
        "step": swarm.steps(),
        "error_bound": swarm.error(),
        "positions": positions,
        "smallest_gap": { "value": gap, "within": gap_within },
        "largest_deviation": { "value": deviation, "within": deviation_within },
        "order": order(swarm),
    });
    writeln!(out, "{page:#}")?;
    Ok(())
}
