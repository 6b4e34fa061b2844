//! Who hears whom in a protocol file.

use std::collections::BTreeMap;

use num_traits::One;
use toml::Value;

use cordon_core::{Rational, exact};
use cordon_spec::graph::Graph;

use crate::scenario::Topology as Undirected;

/// The shapes in which agents have a place beside each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Topology {
    /// Not said: rules name the agents that they hear.
    None,
    /// `prev` and `next`, with two ends.
    Line,
    /// `prev` and `next` without ends.
    Ring,
    /// Neighbours without order.
    Other,
}

/// Neighbours, with the weights of the links.
#[derive(Clone, Debug)]
pub(super) struct Links {
    pub topology: Topology,
    /// Of each agent, whom it hears, ascending.
    pub heard: Vec<Vec<(usize, Rational)>>,
}

impl Links {
    /// Reads a topology.
    pub fn read(value: &Value, count: usize) -> Result<Self, String> {
        match value {
            Value::String(name) => Self::named(name, count),
            Value::Array(list) => Self::listed(list, count),
            _ => Err("expected a name or a list of links".to_owned()),
        }
    }

    fn named(name: &str, count: usize) -> Result<Self, String> {
        let weightless = |of: &dyn Fn(usize) -> Vec<usize>| -> Vec<Vec<(usize, Rational)>> {
            (0..count).map(|i| of(i).into_iter().map(|j| (j, Rational::one())).collect()).collect()
        };
        let graph =
            |g: Undirected| weightless(&|i| (0..count).filter(|&j| g.linked(i, j)).collect());
        let (topology, heard) = match name {
            "line" | "path" => (Topology::Line, graph(Undirected::Path(count))),
            "ring" => (Topology::Ring, graph(Undirected::Ring(count))),
            "complete" => (Topology::Other, graph(Undirected::Complete(count))),
            "star" => (
                Topology::Other,
                weightless(&|i| {
                    if i == 0 { (1..count).collect() } else { vec![0] }
                }),
            ),
            _ => {
                let columns = grid(name, count)?;
                let near = |i: usize| {
                    let (row, column) = (i / columns, i % columns);
                    let mut near = Vec::new();
                    near.extend(i.checked_sub(columns));
                    near.extend((column > 0).then(|| i - 1));
                    near.extend((column + 1 < columns).then(|| i + 1));
                    near.extend((row + 1 < count / columns).then(|| i + columns));
                    near
                };
                (Topology::Other, weightless(&near))
            }
        };
        Ok(Self { topology, heard })
    }

    fn listed(list: &[Value], count: usize) -> Result<Self, String> {
        let mut heard: Vec<BTreeMap<usize, Rational>> = vec![BTreeMap::new(); count];
        for item in list {
            let (from, to, both, weight) = link(item)?;
            if from == to || from.max(to) >= count {
                return Err(format!(
                    "`{}`: expected two different agents from 0 to {}",
                    shown(item),
                    count.saturating_sub(1)
                ));
            }
            let directions = [(from, to), (to, from)];
            for (from, to) in directions.into_iter().take(if both { 2 } else { 1 }) {
                let hears = heard.get_mut(to).map(|h| h.insert(from, weight.clone()));
                if hears.flatten().is_some() {
                    return Err(format!("`{}`: agent {to} hears agent {from} twice", shown(item)));
                }
            }
        }
        let heard = heard.into_iter().map(|h| h.into_iter().collect()).collect();
        Ok(Self { topology: Topology::Other, heard })
    }

    /// The agent `step` places on, where there is one.
    pub fn beside(&self, i: usize, step: isize) -> Option<usize> {
        let count = self.heard.len();
        let beside = i.checked_add_signed(step);
        match self.topology {
            Topology::Line => beside.filter(|&j| j < count),
            Topology::Ring if count > 1 => match beside {
                Some(j) => Some(j % count),
                None => count.checked_add_signed(step),
            },
            _ => None,
        }
    }
}

/// `grid RxC`: the number of columns.
fn grid(name: &str, count: usize) -> Result<usize, String> {
    let size = name.strip_prefix("grid ").and_then(|size| {
        let (rows, columns) = size.split_once('x')?;
        Some((rows.trim().parse::<usize>().ok()?, columns.trim().parse::<usize>().ok()?))
    });
    match size {
        Some((rows, columns)) if rows.checked_mul(columns) == Some(count) && columns > 0 => {
            Ok(columns)
        }
        Some(_) => {
            Err(format!("`{name}`: expected rows times columns to be {count}, one an agent"))
        }
        None => Err(format!(
            "`{name}`: expected `line`, `ring`, `star`, `complete`, `grid RxC` or a list of links"
        )),
    }
}

/// A link as listed: from, to, whether both ways, weight.
fn link(item: &Value) -> Result<(usize, usize, bool, Rational), String> {
    let fail = || {
        format!(
            "`{}`: expected a link like `[0, 1]`, `\"0 -> 1\"` or `\"0 - 1: 1/2\"`",
            shown(item)
        )
    };
    match item {
        Value::Array(pair) => {
            let index = |v: &Value| v.as_integer().and_then(|n| usize::try_from(n).ok());
            match pair.as_slice() {
                [a, b] => match (index(a), index(b)) {
                    (Some(a), Some(b)) => Ok((a, b, true, Rational::one())),
                    _ => Err(fail()),
                },
                _ => Err(fail()),
            }
        }
        Value::String(text) => {
            let (ends, weight) = match text.split_once(':') {
                Some((ends, weight)) => {
                    let weight =
                        exact::parse("weight", weight.trim()).map_err(|e| e.to_string())?;
                    (ends, weight)
                }
                None => (text.as_str(), Rational::one()),
            };
            let split = ends.split_once("->").map(|pair| (pair, false));
            let ((a, b), both) =
                split.or_else(|| ends.split_once('-').map(|pair| (pair, true))).ok_or_else(fail)?;
            match (a.trim().parse(), b.trim().parse()) {
                (Ok(a), Ok(b)) => Ok((a, b, both, weight)),
                _ => Err(fail()),
            }
        }
        _ => Err(fail()),
    }
}

fn shown(item: &Value) -> String {
    cordon_core::text::cut(item.to_string().trim_matches('"'), 40)
}
