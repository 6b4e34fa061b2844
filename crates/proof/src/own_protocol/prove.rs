//! Proofs by induction over the steps, with multipliers from exact linear programs.
//!
//! Candidates for the invariant are the claims and the assumptions on the start, and, where the
//! weight is one number, the claims about the next few steps. All of them hold of the start;
//! those that a step does not provably keep are dropped until all that are left are kept
//! (Houdini). The claims are proved if they survive. The step is affine in eps, so that what
//! is kept at both ends of its range is kept throughout.

use std::collections::BTreeMap;

use serde_json::Value;

use super::{OwnProtocol, inequalities};
use crate::certificate::linear::{
    Edge, Invariance, LinearSystem, Multipliers, NodeClaim, form, multipliers,
};
use cordon_core::Rational;
use cordon_core::exact::fraction;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Premises, Sign, point};

/// Claims about the next so many steps are tried as part of the invariant.
const LOOK_AHEAD: usize = 4;

/// A proof: the claims hold at every step from every assumed start, for all weights in range.
#[derive(Clone, Debug)]
pub struct InductiveProof {
    /// Half-spaces of the invariant, those of the claims first.
    pub half_spaces: usize,
    /// How many of them say what the claims say.
    pub claimed: usize,
    /// That every assumed start meets the invariant, that each step keeps it at both ends of the range of
    /// eps, and that the claims follow.
    pub certificate: Value,
}

/// Whether no start meets the assumptions, so that there is nothing to prove.
pub fn is_vacuous(protocol: &OwnProtocol) -> bool {
    let x = protocol.variables();
    let starts: Vec<Constraint> = protocol.starts.iter().map(|c| c.about(&x)).collect();
    point(protocol.count, &starts).is_none()
}

/// A proof, if the search finds one. None does not mean that a claim is false.
pub fn prove(protocol: &OwnProtocol) -> Option<InductiveProof> {
    let weights = protocol.extreme_weights();
    let depth = if weights.len() == 1 { LOOK_AHEAD } else { 1 };
    let x = protocol.variables();
    let constraints = |claims: &[super::Predicate], at: &[Affine]| -> Vec<Constraint> {
        claims.iter().flat_map(|c| inequalities(&c.about(at))).collect()
    };
    let starts = constraints(&protocol.starts, &x);
    let assumed = Premises::new(&starts)?;
    // The first attempt is the claims alone: the shortest certificate.
    let mut pool: Vec<Constraint> = Vec::new();
    let mut ahead = x.clone();
    let claimed = constraints(&protocol.claims, &x).len();
    for look_ahead in 0..=depth {
        match look_ahead {
            0 => pool = constraints(&protocol.claims, &x),
            1 => extend(&mut pool, starts.clone()),
            _ => {
                ahead = protocol.step_forms(weights.first()?, &ahead);
                extend(&mut pool, constraints(&protocol.claims, &ahead));
            }
        }
        // What does not hold of every start is no invariant; a claim that does not is false.
        let holds_of_start = |c: &Constraint| assumed.multipliers(c).is_some();
        if !pool.iter().take(claimed).all(holds_of_start) {
            return None;
        }
        pool.retain(holds_of_start);
        if let Some(proof) = kept(protocol, &starts, &weights, pool.clone(), claimed) {
            return Some(proof);
        }
    }
    None
}

/// Adds what is not there yet.
fn extend(pool: &mut Vec<Constraint>, more: Vec<Constraint>) {
    for c in more {
        if !pool.contains(&c) {
            pool.push(c);
        }
    }
}

/// Drops what is not kept until all is; fails when a claim has to go.
fn kept(
    protocol: &OwnProtocol,
    starts: &[Constraint],
    weights: &[Rational],
    mut pool: Vec<Constraint>,
    claimed: usize,
) -> Option<InductiveProof> {
    let x = protocol.variables();
    loop {
        let mut proofs: Vec<Vec<Option<Vec<Rational>>>> = Vec::new();
        let premises = Premises::new(&pool)?;
        for eps in weights {
            let next = protocol.step_forms(eps, &x);
            let after =
                |c: &Constraint| Constraint { form: substituted(&c.form, &next), ..c.clone() };
            let rows = pool.iter().map(|c| premises.multipliers(&after(c)));
            proofs.push(rows.collect());
        }
        let failed: Vec<bool> =
            (0..pool.len()).map(|j| proofs.iter().any(|rows| rows[j].is_none())).collect();
        if !failed.contains(&true) {
            let certificate = sealed(protocol, starts, &pool, claimed, &proofs)?;
            return Some(InductiveProof { half_spaces: pool.len(), claimed, certificate });
        }
        if failed.iter().take(claimed).any(|&f| f) {
            return None;
        }
        let mut verdicts = failed.iter();
        pool.retain(|_| verdicts.next() == Some(&false));
    }
}

/// The form with forms in place of its variables.
fn substituted(form: &Affine, x: &[Affine]) -> Affine {
    let Some((constant, coefficients)) = form.parts() else {
        return Affine::beyond();
    };
    coefficients.iter().zip(x).fold(Affine::constant(constant.clone()), |sum, (c, x)| {
        sum + &(Affine::constant(c.clone()) * x)
    })
}

/// Base case, step at both ends of the range of eps, and claims, in one certificate.
fn sealed(
    protocol: &OwnProtocol,
    starts: &[Constraint],
    pool: &[Constraint],
    claimed: usize,
    proofs: &[Vec<Option<Vec<Rational>>>],
) -> Option<Value> {
    let names: Vec<String> = (0..protocol.count).map(|i| format!("x{i}")).collect();
    let text = |f: &Affine| {
        let (constant, coefficients) = f.parts()?;
        Some(form(constant, names.iter().map(String::as_str).zip(coefficients)))
    };
    let literal = |c: &Constraint| {
        let sign = if c.sign == Sign::Positive { ">" } else { ">=" };
        Some(format!("{} {sign} 0", text(&c.form)?))
    };
    let literals = |all: &[Constraint]| all.iter().map(literal).collect::<Option<Vec<_>>>();
    let weights = protocol.extreme_weights();
    let ends = weights.iter().map(|eps| protocol.step_forms(eps, &protocol.variables()));
    let ends: Vec<Vec<Affine>> = ends.collect();
    let mut step = BTreeMap::new();
    let mut parameters = BTreeMap::new();
    for (i, name) in names.iter().enumerate() {
        let at = |end: &Vec<Affine>| end.get(i).cloned();
        let row =
            match (weights.as_slice(), ends.iter().map(at).collect::<Option<Vec<_>>>()?.as_slice())
            {
                // Affine in eps: low + slope (eps - lo).
                ([lo, hi], [low, high]) => {
                    parameters.insert("eps".to_owned(), [fraction(lo), fraction(hi)]);
                    let scale = |f: Affine, by: Rational| f * &Affine::constant(by);
                    let slope = scale(high.clone() - low, (hi - lo).recip());
                    let rest = low.clone() - &scale(slope.clone(), lo.clone());
                    match text(&slope)?.as_str() {
                        "0" => text(&rest)?,
                        slope => format!("{} + eps*({slope})", text(&rest)?),
                    }
                }
                ([_], [only]) => text(only)?,
                _ => return None,
            };
        step.insert(name.clone(), row);
    }
    let assumed = Premises::new(starts)?;
    let base = pool.iter().map(|c| Some(vec![multipliers(&assumed.multipliers(c)?)]));
    let rows = pool.iter().enumerate().map(|(j, c)| {
        let row = |proof: &Vec<Option<Vec<Rational>>>| Some(multipliers(proof.get(j)?.as_ref()?));
        let mut at_ends = proofs.iter().map(row).collect::<Option<Vec<_>>>()?;
        // Where eps cancels, one end stands for both.
        let mut after = ends.iter().map(|next| substituted(&c.form, next));
        let first = after.next();
        if after.all(|f| Some(f) == first) {
            at_ends.truncate(1);
        }
        Some(at_ends)
    });
    let edge = |from: &str, by: Option<&str>, multipliers: Vec<Vec<Multipliers>>| Edge {
        from: from.into(),
        by: by.map(str::to_owned),
        to: "kept".into(),
        multipliers,
    };
    let claim = |(j, c): (usize, &Constraint)| {
        let multipliers = BTreeMap::from([(j, "1".to_owned())]);
        Some(NodeClaim { at: "kept".into(), holds: literal(c)?, multipliers })
    };
    let invariance = Invariance {
        edges: vec![
            edge("start", None, base.collect::<Option<_>>()?),
            edge("kept", Some("step"), rows.collect::<Option<_>>()?),
        ],
        claims: pool.iter().take(claimed).enumerate().map(claim).collect::<Option<_>>()?,
        nodes: [("start", starts), ("kept", pool)]
            .into_iter()
            .map(|(name, all)| Some((name.to_owned(), literals(all)?)))
            .collect::<Option<_>>()?,
        start: "start".into(),
        system: LinearSystem { state: names, parameters, modes: [("step".into(), step)].into() },
    };
    Some(invariance.certificate())
}
