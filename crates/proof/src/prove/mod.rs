//! Proofs: the untrusted search for certificates. What it finds counts only once the
//! independent checker (`cordon-check`) has accepted it.

pub mod certificate;
pub mod claims;
pub mod exactness;
mod exchange;
mod goals;
mod primitive;
mod search;
mod symbols;
mod window;

use serde_json::Value;

use claims::Claim;
pub use goals::Scope;
pub use search::Effort;

/// How a search ends.
#[derive(Clone, Debug, PartialEq)]
pub enum Found {
    /// A certificate: for the checker to judge.
    Certificate(Value),
    /// No proof within the effort; these goals lack one.
    Nothing(Vec<String>),
}

/// Searches a proof of the claim.
pub fn prove(claim: &Claim, scope: &Scope, effort: Effort) -> Found {
    let primitives: Vec<_> = primitive::find(claim).into_iter().collect();
    let goals = goals::Deriver { claim, scope, primitives: &primitives }.goals();
    let (mut proofs, mut missing) = (Vec::new(), Vec::new());
    for goal in goals {
        match search::prove(&goal, effort) {
            Some(proof) => proofs.push((goal.name, proof)),
            None => missing.push(goal.name),
        }
    }
    if missing.is_empty() {
        Found::Certificate(certificate::theorem(claim, scope, &primitives, &proofs))
    } else {
        Found::Nothing(missing)
    }
}
