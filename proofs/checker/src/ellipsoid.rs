//! Invariant ellipsoids of a linear system in continuous time.
//!
//! A node is the set (x - c)' Q^-1 (x - c) <= 1, Q > 0. Along x' = Ax + b, with y = Q^-1 (x - c), c and Q moving at c' and Q', the
//! derivative of that form is at most decay (1 - form) if M = [[AQ + QA' + decay Q - Q', Ac + b - c'], [., -decay]] <= 0, being
//! [y; 1]' M [y; 1] away from it: who is inside stays inside. M is affine in each parameter, and in time where c and Q move straight.

use std::collections::BTreeMap;

use crate::expr::Relation::{Positive, Zero};
use crate::expr::{Literal, joined};
use crate::fault::{Result, fault, need};
use crate::format::{Ellipsoid, Passage};
use crate::linear::System;
use crate::matrix::{Matrix, definite, symmetric};
use crate::number::Number;
use crate::poly::{Atom, Poly};

type Vector = Vec<Number>;

const RULE: &str = "ellipsoid";

/// Most variables.
const MAX_VARIABLES: usize = 200;

/// An ellipsoid: where its centre is, and its matrix.
struct Node {
    centre: Vector,
    matrix: Matrix,
}

/// The constant and the coefficients of an affine polynomial.
fn parts(poly: &Poly, names: &[String]) -> (Number, Vector) {
    let entry = |name: &String| poly.coefficient(&[Atom::Var(name.as_str().into())]);
    (poly.coefficient(&[]), names.iter().map(entry).collect())
}

fn dot(a: &[Number], b: &[Number]) -> Number {
    a.iter().zip(b).fold(Number::whole(0), |sum, (x, y)| sum + &(x.clone() * y))
}

/// The matrix with one more row: m, then column and corner.
fn bordered(mut m: Matrix, column: Vector, corner: Number) -> Matrix {
    for (row, x) in m.iter_mut().zip(&column) {
        row.push(x.clone());
    }
    m.push(column);
    if let Some(row) = m.last_mut() {
        row.push(corner);
    }
    m
}

/// c + b'(x - centre) over an ellipsoid is above 0 at its centre, and how far its square exceeds what
/// the ellipsoid takes from it.
fn margins(literal: &(Number, Vector), node: &Node) -> [Number; 2] {
    let (constant, row) = literal;
    let at = constant.clone() + &dot(row, &node.centre);
    let image: Vector = node.matrix.iter().map(|r| dot(r, row)).collect();
    let square = at.clone() * &at;
    [at, square - &dot(row, &image)]
}

/// What a claim needs: >= 0, or > 0 where the claim is strict.
fn reached(x: &Number, literal: &Literal) -> bool {
    x.is_positive() || (x.is_zero() && literal.relation != Positive)
}

/// Whether a claim holds all the way between two ellipsoids where it holds: f(s) = f0 + (f1 - f0 - a) s + a s^2, a being the square
/// of the change at the centre, may dip in between.
fn between(literal: &Literal, from: &[Number; 2], to: &[Number; 2]) -> bool {
    let change = to[0].clone() - &from[0];
    let a = change.clone() * &change;
    let b = to[1].clone() - &from[1] - &a;
    let (low, two) = (Number::whole(-2) * &a, Number::whole(2));
    let inside = b < Number::whole(0) && b > low;
    !inside || reached(&(two.clone() * &two * &a * &from[1] - &(b.clone() * &b)), literal)
}

/// `ellipsoid`: runs that start inside stay inside along the edges, and there the claims hold.
///
/// # Errors
/// What is wrong with it.
pub fn ellipsoid(c: &Ellipsoid) -> Result<(String, usize)> {
    let system = System::read(&c.system)?;
    let names = &c.system.state;
    let size = names.len();
    need(size <= MAX_VARIABLES, RULE, || {
        format!("{size} variables: expected at most {MAX_VARIABLES}")
    })?;
    let mut proved = 0;
    let mut nodes = BTreeMap::new();
    for (name, node) in &c.nodes.0 {
        let matrix = symmetric(RULE, &node.matrix, size)?;
        let fits = node.centre.len() == size && definite(matrix.clone(), true);
        let what = "a centre and a positive definite matrix are expected";
        need(fits, RULE, || format!("node `{name:.40}`: {what}"))?;
        nodes.insert(name.as_str(), Node { centre: node.centre.clone(), matrix });
    }
    let node = |name: &str| match nodes.get(name) {
        Some(node) => Ok(node),
        None => fault(RULE, format!("no node `{name:.40}`")),
    };
    let empty = c.start.is_empty() || c.points.is_empty() || c.claims.is_empty();
    need(!empty, RULE, || "nodes and points of the start, and claims, are expected")?;
    for name in &c.start {
        let start = node(name)?;
        for (i, point) in c.points.iter().enumerate() {
            let away = point.iter().zip(&start.centre).map(|(p, q)| p.clone() - q).collect();
            let there = bordered(start.matrix.clone(), away, Number::whole(1));
            let inside = point.len() == size && definite(there, false);
            need(inside, RULE, || format!("point {i} of the start is not in `{name:.40}`"))?;
        }
    }
    for edge in &c.edges {
        let (from, to) = (node(&edge.from)?, node(&edge.to)?);
        let rate = match &edge.time {
            Some(time) if time.is_positive() => Number::whole(1).over(time),
            None if edge.from == edge.to => Some(Number::whole(0)),
            _ => None,
        };
        let Some(rate) = rate else {
            let what = "a time above 0 is expected, or an edge that stays at its node";
            return fault(RULE, format!("edge {}: {what}", path(edge)));
        };
        let made = system.rows(&edge.by)?;
        let rows: Vec<Poly> =
            names.iter().map(|n| made.get(n.as_str()).cloned().unwrap_or_default()).collect();
        let moved = |a: &Number, b: &Number| rate.clone() * &(b.clone() - a);
        let ends = if edge.time.is_some() { vec![from, to] } else { vec![from] };
        for (vertex, rows) in system.vertices(&rows)?.iter().enumerate() {
            let rows: Vec<(Number, Vector)> = rows.iter().map(|row| parts(row, names)).collect();
            for (end, at) in ends.iter().enumerate() {
                let aq = |i: usize, j: usize| dot(&rows[i].1, &at.matrix[j]);
                let entry = |i: usize, j: usize| {
                    let inward = aq(i, j) + &aq(j, i) + &(edge.decay.clone() * &at.matrix[i][j]);
                    moved(&from.matrix[i][j], &to.matrix[i][j]) - &inward
                };
                let column = |i: usize| {
                    let drift = rows[i].0.clone() + &dot(&rows[i].1, &at.centre);
                    moved(&from.centre[i], &to.centre[i]) - &drift
                };
                let all = (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect();
                let minus = bordered(all, (0..size).map(column).collect(), edge.decay.clone());
                let what = "a run may leave the ellipsoid";
                let kept = definite(minus, false);
                need(kept, RULE, || {
                    format!("edge {}: vertex {vertex}, end {end}: {what}", path(edge))
                })?;
                proved += 1;
            }
        }
    }
    for text in &c.claims {
        let literal = system.literal(text)?;
        let equation = literal.relation == Zero;
        need(!equation, RULE, || format!("`{text:.60}`: an ellipsoid shows no equation"))?;
        let form = parts(&literal.poly, names);
        let at: BTreeMap<&str, [Number; 2]> =
            nodes.iter().map(|(name, node)| (*name, margins(&form, node))).collect();
        for (name, margins) in &at {
            let within = margins.iter().all(|m| reached(m, &literal));
            need(within, RULE, || {
                format!("the ellipsoid `{name:.40}` is not within `{text:.60}`")
            })?;
        }
        for edge in c.edges.iter().filter(|e| e.time.is_some()) {
            let holds = between(&literal, &at[edge.from.as_str()], &at[edge.to.as_str()]);
            need(holds, RULE, || format!("`{text:.60}` may fail along {}", path(edge)))?;
        }
        proved += 1;
    }
    Ok((words(c, &system)?, proved))
}

/// What was shown, of which runs: of all, where from some node of the start all modes may act for any time.
fn words(c: &Ellipsoid, system: &System<'_>) -> Result<String> {
    let stays = |node: &String, mode: &str| {
        c.edges.iter().any(|e| e.time.is_none() && e.from == *node && e.by == mode)
    };
    let every = c.start.iter().any(|n| system.modes.keys().all(|m| stays(n, m)));
    let who = match (every, system.modes.len()) {
        (true, 1) => "every run".to_owned(),
        (true, _) => "every run, whatever mode acts at each time".to_owned(),
        _ => {
            let edges = joined(c.edges.iter().map(path), ", ");
            format!("the runs that start at {}, along {edges}", joined(&c.start, " or "))
        }
    };
    let mut words = format!("in continuous time {}", joined(&c.system.state, ", "));
    for (mode, rows) in &system.modes {
        let rows = rows.iter().map(|(v, row)| format!("{v}' = {row}"));
        words += &format!("\n  mode {mode}: {}", joined(rows, ", "));
    }
    for (name, [low, high]) in &c.system.parameters.0 {
        words += &format!("\n  at each time any {name} in [{low}, {high}]");
    }
    let points = joined(c.points.iter().map(|p| joined(p, ", ")), "), (");
    words += &format!("\n  assuming a start between these points: ({points})");
    let claims = c.claims.iter().map(|text| system.literal(text)).collect::<Result<Vec<_>>>()?;
    words += &format!("\n  proved of {who}, at every time: {}", joined(claims, " and "));
    Ok(words)
}

fn path(edge: &Passage) -> String {
    let time = edge.time.as_ref().map_or(String::new(), |t| format!(" for {t:.40}"));
    format!("{:.40} -{:.40}{time}-> {:.40}", edge.from, edge.by, edge.to)
}
