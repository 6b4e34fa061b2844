//! Whether the claims about a system hold: backwards from the claims.
//!
//! A claim holds in all runs if and only if all its pre-images hold of the start: what the claim's
//! form becomes of the state one step before, two steps before, and so on, whichever mode acts and at
//! every corner of the parameters' ranges (a form affine in each parameter is least at a corner). The
//! search goes through the pre-images by depth. One that follows from what is known already, by
//! multipliers from an exact linear program, need not be followed further. When none is left, what was
//! collected is an invariant that implies the claims (Gilbert and Tan 1991, Linear systems with state and control
//! constraints: complete for stable systems with bounded claims). When one fails of some start, that
//! start's run is a counterexample, and no shorter one exists.
//!
//! What is assumed of the start may be kept as well. The largest set of assumptions and claims that
//! every step keeps (Houdini) is known from the beginning.

mod failure;
mod fewer;
mod kept;
mod limits;
mod reasons;

pub use limits::{End, Limits};

use std::collections::VecDeque;
use std::mem;

use super::automaton::Automaton;
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::Constraint;
use cordon_core::simplex::Work;
use cordon_core::system::{Parameter, ParameterKind, System, inequalities};

/// Most bits of a number in an invariant: certificates take longer ones, but not in such numbers.
const LONGEST: u64 = 2_000;

/// Most ranges that a half-space may depend on: each has two ends, and all combinations are looked at.
const MOST_CHOICES: usize = 12;

/// Values of some parameters, by their places.
pub type Corner = Vec<(usize, Rational)>;

/// A half-space that holds whenever its moment comes.
#[derive(Clone, Debug)]
pub struct Row {
    /// What holds.
    pub is: Constraint,
    /// When.
    pub moment: usize,
    /// The claim that it says, if it is one.
    pub claim: Option<usize>,
    /// Steps to the claim that it is a pre-image of.
    depth: usize,
    /// The step to the row that it is a pre-image of: the row, the edge and the corner.
    leads_to: Option<(usize, usize, Corner)>,
}

/// That a row's image after a step follows from the rows before it.
#[derive(Clone, Debug)]
pub struct Kept {
    /// The row.
    pub row: usize,
    /// The step.
    pub edge: usize,
    /// The parameters that play a part, with the end of the range of each.
    pub corner: Corner,
    /// Rows before, with their multipliers.
    pub multipliers: Vec<(usize, Rational)>,
}

/// An invariant that implies the claims, with all multipliers.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The half-spaces, those of the claims among them.
    pub rows: Vec<Row>,
    /// Of each row at the start, the multipliers of the assumptions.
    pub base: Vec<(usize, Vec<(usize, Rational)>)>,
    /// The steps.
    pub kept: Vec<Kept>,
}

/// A step of a run: the mode, and the values of the parameters that vary.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The mode.
    pub mode: usize,
    /// Values of all parameters.
    pub values: Vec<Rational>,
}

/// What the search found.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The claims hold in every run.
    Proved(Proof),
    /// A claim fails: the start, and how the run goes on.
    Refuted(Vec<Rational>, Vec<Choice>),
    /// No claim fails up to that step, from any start, whatever is chosen; the rest is open, by what
    /// ended the search.
    Open(usize, End),
}

/// Whether the numbers of a form are as short as those of an invariant have to be.
pub fn is_short(form: &Affine) -> bool {
    let short = |x: &Rational| x.numer().bits().max(x.denom().bits()) <= LONGEST;
    form.parts()
        .is_some_and(|(constant, coefficients)| short(constant) && coefficients.iter().all(short))
}

/// The search under way.
pub struct Search<'s> {
    system: &'s System,
    automaton: &'s Automaton,
    /// The parameters, each with the range that it has here.
    parameters: Vec<Parameter>,
    starts: Vec<Constraint>,
    rows: Vec<Row>,
    kept: Vec<Kept>,
    base: Vec<(usize, Vec<(usize, Rational)>)>,
    work: Work,
    limits: Limits,
}

impl<'s> Search<'s> {
    /// The search for a system whose parameters have these ranges, so far and no further; `starts` are
    /// what is assumed.
    pub fn new(
        system: &'s System,
        automaton: &'s Automaton,
        parameters: Vec<Parameter>,
        starts: Vec<Constraint>,
        limits: &Limits,
    ) -> Self {
        Self {
            system,
            automaton,
            parameters,
            starts,
            rows: Vec::new(),
            kept: Vec::new(),
            base: Vec::new(),
            work: Work::limited(limits.work),
            limits: *limits,
        }
    }

    /// Searches. Where a constant has a range, it is taken to vary: what is proved holds all the same;
    /// what fails is reported as open.
    pub fn run(&mut self) -> Answer {
        let constant = |p: &Parameter| p.kind == ParameterKind::Constant && p.fixed().is_none();
        let may_refute = !self.parameters.iter().any(constant);
        // Half of the work at most: without that set the search may still succeed.
        let half = self.limits.work / 2;
        self.work = Work::limited(half);
        if self.kept_from_the_beginning().is_none() {
            self.rows.clear();
        }
        self.work = Work::limited(self.limits.work - half + self.work.left());
        let mut queue: VecDeque<usize> = VecDeque::new();
        for moment in 0..self.automaton.names.len() {
            for &claim in &self.automaton.claims[moment] {
                let Some(c) = self.system.claims.get(claim) else { continue };
                for is in inequalities(&c.predicate.is) {
                    if let Some(row) =
                        self.rows.iter_mut().find(|r| r.moment == moment && r.is == is)
                    {
                        row.claim = row.claim.or(Some(claim));
                        continue;
                    }
                    let row = Row { is, moment, claim: Some(claim), depth: 0, leads_to: None };
                    queue.push_back(self.rows.len());
                    self.rows.push(row);
                }
            }
        }
        // Claims about the first moments are refuted by the start alone.
        for j in queue.clone() {
            if self.rows[j].moment == 0 {
                match self.holds_of_start(j) {
                    Some(multipliers) => self.base.push((j, multipliers)),
                    None => {
                        return self.fails(j, 0, may_refute);
                    }
                }
            }
        }
        let first = self.rows.len();
        while let Some(j) = queue.pop_front() {
            let depth = self.rows[j].depth;
            if depth >= self.limits.steps {
                return Answer::Open(depth, End::Steps);
            }
            let edges: Vec<(usize, usize, usize)> = self
                .automaton
                .into(self.rows[j].moment)
                .map(|(e, edge)| (e, edge.from, edge.mode))
                .collect();
            for (edge, from, mode) in edges {
                let Some(corners) = self.corners(j, mode) else {
                    return Answer::Open(depth, End::Choices);
                };
                for corner in corners {
                    let Some(is) = self.pre_image(j, mode, &corner) else {
                        return Answer::Open(depth, End::Digits);
                    };
                    if let Some(multipliers) = self.follows(&is, from, None) {
                        self.kept.push(Kept { row: j, edge, corner, multipliers });
                        continue;
                    }
                    let new = self.rows.len();
                    if new - first >= self.limits.half_spaces {
                        return Answer::Open(depth, End::HalfSpaces);
                    }
                    if self.work.left() == 0 {
                        return Answer::Open(depth, End::Work);
                    }
                    self.rows.push(Row {
                        is,
                        moment: from,
                        claim: None,
                        depth: depth + 1,
                        leads_to: Some((j, edge, corner.clone())),
                    });
                    if from == 0 {
                        match self.holds_of_start(new) {
                            Some(multipliers) => self.base.push((new, multipliers)),
                            None => return self.fails(new, depth, may_refute),
                        }
                    }
                    let multipliers = vec![(new, Rational::from_integer(1.into()))];
                    self.kept.push(Kept { row: j, edge, corner, multipliers });
                    queue.push_back(new);
                }
            }
        }
        // Of the proof's work a part at most: rows too many do no harm.
        let most = self.limits.work / 4;
        let spare = self.work.left().saturating_sub(most);
        self.work = Work::limited(self.work.left().min(most));
        self.minimise();
        self.work = Work::limited(self.work.left() + spare);
        Answer::Proved(Proof {
            rows: mem::take(&mut self.rows),
            base: mem::take(&mut self.base),
            kept: mem::take(&mut self.kept),
        })
    }

    /// The work that is left.
    pub fn left(&self) -> u64 {
        self.work.left()
    }

    /// The corners of the ranges of the parameters that play a part in a row's image.
    /// None where there are more than 2^[`MOST_CHOICES`].
    fn corners(&self, row: usize, mode: usize) -> Option<Vec<Corner>> {
        let coefficients = self.rows[row].is.form.parts().map_or(&[][..], |(_, c)| c);
        let mode = self.system.modes.get(mode)?;
        let mut corners = vec![Vec::new()];
        // In the order in which certificates list corners: by name, the last one changing fastest.
        let mut parameters = mode.parameters_in(coefficients);
        parameters.sort_by_key(|&p| self.parameters.get(p).map(|p| p.name.as_str()));
        let has_ends = |&&p: &&usize| self.parameters.get(p).is_some_and(|p| p.fixed().is_none());
        if parameters.iter().filter(has_ends).count() > MOST_CHOICES {
            return None;
        }
        for p in parameters {
            let ends = self.parameters.get(p).map(Parameter::ends).unwrap_or_default();
            corners = corners
                .into_iter()
                .flat_map(|corner: Corner| {
                    ends.iter().map(move |end| {
                        let mut corner = corner.clone();
                        corner.push((p, end.clone()));
                        corner
                    })
                })
                .collect();
        }
        Some(corners)
    }

    /// The values of all parameters at a corner; those that play no part at their least.
    fn values(&self, corner: &[(usize, Rational)]) -> Vec<Rational> {
        let mut values: Vec<Rational> = self.parameters.iter().map(|p| p.low.clone()).collect();
        for (p, value) in corner {
            if let Some(slot) = values.get_mut(*p) {
                *slot = value.clone();
            }
        }
        values
    }

    fn pre_image(
        &self,
        row: usize,
        mode: usize,
        corner: &[(usize, Rational)],
    ) -> Option<Constraint> {
        let map = self.system.modes.get(mode)?.at(&self.values(corner));
        let Constraint { form, sign } = &self.rows[row].is;
        let form = map.pulled_back(form)?;
        is_short(&form).then_some(Constraint { form, sign: *sign })
    }
}
