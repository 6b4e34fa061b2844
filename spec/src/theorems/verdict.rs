//! Three-valued answers: some scalars (intervals, overflowed fractions) cannot always tell.

use core::cmp::Ordering;

#[cfg(feature = "contracts")]
use creusot_std::prelude::{Clone, PartialEq};

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::Ordered;

/// Whether something is so.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(not(creusot), derive(Debug, Eq))]
#[cfg_attr(creusot, derive(DeepModel))]
pub enum Truth {
    /// It certainly is.
    True,
    /// It certainly is not.
    False,
    /// The scalars cannot tell.
    Unknown,
}

impl Truth {
    /// Conjunction: false as soon as one side is.
    #[cfg_attr(feature = "contracts", ensures(result == both(self, other)))]
    pub fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::False, _) | (_, Self::False) => Self::False,
            (Self::True, Self::True) => Self::True,
            _ => Self::Unknown,
        }
    }

    /// Whether the answer is a certain yes.
    #[cfg_attr(feature = "contracts", ensures(result == (self == Truth::True)))]
    pub fn is_true(self) -> bool {
        self == Self::True
    }

    /// Negation; what is unknown stays so.
    #[cfg_attr(feature = "contracts", ensures(result == match self { Truth::True => Truth::False, Truth::False => Truth::True, Truth::Unknown => Truth::Unknown }))]
    pub(super) fn negated(self) -> Self {
        match self {
            Self::True => Self::False,
            Self::False => Self::True,
            Self::Unknown => Self::Unknown,
        }
    }

    /// Conjunction of the answers about `0 .. count`.
    #[cfg_attr(feature = "contracts", requires(forall<i: usize> i@ < count@ ==> holds.precondition((i,))))]
    #[cfg_attr(feature = "contracts", ensures(conjunction(holds, count@, result)))]
    pub fn all(count: usize, holds: impl Fn(usize) -> Self) -> Self {
        let mut answer = Self::True;
        #[cfg_attr(creusot, invariant(conjunction(holds, produced.len(), answer)))]
        for i in 0..count {
            answer = answer.and(holds(i));
        }
        answer
    }

    /// Disjunction of the answers about `0 .. count`.
    #[cfg_attr(feature = "contracts", requires(forall<i: usize> i@ < count@ ==> holds.precondition((i,))))]
    #[cfg_attr(feature = "contracts", ensures(disjunction(holds, count@, result)))]
    pub(super) fn any(count: usize, holds: impl Fn(usize) -> Self) -> Self {
        let mut answer = Self::False;
        #[cfg_attr(creusot, invariant(disjunction(holds, produced.len(), answer) && answer != Truth::True))]
        for i in 0..count {
            match holds(i) {
                Self::True => return Self::True,
                Self::Unknown => answer = Self::Unknown,
                Self::False => {}
            }
        }
        answer
    }
}

impl From<bool> for Truth {
    #[cfg_attr(feature = "contracts", ensures(result == if b { Truth::True } else { Truth::False }))]
    fn from(b: bool) -> Self {
        if b { Self::True } else { Self::False }
    }
}

/// Whether `a < b`.
#[cfg_attr(feature = "contracts", ensures(says(result, a.model() < b.model())))]
pub(super) fn less<S: Ordered>(a: &S, b: &S) -> Truth {
    order(a, b, |o| o == Ordering::Less)
}

/// Whether `a <= b`.
#[cfg_attr(feature = "contracts", ensures(says(result, a.model() <= b.model())))]
pub(super) fn at_most<S: Ordered>(a: &S, b: &S) -> Truth {
    order(a, b, |o| o != Ordering::Greater)
}

/// Whether `a = b`.
#[cfg_attr(feature = "contracts", ensures(says(result, a.model() == b.model())))]
pub(super) fn equal<S: Ordered>(a: &S, b: &S) -> Truth {
    order(a, b, |o| o == Ordering::Equal)
}

#[cfg_attr(feature = "contracts", requires(forall<o> wanted.precondition((o,))))]
#[cfg_attr(feature = "contracts", ensures(result == Truth::Unknown || exists<yes: bool> wanted.postcondition((a.model().cmp_log(b.model()),), yes) && says(result, yes) && result != Truth::Unknown))]
fn order<S: Ordered>(a: &S, b: &S, wanted: impl Fn(Ordering) -> bool) -> Truth {
    a.compare(b).map_or(Truth::Unknown, |o| wanted(o).into())
}

/// What a violated conclusion is about.
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq, PartialOrd, Ord))]
pub enum Subject {
    /// Drones `i` and `i + 1`.
    Pair(usize),
    /// The position of drone `i`.
    Drone(usize),
    /// The sum of the positions.
    Sum,
    /// The sum of the squared errors.
    Energy,
}

/// Where a conclusion fails.
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq, PartialOrd, Ord))]
pub struct Violation {
    /// Placement in the run, counted from its first: 0 for X^k, 1 for X^{k+1}.
    pub step: usize,
    /// Which drones or which quantity of the placement fail.
    pub subject: Subject,
}

/// Whether a conclusion holds of a run.
#[derive(Clone, Copy)]
#[cfg_attr(not(creusot), derive(Debug, PartialEq, Eq))]
pub enum Verdict {
    /// It holds, and says something about this run.
    Holds,
    /// It is an implication whose premise this run does not meet.
    Vacuous,
    /// It fails, first at this place of the run.
    Violated(Violation),
    /// The scalars cannot tell, or the run is too short.
    Undecided,
}

impl Verdict {
    /// The verdict on the answers about `0 .. count`: `Violated` at the first certain no, else
    /// `Undecided` if some answer is unknown.
    #[cfg_attr(feature = "contracts", requires(forall<i: usize> i@ < count@ ==> holds.precondition((i,)) && at.precondition((i,))))]
    #[cfg_attr(feature = "contracts", ensures(verdict_of(holds, count@, result)))]
    pub(super) fn for_all(
        count: usize,
        holds: impl Fn(usize) -> Truth,
        at: impl Fn(usize) -> Violation,
    ) -> Self {
        let mut verdict = Self::Holds;
        #[cfg_attr(creusot, invariant(verdict_of(holds, produced.len(), verdict) && (verdict == Verdict::Holds || verdict == Verdict::Undecided)))]
        for i in 0..count {
            match holds(i) {
                Truth::True => {}
                Truth::False => return Self::Violated(at(i)),
                Truth::Unknown => verdict = Self::Undecided,
            }
        }
        verdict
    }

    /// The verdict of one answer.
    #[cfg_attr(feature = "contracts", ensures(result == match truth { Truth::True => Verdict::Holds, Truth::False => Verdict::Violated(Violation { step, subject }), Truth::Unknown => Verdict::Undecided }))]
    pub(super) fn one(truth: Truth, step: usize, subject: Subject) -> Self {
        match truth {
            Truth::True => Self::Holds,
            Truth::False => Self::Violated(Violation { step, subject }),
            Truth::Unknown => Self::Undecided,
        }
    }

    /// The verdict of an implication: `conclusion` counts only where `premise` holds.
    #[cfg_attr(feature = "contracts", requires(premise == Truth::True ==> conclusion.precondition(())))]
    #[cfg_attr(feature = "contracts", ensures(match premise { Truth::True => conclusion.postcondition_once((), result), Truth::False => result == Verdict::Vacuous, Truth::Unknown => result == Verdict::Undecided }))]
    pub(super) fn given(premise: Truth, conclusion: impl FnOnce() -> Self) -> Self {
        match premise {
            Truth::True => conclusion(),
            Truth::False => Self::Vacuous,
            Truth::Unknown => Self::Undecided,
        }
    }
}
