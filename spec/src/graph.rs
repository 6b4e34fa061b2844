//! Undirected communication graphs.

use core::ops::Range;

#[cfg(feature = "contracts")]
use crate::model::*;

/// An undirected graph on the drones `0 .. count`: who hears whom.
pub trait Graph {
    /// The number of drones.
    fn count(&self) -> usize;

    /// Whether drones `i` and `j` are linked. Symmetric, and never true of `i == j`.
    fn linked(&self, i: usize, j: usize) -> bool;

    /// A range that contains every neighbour of `i`; narrower where the graph knows better.
    fn neighbourhood(&self, _i: usize) -> Range<usize> {
        0..self.count()
    }
}

/// The path `0 - 1 - ... - (count-1)`: the line of drones, the default graph.
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct Path {
    /// The number of drones.
    pub count: usize,
}

impl Graph for Path {
    fn count(&self) -> usize {
        self.count
    }

    fn linked(&self, i: usize, j: usize) -> bool {
        i.abs_diff(j) == 1 && i.max(j) < self.count
    }

    fn neighbourhood(&self, i: usize) -> Range<usize> {
        i.saturating_sub(1)..i.saturating_add(2).min(self.count)
    }
}

/// A graph given by a list of its edges, in either direction. Loops are ignored.
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub struct Edges<'e> {
    /// The number of drones.
    pub count: usize,
    /// The linked pairs.
    pub edges: &'e [(usize, usize)],
}

impl Graph for Edges<'_> {
    fn count(&self) -> usize {
        self.count
    }

    // Trusted, without a promise: `any` has no contract.
    #[cfg_attr(feature = "contracts", trusted)]
    fn linked(&self, i: usize, j: usize) -> bool {
        i != j && self.edges.iter().any(|&e| e == (i, j) || e == (j, i))
    }
}
