//! A protocol file for every number of agents: its classes, given to the kernel's search.

use serde_json::Value;

use crate::prove::any_size::{AnySize, Family, Topology, any_size as search};
use cordon_core::system::Parameter;
use cordon_run::protocol::Classes;

/// A certificate for every N >= 3, where the search finds one; or why there is none, in words.
///
/// # Errors
/// There is none; the error is the reason.
pub fn any_size(classes: &Classes) -> Result<(Value, usize), String> {
    let range = |p: &Parameter| (p.name.clone(), [Some(p.low.clone()), Some(p.high.clone())]);
    let family = Family {
        topology: if classes.is_ring { Topology::Ring } else { Topology::Line },
        state: classes.state.clone(),
        parameters: classes.parameters.iter().map(range).collect(),
        rules: classes.rules.clone(),
        given: Vec::new(),
        start: classes.starts.clone(),
        claims: classes.claims.clone(),
    };
    match search(&family) {
        Ok(Some(AnySize { certificate, invariant })) => Ok((certificate, invariant)),
        Ok(None) => Err("no induction over the steps was found".to_owned()),
        Err(e) => Err(e.to_string()),
    }
}
