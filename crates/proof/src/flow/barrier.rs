//! Linear matrix inequalities in doubles: the logarithmic barrier and Newton's method.
//!
//! Small and dense, with the one economy that a row of the Hessian begins at its first entry. What is found here is
//! not believed: it is rounded and checked exactly.

use crate::claims::doubles::{Matrix, identity, largest};

/// A symmetric matrix that depends affinely on the variables, and has to be positive definite.
#[derive(Clone, Debug)]
pub struct Block {
    /// Its value where all variables are 0.
    constant: Matrix,
    /// Of each variable that occurs, the entries (row, column, number) of its coefficient, both halves.
    coefficients: Vec<(usize, Entries)>,
}

/// Entries of a matrix: row, column, number.
type Entries = Vec<(usize, usize, f64)>;

impl Block {
    /// A matrix that is `constant` so far.
    pub fn new(constant: Matrix) -> Self {
        Self { constant, coefficients: Vec::new() }
    }

    /// Adds `by * variable` at (i, j) and (j, i).
    pub fn add(&mut self, variable: usize, i: usize, j: usize, by: f64) {
        if by == 0.0 {
            return;
        }
        let index = match self.coefficients.iter().position(|(v, _)| *v == variable) {
            Some(index) => index,
            None => {
                self.coefficients.push((variable, Vec::new()));
                self.coefficients.len() - 1
            }
        };
        let entries = &mut self.coefficients[index].1;
        for (i, j) in if i == j { vec![(i, j)] } else { vec![(i, j), (j, i)] } {
            match entries.iter_mut().find(|(r, c, _)| (*r, *c) == (i, j)) {
                Some((.., x)) => *x += by,
                None => entries.push((i, j, by)),
            }
        }
    }

    /// The block's matrix at a point.
    fn at(&self, x: &[f64]) -> Matrix {
        let mut m = self.constant.clone();
        for (v, entries) in &self.coefficients {
            for (i, j, by) in entries {
                m[*i][*j] += by * x[*v];
            }
        }
        m
    }
}

/// The lower triangular L with LL' = m, each row being 0 before its first entry. `None` where there is none.
fn cholesky(m: &Matrix) -> Option<Matrix> {
    let n = m.len();
    let first: Vec<usize> =
        m.iter().enumerate().map(|(i, r)| r.iter().position(|x| *x != 0.0).unwrap_or(i)).collect();
    let mut l = vec![vec![0.0; n]; n];
    for i in 0..n {
        let (above, rest) = l.split_at_mut(i);
        let row = &mut rest[0];
        for j in first[i]..i {
            let from = first[i].max(first[j]);
            let sum: f64 = (from..j).map(|k| row[k] * above[j][k]).sum();
            row[j] = (m[i][j] - sum) / above[j][j];
        }
        let pivot = m[i][i] - row[first[i]..i].iter().map(|x| x * x).sum::<f64>();
        if pivot.is_nan() || pivot <= 0.0 {
            return None;
        }
        row[i] = pivot.sqrt();
    }
    Some(l)
}

/// The solution of LL' x = b.
fn solve(l: &Matrix, b: &[f64]) -> Vec<f64> {
    let mut x = b.to_vec();
    for i in 0..x.len() {
        let sum: f64 = (0..i).map(|k| l[i][k] * x[k]).sum();
        x[i] = (x[i] - sum) / l[i][i];
    }
    for i in (0..x.len()).rev() {
        x[i] /= l[i][i];
        let value = x[i];
        for (k, y) in x.iter_mut().enumerate().take(i) {
            *y -= l[i][k] * value;
        }
    }
    x
}

/// A variable to be made as large as the blocks allow. They have to bound all variables: where one may go on for
/// ever, the barrier has no least value.
#[derive(Clone, Debug)]
pub struct Program {
    /// Number of variables of the search.
    pub variables: usize,
    /// What has to be positive definite.
    pub blocks: Vec<Block>,
    /// The variable that is to be large.
    pub objective: usize,
}

/// Most steps of Newton's method in all: some hundred times what is needed.
const MOST_STEPS: usize = 5_000;

impl Program {
    /// The barrier: minus the logarithms of the determinants. `None` beyond it.
    fn barrier(&self, x: &[f64]) -> Option<f64> {
        self.blocks.iter().try_fold(0.0, |sum, b| {
            let l = cholesky(&b.at(x))?;
            Some(sum - l.iter().enumerate().map(|(i, row)| 2.0 * row[i].ln()).sum::<f64>())
        })
    }

    /// Gradient and Hessian of the barrier.
    fn derivatives(&self, x: &[f64]) -> Option<(Vec<f64>, Matrix)> {
        let mut gradient = vec![0.0; self.variables];
        let mut hessian = vec![vec![0.0; self.variables]; self.variables];
        for block in &self.blocks {
            let l = cholesky(&block.at(x))?;
            let inverse: Matrix = identity(l.len()).iter().map(|e| solve(&l, e)).collect();
            let n = inverse.len();
            for (v, entries) in &block.coefficients {
                // inverse * coefficient * inverse.
                let mut half = vec![vec![0.0; n]; n];
                for (i, j, by) in entries {
                    gradient[*v] -= by * inverse[*i][*j];
                    for (x, y) in half[*j].iter_mut().zip(&inverse[*i]) {
                        *x += by * y;
                    }
                }
                let mut moved = vec![vec![0.0; n]; n];
                for (row, inverse) in moved.iter_mut().zip(&inverse) {
                    for (half, a) in half.iter().zip(inverse) {
                        for (x, y) in row.iter_mut().zip(half) {
                            *x += a * y;
                        }
                    }
                }
                for (w, entries) in block.coefficients.iter().filter(|(w, _)| w <= v) {
                    hessian[*v][*w] +=
                        entries.iter().map(|(i, j, by)| by * moved[*i][*j]).sum::<f64>();
                }
            }
        }
        Some((gradient, hessian))
    }

    /// How far from the largest value the objective may be, with this weight of the objective.
    fn gap(&self, weight: f64) -> f64 {
        self.blocks.iter().map(|b| b.constant.len()).sum::<usize>() as f64 / weight
    }

    /// A point from which the objective grows by no more than `precision`, or the first one met at which it is `enough`.
    /// From a point at which all blocks are positive definite; `None` where it is none.
    pub fn maximise(&self, start: &[f64], precision: f64, enough: f64) -> Option<Vec<f64>> {
        let mut x = start.to_vec();
        let mut value = self.barrier(&x)?;
        let mut weight = 1.0 / (1.0 + start[self.objective].abs());
        for _ in 0..MOST_STEPS {
            if x[self.objective] >= enough {
                return Some(x);
            }
            let (mut gradient, mut hessian) = self.derivatives(&x)?;
            gradient[self.objective] -= weight;
            let scale = hessian.iter().enumerate().map(|(i, r)| r[i]).fold(0.0, f64::max);
            let l = loop {
                if let Some(l) = cholesky(&hessian) {
                    break l;
                }
                // Singular for doubles.
                for (i, row) in hessian.iter_mut().enumerate() {
                    row[i] += 1e-12 * scale + 1e-14 * row[i];
                }
                if !largest(&hessian).is_finite() {
                    return None;
                }
            };
            let step = solve(&l, &gradient);
            let decrement: f64 = step.iter().zip(&gradient).map(|(s, g)| s * g).sum();
            if decrement < 0.1 {
                if self.gap(weight) < precision {
                    return Some(x);
                }
                // Not to be reached any more.
                if enough.is_finite() && x[self.objective] + 2.0 * self.gap(weight) < enough {
                    return None;
                }
                weight *= 8.0;
                continue;
            }
            let mut length = 1.0;
            loop {
                let next: Vec<f64> = x.iter().zip(&step).map(|(x, s)| x - length * s).collect();
                let gain = weight * (next[self.objective] - x[self.objective]);
                if let Some(found) =
                    self.barrier(&next).filter(|v| *v - gain <= value - 0.1 * length * decrement)
                {
                    (x, value) = (next, found);
                    break;
                }
                length /= 2.0;
                if length < 1e-9 {
                    // As far as doubles go.
                    return if enough.is_finite() { None } else { Some(x) };
                }
            }
        }
        None
    }

    /// A point at which all blocks are positive definite, if one is found: the blocks less a number that
    /// begins below their least eigenvalue and grows until it is above 0.
    pub fn feasible(&self, start: &[f64]) -> Option<Vec<f64>> {
        let mut relaxed =
            Self { objective: self.variables, variables: self.variables + 1, ..self.clone() };
        let mut low = 0.0_f64;
        for block in &mut relaxed.blocks {
            for row in block.at(start) {
                low = low.min(-row.iter().map(|x| x.abs()).sum::<f64>());
            }
            for i in 0..block.constant.len() {
                block.add(self.variables, i, i, -1.0);
            }
        }
        let start: Vec<f64> = start.iter().copied().chain([2.0 * low - 1.0]).collect();
        let mut x = relaxed.maximise(&start, 1e-9, 1e-6)?;
        x.pop();
        Some(x)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// The greatest x + y on the unit disc, and that there is no point where it is asked to be more.
    #[test]
    fn a_maximum_and_an_empty_set() {
        let mut disc = Block::new(identity(3));
        disc.add(0, 0, 2, 1.0);
        disc.add(1, 1, 2, 1.0);
        let mut line = Block::new(vec![vec![0.0]]);
        for (v, by) in [(0, 1.0), (1, 1.0), (2, -1.0)] {
            line.add(v, 0, 0, by);
        }
        let mut floor = Block::new(vec![vec![10.0]]);
        floor.add(2, 0, 0, 1.0);
        let mut program = Program { variables: 3, blocks: vec![disc, line, floor], objective: 2 };
        let start = program.feasible(&[3.0, 4.0, 100.0]).unwrap();
        let x = program.maximise(&start, 1e-6, f64::INFINITY).unwrap();
        assert!((x[2] - 2f64.sqrt()).abs() < 1e-5 && (x[0] - x[1]).abs() < 1e-4, "{x:?}");
        let mut beyond = Block::new(vec![vec![-1.5]]);
        beyond.add(2, 0, 0, 1.0);
        program.blocks.push(beyond);
        assert!(program.feasible(&[0.0, 0.0, 0.0]).is_none());
    }
}
