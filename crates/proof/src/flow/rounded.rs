//! Ellipsoids found in doubles as a certificate, in few digits.

use std::collections::BTreeMap;

use num_traits::{ToPrimitive, Zero};
use serde_json::Value;

use super::inequalities::Search;
use super::plan::{Plan, Way};
use super::{Attempt, Invariant};
use crate::certificate;
use crate::certificate::linear::{Ellipsoid, EllipsoidNode, LinearSystem, Passage};
use crate::claims::certificate::{linear_system, literal};
use cordon_core::exact::{fraction, to_f64};
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::Constraint;
use cordon_core::system::Flow;
use cordon_core::{Error, Rational, Result};

impl Search<'_> {
    /// The certificate for what was found, rounded to multiples of a unit.
    fn certificate(
        &self,
        plan: &Plan,
        decay: &Rational,
        x: &[f64],
        digits: i32,
    ) -> Option<Ellipsoid> {
        let scale = |of: &dyn Fn(usize) -> f64, count: usize| {
            let most = (0..count).map(|i| of(i).abs()).fold(1e-3, f64::max);
            most.log10().ceil().to_i32()
        };
        let rounded = |value: f64, unit: &Rational| {
            let steps = (value / to_f64(unit)).round();
            Some(unit * Rational::from_integer(steps.to_i64()?.into()))
        };
        let mut nodes = BTreeMap::new();
        for (node, name) in plan.names.iter().enumerate() {
            let deviation = |i: usize| x[self.entry(node, i, i)];
            let unit = tens(scale(&deviation, self.size)? - digits);
            let fine = tens(scale(&|i| deviation(i).sqrt(), self.size)? - digits);
            let centre = (0..self.size)
                .map(|i| rounded(x[self.centre(node, i)], &fine).map(|c| fraction(&c)))
                .collect::<Option<_>>()?;
            let row = |i: usize| {
                (0..=i)
                    .map(|j| rounded(x[self.entry(node, i, j)], &unit).map(|q| fraction(&q)))
                    .collect()
            };
            let matrix = (0..self.size).map(row).collect::<Option<_>>()?;
            nodes.insert(name.clone(), EllipsoidNode { centre, matrix });
        }
        let name = |node: usize| plan.names.get(node).cloned();
        let edge = |way: &Way| {
            Some(Passage {
                from: name(way.from)?,
                by: self.flow.system.modes.get(way.mode)?.name.clone(),
                to: name(way.to)?,
                decay: fraction(decay),
                time: way.time.as_ref().map(fraction),
            })
        };
        Some(Ellipsoid {
            system: derivatives(self.flow),
            nodes,
            start: plan.start.iter().map(|n| name(*n)).collect::<Option<_>>()?,
            points: self.starts.iter().map(|p| p.iter().map(fraction).collect()).collect(),
            edges: plan.ways.iter().map(edge).collect::<Option<_>>()?,
            claims: Vec::new(),
        })
    }

    /// The certificate with claims stronger by `spare`.
    fn claiming(&self, of: &Ellipsoid, spare: &Rational) -> Option<Value> {
        let stronger = |c: &Constraint| {
            let form = c.form.clone() - &Affine::constant(spare.clone());
            literal(&self.flow.system, &Constraint { form, sign: c.sign })
        };
        let claims = self.claims.iter().map(stronger).collect::<Option<_>>()?;
        Some(Ellipsoid { claims, ..of.clone() }.certificate())
    }
}

/// The system in the checker's words, rows being derivatives.
fn derivatives(flow: &Flow) -> LinearSystem {
    let system = &flow.system;
    let modes = system.modes.iter().map(|mode| {
        let rows = mode.updates(&system.state, &system.parameters);
        let changing = system.state.iter().cloned().zip(rows).filter(|(_, row)| row != "0");
        (mode.name.clone(), changing.collect())
    });
    LinearSystem { modes: modes.collect(), ..linear_system(system) }
}

fn tens(power: i32) -> Rational {
    let ten = Rational::from_integer(10.into());
    ten.pow(power)
}

/// What was found in few digits, as few as the checker accepts.
pub(super) fn rounded(
    search: &Search<'_>,
    plan: &Plan,
    attempt: &Attempt,
) -> Result<Option<Invariant>> {
    let Attempt { margin, decay, x, .. } = attempt;
    for digits in 3..=9 {
        let Some(found) = search.certificate(plan, decay, x, digits) else { continue };
        let accepted = |spare: &Rational| -> Result<Option<Value>> {
            let Some(certificate) = search.claiming(&found, spare) else { return Ok(None) };
            match certificate::judged(&certificate) {
                Ok(_) => Ok(Some(certificate)),
                Err(Error::Rejected(_)) => Ok(None),
                Err(e) => Err(e),
            }
        };
        let Some(certificate) = accepted(&Rational::zero())? else { continue };
        // Three digits of the margin in doubles, or what is a little below.
        let unit = tens(margin.log10().floor().to_i32().unwrap_or(0) - 2);
        let most = (margin / to_f64(&unit)).floor().to_i64().unwrap_or(0);
        let mut spare = Rational::zero();
        let tries = (0..i64::BITS - 1).map(|j| most + 1 - (1 << j)).take_while(|steps| *steps > 0);
        for steps in tries {
            let wanted = &unit * Rational::from_integer(steps.into());
            if accepted(&wanted)?.is_some() {
                spare = wanted;
                break;
            }
        }
        return Ok(Some(Invariant { certificate, ellipsoids: plan.names.len(), spare }));
    }
    Ok(None)
}
