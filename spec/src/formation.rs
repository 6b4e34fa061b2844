//! Formation control: equation 8 in discrete time.

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::consensus::pull;
use crate::graph::Graph;
use crate::{DroneMap, Scalar};

/// One formation step: `x' = x + eps*(-L x + b)`, with L the Laplacian of the graph and
/// `b_i` the sum of the wanted displacements of drone `i` from its neighbours (equation 8,
/// Euler's rule). `b` has one entry a drone.
#[cfg_attr(feature = "contracts", requires(exact::<S>() && graph.size() == x.seq().len() && b.seq().len() == x.seq().len()))]
#[cfg_attr(feature = "contracts", ensures(result.seq().len() == x.seq().len() && forall<i> 0 <= i && i < x.seq().len() ==> result.seq()[i].model()
    == x.seq()[i].model() + eps.model() * (pull_of(*graph, reals(x.seq()), i, x.seq().len()) + b.seq()[i].model())))]
pub fn exec_formation<S: Scalar, G: Graph, M: DroneMap<S>>(eps: &S, graph: &G, x: &M, b: &M) -> M {
    let (x_of, b_of) = (x.as_ref(), b.as_ref());
    x.lambda(|i| x_of[i].clone() + &(eps.clone() * &(pull(graph, x_of, i) + &b_of[i])))
}
