//! That 1/2 is exact: for every larger weight a start that violates the conclusion at step 1.
//!
//! The starts are the extreme ones. Against 7.2 (N >= 4): all gaps (2 eps - 1)/2 but gap 1,
//! which is 2 eps, so that the drones around it overtake each other. Against 7.3 (N >= 3): all
//! drones at their targets but drone 1, which overshoots.

use cordon_spec::coverage::exec_coverage;
use cordon_spec::placement::error_at;
use cordon_spec::theorems::Theorem;
use cordon_spec::{Params, State};
use num_traits::One;
use serde_json::{Value, json};

use super::certificate::{discharges, sealed, terms};
use super::search::{self, Effort, terms_of};
use super::symbols::{Goal, Sign, constant, fact, int, named, substitute};
use cordon_core::Rational;
use cordon_core::scalar::Polynomial;

/// A start for every N and every weight above 1/2.
struct Start {
    theorem: Theorem,
    drones_from: usize,
    max: Polynomial,
    head: Vec<Polynomial>,
    tail: Polynomial,
}

impl Start {
    fn against(theorem: Theorem) -> Option<Self> {
        let half = constant(&Rational::new(One::one(), 2.into()));
        match theorem {
            Theorem::Ordering => {
                let small = named("eps") - &half;
                let wide = int(2) * &named("eps");
                let tail = small.clone() + &wide + &((named("i") - &int(2)) * &small);
                let max = substitute(&tail, &[(named("i"), named("last"))]);
                Some(Self { theorem, drones_from: 4, max, head: vec![int(0), small], tail })
            }
            Theorem::UpperBound => Some(Self {
                theorem,
                drones_from: 3,
                max: named("last"),
                head: vec![int(0), int(0)],
                tail: named("i"),
            }),
            _ => None,
        }
    }

    fn behind(&self, i: &Polynomial) -> Polynomial {
        substitute(&self.tail, &[(named("i"), i.clone())])
    }

    fn x(&self, j: usize) -> Polynomial {
        self.head.get(j).cloned().unwrap_or_else(|| self.behind(&int(j as i32)))
    }

    fn goals(&self) -> Vec<Goal> {
        let (i, last, head) = (named("i"), named("last"), self.head.len());
        let least = self.drones_from as i32 - 1;
        let half = constant(&Rational::new(One::one(), 2.into()));
        let known = vec![
            fact("eps-above", named("eps") - &half, Sign::Positive),
            fact(format!("last-{least}"), last.clone() - &int(least), Sign::NonNegative),
        ];
        let later = |reach: i32| {
            let mut facts = known.clone();
            let from = i.clone() - &int(head as i32);
            facts.push(fact(format!("i-{head}"), from, Sign::NonNegative));
            let room = last.clone() - &i - &int(reach);
            facts.push(fact(format!("last-i-{reach}"), room, Sign::NonNegative));
            facts
        };
        let error = |i: &Polynomial, x: &Polynomial| error_at(&int(0), &self.max, &last, i, x);
        let goal = |name: &str, facts: &[_], poly, sign| Goal {
            name: name.to_owned(),
            facts: facts.to_vec(),
            poly,
            sign,
        };
        let mut goals = vec![
            goal("anchored/first", &known, self.x(0), Sign::Zero),
            goal("anchored/last", &known, self.behind(&last) - &self.max, Sign::Zero),
            goal("segment", &known, self.max.clone(), Sign::Positive),
        ];
        let ordering = self.theorem == Theorem::Ordering;
        for j in 0..head {
            let (poly, sign) = if ordering {
                (self.x(j + 1) - &self.x(j), Sign::Positive)
            } else {
                (error(&int(j as i32), &self.x(j)), Sign::NonNegative)
            };
            goals.push(goal(&format!("start/{j}"), &known, poly, sign));
        }
        goals.push(if ordering {
            let gap = self.behind(&(i.clone() + &int(1))) - &self.tail;
            goal("start/later", &later(1), gap, Sign::Positive)
        } else {
            goal("start/later", &later(0), error(&i, &self.tail), Sign::NonNegative)
        });
        let mut drones: Vec<Polynomial> =
            (0..=if ordering { 3 } else { 2 }).map(|j| self.x(j)).collect();
        drones.push(self.max.clone());
        let p = Params { min: int(0), max: self.max.clone(), eps: named("eps"), n: 0 };
        let next = exec_coverage(&p, &State { drones, timesteps: 0 }).drones;
        let (poly, sign) = if ordering {
            (next[1].clone() - &next[2], Sign::NonNegative)
        } else {
            (int(0) - &error(&int(1), &next[1]), Sign::Positive)
        };
        goals.push(goal("violation", &known, poly, sign));
        goals
    }
}

/// The certificate that 1/2 is exact for 7.2 or 7.3, if the start above is accepted by the search.
pub fn prove(theorem: Theorem, effort: Effort) -> Option<Value> {
    let start = Start::against(theorem)?;
    let mut proofs = Vec::new();
    for goal in start.goals() {
        let proof = search::prove(&goal, effort)?;
        proofs.push((goal.name, proof));
    }
    let subject =
        if theorem == Theorem::Ordering { json!({ "pair": 1 }) } else { json!({ "drone": 1 }) };
    let polynomial = |p: &Polynomial| terms(&terms_of(p));
    let head: Vec<Value> = start.head.iter().map(polynomial).collect();
    Some(sealed(
        "exactness",
        json!({
            "theorem": theorem.number(),
            "drones_from": start.drones_from,
            "above": "1/2",
            "min": [],
            "max": polynomial(&start.max),
            "head": head,
            "tail": polynomial(&start.tail),
            "subject": subject,
            "proofs": discharges(&proofs),
        }),
    ))
}
