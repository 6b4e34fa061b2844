//! The safe side of ordering and bound as invariance certificates in positions.

use std::collections::BTreeMap;

use num_traits::{One, Zero};
use serde_json::Value;

use super::safety::Cone;
use crate::certificate::linear::{Edge, Invariance, LinearSystem, NodeClaim, form, multipliers};
use cordon_core::Rational;
use cordon_core::linear::rows::Row;
use cordon_core::stencil::{Role, Stencil};

/// Most drones for which a certificate is written: the limit of protocol files.
pub const MOST: usize = 198;

/// `normal . x = bound` (a pinned drone), `>=` or `>` it.
struct Face {
    normal: Vec<Rational>,
    bound: Rational,
    relation: &'static str,
}

/// The certificate that one step at weight `eps` preserves the cone, on the segment \[0, 1\]: in
/// positions, with the step's matrix from the spec. `None` where a multiplier would be negative, that
/// is, where the cone is not preserved, and beyond [`MOST`] drones.
pub fn certificate(cone: Cone, count: usize, eps: &Rational) -> Option<Value> {
    if count > MOST {
        return None;
    }
    let stencil = Stencil::executed(eps);
    let (matrix, offset) = transition(&stencil, count);
    let pinned =
        |i: usize, at: Rational| Face { normal: unit(count, i, 1), bound: at, relation: "=" };
    let mut faces = vec![pinned(0, Rational::zero()), pinned(count - 1, Rational::one())];
    let own = faces.len();
    faces.extend(facets(cone, count));
    let coefficients = cone_matrix(cone, &stencil, count)?;
    let mut rows = Vec::new();
    for (j, face) in faces.iter().enumerate() {
        let target = times(&face.normal, &matrix);
        let mut m = vec![Rational::zero(); faces.len()];
        if let Some(parts) = j.checked_sub(own).and_then(|facet| coefficients.get(facet)) {
            m.splice(own.., parts.iter().cloned());
        }
        // The remainder is a multiple of the pinned positions.
        let left = |x: usize| {
            let have: Rational = faces.iter().zip(&m).map(|(f, m)| &f.normal[x] * m).sum();
            &target[x] - have
        };
        (m[0], m[1]) = (left(0), left(count - 1));
        if m[own..].iter().any(|m| *m < Rational::zero()) {
            return None;
        }
        rows.push(vec![multipliers(&m)]);
    }
    let names: Vec<String> = (0..count).map(|i| format!("x{i}")).collect();
    let text = |constant: &Rational, row: &[Rational]| {
        form(constant, names.iter().map(String::as_str).zip(row))
    };
    let literal = |f: &Face| format!("{} {} 0", text(&-&f.bound, &f.normal), f.relation);
    let claim = |(j, f): (usize, &Face)| NodeClaim {
        at: "kept".into(),
        holds: literal(f),
        multipliers: BTreeMap::from([(j, "1".to_owned())]),
    };
    let updates = matrix.iter().zip(&offset).map(|(row, c)| text(c, row));
    let step: BTreeMap<String, String> = names.iter().cloned().zip(updates).collect();
    let edge =
        Edge { from: "kept".into(), by: Some("step".into()), to: "kept".into(), multipliers: rows };
    let invariance = Invariance {
        start: "kept".into(),
        edges: vec![edge],
        claims: faces.iter().enumerate().skip(own).map(claim).collect(),
        nodes: [("kept".into(), faces.iter().map(literal).collect())].into(),
        system: LinearSystem {
            modes: [("step".into(), step)].into(),
            parameters: BTreeMap::new(),
            state: names.clone(),
        },
    };
    invariance.certificate()
}

/// Matrix and offset of one step in positions on \[0, 1\].
fn transition(stencil: &Stencil<Rational>, count: usize) -> (Vec<Vec<Rational>>, Vec<Rational>) {
    let row = |i: usize| {
        let w = stencil.weights(Role::of(i, count));
        let mut row = vec![Rational::zero(); count];
        row[i].clone_from(&w.own);
        // Beyond the line, the lower end is at 0 and the upper end at 1.
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

/// The cone's own half-spaces.
fn facets(cone: Cone, count: usize) -> Vec<Face> {
    match cone {
        Cone::PositiveGaps => (0..count - 1)
            .map(|i| {
                let mut normal = unit(count, i, -1);
                normal[i + 1] = Rational::one();
                Face { normal, bound: Rational::zero(), relation: ">" }
            })
            .collect(),
        Cone::NonnegativeErrors => (1..count - 1)
            .map(|i| Face {
                normal: unit(count, i, -1),
                bound: -Rational::new(i.into(), (count - 1).into()),
                relation: ">=",
            })
            .collect(),
    }
}

/// Row i gives the new coordinate i as a combination of the old coordinates.
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
