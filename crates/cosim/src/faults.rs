//! Links that lose or delay messages. All random choices derive from the scenario's seed.

use std::collections::VecDeque;
use std::ops::Range;

use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive};

use super::grid::Grid;
use super::unit::Value;
use super::wiring::Link;
use cordon_core::exact::Rational;
use cordon_core::random::SplitMix;
use cordon_core::{Error, Result};
use cordon_run::scenario::{Fault, FaultKind};

/// The faults of a connection, applied to each message one after the other.
pub(super) struct Chain(Vec<Box<dyn Link>>);

impl Link for Chain {
    fn carry(&mut self, step: u64, value: &Value) -> Option<Value> {
        self.0.iter_mut().try_fold(value.clone(), |v, link| link.carry(step, &v))
    }
}

/// Loses each message with a given probability, independently of all others.
struct Loss {
    /// A message is lost where its random 64 bits are below this.
    below: u128,
    /// Of this link alone.
    seed: u64,
    steps: Range<u64>,
}

impl Link for Loss {
    fn carry(&mut self, step: u64, value: &Value) -> Option<Value> {
        let drawn = mixed(self.seed ^ mixed(step));
        let lost = self.steps.contains(&step) && u128::from(drawn) < self.below;
        (!lost).then(|| value.clone())
    }
}

/// Delivers each message some steps after it was sent; before the first one arrives, the value that was
/// sent first.
struct Delay {
    by: u64,
    steps: Range<u64>,
    /// Messages not yet superseded: when each was sent, and its value.
    under_way: VecDeque<(u64, Value)>,
}

impl Link for Delay {
    fn carry(&mut self, step: u64, value: &Value) -> Option<Value> {
        self.under_way.push_back((step, value.clone()));
        if !self.steps.contains(&step) {
            // Messages under way are kept: the delay may begin later.
            while self.under_way.front().is_some_and(|(sent, _)| sent + self.by < step) {
                self.under_way.pop_front();
            }
            return Some(value.clone());
        }
        while self.under_way.get(1).is_some_and(|(sent, _)| sent + self.by <= step) {
            self.under_way.pop_front();
        }
        self.under_way.front().map(|(_, v)| v.clone())
    }
}

/// A bijection of 64-bit numbers that mixes all bits. It is evaluated at the message's index instead of
/// in sequence, so that a message's fate does not depend on how many others there are.
fn mixed(x: u64) -> u64 {
    SplitMix::new(x).bits()
}

/// A fault on links.
struct OnLinks {
    /// Its number in the scenario, from 1.
    number: usize,
    fault: Fault,
    steps: Range<u64>,
}

/// The faults of a scenario on the grid of its run.
pub(super) struct Plan {
    /// The faults of messages, in the order of the scenario.
    on_links: Vec<OnLinks>,
    /// Which drones are out of order, and when.
    pub(super) drop_outs: Vec<(usize, Range<u64>)>,
    seed: u64,
}

impl Plan {
    /// Checks the faults of `count` drones.
    ///
    /// # Errors
    /// A drone that does not exist, a probability beyond 1, a time that is no grid point.
    pub(super) fn new(faults: &[Fault], seed: u64, count: usize, grid: &Grid) -> Result<Self> {
        let mut plan = Self { on_links: Vec::new(), drop_outs: Vec::new(), seed };
        for (index, fault) in faults.iter().enumerate() {
            let fail = |what: String| Error::input(format!("fault {}: {what}", index + 1));
            let steps = window(fault, grid).map_err(&fail)?;
            let exists = |drone: usize| {
                let what = format!("drone `{drone}`: expected 0 to {}", count - 1);
                if drone < count { Ok(()) } else { Err(fail(what)) }
            };
            match &fault.kind {
                FaultKind::DropOut { drone } => {
                    exists(*drone)?;
                    plan.drop_outs.push((*drone, steps));
                    continue;
                }
                FaultKind::Loss { link, probability } => {
                    if probability.is_negative() || *probability > Rational::from_integer(1.into())
                    {
                        return Err(fail(format!(
                            "probability: `{probability}`: expected a number from 0 to 1"
                        )));
                    }
                    link.iter().try_for_each(|(i, j)| exists(*i).and(exists(*j)))?;
                }
                FaultKind::Delay { link, .. } => {
                    link.iter().try_for_each(|(i, j)| exists(*i).and(exists(*j)))?;
                }
            }
            plan.on_links.push(OnLinks { number: index + 1, fault: fault.clone(), steps });
        }
        Ok(plan)
    }

    /// Whether some fault on a link names two drones that are not linked: a mistake in the scenario.
    ///
    /// # Errors
    /// There is such a fault.
    pub(super) fn check_links(&self, linked: impl Fn(usize, usize) -> bool) -> Result<()> {
        for OnLinks { number, fault, .. } in &self.on_links {
            let (FaultKind::Loss { link, .. } | FaultKind::Delay { link, .. }) = &fault.kind else {
                continue;
            };
            if let Some((i, j)) = link.filter(|(i, j)| !linked(*i, *j)) {
                return Err(Error::input(format!(
                    "fault {number}: link `[{i}, {j}]`: expected two drones that exchange positions"
                )));
            }
        }
        Ok(())
    }

    /// The faults of messages from drone `from` to drone `to`, if any.
    pub(super) fn link(&self, from: usize, to: usize) -> Option<Chain> {
        let mut chain: Vec<Box<dyn Link>> = Vec::new();
        for (index, OnLinks { fault, steps, .. }) in self.on_links.iter().enumerate() {
            let concerns = |link: &Option<(usize, usize)>| link.is_none_or(|l| l == (from, to));
            match &fault.kind {
                FaultKind::Loss { link, probability } if concerns(link) => {
                    let ends = [index, from, to].into_iter();
                    let seed = ends.fold(self.seed, |seed, n| mixed(seed ^ mixed(n as u64)));
                    let scaled = probability * Rational::from_integer(BigInt::from(1u8) << 64u8);
                    // At most 2^64, which fits.
                    let below = scaled.to_integer().to_u128().unwrap_or(u128::MAX);
                    chain.push(Box::new(Loss { below, seed, steps: steps.clone() }));
                }
                FaultKind::Delay { link, ticks } if concerns(link) => {
                    chain.push(Box::new(Delay {
                        by: u64::from(*ticks),
                        steps: steps.clone(),
                        under_way: VecDeque::new(),
                    }));
                }
                _ => {}
            }
        }
        (!chain.is_empty()).then_some(Chain(chain))
    }
}

/// The steps in which a fault is active.
fn window(fault: &Fault, grid: &Grid) -> std::result::Result<Range<u64>, String> {
    let step = |name: &str, time: &Option<Rational>, default: u64| match time {
        None => Ok(default),
        Some(seconds) => grid.steps_in(seconds).ok_or_else(|| {
            format!(
                "{name}: `{seconds}`: expected a whole multiple of the step tau, which is `{}` s",
                grid.tau()
            )
        }),
    };
    let (from, until) = (step("from", &fault.from, 0)?, step("until", &fault.until, u64::MAX)?);
    if from < until {
        Ok(from..until)
    } else {
        Err("until: expected a time after `from`".to_owned())
    }
}
