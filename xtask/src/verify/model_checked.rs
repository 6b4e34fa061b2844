//! The harnesses of `kani/`, checked by Kani on request.

use std::cell::OnceCell;
use std::path::PathBuf;

use cordon_spec::theorems::Theorem;

use super::{Context, Evidence, Status, Tier, Verdict};
use crate::model_check::report::{Checked, Report};
use crate::model_check::results::Verdict as Ending;
use crate::model_check::tool::Kani;
use crate::model_check::{Limits, NotRun, run};

/// Limits of each harness: what `cargo xtask kani` sets by itself.
const SECONDS: u64 = 60;
const MEBIBYTES: u64 = 4096;

/// The tier.
#[derive(Debug)]
pub struct ModelChecked {
    root: PathBuf,
    requested: bool,
    ran: OnceCell<Result<Report, String>>,
}

impl ModelChecked {
    /// The harnesses below the repository's root.
    pub fn new(context: Context<'_>) -> Self {
        let requested = context.run.iter().any(|name| name == "kani");
        Self { root: context.root.to_owned(), requested, ran: OnceCell::new() }
    }

    fn report(&self) -> &Result<Report, String> {
        self.ran.get_or_init(|| {
            let kani = Kani::find().map_err(|NotRun(why)| why)?;
            let limits = Limits::allowed(None, SECONDS, MEBIBYTES);
            let report = run(&self.root, &kani, &[], limits).map_err(|e| e.to_string())?;
            report.map_err(|NotRun(why)| why)
        })
    }
}

/// What a failed harness means for its theorem.
fn verdict(checked: &Checked) -> Verdict {
    let said = || {
        let Checked { harness, finding } = checked;
        format!("{}: {}: {}", harness.name, finding.verdict.label(), finding.detail)
    };
    match checked.finding.verdict {
        Ending::Proved => Verdict::Holds,
        Ending::Refuted => Verdict::Refuted(said()),
        Ending::TimedOut | Ending::OutOfMemory | Ending::Broken => Verdict::Inconclusive(said()),
        Ending::Vacuous | Ending::Missing => Verdict::Rejected(said()),
    }
}

impl Tier for ModelChecked {
    fn name(&self) -> &'static str {
        "kani"
    }

    fn kind(&self) -> Evidence {
        Evidence::ModelChecked
    }

    fn tool(&self) -> String {
        Kani::find().map_or_else(|_| "cargo kani".to_owned(), |kani| kani.to_string())
    }

    fn sources(&self) -> &'static [&'static str] {
        &["spec/src", "kani/src"]
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
            return Status::NotRun("on request only: `--run kani`".to_owned());
        }
        let report = match self.report() {
            Ok(report) => report,
            Err(why) => return Status::NotRun(why.clone()),
        };
        let mine = report.harnesses.iter().filter(|c| c.harness.subject == number);
        let mine: Vec<_> = mine.collect();
        let worst = mine.iter().map(|c| verdict(c)).max_by_key(|v| v.outcome().code());
        Status::Run {
            verdict: worst.unwrap_or(Verdict::Inconclusive("no harness was run".to_owned())),
            scope: format!(
                "{} harnesses within their bounds (`cargo xtask kani --list`)",
                mine.len()
            ),
            seconds: mine.iter().filter_map(|c| c.finding.seconds).sum(),
        }
    }

    fn problems(&self) -> Vec<Verdict> {
        let Some(Ok(report)) = self.ran.get() else { return Vec::new() };
        let theorems = Theorem::ALL.map(|t| t.number());
        let others = report.harnesses.iter().filter(|c| !theorems.contains(&c.harness.subject));
        let unexpected = report
            .unexpected
            .iter()
            .map(|name| Verdict::Rejected(format!("{name}: reported by Kani, and in no list")));
        others.map(verdict).filter(|v| *v != Verdict::Holds).chain(unexpected).collect()
    }
}
