//! Solvers' answers, read back: the values of a model, and what they do when the spec runs them.

use cordon_spec::coverage::exec_coverage;
use cordon_spec::theorems::{Setting, Truth, Verdict};
use cordon_spec::{Params, State};
use num_traits::Zero;

use super::smt2::{Obligation, Query};
use cordon_core::{Error, Rational, Result, exact, violation};

/// What a solver said.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Response {
    /// There is no model: what was asked holds.
    Unsat,
    /// A model exists; its values if the solver gave them.
    Sat(Option<Model>),
    /// The solver gave up, with its words.
    Unknown(String),
}

/// Values of a query's symbols.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Model {
    /// Ends of the segment and weight, exact.
    pub params: Params<Rational>,
    /// Position of every drone at the start.
    pub start: Vec<Rational>,
}

/// Deepest nesting of parentheses read in an answer.
const MAX_DEPTH: usize = 200;

/// Reads what a solver printed for `query`.
///
/// # Errors
/// Text that is no solver's answer, or a model with values that are no rational numbers.
pub fn read_answer(query: &Query, text: &str) -> Result<Response> {
    let text = text.trim_start();
    let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    match word {
        "unsat" => Ok(Response::Unsat),
        "unknown" | "timeout" => Ok(Response::Unknown(word.to_owned())),
        "sat" => {
            let rest = rest.trim();
            let model = if rest.is_empty() { None } else { Some(read_model(query, rest)?) };
            Ok(Response::Sat(model))
        }
        other => {
            let shown: String = other.chars().take(40).collect();
            Err(Error::input(format!(
                "solver's answer: `{shown}`: expected `sat`, `unsat` or `unknown` first"
            )))
        }
    }
}

fn read_model(query: &Query, text: &str) -> Result<Model> {
    let mut tokens = tokens(text).into_iter().peekable();
    let parsed = expression(&mut tokens, 0)?;
    let Sexp::List(pairs) = parsed else {
        return Err(bad("a list of symbols and values"));
    };
    let value = |name: &str| -> Result<Rational> {
        let of_name = pairs.iter().find_map(|pair| match pair {
            Sexp::List(p) => match p.as_slice() {
                [Sexp::Word(n), v] if n == name => Some(v),
                _ => None,
            },
            Sexp::Word(_) => None,
        });
        number(of_name.ok_or_else(|| bad(&format!("a value of `{name}`")))?)
    };
    let values: Vec<_> = query.symbols().iter().map(|s| value(s)).collect::<Result<_>>()?;
    match values.as_slice() {
        [min, max, eps, start @ ..] => Ok(Model {
            params: Params { min: min.clone(), max: max.clone(), eps: eps.clone(), n: 0 },
            start: start.to_vec(),
        }),
        _ => Err(bad("values of min, max and eps")),
    }
}

enum Sexp {
    Word(String),
    List(Vec<Sexp>),
}

fn tokens(text: &str) -> Vec<String> {
    text.replace('(', " ( ").replace(')', " ) ").split_whitespace().map(str::to_owned).collect()
}

fn expression(
    tokens: &mut std::iter::Peekable<std::vec::IntoIter<String>>,
    depth: usize,
) -> Result<Sexp> {
    if depth > MAX_DEPTH {
        return Err(bad("a value nested less deeply"));
    }
    match tokens.next().as_deref() {
        Some("(") => {
            let mut list = Vec::new();
            while tokens.peek().is_some_and(|t| t != ")") {
                list.push(expression(tokens, depth + 1)?);
            }
            tokens.next().ok_or_else(|| bad("a closing parenthesis"))?;
            Ok(Sexp::List(list))
        }
        Some(")") | None => Err(bad("a value")),
        Some(word) => Ok(Sexp::Word(word.to_owned())),
    }
}

/// The rational that a solver writes as `2.0`, `(- 2.0)`, `(/ 1.0 2.0)` or `(- (/ 1 2))`.
fn number(value: &Sexp) -> Result<Rational> {
    match value {
        Sexp::Word(word) => exact::parse("solver's value", word),
        Sexp::List(parts) => match parts.as_slice() {
            [Sexp::Word(op), x] if op == "-" => Ok(-number(x)?),
            [Sexp::Word(op), x, y] if op == "/" => {
                let (x, y) = (number(x)?, number(y)?);
                if y.is_zero() { Err(bad("a quotient by other than zero")) } else { Ok(x / y) }
            }
            _ => Err(bad("a rational value (an irrational one cannot be replayed exactly)")),
        },
    }
}

fn bad(expected: &str) -> Error {
    Error::input(format!("solver's model: expected {expected}"))
}

/// What the spec says of a model, run over exact rationals.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Replay {
    /// The start meets the hypothesis and the conclusion fails.
    Violates {
        /// The step k that the violated statement is about.
        step: usize,
        /// What fails, in words with exact values.
        what: String,
    },
    /// It does not: the model is no counterexample.
    DoesNot(&'static str),
}

/// Runs a model of a [`Obligation::Violated`] query exactly: is its weight among those asked
/// about, does its start meet the hypothesis, and does its run violate the conclusion?
pub fn replay(query: &Query, model: &Model) -> Replay {
    let Obligation::Violated { steps } = query.obligation else {
        return Replay::DoesNot("the query asks for no run");
    };
    let Query { claim, form, drones, .. } = *query;
    let setting = Setting::from(&model.params);
    if !query.asks_about(&setting) {
        return Replay::DoesNot("its weight is none of those asked about");
    }
    if claim.allows(form, &setting, &model.start) != Truth::True {
        return Replay::DoesNot("its start does not meet the hypothesis");
    }
    let mut run = vec![model.start.clone()];
    let mut state = State { drones: model.start.clone(), timesteps: 0 };
    for _ in 0..steps + claim.span(form, drones) {
        state = exec_coverage(&model.params, &state);
        run.push(state.drones.clone());
    }
    for k in 0..=steps {
        if let Verdict::Violated(violation) = claim.conclusion(form, &setting, &run[k..]) {
            let ends = [&model.params.min, &model.params.max];
            let what = violation::in_words(ends, &run[k..], k as u64, violation);
            return Replay::Violates { step: k, what };
        }
    }
    Replay::DoesNot("the conclusion holds at every step looked at")
}
