//! Theorems that are implications or equivalences: every combination of answers to their comparisons
//! that some start can produce.

use std::cmp::Ordering;

use cordon_spec::theorems::{Setting, StartSet, Truth, Verdict};

use super::conjunction::{assumption, demands};
use super::region::Region;
use crate::symbolic::{ANSWERS, Oracle, Question, Symbol};
use cordon_core::Rational;
use cordon_core::linear::affine::Affine;
use cordon_core::linear::feasible::{Constraint, point};

/// Most combinations examined at one step: beyond that the search is incomplete.
const MOST_NODES: usize = 4_000;

/// A start of the set for which the conclusion is violated on the placements, and whether finding none
/// would be conclusive.
pub fn violation(
    set: StartSet,
    region: &Region,
    setting: &Setting<Symbol<Affine>>,
    placements: &[Vec<Affine>],
    conclusion: impl Fn(&[Vec<Symbol<Affine>>]) -> Verdict,
) -> (Option<Vec<Rational>>, bool) {
    let contains = |run: &[Vec<Symbol<Affine>>]| match run.first() {
        Some(x) => set.contains(setting, x),
        None => Truth::Unknown,
    };
    let start = [region.placement()];
    let Some(constraints) = demands(&start, contains, |t| *t == Truth::False) else {
        return (None, false);
    };
    let oracle = Oracle::new();
    let run = oracle.symbols(placements);
    let mut tree = Tree {
        variables: region.count.saturating_sub(2),
        oracle: &oracle,
        conclusion: || conclusion(&run),
        answers: Vec::new(),
        constraints,
        nodes: 0,
        complete: true,
    };
    let found = tree.explore();
    (found, tree.complete)
}

struct Tree<'o, C> {
    variables: usize,
    oracle: &'o Oracle<Affine>,
    conclusion: C,
    answers: Vec<(Question<Affine>, Ordering)>,
    constraints: Vec<Constraint>,
    nodes: usize,
    complete: bool,
}

impl<C: Fn() -> Verdict> Tree<'_, C> {
    fn explore(&mut self) -> Option<Vec<Rational>> {
        self.nodes += 1;
        if self.nodes > MOST_NODES {
            self.complete = false;
            return None;
        }
        let (verdict, open) = self.oracle.assuming(&self.answers, &self.conclusion);
        match verdict {
            Verdict::Holds | Verdict::Vacuous => return None,
            Verdict::Violated(_) => return point(self.variables, &self.constraints),
            Verdict::Undecided => {}
        }
        // The next comparison, unless no open one is left.
        let Some(question) = open.into_iter().next() else {
            self.complete = false;
            return None;
        };
        for answer in ANSWERS {
            self.constraints.push(assumption(&question, answer));
            self.answers.push((question.clone(), answer));
            let found = if point(self.variables, &self.constraints).is_some() {
                self.explore()
            } else {
                None
            };
            self.answers.pop();
            self.constraints.pop();
            if found.is_some() {
                return found;
            }
        }
        None
    }
}
