//! Whether drones keep their order when messages are late, at one weight.

use cordon_spec::theorems::{Form, Theorem};
use serde_json::Value;

use super::Departures;
use super::swarm::Swarm;
use crate::certificate::judged;
use crate::claims::Sought;
use crate::claims::certificate::certificate;
use crate::counterexample::Counterexample;
use crate::refute::SearchSpace;
use cordon_core::{Rational, Result};

/// What is known at one weight.
#[derive(Clone, Debug, PartialEq)]
pub enum Order {
    /// No drones ever meet, whatever the delays: the number of half-spaces of an invariant, and the
    /// certificate accepted by the independent checker.
    Kept(usize, Value),
    /// Two drones meet in this run.
    Lost(Counterexample),
    /// Neither was found; the reason why the search ended.
    Open(String),
}

/// The number of steps searched for a crossing.
const STEPS: usize = 60;

fn swarm(count: usize, longest: usize, eps: &Rational) -> Swarm {
    Swarm { count, eps: eps.clone(), departures: Departures::Late(longest) }
}

/// A crossing of two neighbours that are driven into each other, if there is one.
///
/// # Errors
/// Drones and delays need more variables than a system may have.
pub fn crossing(count: usize, longest: usize, eps: &Rational) -> Result<Option<Counterexample>> {
    let swarm = swarm(count, longest, eps);
    swarm.fits()?;
    // If they meet, they do so soon after the last message from before the start.
    Ok(swarm.facing(6 * longest + 20))
}

/// Whether `count` drones keep their order when each may see each neighbour up to `longest` steps late,
/// independently in each step. The search stops when `work` is used up.
///
/// # Errors
/// Drones and delays need more variables than a system may have.
pub fn order(count: usize, longest: usize, eps: &Rational, mut work: u64) -> Result<Order> {
    let swarm = swarm(count, longest, eps);
    swarm.fits()?;
    let space = SearchSpace {
        theorem: Theorem::Ordering,
        form: Form::Sharp,
        drones: vec![count],
        weights: vec![eps.clone()],
        any_weight: true,
        steps: STEPS,
    };
    let (system, found) = swarm.sought(&space, STEPS, &mut work)?;
    Ok(match found {
        Sought::Never(proof) => {
            match certificate(&system, &proof).map(|page| (judged(&page), page)) {
                Some((Ok(_), page)) => Order::Kept(proof.rows.len(), page),
                Some((Err(e), _)) => Order::Open(e.to_string()),
                None => Order::Open("the proof has no certificate".to_owned()),
            }
        }
        Sought::Fails(run) => match swarm.replayed(&space, &run) {
            Some(found) => Order::Lost(found),
            None => Order::Open("the spec does not confirm the run that was found".to_owned()),
        },
        Sought::NotUpTo(_, end) => Order::Open(end.to_string()),
    })
}
