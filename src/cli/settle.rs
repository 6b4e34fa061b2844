//! `cordon settle`.

use std::io::Write;
use std::path::PathBuf;

use num_traits::{One, Signed};
use serde_json::{Value, json};

use super::certificates;
use super::own_protocol;
use super::progress;
use super::scenario_args::positions;
use super::select::OutputFormat;
use cordon_core::exact::{self, decimal_string, fraction, in_short, shortened};
use cordon_core::linear::perron::Perron;
use cordon_core::{Error, Evidence, Outcome, Rational, Result};
use cordon_proof::certificate;
use cordon_proof::settle::{Contraction, DRONES, Observed, Proved, Settling, Starts, settling};
use cordon_proof::threshold::convergence::rounded_up_below_one;

/// Arguments of `cordon settle`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Number of drones, 3 to 10000
    #[arg(
        long,
        value_name = "N",
        required_unless_present = "protocol",
        conflicts_with = "protocol"
    )]
    drones: Option<usize>,
    /// Weight of the neighbours in the update, read exactly
    #[arg(
        long,
        value_name = "E",
        allow_hyphen_values = true,
        required_unless_present = "protocol",
        conflicts_with = "protocol"
    )]
    eps: Option<String>,
    #[command(flatten)]
    own: own_protocol::ProtocolArgs,
    /// Distance from the targets, in the unit of the positions
    #[arg(long, value_name = "D", allow_hyphen_values = true)]
    within: String,
    /// Start: positions separated by commas [default: every start within the segment [0, 1]]
    #[arg(long, value_name = "X,...", allow_hyphen_values = true)]
    start: Option<String>,
    /// Folder for the certificate of the contraction (or of the growth)
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
}

impl Args {
    /// The number of drones, which is present unless a protocol file is given.
    fn drones(&self) -> usize {
        self.drones.unwrap_or_default()
    }
}

/// Up to this number of drones the search takes a second or two.
const QUICK: usize = 5_000;

/// Finds the settling step.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    let within = exact::parse("within", &args.within)?;
    if let Some((_, system)) = args.own.system()? {
        let start = args.start.as_deref().map(positions).transpose()?;
        let (start, folder) = (start.as_deref(), args.out.as_deref());
        return own_protocol::settle(&args.own, &system, start, &within, folder, args.format, out);
    }
    let eps = exact::parse("eps", args.eps.as_deref().unwrap_or_default())?;
    let starts = match &args.start {
        None => Starts::AllWithin(args.drones()),
        Some(list) => {
            let start = positions(list)?;
            if start.len() != args.drones() {
                return Err(Error::input(format!(
                    "start: {} positions: expected {}, one a drone",
                    start.len(),
                    args.drones()
                )));
            }
            Starts::One(start)
        }
    };
    if args.drones() > QUICK && DRONES.contains(&args.drones()) && within.is_positive() {
        progress::announce(&format!("{} drones: this may take half a minute", args.drones()));
    }
    let found = settling(&starts, &eps, &within)?;
    let (name, certificate) = match &found {
        Settling::Settles { proved, .. } => {
            ("contraction", contraction(args.drones(), &eps, proved))
        }
        Settling::NotFromEveryStart(w) => {
            ("growth", Some(certificate::growth(args.drones(), &eps, &w.weights)))
        }
        Settling::Stays { .. } | Settling::NeverFromThisStart | Settling::Undecided => ("", None),
    };
    if let Some(certificate) = &certificate {
        certificate::judged(certificate)?;
    }
    let named = certificate.map(|c| (format!("{name}-{}", args.drones()), c));
    let files = certificates::written(args.out.as_deref(), named)?;
    match args.format {
        OutputFormat::Text => {
            let which = if args.start.is_some() { "this start" } else { "every start in [0, 1]" };
            writeln!(
                out,
                "settling: N = {}, eps = {}, within {} of the targets, from {which}",
                args.drones(),
                shortened(&fraction(&eps)),
                shortened(&fraction(&within))
            )?;
            text(args, &found, out)?;
            certificates::list("wrote   ", &files, out)?;
        }
        OutputFormat::Json => {
            let page = json!({
                "schema": "cordon-settle/1",
                "drones": args.drones(),
                "eps": fraction(&eps),
                "within": fraction(&within),
                "start": args.start.as_ref().map_or("every", |_| "given"),
                "result": as_json(&found),
                "file": files.first(),
            });
            writeln!(out, "{page:#}")?;
        }
    }
    Ok(match found {
        Settling::Settles { observed: Observed::Step(_), .. } | Settling::Stays { .. } => {
            Outcome::Holds
        }
        Settling::NeverFromThisStart => Outcome::Refuted,
        Settling::NotFromEveryStart(_) if args.start.is_none() => Outcome::Refuted,
        _ => Outcome::Inconclusive,
    })
}

/// The sharpest contraction as a certificate.
fn contraction(count: usize, eps: &Rational, proved: &[Proved]) -> Option<Value> {
    proved.iter().rev().find_map(|p| match &p.by {
        Contraction::OwnVector(w) => {
            let rate = rounded_up(&p.rate)?;
            Some(certificate::contraction(count, eps, &rate, &w.weights))
        }
        Contraction::EveryN => None,
    })
}

/// A short fraction at or above the rate and still below 1: six places if they suffice.
fn rounded_up(rate: &Rational) -> Option<Rational> {
    let million = Rational::from_integer(1_000_000.into());
    let short = (rate * &million).ceil() / million;
    if short < Rational::from_integer(1.into()) { Some(short) } else { rounded_up_below_one(rate) }
}

fn describe(by: &Contraction) -> (&'static str, &'static str) {
    match by {
        Contraction::EveryN => {
            ("every-n", "contraction for every N: w_i = i(N-1-i), c = 1 - 8 eps/(N-1)^2")
        }
        Contraction::OwnVector(_) => {
            ("own-vector", "contraction with a rational vector for this N")
        }
    }
}

fn text(args: &Args, found: &Settling, out: &mut dyn Write) -> Result<()> {
    match found {
        Settling::Settles { proved, not_before, observed } => {
            for p in proved {
                let c = rounded_up(&p.rate).unwrap_or_else(|| p.rate.clone());
                let (_, by) = describe(&p.by);
                // Where six places would round it up to 1.
                let million = Rational::from_integer(1_000_000.into());
                let shown = match (&c * &million).is_integer() {
                    true => decimal_string(&c, 6),
                    false => format!("1 - {}", in_short(&(Rational::one() - &c))),
                };
                writeln!(out, "  proved  step {:<8} {by}, c <= {shown}", p.step)?;
            }
            if *not_before > 0 {
                writeln!(out, "  not before {not_before:<5} the same vector from below")?;
            }
            match observed {
                Observed::Step(k) => {
                    let how = if args.start.is_some() {
                        "the run itself"
                    } else {
                        "complete for all these starts: the runs from the extreme ones"
                    };
                    writeln!(out, "  true    step {k:<8} {how}")?;
                }
                Observed::TooLong => {
                    writeln!(out, "  true    not determined: the run is too long to execute")?;
                }
            }
        }
        Settling::NotFromEveryStart(w) => {
            writeln!(
                out,
                "  never   some start does not settle: |A| w >= w for a positive vector w of {} integers",
                w.weights.len()
            )?;
            if args.start.is_some() {
                writeln!(out, "          whether this one does is not decided")?;
            }
        }
        Settling::Stays { step, .. } => {
            writeln!(
                out,
                "  true    step {step:<8} within the distance for ever, though not every start converges at this weight"
            )?;
        }
        Settling::NeverFromThisStart => {
            writeln!(
                out,
                "  never   the errors of this start do not fall below the distance for good"
            )?;
        }
        Settling::Undecided => {
            writeln!(out, "  not decided: the weight is too near 0 or the critical one")?;
        }
    }
    Ok(())
}

fn as_json(found: &Settling) -> Value {
    let vector = |w: &Perron| w.weights.iter().map(ToString::to_string).collect::<Vec<_>>();
    match found {
        Settling::Settles { proved, not_before, observed } => json!({
            "settles": true,
            "proved": proved.iter().map(|p| json!({
                "step": p.step,
                "evidence": Evidence::Certified,
                "contraction": describe(&p.by).0,
                "rate_at_most": rounded_up(&p.rate).as_ref().map(fraction),
            })).collect::<Vec<_>>(),
            "not_before": not_before,
            "true": match observed {
                Observed::Step(k) => json!({ "step": k, "evidence": "executed" }),
                Observed::TooLong => Value::Null,
            },
        }),
        Settling::NotFromEveryStart(w) => json!({
            "settles": false,
            "evidence": "growth",
            "vector": vector(w),
        }),
        Settling::Stays { step, converges } => json!({
            "settles": true,
            "converges": converges,
            "true": { "step": step, "evidence": "closed form of the errors" },
        }),
        Settling::NeverFromThisStart => json!({
            "settles": false,
            "evidence": "closed form of the errors",
        }),
        Settling::Undecided => Value::Null,
    }
}
