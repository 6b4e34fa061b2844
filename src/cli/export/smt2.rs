//! `cordon export smt2`.

use std::io::Write;
use std::path::PathBuf;

use cordon_spec::theorems::Form;

use super::super::own_protocol::ProtocolArgs;
use super::super::select::FormArg;

use cordon_core::files::{self, Limit};
use cordon_core::system::System;
use cordon_core::{Error, Outcome, Result, progress, range};
use cordon_proof::export::conjecture::Conjecture;
use cordon_proof::export::smt_model::{Model, Replay, Response, read_answer, replay};
use cordon_proof::export::smt2::{
    MAX_DRONES, MIN_DRONES, Obligation, Query, WeightDomain, has_beyond, obligations,
};
use cordon_proof::export::system;

/// Arguments of `cordon export smt2`.
#[derive(clap::Args, Debug)]
#[command(
    after_help = "A solver that answers `unsat` to every query proves the theorem for that number of \
drones and all steps. With `--negate` it looks for a counterexample to the theorem beyond its range of \
weights: `cordon export smt2 7.2 --drones 4 --negate | z3 -in`."
)]
pub struct Args {
    /// Which claims: numbers like 7.2 or 7.4ii, `mirror`, `box`, separated by commas [default: all]
    #[arg(value_name = "THEOREMS")]
    pub claims: Option<String>,
    #[command(flatten)]
    pub own: ProtocolArgs,
    /// Number of drones, or an inclusive range like 3..6, from 3 to 9
    #[arg(long, value_name = "N", default_value = "3..6", conflicts_with = "protocol")]
    pub drones: String,
    /// Which reading of the theorems
    #[arg(long, value_enum, default_value_t = FormArg::Sharp, conflicts_with = "protocol")]
    pub form: FormArg,
    /// Weights instead of the theorem's: a range like `0..1/2` or `(1/2,1]`
    #[arg(long, value_name = "LO..HI", allow_hyphen_values = true)]
    pub eps_range: Option<String>,
    /// Ask for a counterexample to the theorem: beyond its weights (within 0 <= eps <= 1), or in --eps-range
    #[arg(long)]
    pub negate: bool,
    /// With --negate: look at steps up to K, at most 8
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = clap::value_parser!(u8).range(0..=8))]
    pub steps: u8,
    /// With --negate and one claim and N: read a solver's answer (`-`: stdin) and replay its model exactly
    #[arg(long, value_name = "FILE", conflicts_with = "out")]
    pub answer: Option<PathBuf>,
    /// Write to a file [default: stdout]
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Exports, or replays an answer.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    if let Some((_, system)) = args.own.system()? {
        let text = own(args, &system)?;
        return write(args, &text, out);
    }
    let queries = queries(args)?;
    if let Some(path) = &args.answer {
        return answer(&queries, path, out);
    }
    write(args, &script(&queries), out)
}

/// The claims of a protocol file.
fn own(args: &Args, system: &System) -> Result<String> {
    let foreign = [
        ("theorems", args.claims.is_some()),
        ("--eps-range", args.eps_range.is_some()),
        ("--answer", args.answer.is_some()),
    ];
    if let Some((flag, _)) = foreign.iter().find(|(_, given)| *given) {
        return Err(Error::input(format!("{flag}: expected none together with --protocol")));
    }
    match args.negate {
        true => Ok(system::search(system, args.steps.into())),
        false => system::induction(system),
    }
}

fn write(args: &Args, text: &str, out: &mut dyn Write) -> Result<Outcome> {
    match &args.out {
        Some(path) => files::write_atomically(path, text.as_bytes())?,
        None => out.write_all(text.as_bytes())?,
    }
    Ok(Outcome::Holds)
}

/// All queries in one script; `(reset)` makes each independent of those before.
fn script(queries: &[Query]) -> String {
    let mut text = String::new();
    progress::expect(queries.len() as u64);
    for (n, query) in queries.iter().enumerate() {
        if n > 0 {
            text.push_str("(reset)\n\n");
        }
        text.push_str(&query.text());
        progress::advance(1);
    }
    text
}

fn queries(args: &Args) -> Result<Vec<Query>> {
    let claims = Conjecture::named(args.claims.as_deref().unwrap_or("all"))?;
    let drones = range::whole("drones", &args.drones, MIN_DRONES..=MAX_DRONES)?;
    let interval =
        args.eps_range.as_deref().map(|t| range::interval("eps-range", t)).transpose()?;
    let form = Form::from(args.form);
    let mut queries = Vec::new();
    for claim in claims {
        for n in drones.clone() {
            if !args.negate {
                let weights =
                    interval.clone().map_or(WeightDomain::OfHypothesis, WeightDomain::Interval);
                queries.extend(obligations(claim, form, n, &weights));
                continue;
            }
            let weights = match &interval {
                Some(interval) => WeightDomain::Interval(interval.clone()),
                None if has_beyond(claim, n) => WeightDomain::Beyond,
                None if args.claims.is_none() || args.claims.as_deref() == Some("all") => continue,
                None => {
                    return Err(Error::input(format!(
                        "--negate: {claim} with {n} drones holds for all 0 <= eps <= 1: \
                         expected --eps-range with the weights to look at"
                    )));
                }
            };
            let obligation = Obligation::Violated { steps: args.steps.into() };
            queries.push(Query { claim, form, drones: n, obligation, weights });
        }
    }
    Ok(queries)
}

fn answer(queries: &[Query], path: &std::path::Path, out: &mut dyn Write) -> Result<Outcome> {
    let [query] = queries else {
        return Err(Error::input(
            "--answer: expected one claim and one number of drones, like `7.2 --drones 4`",
        ));
    };
    let text = files::read_text(path, Limit::ANSWER)?;
    match read_answer(query, &text)? {
        Response::Unsat => {
            writeln!(out, "unsat: the solver finds no counterexample")?;
            Ok(Outcome::Holds)
        }
        Response::Unknown(word) => {
            writeln!(out, "{word}: the solver gave up")?;
            Ok(Outcome::Inconclusive)
        }
        Response::Sat(None) => Err(Error::input(
            "solver's model: expected values after `sat` (the answer to `get-value`)",
        )),
        Response::Sat(Some(model)) => report(query, &model, out),
    }
}

fn report(query: &Query, model: &Model, out: &mut dyn Write) -> Result<Outcome> {
    let start: Vec<_> = model.start.iter().map(ToString::to_string).collect();
    let (p, start) = (&model.params, start.join(","));
    match replay(query, model) {
        Replay::Violates { step, what } => {
            let (claim, form) = (query.claim, query.form.label());
            writeln!(out, "refuted: {claim} ({form} form) fails {what} (by exact replay)")?;
            let steps = step + query.claim.span(query.form, query.drones);
            writeln!(
                out,
                "replay: cordon trace --min={} --max={} --eps={} --start={start} --steps={steps}{}",
                p.min,
                p.max,
                p.eps,
                check_flags(query)
            )?;
            Ok(Outcome::Refuted)
        }
        Replay::DoesNot(why) => {
            writeln!(out, "the solver's model is not a counterexample: {why}")?;
            Ok(Outcome::Inconclusive)
        }
    }
}

/// The flags with which `cordon trace` checks the claim, where it is a theorem.
fn check_flags(query: &Query) -> String {
    match query.claim {
        Conjecture::Theorem(_) => format!(" --check={} --form={}", query.claim, query.form.label()),
        Conjecture::Mirror | Conjecture::Box => String::new(),
    }
}
