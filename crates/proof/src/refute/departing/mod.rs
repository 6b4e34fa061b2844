//! Steps in which drones skip their update, or see old positions of their neighbours: as a system
//! derived by executing the spec's own functions, and searched by the claims engine.

mod facing;
mod order;
mod swarm;
mod unchanging;

pub use order::{Order, crossing, order};

use cordon_spec::theorems::{Form, Theorem};
use num_traits::Zero;

use super::{Coverage, SearchResult, SearchSpace, is_conjunction};
use crate::claims::WORK;
use crate::counterexample::Counterexample;
use cordon_core::{Error, Rational, Result, progress};
use swarm::Swarm;

/// How steps may depart from the protocol as written, independently in each step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Departures {
    /// Any drone may skip its update.
    Skips,
    /// Each drone may see each neighbour as it was up to this many steps ago, but never before the
    /// start.
    Late(usize),
}

/// Whether the conclusion concerns a single placement and consists of comparisons, so that it is a
/// claim.
pub fn is_claim(theorem: Theorem, form: Form) -> bool {
    is_conjunction(theorem) && theorem.span(form, 3) == 0
}

/// Searches over all departures of every step: the smallest counterexample with constant delays and,
/// failing that, the smallest of all.
///
/// # Errors
/// The theorem concerns several placements, or drones and delays need more variables than a system may
/// have.
pub fn search(space: &SearchSpace, departures: Departures) -> Result<SearchResult> {
    let number = space.theorem.number();
    if !is_claim(space.theorem, space.form) {
        return Err(Error::input(format!(
            "theorem: `{number}` with skipped updates or stale messages: expected 7.2, 7.3 or 7.4i"
        )));
    }
    let mut covered = Vec::new();
    for &count in &space.drones {
        let swarm = |eps: &Rational| Swarm { count, eps: eps.clone(), departures };
        swarm(&Rational::zero()).fits()?;
        let weights = space.weights_for(count);
        // The simplest first: constant delays.
        let mut best: Option<Counterexample> = None;
        for eps in &weights {
            best = swarm(eps).unchanging_counterexample(space, best);
            progress::advance(1);
        }
        if best.is_some() {
            return Ok(SearchResult { found: best, covered });
        }
        let mut left = WORK;
        let mut others = weights.len() as u64;
        for eps in weights {
            let deepest = match &best {
                None => space.steps,
                Some(found) if found.step == 0 => break,
                Some(found) => found.step - 1,
            };
            // What earlier weights leave of the budget, the remaining ones share.
            let mut work = left / others;
            others -= 1;
            left -= work;
            let (found, extent) = swarm(&eps).counterexample(space, deepest, &mut work)?;
            left += work;
            best = found.or(best);
            covered.push(Coverage { count, eps, extent });
            progress::advance(space.pieces_of_one() - 1);
        }
        if best.is_some() {
            covered.retain(|c| c.count < count);
            return Ok(SearchResult { found: best, covered });
        }
    }
    Ok(SearchResult { found: None, covered })
}
