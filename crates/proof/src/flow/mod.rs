//! Claims about systems in continuous time, by ellipsoids that no run leaves.
//!
//! A run is inside of (x - c)' Q^-1 (x - c) <= 1. For a fixed decay the condition that it stays inside is a linear matrix
//! inequality in Q and c together (`proofs/checker/src/ellipsoid.rs` has it), at each end of each input's range; so is the
//! start. A claim g takes g(c) >= sqrt(l'Ql), which is implied by g(c) >= (m + l'Ql/m)/2 and, where m is the root itself, no more:
//! a few rounds with m from the round before. Where modes act in turn, or each for some time at least, c and Q move
//! straight between ellipsoids at fixed times.

mod barrier;

use std::collections::BTreeMap;

use num_traits::{ToPrimitive, Zero};
use serde_json::Value;

use crate::certificate;
use crate::certificate::linear::{Ellipsoid, EllipsoidNode, LinearSystem, Passage};
use crate::claims::certificate::{linear_system, literal};
use crate::claims::doubles::{Matrix, identity, plus, product, spectral_radius};
use barrier::{Block, Program};
use cordon_core::exact::{fraction, to_f64};
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::linear::simplest::strictly_between;
use cordon_core::system::{Flow, Map, Schedule, Switching, inequalities};
use cordon_core::{Error, Rational, Result};

/// Most variables of the state: what is solved in doubles grows with their fourth power.
const MOST_VARIABLES: usize = 24;

/// Most ellipsoids that one invariant may have.
const MOST_NODES: usize = 200;

/// Most corners of the box of inputs.
const MOST_VERTICES: usize = 64;

/// The claims about a system in continuous time, proved.
#[derive(Clone, Debug)]
pub struct Invariant {
    /// The certificate, accepted by the checker.
    pub certificate: Value,
    /// Number of ellipsoids in the certificate.
    pub ellipsoids: usize,
    /// By how much every claim could be stronger: with all of them as much stronger, the certificate is accepted too.
    pub spare: Rational,
}

/// How a search ended.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The claims hold, and here is the invariant.
    Proved(Box<Invariant>),
    /// With ellipsoids, in doubles, in which the worst claim is missed by so much: its place and that.
    Missed(usize, f64),
    /// No invariant of this kind was found, which decides nothing.
    Open,
}

/// From an ellipsoid to one while a mode acts, for a time or for ever.
struct Way {
    from: usize,
    mode: usize,
    to: usize,
    time: Option<Rational>,
}

/// The ellipsoids wanted, and the ways between them.
struct Plan {
    names: Vec<String>,
    start: Vec<usize>,
    ways: Vec<Way>,
}

impl Plan {
    /// The nodes and edges of a way of switching; `parts` ellipsoids follow each other while a mode acts for a time.
    fn of(flow: &Flow, parts: usize) -> Self {
        let modes = &flow.system.modes;
        let name = |mode: usize| modes.get(mode).map_or("", |m| m.name.as_str());
        let mut plan = Self { names: Vec::new(), start: vec![0], ways: Vec::new() };
        let part = |time: &Rational| time / Rational::from_integer(parts.into());
        match &flow.switching {
            Switching::Any => {
                plan.names.push("kept".to_owned());
                plan.ways.extend((0..modes.len()).map(|mode| Way {
                    from: 0,
                    mode,
                    to: 0,
                    time: None,
                }));
            }
            Switching::Every(time) => {
                let cycle = match &flow.system.schedule {
                    Schedule::Cycle(list) => list.clone(),
                    Schedule::Any => (0..modes.len()).collect(),
                };
                let count = cycle.len() * parts;
                for (turn, mode) in cycle.iter().enumerate() {
                    for k in 0..parts {
                        let from = plan.names.len();
                        plan.names.push(format!("{}.{}", name(*mode), turn * parts + k));
                        let to = (from + 1) % count;
                        plan.ways.push(Way { from, mode: *mode, to, time: Some(part(time)) });
                    }
                }
            }
            Switching::Dwell(time) => {
                plan.names.extend((0..modes.len()).map(|m| name(m).to_owned()));
                plan.start = (0..modes.len()).collect();
                plan.ways.extend((0..modes.len()).map(|mode| Way {
                    from: mode,
                    mode,
                    to: mode,
                    time: None,
                }));
                for before in 0..modes.len() {
                    for mode in (0..modes.len()).filter(|m| *m != before) {
                        let mut from = before;
                        for k in 1..=parts {
                            let to = if k == parts { mode } else { plan.names.len() };
                            if k < parts {
                                plan.names.push(format!(
                                    "{}.after.{}.{k}",
                                    name(mode),
                                    name(before)
                                ));
                            }
                            plan.ways.push(Way { from, mode, to, time: Some(part(time)) });
                            from = to;
                        }
                    }
                }
            }
        }
        plan
    }
}

/// A mode's derivative at a corner of the inputs, in doubles.
struct Corner {
    matrix: Matrix,
    constant: Vec<f64>,
}

/// The claims as forms of which each has to be at least 0.
fn wanted(flow: &Flow) -> Result<Vec<Constraint>> {
    let claims = flow.system.claims.iter().map(|c| &c.predicate);
    if let Some(equation) = claims.clone().find(|p| p.is.sign == Sign::Zero) {
        return Err(Error::input(format!(
            "claims: `{}`: expected no equation in continuous time: an ellipsoid shows none",
            equation.text
        )));
    }
    Ok(claims.flat_map(|p| inequalities(&p.is)).collect())
}

/// The search for one system.
struct Search<'f> {
    flow: &'f Flow,
    size: usize,
    corners: Vec<Vec<Corner>>,
    starts: Vec<Vec<Rational>>,
    claims: Vec<Constraint>,
}

impl<'f> Search<'f> {
    fn new(flow: &'f Flow) -> Result<Self> {
        let size = flow.system.state.len();
        if size > MOST_VARIABLES {
            return Err(Error::input(format!(
                "state: {size} variables: expected at most {MOST_VARIABLES} in continuous time"
            )));
        }
        let mut values = vec![Vec::new()];
        for parameter in &flow.system.parameters {
            values = values
                .iter()
                .flat_map(|v: &Vec<Rational>| {
                    parameter
                        .ends()
                        .into_iter()
                        .map(move |end| v.iter().cloned().chain([end]).collect())
                })
                .collect();
            if values.len() > MOST_VERTICES {
                return Err(Error::input(format!(
                    "parameters: expected at most {MOST_VERTICES} corners of their ranges in continuous time"
                )));
            }
        }
        let corner = |map: &Map| {
            let mut matrix = vec![vec![0.0; size]; size];
            for (row, (_, entries)) in matrix.iter_mut().zip(&map.rows) {
                for (j, a) in entries {
                    if let Some(x) = row.get_mut(*j) {
                        *x = to_f64(a);
                    }
                }
            }
            Corner { matrix, constant: map.rows.iter().map(|(b, _)| to_f64(b)).collect() }
        };
        let corners =
            flow.system.modes.iter().map(|m| values.iter().map(|v| corner(&m.at(v))).collect());
        let (corners, starts) = (corners.collect(), flow.corners()?);
        Ok(Self { flow, size, corners, starts, claims: wanted(flow)? })
    }

    /// How slowly runs die away, over all modes: the greatest real part of an eigenvalue.
    fn slowest(&self) -> f64 {
        let growth = |corner: &Corner| {
            // exp(A/s) by its series, then squared.
            let scale = corner.matrix.iter().flatten().fold(1.0_f64, |m, x| m.max(x.abs()))
                * self.size as f64;
            let unit = identity(self.size);
            let mut exp = unit.clone();
            for k in (1..=12).rev() {
                exp = plus(&unit, 1.0 / (scale * f64::from(k)), &product(&corner.matrix, &exp));
            }
            scale * spectral_radius(&exp).ln()
        };
        self.corners.iter().flatten().map(growth).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The place of an entry of a node's matrix among the variables.
    fn entry(&self, node: usize, i: usize, j: usize) -> usize {
        let (i, j) = (i.max(j), i.min(j));
        node * self.per_node() + i * (i + 1) / 2 + j
    }

    fn centre(&self, node: usize, i: usize) -> usize {
        node * self.per_node() + self.size * (self.size + 1) / 2 + i
    }

    fn per_node(&self) -> usize {
        self.size * (self.size + 3) / 2
    }

    /// What keeps runs inside, for a decay.
    fn blocks(&self, plan: &Plan, decay: f64) -> Vec<Block> {
        let n = self.size;
        let mut blocks = Vec::new();
        for node in 0..plan.names.len() {
            let mut positive = Block::new(vec![vec![0.0; n]; n]);
            for i in 0..n {
                for j in 0..=i {
                    positive.add(self.entry(node, i, j), i, j, 1.0);
                }
            }
            blocks.push(positive);
        }
        for node in &plan.start {
            for point in &self.starts {
                let mut constant = vec![vec![0.0; n + 1]; n + 1];
                constant[n][n] = 1.0;
                for (i, x) in point.iter().enumerate() {
                    (constant[i][n], constant[n][i]) = (to_f64(x), to_f64(x));
                }
                let mut inside = Block::new(constant);
                for i in 0..n {
                    inside.add(self.centre(*node, i), i, n, -1.0);
                    for j in 0..=i {
                        inside.add(self.entry(*node, i, j), i, j, 1.0);
                    }
                }
                blocks.push(inside);
            }
        }
        for way in &plan.ways {
            let ends = if way.time.is_some() { vec![way.from, way.to] } else { vec![way.from] };
            let rate = way.time.as_ref().map_or(0.0, |t| 1.0 / to_f64(t));
            for (corner, node) in
                self.corners[way.mode].iter().flat_map(|c| ends.iter().map(move |e| (c, *e)))
            {
                let mut constant = vec![vec![0.0; n + 1]; n + 1];
                constant[n][n] = decay;
                for (i, b) in corner.constant.iter().enumerate() {
                    (constant[i][n], constant[n][i]) = (-b, -b);
                }
                let mut block = Block::new(constant);
                for i in 0..n {
                    for k in 0..n {
                        let a = corner.matrix[i][k];
                        block.add(self.centre(node, k), i, n, -a);
                        // -(AQ)_ij, twice where i = j, for AQ and QA'.
                        for j in 0..n {
                            let by = if i == j { -2.0 * a } else { -a };
                            block.add(self.entry(node, k, j), i, j, by);
                        }
                    }
                    if rate > 0.0 {
                        block.add(self.centre(way.to, i), i, n, rate);
                        block.add(self.centre(way.from, i), i, n, -rate);
                    }
                    for j in 0..=i {
                        block.add(self.entry(node, i, j), i, j, -decay);
                        if rate > 0.0 {
                            block.add(self.entry(way.to, i, j), i, j, rate);
                            block.add(self.entry(way.from, i, j), i, j, -rate);
                        }
                    }
                }
                blocks.push(block);
            }
        }
        blocks
    }

    /// l'Ql of a claim in an ellipsoid.
    fn width(&self, claim: &Affine, node: usize, x: &[f64]) -> f64 {
        let coefficients = claim.parts().map(|(_, c)| c).unwrap_or_default();
        let mut sum = 0.0;
        for (i, a) in coefficients.iter().enumerate() {
            for (j, b) in coefficients.iter().enumerate() {
                sum += to_f64(a) * to_f64(b) * x[self.entry(node, i, j)];
            }
        }
        sum
    }

    fn at_centre(&self, claim: &Affine, node: usize, x: &[f64]) -> f64 {
        let Some((constant, coefficients)) = claim.parts() else { return f64::NEG_INFINITY };
        let terms =
            coefficients.iter().enumerate().map(|(i, a)| to_f64(a) * x[self.centre(node, i)]);
        to_f64(constant) + terms.sum::<f64>()
    }

    /// The claim with the worst margin, and that.
    fn margin(&self, plan: &Plan, x: &[f64]) -> (usize, f64) {
        let of = |(index, claim): (usize, &Constraint), node: usize| {
            let margin =
                self.at_centre(&claim.form, node, x) - self.width(&claim.form, node, x).sqrt();
            (index, margin)
        };
        let nodes = 0..plan.names.len();
        let all = nodes.flat_map(|n| self.claims.iter().enumerate().map(move |c| of(c, n)));
        all.fold((0, f64::INFINITY), |worst, c| if c.1 < worst.1 { c } else { worst })
    }

    /// That no ellipsoid is larger than so: by the traces. Without, those of a barrier grow for ever.
    fn bounds(&self, plan: &Plan, most: f64) -> Vec<Block> {
        let bound = |node: usize| {
            let mut block = Block::new(vec![vec![most]]);
            for i in 0..self.size {
                block.add(self.entry(node, i, i), 0, 0, -1.0);
            }
            block
        };
        (0..plan.names.len()).map(bound).collect()
    }

    /// Ellipsoids, in doubles, with the greatest worst margin that is found for a decay.
    fn solve(&self, plan: &Plan, decay: f64, rounds: usize) -> Option<Vec<f64>> {
        let mut blocks = self.blocks(plan, decay);
        let variables = plan.names.len() * self.per_node();
        let mut x = vec![0.0; variables];
        for node in 0..plan.names.len() {
            for i in 0..self.size {
                x[self.entry(node, i, i)] = 1.0;
            }
        }
        // Small ones first.
        let (most, mut x) = SIZES.iter().find_map(|&most| {
            let blocks = [blocks.as_slice(), &self.bounds(plan, most)].concat();
            Some((most, Program { variables, blocks, objective: 0 }.feasible(&x)?))
        })?;
        blocks.extend(self.bounds(plan, 100.0 * most));
        for _ in 0..rounds {
            let (_, margin) = self.margin(plan, &x);
            let mut program =
                Program { variables: variables + 1, blocks: blocks.clone(), objective: variables };
            for (claim, node) in
                self.claims.iter().flat_map(|c| (0..plan.names.len()).map(move |n| (c, n)))
            {
                let (constant, coefficients) = claim.form.parts()?;
                let root = self.width(&claim.form, node, &x).sqrt();
                let mut block = Block::new(vec![vec![to_f64(constant) - root / 2.0]]);
                block.add(variables, 0, 0, -1.0);
                for (i, a) in coefficients.iter().enumerate() {
                    block.add(self.centre(node, i), 0, 0, to_f64(a));
                    for (j, b) in coefficients.iter().enumerate() {
                        block.add(
                            self.entry(node, i, j),
                            0,
                            0,
                            -to_f64(a) * to_f64(b) / (2.0 * root),
                        );
                    }
                }
                program.blocks.push(block);
            }
            let start: Vec<f64> =
                x.iter().copied().chain([margin - 1.0 - margin.abs() / 100.0]).collect();
            // Not all the way: what is at the end of it has no room to be rounded in.
            let mut found = program.maximise(&start, 2e-3 * (1.0 + margin.abs()), f64::INFINITY)?;
            found.pop();
            x = found;
        }
        Some(x)
    }

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

/// What was found in doubles for a decay.
struct Attempt {
    worst: usize,
    margin: f64,
    part: f64,
    decay: Rational,
    x: Vec<f64>,
}

/// Ellipsoids on the way, while a mode acts for a time: few first.
const PARTS: [usize; 3] = [2, 4, 8];

/// Traces of ellipsoids that are tried.
const SIZES: [f64; 5] = [1e2, 1e4, 1e6, 1e8, 1e10];

/// The decays that are tried, as parts of what the slowest mode allows.
const DECAYS: [f64; 6] = [0.3, 0.45, 0.15, 0.6, 0.75, 0.9];

/// Searches ellipsoids that show the claims.
///
/// # Errors
/// The system is too large, its starts are no box, or it claims an equation.
pub fn prove(flow: &Flow) -> Result<Answer> {
    let search = Search::new(flow)?;
    let slowest = search.slowest();
    if slowest >= 0.0 {
        return Ok(Answer::Open);
    }
    let parts: &[usize] = if flow.switching == Switching::Any { &PARTS[..1] } else { &PARTS };
    let mut best: Option<(usize, f64)> = None;
    for parts in parts {
        let plan = Plan::of(flow, *parts);
        if plan.names.len() > MOST_NODES {
            break;
        }
        let mut tried: Vec<Attempt> = Vec::new();
        let rounds = if plan.names.len() == 1 { 3 } else { 2 };
        let attempt = |part: f64, tried: &mut Vec<Attempt>| {
            // A simple one near by, the same in doubles and in the certificate.
            let near = |to: f64| Rational::from_float(-2.0 * slowest * part * to);
            let decay = near(0.98).zip(near(1.02)).and_then(|(a, b)| strictly_between(&a, &b))?;
            let x = search.solve(&plan, to_f64(&decay), rounds)?;
            let (worst, margin) = search.margin(&plan, &x);
            tried.push(Attempt { worst, margin, part, decay, x });
            Some(())
        };
        // Many ellipsoids are slow: the middle of the decays, and enough where it holds.
        let decays = if plan.names.len() == 1 { &DECAYS[..] } else { &DECAYS[..2] };
        for part in decays {
            attempt(*part, &mut tried);
            if plan.names.len() > 1 && tried.last().is_some_and(|a| a.margin > 0.0) {
                break;
            }
        }
        let largest = |a: &Attempt, b: &Attempt| b.margin.total_cmp(&a.margin);
        tried.sort_by(largest);
        if let (1, Some(part)) = (plan.names.len(), tried.first().map(|a| a.part)) {
            for near in [part - 0.07, part + 0.07] {
                attempt(near, &mut tried);
            }
            tried.sort_by(largest);
        }
        let Some(found) = tried.first() else { continue };
        if best.is_none_or(|(_, margin)| found.margin > margin) {
            best = Some((found.worst, found.margin));
        }
        if found.margin > 0.0
            && let Some(found) = rounded(&search, &plan, found)?
        {
            return Ok(Answer::Proved(Box::new(found)));
        }
    }
    Ok(best.map_or(Answer::Open, |(worst, margin)| Answer::Missed(worst, -margin)))
}

fn tens(power: i32) -> Rational {
    let ten = Rational::from_integer(10.into());
    ten.pow(power)
}

/// What was found in few digits, as few as the checker accepts.
fn rounded(search: &Search<'_>, plan: &Plan, attempt: &Attempt) -> Result<Option<Invariant>> {
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
