//! Claims about systems in continuous time, by ellipsoids that no run leaves.
//!
//! A run is inside of (x - c)' Q^-1 (x - c) <= 1. For a fixed decay the condition that it stays inside is a linear matrix
//! inequality in Q and c together (`proofs/checker/src/ellipsoid.rs` has it), at each end of each input's range; so is the
//! start. A claim g takes g(c) >= sqrt(l'Ql), which is implied by g(c) >= (m + l'Ql/m)/2 and, where m is the root itself, no more:
//! a few rounds with m from the round before. Where modes act in turn, or each for some time at least, c and Q move
//! straight between ellipsoids at fixed times.

mod barrier;
mod inequalities;
mod plan;
mod rounded;

use serde_json::Value;

use cordon_core::exact::to_f64;
use cordon_core::linear::simplest::strictly_between;
use cordon_core::system::{Flow, Switching};
use cordon_core::{Rational, Result};
use inequalities::Search;
use plan::Plan;
use rounded::rounded;

/// Most ellipsoids that one invariant may have.
const MOST_NODES: usize = 200;

/// The claims about a system in continuous time, proved.
#[derive(Clone, Debug)]
pub struct Invariant {
    /// The certificate, accepted by the checker.
    pub certificate: Value,
    /// Number of ellipsoids in the certificate.
    pub ellipsoids: usize,
    /// By how much every claim could be stronger: with all of them as much stronger, the certificate is accepted too.
    pub spare: Rational,
}

/// How a search ended.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The claims hold, and here is the invariant.
    Proved(Box<Invariant>),
    /// With ellipsoids, in doubles, in which the worst claim is missed by so much: its place and that.
    Missed(usize, f64),
    /// No invariant of this kind was found, which decides nothing.
    Open,
}

/// What was found in doubles for a decay.
struct Attempt {
    worst: usize,
    margin: f64,
    part: f64,
    decay: Rational,
    x: Vec<f64>,
}

/// Ellipsoids on the way, while a mode acts for a time: few first.
const PARTS: [usize; 3] = [2, 4, 8];

/// The decays that are tried, as parts of what the slowest mode allows.
const DECAYS: [f64; 6] = [0.3, 0.45, 0.15, 0.6, 0.75, 0.9];

/// Searches ellipsoids that show the claims.
///
/// # Errors
/// The system is too large, its starts are no box, or it claims an equation.
pub fn prove(flow: &Flow) -> Result<Answer> {
    let search = Search::new(flow)?;
    let slowest = search.slowest();
    if slowest >= 0.0 {
        return Ok(Answer::Open);
    }
    let parts: &[usize] = if flow.switching == Switching::Any { &PARTS[..1] } else { &PARTS };
    let mut best: Option<(usize, f64)> = None;
    for parts in parts {
        let plan = Plan::of(flow, *parts);
        if plan.names.len() > MOST_NODES {
            break;
        }
        let mut tried: Vec<Attempt> = Vec::new();
        let rounds = if plan.names.len() == 1 { 3 } else { 2 };
        let attempt = |part: f64, tried: &mut Vec<Attempt>| {
            // A simple one near by, the same in doubles and in the certificate.
            let near = |to: f64| Rational::from_float(-2.0 * slowest * part * to);
            let decay = near(0.98).zip(near(1.02)).and_then(|(a, b)| strictly_between(&a, &b))?;
            let x = search.solve(&plan, to_f64(&decay), rounds)?;
            let (worst, margin) = search.margin(&plan, &x);
            tried.push(Attempt { worst, margin, part, decay, x });
            Some(())
        };
        // Many ellipsoids are slow: the middle of the decays, and enough where it holds.
        let decays = if plan.names.len() == 1 { &DECAYS[..] } else { &DECAYS[..2] };
        for part in decays {
            attempt(*part, &mut tried);
            if plan.names.len() > 1 && tried.last().is_some_and(|a| a.margin > 0.0) {
                break;
            }
        }
        let largest = |a: &Attempt, b: &Attempt| b.margin.total_cmp(&a.margin);
        tried.sort_by(largest);
        if let (1, Some(part)) = (plan.names.len(), tried.first().map(|a| a.part)) {
            for near in [part - 0.07, part + 0.07] {
                attempt(near, &mut tried);
            }
            tried.sort_by(largest);
        }
        let Some(found) = tried.first() else { continue };
        if best.is_none_or(|(_, margin)| found.margin > margin) {
            best = Some((found.worst, found.margin));
        }
        if found.margin > 0.0
            && let Some(found) = rounded(&search, &plan, found)?
        {
            return Ok(Answer::Proved(Box::new(found)));
        }
    }
    Ok(best.map_or(Answer::Open, |(worst, margin)| Answer::Missed(worst, -margin)))
}
