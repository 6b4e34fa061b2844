//! Three-valued answers: some scalars (intervals, overflowed fractions) cannot always tell.

use core::cmp::Ordering;

#[cfg(feature = "contracts")]
use creusot_std::prelude::{Clone, PartialEq};

#[cfg(feature = "contracts")]
use crate::model::*;

use crate::Ordered;
#[cfg(not(creusot))]
use core::iter::Iterator as IteratorSpec;

/// Whether something is so.
#[derive(Clone, Copy, PartialEq)]
#[cfg_attr(not(creusot), derive(Debug, Eq))]
#[cfg_attr(creusot, derive(DeepModel))]
pub enum Truth {
    /// It is.
    True,
    /// It is not.
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

    /// Conjunction of many.
    #[cfg_attr(feature = "contracts", requires(I::into_iter.precondition((answers,))))]
    #[cfg_attr(feature = "contracts", ensures(exists<it: I::IntoIter, given: Seq<Truth>> I::into_iter.postcondition((answers,), it) && all_of(it, given) && conjunction(given, result)))]
    pub fn all<I: IntoIterator<Item = Self, IntoIter: IteratorSpec>>(answers: I) -> Self {
        let mut answer = Self::True;
        #[cfg(creusot)]
        let mut seen = snapshot!(Seq::empty());
        #[cfg_attr(creusot, invariant(*seen == *produced && conjunction(*produced, answer)))]
        for truth in answers {
            #[cfg(creusot)]
            proof_assert!({
                one_answer_more(*seen, answer, truth);
                conjunction(*produced, both(answer, truth))
            });
            answer = answer.and(truth);
            #[cfg(creusot)]
            {
                seen = snapshot!(*produced);
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
    /// Drone `i`.
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
    /// What fails there.
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
    /// It fails.
    Violated(Violation),
    /// The scalars cannot tell, or the run is too short.
    Undecided,
}

impl Verdict {
    /// `Violated` at the first certain no, else `Undecided` if some answer is unknown.
    #[cfg_attr(feature = "contracts", trusted)] // promised, not proved
    #[cfg_attr(feature = "contracts", requires(I::into_iter.precondition((answers,))))]
    #[cfg_attr(feature = "contracts", ensures(exists<it: I::IntoIter, given: Seq<(Truth, Violation)>> I::into_iter.postcondition((answers,), it) && judged(it, given, result)))]
    pub(super) fn for_all<I: IntoIterator<Item = (Truth, Violation), IntoIter: IteratorSpec>>(
        answers: I,
    ) -> Self {
        let mut verdict = Self::Holds;
        for (truth, violation) in answers {
            match truth {
                Truth::True => {}
                Truth::False => return Self::Violated(violation),
                Truth::Unknown => verdict = Self::Undecided,
            }
        }
        verdict
    }

    /// The verdict of one answer.
    #[cfg_attr(feature = "contracts", ensures(result == match truth { Truth::True => Verdict::Holds, Truth::False => Verdict::Violated(Violation { step, subject }), Truth::Unknown => Verdict::Undecided }))]
    pub(super) fn one(truth: Truth, step: usize, subject: Subject) -> Self {
        Self::for_all([(truth, Violation { step, subject })])
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
