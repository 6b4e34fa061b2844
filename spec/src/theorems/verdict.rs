//! Three-valued answers: some scalars (intervals, overflowed fractions) cannot always tell.

use core::cmp::Ordering;

use crate::Ordered;

/// Whether something is so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    pub fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::False, _) | (_, Self::False) => Self::False,
            (Self::True, Self::True) => Self::True,
            _ => Self::Unknown,
        }
    }

    /// Whether the answer is a certain yes.
    pub fn is_true(self) -> bool {
        self == Self::True
    }

    /// Conjunction of many.
    pub fn all(answers: impl IntoIterator<Item = Self>) -> Self {
        answers.into_iter().fold(Self::True, Self::and)
    }
}

impl From<bool> for Truth {
    fn from(b: bool) -> Self {
        if b { Self::True } else { Self::False }
    }
}

/// Whether `a < b`.
pub(super) fn less<S: Ordered>(a: &S, b: &S) -> Truth {
    order(a, b, |o| o == Ordering::Less)
}

/// Whether `a <= b`.
pub(super) fn at_most<S: Ordered>(a: &S, b: &S) -> Truth {
    order(a, b, |o| o != Ordering::Greater)
}

/// Whether `a = b`.
pub(super) fn equal<S: Ordered>(a: &S, b: &S) -> Truth {
    order(a, b, |o| o == Ordering::Equal)
}

fn order<S: Ordered>(a: &S, b: &S, wanted: impl Fn(Ordering) -> bool) -> Truth {
    a.compare(b).map_or(Truth::Unknown, |o| wanted(o).into())
}

/// What a violated conclusion is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Violation {
    /// Placement in the run, counted from its first: 0 for X^k, 1 for X^{k+1}.
    pub step: usize,
    /// What fails there.
    pub subject: Subject,
}

/// Whether a conclusion holds of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    pub(super) fn for_all(answers: impl IntoIterator<Item = (Truth, Violation)>) -> Self {
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
    pub(super) fn one(truth: Truth, step: usize, subject: Subject) -> Self {
        Self::for_all([(truth, Violation { step, subject })])
    }

    /// The verdict of an implication: `conclusion` counts only where `premise` holds.
    pub(super) fn given(premise: Truth, conclusion: impl FnOnce() -> Self) -> Self {
        match premise {
            Truth::True => conclusion(),
            Truth::False => Self::Vacuous,
            Truth::Unknown => Self::Undecided,
        }
    }
}
