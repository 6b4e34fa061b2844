//! Protocols as Rust types: the spec's own, and a user's.

use cordon_spec::consensus::exec_consensus;
use cordon_spec::coverage::exec_coverage;
use cordon_spec::graph::Graph;
use cordon_spec::{Params, Scalar, State};

use super::{Parameter, ParameterKind};
use crate::Rational;

/// A protocol whose step is one generic function. [`System::of`](super::System::of) turns a type that
/// implements it into a system for every engine.
pub trait Protocol {
    /// Number of agents, at least 1.
    fn agents(&self) -> usize;

    /// Names of the state variables of an agent, letters only.
    fn variables(&self) -> Vec<&str> {
        vec!["x"]
    }

    /// The parameters, in the order in which `step` takes them.
    fn parameters(&self) -> Vec<Parameter>;

    /// A title, for display.
    fn title(&self) -> String {
        "a protocol".to_owned()
    }

    /// The next state, agent by agent. `number` embeds numbers; the step may add, subtract and
    /// multiply, and branch on indices only.
    fn step<S: Scalar>(
        &self,
        number: &impl Fn(&Rational) -> S,
        parameters: &[S],
        x: &[S],
    ) -> Vec<S>;
}

/// The paper's coverage protocol (equation 10) on the segment \[min, max\].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coverage {
    /// Number of drones, at least 2.
    pub count: usize,
    /// Position of the first drone, the left end of the segment.
    pub min: Rational,
    /// Position of the last drone, the right end of the segment.
    pub max: Rational,
    /// Least and greatest weight.
    pub eps: (Rational, Rational),
}

/// The weight of the neighbours as a parameter.
fn eps((low, high): &(Rational, Rational)) -> Parameter {
    let (low, high) = (low.clone(), high.clone());
    Parameter { name: "eps".to_owned(), low, high, kind: ParameterKind::Constant }
}

impl Protocol for Coverage {
    fn agents(&self) -> usize {
        self.count
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![eps(&self.eps)]
    }

    fn title(&self) -> String {
        "coverage".to_owned()
    }

    fn step<S: Scalar>(
        &self,
        number: &impl Fn(&Rational) -> S,
        parameters: &[S],
        x: &[S],
    ) -> Vec<S> {
        let eps = parameters.first().cloned().unwrap_or_else(|| S::from_int(0));
        let p = Params { min: number(&self.min), max: number(&self.max), eps, n: 0 };
        exec_coverage(&p, &State { drones: x.to_vec(), timesteps: 0 }).drones
    }
}

/// Consensus (equation 6) on a graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Consensus<G> {
    /// Which agents each one hears.
    pub graph: G,
    /// Least and greatest weight.
    pub eps: (Rational, Rational),
}

impl<G: Graph> Protocol for Consensus<G> {
    fn agents(&self) -> usize {
        self.graph.count()
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![eps(&self.eps)]
    }

    fn title(&self) -> String {
        "consensus".to_owned()
    }

    fn step<S: Scalar>(&self, _: &impl Fn(&Rational) -> S, parameters: &[S], x: &[S]) -> Vec<S> {
        let eps = parameters.first().cloned().unwrap_or_else(|| S::from_int(0));
        exec_consensus(&eps, &self.graph, &x.to_vec())
    }
}
