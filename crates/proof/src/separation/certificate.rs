//! What was found about a response, as certificates of the kind `invariance`.

use std::collections::BTreeMap;

use cordon_core::Rational;
use cordon_core::linear::matrix::{Matrix, dot, transposed};
use num_traits::{One, Zero};
use serde_json::Value;

use super::path::Path;
use super::{Cone, Negative, Response};
use crate::certificate::linear::{
    Edge, Invariance, LinearSystem, Multipliers, NodeClaim, form, multipliers,
};

const STEP: &str = "step";
const KEPT: &str = "kept";

fn after(step: usize) -> String {
    format!("after{step}")
}

/// No readout is ever negative, from any nonnegative combination of the starts: the states of the
/// first steps, and then the cone.
pub fn nonnegative(response: &Response, cone: &Cone) -> Value {
    let starts: Vec<usize> = (0..response.starts.len()).collect();
    let chain = Chain::new(response, &starts, cone.entered);
    let mut whole = chain.unrolled(response, ">=");
    let rows = cone.rows.iter();
    whole.nodes.insert(KEPT.to_owned(), rows.map(|f| chain.literal(f, ">=")).collect());
    whole.edges.push(Edge {
        from: after(cone.entered),
        by: None,
        to: KEPT.to_owned(),
        multipliers: cone.rows.iter().map(|f| vec![chain.follows(f, cone.entered)]).collect(),
    });
    whole.edges.push(Edge {
        from: KEPT.to_owned(),
        by: Some(STEP.to_owned()),
        to: KEPT.to_owned(),
        multipliers: cone.multipliers.iter().map(|m| vec![multipliers(m)]).collect(),
    });
    for (readout, combination) in response.readouts.iter().zip(&cone.readouts) {
        let holds = chain.literal(readout, ">=");
        let early = (0..=cone.entered).map(|step| (after(step), chain.follows(readout, step)));
        let claims = early.chain([(KEPT.to_owned(), multipliers(combination))]);
        whole.claims.extend(claims.map(|(at, multipliers)| NodeClaim {
            at,
            holds: holds.clone(),
            multipliers,
        }));
    }
    whole.certificate()
}

/// A readout is negative at a step, from the start with any positive factor.
pub fn negative(response: &Response, found: &Negative) -> Value {
    let chain = Chain::new(response, &[found.start], found.step);
    let mut whole = chain.unrolled(response, ">");
    let against: Vec<Rational> =
        response.readouts.get(found.readout).into_iter().flatten().map(|x| -x).collect();
    whole.claims.push(NodeClaim {
        at: after(found.step),
        holds: chain.literal(&against, ">"),
        multipliers: chain.follows(&against, found.step),
    });
    whole.certificate()
}

/// The states of the first steps: after each step, state = sum of starts times their states.
struct Chain {
    /// The state's names, then those of the starts.
    names: Vec<String>,
    size: usize,
    /// For each step, the state of each start.
    states: Vec<Matrix>,
}

impl Chain {
    fn new(response: &Response, starts: &[usize], last: usize) -> Self {
        let starts = || starts.iter().filter_map(|s| response.starts.get(*s));
        let mut paths: Vec<Path> =
            starts().map(|(_, start)| Path::new(&response.matrix, start)).collect();
        let mut states = Vec::new();
        for _ in 0..=last {
            states.push(paths.iter().map(Path::state).collect());
            paths.iter_mut().for_each(Path::step);
        }
        let names = response.state.iter().chain(starts().map(|(name, _)| name));
        Self { names: names.cloned().collect(), size: response.state.len(), states }
    }

    fn form(&self, coefficients: &[Rational]) -> String {
        form(&Rational::zero(), self.names.iter().map(String::as_str).zip(coefficients))
    }

    fn literal(&self, row: &[Rational], relation: &str) -> String {
        format!("{} {relation} 0", self.form(row))
    }

    /// System, the chain's nodes and its edges; the starts' factors are `relation` 0.
    fn unrolled(&self, response: &Response, relation: &str) -> Invariance {
        let updates = self.names.iter().zip(response.matrix.iter().map(|row| self.form(row)));
        let step = updates.map(|(name, row)| (name.clone(), row)).collect();
        let factors = || self.names.iter().enumerate().skip(self.size);
        let nodes = self.states.iter().enumerate().map(|(step, states)| {
            let equations = transposed(states).into_iter().enumerate().map(|(i, parts)| {
                let mut row = vec![Rational::zero(); self.size];
                row[i] = Rational::one();
                row.extend(parts.into_iter().map(|x| -x));
                self.literal(&row, "=")
            });
            let factors = factors().map(|(_, name)| format!("{name} {relation} 0"));
            (after(step), equations.chain(factors).collect())
        });
        let rows: Vec<Vec<Multipliers>> = response
            .matrix
            .iter()
            .map(|row| vec![multipliers(row)])
            .chain(factors().map(|(place, _)| vec![[(place, "1".to_owned())].into()]))
            .collect();
        let edges = (1..self.states.len()).map(|step| Edge {
            from: after(step - 1),
            by: Some(STEP.to_owned()),
            to: after(step),
            multipliers: rows.clone(),
        });
        Invariance {
            system: LinearSystem {
                state: self.names.clone(),
                parameters: BTreeMap::new(),
                modes: [(STEP.to_owned(), step)].into(),
            },
            nodes: nodes.collect(),
            start: after(0),
            edges: edges.collect(),
            claims: Vec::new(),
        }
    }

    /// How a form of the state follows from what is known after a step.
    fn follows(&self, row: &[Rational], step: usize) -> Multipliers {
        let states = self.states.get(step).into_iter().flatten();
        let all: Vec<Rational> =
            row.iter().cloned().chain(states.map(|state| dot(row, state))).collect();
        multipliers(&all)
    }
}
