//! Certificates as JSON, in the format `cordon-certificate/2` (`proofs/checker/FORMAT.md`).
//!
//! Only writing is done here; what a certificate is worth, the independent checker says.

pub mod invariance;
pub mod linear;
pub mod quadratic;
pub mod runs;
pub mod theorem;
pub mod weights;

use std::path::{Path, PathBuf};

use cordon_check::Verdict;
use cordon_check::format::MAX_BYTES;
use cordon_check::number::MAX_NUMBER;
use cordon_spec::theorems::Subject;
use num_bigint::BigInt;
use serde_json::{Value, json};

use crate::counterexample::Counterexample;
use cordon_core::exact::fraction;
use cordon_core::{Error, Rational, Result, files};

/// Name and version of the format.
pub const SCHEMA: &str = "cordon-certificate/2";

/// A certificate of that kind.
pub fn sealed(kind: &str, body: Value) -> Value {
    json!({ "schema": SCHEMA, "certificate": { kind: body } })
}

fn numbers(x: &[Rational]) -> Vec<String> {
    x.iter().map(fraction).collect()
}

/// Convergence for one N and one eps: |A| w <= rate w.
pub fn contraction(count: usize, eps: &Rational, rate: &Rational, w: &[BigInt]) -> Value {
    let vector: Vec<String> = w.iter().map(ToString::to_string).collect();
    sealed(
        "contraction",
        json!({ "drones": count, "eps": fraction(eps), "rate": fraction(rate), "vector": vector }),
    )
}

/// No convergence for one N and one eps: |A| w >= w.
pub fn growth(count: usize, eps: &Rational, w: &[BigInt]) -> Value {
    let vector: Vec<String> = w.iter().map(ToString::to_string).collect();
    sealed("growth", json!({ "drones": count, "eps": fraction(eps), "vector": vector }))
}

/// How a run departs from the protocol as written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Departure {
    /// Not at all: all drones update, and see where the others are.
    #[default]
    None,
    /// In each step only these drones update.
    Activation(Vec<Vec<usize>>),
    /// In each step drone i sees drone j as it was `age` steps ago, for the listed (i, j, age).
    Delay(Vec<Vec<(usize, usize, usize)>>),
}

/// What a violated conclusion is about, and where.
pub fn subject(step: usize, subject: Subject) -> Value {
    match subject {
        Subject::Pair(i) => json!({ "step": step, "subject": "pair", "at": i }),
        Subject::Drone(i) => json!({ "step": step, "subject": "drone", "at": i }),
        Subject::Sum => json!({ "step": step, "subject": "sum" }),
        Subject::Energy => json!({ "step": step, "subject": "energy" }),
    }
}

/// A run that violates a theorem, or an extension of it to other weights or other steps.
pub fn refutation(found: &Counterexample) -> Value {
    let start = found.start();
    let mut body = json!({
        "theorem": found.theorem.number(),
        "form": found.form.label(),
        "min": start.first().map(fraction),
        "max": start.last().map(fraction),
        "eps": fraction(&found.eps),
        "start": numbers(start),
        "step": found.step,
        "violation": subject(found.violation.step, found.violation.subject),
    });
    if let Some(fields) = body.as_object_mut() {
        if !found.weight_is_in_range() {
            fields.insert("weights".to_owned(), json!("any"));
        }
        match &found.departure {
            Departure::None => {}
            Departure::Activation(steps) => {
                fields.insert("activation".to_owned(), json!(steps));
            }
            Departure::Delay(steps) => {
                let late = |&(drone, sees, age): &(usize, usize, usize)| json!({ "drone": drone, "sees": sees, "age": age });
                let steps: Vec<Vec<Value>> =
                    steps.iter().map(|s| s.iter().map(late).collect()).collect();
                fields.insert("delay".to_owned(), json!(steps));
            }
        }
    }
    sealed("refutation", body)
}

/// Has the independent checker judge a certificate: what is proved, in the checker's words.
/// Nothing is called certified before this.
///
/// # Errors
/// [`Error::Input`]: a number or the whole is longer than the checker reads, or takes more work
/// than it allows. [`Error::Rejected`]: the checker finds it wrong.
pub fn judged(certificate: &Value) -> Result<String> {
    let text = certificate.to_string();
    let is_of_number = |c: char| c.is_ascii_digit() || c == '/';
    if text.split(|c| !is_of_number(c)).any(|number| number.len() > MAX_NUMBER) {
        return Err(beyond(&format!("a number of more than {MAX_NUMBER} characters")));
    }
    match cordon_check::check(&text) {
        Verdict::Valid { claim, .. } => Ok(claim),
        // What is written here is in the format: only its size can be at fault.
        Verdict::Unreadable { reason } => Err(beyond(&reason)),
        Verdict::Invalid { rule: "work", .. } => Err(beyond(
            "it takes more work than a file is allowed: fewer drones, steps or digits take less",
        )),
        verdict @ Verdict::Invalid { .. } => Err(Error::Rejected(verdict.to_string())),
    }
}

fn beyond(limit: &str) -> Error {
    Error::input(format!("what was found is beyond the limits of the independent checker: {limit}"))
}

/// Writes a certificate to `folder/name.json`, creating the folder, and returns the path.
///
/// # Errors
/// The folder cannot be created or written.
pub fn write(folder: &Path, name: &str, certificate: &Value) -> Result<PathBuf> {
    std::fs::create_dir_all(folder).map_err(|e| Error::file("create", folder, e))?;
    let path = folder.join(format!("{name}.json"));
    write_file(&path, certificate)?;
    Ok(path)
}

/// Writes a certificate to a file, and returns its path as text: on lines, where that is no longer than the checker reads.
///
/// # Errors
/// The file cannot be written.
pub fn write_file(path: &Path, certificate: &Value) -> Result<String> {
    let mut text = format!("{certificate:#}\n");
    if text.len() > MAX_BYTES {
        text = format!("{certificate}\n");
    }
    files::write_atomically(path, text.as_bytes())?;
    Ok(path.display().to_string())
}
