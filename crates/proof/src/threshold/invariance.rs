//! The safe side of ordering and bound as invariance certificates in positions.

use num_traits::{One, Signed, Zero};
use serde_json::Value;

use super::safety::Cone;
use crate::certificate::{self, HalfSpace};
use cordon_core::Rational;
use cordon_core::linear::rows::Row;
use cordon_core::stencil::{Role, Stencil};

/// Most drones for which the format takes an invariance certificate (200 variables).
pub const MOST: usize = 198;

/// The certificate that one step at weight `eps` keeps the cone, on the segment \[0, 1\]: in
/// positions, with the protocol's matrix as the spec has it. `None` where a multiplier would
/// be negative, hence where the cone is not kept, and beyond [`MOST`] drones.
pub fn certificate(cone: Cone, count: usize, eps: &Rational) -> Option<Value> {
    if count > MOST {
        return None;
    }
    let stencil = Stencil::executed(eps);
    let (matrix, offset) = transition(&stencil, count);
    let mut rows = pinned(count, 0, &Rational::zero());
    rows.extend(pinned(count, count - 1, &Rational::one()));
    let own = rows.len();
    rows.extend(facets(cone, count));
    let coefficients = cone_matrix(cone, &stencil, count)?;
    let mut multipliers = Vec::new();
    for (j, row) in rows.iter().enumerate() {
        let target = times(&row.normal, &matrix);
        let mut m = vec![Rational::zero(); rows.len()];
        if let Some(parts) = j.checked_sub(own).and_then(|facet| coefficients.get(facet)) {
            m.splice(own.., parts.iter().cloned());
        }
        // What is left is a multiple of the pinned positions.
        let left = |x: usize| {
            let have: Rational = rows.iter().zip(&m).map(|(r, m)| &r.normal[x] * m).sum();
            &target[x] - have
        };
        let (first, last) = (left(0), left(count - 1));
        for (x, at) in [(first, 0), (last, 2)] {
            m[if x.is_negative() { at + 1 } else { at }] = x.abs();
        }
        if m.iter().any(Signed::is_negative) {
            return None;
        }
        multipliers.push(m);
    }
    Some(certificate::invariance(&matrix, &offset, &rows, &multipliers))
}

/// Matrix and offset of one step in positions on \[0, 1\].
fn transition(stencil: &Stencil<Rational>, count: usize) -> (Vec<Vec<Rational>>, Vec<Rational>) {
    let row = |i: usize| {
        let w = stencil.weights(Role::of(i, count));
        let mut row = vec![Rational::zero(); count];
        row[i].clone_from(&w.own);
        // Of what lies beyond the line, the lower end counts 0 and the upper end 1.
        let mut offset = w.max.clone();
        if i > 0 {
            row[i - 1].clone_from(&w.prec);
        }
        match row.get_mut(i + 1) {
            Some(entry) => entry.clone_from(&w.foll),
            None => offset += &w.foll,
        }
        (row, offset)
    };
    (0..count).map(row).unzip()
}

fn unit(count: usize, i: usize, value: i32) -> Vec<Rational> {
    let mut normal = vec![Rational::zero(); count];
    if let Some(x) = normal.get_mut(i) {
        *x = Rational::from_integer(value.into());
    }
    normal
}

/// x_i >= value and x_i <= value.
fn pinned(count: usize, i: usize, value: &Rational) -> Vec<HalfSpace> {
    let row = |sign: i32| HalfSpace {
        normal: unit(count, i, sign),
        bound: value * Rational::from_integer(sign.into()),
        strict: false,
    };
    vec![row(1), row(-1)]
}

/// The cone's own half-spaces.
fn facets(cone: Cone, count: usize) -> Vec<HalfSpace> {
    match cone {
        Cone::PositiveGaps => (0..count - 1)
            .map(|i| {
                let mut normal = unit(count, i, -1);
                normal[i + 1] = Rational::one();
                HalfSpace { normal, bound: Rational::zero(), strict: true }
            })
            .collect(),
        Cone::NonnegativeErrors => (1..count - 1)
            .map(|i| HalfSpace {
                normal: unit(count, i, -1),
                bound: -Rational::new(i.into(), (count - 1).into()),
                strict: false,
            })
            .collect(),
    }
}

/// Row i: of what multiples of the old coordinates the new coordinate i is the sum.
fn cone_matrix(
    cone: Cone,
    stencil: &Stencil<Rational>,
    count: usize,
) -> Option<Vec<Vec<Rational>>> {
    let (rows, coordinates) = cone.rows(stencil, count)?;
    let dense = |row: &Row<Rational>| {
        let mut entries = vec![Rational::zero(); count];
        row.iter().for_each(|(j, a)| entries[*j].clone_from(a));
        entries[coordinates.clone()].to_vec()
    };
    Some(rows[coordinates.clone()].iter().map(dense).collect())
}

fn times(row: &[Rational], matrix: &[Vec<Rational>]) -> Vec<Rational> {
    (0..row.len()).map(|x| row.iter().zip(matrix).map(|(r, line)| r * &line[x]).sum()).collect()
}
