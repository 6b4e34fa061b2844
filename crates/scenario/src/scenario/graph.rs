//! Communication graphs that a scenario can name.

use std::collections::BTreeSet;
use std::ops::Range;

use cordon_spec::graph::{Graph, Path};

use cordon_core::{Error, Result};

/// An undirected graph on the drones of a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Topology {
    /// `0 - 1 - ... - (N-1)`: the line of drones.
    Path(usize),
    /// The path closed to a ring.
    Ring(usize),
    /// Everyone hears everyone; the number of drones.
    Complete(usize),
    /// The listed pairs, smaller drone first.
    Edges(usize, BTreeSet<(usize, usize)>),
}

impl Topology {
    /// The graph called `name` on `count` drones.
    ///
    /// # Errors
    /// An unknown name.
    pub fn named(name: &str, count: usize) -> Result<Self> {
        match name {
            "path" => Ok(Self::Path(count)),
            "ring" => Ok(Self::Ring(count)),
            "complete" => Ok(Self::Complete(count)),
            _ => Err(Error::input(format!(
                "graph: `{name}` is unknown: expected `path`, `ring` or `complete`, or in a scenario file \
                 a list of edges"
            ))),
        }
    }

    /// The graph with these edges.
    ///
    /// # Errors
    /// A drone that does not exist, or an edge from a drone to itself.
    pub fn from_edges(edges: &[(usize, usize)], count: usize) -> Result<Self> {
        let mut set = BTreeSet::new();
        for &(i, j) in edges {
            if i >= count || j >= count || i == j {
                return Err(Error::input(format!(
                    "graph: edge `[{i}, {j}]`: expected two different drones from 0 to {}",
                    count.saturating_sub(1)
                )));
            }
            set.insert((i.min(j), i.max(j)));
        }
        Ok(Self::Edges(count, set))
    }
}

impl Graph for Topology {
    fn count(&self) -> usize {
        match self {
            Self::Path(n) | Self::Ring(n) | Self::Complete(n) | Self::Edges(n, _) => *n,
        }
    }

    fn linked(&self, i: usize, j: usize) -> bool {
        let n = self.count();
        match self {
            Self::Path(_) => Path { count: n }.linked(i, j),
            Self::Ring(_) => {
                let apart = i.abs_diff(j);
                i.max(j) < n && (apart == 1 || (apart + 1 == n && n > 2))
            }
            Self::Complete(_) => i != j && i.max(j) < n,
            Self::Edges(_, set) => set.contains(&(i.min(j), i.max(j))),
        }
    }

    fn neighbourhood(&self, i: usize) -> Range<usize> {
        match self {
            Self::Path(n) => Path { count: *n }.neighbourhood(i),
            _ => 0..self.count(),
        }
    }
}
