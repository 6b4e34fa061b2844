//! The nodes of an invariant in the order of a run: first a chain, then nodes that recur.

use std::collections::BTreeMap;

use super::super::linear::{Edge, Invariance};
use super::super::runs::Turns;

/// How a node is reached.
#[derive(Clone, Debug)]
pub enum How<'i> {
    /// It is assumed of the start.
    Start,
    /// It follows from the one before, at the same step.
    Here(&'i Edge),
    /// It follows from the one before by a step: an edge for each mode.
    Step(Vec<&'i Edge>),
}

/// A node at a step.
#[derive(Clone, Debug)]
pub struct Place<'i> {
    /// The node.
    pub node: &'i str,
    /// The first step at which it holds.
    pub step: usize,
    /// How it is reached.
    pub how: How<'i>,
}

/// Nodes in the order of a run.
#[derive(Clone, Debug)]
pub struct Walk<'i> {
    /// The nodes, each at the first step where it holds.
    pub places: Vec<Place<'i>>,
    /// The place to which the last leads back, if it does, and how.
    pub back: Option<(usize, Vec<&'i Edge>)>,
    /// Which mode acts when.
    pub turns: Turns,
}

impl<'i> Walk<'i> {
    /// The walk through an invariant's nodes. `None` where they are not in one row: a node is left for two
    /// others, or the modes act neither freely nor in turns.
    pub fn through(invariance: &'i Invariance) -> Option<Self> {
        let mut leaving: BTreeMap<&str, Vec<&Edge>> = BTreeMap::new();
        for edge in &invariance.edges {
            leaving.entry(&edge.from).or_default().push(edge);
        }
        let mut places = vec![Place { node: invariance.start.as_str(), step: 0, how: How::Start }];
        let mut back = None;
        let mut acting: Vec<Vec<usize>> = Vec::new();
        while let Some(last) = places.last() {
            let Some(edges) = leaving.get(last.node) else { break };
            let to = edges.first()?.to.as_str();
            let timeless = edges.iter().any(|e| e.by.is_none());
            if edges.iter().any(|e| e.to != to) || (timeless && edges.len() > 1) {
                return None;
            }
            if !timeless {
                acting.push(modes(invariance, edges)?);
            }
            match places.iter().position(|p| p.node == to) {
                Some(_) if timeless => return None,
                Some(place) => {
                    back = Some((place, edges.clone()));
                    break;
                }
                None => {
                    let step = last.step + usize::from(!timeless);
                    let how = match edges.as_slice() {
                        [edge] if timeless => How::Here(edge),
                        edges => How::Step(edges.to_vec()),
                    };
                    places.push(Place { node: to, step, how });
                }
            }
        }
        let all = invariance.system.modes.len();
        let turns = if acting.iter().all(|modes| modes.len() == all) {
            Turns::Any
        } else {
            let single = acting.iter().map(|m| if let [m] = m[..] { Some(m) } else { None });
            let list = single.collect::<Option<Vec<_>>>()?;
            // Those that recur are the period, and those before are of it too.
            let first = back.as_ref().map_or(0, |(place, _)| places[*place].step);
            let period = list.len() - first;
            let turn = |step: usize| list[first + (step + period - first % period) % period];
            let cycle: Vec<usize> = (0..period).map(turn).collect();
            if (0..first).any(|step| list[step] != cycle[step % period]) {
                return None;
            }
            Turns::Cycle(cycle)
        };
        Some(Self { places, back, turns })
    }
}

/// The places of the edges' modes, none twice.
fn modes(invariance: &Invariance, edges: &[&Edge]) -> Option<Vec<usize>> {
    let place = |e: &&Edge| {
        let by = e.by.as_ref()?;
        invariance.system.modes.keys().position(|m| m == by)
    };
    let mut modes = edges.iter().map(place).collect::<Option<Vec<_>>>()?;
    modes.sort_unstable();
    let count = modes.len();
    modes.dedup();
    (modes.len() == count).then_some(modes)
}
