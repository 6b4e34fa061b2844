//! Proofs by induction over the steps, with multipliers from exact linear programs.
//!
//! Candidates for the invariant are the claims and the assumptions on the start, and, where the
//! weight is one number, the claims about the next few steps. All of them hold of the start;
//! those that a step does not provably keep are dropped until all that are left are kept
//! (Houdini). The claims are proved if they survive. The step is affine in eps, so that what
//! is kept at both ends of its range is kept throughout.

use serde_json::Value;

use super::{OwnProtocol, inequalities};
use crate::certificate::{self, HalfSpace};
use cordon_core::Rational;
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
    /// The invariance certificates, one a weight: at both ends of the range.
    pub certificates: Vec<(Rational, Value)>,
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
        if let Some(proof) = kept(protocol, &weights, pool.clone(), claimed) {
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
            let certificates = weights
                .iter()
                .zip(&proofs)
                .map(|(eps, rows)| Some((eps.clone(), sealed(protocol, eps, &pool, rows)?)))
                .collect::<Option<Vec<_>>>()?;
            return Some(InductiveProof { half_spaces: pool.len(), claimed, certificates });
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

fn sealed(
    protocol: &OwnProtocol,
    eps: &Rational,
    pool: &[Constraint],
    rows: &[Option<Vec<Rational>>],
) -> Option<Value> {
    let padded = |coefficients: &[Rational]| {
        let mut row = coefficients.to_vec();
        row.resize(protocol.count, Rational::default());
        row
    };
    let mut matrix = Vec::new();
    let mut offset = Vec::new();
    for form in protocol.step_forms(eps, &protocol.variables()) {
        let (constant, coefficients) = form.parts()?;
        matrix.push(padded(coefficients));
        offset.push(constant.clone());
    }
    let half_space = |c: &Constraint| {
        let (constant, coefficients) = c.form.parts()?;
        let strict = c.sign == Sign::Positive;
        Some(HalfSpace { normal: padded(coefficients), bound: -constant, strict })
    };
    let invariant = pool.iter().map(half_space).collect::<Option<Vec<_>>>()?;
    let multipliers = rows.iter().cloned().collect::<Option<Vec<_>>>()?;
    Some(certificate::invariance(&matrix, &offset, &invariant, &multipliers))
}
