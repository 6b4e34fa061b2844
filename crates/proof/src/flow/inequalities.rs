//! The linear matrix inequalities of a plan of ellipsoids, and their solutions in doubles.

use super::barrier::{Block, Program};
use super::plan::Plan;
use crate::claims::doubles::{Matrix, identity, plus, product, spectral_radius};
use cordon_core::exact::to_f64;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::system::{Flow, Map, inequalities};
use cordon_core::{Error, Rational, Result};

/// Most variables of the state: what is solved in doubles grows with their fourth power.
const MOST_VARIABLES: usize = 24;

/// Most corners of the box of inputs.
const MOST_VERTICES: usize = 64;

/// Traces of ellipsoids that are tried.
const SIZES: [f64; 5] = [1e2, 1e4, 1e6, 1e8, 1e10];

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
pub(super) struct Search<'f> {
    pub(super) flow: &'f Flow,
    pub(super) size: usize,
    corners: Vec<Vec<Corner>>,
    pub(super) starts: Vec<Vec<Rational>>,
    pub(super) claims: Vec<Constraint>,
}

impl<'f> Search<'f> {
    pub(super) fn new(flow: &'f Flow) -> Result<Self> {
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
    pub(super) fn slowest(&self) -> f64 {
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
    pub(super) fn entry(&self, node: usize, i: usize, j: usize) -> usize {
        let (i, j) = (i.max(j), i.min(j));
        node * self.per_node() + i * (i + 1) / 2 + j
    }

    pub(super) fn centre(&self, node: usize, i: usize) -> usize {
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
    pub(super) fn margin(&self, plan: &Plan, x: &[f64]) -> (usize, f64) {
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
    pub(super) fn solve(&self, plan: &Plan, decay: f64, rounds: usize) -> Option<Vec<f64>> {
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
}
