//! The certificate of a proof: base case, steps, and that the claims follow, for the checker; and of a
//! counterexample: start, choices, and the claim that fails.

use std::collections::BTreeMap;

use serde_json::Value;

use super::Proved;
use super::automaton::Automaton;
use super::refute::Run;
use super::search::Proof;
use crate::certificate::judged;
use crate::certificate::linear::{
    Counterexample, Edge, Invariance, LinearSystem, Move, Multipliers, NodeClaim, form,
};
use cordon_core::exact::fraction;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::system::{ParameterKind, System, inequalities};
use cordon_core::{Error, Rational, Result};

/// The name of the node that holds what is assumed.
const START: &str = "start";

/// The system in the checker's words.
pub fn linear_system(system: &System) -> LinearSystem {
    let modes = system.modes.iter().map(|mode| {
        let updates = mode.updates(&system.state, &system.parameters);
        let changed = system.state.iter().cloned().zip(updates).filter(|(name, next)| name != next);
        (mode.name.clone(), changed.collect())
    });
    let range = |p: &cordon_core::system::Parameter| {
        (p.name.clone(), [fraction(&p.low), fraction(&p.high)])
    };
    LinearSystem {
        state: system.state.clone(),
        parameters: system.parameters.iter().map(range).collect(),
        modes: modes.collect(),
    }
}

/// A comparison in the checker's words.
pub fn literal(system: &System, c: &Constraint) -> Option<String> {
    let (constant, coefficients) = c.form.parts()?;
    let names = system.state.iter().map(String::as_str);
    let sign = match c.sign {
        Sign::Positive => ">",
        Sign::NonNegative => ">=",
        Sign::Zero => "=",
    };
    Some(format!("{} {sign} 0", form(constant, names.zip(coefficients))))
}

/// The certificate of a proof.
pub fn certificate(system: &System, proof: &Proof) -> Option<Value> {
    let automaton = Automaton::of(system);
    // The place of every row among those of its moment.
    let mut nodes: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut index = Vec::new();
    for row in &proof.rows {
        let node = nodes.entry(automaton.names.get(row.moment)?.clone()).or_default();
        index.push(node.len());
        node.push(literal(system, &row.is)?);
    }
    let sparse =
        |m: &[(usize, Rational)], at: &dyn Fn(usize) -> Option<usize>| -> Option<Multipliers> {
            m.iter().map(|(j, m)| Some((at(*j)?, fraction(m)))).collect()
        };
    let starts = system.start_constraints();
    let assumed = starts.iter().map(|c| literal(system, c)).collect::<Option<Vec<_>>>()?;
    nodes.insert(START.to_owned(), assumed);
    let base = |j: usize| proof.base.iter().find(|(row, _)| *row == j).map(|(_, m)| m);
    let first = automaton.names.first()?;
    let of_moment =
        |moment: usize| proof.rows.iter().enumerate().filter(move |(_, r)| r.moment == moment);
    let entry = of_moment(0)
        .map(|(j, _)| Some(vec![sparse(base(j)?, &Some)?]))
        .collect::<Option<Vec<_>>>()?;
    let enter = Edge { from: START.to_owned(), by: None, to: first.clone(), multipliers: entry };
    let mut edges = vec![enter];
    for (e, edge) in automaton.edges.iter().enumerate() {
        let mut multipliers = Vec::new();
        for (j, _) in of_moment(edge.to) {
            let corners = proof.kept.iter().filter(|k| k.row == j && k.edge == e);
            let rows = corners.map(|k| sparse(&k.multipliers, &|j| index.get(j).copied()));
            multipliers.push(rows.collect::<Option<Vec<_>>>()?);
        }
        edges.push(Edge {
            from: automaton.names.get(edge.from)?.clone(),
            by: Some(system.modes.get(edge.mode)?.name.clone()),
            to: automaton.names.get(edge.to)?.clone(),
            multipliers,
        });
    }
    for name in &automaton.names {
        nodes.entry(name.clone()).or_default();
    }
    let mut claims = Vec::new();
    for (moment, about) in automaton.claims.iter().enumerate() {
        for &j in about {
            for is in inequalities(&system.claims.get(j)?.predicate.is) {
                let (row, _) = of_moment(moment).find(|(_, r)| r.is == is)?;
                claims.push(NodeClaim {
                    at: automaton.names.get(moment)?.clone(),
                    holds: literal(system, &is)?,
                    multipliers: [(*index.get(row)?, "1".to_owned())].into(),
                });
            }
        }
    }
    let start = START.to_owned();
    Invariance { system: linear_system(system), nodes, start, edges, claims }.certificate()
}

/// The certificate of a proof, accepted by the checker; or why that cannot judge it.
///
/// # Errors
/// The checker rejects it.
pub fn certified(found: &Proved) -> Result<std::result::Result<Value, String>> {
    let certificate = certificate(&found.system, &found.proof)
        .ok_or_else(|| Error::internal("a proof without a certificate"))?;
    within_limits(certificate)
}

/// The certificate, accepted by the checker; or why that cannot judge it: it is too large.
///
/// # Errors
/// The checker rejects it.
pub fn within_limits(certificate: Value) -> Result<std::result::Result<Value, String>> {
    match judged(&certificate) {
        Ok(_) => Ok(Ok(certificate)),
        Err(Error::Input(reason)) => Ok(Err(reason)),
        Err(e) => Err(e),
    }
}

/// The certificate of a counterexample.
pub fn counterexample(system: &System, run: &Run) -> Option<Value> {
    let named = |values: &[Rational], constant: bool| -> BTreeMap<String, String> {
        let all = system.parameters.iter().zip(values);
        let some = all.filter(|(p, _)| (p.kind == ParameterKind::Constant) == constant);
        some.map(|(p, value)| (p.name.clone(), fraction(value))).collect()
    };
    let starts = system.start_constraints();
    let mut steps = Vec::new();
    for choice in &run.choices {
        let by = system.modes.get(choice.mode)?.name.clone();
        steps.push(Move { by, with: named(&choice.values, false) });
    }
    let found = Counterexample {
        system: linear_system(system),
        assumptions: starts.iter().map(|c| literal(system, c)).collect::<Option<Vec<_>>>()?,
        start: run.states.first()?.iter().map(fraction).collect(),
        with: named(&run.values, true),
        steps,
        claim: literal(system, &system.claims.get(run.claim)?.predicate.is)?,
    };
    Some(found.certificate())
}
