//! Certificates, of the kind `invariance`, for results about a response.
//!
//! The first steps are a chain of nodes with bounds for the state: exact numbers grow with every step,
//! bounds with a fixed number of decimals do not.

use std::collections::BTreeMap;

use cordon_core::Rational;
use cordon_core::linear::matrix::{Matrix, transposed};
use num_bigint::BigInt;
use num_traits::{Pow, Signed, Zero};
use serde_json::Value;

use super::{Cone, Negative, Response};
use crate::certificate::linear::{
    Edge, Invariance, LinearSystem, Multipliers, NodeClaim, form, multipliers,
};

const STEP: &str = "step";
const KEPT: &str = "kept";

/// Decimal places of the bounds, tried in turn.
const PLACES: [u32; 7] = [10, 16, 24, 36, 54, 81, 120];

/// Steps by which bounds may enter a cone later than the states that they enclose.
const LATER: usize = 10;

fn after(step: usize) -> String {
    format!("after{step}")
}

/// Certifies that no readout is ever negative, from any nonnegative combination of the starts: first a
/// chain of states, then the cone. `None` where the bounds that were tried are too wide.
pub fn nonnegative(response: &Response, cone: &Cone) -> Option<Value> {
    PLACES.into_iter().find_map(|places| entering(response, cone, places))
}

fn entering(response: &Response, cone: &Cone, places: u32) -> Option<Value> {
    let starts: Vec<usize> = (0..response.starts.len()).collect();
    let mut chain = Chain::new(response, &starts, places);
    let mut claims = Vec::new();
    let into_cone = loop {
        for readout in &response.readouts {
            claims.push(chain.claim(readout, ">=")?);
        }
        let rows = cone.rows.iter().map(|f| Some(vec![chain.follows(f, None)?]));
        if let Some(rows) = rows.collect::<Option<Vec<_>>>() {
            break rows;
        }
        if chain.step() > cone.entered + LATER {
            return None;
        }
        chain.advance()?;
    };
    let edge = |from: String, by: Option<&str>, multipliers| Edge {
        from,
        by: by.map(str::to_owned),
        to: KEPT.to_owned(),
        multipliers,
    };
    let kept = cone.multipliers.iter().map(|m| vec![multipliers(m)]).collect();
    let entry = edge(after(chain.step()), None, into_cone);
    for (readout, combination) in response.readouts.iter().zip(&cone.readouts) {
        claims.push(NodeClaim {
            at: KEPT.to_owned(),
            holds: chain.literal(readout, ">="),
            multipliers: multipliers(combination),
        });
    }
    let rows = cone.rows.iter().map(|f| chain.literal(f, ">=")).collect();
    let mut whole = chain.unrolled(response, ">=", claims);
    whole.nodes.insert(KEPT.to_owned(), rows);
    whole.edges.extend([entry, edge(KEPT.to_owned(), Some(STEP), kept)]);
    whole.certificate()
}

/// Certifies that a readout is negative at a step, from any positive multiple of the start.
pub fn negative(response: &Response, found: &Negative) -> Option<Value> {
    let against: Vec<Rational> = response.readouts.get(found.readout)?.iter().map(|x| -x).collect();
    PLACES.into_iter().find_map(|places| {
        let mut chain = Chain::new(response, &[found.start], places);
        while chain.step() < found.step {
            chain.advance()?;
        }
        let claim = chain.claim(&against, ">")?;
        let strictly = chain.least(&against).iter().all(Signed::is_positive);
        strictly.then(|| chain.unrolled(response, ">", vec![claim]).certificate())?
    })
}

/// Bounds for the state after a step: `low s <= state <= high s`, where s has the factors of the
/// starts.
struct Bounds {
    low: Matrix,
    high: Matrix,
}

/// The bounds after each of the first steps.
struct Chain<'r> {
    matrix: &'r Matrix,
    /// The names of the state, then those of the starts.
    names: Vec<String>,
    size: usize,
    /// One unit in the last place of the bounds.
    unit: Rational,
    /// The first bounds are exact, with both ends equal.
    known: Vec<Bounds>,
    edges: Vec<Edge>,
}

impl<'r> Chain<'r> {
    fn new(response: &'r Response, starts: &[usize], places: u32) -> Self {
        let starts = || starts.iter().filter_map(|s| response.starts.get(*s));
        let exact = transposed(&starts().map(|(_, state)| state.clone()).collect());
        let names = response.state.iter().chain(starts().map(|(name, _)| name));
        Self {
            matrix: &response.matrix,
            names: names.cloned().collect(),
            size: response.state.len(),
            unit: Rational::from_integer(BigInt::from(10).pow(places)).recip(),
            known: vec![Bounds { low: exact.clone(), high: exact }],
            edges: Vec::new(),
        }
    }

    /// The last step with bounds.
    fn step(&self) -> usize {
        self.known.len() - 1
    }

    /// Adds the bounds after one more step.
    fn advance(&mut self) -> Option<()> {
        let down = |x: &Rational| (x / &self.unit).floor() * &self.unit;
        let negated = |row: &[Rational]| -> Vec<Rational> { row.iter().map(|x| -x).collect() };
        let low: Matrix =
            self.matrix.iter().map(|row| self.least(row).iter().map(down).collect()).collect();
        let least = |row: &Vec<Rational>| self.least(&negated(row)).iter().map(down).collect();
        let opposite: Matrix = self.matrix.iter().map(least).collect();
        let rows = self.matrix.iter().zip(&low).map(|(row, low)| self.follows(row, Some(low)));
        let from_above = self.matrix.iter().zip(&opposite);
        let from_above = from_above.map(|(row, low)| self.follows(&negated(row), Some(low)));
        let places = if self.step() == 0 { self.size } else { 2 * self.size };
        let starts = 0..self.names.len() - self.size;
        let kept = starts.map(|s| Some([(places + s, "1".to_owned())].into()));
        let rows = rows.chain(from_above).chain(kept);
        let multipliers = rows.map(|row| Some(vec![row?])).collect::<Option<_>>()?;
        self.edges.push(Edge {
            from: after(self.step()),
            by: Some(STEP.to_owned()),
            to: after(self.step() + 1),
            multipliers,
        });
        let high = opposite.iter().map(|row| negated(row)).collect();
        self.known.push(Bounds { low, high });
        Some(())
    }

    /// The lower bound of a form of the state after the last step, in multiples of the starts.
    fn least(&self, row: &[Rational]) -> Vec<Rational> {
        let mut sum = vec![Rational::zero(); self.names.len() - self.size];
        for (c, (low, high)) in self.known.last().iter().flat_map(|now| {
            row.iter().zip(now.low.iter().zip(&now.high)).filter(|(c, _)| !c.is_zero())
        }) {
            let bound = if c.is_negative() { high } else { low };
            sum.iter_mut().zip(bound).for_each(|(s, b)| *s += c * b);
        }
        sum
    }

    /// Multipliers that show that a form of the state is at least these multiples of the starts (or at
    /// least 0) after the last step. `None` where the bounds do not imply it.
    fn follows(&self, row: &[Rational], least: Option<&Vec<Rational>>) -> Option<Multipliers> {
        let mut left = self.least(row);
        if let Some(least) = least {
            left.iter_mut().zip(least).for_each(|(l, b)| *l -= b);
        }
        if left.iter().any(Signed::is_negative) {
            return None;
        }
        let all: Vec<Rational> = if self.step() == 0 {
            row.iter().cloned().chain(left).collect()
        } else {
            let part = |negative| {
                row.iter().map(move |c| match c.is_negative() == negative {
                    true => c.abs(),
                    false => Rational::zero(),
                })
            };
            part(false).chain(part(true)).chain(left).collect()
        };
        Some(multipliers(&all))
    }

    /// The claim that a form of the state compares with 0 as `relation` after the last step.
    fn claim(&self, row: &[Rational], relation: &str) -> Option<NodeClaim> {
        let multipliers = self.follows(row, None)?;
        Some(NodeClaim { at: after(self.step()), holds: self.literal(row, relation), multipliers })
    }

    fn form(&self, coefficients: &[Rational]) -> String {
        form(&Rational::zero(), self.names.iter().map(String::as_str).zip(coefficients))
    }

    fn literal(&self, row: &[Rational], relation: &str) -> String {
        format!("{} {relation} 0", self.form(row))
    }

    /// The certificate with the chain alone; `relation` compares the factors of the starts with 0.
    fn unrolled(self, response: &Response, relation: &str, claims: Vec<NodeClaim>) -> Invariance {
        let updates = self.names.iter().zip(response.matrix.iter().map(|row| self.form(row)));
        let step = updates.map(|(name, row)| (name.clone(), row)).collect();
        let one = |i: usize, bounds: &[Rational], sign: i32, relation: &str| {
            let sign = Rational::from_integer(sign.into());
            let mut row = vec![Rational::zero(); self.size];
            row[i].clone_from(&sign);
            row.extend(bounds.iter().map(|x| -x * &sign));
            self.literal(&row, relation)
        };
        let side = |side: &Matrix, sign: i32, relation: &str| -> Vec<String> {
            side.iter().enumerate().map(|(i, bounds)| one(i, bounds, sign, relation)).collect()
        };
        let nodes = self.known.iter().enumerate().map(|(step, now)| {
            let mut literals = match step {
                0 => side(&now.low, 1, "="),
                _ => [side(&now.low, 1, ">="), side(&now.high, -1, ">=")].concat(),
            };
            let factors = self.names.iter().skip(self.size);
            literals.extend(factors.map(|name| format!("{name} {relation} 0")));
            (after(step), literals)
        });
        Invariance {
            nodes: nodes.collect(),
            system: LinearSystem {
                state: self.names.clone(),
                parameters: BTreeMap::new(),
                modes: [(STEP.to_owned(), step)].into(),
            },
            start: after(0),
            edges: self.edges,
            claims,
        }
    }
}
