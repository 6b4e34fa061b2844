//! What was found, in the format of the checker (`proofs/checker/FORMAT.md`).

use serde_json::{Map, Value, json};

use super::claims::Claim;
use super::goals::{Primitive, Scope};
use super::search::{Proof, Terms, terms_of};

/// The format's name.
pub const SCHEMA: &str = "cordon-certificate/1";

/// The proofs of a claim.
pub fn theorem(
    claim: &Claim,
    scope: &Scope,
    primitives: &[Primitive],
    proofs: &[(String, Proof)],
) -> Value {
    let mut body = Map::new();
    body.insert("claim".into(), json!(claim.name));
    if claim.has_forms() {
        body.insert("form".into(), json!(scope.form.label()));
    }
    if let Some(n) = scope.drones {
        body.insert("drones".into(), json!(n));
    }
    if let Some((from, to)) = &scope.weights {
        let interval = json!({ "from": from.to_string(), "to": to.to_string() });
        body.insert("weights".into(), interval);
    }
    if !primitives.is_empty() {
        let data: Vec<Value> = primitives
            .iter()
            .map(|p| json!({ "name": p.name, "polynomial": terms(&terms_of(&p.poly)) }))
            .collect();
        body.insert("data".into(), json!(data));
    }
    body.insert("proofs".into(), discharges(proofs));
    sealed("theorem", Value::Object(body))
}

/// A certificate of that kind.
pub fn sealed(kind: &str, body: Value) -> Value {
    json!({ "schema": SCHEMA, "certificate": { kind: body } })
}

/// Proofs by name of their obligation.
pub fn discharges(proofs: &[(String, Proof)]) -> Value {
    proofs.iter().map(|(name, p)| json!({ "obligation": name, "proof": proof(p) })).collect()
}

/// A polynomial, or a sum of products of facts.
pub fn terms(terms: &Terms) -> Value {
    terms.iter().map(|(c, of)| json!({ "c": c.to_string(), "of": of })).collect()
}

fn proof(p: &Proof) -> Value {
    let sum = |rule: &str, times: &[String], sum: &Terms| {
        let mut body = Map::new();
        body.insert("rule".into(), json!(rule));
        if !times.is_empty() {
            body.insert("times".into(), json!(times));
        }
        if !sum.is_empty() {
            body.insert("terms".into(), terms(sum));
        }
        Value::Object(body)
    };
    match p {
        Proof::Positivity { times, terms } => sum("positivity", times, terms),
        Proof::Identity { times, terms } => sum("identity", times, terms),
        Proof::Split { on, branches } => {
            let branches: Vec<Value> = branches.iter().map(proof).collect();
            json!({ "rule": "split", "on": terms(on), "branches": branches })
        }
    }
}
