//! The harnesses of `kani/`, checked by Kani on request; otherwise shown from the record of the last
//! run.

use std::cell::OnceCell;
use std::path::{Path, PathBuf};

use cordon_spec::theorems::Theorem;
use serde::Deserialize;

use super::record::{Record, entry};
use super::{Context, Evidence, Status, Tier, TierVerdict};
use crate::model_check::report::{Checked, Report};
use crate::model_check::results::Ending;
use crate::model_check::tool::Kani;
use crate::model_check::{Limits, NotRun, SOURCES, run};
use cordon_core::{Error, Result, files};

/// The name of the tier.
pub const NAME: &str = "kani";

/// The record of the last run, below the repository's root.
pub const RECORD: &str = "kani/run.json";

/// Limits of each harness: the defaults of `cargo xtask kani`.
const SECONDS: u64 = 60;
const MEBIBYTES: u64 = 4096;

/// The tier of model-checked harnesses, `kani/`.
#[derive(Debug)]
pub struct ModelChecked {
    root: PathBuf,
    requested: bool,
    ran: OnceCell<std::result::Result<Report, String>>,
}

impl ModelChecked {
    /// The harnesses below the repository's root.
    pub fn new(context: Context<'_>) -> Self {
        let requested = context.run.iter().any(|name| name == NAME);
        Self { root: context.root.to_owned(), requested, ran: OnceCell::new() }
    }

    fn report(&self) -> &std::result::Result<Report, String> {
        self.ran.get_or_init(|| {
            let kani = Kani::find().map_err(|NotRun(why)| why)?;
            let limits = Limits::allowed(None, SECONDS, MEBIBYTES);
            let report = run(&self.root, &kani, &[], limits).map_err(|e| e.to_string())?;
            report.map_err(|NotRun(why)| why)
        })
    }
}

/// The fields of a record that are used.
#[derive(Deserialize)]
struct Page {
    kani: String,
    /// Early records had neither.
    #[serde(default)]
    date: Option<String>,
    #[serde(default)]
    sources: Option<String>,
    harnesses: Vec<Row>,
}

#[derive(Deserialize)]
struct Row {
    name: String,
    verdict: String,
    detail: String,
    seconds: Option<f64>,
}

/// The record of the last run; `None` if there is no file. A record without a hash of its sources is
/// always stale.
///
/// # Errors
/// The file cannot be read, or is not a record.
pub fn recorded(root: &Path) -> Result<Option<Record>> {
    let path = root.join(RECORD);
    if !path.exists() {
        return Ok(None);
    }
    let page: Page = serde_json::from_str(&files::read_text(&path, files::Limit::RECORD)?)
        .map_err(|e| Error::input(format!("{}: expected a record: {e}", path.display())))?;
    let about = |theorem: Theorem| {
        let mine: Vec<_> = cordon_kani::all().filter(|h| h.subject == theorem.number()).collect();
        let rows = mine.iter().map(|h| (h.name, page.harnesses.iter().find(|r| r.name == h.name)));
        let verdicts = rows.clone().map(|(name, row)| match row {
            Some(row) => judged(name, Ending::labelled(&row.verdict), &row.detail),
            None => TierVerdict::Inconclusive(format!("{name}: not in the record")),
        });
        let worst = verdicts.reduce(TierVerdict::worse)?;
        let seconds = rows.filter_map(|(_, row)| row?.seconds).sum();
        Some(entry(theorem, worst, scope(mine.len()), seconds))
    };
    Ok(Some(Record {
        tier: NAME.to_owned(),
        tool: format!("Kani {}", page.kani),
        date: page.date.unwrap_or_else(|| "unknown date".to_owned()),
        sources: page.sources.unwrap_or_else(|| "unknown sources".to_owned()),
        theorems: Theorem::ALL.into_iter().filter_map(about).collect(),
    }))
}

fn scope(harnesses: usize) -> String {
    format!("{harnesses} harnesses within their bounds (`cargo xtask kani --list`)")
}

fn verdict(checked: &Checked) -> TierVerdict {
    let Checked { harness, finding } = checked;
    judged(harness.name, Some(finding.verdict), &finding.detail)
}

/// The verdict on a theorem from the result of its harness; `None` stands for an unknown result.
fn judged(harness: &str, ending: Option<Ending>, detail: &str) -> TierVerdict {
    let Some(ending) = ending else {
        return TierVerdict::Rejected(format!("{harness}: an unknown verdict"));
    };
    let said = || format!("{harness}: {}: {detail}", ending.label());
    match ending {
        Ending::Proved => TierVerdict::Holds,
        Ending::Refuted => TierVerdict::Refuted(said()),
        Ending::TimedOut | Ending::OutOfMemory | Ending::Broken => {
            TierVerdict::Inconclusive(said())
        }
        Ending::Vacuous | Ending::Missing => TierVerdict::Rejected(said()),
    }
}

impl Tier for ModelChecked {
    fn name(&self) -> &'static str {
        NAME
    }

    fn kind(&self) -> Evidence {
        Evidence::ModelChecked
    }

    fn tool(&self) -> String {
        Kani::find().map_or_else(|_| "cargo kani".to_owned(), |kani| kani.to_string())
    }

    fn sources(&self) -> &'static [&'static str] {
        &SOURCES
    }

    fn status(&self, theorem: Theorem) -> Status {
        if !self.root.join("kani").is_dir() {
            return Status::NotRun("no `kani` here".to_owned());
        }
        let number = theorem.number();
        if !cordon_kani::all().any(|h| h.subject == number) {
            return Status::NotClaimed(format!("no harness is about {number}"));
        }
        if !self.requested {
            return Status::NotRun(format!("on request only: `--run {NAME}`"));
        }
        let report = match self.report() {
            Ok(report) => report,
            Err(why) => return Status::NotRun(why.clone()),
        };
        let mine = report.harnesses.iter().filter(|c| c.harness.subject == number);
        let mine: Vec<_> = mine.collect();
        let worst = mine.iter().map(|c| verdict(c)).reduce(TierVerdict::worse);
        Status::Run {
            verdict: worst.unwrap_or(TierVerdict::Inconclusive("no harness was run".to_owned())),
            scope: scope(mine.len()),
            seconds: mine.iter().filter_map(|c| c.finding.seconds).sum(),
        }
    }

    fn problems(&self) -> Vec<TierVerdict> {
        let Some(Ok(report)) = self.ran.get() else { return Vec::new() };
        let theorems = Theorem::ALL.map(|t| t.number());
        let others = report.harnesses.iter().filter(|c| !theorems.contains(&c.harness.subject));
        let unexpected = report
            .unexpected
            .iter()
            .map(|name| TierVerdict::Rejected(format!("{name}: reported by Kani, and in no list")));
        others.map(verdict).filter(|v| *v != TierVerdict::Holds).chain(unexpected).collect()
    }
}
