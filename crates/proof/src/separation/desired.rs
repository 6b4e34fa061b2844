//! The smallest gap of the desired positions, preserved by every step of coverage.

use std::collections::BTreeMap;

use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Premises, Sign};
use cordon_spec::coverage::exec_coverage;
use cordon_spec::{Params, State};
use num_traits::Signed;
use serde_json::Value;

use crate::certificate::linear::{Edge, Invariance, LinearSystem, NodeClaim, form, multipliers};

/// Most drones for which a certificate is written.
pub const MOST: usize = 198;

/// Which drones update in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Update {
    /// All drones at once.
    AtOnce,
    /// One drone alone, any of them.
    OneByOne,
}

const KEPT: &str = "kept";

/// The certificate that all gaps stay at least `least`, at all steps, from a start whose end drones are
/// at the ends of the segment. `None` where a step may lower the smallest gap, where the start has a
/// smaller one, and beyond [`MOST`] drones.
pub fn smallest_gap(
    start: &[Rational],
    eps: &Rational,
    least: &Rational,
    update: Update,
) -> Option<Value> {
    let count = start.len();
    let (min, max) = (start.first()?, start.last()?);
    if count > MOST || start.windows(2).any(|x| (&x[1] - &x[0] - least).is_negative()) {
        return None;
    }
    let variables: Vec<Affine> = (0..count).map(Affine::variable).collect();
    let constant = |x: &Rational| Affine::constant(x.clone());
    let params = Params { min: constant(min), max: constant(max), eps: constant(eps), n: 0 };
    let state = State { drones: variables.clone(), timesteps: 0 };
    let stepped = exec_coverage(&params, &state).drones;
    let modes: Vec<(String, Vec<Affine>)> = match update {
        Update::AtOnce => vec![("step".to_owned(), stepped)],
        Update::OneByOne => (0..count)
            .map(|i| {
                let mut after = variables.clone();
                after[i].clone_from(&stepped[i]);
                (format!("drone{i}"), after)
            })
            .collect(),
    };
    // The end drones' positions, and the gaps.
    let kept = |x: &[Affine]| -> Vec<Constraint> {
        let pinned = [(0, min), (count - 1, max)]
            .map(|(i, at)| Constraint { form: x[i].clone() - &constant(at), sign: Sign::Zero });
        let gaps = x.windows(2).map(|pair| Constraint {
            form: pair[1].clone() - &pair[0] - &constant(least),
            sign: Sign::NonNegative,
        });
        pinned.into_iter().chain(gaps).collect()
    };
    let now = kept(&variables);
    let names: Vec<String> = (0..count).map(|i| format!("x{i}")).collect();
    let text = |f: &Affine| {
        let (constant, coefficients) = f.parts()?;
        Some(form(constant, names.iter().map(String::as_str).zip(coefficients)))
    };
    let literal = |c: &Constraint| {
        let relation = if c.sign == Sign::Zero { "=" } else { ">=" };
        Some(format!("{} {relation} 0", text(&c.form)?))
    };
    let literals = |all: &[Constraint]| all.iter().map(literal).collect::<Option<Vec<_>>>();
    let mut edges = vec![Edge {
        from: "start".to_owned(),
        by: None,
        to: KEPT.to_owned(),
        multipliers: (0..now.len())
            .map(|place| match place {
                0 => vec![[(0, "1".to_owned())].into()],
                1 => vec![[(count - 1, "1".to_owned())].into()],
                gap => {
                    vec![[(gap - 2, "-1".to_owned()), (gap - 1, "1".to_owned())].into()]
                }
            })
            .collect(),
    }];
    let mut updates = BTreeMap::new();
    for (name, after) in &modes {
        let goals = kept(after);
        let rows = goals.iter().enumerate().map(|(place, goal)| {
            // A gap after the step depends on itself and on its neighbours.
            let near: Vec<usize> =
                (0..now.len()).filter(|&p| p < 2 || p.abs_diff(place) < 2).collect();
            let given: Vec<Constraint> = near.iter().map(|&p| now[p].clone()).collect();
            let found = match goal.sign {
                Sign::Zero => pinned(&given, goal)?,
                _ => Premises::new(&given)?.multipliers(goal)?,
            };
            let mut row = vec![Rational::default(); now.len()];
            for (p, m) in near.into_iter().zip(found) {
                row[p] = m;
            }
            Some(vec![multipliers(&row)])
        });
        edges.push(Edge {
            from: KEPT.to_owned(),
            by: Some(name.clone()),
            to: KEPT.to_owned(),
            multipliers: rows.collect::<Option<_>>()?,
        });
        let changed = after.iter().zip(&variables).enumerate().filter(|(_, (a, b))| a != b);
        let changed = changed.map(|(i, (row, _))| Some((names[i].clone(), text(row)?)));
        updates.insert(name.clone(), changed.collect::<Option<BTreeMap<_, _>>>()?);
    }
    let claims = now.iter().enumerate().skip(2).map(|(place, c)| {
        let multipliers = [(place, "1".to_owned())].into();
        Some(NodeClaim { at: KEPT.to_owned(), holds: literal(c)?, multipliers })
    });
    let placed = start
        .iter()
        .zip(&variables)
        .map(|(at, x)| Constraint { form: x.clone() - &constant(at), sign: Sign::Zero });
    let placed: Vec<Constraint> = placed.collect();
    let whole = Invariance {
        nodes: [("start".to_owned(), literals(&placed)?), (KEPT.to_owned(), literals(&now)?)]
            .into(),
        start: "start".to_owned(),
        edges,
        claims: claims.collect::<Option<_>>()?,
        system: LinearSystem { state: names.clone(), parameters: BTreeMap::new(), modes: updates },
    };
    whole.certificate()
}

/// Multipliers of the given equations that yield one of them after a step: an end drone does not move.
fn pinned(given: &[Constraint], goal: &Constraint) -> Option<Vec<Rational>> {
    let whole = |is: bool| Rational::from_integer(i32::from(is).into());
    let constant = goal.form.as_constant().is_some_and(|c| *c == whole(false));
    let same = |c: &Constraint| !constant && c.sign == Sign::Zero && c.form == goal.form;
    (constant || given.iter().any(same)).then(|| given.iter().map(|c| whole(same(c))).collect())
}
