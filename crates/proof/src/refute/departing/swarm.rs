//! A line of drones with departing steps, as a system.

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::{Truth, Verdict};
use cordon_spec::{Params, Scalar, State};
use num_traits::{One, Zero};

use super::Departures;
use crate::certificate::Departure;
use crate::claims::automaton::Automaton;
use crate::claims::search::Choice;
use crate::claims::{Run, Sought, sought};
use crate::counterexample::Counterexample;
use crate::refute::conjunction::demands;
use crate::refute::{Extent, SearchSpace, symbolic_setting};
use crate::symbolic::Symbol;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::system::{
    Claim, MOST_VARIABLES, Parameter, ParameterKind, Predicate, Protocol, System,
};
use cordon_core::{Error, Rational, Result};

/// Names of a drone's position now, one step ago, two steps ago, and so on, as in certificates.
const NAMES: [&str; 21] = [
    "x", "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n", "o", "p", "q", "r",
    "s", "t",
];

/// A line of drones on the segment \[0, 1\] with departing steps.
pub(super) struct Swarm {
    /// Number of drones, at least 3.
    pub count: usize,
    /// The weight of the neighbours.
    pub eps: Rational,
    /// The allowed departures.
    pub departures: Departures,
}

impl Swarm {
    /// The number of placements in the state.
    fn remembered(&self) -> usize {
        match self.departures {
            Departures::Skips => 1,
            Departures::Late(longest) => longest + 1,
        }
    }

    /// The links with delays that matter: the end drones do not move, whatever they see.
    pub(super) fn links(&self) -> Vec<(usize, usize)> {
        (1..self.count.saturating_sub(2)).flat_map(|i| [(i, i + 1), (i + 1, i)]).collect()
    }

    /// Refuses more variables than a system may have.
    pub(super) fn fits(&self) -> Result<()> {
        let width = self.remembered();
        let variables = self.count.saturating_mul(width);
        if variables > MOST_VARIABLES {
            return Err(Error::input(format!(
                "drones: `{}` of which {width} placements are remembered: expected at most \
                 {MOST_VARIABLES} positions in all",
                self.count
            )));
        }
        Ok(())
    }

    /// The theorem on this swarm, as a system with claims.
    fn system(&self, space: &SearchSpace) -> Result<System> {
        let width = self.remembered();
        let mut system = System::of(self)?;
        let position = |i: usize, age: usize| Affine::variable(i * width + age);
        let placement: Vec<Affine> = (0..self.count).map(|i| position(i, 0)).collect();
        let setting = symbolic_setting(&self.eps);
        let starts = space.theorem.hypothesis(space.form).starts;
        let contained = |run: &[Vec<Symbol<Affine>>]| {
            run.first().map_or(Truth::Unknown, |x| starts.contains(&setting, x))
        };
        let concluded =
            |run: &[Vec<Symbol<Affine>>]| space.theorem.conclusion(space.form, &setting, run);
        // The earlier placements, at rest, are in the start set too; a step may preserve that.
        let assumed = (0..width).map(|age| {
            let placement = (0..self.count).map(|i| position(i, age)).collect();
            demands(&[placement], contained, |t| *t == Truth::False)
        });
        let assumed: Option<Vec<_>> = assumed.collect();
        let claimed = demands(&[placement], concluded, |v| matches!(v, Verdict::Violated(_)));
        let (Some(assumed), Some(claimed)) = (assumed, claimed) else {
            return Err(Error::internal("a start set and a conclusion that are conjunctions"));
        };
        let equal = |a: &Affine, b: &Affine| Constraint { form: a.clone() - b, sign: Sign::Zero };
        let last = self.count.saturating_sub(1);
        let ends = [(0, Rational::zero()), (last, Rational::one())]
            .map(|(i, end)| equal(&position(i, 0), &Affine::constant(end)));
        let at_rest = (0..self.count)
            .flat_map(|i| (1..width).map(move |age| (i, age)))
            .map(|(i, age)| equal(&position(i, age), &position(i, 0)));
        let said = |is| Predicate { text: String::new(), is };
        system.starts =
            assumed.into_iter().flatten().chain(ends).chain(at_rest).map(said).collect();
        let claim = |is| Claim { predicate: said(is), from: 0, until: None };
        system.claims = claimed.into_iter().map(claim).collect();
        Ok(system)
    }

    /// The first counterexample up to step `last`, or the extent without one, within a budget of work.
    pub(super) fn counterexample(
        &self,
        space: &SearchSpace,
        last: usize,
        work: &mut u64,
    ) -> Result<(Option<Counterexample>, Extent)> {
        let (_, found) = self.sought(space, last, work)?;
        Ok(match found {
            Sought::Never(_) => (None, Extent::EveryStartAndStep),
            Sought::NotUpTo(step, _) if step >= last => (None, Extent::EveryStart),
            Sought::NotUpTo(..) => (None, Extent::Tried),
            // The spec decides; a run that it does not confirm is not a counterexample.
            Sought::Fails(run) => (self.replayed(space, &run), Extent::Tried),
        })
    }

    /// The result of the search up to step `last`, within a budget of work, and the system searched.
    pub(super) fn sought(
        &self,
        space: &SearchSpace,
        last: usize,
        work: &mut u64,
    ) -> Result<(System, Sought)> {
        let system = self.system(space)?;
        let values = system.values(|p| p.low.clone());
        let starts = system.start_constraints();
        let found = sought(&system, &Automaton::of(&system), &values, starts, last, work);
        Ok((system, found))
    }

    /// The run, if the spec confirms it.
    pub(super) fn replayed(&self, space: &SearchSpace, run: &Run) -> Option<Counterexample> {
        let start = run.states.first()?.iter().step_by(self.remembered()).cloned().collect();
        let steps = run.choices.iter();
        let departure = match self.departures {
            Departures::Skips => {
                Departure::Activation(steps.map(|choice| self.active(choice)).collect())
            }
            Departures::Late(_) => Departure::Delay(
                steps.enumerate().map(|(t, choice)| self.stale(t, choice)).collect(),
            ),
        };
        let (theorem, form) = (space.theorem, space.form);
        Counterexample::replay_departing(theorem, form, &self.eps, start, run.step, departure)
    }

    /// The internal drones that update.
    fn active(&self, choice: &Choice) -> Vec<usize> {
        let acts = choice.values.iter().enumerate().filter(|(_, acts)| acts.is_one());
        acts.map(|(index, _)| index + 1).collect()
    }

    /// Who sees whom with which delay in the step from time t; before the start all were at rest.
    fn stale(&self, t: usize, choice: &Choice) -> Vec<(usize, usize, usize)> {
        let longest = self.remembered() - 1;
        let links = self.links();
        let late = choice.values.chunks(longest.max(1));
        let age = |late: &[Rational]| late.iter().take_while(|x| x.is_one()).count();
        let ages = links.iter().zip(late).map(|(&(i, j), late)| (i, j, age(late).min(t)));
        let mut all: Vec<_> = ages.filter(|&(.., age)| age > 0).collect();
        all.sort_unstable();
        all
    }
}

/// Each drone's variables are its positions, the latest first. Choices: whether internal drone `i`
/// acts; for each link whether the position seen is at least one step old, at least two, and so on.
impl Protocol for Swarm {
    fn agents(&self) -> usize {
        self.count
    }

    fn variables(&self) -> Vec<&str> {
        (0..self.remembered()).map(|age| NAMES.get(age).copied().unwrap_or("x")).collect()
    }

    fn parameters(&self) -> Vec<Parameter> {
        let choice = |name: String| {
            let (low, high) = (Rational::zero(), Rational::one());
            Parameter { name, low, high, kind: ParameterKind::Choice }
        };
        match self.departures {
            Departures::Skips => (1..self.count - 1).map(|i| choice(format!("acts{i}"))).collect(),
            Departures::Late(longest) => {
                let of =
                    |(i, j)| (1..=longest).map(move |age| choice(format!("late{i}of{j}by{age}")));
                self.links().into_iter().flat_map(of).collect()
            }
        }
    }

    fn step<S: Scalar>(
        &self,
        number: &impl Fn(&Rational) -> S,
        parameters: &[S],
        x: &[S],
    ) -> Vec<S> {
        let width = self.remembered();
        let (min, max) = (number(&Rational::zero()), number(&Rational::one()));
        let p = Params { min, max, eps: number(&self.eps), n: 0 };
        let ago = |age: usize| -> Vec<S> { x.iter().skip(age).step_by(width).cloned().collect() };
        // a where the choice is 0, b where it is 1.
        let either = |choice: &S, a: &S, b: &S| a.clone() + &((b.clone() - a) * choice);
        let state = State { drones: ago(0), timesteps: 0 };
        let next = match self.departures {
            Departures::Skips => {
                let [off, on] =
                    [false, true].map(|acts| exec_coverage_active(&p, &state, |_| acts).drones);
                let mut next = off;
                let inner = next.iter_mut().zip(&on).skip(1).zip(parameters);
                inner.for_each(|((x, on), acts)| *x = either(acts, x, on));
                next
            }
            Departures::Late(longest) => {
                let past: Vec<Vec<S>> = (0..=longest).map(ago).collect();
                let links = self.links();
                let seen = |(&(_, j), late): (&(usize, usize), &[S])| {
                    // From the oldest: newer than this, or at least this old.
                    let none = number(&Rational::zero());
                    let at = |age: usize| past.get(age).and_then(|x| x.get(j)).unwrap_or(&none);
                    let oldest = at(longest).clone();
                    let older = |seen: S, (age, late): (usize, &S)| either(late, at(age), &seen);
                    late.iter().enumerate().rev().fold(oldest, older)
                };
                let seen: Vec<S> = match longest {
                    0 => links.iter().map(|&(_, j)| state.drones[j].clone()).collect(),
                    _ => links.iter().zip(parameters.chunks(longest)).map(seen).collect(),
                };
                exec_coverage_delayed(&p, &state, |i, j| {
                    let link = links.iter().position(|&link| link == (i, j));
                    link.and_then(|at| seen.get(at)).unwrap_or(&state.drones[j])
                })
                .drones
            }
        };
        let mut all = Vec::with_capacity(x.len());
        for (i, now) in next.into_iter().enumerate() {
            all.push(now);
            all.extend(x.iter().skip(i * width).take(width - 1).cloned());
        }
        all
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use cordon_core::random::SplitMix;

    /// Whatever is chosen, a step of the system is the spec's step with these departures.
    #[test]
    fn a_step_is_the_specs_whatever_is_chosen() {
        let mut random = SplitMix::new(7);
        let mut number = || Rational::new((random.below(41) as i64 - 20).into(), 7.into());
        let mut bits = SplitMix::new(8);
        let mut compared = 0;
        for count in 3..=6 {
            for departures in [Departures::Skips, Departures::Late(1), Departures::Late(3)] {
                let swarm = Swarm { count, eps: number(), departures };
                let system = System::of(&swarm).unwrap();
                let width = swarm.remembered();
                for _ in 0..20 {
                    let x: Vec<Rational> = (0..count * width).map(|_| number()).collect();
                    let chosen = |_: &Parameter| match bits.below(2) {
                        0 => Rational::zero(),
                        _ => Rational::one(),
                    };
                    let values: Vec<Rational> = system.parameters.iter().map(chosen).collect();
                    let choice = Choice { mode: 0, values };
                    let next = system.modes[0].at(&choice.values).apply(&x);
                    let ago = |age: usize| x.iter().skip(age).step_by(width).cloned().collect();
                    let past: Vec<Vec<Rational>> = (0..width).map(ago).collect();
                    let (min, max) = (Rational::zero(), Rational::one());
                    let p = Params { min, max, eps: swarm.eps.clone(), n: 0 };
                    let state = State { drones: past[0].clone(), timesteps: 0 };
                    let wanted = match departures {
                        Departures::Skips => {
                            let active = swarm.active(&choice);
                            exec_coverage_active(&p, &state, |i| active.contains(&i))
                        }
                        Departures::Late(_) => {
                            let stale = swarm.stale(width, &choice);
                            let age = |i, j| stale.iter().find(|s| (s.0, s.1) == (i, j));
                            exec_coverage_delayed(&p, &state, |i, j| {
                                &past[age(i, j).map_or(0, |s| s.2)][j]
                            })
                        }
                    };
                    let now: Vec<Rational> = next.iter().step_by(width).cloned().collect();
                    assert_eq!(now, wanted.drones, "{departures:?}");
                    for (i, x) in x.chunks(width).enumerate() {
                        assert_eq!(next[i * width + 1..(i + 1) * width], x[..width - 1]);
                    }
                    compared += 1;
                }
            }
        }
        assert_eq!(compared, 4 * 3 * 20);
    }
}
