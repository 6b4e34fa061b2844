//! The report of a run, as text and as JSON.

use std::io::Write;

use cordon_kani::{Expected, Harness};
use serde::Serialize;

use super::Limits;
use super::results::{Ending, HarnessResult};
use super::tool::Kani;
use cordon_core::{Error, Outcome, Result};

/// Version of the JSON.
const SCHEMA: &str = "cordon-kani/1";

/// A harness with its result.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The harness, as the crate `cordon-kani` lists it.
    pub harness: &'static Harness,
    /// The result, read from Kani's report.
    pub finding: HarnessResult,
}

/// The result of one run of Kani.
#[derive(Clone, Debug)]
pub struct Report {
    /// The Kani that ran, with its version.
    pub kani: Kani,
    /// When, in UTC: `2026-01-31`.
    pub date: String,
    /// Hash of the sources that were checked, if they are present.
    pub sources: Option<String>,
    /// The limits of the run.
    pub limits: Limits,
    /// All selected harnesses.
    pub harnesses: Vec<Checked>,
    /// Harnesses that were reported without having been selected.
    pub unexpected: Vec<String>,
}

#[derive(Serialize)]
struct Page<'r> {
    schema: &'static str,
    kani: &'r str,
    date: &'r str,
    sources: Option<&'r str>,
    jobs: usize,
    seconds_limit: u64,
    mebibytes_limit: u64,
    expected: usize,
    proved: usize,
    harnesses: Vec<Row<'r>>,
    unexpected: &'r [String],
}

#[derive(Serialize)]
struct Row<'r> {
    name: &'r str,
    subject: &'r str,
    claim: &'r str,
    bounds: String,
    expected: &'static str,
    verdict: &'static str,
    detail: &'r str,
    checks: usize,
    covers_met: usize,
    covers: usize,
    seconds: Option<f64>,
}

/// The expected result of a harness, in a word.
pub fn expectation(harness: &Harness) -> &'static str {
    match harness.expected {
        Expected::Holds => "holds",
        Expected::Fails => "counterexample",
    }
}

impl Report {
    /// The worst result; an unexpected harness is a failure too.
    pub fn outcome(&self) -> Outcome {
        let worst = self
            .harnesses
            .iter()
            .map(|c| c.finding.verdict.outcome())
            .fold(Outcome::Holds, Outcome::worst);
        if self.unexpected.is_empty() { worst } else { worst.worst(Outcome::Rejected) }
    }

    /// The number of proved harnesses.
    pub fn proved(&self) -> usize {
        self.harnesses.iter().filter(|c| c.finding.verdict == Ending::Proved).count()
    }

    /// Writes a line for each harness, and a closing one.
    ///
    /// # Errors
    /// The output cannot be written.
    pub fn text(&self, out: &mut dyn Write) -> Result<()> {
        for Checked { harness, finding } in &self.harnesses {
            let time = finding.seconds.map_or_else(|| "-".to_owned(), |s| format!("{s:.1} s"));
            let verdict = match (finding.verdict, harness.expected) {
                (Ending::Proved, Expected::Fails) => "found",
                (verdict, _) => verdict.label(),
            };
            let (name, subject) = (harness.name, harness.subject);
            let bounds = (harness.bounds)();
            writeln!(out, "{verdict:<13} {time:>7}  {subject:<11} {name}: {bounds}")?;
            if !finding.detail.is_empty() {
                writeln!(out, "{:24}{}", "", finding.detail)?;
            }
        }
        for name in &self.unexpected {
            writeln!(out, "{:<13} {:>7}  {name}: reported, and in no list", "unexpected", "-")?;
        }
        let found = self
            .harnesses
            .iter()
            .filter(|c| {
                c.finding.verdict == Ending::Proved && c.harness.expected == Expected::Fails
            })
            .count();
        let (kani, all) = (&self.kani, self.harnesses.len());
        let proved = self.proved() - found;
        writeln!(
            out,
            "{kani}: {all} harnesses expected, {proved} proved within their bounds, {found} expected counterexamples found, {} not",
            all - proved - found
        )?;
        Ok(())
    }

    /// The run as JSON.
    ///
    /// # Errors
    /// The output cannot be written.
    pub fn json(&self, out: &mut dyn Write) -> Result<()> {
        let page = Page {
            schema: SCHEMA,
            kani: &self.kani.version,
            date: &self.date,
            sources: self.sources.as_deref(),
            jobs: self.limits.jobs,
            seconds_limit: self.limits.seconds,
            mebibytes_limit: self.limits.mebibytes,
            expected: self.harnesses.len(),
            proved: self.proved(),
            harnesses: self.harnesses.iter().map(Checked::row).collect(),
            unexpected: &self.unexpected,
        };
        let text =
            serde_json::to_string_pretty(&page).map_err(|e| Error::internal(e.to_string()))?;
        writeln!(out, "{text}")?;
        Ok(())
    }
}

impl Checked {
    fn row(&self) -> Row<'_> {
        let Self { harness, finding } = self;
        Row {
            name: harness.name,
            subject: harness.subject,
            claim: harness.claim,
            bounds: (harness.bounds)(),
            expected: expectation(harness),
            verdict: finding.verdict.label(),
            detail: &finding.detail,
            checks: finding.checks,
            covers_met: finding.covers.0,
            covers: finding.covers.1,
            seconds: finding.seconds,
        }
    }
}
