//! `--protocol FILE` of `cordon prove` and `cordon refute`: a user's own linear protocol.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::select::OutputFormat;
use super::table::{self, abridged};
use cordon_core::exact::fraction;
use cordon_core::text::shell_word;
use cordon_core::{Error, Evidence, Outcome, Rational, Result};
use cordon_proof::certificate;
use cordon_proof::counterexample::list;
use cordon_proof::own_protocol::prove::{InductiveProof, is_vacuous, prove as find_proof};
use cordon_proof::own_protocol::refute::{Run, check, refute as find_run, weights};
use cordon_proof::own_protocol::{OwnProtocol, read};

/// Where to search for a counterexample.
#[derive(Clone, Debug)]
pub struct Search {
    /// These weights in place of the protocol's own.
    pub weights: Option<Vec<Rational>>,
    /// Of a range of weights, the fractions with denominators up to this.
    pub denominators: u32,
    /// Last step.
    pub steps: usize,
    /// Only the run from this start.
    pub start: Option<Vec<Rational>>,
}

impl Default for Search {
    /// What follows where no proof is found: the weights with small denominators, some steps.
    fn default() -> Self {
        Self { weights: None, denominators: 8, steps: 8, start: None }
    }
}

/// Proves the claims of a protocol file, or refutes them, or says that it can do neither.
///
/// # Errors
/// The file is wrong, or a certificate cannot be written.
pub fn prove(
    path: &Path,
    folder: Option<&Path>,
    search: &Search,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let protocol = read_sensible(path)?;
    if let Some(proof) = find_proof(&protocol) {
        for (_, found) in &proof.certificates {
            certificate::judged(found)?;
        }
        let files = match folder {
            Some(folder) => write_all(path, folder, &proof)?,
            None => Vec::new(),
        };
        match format {
            OutputFormat::Text => proved(&protocol, &proof, &files, out)?,
            OutputFormat::Json => {
                let page = json!({
                    "schema": "cordon-own-protocol/1",
                    "title": protocol.title,
                    "proved": true,
                    "evidence": Evidence::Inductive,
                    "eps": protocol.eps.as_ref().map(|(lo, hi)| [fraction(lo), fraction(hi)]),
                    "half_spaces": proof.half_spaces,
                    "claimed": proof.claimed,
                    "files": files,
                });
                writeln!(out, "{page:#}")?;
            }
        }
        return Ok(Outcome::Holds);
    }
    search_run(&protocol, path, search, format, out)
}

/// Searches for a counterexample to the claims of a protocol file.
///
/// # Errors
/// The file or the start is wrong.
pub fn refute(
    path: &Path,
    search: &Search,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    search_run(&read_sensible(path)?, path, search, format, out)
}

fn read_sensible(path: &Path) -> Result<OwnProtocol> {
    let protocol = read(path)?;
    if is_vacuous(&protocol) {
        return Err(Error::input(format!(
            "{}: start: no start meets the assumptions: expected one that does",
            path.display()
        )));
    }
    Ok(protocol)
}

fn search_run(
    protocol: &OwnProtocol,
    path: &Path,
    search: &Search,
    format: OutputFormat,
    out: &mut dyn Write,
) -> Result<Outcome> {
    let weights = match &search.weights {
        Some(weights) => weights.clone(),
        None => weights(protocol, search.denominators),
    };
    let found = match &search.start {
        Some(start) => {
            if start.len() != protocol.count {
                return Err(Error::input(format!(
                    "start: {} positions: expected {}, one a drone",
                    start.len(),
                    protocol.count
                )));
            }
            if let Some(broken) = protocol.starts.iter().find(|c| !c.holds(start)) {
                return Err(Error::input(format!(
                    "start: does not meet `{}`: expected a start that the protocol assumes",
                    broken.text
                )));
            }
            weights.iter().find_map(|eps| check(protocol, eps, start, search.steps))
        }
        None => find_run(protocol, &weights, search.steps),
    };
    match format {
        OutputFormat::Text => {
            header(protocol, search.weights.is_some(), out)?;
            match &found {
                Some(run) => refuted(protocol, path, run, out)?,
                None => not_refuted(search, &weights, out)?,
            }
        }
        OutputFormat::Json => {
            let page = json!({
                "schema": "cordon-own-protocol/1",
                "title": protocol.title,
                "proved": false,
                "counterexample": found.as_ref().map(|run| as_json(protocol, path, run)),
                "weights": weights.iter().map(fraction).collect::<Vec<_>>(),
                "steps": search.steps,
                "starts": if search.start.is_some() { "given" } else { "every" },
            });
            writeln!(out, "{page:#}")?;
        }
    }
    Ok(if found.is_some() { Outcome::Refuted } else { Outcome::Inconclusive })
}

/// Other weights than the protocol's own may be searched: then nothing is said of those.
fn header(protocol: &OwnProtocol, other_weights: bool, out: &mut dyn Write) -> Result<()> {
    let drones = if protocol.count == 1 { "drone" } else { "drones" };
    write!(out, "{}: {} {drones}, ", protocol.title, protocol.count)?;
    if other_weights {
        writeln!(out, "at the given eps (the protocol's own: {})", range(protocol))?;
    } else {
        writeln!(out, "{}", range(protocol))?;
    }
    Ok(())
}

fn range(protocol: &OwnProtocol) -> String {
    match &protocol.eps {
        None => "no eps".to_owned(),
        Some((lo, hi)) if lo == hi => format!("eps = {}", fraction(lo)),
        Some((lo, hi)) => format!("every eps in [{}, {}]", fraction(lo), fraction(hi)),
    }
}

fn proved(
    protocol: &OwnProtocol,
    proof: &InductiveProof,
    files: &[String],
    out: &mut dyn Write,
) -> Result<()> {
    header(protocol, false, out)?;
    writeln!(out, "  proved: the claims hold at every step from every assumed start")?;
    let weights: Vec<String> = proof.certificates.iter().map(|(eps, _)| fraction(eps)).collect();
    let at = match weights.as_slice() {
        [lo, hi] => format!(" at eps = {lo} and {hi}, so between"),
        _ => String::new(),
    };
    writeln!(
        out,
        "  {}: {} half-space{}, {} of them claimed, each kept by a step{at} ({})",
        Evidence::Inductive,
        proof.half_spaces,
        if proof.half_spaces == 1 { "" } else { "s" },
        proof.claimed,
        Evidence::Certified
    )?;
    writeln!(
        out,
        "  base: every assumed start meets them (exact multipliers; the certificates are about the step)"
    )?;
    for file in files {
        writeln!(out, "  wrote {file}")?;
    }
    Ok(())
}

fn refuted(protocol: &OwnProtocol, path: &Path, run: &Run, out: &mut dyn Write) -> Result<()> {
    writeln!(
        out,
        "  refuted at eps = {}: `{}` fails at step {}",
        fraction(&run.eps),
        claim_text(protocol, run),
        run.step
    )?;
    table::placements(&run.placements, out)?;
    writeln!(out, "  replay: {}", replay_line(path, run))?;
    Ok(())
}

fn not_refuted(search: &Search, weights: &[Rational], out: &mut dyn Write) -> Result<()> {
    let mut weights: Vec<&Rational> = weights.iter().collect();
    weights.sort();
    let weights: Vec<String> = weights.into_iter().map(fraction).collect();
    let which = if search.start.is_some() {
        "from this start"
    } else {
        Evidence::CompleteForAllStarts.text()
    };
    writeln!(
        out,
        "  not refuted: no counterexample up to step {} at eps = {}: {which}",
        search.steps,
        abridged(&weights)
    )?;
    Ok(())
}

fn claim_text<'p>(protocol: &'p OwnProtocol, run: &Run) -> &'p str {
    protocol.claims.get(run.claim).map_or("", |c| c.text.as_str())
}

fn replay_line(path: &Path, run: &Run) -> String {
    let start = run.placements.first().map_or_else(String::new, |x| list(x));
    format!(
        "cordon refute --protocol {} --eps {} --steps {} --start={start}",
        shell_word(&path.display().to_string()),
        fraction(&run.eps),
        run.step,
    )
}

fn as_json(protocol: &OwnProtocol, path: &Path, run: &Run) -> Value {
    let placements: Vec<Vec<String>> =
        run.placements.iter().map(|x| x.iter().map(fraction).collect()).collect();
    json!({
        "eps": fraction(&run.eps),
        "step": run.step,
        "claim": claim_text(protocol, run),
        "run": placements,
        "replay": replay_line(path, run),
    })
}

fn write_all(path: &Path, folder: &Path, proof: &InductiveProof) -> Result<Vec<String>> {
    let stem = path.file_stem().map_or_else(|| "own".into(), |s| s.to_string_lossy());
    let ends = ["low", "high"];
    let named = proof.certificates.iter().zip(ends).map(|((_, c), end)| {
        let name = match proof.certificates.len() {
            1 => stem.to_string(),
            _ => format!("{stem}-{end}"),
        };
        Ok(certificate::write(folder, &name, c)?.display().to_string())
    });
    named.collect()
}
