//! The order in which connections are read and units are stepped.

use std::collections::{BTreeMap, BTreeSet};

use super::wiring::{Connection, Timing, Wiring};
use cordon_core::Result;

/// The connections with this timing, each after those that its value depends on by direct feedthrough.
///
/// # Errors
/// An algebraic loop.
pub(super) fn connections(
    wiring: &Wiring,
    wanted: impl Fn(&Connection) -> bool,
) -> Result<Vec<usize>> {
    let chosen: Vec<usize> = (0..wiring.connections.len())
        .filter(|&c| wiring.connections.get(c).is_some_and(&wanted))
        .collect();
    let mut into: BTreeMap<_, usize> = BTreeMap::new();
    for &c in &chosen {
        if let Some(connection) = wiring.connections.get(c) {
            into.insert(connection.to, c);
        }
    }
    let before = |c: usize| -> Vec<usize> {
        let Some(connection) = wiring.connections.get(c) else {
            return Vec::new();
        };
        let from = connection.from;
        let variable = wiring.units.get(from.unit).and_then(|u| u.variables().get(from.variable));
        let inputs = variable.map(|v| v.feedthrough.as_slice()).unwrap_or_default();
        let port = |&variable: &usize| into.get(&super::wiring::Port { variable, ..from });
        inputs.iter().filter_map(port).copied().collect()
    };
    sorted(&chosen, before).map_err(|cycle| {
        let names: Vec<_> = cycle
            .iter()
            .filter_map(|&c| wiring.connections.get(c))
            .map(|c| format!("{} to {}", wiring.full_name(c.from), wiring.full_name(c.to)))
            .collect();
        loop_error(wiring, &cycle, &names)
    })
}

/// The units, each after those whose values it reads immediately.
///
/// # Errors
/// An algebraic loop.
pub(super) fn units(wiring: &Wiring) -> Result<Vec<usize>> {
    let mut sources: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); wiring.units.len()];
    for c in wiring.connections.iter().filter(|c| c.timing != Timing::Sampled) {
        if let Some(set) = sources.get_mut(c.to.unit) {
            set.insert(c.from.unit);
        }
    }
    let all: Vec<usize> = (0..wiring.units.len()).collect();
    let before = |u: usize| sources.get(u).map(|s| s.iter().copied().collect()).unwrap_or_default();
    sorted(&all, before).map_err(|cycle| {
        let within = |c: &&Connection| {
            c.timing != Timing::Sampled
                && cycle.contains(&c.to.unit)
                && cycle.contains(&c.from.unit)
        };
        let names: Vec<_> = wiring
            .connections
            .iter()
            .filter(within)
            .take(8)
            .map(|c| format!("{} to {}", wiring.full_name(c.from), wiring.full_name(c.to)))
            .collect();
        let first = wiring.connections.iter().position(|c| within(&c));
        loop_error(wiring, first.as_slice(), &names)
    })
}

fn loop_error(wiring: &Wiring, connections: &[usize], names: &[String]) -> cordon_core::Error {
    let what = format!(
        "is in an algebraic loop: {}: expected a connection that is sampled, or a unit without feedthrough, in it",
        names.join(", ")
    );
    match connections.first().and_then(|&c| wiring.connections.get(c)) {
        Some(c) => wiring.at(c.to, what),
        None => cordon_core::Error::internal(what),
    }
}

/// Topological order, stable where possible; or the members of a cycle, in order.
fn sorted(
    nodes: &[usize],
    before: impl Fn(usize) -> Vec<usize>,
) -> std::result::Result<Vec<usize>, Vec<usize>> {
    #[derive(Clone, Copy, PartialEq)]
    enum Mark {
        Open,
        Done,
    }
    let mut marks: BTreeMap<usize, Mark> = BTreeMap::new();
    let mut order = Vec::with_capacity(nodes.len());
    for &root in nodes {
        // Depth-first without recursion: a chain may be as long as there are nodes.
        let mut path: Vec<(usize, Vec<usize>)> = Vec::new();
        let mut next = Some(root);
        loop {
            if let Some(node) = next.take() {
                match marks.get(&node) {
                    Some(Mark::Done) => {}
                    Some(Mark::Open) => {
                        let from = path.iter().position(|(n, _)| *n == node).unwrap_or(0);
                        return Err(path.iter().skip(from).map(|(n, _)| *n).collect());
                    }
                    None => {
                        marks.insert(node, Mark::Open);
                        path.push((node, before(node)));
                    }
                }
            }
            match path.last_mut() {
                None => break,
                Some((node, rest)) => match rest.pop() {
                    Some(source) => next = Some(source),
                    None => {
                        marks.insert(*node, Mark::Done);
                        order.push(*node);
                        path.pop();
                    }
                },
            }
        }
    }
    Ok(order)
}
