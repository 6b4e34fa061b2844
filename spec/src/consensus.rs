//! The consensus (rendez-vous) protocol: equation 6.

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::graph::Graph;
use crate::{DroneMap, Scalar};

/// The sum over the neighbours j of drone `i` of `x_j - x_i`: component `i` of `-L x`, with
/// L the Laplacian of the graph. `i` is below N, and `x` has one entry a drone.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && i@ < x@.len() && graph.size() == x@.len()))]
#[cfg_attr(feature = "contracts", ensures(result.model() == pull_of(*graph, reals(x@), i@, x@.len())))]
pub fn pull<S: Scalar, G: Graph>(graph: &G, x: &[S], i: usize) -> S {
    let mut sum = S::from_int(0);
    let near = graph.neighbourhood(i);
    #[cfg(creusot)]
    let first = snapshot!(near.start@);
    #[cfg(creusot)]
    proof_assert!({
        range_is_all(*graph, reals(x@), i@, near);
        pull_of(*graph, reals(x@), i@, near.start@) == int(0) && pull_of(*graph, reals(x@), i@, near.end@) == pull_of(*graph, reals(x@), i@, x@.len())
    });
    #[cfg_attr(creusot, invariant(sum.model() == pull_of(*graph, reals(x@), i@, *first + produced.len())))]
    for j in near {
        #[cfg(creusot)]
        proof_assert!(j@ == *first + produced.len() - 1 && reals(x@)[j@] == x@[j@].model() && reals(x@)[i@] == x@[i@].model()
            && pull_of(*graph, reals(x@), i@, j@ + 1) == pull_of(*graph, reals(x@), i@, j@) + heard(*graph, reals(x@), i@, j@));
        if graph.linked(i, j) {
            sum = sum + &(x[j].clone() - &x[i]);
        }
    }
    sum
}

/// One consensus step, all drones moving: `x_i' = x_i + eps * sum over neighbours (x_j - x_i)`
/// (equation 6).
#[cfg_attr(feature = "contracts", requires(exact::<S>() && graph.size() == x.seq().len()))]
#[cfg_attr(feature = "contracts", ensures(reals(result.seq()).ext_eq(consensus_step(eps.model(), *graph, reals(x.seq())))))]
pub fn exec_consensus<S: Scalar, G: Graph, M: DroneMap<S>>(eps: &S, graph: &G, x: &M) -> M {
    let x_of = x.as_ref();
    x.lambda(|i| x_of[i].clone() + &(eps.clone() * &pull(graph, x_of, i)))
}
