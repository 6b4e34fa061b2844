//! Invariant ellipsoids of a linear system in continuous time.
//!
//! A node is the set (x - c)' Q^-1 (x - c) <= 1, Q > 0. Along x' = Ax + b, with y = Q^-1 (x - c), c and Q moving at c' and Q', the
//! derivative of that form is at most decay (1 - form) if M = [[AQ + QA' + decay Q - Q', Ac + b - c'], [., -decay]] <= 0, being
//! [y; 1]' M [y; 1] away from it: who is inside stays inside. M is affine in each parameter, and in time where c and Q move straight.

use std::collections::BTreeMap;

use crate::expr::Relation::{Positive, Zero};
use crate::expr::{Literal, joined};
use crate::fault::{Result, Shown, ensure, fault};
use crate::format::{Ellipsoid, Named, Passage};
use crate::linear::{System, coefficients};
use crate::matrix::{Matrix, bordered, definite, dot, product, symmetric};
use crate::number::Number;
use crate::poly::Poly;

type Vector = Vec<Number>;

const RULE: &str = "ellipsoid";

/// Most variables.
const MAX_VARIABLES: usize = 200;

/// c + b'(x - centre) over an ellipsoid is above 0 at its centre, and how far its square exceeds what
/// the ellipsoid takes from it.
fn margins((constant, row): &(Number, Vector), centre: &[Number], matrix: &Matrix) -> [Number; 2] {
    let at = constant + &dot(row, centre);
    let image: Vector = matrix.iter().map(|r| dot(r, row)).collect();
    let square = &at * &at;
    [at, square - &dot(row, &image)]
}

/// What a claim needs: >= 0, or > 0 where the claim is strict.
fn reached(x: &Number, literal: &Literal) -> bool {
    x.is_positive() || (x.is_zero() && literal.relation != Positive)
}

/// Whether a claim holds all the way between two ellipsoids where it holds: f(s) = f0 + (f1 - f0 - a) s + a s^2, a being the square
/// of the change at the centre, may dip in between.
fn between(literal: &Literal, from: &[Number; 2], to: &[Number; 2]) -> bool {
    let change = &to[0] - &from[0];
    let a = &change * &change;
    let b = &to[1] - &from[1] - &a;
    let inside = b < Number::whole(0) && b > Number::whole(-2) * &a;
    !inside || reached(&(Number::whole(4) * &a * &from[1] - &(&b * &b)), literal)
}

/// `ellipsoid`: runs that start inside stay inside along the edges, and there the claims hold.
///
/// # Errors
/// What is wrong with it.
pub fn ellipsoid(c: &Ellipsoid) -> Result<Shown> {
    let system = System::read(&c.system)?;
    let names = &c.system.state;
    let size = names.len();
    ensure!(size <= MAX_VARIABLES, RULE, "{size} variables: expected at most {MAX_VARIABLES}");
    let mut nodes = BTreeMap::new();
    for (name, node) in &c.nodes.0 {
        let matrix = symmetric(RULE, &node.matrix, size)?;
        let fits = node.centre.len() == size && definite(&matrix, true);
        let what = "a centre and a positive definite matrix are expected";
        ensure!(fits, RULE, "node `{name:.40}`: {what}");
        nodes.insert(name.as_str(), (&node.centre, matrix));
    }
    let node = |name: &str| match nodes.get(name) {
        Some(node) => Ok(node),
        None => fault(RULE, format!("no node `{name:.40}`")),
    };
    let empty = c.start.is_empty() || c.points.is_empty() || c.claims.is_empty();
    ensure!(!empty, RULE, "nodes and points of the start, and claims, are expected");
    for name in &c.start {
        let (centre, matrix) = node(name)?;
        for (i, point) in c.points.iter().enumerate() {
            let away = point.iter().zip(*centre).map(|(p, q)| p - q).collect();
            let there = bordered(matrix.clone(), away, Number::whole(1));
            let inside = point.len() == size && definite(&there, false);
            ensure!(inside, RULE, "point {i} of the start is not in `{name:.40}`");
        }
    }
    let mut proved = c.claims.len();
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
        let moved = |(a, b): (&Vector, &Vector)| -> Vector {
            a.iter().zip(b).map(|(a, b)| &rate * &(b - a)).collect()
        };
        let drift = moved((from.0, to.0));
        let change: Matrix = from.1.iter().zip(&to.1).map(moved).collect();
        let ends = if edge.time.is_some() { vec![from, to] } else { vec![from] };
        for (vertex, rows) in system.vertices(&rows)?.iter().enumerate() {
            let (b, a): (Vector, Matrix) = rows.iter().map(|row| coefficients(row, names)).unzip();
            for (end, (centre, matrix)) in ends.iter().enumerate() {
                let aq = product(&a, matrix);
                let entry = |i: usize, j: usize| {
                    let decay = &edge.decay * &matrix[i][j];
                    &change[i][j] - &(&aq[i][j] + &aq[j][i] + &decay)
                };
                let column = |i: usize| &drift[i] - &(&b[i] + &dot(&a[i], centre));
                let all = (0..size).map(|i| (0..=i).map(|j| entry(i, j)).collect()).collect();
                let minus = bordered(all, (0..size).map(column).collect(), edge.decay.clone());
                let place = format!("edge {}: vertex {vertex}, end {end}", path(edge));
                ensure!(definite(&minus, false), RULE, "{place}: a run may leave the ellipsoid");
                proved += 1;
            }
        }
    }
    let claims = c.claims.iter().map(|text| system.literal(text)).collect::<Result<Vec<_>>>()?;
    for (literal, text) in claims.iter().zip(&c.claims) {
        let equation = literal.relation == Zero;
        ensure!(!equation, RULE, "`{text:.60}`: an ellipsoid shows no equation");
        let form = coefficients(&literal.poly, names);
        let at: BTreeMap<&str, [Number; 2]> =
            nodes.iter().map(|(name, (c, q))| (*name, margins(&form, c, q))).collect();
        for (name, margins) in &at {
            let within = margins.iter().all(|m| reached(m, literal));
            ensure!(within, RULE, "the ellipsoid `{name:.40}` is not within `{text:.60}`");
        }
        for edge in c.edges.iter().filter(|e| e.time.is_some()) {
            let holds = between(literal, &at[edge.from.as_str()], &at[edge.to.as_str()]);
            ensure!(holds, RULE, "`{text:.60}` may fail along {}", path(edge));
        }
    }
    Ok((words(c, &system, &claims), proved))
}

/// What was shown, of which runs: of all, where from some node of the start all modes may act for any time.
fn words(c: &Ellipsoid, system: &System<'_>, claims: &[Literal]) -> String {
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
    let system = system.words(["in continuous time", "at each time"], &Named::default(), &[]);
    let points = joined(c.points.iter().map(|p| joined(p, ", ")), "), (");
    let claims = joined(claims, " and ");
    format!(
        "{system}\n  assuming a start between these points: ({points})\n  proved of {who}, at every time: {claims}"
    )
}

fn path(edge: &Passage) -> String {
    let time = edge.time.as_ref().map_or(String::new(), |t| format!(" for {t:.40}"));
    format!("{:.40} -{:.40}{time}-> {:.40}", edge.from, edge.by, edge.to)
}
