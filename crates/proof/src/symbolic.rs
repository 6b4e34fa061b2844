//! The spec's own predicates on expressions.
//!
//! Positions are expressions: affine forms in the start, or terms of a solver's language.
//! Whenever a predicate of the spec compares two of them, an [`Oracle`] answers: with what has
//! been assumed, or not at all. The spec's three-valued logic then says whether the assumptions
//! decide the predicate. So searches and exports state no theorem a second time: the
//! comparisons that a theorem makes are taken from the code.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};
use std::rc::Rc;

use cordon_spec::{Ordered, Scalar};

/// What positions can be.
pub(crate) trait Expression: Scalar + PartialEq {
    /// The order of two expressions, or what has to be known for it.
    fn compared(&self, other: &Self) -> Compared<Self>;
}

/// What comparing two expressions comes to.
pub(crate) enum Compared<E> {
    /// The order is the same for all values of the symbols.
    Known(Ordering),
    /// It is the answer to this question.
    Open(Question<E>),
    /// Nothing could be assumed of it.
    Unknowable,
}

/// How the first expression compares with the second.
pub(crate) type Question<E> = [E; 2];

/// Every answer to a question.
pub(crate) const ANSWERS: [Ordering; 3] = [Ordering::Less, Ordering::Equal, Ordering::Greater];

/// Who answers comparisons while a predicate runs.
#[derive(Debug)]
pub(crate) struct Oracle<E> {
    answers: RefCell<Vec<(Question<E>, Ordering)>>,
    /// Questions without an answer, in the order in which they were asked first.
    open: RefCell<Vec<Question<E>>>,
}

impl<E: Expression> Oracle<E> {
    /// An oracle that knows nothing yet.
    pub fn new() -> Rc<Self> {
        Rc::new(Self { answers: RefCell::default(), open: RefCell::default() })
    }

    /// The scalar with this expression that asks the oracle when it is compared.
    pub fn symbol(self: &Rc<Self>, expression: E) -> Symbol<E> {
        Symbol { expression, oracle: Some(Rc::clone(self)) }
    }

    /// The scalars of several placements.
    pub fn symbols(self: &Rc<Self>, placements: &[Vec<E>]) -> Vec<Vec<Symbol<E>>> {
        let symbols = |x: &Vec<E>| x.iter().map(|e| self.symbol(e.clone())).collect();
        placements.iter().map(symbols).collect()
    }

    /// What a predicate says if these answers are assumed, and the questions that it has asked
    /// besides, in order.
    pub fn assuming<V>(
        &self,
        answers: &[(Question<E>, Ordering)],
        predicate: impl FnOnce() -> V,
    ) -> (V, Vec<Question<E>>) {
        self.answers.replace(answers.to_vec());
        self.open.take();
        let verdict = predicate();
        (verdict, self.open.take())
    }

    fn ask(&self, question: Question<E>) -> Option<Ordering> {
        let [a, b] = &question;
        for ([p, q], order) in self.answers.borrow().iter() {
            if p == a && q == b {
                return Some(*order);
            }
            if p == b && q == a {
                return Some(order.reverse());
            }
        }
        let mut open = self.open.borrow_mut();
        if !open.contains(&question) {
            open.push(question);
        }
        None
    }
}

/// An expression with an oracle for comparisons that the expression alone does not decide: the
/// scalar on which the spec is executed. Constants need no oracle.
#[derive(Clone, Debug)]
pub(crate) struct Symbol<E> {
    /// What the number is, in terms of the start.
    pub expression: E,
    oracle: Option<Rc<Oracle<E>>>,
}

impl<E: Expression> Symbol<E> {
    /// An expression that compares with symbols only.
    pub fn constant(expression: E) -> Self {
        Self { expression, oracle: None }
    }

    fn combine(self, other: &Self, op: impl FnOnce(E, &E) -> E) -> Self {
        let expression = op(self.expression, &other.expression);
        Self { expression, oracle: self.oracle.or_else(|| other.oracle.clone()) }
    }
}

impl<E: Expression> Add<&Self> for Symbol<E> {
    type Output = Self;

    fn add(self, other: &Self) -> Self {
        self.combine(other, |a, b| a + b)
    }
}

impl<E: Expression> Sub<&Self> for Symbol<E> {
    type Output = Self;

    fn sub(self, other: &Self) -> Self {
        self.combine(other, |a, b| a - b)
    }
}

impl<E: Expression> Mul<&Self> for Symbol<E> {
    type Output = Self;

    fn mul(self, other: &Self) -> Self {
        self.combine(other, |a, b| a * b)
    }
}

impl<E: Expression> Scalar for Symbol<E> {
    fn from_int(n: i32) -> Self {
        Self::constant(E::from_int(n))
    }
}

impl<E: Expression> Ordered for Symbol<E> {
    fn compare(&self, other: &Self) -> Option<Ordering> {
        match self.expression.compared(&other.expression) {
            Compared::Known(order) => Some(order),
            Compared::Open(question) => {
                self.oracle.as_ref().or(other.oracle.as_ref())?.ask(question)
            }
            Compared::Unknowable => None,
        }
    }
}
