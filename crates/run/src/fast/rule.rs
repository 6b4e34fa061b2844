//! The protocols that the fast engines take: the spec, on any scalar.

use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::graph::Path;
use cordon_spec::{Params, Scalar, State};

use super::course::Course;
use super::engine::Motion;
use super::line::Line;
use crate::scenario::{Protocol, Scenario, Topology};
use cordon_core::system::Map;
use cordon_core::{Error, Rational, Result};

/// A protocol on a line of drones, or an own one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Rule<S> {
    /// Coverage of a segment (equation 10).
    Coverage {
        /// Left end of the segment.
        min: S,
        /// Right end of the segment.
        max: S,
        /// Weight of the neighbours.
        eps: S,
    },
    /// Equation 6 on the path of all drones.
    Consensus {
        /// Weight of the neighbours.
        eps: S,
    },
    /// A protocol file's: of each of the maps that act in turn every row, the constant first.
    Own(Vec<Vec<Row<S>>>),
}

/// The constant and the coefficients by column.
type Row<S> = (S, Vec<(usize, S)>);

impl<S: Scalar> Rule<S> {
    /// Protocol step `k >= 1`, of the spec itself or of the protocol file.
    pub fn step(&self, k: u64, x: Vec<S>) -> Vec<S> {
        match self {
            Self::Coverage { min, max, eps } => {
                // Every tick is a step: the counter plays no part.
                let p = Params { min: min.clone(), max: max.clone(), eps: eps.clone(), n: 0 };
                exec_coverage(&p, &State { drones: x, timesteps: 0 }).drones
            }
            Self::Consensus { eps } => exec_consensus(eps, &Path { count: x.len() }, &x),
            Self::Own(maps) => {
                let turn = k.saturating_sub(1) % (maps.len() as u64).max(1);
                let row = |(constant, row): &Row<S>| {
                    let terms = row.iter().filter_map(|(j, a)| Some(a.clone() * x.get(*j)?));
                    terms.fold(constant.clone(), |sum, term| sum + &term)
                };
                maps.get(turn as usize).into_iter().flatten().map(row).collect()
            }
        }
    }

    /// The same protocol on other scalars, where `f` has an image of every parameter.
    pub fn map<T>(&self, f: impl Fn(&S) -> Option<T>) -> Option<Rule<T>> {
        Some(match self {
            Self::Coverage { min, max, eps } => {
                Rule::Coverage { min: f(min)?, max: f(max)?, eps: f(eps)? }
            }
            Self::Consensus { eps } => Rule::Consensus { eps: f(eps)? },
            Self::Own(maps) => {
                let row = |(constant, row): &Row<S>| {
                    let entries = row.iter().map(|(j, a)| Some((*j, f(a)?)));
                    Some((f(constant)?, entries.collect::<Option<_>>()?))
                };
                let map = |map: &Vec<Row<S>>| map.iter().map(row).collect::<Option<_>>();
                Rule::Own(maps.iter().map(map).collect::<Option<_>>()?)
            }
        })
    }
}

impl Rule<Rational> {
    /// The protocol of a scenario.
    ///
    /// # Errors
    /// Formation, consensus on another graph than the path, and a protocol file whose choices are
    /// drawn.
    pub fn of(scenario: &Scenario) -> Result<Self> {
        let eps = scenario.weight.clone();
        match &scenario.protocol {
            Protocol::Coverage { min, max } => {
                Ok(Self::Coverage { min: min.clone(), max: max.clone(), eps })
            }
            Protocol::Consensus { graph: Topology::Path(_) } => Ok(Self::Consensus { eps }),
            Protocol::Own(own) => match own.cycle() {
                Some(maps) => Ok(Self::Own(maps.into_iter().map(|map| map.rows).collect())),
                None => Err(Error::input(
                    "verify: expected a run without drawn choices, whose steps are known beforehand",
                )),
            },
            other => Err(Error::input(format!(
                "protocol: `{}`: expected coverage, or consensus on the path, where steps are \
                 jumped over",
                other.name()
            ))),
        }
    }

    /// What moves by this protocol from a whole `start`.
    ///
    /// # Errors
    /// Fewer than 3 drones on a line; coverage from a start whose end drones are not at the ends.
    pub fn motion(&self, start: &[Rational]) -> Result<Motion> {
        match self {
            Self::Coverage { min, max, eps } => {
                let p = Params { min: min.clone(), max: max.clone(), eps: eps.clone(), n: 0 };
                Line::coverage(&p, start).map(Motion::Line)
            }
            Self::Consensus { eps } => Line::consensus(eps, start).map(Motion::Line),
            Self::Own(maps) => {
                let maps: Vec<Map> = maps.iter().map(|rows| Map { rows: rows.clone() }).collect();
                let line = match maps.as_slice() {
                    [map] => Line::of_map(map, start),
                    _ => None,
                };
                let course = || Motion::Course(Course::in_turn(&maps, start).into());
                Ok(line.map_or_else(course, Motion::Line))
            }
        }
    }

    /// The line of drones of this protocol from `start`.
    ///
    /// # Errors
    /// As for [`motion`](Self::motion), or it is no line.
    pub fn line(&self, start: &[Rational]) -> Result<Line> {
        self.motion(start)?.into_line("protocol")
    }
}
