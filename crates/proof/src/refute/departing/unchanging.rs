//! Constant delays, tried by executing the spec.

use cordon_spec::State;
use cordon_spec::coverage::getx;
use cordon_spec::delay::exec_coverage_delayed;

use super::Departures;
use super::swarm::Swarm;
use crate::certificate::Departure;
use crate::counterexample::Counterexample;
use crate::refute::region::Region;
use crate::refute::{SearchSpace, params, violating_start};
use cordon_core::linear::affine::Affine;

/// Most patterns of constant delays.
const MOST_PATTERNS: usize = 10_000;

/// Most drones for which they are tried: two drones need no more around them to interact.
const MOST_DRONES: usize = 12;

impl Swarm {
    /// A counterexample with constant delays at an earlier step than the known one; otherwise the known
    /// one.
    pub(super) fn unchanging_counterexample(
        &self,
        space: &SearchSpace,
        known: Option<Counterexample>,
    ) -> Option<Counterexample> {
        self.unchanging().iter().fold(known, |best, ages| {
            let last = best.as_ref().map_or(Some(space.steps), |b| b.step.checked_sub(1));
            last.and_then(|last| self.along(space, ages, last)).or(best)
        })
    }

    /// The constant delays of each link, the smallest first. Where there are too many patterns, only
    /// two drones are late, to each other.
    fn unchanging(&self) -> Vec<Vec<usize>> {
        let Departures::Late(longest) = self.departures else { return Vec::new() };
        if self.count > MOST_DRONES {
            return Vec::new();
        }
        let links = self.links().len();
        let number = (0..links).fold(1_usize, |n, _| n.saturating_mul(longest + 1));
        let mut ages: Vec<Vec<usize>> = match number <= MOST_PATTERNS {
            true => (0..links).fold(vec![Vec::new()], |all, _| {
                let longer = |ages: Vec<usize>| {
                    (0..=longest).map(move |age| ages.iter().copied().chain([age]).collect())
                };
                all.into_iter().flat_map(longer).collect()
            }),
            // Both directions of a link are adjacent.
            false => (0..links)
                .step_by(2)
                .flat_map(|pair| (1..=longest).map(move |age| (pair, age)))
                .map(|(pair, age)| {
                    (0..links).map(|l| if l / 2 == pair / 2 { age } else { 0 }).collect()
                })
                .collect(),
        };
        ages.sort_by_key(|ages: &Vec<usize>| (ages.iter().sum::<usize>(), ages.clone()));
        ages
    }

    /// The first counterexample up to step `last` with these delays of the links.
    fn along(&self, space: &SearchSpace, ages: &[usize], last: usize) -> Option<Counterexample> {
        let (theorem, form) = (space.theorem, space.form);
        let set = theorem.hypothesis(form).starts;
        let region = Region::of(set, self.count);
        let params = params(&self.eps, Affine::constant);
        let links = self.links();
        let age = |t: usize, i: usize, j: usize| {
            let link = links.iter().position(|&link| link == (i, j));
            link.and_then(|index| ages.get(index)).map_or(0, |&age| age.min(t))
        };
        let stale = |t: usize| {
            let mut all: Vec<_> = links.iter().map(|&(i, j)| (i, j, age(t, i, j))).collect();
            all.retain(|&(.., age)| age > 0);
            all.sort_unstable();
            all
        };
        let mut history: Vec<State<Vec<Affine>>> = Vec::new();
        let mut state = State { drones: region.placement(), timesteps: 0 };
        for k in 0..=last {
            let now = std::slice::from_ref(&state.drones);
            let found = violating_start(theorem, form, set, &region, &self.eps, now).0;
            let departure = || Departure::Delay((0..k).map(stale).collect());
            let replayed = found.and_then(|start| {
                let start = region.start(&start);
                Counterexample::replay_departing(theorem, form, &self.eps, start, k, departure())
            });
            if replayed.is_some() {
                return replayed;
            }
            history.push(state);
            let present = history.last()?;
            let seen =
                |i: usize, j: usize| getx(history.get(k - age(k, i, j)).unwrap_or(present), j);
            state = exec_coverage_delayed(&params, present, seen);
        }
        None
    }
}
