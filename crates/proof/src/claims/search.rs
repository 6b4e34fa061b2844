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

use std::collections::{BTreeSet, VecDeque};
use std::{fmt, mem};

use num_traits::Zero;

use super::automaton::Automaton;
use super::bounds::extreme;
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, Premises, Sign, point_within};
use cordon_core::simplex::Work;
use cordon_core::system::{Parameter, ParameterKind, System, inequalities};

/// Most bits of a number in an invariant: certificates take longer ones, but not in such numbers.
const LONGEST: u64 = 2_000;

/// Links from what a goal speaks of to what is near it: 0, 1, and so on; then everything counts.
const NEAR: usize = 3;

/// Most half-spaces from all of which something is shown: a program with more, whose answer is mostly
/// that it does not follow, is work without use, where the near ones did not show it.
const MANY: usize = 300;

/// Most variables of a half-space that makes them near each other.
const FEW: usize = 4;

/// Most ranges that a half-space may depend on: each has two ends, and all combinations are looked at.
const MOST_CHOICES: usize = 12;

/// How far to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Last step of a counterexample.
    pub steps: usize,
    /// Most half-spaces of an invariant beside the claims and what is assumed of the start.
    pub half_spaces: usize,
    /// Most work in linear programs, in the unit of [`Work`].
    pub work: u64,
}

/// What ended a search that decided nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The limit of steps.
    Steps,
    /// The limit of half-spaces.
    HalfSpaces,
    /// The limit of work.
    Work,
    /// Numbers longer than a certificate may have.
    Digits,
    /// A half-space that depends on too many ranges.
    Choices,
    /// A claim that fails where constants differ from step to step; it may hold where they do not.
    Varying,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Steps => "the invariant needs more steps than the search goes back",
            Self::HalfSpaces => "the invariant needs more half-spaces than the search allows",
            Self::Work => "the linear programs take more work than the search allows",
            Self::Digits => "the invariant needs longer numbers than a certificate may have",
            Self::Choices => "a claim depends on more choices in a step than the search combines",
            Self::Varying => {
                "a claim fails where a constant takes another value in each step, which is how ranges \
                 are proved"
            }
        })
    }
}

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

/// Puts a combination of others in the place of a premise.
fn replace(multipliers: &mut Vec<(usize, Rational)>, row: usize, others: &[(usize, Rational)]) {
    let Some(at) = multipliers.iter().position(|(j, _)| *j == row) else { return };
    let (_, factor) = multipliers.swap_remove(at);
    for (j, m) in others {
        match multipliers.iter_mut().find(|(known, _)| known == j) {
            Some((_, sum)) => *sum += &factor * m,
            None => multipliers.push((*j, &factor * m)),
        }
    }
    multipliers.retain(|(_, m)| !m.is_zero());
    multipliers.sort_by_key(|(j, _)| *j);
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

    /// Leaves out rows that follow from others of their moment: what was shown with their help is shown
    /// with the help of those. The longest way from a claim goes first: there numbers are longest.
    fn minimise(&mut self) {
        let mut gone = vec![false; self.rows.len()];
        for j in (0..self.rows.len()).rev() {
            let Some(row) = self.rows.get(j).filter(|r| r.claim.is_none()) else { continue };
            if let Some(slot) = gone.get_mut(j) {
                *slot = true;
            }
            let Some(others) = self.follows(&row.is, row.moment, Some(&gone)) else {
                if let Some(slot) = gone.get_mut(j) {
                    *slot = false;
                }
                continue;
            };
            for kept in &mut self.kept {
                replace(&mut kept.multipliers, j, &others);
            }
        }
        let mut base = vec![None; self.rows.len()];
        for (j, multipliers) in mem::take(&mut self.base) {
            if let Some(slot) = base.get_mut(j) {
                *slot = Some(multipliers);
            }
        }
        let kept = vec![mem::take(&mut self.kept)];
        self.retain(&gone, base, kept);
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
        let (constant, coefficients) = form.parts()?;
        let short = |x: &Rational| x.numer().bits().max(x.denom().bits()) <= LONGEST;
        let all_short = short(constant) && coefficients.iter().all(short);
        all_short.then_some(Constraint { form, sign: *sign })
    }

    /// Multipliers that show a half-space to follow from the rows of a moment, but for `without`.
    fn follows(
        &self,
        goal: &Constraint,
        moment: usize,
        without: Option<&[bool]>,
    ) -> Option<Vec<(usize, Rational)>> {
        let known = |j: &usize| {
            self.rows[*j].moment == moment && without.is_none_or(|gone| gone.get(*j) != Some(&true))
        };
        let places: Vec<usize> = (0..self.rows.len()).filter(known).collect();
        // The row itself, or a weaker copy of it, is the commonest reason.
        let same = |&&j: &&usize| {
            let c = &self.rows[j].is;
            c.form == goal.form && (c.sign == goal.sign || c.sign == Sign::Positive)
        };
        if let Some(&j) = places.iter().find(same) {
            return Some(vec![(j, Rational::from_integer(1.into()))]);
        }
        let given: Vec<Constraint> = places.iter().map(|&j| self.rows[j].is.clone()).collect();
        let found = self.near_first(&given, goal, given.len() <= MANY)?;
        Some(found.into_iter().filter_map(|(at, m)| Some((*places.get(at)?, m))).collect())
    }

    /// Multipliers of what is given, by place: first of what speaks of nothing else than the goal does,
    /// a small program; then of what speaks of what is near that too, some links on; then, if `all` may
    /// count, of all.
    fn near_first(
        &self,
        given: &[Constraint],
        goal: &Constraint,
        all: bool,
    ) -> Option<Vec<(usize, Rational)>> {
        let speaks_of = |c: &Constraint| {
            let coefficients = c.form.parts().map_or(&[][..], |(_, c)| c);
            let nonzero = coefficients.iter().enumerate().filter(|(_, c)| !c.is_zero());
            nonzero.map(|(j, _)| j).collect::<Vec<usize>>()
        };
        let about: Vec<Vec<usize>> = given.iter().map(speaks_of).collect();
        let mut near: BTreeSet<usize> = speaks_of(goal).into_iter().collect();
        let mut tried = usize::MAX;
        for links in 0..=NEAR {
            let is_near = |j: &usize| {
                (all && links == NEAR)
                    || about.get(*j).is_some_and(|a| a.iter().all(|v| near.contains(v)))
            };
            let places: Vec<usize> = (0..given.len()).filter(is_near).collect();
            if places.len() != tried {
                tried = places.len();
                let some: Vec<Constraint> =
                    places.iter().filter_map(|&j| given.get(j).cloned()).collect();
                let premises = Premises::new(&some)?;
                if let Some(multipliers) = premises.multipliers_within(goal, &self.work) {
                    let found = places.into_iter().zip(multipliers);
                    return Some(found.filter(|(_, m)| !m.is_zero()).collect());
                }
            }
            let touches = |a: &&Vec<usize>| a.len() <= FEW && a.iter().any(|v| near.contains(v));
            let more: Vec<usize> = about.iter().filter(touches).flatten().copied().collect();
            near.extend(more);
        }
        None
    }

    /// Multipliers of the assumptions that show a row to hold of every start.
    fn holds_of_start(&self, row: usize) -> Option<Vec<(usize, Rational)>> {
        self.near_first(&self.starts, &self.rows.get(row)?.is, true)
    }

    /// What a row comes to that was not shown of every start.
    fn fails(&self, row: usize, depth: usize, may_refute: bool) -> Answer {
        let found = if may_refute { self.refuted(row) } else { None };
        let end = if self.work.left() == 0 { End::Work } else { End::Varying };
        found.unwrap_or(Answer::Open(depth, end))
    }

    /// The counterexample that a row is which fails of some start.
    fn refuted(&self, row: usize) -> Option<Answer> {
        let found = self.rows.get(row)?;
        let start = self.violating(&found.is)?;
        let mut choices = Vec::new();
        let mut at = &found.leads_to;
        while let Some((row, edge, corner)) = at {
            let mode = self.automaton.edges.get(*edge)?.mode;
            choices.push(Choice { mode, values: self.values(corner) });
            at = &self.rows.get(*row)?.leads_to;
        }
        Some(Answer::Refuted(start, choices))
    }

    /// The largest set of assumptions and claims that holds of the start and that every step keeps.
    fn kept_from_the_beginning(&mut self) -> Option<()> {
        let assumed: Vec<Constraint> = self.starts.iter().flat_map(inequalities).collect();
        for moment in 0..self.automaton.names.len() {
            let claims = self.automaton.claims[moment].iter();
            let claims = claims.filter_map(|&j| self.system.claims.get(j));
            let claimed = claims.flat_map(|c| inequalities(&c.predicate.is)).collect::<Vec<_>>();
            for is in claimed.into_iter().chain(assumed.clone()) {
                if !self.rows.iter().any(|r| r.moment == moment && r.is == is) {
                    let row = Row { is, moment, claim: None, depth: 0, leads_to: None };
                    self.rows.push(row);
                }
            }
        }
        let mut gone = vec![false; self.rows.len()];
        let mut base: Vec<Option<Vec<(usize, Rational)>>> = vec![None; self.rows.len()];
        for j in 0..self.rows.len() {
            if self.rows[j].moment == 0 {
                base[j] = self.holds_of_start(j);
                gone[j] = base[j].is_none();
            }
        }
        let mut kept: Vec<Vec<Kept>>;
        loop {
            kept = vec![Vec::new(); self.rows.len()];
            let mut dropped = false;
            for j in 0..self.rows.len() {
                if !gone[j] {
                    match self.keeps(j, &gone) {
                        Some(proofs) => kept[j] = proofs,
                        None => (gone[j], dropped) = (true, true),
                    }
                }
                if self.work.left() == 0 {
                    return None;
                }
            }
            if !dropped {
                break;
            }
        }
        self.retain(&gone, base, kept);
        Some(())
    }

    /// The proofs that every step to a row's moment keeps the row.
    fn keeps(&self, row: usize, gone: &[bool]) -> Option<Vec<Kept>> {
        let edges: Vec<(usize, usize, usize)> = self
            .automaton
            .into(self.rows[row].moment)
            .map(|(e, edge)| (e, edge.from, edge.mode))
            .collect();
        let mut proofs = Vec::new();
        for (edge, from, mode) in edges {
            for corner in self.corners(row, mode)? {
                let image = self.pre_image(row, mode, &corner)?;
                let multipliers = self.follows(&image, from, Some(gone))?;
                proofs.push(Kept { row, edge, corner, multipliers });
            }
        }
        Some(proofs)
    }

    /// Drops the rows that are gone, and renumbers the others.
    fn retain(
        &mut self,
        gone: &[bool],
        base: Vec<Option<Vec<(usize, Rational)>>>,
        kept: Vec<Vec<Kept>>,
    ) {
        let mut index = vec![usize::MAX; gone.len()];
        let mut rows = Vec::new();
        for (j, row) in self.rows.drain(..).enumerate() {
            if gone.get(j) == Some(&false) {
                index[j] = rows.len();
                rows.push(row);
            }
        }
        self.rows = rows;
        let at = |j: usize| index.get(j).copied().unwrap_or(usize::MAX);
        for (j, multipliers) in base.into_iter().enumerate() {
            if let (Some(m), false) = (multipliers, at(j) == usize::MAX) {
                self.base.push((at(j), m));
            }
        }
        for proof in kept.into_iter().flatten().filter(|k| at(k.row) != usize::MAX) {
            let multipliers = proof.multipliers.into_iter().map(|(j, m)| (at(j), m)).collect();
            self.kept.push(Kept { row: at(proof.row), multipliers, ..proof });
        }
    }

    /// A start that meets the assumptions and of which the half-space fails.
    fn violating(&self, is: &Constraint) -> Option<Vec<Rational>> {
        // The negation of form > 0 is -form >= 0, and of form >= 0 it is -form > 0.
        let form = Affine::constant(Rational::zero()) - &is.form;
        let with = |sign| {
            let last = Constraint { form: form.clone(), sign };
            let all: Vec<Constraint> = self.starts.iter().cloned().chain([last]).collect();
            point_within(self.system.state.len(), &all, &self.work)
        };
        // A corner of the start set first: its numbers are short. Then a real violation anywhere, then one that
        // only touches the bound.
        let corner = extreme(&form, &self.starts, self.system.state.len(), &self.work);
        let fails = |x: &Vec<Rational>| is.form.at(x).is_some_and(|value| !is.sign.met_by(&value));
        let is_start = |x: &Vec<Rational>| {
            self.starts.iter().all(|c| c.form.at(x).is_some_and(|value| c.sign.met_by(&value)))
        };
        if let Some(corner) = corner.filter(|x| fails(x) && is_start(x)) {
            return Some(corner);
        }
        with(Sign::Positive)
            .or_else(|| (is.sign == Sign::Positive).then(|| with(Sign::NonNegative)).flatten())
    }
}
