//! Consensus and formation (equations 6 and 8), and the graphs they run on. Integers modulo 4, every
//! one of them: that a sum is kept takes distributivity, which is dear to the solver.

use cordon_spec::Scalar;
use cordon_spec::consensus::{exec_consensus, pull};
use cordon_spec::formation::exec_formation;
use cordon_spec::graph::{Edges, Graph, Path};
use cordon_spec::placement::sum;

use crate::harness::{covering, harnesses};
use crate::line::same;
use crate::residue::Residue;
use crate::source::{Case, Domain, Source, Witness};

const FUNCTIONS: &[&str] = &[
    "consensus::exec_consensus",
    "consensus::pull",
    "formation::exec_formation",
    "graph::Graph::count",
    "graph::Graph::linked",
    "graph::Graph::neighbourhood",
    "graph::Edges::count",
    "graph::Edges::linked",
    "graph::Path::count",
    "graph::Path::linked",
    "graph::Path::neighbourhood",
];

type Ring = Residue<2>;

/// The six pairs of four drones.
const PAIRS: [(usize, usize); 6] = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];

/// A list of edges that links the pairs drawn, in a drawn direction. An absent one is a loop,
/// which the graph ignores.
fn drawn_edges<const E: usize, S: Source>(
    source: &mut S,
    pairs: [(usize, usize); E],
) -> [(usize, usize); E] {
    pairs.map(|(i, j)| match source.integer(Domain::whole(0, 2)) {
        0 => (i, i),
        1 => (i, j),
        _ => (j, i),
    })
}

/// A step keeps the sum, whatever the weight: what i gets from j, j gives to i. Each drone moves
/// by eps times the sum of the differences to its neighbours. Witness: a drone has moved.
fn preserved<const N: usize, G: Graph, S: Source>(source: &mut S, graph: &G) -> Case {
    let x: [Ring; N] = core::array::from_fn(|_| Ring::draw(source));
    let eps = Ring::draw(source);
    let next = exec_consensus(&eps, graph, &x);
    assert!(sum(&next) == sum(&x), "the sum is kept");
    for i in 0..N {
        let mut expected = Ring::from_int(0);
        for j in 0..N {
            if graph.linked(i, j) {
                expected = expected + &(x[j] - &x[i]);
            }
        }
        assert!(pull(graph, &x, i) == expected, "the differences to the neighbours");
        assert!(next[i] == x[i] + &(eps * &expected), "moved by eps times them");
    }
    Some(Witness(!same(&next, &x)))
}

/// Formation moves by eps*(-L x + b): consensus and the displacements. Witness: they matter.
fn displaced<const N: usize, S: Source>(source: &mut S) -> Case {
    let graph = Path { count: N };
    let x: [Ring; N] = core::array::from_fn(|_| Ring::draw(source));
    let b: [Ring; N] = core::array::from_fn(|_| Ring::draw(source));
    let eps = Ring::draw(source);
    let next = exec_formation(&eps, &graph, &x, &b);
    let without = exec_consensus(&eps, &graph, &x);
    for i in 0..N {
        assert!(next[i] == without[i] + &(eps * &b[i]), "consensus and the displacement");
    }
    let displaced = sum(&x) + &(eps * &sum(&b));
    assert!(sum(&next) == displaced, "the sum changes by the displacements");
    Some(Witness(!same(&next, &without)))
}

/// A graph is symmetric and without loops, and knows where neighbours are. Witness: a link.
fn lawful<G: Graph>(graph: &G, i: usize, j: usize) -> Case {
    let linked = graph.linked(i, j);
    assert!(linked == graph.linked(j, i), "symmetric");
    assert!(!(linked && i == j), "no loops");
    assert!(!linked || graph.neighbourhood(i).contains(&j), "neighbours are where it says");
    Some(Witness(linked))
}

/// The path, with indices of any size. Witness: a link.
fn path_is_lawful<S: Source>(source: &mut S) -> Case {
    // Small and large indices, to the last.
    let from = if source.flag() { 0 } else { usize::MAX - 3 };
    let [i, j, count] =
        source.integers::<3>(Domain::whole(0, 3)).map(|n| from + n.unsigned_abs() as usize);
    let graph = Path { count };
    assert!(graph.count() == count, "the number of drones");
    let beside = i.abs_diff(j) == 1 && i < count && j < count;
    assert!(graph.linked(i, j) == beside, "neighbours are one apart");
    assert!(graph.neighbourhood(i).end <= count, "below the number of drones");
    lawful(&graph, i, j)
}

/// A list of edges: linked are the listed pairs. Witness: a link.
fn listed<S: Source>(source: &mut S) -> Case {
    let edges = drawn_edges(source, PAIRS);
    let graph = Edges { count: 4, edges: &edges };
    assert!(graph.count() == 4 && graph.neighbourhood(1) == (0..4), "all drones");
    let [i, j] = source.integers::<2>(Domain::whole(0, 3)).map(|n| n.unsigned_abs() as usize);
    let mut expected = false;
    for (at, &(a, b)) in edges.iter().enumerate() {
        expected |= a != b && (PAIRS[at] == (i, j) || PAIRS[at] == (j, i));
    }
    assert!(graph.linked(i, j) == expected, "linked are the listed pairs");
    lawful(&graph, i, j)
}

harnesses! {
    functions FUNCTIONS;
    /// Consensus of three drones on a path keeps the sum.
    path_3("consensus", unwind 5): covering!("N = 3, path, all positions and weights modulo 4")
        => |s| preserved::<3, _, _>(s, &Path { count: 3 });
    /// Consensus of four drones on a path keeps the sum.
    path_4("consensus", unwind 6): covering!("N = 4, path, all positions and weights modulo 4")
        => |s| preserved::<4, _, _>(s, &Path { count: 4 });
    /// Consensus of three drones on any graph keeps the sum.
    any_graph("consensus", unwind 5): covering!("N = 3, every graph, all positions and weights modulo 4")
        => |s| {
            let all = [(0, 1), (0, 2), (1, 2)];
            let edges = drawn_edges(s, all);
            preserved::<3, _, _>(s, &Edges { count: 3, edges: &edges })
        };
    /// Formation is consensus with displacements.
    formation_3("formation", unwind 5): covering!("N = 3, path, all positions and weights modulo 4")
        => |s| displaced::<3, _>(s);
    /// A path is symmetric and has no loops, whatever the indices.
    path("graph", unwind 5): covering!("four smallest and four largest indices") => |s| path_is_lawful(s);
    /// A list of edges is symmetric, ignores loops, and links what it lists.
    edges("graph", unwind 8): covering!("N = 4, every list of six edges") => |s| listed(s);
}
