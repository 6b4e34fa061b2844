//! `cordon prove`.

use std::io::Write;
use std::path::PathBuf;

use cordon_spec::theorems::Form;
use serde_json::{Value, json};

use super::own_protocol;
use super::select::OutputFormat;
use cordon_core::{Error, Outcome, Result, files, progress, range, theorems};
use cordon_proof::certificate;
use cordon_proof::prove::{CLAIMS, Claim, Scope};
use cordon_proof::refute;

/// Arguments of `cordon prove`.
#[derive(clap::Args, Debug)]
#[command(
    override_usage = "cordon prove [OPTIONS] [CLAIMS]\n       cordon prove [OPTIONS] --protocol <FILE>"
)]
pub struct Args {
    /// What to prove: `all`, or names separated by commas: theorems (7.2, 7.4ii, ...), their
    /// extensions (7.2-activation, ...; a wrong one like 7.2-x lists them), 7.2-exact, 7.3-exact
    #[arg(value_name = "CLAIMS", default_value = "all", conflicts_with = "protocol")]
    pub claims: String,
    #[command(flatten)]
    pub own: own_protocol::ProtocolArgs,
    /// Form of the theorems
    #[arg(long, value_enum, default_value_t = FormChoice::Sharp, conflicts_with = "protocol")]
    pub form: FormChoice,
    /// Weight or range of weights, instead of each theorem's own range
    #[arg(long, value_name = "E|LO..HI", allow_hyphen_values = true, conflicts_with = "protocol")]
    pub eps: Option<String>,
    /// Number of drones: one N from 3 to 1000000, or every N
    #[arg(long, value_name = "N|any", default_value = "any", conflicts_with = "protocol")]
    pub drones: String,
    /// With --protocol: the claims up to this step only, 0 to 149; of a protocol for any number of agents, with
    /// --agents or the fewest
    #[arg(long, value_name = "K", help_heading = "Own protocol")]
    pub steps: Option<usize>,
    /// Folder to write the certificates to
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Output format
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub format: OutputFormat,
}

/// Which forms of a theorem.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormChoice {
    /// As printed.
    Paper,
    /// Under the weakest known hypothesis.
    Sharp,
    /// Both.
    Both,
}

/// Searches for certificates, has each one checked, and writes them.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    if let Some((file, flow)) = args.own.flow()? {
        let folder = args.out.as_deref();
        return own_protocol::prove_flow(&args.own, &file, &flow, folder, args.format, out);
    }
    let own = args.own.system()?;
    if args.steps.is_some() && own.is_none() {
        return Err(Error::input("steps: expected --protocol with it"));
    }
    if let Some(folder) = &args.out {
        std::fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
    }
    if let Some((file, system)) = own {
        let folder = args.out.as_deref();
        let (own, system) = match args.steps {
            Some(last) => args.own.up_to(&file, system, last)?,
            None => (args.own.clone(), system),
        };
        return own_protocol::prove(&own, &file, &system, folder, args.format, out);
    }
    let drones = drones(&args.drones)?;
    let weights = args.eps.as_deref().map(|t| range::closed("eps", t)).transpose()?;
    let narrowed = Scope { form: Form::Sharp, weights: weights.clone(), drones };
    let claims = claims(args, &narrowed)?;
    let (mut outcome, mut rows) = (Outcome::Holds, Vec::new());
    progress::expect(claims.len() as u64);
    for (claim, form) in claims {
        let ended = attempt(claim, Scope { form, weights: weights.clone(), drones });
        progress::advance(1);
        outcome = outcome.worst(ended.outcome);
        let mut file = None;
        if let (Some(folder), Some(certificate)) = (&args.out, &ended.certificate) {
            let path = folder.join(format!("{}.json", ended.name));
            files::write_atomically(&path, format!("{certificate:#}\n").as_bytes())?;
            file = Some(path.display().to_string());
        }
        match args.format {
            OutputFormat::Text => {
                let place = file.map(|f| format!(" [{f}]")).unwrap_or_default();
                writeln!(out, "{}: {}{place}", ended.name, ended.message)?;
                if let Some(replay) = &ended.replay {
                    writeln!(out, "  replay: {replay}")?;
                }
                out.flush()?;
            }
            OutputFormat::Json => rows.push(json!({
                "name": ended.name,
                "outcome": ended.label(),
                "message": ended.message,
                "file": file,
                "replay": ended.replay,
                "certificate": if file.is_none() { ended.certificate } else { None },
            })),
        }
    }
    if args.format == OutputFormat::Json {
        writeln!(out, "{:#}", json!({ "schema": "cordon-prove/1", "claims": rows }))?;
    }
    Ok(outcome)
}

/// The result of a search.
struct Ended {
    name: String,
    outcome: Outcome,
    message: String,
    certificate: Option<Value>,
    /// The command that replays a counterexample.
    replay: Option<String>,
}

impl Ended {
    fn label(&self) -> &'static str {
        match self.outcome {
            Outcome::Holds => "proved",
            Outcome::Refuted => "refuted",
            Outcome::Inconclusive => "inconclusive",
            Outcome::Rejected => "rejected",
        }
    }
}

fn attempt(claim: &Claim, scope: Scope) -> Ended {
    let base = claim.label(scope.form);
    let name = match (scope.drones, &scope.weights) {
        (None, None) => base,
        (n, w) => {
            let n = n.map(|n| format!("-n{n}")).unwrap_or_default();
            let w = w.as_ref().map(|(a, b)| format!("-eps-{a}..{b}").replace('/', "_"));
            format!("{base}{n}{}", w.unwrap_or_default())
        }
    };
    // A counterexample is cheap to search for.
    let (count, weights) = (scope.drones.map(|n| n as usize), scope.weights.as_ref());
    let evident = |t| refute::evident(t, scope.form, count, weights);
    if let Some(found) = claim.theorem.and_then(evident) {
        let refutation = certificate::refutation(&found);
        let replay = Some(found.replay_line());
        return Ended { replay, ..judged(name, Outcome::Refuted, "refuted", refutation) };
    }
    match claim.prove(&scope) {
        Some(certificate) => judged(name, Outcome::Holds, "proved", certificate),
        None => Ended {
            name,
            outcome: Outcome::Inconclusive,
            message: format!(
                "inconclusive: no strategy for this claim{}",
                hindrance(claim, &scope)
            ),
            certificate: None,
            replay: None,
        },
    }
}

/// A note on which flag to drop so that there is a strategy, if that helps.
fn hindrance(claim: &Claim, scope: &Scope) -> String {
    let without = [
        ("--eps", scope.weights.is_some(), Scope { weights: None, ..scope.clone() }),
        ("--drones", scope.drones.is_some(), Scope { drones: None, ..scope.clone() }),
        (
            "--form paper",
            claim.theorem.is_some() && scope.form == Form::Paper,
            Scope { form: Form::Sharp, ..scope.clone() },
        ),
        ("--eps and --drones", true, Scope { weights: None, drones: None, ..scope.clone() }),
    ];
    let found =
        without.into_iter().find(|(_, given, wider)| *given && claim.statement(wider).is_some());
    match found {
        Some((flag, ..)) => format!(" with {flag}: without there is one"),
        None => String::new(),
    }
}

/// The result for a certificate is decided by the independent checker.
fn judged(name: String, outcome: Outcome, word: &str, certificate: Value) -> Ended {
    match certificate::judged(&certificate) {
        Ok(claim) => Ended {
            name,
            outcome,
            message: format!("{word}: {claim}"),
            certificate: Some(certificate),
            replay: None,
        },
        Err(e) => Ended {
            name,
            outcome: match e {
                Error::Rejected(_) => Outcome::Rejected,
                _ => Outcome::Inconclusive,
            },
            message: e.to_string(),
            certificate: None,
            replay: None,
        },
    }
}

/// The requested claims, each with its forms; `all` leaves out those that do not apply in a narrowed
/// scope.
fn claims(args: &Args, narrowed: &Scope) -> Result<Vec<(&'static Claim, Form)>> {
    let forms: &[Form] = match args.form {
        FormChoice::Paper => &[Form::Paper],
        FormChoice::Sharp => &[Form::Sharp],
        FormChoice::Both => &Form::ALL,
    };
    let names: Vec<&str> = args.claims.split(',').map(str::trim).collect();
    let named = |c: &Claim, n: &str| {
        n == c.name
            || (c.theorem.is_some() && c.name.trim_end_matches("-if").trim_end_matches('i') == n)
    };
    let known = |n: &&&str| **n == "all" || CLAIMS.iter().any(|c| named(c, n));
    if let Some(name) = names.iter().find(|n| !known(n)) {
        return Err(Error::input(format!(
            "claim: `{name}` is unknown: expected {}",
            theorems::expected(name, &like(name))
        )));
    }
    // `all` includes claims with a single form; if such a claim is named, `--form paper` is an error.
    let formless = |c: &&Claim| c.theorem.is_none() && names.contains(&c.name);
    if let (FormChoice::Paper, Some(claim)) = (args.form, CLAIMS.iter().find(formless)) {
        return Err(Error::input(format!(
            "form: `paper`: expected the form `sharp` of `{}`, which has no other",
            claim.name
        )));
    }
    let wanted = |c: &&Claim| {
        let fits = c.theorem.is_some() || c.statement(narrowed).is_some();
        names.iter().any(|n| named(c, n) || (*n == "all" && fits))
    };
    let forms_of = |c: &Claim| if c.theorem.is_some() { forms } else { &[Form::Sharp] };
    Ok(CLAIMS
        .iter()
        .filter(wanted)
        .flat_map(|c| forms_of(c).iter().map(move |&f| (c, f)))
        .collect())
}

/// The claims that a wrong name may stand for: the extensions of a theorem if the name begins like
/// them, otherwise the claims that are not extensions.
fn like(name: &str) -> String {
    let part = |name: &'static str| name.split_once('-').map_or(name, |(theorem, _)| theorem);
    let begins = name.split_once('-').map_or(name, |(theorem, _)| theorem);
    let all = CLAIMS.map(|c| c.name);
    let some: Vec<&str> = all.into_iter().filter(|n| part(n) == begins).collect();
    if !some.is_empty() {
        return some.join(", ");
    }
    let whole = |n: &&str| !n.starts_with("7.") || !n.contains('-');
    let some: Vec<&str> = all.into_iter().filter(whole).collect();
    format!("{}; or an extension like 7.2-activation", some.join(", "))
}

fn drones(text: &str) -> Result<Option<u32>> {
    match (text, text.parse()) {
        ("any", _) => Ok(None),
        (_, Ok(n @ 3..=1_000_000)) => Ok(Some(n)),
        _ => Err(Error::input(format!(
            "--drones: `{text}`: expected `any` or a number from 3 to 1000000"
        ))),
    }
}
