//! Steps in which drones skip their update, or see their neighbours where they were: as a system that
//! the spec's own functions are executed to make, searched by the engine of claims.

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::coverage::getx;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::theorems::{Form, Theorem, Truth, Verdict};
use cordon_spec::{Params, Scalar, State};
use num_traits::{One, Zero};

use super::conjunction::demands;
use super::region::Region;
use super::{
    Coverage, Extent, SearchResult, SearchSpace, is_conjunction, params, symbolic_setting,
    violating_start,
};
use crate::certificate::Departure;
use crate::claims::automaton::Automaton;
use crate::claims::search::Choice;
use crate::claims::{Run, Sought, WORK, sought};
use crate::counterexample::Counterexample;
use crate::symbolic::Symbol;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::system::{
    Claim, MOST_VARIABLES, Parameter, ParameterKind, Predicate, Protocol, System,
};
use cordon_core::{Error, Rational, Result, progress};

/// How steps depart from the protocol as written, in each step anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Departures {
    /// Any drone may skip its update.
    Skips,
    /// Each drone may see each neighbour as it was up to so many steps ago, but never before the start.
    Late(usize),
}

/// Most patterns of delays that do not change.
const MOST_PATTERNS: usize = 10_000;

/// Most drones for which they are tried: what happens between two drones needs no more around them.
const MOST_DRONES: usize = 12;

/// Whether the conclusion is about one placement and made of comparisons, so that it is a claim.
pub fn is_claim(theorem: Theorem, form: Form) -> bool {
    is_conjunction(theorem) && theorem.span(form, 3) == 0
}

/// Searches over all departures of every step.
///
/// # Errors
/// The theorem reads more than one placement, or there are more drones and delays than a system has
/// variables.
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
        // The simplest first: delays that do not change.
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
            // What the simple ones leave, the others may use.
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

/// A line of drones on the segment \[0, 1\] whose steps depart.
struct Swarm {
    count: usize,
    eps: Rational,
    departures: Departures,
}

impl Swarm {
    /// How many placements the state has.
    fn remembered(&self) -> usize {
        match self.departures {
            Departures::Skips => 1,
            Departures::Late(longest) => longest + 1,
        }
    }

    /// Who sees whom late, where it matters: the end drones do not move.
    fn links(&self) -> Vec<(usize, usize)> {
        (1..self.count.saturating_sub(2)).flat_map(|i| [(i, i + 1), (i + 1, i)]).collect()
    }

    /// Refuses more positions than a system may have.
    fn fits(&self) -> Result<()> {
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

    /// The theorem about this swarm as a system with claims.
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
        // At rest every earlier placement is in the start set too, which a step may keep.
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
            .map(|(i, place)| equal(&position(i, 0), &Affine::constant(place)));
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

    /// The first counterexample up to step `last`, or how far there is none, within so much work.
    fn counterexample(
        &self,
        space: &SearchSpace,
        last: usize,
        work: &mut u64,
    ) -> Result<(Option<Counterexample>, Extent)> {
        let system = self.system(space)?;
        let values = system.values(|p| p.low.clone());
        let starts = system.start_constraints();
        let found = sought(&system, &Automaton::of(&system), &values, starts, last, work);
        Ok(match found {
            Sought::Never => (None, Extent::EveryStartAndStep),
            Sought::NotUpTo(step) if step >= last => (None, Extent::EveryStart),
            Sought::NotUpTo(_) => (None, Extent::Tried),
            // The spec decides; a run that it does not confirm is no counterexample.
            Sought::Fails(run) => (self.replayed(space, &run), Extent::Tried),
        })
    }

    /// A counterexample at an earlier step than the one known, with delays that do not change; else that
    /// one.
    fn unchanging_counterexample(
        &self,
        space: &SearchSpace,
        known: Option<Counterexample>,
    ) -> Option<Counterexample> {
        self.unchanging().iter().fold(known, |best, ages| {
            let last = best.as_ref().map_or(Some(space.steps), |b| b.step.checked_sub(1));
            last.and_then(|last| self.along(space, ages, last)).or(best)
        })
    }

    /// How late each link is where that does not change, the smallest delays first. Where those are too
    /// many, only two drones are late, to each other.
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
            // Both directions of a link are beside each other.
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
            link.and_then(|place| ages.get(place)).map_or(0, |&age| age.min(t))
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

    /// The run, if the spec confirms it.
    fn replayed(&self, space: &SearchSpace, run: &Run) -> Option<Counterexample> {
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

    /// The inner drones that update.
    fn active(&self, choice: &Choice) -> Vec<usize> {
        let acts = choice.values.iter().enumerate().filter(|(_, acts)| acts.is_one());
        acts.map(|(place, _)| place + 1).collect()
    }

    /// Who sees whom how late in the step from time t; before the start all were at rest.
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

/// Each drone's variables are its positions, the latest first. Choices: whether inner drone `i` acts; of
/// each link whether what is seen is at least one step old, at least two, and so on.
impl Protocol for Swarm {
    fn agents(&self) -> usize {
        self.count
    }

    fn variables(&self) -> Vec<&str> {
        vec!["x"; self.remembered()]
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
                    |(i, j)| (1..=longest).map(move |age| choice(format!("late{i}_{j}_{age}")));
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
                    // From the oldest on: not so old, or as old as that at least.
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
