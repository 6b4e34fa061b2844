//! `--protocol FILE` of the commands that decide: a user's own protocol.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::select::OutputFormat;
use super::table::abridged;
use cordon_core::exact::fraction;
use cordon_core::system::{Parameter, ParameterKind, System};
use cordon_core::table::lines;
use cordon_core::text::shell_word;
use cordon_core::{Error, Evidence, Outcome, Rational, Result, range};
use cordon_proof::certificate;
use cordon_proof::claims::certificate::certificate as sealed;
use cordon_proof::claims::{self, MOST_COMBINATIONS, Proved, Run};
use cordon_proof::counterexample::list;
use cordon_run::protocol::{ProtocolFile, read};

/// A protocol file, and what of it is fixed.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct ProtocolArgs {
    /// The claims of a protocol of your own instead (TOML, see `scenarios/own/`)
    #[arg(long, value_name = "FILE", help_heading = "Own protocol")]
    pub protocol: Option<PathBuf>,
    /// Of a protocol for any number of agents, this number [default: the fewest]
    #[arg(long, value_name = "N", requires = "protocol", help_heading = "Own protocol")]
    pub agents: Option<usize>,
    /// A parameter's value or range in the place of the file's: `eps=1/3`, `gain=0..2`
    #[arg(
        long,
        value_name = "NAME=X|LO..HI",
        requires = "protocol",
        allow_hyphen_values = true,
        help_heading = "Own protocol"
    )]
    pub set: Vec<String>,
}

impl ProtocolArgs {
    /// The file and its system, where one is named.
    ///
    /// # Errors
    /// The file is wrong, a parameter is not there, or no start meets the assumptions.
    pub fn system(&self) -> Result<Option<(ProtocolFile, System)>> {
        let Some(path) = &self.protocol else { return Ok(None) };
        let file = read(path)?;
        let mut system = file.with_agents(self.agents.unwrap_or(file.agents.fewest()))?;
        for set in &self.set {
            let (name, values) = set.split_once('=').ok_or_else(|| {
                Error::input(format!(
                    "set: `{set}`: expected a parameter and its value, like `eps=1/3`"
                ))
            })?;
            let (low, high) = range::closed(&format!("set: {name}"), values)?;
            let known: Vec<&str> = system.parameters.iter().map(|p| p.name.as_str()).collect();
            let unknown = format!(
                "set: `{name}` is no parameter: expected one of {}",
                abridged_words(&known)
            );
            match system.parameters.iter_mut().find(|p| p.name == name) {
                Some(p) => (p.low, p.high) = (low, high),
                None => return Err(Error::input(unknown)),
            }
        }
        if claims::is_vacuous(&system) {
            return Err(Error::input(format!(
                "{}: start: no start meets the assumptions: expected one that does",
                path.display()
            )));
        }
        Ok(Some((file, system)))
    }

    fn path(&self) -> &Path {
        self.protocol.as_deref().unwrap_or(Path::new(""))
    }

    /// The flags that name this system again.
    fn flags(&self) -> String {
        let mut flags = format!("--protocol {}", shell_word(&self.path().display().to_string()));
        if let Some(n) = self.agents {
            flags += &format!(" --agents {n}");
        }
        flags
    }
}

fn abridged_words(words: &[&str]) -> String {
    match words {
        [] => "none".to_owned(),
        _ => abridged(&words.iter().map(|w| (*w).to_owned()).collect::<Vec<_>>()),
    }
}

/// Where to search for a counterexample.
#[derive(Clone, Debug)]
pub struct Search {
    /// Of a range of constants, the fractions with denominators up to this.
    pub denominators: u32,
    /// Last step.
    pub steps: usize,
    /// Only the run from this start.
    pub start: Option<Vec<Rational>>,
}

impl Default for Search {
    /// What follows where no proof is found: constants with small denominators, some steps.
    fn default() -> Self {
        Self { denominators: 8, steps: 8, start: None }
    }
}

/// Proves the claims of a protocol file, or refutes them, or says that it can do neither.
///
/// # Errors
/// A certificate cannot be written, or is beyond the checker's limits.
pub fn prove(
    args: &ProtocolArgs,
    system: &System,
    folder: Option<&Path>,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let Some(found) = claims::prove(system) else {
        return refute(args, system, &Search::default(), None, format, out);
    };
    let Some(certificate) = sealed(&found.system, &found.proof) else {
        return Err(Error::internal("a proof without a certificate"));
    };
    certificate::judged(&certificate)?;
    let name = args.path().file_stem().map_or_else(|| "own".into(), |s| s.to_string_lossy());
    let file = folder.map(|folder| certificate::write(folder, &name, &certificate)).transpose()?;
    let file = file.map(|path| path.display().to_string());
    match format {
        OutputFormat::Text => proved(system, &found, file.as_deref(), out)?,
        OutputFormat::Json => {
            let mut page = head(system);
            page.insert("proved", json!(true));
            page.insert("evidence", json!(Evidence::Certified));
            page.insert("half_spaces", json!(found.proof.rows.len()));
            page.insert("claimed", json!(claimed(&found)));
            page.insert("file", json!(file));
            writeln!(out, "{:#}", json!(page))?;
        }
    }
    Ok(Outcome::Holds)
}

fn claimed(found: &Proved) -> usize {
    found.proof.rows.iter().filter(|r| r.claim.is_some()).count()
}

fn head(system: &System) -> BTreeMap<&'static str, Value> {
    let range = |p: &Parameter| (p.name.clone(), json!([fraction(&p.low), fraction(&p.high)]));
    BTreeMap::from([
        ("schema", json!("cordon-own-protocol/2")),
        ("title", json!(system.title)),
        ("agents", json!(system.agents)),
        (
            "parameters",
            system.parameters.iter().map(range).collect::<serde_json::Map<_, _>>().into(),
        ),
    ])
}

/// Searches for a counterexample to the claims of a protocol file.
///
/// # Errors
/// The start is wrong, or there is too much to search.
pub fn refute(
    args: &ProtocolArgs,
    system: &System,
    search: &Search,
    file: Option<&Path>,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let constants = claims::constants(system, search.denominators).ok_or_else(|| {
        Error::input(format!(
            "set: more than {MOST_COMBINATIONS} combinations of constants: expected values for some, or \
             smaller denominators"
        ))
    })?;
    let start = search.start.as_deref().map(|x| assumed(system, x)).transpose()?;
    let (found, complete) = claims::refute(system, &constants, start.as_deref(), search.steps);
    if let (Some(_), Some(path)) = (&found, file) {
        return Err(Error::input(format!(
            "out: `{}`: the run is in the output: expected no certificate of it",
            path.display()
        )));
    }
    match format {
        OutputFormat::Text => {
            writeln!(out, "{}", headline(system))?;
            match &found {
                Some(run) => refuted(args, system, run, out)?,
                None => not_refuted(system, search, &constants, complete, out)?,
            }
        }
        OutputFormat::Json => {
            let mut page = head(system);
            page.insert("proved", json!(false));
            page.insert(
                "counterexample",
                found.as_ref().map_or(Value::Null, |run| as_json(args, system, run)),
            );
            page.insert(
                "searched",
                json!({
                    "constants": constants.len(),
                    "steps": complete,
                    "starts": if search.start.is_some() { "given" } else { "every" },
                }),
            );
            writeln!(out, "{:#}", json!(page))?;
        }
    }
    Ok(if found.is_some() { Outcome::Refuted } else { Outcome::Inconclusive })
}

/// The whole state of a start that the assumptions allow.
fn assumed(system: &System, start: &[Rational]) -> Result<Vec<Rational>> {
    let state = system.at_rest(start).ok_or_else(|| {
        Error::input(format!(
            "start: {} numbers: expected {}, one a state variable: {}",
            start.len(),
            system.state.len() - system.past.len(),
            abridged(&system.state)
        ))
    })?;
    match system.starts.iter().find(|p| !p.holds(&state)) {
        Some(broken) => Err(Error::input(format!(
            "start: does not meet `{}`: expected a start that the protocol assumes",
            broken.text
        ))),
        None => Ok(state),
    }
}

fn headline(system: &System) -> String {
    let agents = if system.agents == 1 { "agent" } else { "agents" };
    let mut parts = vec![format!("{}: {} {agents}", system.title, system.agents)];
    let is_choice = |p: &&Parameter| p.kind == ParameterKind::Choice;
    for p in system.parameters.iter().filter(|p| !is_choice(p)) {
        parts.push(match (p.fixed(), p.kind) {
            (Some(value), _) => format!("{} = {}", p.name, fraction(value)),
            (None, ParameterKind::Varying) => {
                format!(
                    "{} anywhere in [{}, {}], anew in each step",
                    p.name,
                    fraction(&p.low),
                    fraction(&p.high)
                )
            }
            (None, _) => {
                format!("every {} in [{}, {}]", p.name, fraction(&p.low), fraction(&p.high))
            }
        });
    }
    match system.parameters.iter().filter(is_choice).count() {
        0 => {}
        n => parts.push(format!("{n} free choice{} in each step", if n == 1 { "" } else { "s" })),
    }
    match (&system.schedule, system.modes.len()) {
        (_, 1) => {}
        (cordon_core::system::Schedule::Any, n) => {
            parts.push(format!("any of {n} modes in each step"))
        }
        (cordon_core::system::Schedule::Cycle(list), _) => {
            parts.push(format!("{} modes in turn", list.len()));
        }
    }
    parts.join(", ")
}

fn proved(system: &System, found: &Proved, file: Option<&str>, out: &mut dyn Write) -> Result<()> {
    writeln!(out, "{}", headline(system))?;
    writeln!(out, "  proved: the claims hold at every step from every assumed start")?;
    let rows = found.proof.rows.len();
    writeln!(
        out,
        "  {}: {rows} half-space{}, {} of them claimed; the start meets them, every step keeps them, at \
         the ends of all ranges and so between",
        Evidence::Certified,
        if rows == 1 { "" } else { "s" },
        claimed(found)
    )?;
    if let Some(file) = file {
        writeln!(out, "  wrote {file}")?;
    }
    Ok(())
}

fn refuted(args: &ProtocolArgs, system: &System, run: &Run, out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "  refuted{}: `{}` fails at step {}",
        constants_text(system, &run.values),
        claim_text(system, run),
        run.step
    )?;
    for line in lines(&rows(system, run), |column| {
        column > 0 && has_choices(system) && column == system.state.len() + 1
    }) {
        writeln!(out, "  {line}")?;
    }
    writeln!(out, "  {}, exact", Evidence::ThisRunOnly)?;
    writeln!(out, "  replay: {}", replay_line(args, system, run))?;
    Ok(())
}

fn has_choices(system: &System) -> bool {
    !system.is_deterministic()
}

/// Most states of a run in text.
const MOST_ROWS: usize = 40;

/// The run as a table: a line a step, with what was chosen in it.
fn rows(system: &System, run: &Run) -> Vec<Vec<String>> {
    let mut head: Vec<String> =
        ["step".to_owned()].into_iter().chain(system.state.clone()).collect();
    if has_choices(system) {
        head.push("by".to_owned());
    }
    let mut rows = vec![head];
    for (k, state) in run.states.iter().enumerate() {
        let skipped = run.states.len() > MOST_ROWS
            && k >= MOST_ROWS / 2
            && k + MOST_ROWS / 2 < run.states.len();
        if skipped {
            if k == MOST_ROWS / 2 {
                rows.push(vec!["...".to_owned()]);
            }
            continue;
        }
        let mut row: Vec<String> =
            [k.to_string()].into_iter().chain(state.iter().map(fraction)).collect();
        if let Some(choice) = k
            .checked_sub(1)
            .and_then(|before| run.choices.get(before))
            .filter(|_| has_choices(system))
        {
            let mode = system.modes.get(choice.mode).filter(|_| system.modes.len() > 1);
            let varying = varying(system, &choice.values)
                .map(|(p, v)| format!("{} = {}", p.name, fraction(v)));
            let words: Vec<String> =
                mode.map(|m| m.name.clone()).into_iter().chain(varying).collect();
            row.push(words.join(", "));
        }
        rows.push(row);
    }
    rows
}

/// The parameters that may differ from step to step, with their values.
fn varying<'s>(
    system: &'s System,
    values: &'s [Rational],
) -> impl Iterator<Item = (&'s Parameter, &'s Rational)> {
    let varies =
        |(p, _): &(&Parameter, _)| p.kind != ParameterKind::Constant && p.fixed().is_none();
    system.parameters.iter().zip(values).filter(varies)
}

fn constants_text(system: &System, values: &[Rational]) -> String {
    let constant = |(p, _): &(&Parameter, &Rational)| p.kind == ParameterKind::Constant;
    let all = system.parameters.iter().zip(values).filter(constant);
    let all: Vec<String> = all.map(|(p, v)| format!("{} = {}", p.name, fraction(v))).collect();
    if all.is_empty() { String::new() } else { format!(" at {}", all.join(", ")) }
}

fn not_refuted(
    system: &System,
    search: &Search,
    constants: &[Vec<Rational>],
    complete: usize,
    out: &mut dyn Write,
) -> Result<()> {
    let which = if search.start.is_some() {
        "from this start"
    } else {
        Evidence::CompleteForAllStarts.text()
    };
    let texts: Vec<String> = constants.iter().map(|v| constants_text(system, v)).collect();
    let at = match texts.as_slice() {
        [one] => one.clone(),
        many => format!(" at {} combinations of constants", many.len()),
    };
    writeln!(out, "  not refuted: no counterexample up to step {complete}{at}: {which}")?;
    if complete < search.steps {
        writeln!(out, "  (the search was too large to go on to step {})", search.steps)?;
    }
    Ok(())
}

fn claim_text<'p>(system: &'p System, run: &Run) -> &'p str {
    system.claims.get(run.claim).map_or("", |c| c.predicate.text.as_str())
}

fn replay_line(args: &ProtocolArgs, system: &System, run: &Run) -> String {
    let now = system.state.len() - system.past.len();
    let start = run.states.first().and_then(|x| x.get(..now)).map_or_else(String::new, list);
    let constant = |(p, _): &(&Parameter, &Rational)| p.kind == ParameterKind::Constant;
    let sets = system.parameters.iter().zip(&run.values).filter(constant);
    let sets: String = sets.map(|(p, v)| format!(" --set {}={}", p.name, fraction(v))).collect();
    format!("cordon refute {}{sets} --steps {} --start={start}", args.flags(), run.step)
}

fn as_json(args: &ProtocolArgs, system: &System, run: &Run) -> Value {
    let states: Vec<Vec<String>> =
        run.states.iter().map(|x| x.iter().map(fraction).collect()).collect();
    let named = |(p, v): (&Parameter, &Rational)| (p.name.clone(), json!(fraction(v)));
    let constant = |(p, _): &(&Parameter, &Rational)| p.kind == ParameterKind::Constant;
    let constants: serde_json::Map<_, _> =
        system.parameters.iter().zip(&run.values).filter(constant).map(named).collect();
    let choices: Vec<Value> = run
        .choices
        .iter()
        .map(|c| {
            let values: serde_json::Map<_, _> = varying(system, &c.values).map(named).collect();
            json!({ "mode": system.modes.get(c.mode).map(|m| &m.name), "values": values })
        })
        .collect();
    json!({
        "constants": constants,
        "step": run.step,
        "claim": claim_text(system, run),
        "state": system.state,
        "run": states,
        "choices": choices,
        "replay": replay_line(args, system, run),
    })
}
