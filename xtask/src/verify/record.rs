//! Records of runs: what was verified, by which tool, for which sources.

use std::path::{Path, PathBuf};

use cordon_spec::theorems::Theorem;
use serde::{Deserialize, Serialize};
use time::OffsetDateTime;

use super::{Status, Tier, TierVerdict, model_checked, sources};
use cordon_core::{Error, Result, files};

/// The file, below the repository's root.
const FILE: &str = "proofs/records.json";

/// Version of its format.
const SCHEMA: &str = "cordon-records/1";

/// The records of the repository, at most one per tier.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Records {
    schema: String,
    records: Vec<Record>,
}

/// One run of a tier.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// Name of the tier.
    pub tier: String,
    /// The tool that ran, with its version.
    pub tool: String,
    /// Date in UTC: `2026-01-31`.
    pub date: String,
    /// Hash of the sources at that time.
    pub sources: String,
    /// Its results for each theorem.
    pub theorems: Vec<Entry>,
}

/// The result of a run for one theorem.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// The theorem's number, like `7.4ii`.
    pub number: String,
    /// The result: `holds`, `refuted`, `rejected` or `inconclusive`.
    pub result: Found,
    /// The coverage, or why it was not accepted.
    pub scope: String,
    /// Duration in seconds, to a tenth.
    pub seconds: f64,
}

/// A verdict, in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Found {
    /// The theorem holds there.
    Holds,
    /// A counterexample was found.
    Refuted,
    /// A certificate or proof was not accepted.
    Rejected,
    /// The tool gave no answer.
    Inconclusive,
}

impl Entry {
    /// The verdict, with the recorded words.
    pub fn verdict(&self) -> TierVerdict {
        let said = self.scope.clone();
        match self.result {
            Found::Holds => TierVerdict::Holds,
            Found::Refuted => TierVerdict::Refuted(said),
            Found::Rejected => TierVerdict::Rejected(said),
            Found::Inconclusive => TierVerdict::Inconclusive(said),
        }
    }
}

impl Records {
    /// The repository's records, including that of the model checker, which is a separate file; none if
    /// there is no file.
    ///
    /// # Errors
    /// A file that is not a record file of this version.
    pub fn read(root: &Path) -> Result<Self> {
        let mut records = Self::read_own(root)?;
        records.records.extend(model_checked::recorded(root)?);
        Ok(records)
    }

    fn read_own(root: &Path) -> Result<Self> {
        let path = root.join(FILE);
        if !path.exists() {
            return Ok(Self { schema: SCHEMA.to_owned(), records: Vec::new() });
        }
        let records: Self = serde_json::from_str(&files::read_text(&path, files::Limit::RECORD)?)
            .map_err(|e| {
            let (line, column) = (e.line(), e.column());
            Error::input(format!("{}:{line}:{column}: expected records: {e}", path.display()))
        })?;
        if records.schema != SCHEMA {
            return Err(Error::input(format!(
                "{}: schema `{}`: expected `{SCHEMA}`",
                path.display(),
                records.schema
            )));
        }
        Ok(records)
    }

    /// The record of a tier.
    pub fn of(&self, tier: &str) -> Option<&Record> {
        self.records.iter().find(|r| r.tier == tier)
    }

    /// Runs the tier on the theorems and writes the results into the repository's records, replacing
    /// the tier's previous record.
    ///
    /// # Errors
    /// The tier cannot run or keeps its own record, or the file cannot be written.
    pub fn record(mut self, root: &Path, tier: &dyn Tier, theorems: &[Theorem]) -> Result<PathBuf> {
        if tier.name() == model_checked::NAME {
            return Err(Error::input(format!(
                "--record: `kani`: expected `cargo xtask kani --out {}`, which writes its record",
                model_checked::RECORD
            )));
        }
        // Hashed before the run: a change in the meantime makes the record stale.
        let hash = sources::hash(root, tier.sources())?;
        let mut entries = Vec::new();
        let mut reasons = Vec::new();
        for &theorem in theorems {
            match tier.status(theorem) {
                Status::Run { verdict, scope, seconds } => {
                    entries.push(entry(theorem, verdict, scope, seconds));
                }
                Status::NotRun(why) | Status::NotClaimed(why) => reasons.push(why),
            }
        }
        if entries.is_empty() {
            reasons.sort();
            reasons.dedup();
            let (name, why) = (tier.name(), reasons.join("; "));
            return Err(Error::input(format!("--record: `{name}` did not run: {why}")));
        }
        self.records.retain(|r| ![tier.name(), model_checked::NAME].contains(&r.tier.as_str()));
        self.records.push(Record {
            tier: tier.name().to_owned(),
            tool: tier.tool(),
            date: OffsetDateTime::now_utc().date().to_string(),
            sources: hash,
            theorems: entries,
        });
        self.records.sort_by(|a, b| a.tier.cmp(&b.tier));
        let path = root.join(FILE);
        let text = serde_json::to_string_pretty(&self)
            .map_err(|e| Error::internal(format!("{}: {e}", path.display())))?;
        files::write_regardless(&path, |out| Ok(writeln!(out, "{text}")?))?;
        Ok(path)
    }
}

/// The entry of a record about a theorem.
pub(super) fn entry(theorem: Theorem, verdict: TierVerdict, scope: String, seconds: f64) -> Entry {
    let (result, scope) = match verdict {
        TierVerdict::Holds => (Found::Holds, scope),
        TierVerdict::Refuted(why) => (Found::Refuted, why),
        TierVerdict::Rejected(why) => (Found::Rejected, why),
        TierVerdict::Inconclusive(why) => (Found::Inconclusive, why),
    };
    let seconds = (seconds * 10.0).round() / 10.0;
    Entry { number: theorem.number().to_owned(), result, scope, seconds }
}
