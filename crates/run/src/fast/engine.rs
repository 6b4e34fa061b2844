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
    /// The one that is expected to be faster
    #[default]
    Auto,
    /// Every step, in integers over a common denominator
    Step,
    /// No steps between: one power of the step's kernel
    Jump,
}

/// The default backend of long multiplications.
pub fn multiplier() -> &'static dyn Multiply {
    #[cfg(feature = "gmp")]
    {
        &super::multiply::Gmp
    }
    #[cfg(not(feature = "gmp"))]
    {
        &super::ntt::Ntt
    }
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
    /// An answer longer than the memory limit; a jump over steps that are drawn.
    pub fn positions(&self, steps: &[u64], engine: Engine) -> Result<Vec<Answer>> {
        let course = match self {
            Self::Line(line) => return positions(line, steps, engine),
            Self::Course(course) => course,
        };
        let last = last(steps);
        course.refuse_beyond_memory("at", last)?;
        let jump = match engine {
            Engine::Jump => true,
            Engine::Step => false,
            Engine::Auto => self.jump_is_faster(last, steps.iter().copied()),
        };
        if jump {
            let drawn = || {
                Error::input(
                    "engine: `jump`: expected no drawn choices: drawn steps are made one by one",
                )
            };
            let after = |&k: &u64| leap::after(course, k, multiplier()).ok_or_else(drawn);
            return steps.iter().map(after).collect();
        }
        let mut wanted = steps.to_vec();
        wanted.sort_unstable();
        let mut run = course::Run::new((**course).clone(), last);
        let found: BTreeMap<u64, Answer> =
            wanted.into_iter().map(|k| (k, run.advance_to(k).answer())).collect();
        Ok(steps.iter().filter_map(|k| found.get(k).cloned()).collect())
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
    match engine {
        Engine::Jump => jump::at(line, steps, multiplier()),
        Engine::Step => step::at(line, steps),
        Engine::Auto if jump_is_faster(line, last(steps), steps.iter().copied()) => {
            jump::at(line, steps, multiplier())
        }
        Engine::Auto => step::at(line, steps),
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
