//! Invariants of linear systems, by Farkas' lemma.

use std::collections::{BTreeMap, BTreeSet};

use crate::expr::Relation::{Positive, Zero};
use crate::expr::{Literal, joined};
use crate::fault::{Result, Shown, ensure, fault};
use crate::format::{Edge, Invariance, Named};
use crate::linear::{STEPS, System, at};
use crate::number::{Number, charge, exhausted};
use crate::poly::Poly;

const RULE: &str = "invariance";

/// Farkas' lemma: the goal is a sum of literals given, with multipliers that are >= 0 but for equations, and of a constant >= 0.
/// Where it says more than >= 0, so does the sum.
fn follows(
    given: &[Literal],
    goal: &Literal,
    multipliers: &Named<Number>,
    place: &str,
) -> Result<()> {
    let (mut rest, mut strict) = (goal.poly.clone(), false);
    for (name, m) in &multipliers.0 {
        let index = name.parse().ok().filter(|i: &usize| i.to_string() == *name);
        let Some(fact) = index.and_then(|i| given.get(i)) else {
            return fault(RULE, format!("{place}: no literal `{name:.40}` is given"));
        };
        let allowed = fact.relation == Zero || (goal.relation != Zero && *m >= Number::whole(0));
        let expected = "has to be of an equation, or >= 0";
        ensure!(allowed, RULE, "{place}: the multiplier of literal {name} {expected}");
        strict |= fact.relation == Positive && m.is_positive();
        rest = rest - &(Poly::constant(m.clone()) * &fact.poly);
    }
    if let Some(atom) = rest.terms().find_map(|(m, _)| m.first()) {
        return fault(
            RULE,
            format!("{place}: the multipliers do not give the coefficient of {atom}"),
        );
    }
    let constant = rest.coefficient(&[]);
    let left = format!("{constant:.40}");
    ensure!(
        goal.relation != Zero || constant.is_zero(),
        RULE,
        "{place}: {left} is left of the equation"
    );
    let missed = constant < Number::whole(0);
    ensure!(!missed, RULE, "{place}: the bound is missed by {}", left.trim_start_matches('-'));
    let reached = goal.relation == Positive && constant.is_zero() && !strict;
    ensure!(!reached, RULE, "{place}: the bound is reached, but not strictly");
    Ok(())
}

/// `invariance`: what holds at a node holds at the ends of its edges, after a step where the edge takes one.
pub fn invariance(c: &Invariance) -> Result<Shown> {
    let system = System::read(&c.system)?;
    let mut nodes = BTreeMap::new();
    for (name, literals) in &c.nodes.0 {
        let literals = literals.iter().map(|l| system.literal(l)).collect::<Result<Vec<_>>>()?;
        nodes.insert(name.as_str(), literals);
    }
    let node = |name: &str| match nodes.get(name) {
        Some(literals) => Ok(literals),
        None => fault(RULE, format!("no node `{name:.40}`")),
    };
    let start = node(&c.start)?;
    let mut proved = 0;
    for edge in &c.edges {
        let place = format!("edge {}", path(edge));
        let (given, goals) = (node(&edge.from)?, node(&edge.to)?);
        let step = edge.by.as_ref().map(|mode| system.rows(mode)).transpose()?;
        let (rows, expected) = (edge.multipliers.len(), goals.len());
        ensure!(rows == expected, RULE, "{place}: {rows} rows of multipliers: expected {expected}");
        for (row, (goal, multipliers)) in goals.iter().zip(&edge.multipliers).enumerate() {
            let after = step.map_or(goal.poly.clone(), |step| at(&goal.poly, step));
            let vertices = system.vertices(&[after])?;
            let (found, expected) = (multipliers.len(), vertices.len());
            let fits = found == expected;
            ensure!(fits, RULE, "{place}, row {row}: {found} vertices: expected {expected}");
            let vertices = vertices.into_iter().flatten().zip(multipliers);
            for (vertex, (poly, multipliers)) in vertices.enumerate() {
                let goal = Literal { poly, relation: goal.relation };
                let place = format!("{place}, row {row}, vertex {vertex}");
                follows(given, &goal, multipliers, &place)?;
                proved += 1;
            }
        }
    }
    let mut claims: BTreeMap<Literal, Nodes<'_>> = BTreeMap::new();
    for claim in &c.claims {
        let goal = system.literal(&claim.holds)?;
        let place = format!("claim at `{:.40}`", claim.at);
        follows(node(&claim.at)?, &goal, &claim.multipliers, &place)?;
        proved += 1;
        claims.entry(goal).or_default().insert(&claim.at);
    }
    ensure!(!claims.is_empty(), RULE, "nothing is claimed");
    let mut words = vec![system.words(STEPS, &Named::default(), start)];
    words.extend(said(c, system.modes.len(), &claims));
    Ok((words.join("\n  "), proved))
}

fn path(edge: &Edge) -> String {
    let by = edge.by.as_ref().map_or(String::new(), |m| format!("{m}-"));
    format!("{:.40} -{by:.40}> {:.40}", edge.from, edge.to)
}

type Nodes<'c> = BTreeSet<&'c str>;

/// A node and all that are reached from it.
fn reached<'c>(from: &'c str, next: impl Fn(&'c str) -> Nodes<'c>) -> Nodes<'c> {
    let (mut all, mut open) = (Nodes::from([from]), vec![from]);
    while let Some(node) = open.pop() {
        open.extend(next(node).into_iter().filter(|to| all.insert(to)));
    }
    all
}

/// What follows for the runs: for all of them, where every mode has an edge wherever a run can stand; else
/// for those along the edges.
fn said<'c>(c: &'c Invariance, modes: usize, claims: &BTreeMap<Literal, Nodes<'c>>) -> Vec<String> {
    let mut leaving: BTreeMap<&str, Vec<&Edge>> = BTreeMap::new();
    for edge in &c.edges {
        leaving.entry(&edge.from).or_default().push(edge);
    }
    let edges = |n: &str| leaving.get(n).into_iter().flatten().filter(|_| charge(128));
    let enter = |n: &'c str| edges(n).filter(|e| e.by.is_none()).map(|e| e.to.as_str()).collect();
    // Of each node: those that it implies, and the steps that they allow.
    let near: BTreeMap<&str, Nodes<'c>> =
        c.nodes.0.keys().map(|n| (n.as_str(), reached(n, enter))).collect();
    let steps = |n: &str| {
        near.get(n).into_iter().flatten().flat_map(|n| edges(n)).filter(|e| e.by.is_some())
    };
    let stepped = |n: &str| steps(n).map(|e| e.to.as_str()).collect::<Nodes<'c>>();
    let standing = reached(&c.start, stepped);
    let acting = |n: &str| steps(n).filter_map(|e| e.by.as_deref()).collect::<Nodes<'c>>().len();
    let every = standing.iter().all(|n| acting(n) == modes);
    let who = match (every, modes) {
        (true, 1) => "proved of every run".to_owned(),
        (true, _) => "proved of every run, whatever mode acts in each step".to_owned(),
        _ => format!("proved of the runs along {}", joined(c.edges.iter().map(path), ", ")),
    };
    // Where runs can stand after 0, 1, .. steps or more; nothing is said of steps after which they end.
    let mut late = Vec::new();
    if standing.iter().all(|n| acting(n) > 0) {
        late.push(standing);
        while let Some(last) = late.last() {
            let next = last.iter().flat_map(|n| stepped(n)).collect();
            if next == *last || exhausted() {
                break;
            }
            late.push(next);
        }
    }
    // Claims that hold alike are said together.
    let mut lines: BTreeMap<String, Vec<&Literal>> = BTreeMap::new();
    for (goal, nodes) in claims {
        let holds = |n: &&str| charge(128) && near.get(n).is_some_and(|m| !m.is_disjoint(nodes));
        let when = match late.iter().position(|standing| standing.iter().all(holds)) {
            Some(0) => "at every step".to_owned(),
            Some(k) => format!("from step {k} on"),
            None => format!("at {}", joined(nodes, " and ")),
        };
        lines.entry(when).or_default().push(goal);
    }
    // Each line names the edges again.
    if !every && !charge(1024 * (lines.len() * c.edges.len()) as u64) {
        return Vec::new();
    }
    let line = |(when, goals)| format!("{who}, {when}: {}", joined(goals, " and "));
    lines.into_iter().map(line).collect()
}
