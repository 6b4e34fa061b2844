//! The committed certificates, checked by the independent checker.

use std::cell::OnceCell;
use std::path::{Path, PathBuf};
use std::time::Instant;

use cordon_check::Verdict as CheckerVerdict;
use cordon_proof::prove::{CLAIMS, stated};
use cordon_spec::theorems::{Form, Theorem};
use serde_json::Value;

use super::{Evidence, Status, Tier, TierVerdict, this_program};
use cordon_core::files;

/// The folder of the certificates, below the root.
const FOLDER: &str = "proofs/certificates";

/// The tier of committed certificates, `proofs/certificates`.
#[derive(Debug)]
pub struct Certificates {
    folder: PathBuf,
    judged: OnceCell<Result<Vec<Judged>, String>>,
}

/// A certificate with the checker's verdict.
#[derive(Debug)]
struct Judged {
    /// What it claims: a theorem's number, possibly with an extension (`7.3-mirror`). Empty for an
    /// unreadable file.
    claim: String,
    /// Whether it is the theorem itself: the sharp form, every N, all weights of its range.
    whole: bool,
    verdict: TierVerdict,
    seconds: f64,
}

impl Certificates {
    /// The certificates below the repository's root.
    pub fn new(root: &Path) -> Self {
        Self { folder: root.join(FOLDER), judged: OnceCell::new() }
    }

    fn judged(&self) -> &Result<Vec<Judged>, String> {
        self.judged.get_or_init(|| {
            let mut paths = Vec::new();
            files_below(&self.folder, &mut paths)
                .map_err(|_| format!("no certificates at `{FOLDER}`"))?;
            paths.sort();
            paths.iter().map(|path| judge(path)).collect()
        })
    }
}

fn files_below(folder: &Path, found: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            files_below(&path, found)?;
        } else if path.extension().is_some_and(|e| e == "json") {
            found.push(path);
        }
    }
    Ok(())
}

fn judge(path: &Path) -> Result<Judged, String> {
    let text = files::read_text(path, files::Limit::RECORD).map_err(|e| e.to_string())?;
    let started = Instant::now();
    let answer = cordon_check::check(&text);
    let seconds = started.elapsed().as_secs_f64();
    // The statement decides what a certificate is about, not its name. One about a single N and eps, a
    // counterexample or a protocol file is about no theorem; neither is an unreadable one.
    let page: Value = serde_json::from_str(&text).unwrap_or_default();
    let found = stated(&page["certificate"]["theorem"]["statement"]);
    let claim = found.map_or_else(String::new, |(claim, _)| claim.name.to_owned());
    let whole = found.is_some_and(|(claim, form)| claim.theorem.is_some() && form == Form::Sharp);
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let said = answer.to_string();
    let verdict = match answer {
        CheckerVerdict::Valid { .. } => TierVerdict::Holds,
        CheckerVerdict::Invalid { .. } | CheckerVerdict::Unreadable { .. } => {
            TierVerdict::Rejected(format!("{name}: {said}"))
        }
    };
    Ok(Judged { claim, whole, verdict, seconds })
}

/// Whether a claim is about the theorem: `7.3`, `7.3-mirror`, and `7.5-identity` for 7.5i.
fn is_about(claim: &str, theorem: Theorem) -> bool {
    let (number, extension) = claim.split_once('-').unwrap_or((claim, ""));
    let of_theorem = theorem.number();
    number == of_theorem
        || (extension == "identity" && of_theorem.strip_suffix('i') == Some(number))
}

impl Tier for Certificates {
    fn name(&self) -> &'static str {
        "certificate"
    }

    fn kind(&self) -> Evidence {
        Evidence::Certified
    }

    fn tool(&self) -> String {
        format!("cordon-check, in {}", this_program())
    }

    fn sources(&self) -> &'static [&'static str] {
        &["spec/src", "proofs/checker/src", FOLDER]
    }

    fn status(&self, theorem: Theorem) -> Status {
        let judged = match self.judged() {
            Ok(judged) => judged,
            Err(why) => return Status::NotRun(why.clone()),
        };
        let mine: Vec<_> = judged.iter().filter(|j| is_about(&j.claim, theorem)).collect();
        if mine.is_empty() {
            return Status::NotRun(format!("no certificate about {}", theorem.number()));
        }
        // All parts of the theorem itself have to be accepted; extensions alone do not prove it.
        let accepted = |name: &str| mine.iter().find(|j| j.whole && j.claim == name);
        let mut parts = CLAIMS.iter().filter(|c| c.theorem == Some(theorem));
        let itself =
            accepted(theorem.number()).filter(|_| parts.all(|c| accepted(c.name).is_some()));
        let worst = mine.iter().map(|j| &j.verdict).max_by_key(|v| v.outcome().code());
        let verdict = match (worst, itself) {
            (Some(worst), _) if *worst != TierVerdict::Holds => worst.clone(),
            (_, Some(_)) => TierVerdict::Holds,
            _ => TierVerdict::Inconclusive("only parts or extensions of it are certified".into()),
        };
        let scope = match itself {
            Some(j) => format!("{} (sharp) for every N >= 3, all weights of its range", j.claim),
            None => format!("{} certificates", mine.len()),
        };
        let extra = mine.len() - usize::from(itself.is_some());
        let scope = if extra == 0 { scope } else { format!("{scope}; and {extra} more") };
        Status::Run { verdict, scope, seconds: mine.iter().map(|j| j.seconds).sum() }
    }

    fn problems(&self) -> Vec<TierVerdict> {
        let Ok(judged) = self.judged() else { return Vec::new() };
        let of_no_theorem =
            judged.iter().filter(|j| !Theorem::ALL.iter().any(|&t| is_about(&j.claim, t)));
        of_no_theorem.map(|j| j.verdict.clone()).filter(|v| *v != TierVerdict::Holds).collect()
    }
}
