//! `cordon refute`.

use std::io::Write;
use std::path::PathBuf;

use cordon_spec::theorems::{Form, Theorem};
use num_traits::{One, Zero};
use serde_json::{Value, json};

use super::own_protocol;
use super::scenario_args::positions;
use super::select::{FormArg, OutputFormat};
use super::table::{self, abridged};
use cordon_core::exact::fraction;
use cordon_core::linear::simplest::fractions_within;
use cordon_core::system::{Parameter, ParameterKind};
use cordon_core::theorems;
use cordon_core::{Error, Outcome, Rational, Result, progress, range};
use cordon_proof::certificate::{self, Departure};
use cordon_proof::counterexample::Counterexample;
use cordon_proof::refute::departing::Departures;
use cordon_proof::refute::{Coverage, Extent, SearchResult, SearchSpace, departing, search};

/// Arguments of `cordon refute`.
#[derive(clap::Args, Debug)]
#[command(
    override_usage = "cordon refute [OPTIONS] <THEOREM>\n       cordon refute [OPTIONS] --protocol <FILE>"
)]
pub struct Args {
    /// Which theorems: numbers like 7.2 or 7.4ii, separated by commas, or `all`
    #[arg(
        value_name = "THEOREM",
        required_unless_present = "protocol",
        conflicts_with = "protocol"
    )]
    theorem: Option<String>,
    #[command(flatten)]
    own: own_protocol::ProtocolArgs,
    /// With --protocol: only the run from this start
    #[arg(long, value_name = "X,...", allow_hyphen_values = true)]
    start: Option<String>,
    /// Form of the theorem: its start set, and its weights where --eps is not given
    #[arg(long, value_enum, default_value_t = FormArg::Sharp, conflicts_with = "protocol")]
    form: FormArg,
    /// Number of drones, or a range, from 3 to 50
    #[arg(long, value_name = "N|LO..HI", default_value = "3..6", conflicts_with = "protocol")]
    drones: String,
    /// Weight or range of weights, regardless of the theorem's own range [default: the theorem's]
    #[arg(long, value_name = "E|LO..HI", allow_hyphen_values = true, conflicts_with = "protocol")]
    eps: Option<String>,
    /// In a range of weights, search the fractions with denominators up to Q, 1 to 100 [default: 8]
    #[arg(long, value_name = "Q")]
    denominators: Option<u32>,
    /// Last step, 0 to 1000
    #[arg(long, value_name = "K", default_value_t = 8)]
    steps: usize,
    /// In every step any subset of the drones may skip its update
    #[arg(long, conflicts_with = "delay", conflicts_with = "protocol")]
    activation: bool,
    /// Each drone may see each neighbour up to this many steps late
    #[arg(long, value_name = "D", conflicts_with = "protocol")]
    delay: Option<usize>,
    /// File for the counterexample as a certificate
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    format: OutputFormat,
}

/// Whether a constant has more than one value.
fn has_range(p: &Parameter) -> bool {
    p.kind == ParameterKind::Constant && p.fixed().is_none()
}

const MOST_DRONES: usize = 50;
const MOST_STEPS: usize = 1_000;
const MOST_DENOMINATORS: u32 = 100;

/// Searches for the smallest counterexample.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    args.check()?;
    if let Some((_, system)) = args.own.system()? {
        let search = own_protocol::Search {
            denominators: args.denominators_within(system.parameters.iter().any(has_range))?,
            steps: args.steps,
            start: args.start.as_deref().map(positions).transpose()?,
            file: args.out.clone(),
            known: None,
        };
        return own_protocol::refute(&args.own, &system, &search, args.format, out);
    }
    let (spaces, foreign): (Vec<SearchSpace>, Vec<SearchSpace>) =
        args.spaces()?.into_iter().partition(|space| args.applies(space));
    if let (Some(space), false) = (foreign.first(), args.theorem.as_deref() == Some("all")) {
        return Err(Error::input(format!(
            "theorem: `{}` reads several placements: expected 7.2, 7.3 or 7.4i where drones skip updates or see stale positions",
            space.theorem.number()
        )));
    }
    if args.out.is_some() && spaces.len() > 1 {
        let named = spaces.len();
        return Err(Error::input(format!("out: {named} theorems are named: expected one")));
    }
    let mut outcome = Outcome::Holds;
    let mut results = Vec::new();
    if let Some(space) = spaces.iter().find(|s| s.is_long()) {
        super::progress::announce(&format!(
            "{} with up to {} drones: this may take some minutes",
            space.theorem.number(),
            space.drones.iter().max().copied().unwrap_or_default()
        ));
    }
    progress::expect(spaces.iter().map(SearchSpace::pieces).sum());
    for space in &spaces {
        let answer = match args.departures() {
            Some(departures) => departing::search(space, departures)?,
            None => search(space),
        };
        outcome = outcome.worst(match &answer.found {
            Some(_) => Outcome::Refuted,
            None => Outcome::Inconclusive,
        });
        let refutation = answer.found.as_ref().map(certificate::refutation);
        if let Some(refutation) = &refutation {
            certificate::judged(refutation)?;
        }
        let file = match (&args.out, &refutation) {
            (Some(path), Some(refutation)) => Some(certificate::write_file(path, refutation)?),
            _ => None,
        };
        match args.format {
            OutputFormat::Text => {
                args.text(space, &answer, out)?;
                if let Some(file) = file {
                    writeln!(out, "  wrote   {file}")?;
                }
            }
            OutputFormat::Json => results.push(as_json(space, &answer)),
        }
    }
    let foreign: Vec<&str> = foreign.iter().map(|space| space.theorem.number()).collect();
    if args.format == OutputFormat::Text && !foreign.is_empty() {
        writeln!(
            out,
            "not applicable where drones skip updates or see stale positions, since they read several placements: {}",
            foreign.join(", ")
        )?;
    }
    if args.format == OutputFormat::Json {
        let page = json!({
            "not_applicable": foreign,
            "schema": "cordon-refute/1",
            "steps": args.steps,
            "activation": args.activation,
            "delay": args.delay,
            "results": results,
        });
        writeln!(out, "{page:#}")?;
    }
    Ok(outcome)
}

impl Args {
    fn check(&self) -> Result<()> {
        if self.steps > MOST_STEPS {
            return Err(Error::input(format!(
                "steps: `{}`: expected at most {MOST_STEPS}",
                self.steps
            )));
        }
        match self.denominators {
            Some(given) if !(1..=MOST_DENOMINATORS).contains(&given) => Err(Error::input(format!(
                "denominators: `{given}`: expected a number from 1 to {MOST_DENOMINATORS}"
            ))),
            _ => Ok(()),
        }
    }

    /// The greatest denominator, where one is given; `ranged` says whether there is a range that it is about.
    fn denominators_within(&self, ranged: bool) -> Result<Option<u32>> {
        match self.denominators {
            Some(given) if !ranged => Err(Error::input(format!(
                "denominators: `{given}`: expected a range of weights or of a parameter to search: all are fixed"
            ))),
            given => Ok(given),
        }
    }

    fn greatest(&self, ranged: bool) -> Result<u32> {
        Ok(self.denominators_within(ranged)?.unwrap_or(own_protocol::DENOMINATORS))
    }

    /// How steps may depart from the protocol as written.
    fn departures(&self) -> Option<Departures> {
        match self.delay {
            Some(longest) => Some(Departures::Late(longest)),
            None => self.activation.then_some(Departures::Skips),
        }
    }

    /// Whether the search supports the theorem.
    fn applies(&self, space: &SearchSpace) -> bool {
        self.departures().is_none() || departing::is_claim(space.theorem, space.form)
    }

    fn spaces(&self) -> Result<Vec<SearchSpace>> {
        let theorems = theorems::named(self.theorem.as_deref().unwrap_or("all"))?;
        let drones: Vec<usize> = range::whole("drones", &self.drones, 3..=MOST_DRONES)?.collect();
        let weights = self.weights()?;
        let form = Form::from(self.form);
        let space = |theorem| SearchSpace {
            theorem,
            form,
            drones: drones.clone(),
            weights: weights.clone(),
            any_weight: self.eps.is_some(),
            steps: self.steps,
        };
        Ok(theorems.into_iter().map(space).collect())
    }

    /// The weights of --eps, or without it those of the unit interval.
    fn weights(&self) -> Result<Vec<Rational>> {
        let Some(text) = &self.eps else {
            let most = self.greatest(true)?;
            return Ok(fractions_within(&Rational::zero(), &Rational::one(), most));
        };
        let (lo, hi) = range::closed("eps", text)?;
        let most = self.greatest(lo != hi)?;
        if lo == hi {
            return Ok(vec![lo]);
        }
        if &hi - &lo > Rational::from_integer(100.into()) {
            return Err(Error::input(format!(
                "eps: `{text}`: expected a range of length 100 or less"
            )));
        }
        let within = fractions_within(&lo, &hi, most);
        if within.is_empty() {
            return Err(Error::input(format!(
                "eps: `{text}`: has no fraction with a denominator up to {most}: expected a wider range or more --denominators"
            )));
        }
        Ok(within)
    }

    fn text(&self, space: &SearchSpace, answer: &SearchResult, out: &mut dyn Write) -> Result<()> {
        let t = theorems::words(space.theorem);
        let hypothesis = space.theorem.hypothesis(space.form);
        let manner = match (self.activation, self.delay) {
            (true, _) => ", any subset of the drones skipping any step".to_owned(),
            (_, Some(1)) => ", neighbours seen up to a step late".to_owned(),
            (_, Some(d)) => format!(", neighbours seen up to {d} steps late"),
            _ => String::new(),
        };
        let label = space.form.label();
        writeln!(
            out,
            "{} {} ({label} form{manner}): starts {}",
            space.theorem.number(),
            t.name,
            theorems::starts(hypothesis.starts)
        )?;
        match &answer.found {
            Some(found) => refuted(found, theorems::weights(hypothesis.weights), out)?,
            None => writeln!(out, "  not refuted: no counterexample was found")?,
        }
        for line in coverage_lines(&answer.covered, |extent| self.extent(space, extent)) {
            writeln!(out, "  {line}")?;
        }
        Ok(())
    }

    /// What the absence of a counterexample establishes.
    fn extent(&self, space: &SearchSpace, extent: Extent) -> String {
        let steps = space.steps;
        let every = match self.departures() {
            None => String::new(),
            Some(Departures::Skips) => " and patterns of skipped updates".to_owned(),
            Some(Departures::Late(longest)) => format!(" and delays up to {longest}"),
        };
        match extent {
            Extent::EveryStartAndStep if space.theorem == Theorem::Limit => {
                "none exists: complete for all starts and all steps (I - A^2 positive definite)"
                    .to_owned()
            }
            Extent::EveryStartAndStep if every.is_empty() => {
                "none exists: complete for all starts and all steps (inductive)".to_owned()
            }
            Extent::EveryStartAndStep => {
                format!("none exists: complete for all starts, steps{every} (inductive)")
            }
            Extent::EveryStart => {
                format!("none exists up to step {steps}: complete for all starts{every}")
            }
            Extent::Tried => format!("none found up to step {steps}: not complete"),
        }
    }
}

fn refuted(found: &Counterexample, range: &str, out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "  refuted at N = {}, eps = {}: {}",
        found.start().len(),
        fraction(&found.eps),
        found.what_fails()
    )?;
    if !found.weight_is_in_range() {
        writeln!(out, "  (no contradiction: the theorem is about {range})")?;
    }
    match &found.departure {
        Departure::None => {}
        Departure::Activation(steps) => {
            for (t, active) in steps.iter().enumerate() {
                writeln!(out, "  step {}: drones {} update", t + 1, drone_list(active))?;
            }
        }
        Departure::Delay(steps) => {
            for &(i, j, age) in steps.last().map_or(&[][..], Vec::as_slice) {
                let late = if age == 1 { "step" } else { "steps" };
                writeln!(out, "  drone {i} sees drone {j} {age} {late} late")?;
            }
        }
    }
    table::placements(&found.run, out)?;
    if found.departure == Departure::None {
        writeln!(out, "  replay: {}", found.replay_line())?;
    }
    Ok(())
}

fn drone_list(drones: &[usize]) -> String {
    if drones.is_empty() {
        return "none".to_owned();
    }
    drones.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// One line per number of drones and extent.
fn coverage_lines(covered: &[Coverage], describe: impl Fn(Extent) -> String) -> Vec<String> {
    let mut counts: Vec<usize> = covered.iter().map(|c| c.count).collect();
    counts.dedup();
    let mut lines = Vec::new();
    for count in counts {
        for extent in [Extent::EveryStartAndStep, Extent::EveryStart, Extent::Tried] {
            let here = |c: &&Coverage| c.count == count && c.extent == extent;
            let mut weights: Vec<&Rational> = covered.iter().filter(here).map(|c| &c.eps).collect();
            weights.sort();
            let weights: Vec<String> = weights.into_iter().map(fraction).collect();
            if weights.is_empty() {
                continue;
            }
            let what = describe(extent);
            lines.push(format!("N = {count}, eps = {}: {what}", abridged(&weights)));
        }
    }
    lines
}

fn as_json(space: &SearchSpace, answer: &SearchResult) -> Value {
    json!({
        "theorem": space.theorem.number(),
        "form": space.form.label(),
        "refuted": answer.found.is_some(),
        "counterexample": answer.found.as_ref().map(Counterexample::to_json),
        "covered": answer.covered.iter().map(|c| json!({
            "drones": c.count,
            "eps": fraction(&c.eps),
            "without_counterexample": match c.extent {
                Extent::EveryStartAndStep => "every start, every step",
                Extent::EveryStart => "every start, up to the last step",
                Extent::Tried => "some starts, up to the last step",
            },
        })).collect::<Vec<_>>(),
    })
}
