//! Inductive steps, proved by an SMT solver.

use std::io::Write;
use std::process::{Command, Stdio};
use std::time::Instant;

use cordon_spec::theorems::{Form, Theorem};

use super::{Evidence, Status, Tier, TierVerdict};
use cordon_proof::export::conjecture::Conjecture;
use cordon_proof::export::smt_model::{Response, read_answer};
use cordon_proof::export::smt2::{Query, WeightDomain, obligations};

/// The tier: z3, if it is on PATH.
#[derive(Clone, Copy, Debug)]
pub struct Smt;

/// The numbers of drones.
const DRONES: std::ops::RangeInclusive<usize> = 3..=6;

/// Time limit of one query, in seconds. All of them together take about two.
const SECONDS: u32 = 30;

/// The solver that is called.
const SOLVER: &str = "z3";

impl Tier for Smt {
    fn name(&self) -> &'static str {
        "smt"
    }

    fn kind(&self) -> Evidence {
        Evidence::InductivePerCount
    }

    fn tool(&self) -> String {
        version().unwrap_or_else(|| SOLVER.to_owned())
    }

    fn sources(&self) -> &'static [&'static str] {
        &["spec/src", "crates/proof/src/export"]
    }

    fn status(&self, theorem: Theorem) -> Status {
        let claim = Conjecture::Theorem(theorem);
        if !Conjecture::ALL.contains(&claim) {
            return Status::NotClaimed("a limit has no inductive step".into());
        }
        if version().is_none() {
            return Status::NotRun(format!("`{SOLVER}` is not on PATH"));
        }
        let started = Instant::now();
        let queries: Vec<_> = DRONES
            .flat_map(|n| obligations(claim, Form::Sharp, n, &WeightDomain::OfHypothesis))
            .collect();
        let verdict = queries.iter().map(solve).find(|v| *v != TierVerdict::Holds);
        let (first, last) = (DRONES.start(), DRONES.end());
        let scope = format!(
            "N = {first}..{last}, all eps in its range, all starts, all k: {} obligations",
            queries.len()
        );
        Status::Run {
            verdict: verdict.unwrap_or(TierVerdict::Holds),
            scope,
            seconds: started.elapsed().as_secs_f64(),
        }
    }
}

/// The solver's name and version, if it is installed.
fn version() -> Option<String> {
    let out = Command::new(SOLVER).arg("--version").output().ok()?;
    let text = String::from_utf8(out.stdout).ok()?;
    out.status.success().then(|| text.lines().next().unwrap_or(SOLVER).trim().to_owned())
}

fn solve(query: &Query) -> TierVerdict {
    let name = query.name();
    match ask(&query.text())
        .map_err(|e| e.to_string())
        .and_then(|text| read_answer(query, &text).map_err(|e| e.to_string()))
    {
        Ok(Response::Unsat) => TierVerdict::Holds,
        Ok(Response::Sat(_)) => TierVerdict::Refuted(format!("obligation {name} is satisfiable")),
        Ok(Response::Unknown(word)) => {
            TierVerdict::Inconclusive(format!("obligation {name}: {word}"))
        }
        Err(why) => TierVerdict::Inconclusive(format!("obligation {name}: {why}")),
    }
}

fn ask(text: &str) -> std::io::Result<String> {
    let mut child = Command::new(SOLVER)
        .args(["-in", &format!("-T:{SECONDS}")])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    if let Some(mut stdin) = child.stdin.take() {
        // The solver reads all input before it writes more than a pipe holds.
        stdin.write_all(text.as_bytes())?;
    }
    let out = child.wait_with_output()?;
    Ok(String::from_utf8_lossy(&out.stdout).into_owned())
}
