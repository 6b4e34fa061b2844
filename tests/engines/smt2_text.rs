//! SMT-LIB 2 as far as the export writes it, evaluated.

use std::collections::BTreeMap;

use cordon_core::Rational;

#[derive(Clone, Debug)]
pub(super) enum Sexp {
    Word(String),
    List(Vec<Sexp>),
}

pub(super) fn parse(text: &str) -> Vec<Sexp> {
    let code: String =
        text.lines().map(|l| l.split(';').next().unwrap()).collect::<Vec<_>>().join("\n");
    let spaced = code.replace('(', " ( ").replace(')', " ) ");
    let mut stack = vec![Vec::new()];
    for token in spaced.split_whitespace() {
        match token {
            "(" => stack.push(Vec::new()),
            ")" => {
                let done = stack.pop().expect("balanced");
                stack.last_mut().expect("balanced").push(Sexp::List(done));
            }
            word => stack.last_mut().unwrap().push(Sexp::Word(word.to_owned())),
        }
    }
    assert_eq!(stack.len(), 1, "balanced parentheses");
    stack.pop().unwrap()
}

#[derive(Clone, Debug, PartialEq)]
enum Value {
    Real(Rational),
    Bool(bool),
}

impl Value {
    fn real(self) -> Rational {
        match self {
            Self::Real(x) => x,
            Self::Bool(b) => panic!("{b} where a real was expected"),
        }
    }

    fn bool(self) -> bool {
        match self {
            Self::Bool(b) => b,
            Self::Real(x) => panic!("{x} where a truth value was expected"),
        }
    }
}

type Env = BTreeMap<String, Value>;

fn eval(e: &Sexp, env: &Env) -> Value {
    let list = match e {
        Sexp::Word(w) if w == "true" => return Value::Bool(true),
        Sexp::Word(w) if w == "false" => return Value::Bool(false),
        Sexp::Word(w) if w.starts_with(|c: char| c.is_ascii_digit()) => {
            return Value::Real(cordon_core::exact::parse("literal", w).unwrap());
        }
        Sexp::Word(w) => return env.get(w).unwrap_or_else(|| panic!("`{w}` undeclared")).clone(),
        Sexp::List(list) => list,
    };
    let Sexp::Word(op) = &list[0] else { panic!("operator expected") };
    let arg = |i: usize| eval(&list[i], env);
    let two = || assert_eq!(list.len(), 3, "{op} takes two arguments here");
    match op.as_str() {
        "-" if list.len() == 2 => Value::Real(-arg(1).real()),
        "+" => (two(), Value::Real(arg(1).real() + arg(2).real())).1,
        "-" => (two(), Value::Real(arg(1).real() - arg(2).real())).1,
        "*" => (two(), Value::Real(arg(1).real() * arg(2).real())).1,
        "/" => (two(), Value::Real(arg(1).real() / arg(2).real())).1,
        "<" => (two(), Value::Bool(arg(1).real() < arg(2).real())).1,
        "<=" => (two(), Value::Bool(arg(1).real() <= arg(2).real())).1,
        "=" => (two(), Value::Bool(arg(1).real() == arg(2).real())).1,
        "not" => Value::Bool(!arg(1).bool()),
        "and" => Value::Bool(
            (1..list.len()).map(|i| arg(i).bool()).collect::<Vec<_>>().iter().all(|&b| b),
        ),
        "or" => Value::Bool(
            (1..list.len()).map(|i| arg(i).bool()).collect::<Vec<_>>().iter().any(|&b| b),
        ),
        "ite" => {
            if arg(1).bool() {
                arg(2)
            } else {
                arg(3)
            }
        }
        other => panic!("operator `{other}`"),
    }
}

/// Whether all assertions of the script hold for these values of its declared constants.
pub(super) fn satisfied(script: &[Sexp], values: &[Rational]) -> bool {
    let mut env = Env::new();
    let mut values = values.iter();
    let mut all = true;
    for command in script {
        let Sexp::List(command) = command else { panic!("command expected") };
        let word = |i: usize| match &command[i] {
            Sexp::Word(w) => w.as_str(),
            Sexp::List(_) => panic!("word expected"),
        };
        match word(0) {
            "declare-const" => {
                assert_eq!(word(2), "Real");
                env.insert(word(1).to_owned(), Value::Real(values.next().unwrap().clone()));
            }
            "define-fun" => {
                let value = eval(&command[4], &env);
                match word(3) {
                    "Real" => assert!(matches!(value, Value::Real(_))),
                    "Bool" => assert!(matches!(value, Value::Bool(_))),
                    sort => panic!("sort `{sort}`"),
                }
                let before = env.insert(word(1).to_owned(), value);
                assert!(before.is_none(), "`{}` defined twice", word(1));
            }
            "assert" => all &= eval(&command[1], &env).bool(),
            "set-logic" | "check-sat" | "get-value" => {}
            other => panic!("command `{other}`"),
        }
    }
    assert!(values.next().is_none(), "every value has its declaration");
    all
}
