//! Symbolic execution of predicates: all the ways in which comparisons can turn out, as one
//! formula.
//!
//! A predicate of the spec branches on the order of scalars. Here it is run again and again
//! with the answers of one path prescribed and every later comparison left open; the spec's
//! three-valued logic then either decides the predicate on that path whatever the rest, or
//! names the next comparison to branch on, with three answers each. What results is a decision
//! diagram, shared and reduced, and its text is the formula.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::term::Term;
use crate::symbolic::{Oracle, Question};

/// A node of a [`Diagram`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Node {
    /// The predicate's answer.
    Answer(bool),
    /// Branch number so and so of the diagram.
    Branch(usize),
}

/// What follows from each answer to a question.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Branch {
    question: Question<Term>,
    less: Node,
    equal: Node,
    greater: Node,
}

/// A predicate as a decision diagram: equal parts shared, questions without influence dropped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagram {
    branches: Vec<Branch>,
    root: Node,
}

impl Diagram {
    /// The diagram of `predicate`, whose scalars compare through `oracle`. The predicate
    /// answers `None` where it cannot tell.
    ///
    /// On a path that answers every comparison and still leaves the predicate undecided (only
    /// impossible paths do, such as drone 0 away from its place) the diagram says `in_doubt`:
    /// the side that can only make a proof harder.
    pub fn explore(
        oracle: &Oracle<Term>,
        in_doubt: bool,
        predicate: impl Fn() -> Option<bool>,
    ) -> Self {
        let known = BTreeMap::new();
        let mut builder = Builder { oracle, in_doubt, predicate: &predicate, known };
        let root = builder.node(&mut Vec::new());
        let mut branches: Vec<_> = builder.known.into_iter().collect();
        branches.sort_by_key(|&(_, number)| number);
        Self { branches: branches.into_iter().map(|(branch, _)| branch).collect(), root }
    }

    /// The formula as SMT-LIB: definitions of shared parts, named `prefix` and a number, and a
    /// formula that refers to them.
    pub fn to_smt2(&self, prefix: &str) -> (Vec<String>, String) {
        let mut uses = vec![0usize; self.branches.len()];
        for branch in &self.branches {
            // A part that a branch's text repeats is not shared by that alone: see `text`.
            for child in distinct([branch.less, branch.equal, branch.greater]) {
                if let Node::Branch(b) = child {
                    uses[b] += 1;
                }
            }
        }
        let mut texts: Vec<String> = Vec::with_capacity(self.branches.len());
        let mut definitions = Vec::new();
        // Children are numbered before their parents.
        for (number, branch) in self.branches.iter().enumerate() {
            let text = branch.text(&texts);
            if uses[number] > 1 {
                let name = format!("{prefix}{number}");
                definitions.push(format!("(define-fun {name} () Bool {text})"));
                texts.push(name);
            } else {
                texts.push(text);
            }
        }
        (definitions, node_text(self.root, &texts))
    }
}

fn distinct(children: [Node; 3]) -> Vec<Node> {
    let mut children = children.to_vec();
    children.sort_unstable();
    children.dedup();
    children
}

fn node_text(node: Node, texts: &[String]) -> String {
    match node {
        Node::Answer(true) => "true".to_owned(),
        Node::Answer(false) => "false".to_owned(),
        Node::Branch(b) => texts[b].clone(),
    }
}

impl Branch {
    fn text(&self, texts: &[String]) -> String {
        let [a, b] = &self.question;
        let is = |relation: &str| format!("({relation} {a} {b})");
        let then = |condition: String, yes, no| if_then_else(condition, yes, no, texts);
        match (self.less, self.equal, self.greater) {
            (l, e, g) if l == e => then(is("<="), l, g),
            (l, e, g) if e == g => then(is("<"), l, e),
            (l, e, g) if l == g => then(is("="), e, l),
            (l, e, g) => {
                let rest = then(is("="), e, g);
                match l {
                    Node::Answer(true) => joined("or", &is("<"), &rest),
                    Node::Answer(false) => joined("and", &format!("(not {})", is("<")), &rest),
                    Node::Branch(_) => {
                        format!("(ite {} {} {rest})", is("<"), node_text(l, texts))
                    }
                }
            }
        }
    }
}

fn if_then_else(condition: String, yes: Node, no: Node, texts: &[String]) -> String {
    let text = |node| node_text(node, texts);
    match (yes, no) {
        (Node::Answer(true), Node::Answer(false)) => condition,
        (Node::Answer(false), Node::Answer(true)) => format!("(not {condition})"),
        (Node::Answer(true), no) => joined("or", &condition, &text(no)),
        (Node::Answer(false), no) => joined("and", &format!("(not {condition})"), &text(no)),
        (yes, Node::Answer(true)) => joined("or", &format!("(not {condition})"), &text(yes)),
        (yes, Node::Answer(false)) => joined("and", &condition, &text(yes)),
        (yes, no) => format!("(ite {condition} {} {})", text(yes), text(no)),
    }
}

/// `(op first rest)`, where `rest` joins the list if it is of the same operator.
fn joined(op: &str, first: &str, rest: &str) -> String {
    match rest.strip_prefix(&format!("({op} ")) {
        Some(arguments) => format!("({op} {first} {arguments}"),
        None => format!("({op} {first} {rest})"),
    }
}

struct Builder<'b, P> {
    oracle: &'b Oracle<Term>,
    in_doubt: bool,
    predicate: &'b P,
    known: BTreeMap<Branch, usize>,
}

impl<P: Fn() -> Option<bool>> Builder<'_, P> {
    fn node(&mut self, path: &mut Vec<(Question<Term>, Ordering)>) -> Node {
        let (known, open) = self.oracle.assuming(path, self.predicate);
        if let Some(answer) = known {
            return Node::Answer(answer);
        }
        let Some(question) = open.into_iter().next() else {
            return Node::Answer(self.in_doubt);
        };
        let mut follow = |answer| {
            path.push((question.clone(), answer));
            let node = self.node(path);
            path.pop();
            node
        };
        let (less, equal) = (follow(Ordering::Less), follow(Ordering::Equal));
        let greater = follow(Ordering::Greater);
        if less == equal && equal == greater {
            return less;
        }
        let next = self.known.len();
        let number = *self.known.entry(Branch { question, less, equal, greater }).or_insert(next);
        Node::Branch(number)
    }
}
