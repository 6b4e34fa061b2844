//! Undirected communication graphs.

use core::ops::Range;

#[cfg(feature = "contracts")]
use crate::model::*;

/// An undirected graph on the drones `0 .. count`: who hears whom.
pub trait Graph {
    /// The number of drones, for the contracts.
    #[cfg(feature = "contracts")]
    #[logic]
    fn size(self) -> Int;

    /// Whether drones `i` and `j` are linked, for the contracts.
    #[cfg(feature = "contracts")]
    #[logic]
    fn edge(self, i: Int, j: Int) -> bool;

    /// Links go both ways, and none leads from a drone to itself.
    #[cfg(feature = "contracts")]
    #[logic(law)]
    #[ensures(self.edge(i, j) == self.edge(j, i) && !self.edge(i, i))]
    fn undirected(self, i: Int, j: Int);

    /// The number of drones.
    #[cfg_attr(feature = "contracts", ensures(result@ == self.size()))]
    fn count(&self) -> usize;

    /// Whether drones `i` and `j` are linked. Symmetric, and never true of `i == j`.
    #[cfg_attr(feature = "contracts", requires(i@ < self.size() && j@ < self.size()))]
    #[cfg_attr(feature = "contracts", ensures(result == self.edge(i@, j@)))]
    fn linked(&self, i: usize, j: usize) -> bool;

    /// A range that contains every neighbour of `i`; narrower where the graph knows better.
    #[cfg_attr(feature = "contracts", requires(_i@ < self.size()))]
    #[cfg_attr(feature = "contracts", ensures(hears(*self, _i@, result)))]
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
    #[cfg(feature = "contracts")]
    #[logic(open)]
    fn size(self) -> Int {
        self.count.view()
    }

    #[cfg(feature = "contracts")]
    #[logic(open)]
    fn edge(self, i: Int, j: Int) -> bool {
        i == j + 1 || j == i + 1
    }

    #[cfg(feature = "contracts")]
    #[logic(law)]
    #[ensures(self.edge(i, j) == self.edge(j, i) && !self.edge(i, i))]
    fn undirected(self, i: Int, j: Int) {}

    #[cfg_attr(feature = "contracts", ensures(result@ == self.size()))]
    fn count(&self) -> usize {
        self.count
    }

    #[cfg_attr(feature = "contracts", requires(i@ < self.size() && j@ < self.size()))]
    #[cfg_attr(feature = "contracts", ensures(result == self.edge(i@, j@)))]
    fn linked(&self, i: usize, j: usize) -> bool {
        i.abs_diff(j) == 1 && i.max(j) < self.count
    }

    #[cfg_attr(feature = "contracts", requires(i@ < self.size()))]
    #[cfg_attr(feature = "contracts", ensures(hears(*self, i@, result)))]
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
    /// The pairs of linked drones, either of them first.
    pub edges: &'e [(usize, usize)],
}

impl Graph for Edges<'_> {
    #[cfg(feature = "contracts")]
    #[logic(open)]
    fn size(self) -> Int {
        self.count.view()
    }

    #[cfg(feature = "contracts")]
    #[logic(open)]
    fn edge(self, i: Int, j: Int) -> bool {
        pearlite! {
            i != j && exists<k> 0 <= k && k < self.edges@.len() && joins(self.edges@[k], i, j)
        }
    }

    #[cfg(feature = "contracts")]
    #[logic(law)]
    #[ensures(self.edge(i, j) == self.edge(j, i) && !self.edge(i, i))]
    fn undirected(self, i: Int, j: Int) {}

    #[cfg_attr(feature = "contracts", ensures(result@ == self.size()))]
    fn count(&self) -> usize {
        self.count
    }

    #[cfg_attr(feature = "contracts", requires(i@ < self.size() && j@ < self.size()))]
    #[cfg_attr(feature = "contracts", ensures(result == self.edge(i@, j@)))]
    fn linked(&self, i: usize, j: usize) -> bool {
        let mut found = false;
        #[cfg_attr(creusot, invariant(found == exists<k> 0 <= k && k < produced.len() && joins(self.edges@[k], i@, j@)))]
        for &(a, b) in self.edges {
            #[cfg(creusot)]
            proof_assert!((a, b) == self.edges@[produced.len() - 1]);
            found |= a == i && b == j || a == j && b == i;
        }
        i != j && found
    }
}
