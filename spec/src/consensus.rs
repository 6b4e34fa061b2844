//! The consensus (rendez-vous) protocol: equation 6.

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::graph::Graph;
use crate::{DroneMap, Scalar};

/// The sum over the neighbours j of drone `i` of `x_j - x_i`: component `i` of `-L x`, with
/// L the Laplacian of the graph. `i` is below N, and `x` has one entry a drone.
#[cfg_attr(feature = "contracts", trusted)] // without a promise: `fold` has no contract
pub fn pull<S: Scalar, G: Graph>(graph: &G, x: &[S], i: usize) -> S {
    graph
        .neighbourhood(i)
        .filter(|&j| graph.linked(i, j))
        .fold(S::from_int(0), |sum, j| sum + &(x[j].clone() - &x[i]))
}

/// One consensus step, all drones moving: `x_i' = x_i + eps * sum over neighbours (x_j - x_i)`
/// (equation 6).
pub fn exec_consensus<S: Scalar, G: Graph, M: DroneMap<S>>(eps: &S, graph: &G, x: &M) -> M {
    let x_of = x.as_ref();
    x.lambda(|i| x_of[i].clone() + &(eps.clone() * &pull(graph, x_of, i)))
}
