//! The protocols that the fast engines take: the spec, on any scalar.

use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::graph::Path;
use cordon_spec::{Params, Scalar, State};

use super::line::Line;
use crate::scenario::{Protocol, Scenario, Topology};
use cordon_core::{Error, Rational, Result};

/// A protocol on a line of drones.
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
}

impl<S: Scalar> Rule<S> {
    /// One protocol step of the spec itself.
    pub fn step(&self, x: Vec<S>) -> Vec<S> {
        match self {
            Self::Coverage { min, max, eps } => {
                // Every tick is a step: the counter plays no part.
                let p = Params { min: min.clone(), max: max.clone(), eps: eps.clone(), n: 0 };
                exec_coverage(&p, &State { drones: x, timesteps: 0 }).drones
            }
            Self::Consensus { eps } => exec_consensus(eps, &Path { count: x.len() }, &x),
        }
    }

    /// The same protocol on other scalars, where `f` has an image of every parameter.
    pub fn map<T>(&self, f: impl Fn(&S) -> Option<T>) -> Option<Rule<T>> {
        Some(match self {
            Self::Coverage { min, max, eps } => {
                Rule::Coverage { min: f(min)?, max: f(max)?, eps: f(eps)? }
            }
            Self::Consensus { eps } => Rule::Consensus { eps: f(eps)? },
        })
    }
}

impl Rule<Rational> {
    /// The protocol of a scenario.
    ///
    /// # Errors
    /// Formation, and consensus on another graph than the path.
    pub fn of(scenario: &Scenario) -> Result<Self> {
        let eps = scenario.weight.clone();
        match &scenario.protocol {
            Protocol::Coverage { min, max } => {
                Ok(Self::Coverage { min: min.clone(), max: max.clone(), eps })
            }
            Protocol::Consensus { graph: Topology::Path(_) } => Ok(Self::Consensus { eps }),
            other => Err(Error::input(format!(
                "protocol: `{}`: expected coverage, or consensus on the path, where steps are \
                 jumped over",
                other.name()
            ))),
        }
    }

    /// The line of drones of this protocol from `start`.
    ///
    /// # Errors
    /// Fewer than 3 drones; coverage from a start whose end drones are not at the ends.
    pub fn line(&self, start: &[Rational]) -> Result<Line> {
        match self {
            Self::Coverage { min, max, eps } => {
                let p = Params { min: min.clone(), max: max.clone(), eps: eps.clone(), n: 0 };
                Line::coverage(&p, start)
            }
            Self::Consensus { eps } => Line::consensus(eps, start),
        }
    }
}
