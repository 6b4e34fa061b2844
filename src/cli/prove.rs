//! `cordon prove`.

use std::io::Write;
use std::path::PathBuf;

use cordon_check::Verdict;
use cordon_spec::theorems::{Form, Theorem};
use serde_json::{Value, json};

use super::own_protocol;
use super::progress;
use super::select::OutputFormat;
use cordon_core::{Error, Outcome, Rational, Result, files, range};
use cordon_proof::certificate;
use cordon_proof::prove::claims::Claim;
use cordon_proof::prove::{Effort, Found, Scope, exactness, prove};
use cordon_proof::refute;

/// Arguments of `cordon prove`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// What to prove: `all`, or names separated by commas: theorems (7.2, 7.4ii, ...), their
    /// extensions (7.2-activation, ...), 7.2-exact, 7.3-exact
    #[arg(value_name = "CLAIMS", default_value = "all")]
    pub claims: String,
    /// Prove or refute the claims of an own protocol instead (TOML, see `scenarios/own/`)
    #[arg(long, value_name = "FILE", conflicts_with_all = ["claims", "form", "eps", "drones"])]
    pub protocol: Option<PathBuf>,
    /// Form of the theorems
    #[arg(long, value_enum, default_value_t = FormChoice::Sharp)]
    pub form: FormChoice,
    /// Weight or range of weights in the place of each theorem's own range
    #[arg(long, value_name = "E|LO..HI", allow_hyphen_values = true)]
    pub eps: Option<String>,
    /// Number of drones: one N >= 3, or every N
    #[arg(long, value_name = "N|any", default_value = "any")]
    pub drones: String,
    /// Most factors of a product of hypotheses that the search combines (7.8 needs 4)
    #[arg(long, value_name = "D", default_value_t = 4, value_parser = clap::value_parser!(u8).range(1..=8))]
    pub degree: u8,
    /// Folder to write the certificates to
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Form of the output
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

/// One search.
enum Task {
    Claim(Claim, Form),
    Exactness(Theorem),
}

/// The theorems whose bound 1/2 is proved exact, by the name of that claim.
const EXACT: [(&str, Theorem); 2] =
    [("7.2-exact", Theorem::Ordering), ("7.3-exact", Theorem::UpperBound)];

/// Searches certificates, has each one checked, and writes them.
pub(super) fn run(args: &Args, out: &mut dyn Write) -> Result<Outcome> {
    if let Some(path) = &args.protocol {
        let search = own_protocol::Search::default();
        return own_protocol::prove(path, args.out.as_deref(), &search, args.format, out);
    }
    let drones = drones(&args.drones)?;
    let weights = args.eps.as_deref().map(|t| range::closed("eps", t)).transpose()?;
    let tasks = tasks(args, drones.is_some() || weights.is_some())?;
    if let Some(folder) = &args.out {
        std::fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
    }
    let (mut outcome, mut rows) = (Outcome::Holds, Vec::new());
    progress::expect(tasks.len());
    for task in tasks {
        progress::advance();
        let effort = Effort { level: usize::from(args.degree), ..Effort::default() };
        let ended = attempt(&task, drones, weights.as_ref(), effort);
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
                out.flush()?;
            }
            OutputFormat::Json => rows.push(json!({
                "name": ended.name,
                "outcome": ended.label(),
                "message": ended.message,
                "file": file,
                "certificate": if file.is_none() { ended.certificate } else { None },
            })),
        }
    }
    if args.format == OutputFormat::Json {
        writeln!(out, "{:#}", json!({ "schema": "cordon-prove/1", "claims": rows }))?;
    }
    Ok(outcome)
}

/// How a search ended.
struct Ended {
    name: String,
    outcome: Outcome,
    message: String,
    certificate: Option<Value>,
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

fn attempt(
    task: &Task,
    drones: Option<u32>,
    weights: Option<&(Rational, Rational)>,
    effort: Effort,
) -> Ended {
    match task {
        Task::Exactness(theorem) => {
            let name = format!("{}-exact", theorem.number());
            match exactness::prove(*theorem, effort) {
                Some(certificate) => judged(name, Outcome::Holds, "proved", certificate),
                None => inconclusive(name, "no proof found"),
            }
        }
        Task::Claim(claim, form) => {
            let scope = Scope { form: *form, weights: weights.cloned(), drones };
            let base = if claim.has_forms() {
                format!("{}-{}", claim.name, form.label())
            } else {
                claim.name.to_owned()
            };
            let name = match (drones, weights) {
                (None, None) => base,
                (n, w) => {
                    let n = n.map(|n| format!("-n{n}")).unwrap_or_default();
                    let w = w.map(|(a, b)| format!("-eps-{a}..{b}").replace('/', "_"));
                    format!("{base}{n}{}", w.unwrap_or_default())
                }
            };
            // A counterexample is cheap to look for, and ends a search that cannot succeed.
            let theorem = claim.theorem.filter(|_| claim.has_forms());
            let count = drones.map(|n| n as usize);
            if let Some(found) = theorem.and_then(|t| refute::evident(t, *form, count, weights)) {
                return judged(name, Outcome::Refuted, "refuted", certificate::refutation(&found));
            }
            match prove(claim, &scope, effort) {
                Found::Certificate(certificate) => {
                    judged(name, Outcome::Holds, "proved", certificate)
                }
                Found::Nothing(missing) => {
                    inconclusive(name, &format!("no proof found of {}", missing.join(", ")))
                }
            }
        }
    }
}

fn inconclusive(name: String, why: &str) -> Ended {
    let message = format!("inconclusive: {why}");
    Ended { name, outcome: Outcome::Inconclusive, message, certificate: None }
}

/// What the independent checker says of a certificate decides.
fn judged(name: String, outcome: Outcome, word: &str, certificate: Value) -> Ended {
    match cordon_check::check(&certificate.to_string()) {
        Verdict::Valid { claim, .. } => Ended {
            name,
            outcome,
            message: format!("{word}: {claim}"),
            certificate: Some(certificate),
        },
        verdict => Ended {
            name,
            outcome: Outcome::Rejected,
            message: format!("the checker rejects the certificate: {verdict}"),
            certificate: None,
        },
    }
}

fn tasks(args: &Args, narrowed: bool) -> Result<Vec<Task>> {
    let forms: &[Form] = match args.form {
        FormChoice::Paper => &[Form::Paper],
        FormChoice::Sharp => &[Form::Sharp],
        FormChoice::Both => &Form::ALL,
    };
    let all = Claim::all();
    let names: Vec<&str> = args.claims.split(',').map(str::trim).collect();
    let mut tasks = Vec::new();
    let mut known = Vec::new();
    for claim in &all {
        let wanted = |n: &&str| {
            *n == "all"
                || *n == claim.name
                || (claim.has_forms() && claim.name.trim_end_matches('i') == *n)
        };
        if names.iter().any(wanted) {
            known.extend(names.iter().filter(|n| wanted(n)));
            let forms = if claim.has_forms() { forms } else { &[Form::Sharp] };
            tasks.extend(forms.iter().map(|&f| Task::Claim(*claim, f)));
        }
    }
    for (name, theorem) in EXACT {
        let all = names.contains(&"all") && !narrowed;
        if all || names.contains(&name) {
            known.push(name);
            tasks.push(Task::Exactness(theorem));
        }
    }
    match names.iter().find(|n| !known.contains(n)) {
        None => Ok(tasks),
        Some(name) => {
            let claims: Vec<&str> =
                all.iter().map(|c| c.name).chain(EXACT.map(|(n, _)| n)).collect();
            Err(Error::input(format!(
                "claim: `{name}` is unknown: expected `all` or some of {}",
                claims.join(", ")
            )))
        }
    }
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
