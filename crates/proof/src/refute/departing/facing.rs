//! Drives two neighbours into each other: the left one, and all drones before it, see their neighbours
//! as far ahead as they recently were; the right one, and all beyond it, as far behind. Nothing is
//! searched, so that this works for any number of drones.

use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::{Form, Theorem};
use cordon_spec::{Params, State};
use num_traits::{One, Signed, Zero};

use super::Departures;
use super::swarm::Swarm;
use crate::certificate::Departure;
use crate::counterexample::Counterexample;
use cordon_core::Rational;
use cordon_core::linear::simplest::strictly_between;

/// Who sees whom with which delay, step by step.
type Ages = Vec<Vec<(usize, usize, usize)>>;

impl Swarm {
    /// The first crossing up to step `last` in such a run, from starts in which one gap is large and
    /// the others are zero.
    pub(super) fn facing(&self, last: usize) -> Option<Counterexample> {
        let gaps = self.count.saturating_sub(1);
        let mut best: Option<(usize, Counterexample)> = None;
        for wide in 0..gaps {
            let start: Vec<Rational> = (0..self.count)
                .map(|i| if i <= wide { Rational::zero() } else { Rational::one() })
                .collect();
            for pair in 1..gaps.saturating_sub(1) {
                let last = best.as_ref().map_or(last, |(step, _)| step.saturating_sub(1));
                let found = self.driven(&start, pair, last);
                let found = found.and_then(|(step, ages)| {
                    Some((step, self.started_inside(&start, pair, step, ages)?))
                });
                best = found.or(best);
            }
        }
        best.map(|(_, found)| found)
    }

    /// The step up to `last` at which the drones of a pair swap places, and the ages up to then.
    fn driven(&self, start: &[Rational], pair: usize, last: usize) -> Option<(usize, Ages)> {
        let Departures::Late(longest) = self.departures else { return None };
        let mut run = vec![start.to_vec()];
        let mut ages = Ages::new();
        for t in 0..last {
            let place = |age: usize, j: usize| run.get(t.checked_sub(age)?)?.get(j);
            let stale = self.links().into_iter().filter_map(|(i, j)| {
                // Of equal positions the latest.
                let better = |a: usize, b: usize| match (place(a, j), place(b, j)) {
                    (Some(a), Some(b)) => {
                        if i <= pair {
                            a > b
                        } else {
                            a < b
                        }
                    }
                    _ => false,
                };
                let age =
                    (1..=longest.min(t)).fold(0, |best, a| if better(a, best) { a } else { best });
                (age > 0).then_some((i, j, age))
            });
            let mut stale: Vec<_> = stale.collect();
            stale.sort_unstable();
            ages.push(stale);
            run.push(self.next(&run, &ages)?);
            let now = run.last()?;
            if (now.get(pair + 1)? - now.get(pair)?).is_negative() {
                return Some((t + 1, ages));
            }
        }
        None
    }

    /// The placement after the last step.
    fn next(&self, run: &[Vec<Rational>], ages: &Ages) -> Option<Vec<Rational>> {
        let t = run.len().checked_sub(1)?;
        let now = run.get(t)?;
        let stale = ages.get(t)?;
        let (min, max) = (now.first()?.clone(), now.last()?.clone());
        let params = Params { min, max, eps: self.eps.clone(), n: 0 };
        let state = State { drones: now.clone(), timesteps: 0 };
        let seen = |i: usize, j: usize| {
            let age = stale.iter().find(|s| (s.0, s.1) == (i, j)).map_or(0, |s| s.2);
            run.get(t - age.min(t)).and_then(|x| x.get(j)).unwrap_or(&state.drones[j])
        };
        Some(exec_coverage_delayed(&params, &state, seen).drones)
    }

    /// The same ages from a start with no zero gap: the simplest mixture with equal gaps in which the
    /// pair still meets. For fixed ages a run is a linear function of its start.
    fn started_inside(
        &self,
        start: &[Rational],
        pair: usize,
        step: usize,
        ages: Ages,
    ) -> Option<Counterexample> {
        let last = Rational::from_integer(self.count.checked_sub(1)?.into());
        let equal: Vec<Rational> =
            (0..self.count).map(|i| Rational::from_integer(i.into()) / &last).collect();
        let gap = |start: &[Rational]| {
            let mut run = vec![start.to_vec()];
            for _ in 0..step {
                run.push(self.next(&run, &ages)?);
            }
            Some(run.last()?.get(pair + 1)? - run.last()?.get(pair)?)
        };
        let (outer, middle) = (gap(start)?, gap(&equal)?);
        let from = (&middle / (&middle - &outer)).max(Rational::zero());
        let share = strictly_between(&from, &Rational::one())?;
        let rest = Rational::one() - &share;
        let mixed = start.iter().zip(&equal).map(|(a, b)| a * &share + b * &rest).collect();
        let departure = Departure::Delay(ages);
        Counterexample::replay_departing(
            Theorem::Ordering,
            Form::Sharp,
            &self.eps,
            mixed,
            step,
            departure,
        )
    }
}
