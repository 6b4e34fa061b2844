//! Which engine does the work.

use std::collections::BTreeMap;

use super::answer::Answer;
use super::course::{self, Course};
use super::line::Line;
use super::multiply::Multiply;
use super::rule::Rule;
use super::{cost, jump, leap, step};
use crate::scenario::Scenario;
use cordon_core::{Error, Result};

/// How the exact positions are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engine {
    /// No steps between, by powers of the step, except where making them is expected to be faster
    #[default]
    Jump,
    /// Every step, in integers over a common denominator
    Step,
}

/// The backend of long multiplications.
pub fn multiplier() -> &'static dyn Multiply {
    &super::ntt::Ntt
}

/// What the engines move: a line of drones, or an own protocol that is none.
#[derive(Clone, Debug)]
pub enum Motion {
    /// By one symmetric rule.
    Line(Line),
    /// By sparse matrices.
    Course(Box<Course>),
}

impl Motion {
    /// The motion of a scenario, up to step `last` where its steps are drawn.
    ///
    /// # Errors
    /// Formation, consensus on another graph than the path, or a start that fits no line; drawn steps that
    /// would take for ever.
    pub fn of(scenario: &Scenario, last: u64) -> Result<Self> {
        match scenario.own() {
            Some(own) if own.cycle().is_none() => {
                let start = scenario.whole_start();
                Course::refuse_endless_draws(own, &start, "at", last, last)?;
                Ok(Self::Course(Course::drawn(own, &start, last).into()))
            }
            _ => Rule::of(scenario)?.motion(&scenario.whole_start()),
        }
    }

    /// The line, where it is one; else an error that says so of `what`.
    ///
    /// # Errors
    /// It is no line.
    pub fn into_line(self, what: &str) -> Result<Line> {
        match self {
            Self::Line(line) => Ok(line),
            Self::Course(_) => Err(Error::input(format!(
                "{what}: expected drones on a line that all move by one symmetric rule"
            ))),
        }
    }

    /// A bound of the bits of every numerator after k steps, without its sign.
    pub fn numerator_bits(&self, k: u64) -> u64 {
        match self {
            Self::Line(line) => line.numerator_bits(k),
            Self::Course(course) => course.numerator_bits(k),
        }
    }

    /// Refuses answers beyond memory; `field` is what k was given for.
    ///
    /// # Errors
    /// The answer after k steps would be too long: says how long.
    pub fn refuse_beyond_memory(&self, field: &str, k: u64) -> Result<()> {
        match self {
            Self::Line(line) => line.refuse_beyond_memory(field, k),
            Self::Course(course) => course.refuse_beyond_memory(field, k),
        }
    }

    /// The positions after each of `steps`, in their order.
    ///
    /// # Errors
    /// An answer longer than the memory limit.
    pub fn positions(&self, steps: &[u64], engine: Engine) -> Result<Vec<Answer>> {
        match self {
            Self::Line(line) => positions(line, steps, engine),
            Self::Course(course) => {
                course.refuse_beyond_memory("at", last(steps))?;
                let costs = (|k| course.stepping(k), |k| leap::jumping(course, k));
                let plan = Plan::of(steps, engine, costs);
                let mut wanted = plan.near.clone();
                wanted.sort_unstable();
                let mut run = course::Run::new((**course).clone(), last(&wanted));
                let found: BTreeMap<u64, Answer> =
                    wanted.into_iter().map(|k| (k, run.advance_to(k).answer())).collect();
                let near = plan.near.iter().filter_map(|k| found.get(k).cloned()).collect();
                // Drawn steps are never far: a jump over them would cost infinitely much.
                let jump = |&k: &u64| leap::after(course, k, multiplier());
                let far = plan.far.iter().filter_map(jump).collect();
                Ok(plan.in_order(steps, near, far))
            }
        }
    }

    /// Whether jumping to each of `steps` is expected to be faster than stepping to the `last`.
    pub fn jump_is_faster(&self, last: u64, steps: impl IntoIterator<Item = u64>) -> bool {
        match self {
            Self::Line(line) => jump_is_faster(line, last, steps),
            Self::Course(course) => {
                let mut left = course.stepping(last);
                steps.into_iter().all(|k| {
                    left -= leap::jumping(course, k);
                    left > 0.0
                })
            }
        }
    }
}

/// The positions after each of `steps`, in their order.
///
/// # Errors
/// An answer longer than the memory limit.
pub fn positions(line: &Line, steps: &[u64], engine: Engine) -> Result<Vec<Answer>> {
    line.refuse_beyond_memory("at", last(steps))?;
    let costs = (|k| cost::stepping(line, k), |k| cost::jumping(line, k));
    let plan = Plan::of(steps, engine, costs);
    let near = step::at(line, &plan.near)?;
    let far = jump::at(line, &plan.far, multiplier())?;
    Ok(plan.in_order(steps, near, far))
}

/// Which of some steps are stepped to, and which are jumped to: those after them.
struct Plan {
    /// The last that is stepped to.
    until: Option<u64>,
    near: Vec<u64>,
    far: Vec<u64>,
}

impl Plan {
    /// The cheapest, by what stepping to a step and jumping to it cost.
    fn of(
        steps: &[u64],
        engine: Engine,
        (stepping, jumping): (impl Fn(u64) -> f64, impl Fn(u64) -> f64),
    ) -> Self {
        let mut sorted = steps.to_vec();
        sorted.sort_unstable();
        let mut until = sorted.last().copied();
        if engine == Engine::Jump {
            let (mut jumps, mut least) = (0.0, f64::INFINITY);
            for k in sorted.into_iter().rev() {
                let cost = stepping(k) + jumps;
                if cost < least {
                    (least, until) = (cost, Some(k));
                }
                jumps += jumping(k);
            }
            if jumps < least {
                until = None;
            }
        }
        let (near, far) = steps.iter().partition(|k| Some(**k) <= until);
        Self { until, near, far }
    }

    /// The answers of both kinds in the order of the steps.
    fn in_order(&self, steps: &[u64], near: Vec<Answer>, far: Vec<Answer>) -> Vec<Answer> {
        let (mut near, mut far) = (near.into_iter(), far.into_iter());
        let next = |k: &u64| if Some(*k) <= self.until { near.next() } else { far.next() };
        steps.iter().filter_map(next).collect()
    }
}

fn last(steps: &[u64]) -> u64 {
    steps.iter().copied().max().unwrap_or(0)
}

/// Whether jumping to each of `steps` is expected to be faster than stepping to the `last`.
pub fn jump_is_faster(line: &Line, last: u64, steps: impl IntoIterator<Item = u64>) -> bool {
    let mut left = cost::stepping(line, last);
    steps.into_iter().all(|k| {
        left -= cost::jumping(line, k);
        left > 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Costs in the simplest units: a step k costs k^2, a jump `jump`.
    fn plan(steps: &[u64], engine: Engine, jump: f64) -> (Vec<u64>, Vec<u64>) {
        let plan = Plan::of(steps, engine, (|k| (k * k) as f64, |_| jump));
        (plan.near, plan.far)
    }

    #[test]
    fn near_steps_are_stepped_to_and_far_ones_jumped_to() {
        let steps = [1000, 3, 1, 2, 3, 40];
        assert_eq!(plan(&steps, Engine::Jump, 100.0), (vec![3, 1, 2, 3], vec![1000, 40]));
        assert_eq!(plan(&steps, Engine::Jump, 0.1), (vec![], steps.to_vec()));
        assert_eq!(plan(&steps, Engine::Jump, f64::INFINITY), (steps.to_vec(), vec![]));
        assert_eq!(plan(&steps, Engine::Step, 0.1), (steps.to_vec(), vec![]));
        // A start costs nothing to step to.
        assert_eq!(plan(&[0, 9], Engine::Jump, 1.0), (vec![0], vec![9]));
        assert_eq!(plan(&[], Engine::Jump, 1.0), (vec![], vec![]));
    }
}
