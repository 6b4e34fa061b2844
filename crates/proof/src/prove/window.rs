//! A few neighbouring drones on symbols, and what one step of the spec makes of them.

use cordon_spec::activation::exec_coverage_active;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::delay::exec_coverage_delayed;
use cordon_spec::placement::error_at;
use cordon_spec::{Params, State};

use super::symbols::{Fact, Sign, cell, fact, int, named};
use cordon_core::scalar::Polynomial;

/// Where the drones stand in the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// At its beginning: drone 0, or drones 0 and 1.
    First,
    /// Inside.
    Inner,
    /// At its end: drone N-1, or drones N-2 and N-1.
    Last,
}

impl Part {
    /// In the order of the drones.
    pub const ALL: [Self; 3] = [Self::First, Self::Inner, Self::Last];

    /// Its name in obligations.
    pub fn label(self) -> &'static str {
        match self {
            Self::First => "first",
            Self::Inner => "inner",
            Self::Last => "last",
        }
    }
}

/// Who moves, and what they see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// All, the present.
    Plain,
    /// Any subset, the present.
    Activation,
    /// All; neighbours as they were at any time.
    Delay,
}

/// A property of drones (width 1) or pairs of neighbours (width 2).
#[derive(Clone, Copy, Debug)]
pub struct Property {
    /// Its name.
    pub label: &'static str,
    /// The sign of its polynomial.
    pub sign: Sign,
    /// How many drones it is about.
    pub width: usize,
    /// Its polynomial, of the drones' index and positions.
    pub poly: fn(&Polynomial, &[Polynomial]) -> Polynomial,
}

/// (N-1) times the error of drone `i` at position `x`.
pub fn error(i: &Polynomial, x: &Polynomial) -> Polynomial {
    error_at(&named("min"), &named("max"), &named("last"), i, x)
}

/// The drone before, the drones in question (`width` of them), the drone behind.
#[derive(Clone, Debug)]
pub struct Window {
    part: Part,
    width: usize,
    /// Index of the first drone in question.
    pub index: Polynomial,
    /// Positions by offset; the first offset is `low`.
    cells: Vec<Polynomial>,
    low: i32,
}

impl Window {
    /// The window on that part of the line.
    pub fn new(part: Part, width: usize, step: Step) -> Self {
        let low = if part == Part::First { 0 } else { -1 };
        let behind = usize::from(part != Part::Last);
        let count = width + behind + usize::from(part != Part::First);
        let mut cells: Vec<Polynomial> = (low..)
            .take(count)
            .map(|o| cell(if step == Step::Delay && o != 0 { "y" } else { "x" }, o))
            .collect();
        let index = match part {
            Part::First => int(0),
            Part::Inner => named("i"),
            Part::Last => named("last") - &int(width as i32 - 1),
        };
        match part {
            Part::First => cells[0] = named("min"),
            Part::Inner => {}
            Part::Last => cells[count - 1] = named("max"),
        }
        Self { part, width, index, cells, low }
    }

    /// What the index can be.
    pub fn index_facts(&self) -> Vec<Fact> {
        if self.part != Part::Inner {
            return Vec::new();
        }
        let room = named("last") - &named("i") - &int(self.width as i32);
        vec![
            fact("i-1", named("i") - &int(1), Sign::NonNegative),
            fact(format!("last-i-{}", self.width), room, Sign::NonNegative),
        ]
    }

    /// What the property says wherever it can be read off the window.
    pub fn facts(&self, property: &Property) -> Vec<Fact> {
        (self.low..)
            .zip(self.cells.windows(property.width))
            .map(|(o, cells)| {
                let poly = (property.poly)(&(self.index.clone() + &int(o)), cells);
                fact(format!("{}[{o}]", property.label), poly, property.sign)
            })
            .collect()
    }

    /// The property of the drones in question, now.
    pub fn goal(&self, property: &Property) -> Polynomial {
        let from = (-self.low) as usize;
        (property.poly)(&self.index, &self.cells[from..from + self.width])
    }

    /// The property of the drones in question after a step, for every subset that may move, by name.
    pub fn goals_after(&self, property: &Property, step: Step) -> Vec<(String, Polynomial)> {
        self.after(step)
            .into_iter()
            .map(|(suffix, cells)| (suffix, (property.poly)(&self.index, &cells)))
            .collect()
    }

    /// The positions of the drones in question after a step.
    pub fn after(&self, step: Step) -> Vec<(String, Vec<Polynomial>)> {
        let mut drones = self.cells.clone();
        if self.part != Part::First {
            drones.insert(0, named("min"));
        }
        if self.part != Part::Last {
            drones.push(named("max"));
        }
        let from = if self.part == Part::First { 0 } else { 2 };
        let p = Params { min: named("min"), max: named("max"), eps: named("eps"), n: 0 };
        let state = State { drones, timesteps: 0 };
        let cut = |next: State<Vec<Polynomial>>| next.drones[from..from + self.width].to_vec();
        match step {
            Step::Plain => vec![(String::new(), cut(exec_coverage(&p, &state)))],
            Step::Delay => {
                let seen = |_, j: usize| &state.drones[j];
                vec![(String::new(), cut(exec_coverage_delayed(&p, &state, seen)))]
            }
            Step::Activation => (0..1_u32 << self.width)
                .map(|mask| {
                    let moves = |o: usize| mask >> o & 1 == 1;
                    let bits: String =
                        (0..self.width).map(|o| if moves(o) { '1' } else { '0' }).collect();
                    let next = exec_coverage_active(&p, &state, |j| {
                        !(from..from + self.width).contains(&j) || moves(j - from)
                    });
                    (format!("/active-{bits}"), cut(next))
                })
                .collect(),
        }
    }
}
