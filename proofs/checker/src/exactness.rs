//! Kind `exactness`: beyond a bound on eps the conclusion fails at step 1, for every N from
//! some N on and every such eps at once.

use cordon_spec::coverage::exec_coverage;
use cordon_spec::placement::error_at;
use cordon_spec::theorems::{Form, StartSet, Theorem};
use cordon_spec::{Params, Scalar, State};

use crate::claims::Refusal;
use crate::concrete::theorem_named;
use crate::format::{ExactnessCert, SubjectName, Term, polynomial};
use crate::model::named;
use crate::poly::{Poly, Var};
use crate::rules::Relation::{self, NonNegative, Positive, Zero};
use crate::rules::{Fact, Obligation};

/// Most explicit positions of a start. The theorems need 2.
const MAX_HEAD: usize = 8;

/// The start: explicit positions of the first drones, one formula in i for the others.
struct Start {
    min: Poly,
    max: Poly,
    head: Vec<Poly>,
    tail: Poly,
}

impl Start {
    fn read(cert: &ExactnessCert) -> Result<Self, String> {
        let parameters = ["eps", "last"].map(Var::Named);
        let fixed = |p: &[Term]| polynomial(p, &parameters);
        if cert.head.len() > MAX_HEAD {
            return Err(format!("{} explicit positions: at most {MAX_HEAD}", cert.head.len()));
        }
        Ok(Self {
            min: fixed(&cert.min)?,
            max: fixed(&cert.max)?,
            head: cert.head.iter().map(|p| fixed(p)).collect::<Result<_, _>>()?,
            tail: polynomial(&cert.tail, &["eps", "last", "i"].map(Var::Named))?,
        })
    }

    /// The position of a drone behind the explicit ones.
    fn behind(&self, i: &Poly) -> Poly {
        self.tail.substitute(|v| (v == Var::Named("i")).then(|| i.clone()))
    }

    /// The position of drone j.
    fn x(&self, j: usize) -> Poly {
        self.head.get(j).cloned().unwrap_or_else(|| self.behind(&Poly::from(j)))
    }

    /// N-1 times the error of drone `i` at position `x`.
    fn error(&self, i: &Poly, x: &Poly) -> Poly {
        error_at(&self.min, &self.max, &named("last"), i, x)
    }
}

/// What has to be proved: the start is in the theorem's (sharp) start set, its ends at min <
/// max, and its image under the spec's step violates the conclusion.
///
/// The start set is checked drone by drone on the explicit positions, and once for every drone
/// i from `head` on; drone N-1 is among those, and the subject is inner, for every N spoken of.
pub fn obligations(cert: &ExactnessCert) -> Result<Vec<Obligation>, Refusal> {
    let wrong = |reason: &str| Refusal::Wrong(reason.into());
    let theorem = theorem_named(&cert.theorem).ok_or_else(|| wrong("no such theorem"))?;
    let start = Start::read(cert).map_err(Refusal::Wrong)?;
    let (head, from) = (start.head.len(), cert.drones_from as usize);
    if !(3..=64).contains(&from) || head == 0 || head > from - 1 {
        return Err(wrong(
            "expected 3 <= drones_from <= 64 and 1 to drones_from - 1 explicit positions",
        ));
    }
    let (i, last, one) = (named("i"), named("last"), Poly::from_int(1));
    let above = named("eps") - &Poly::constant(cert.above.0.clone());
    let known = vec![
        Fact::new("eps-above", above, Positive),
        Fact::new(&format!("last-{}", from - 1), last.clone() - &Poly::from(from - 1), NonNegative),
    ];
    let later = |reach: i32| {
        let mut facts = known.clone();
        facts.push(Fact::new(&format!("i-{head}"), i.clone() - &Poly::from(head), NonNegative));
        let room = last.clone() - &i - &Poly::from_int(reach);
        facts.push(Fact::new(&format!("last-i-{reach}"), room, NonNegative));
        facts
    };
    let mut all = Vec::new();
    let mut push = |name: String, facts: Vec<Fact>, goal: Poly, relation: Relation| {
        all.push(Obligation { name, facts, goal, relation });
    };
    push("anchored/first".into(), known.clone(), start.x(0) - &start.min, Zero);
    push("anchored/last".into(), known.clone(), start.behind(&last) - &start.max, Zero);
    push("segment".into(), known.clone(), start.max.clone() - &start.min, Positive);
    let starts = theorem.hypothesis(Form::Sharp).starts;
    for j in 0..head {
        match starts {
            StartSet::Ordered => {
                push(format!("start/{j}"), known.clone(), start.x(j + 1) - &start.x(j), Positive);
            }
            StartSet::UpperBounded => {
                let error = start.error(&Poly::from(j), &start.x(j));
                push(format!("start/{j}"), known.clone(), error, NonNegative);
            }
            _ => return Err(wrong("no rule for this theorem's start set")),
        }
    }
    match starts {
        StartSet::Ordered => {
            let gap = start.behind(&(i.clone() + &one)) - &start.tail;
            push("start/later".into(), later(1), gap, Positive);
        }
        _ => push("start/later".into(), later(0), start.error(&i, &start.tail), NonNegative),
    }
    let (goal, relation) = violation(cert, theorem, &start)?;
    push("violation".into(), known.clone(), goal, relation);
    Ok(all)
}

/// The negation of the conclusion about the subject, at step 1.
fn violation(
    cert: &ExactnessCert,
    theorem: Theorem,
    start: &Start,
) -> Result<(Poly, Relation), Refusal> {
    let from = cert.drones_from as usize;
    let (j, width) = match (theorem, cert.subject) {
        (Theorem::Ordering, SubjectName::Pair(j)) => (j, 2),
        (Theorem::UpperBound, SubjectName::Drone(j)) => (j, 1),
        _ => return Err(Refusal::Wrong("no rule for this theorem and subject".into())),
    };
    if j < 1 || j.saturating_add(width) > from - 1 {
        return Err(Refusal::Wrong("the subject is not inner for every N".into()));
    }
    // Drones 0 .. j+width as they are, and one more behind them that nothing here reads.
    let mut drones: Vec<Poly> = (0..=j + width).map(|j| start.x(j)).collect();
    drones.push(start.max.clone());
    let params = Params { min: start.min.clone(), max: start.max.clone(), eps: named("eps"), n: 0 };
    let next = exec_coverage(&params, &State { drones, timesteps: 0 }).drones;
    Ok(match theorem {
        // Not X_j < X_{j+1}.
        Theorem::Ordering => (next[j].clone() - &next[j + 1], NonNegative),
        // Not (N-1) e_j >= 0.
        _ => (Poly::from_int(0) - &start.error(&Poly::from(j), &next[j]), Positive),
    })
}
