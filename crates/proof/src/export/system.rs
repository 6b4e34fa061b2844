//! The claims of a system as SMT-LIB 2: an induction over the steps, or a search for a run.
//!
//! The step is what [`Mode::step`] computes on terms. A claim about certain steps only takes no part
//! in an induction, but in a search.

use std::fmt::Write as _;
use std::rc::Rc;

use cordon_core::exact::fraction;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::system::{Claim, Map, Mode, Parameter, ParameterKind, Schedule, System};
use cordon_core::{Error, Rational, Result};
use num_traits::{Signed, Zero};

use super::term::Term;

/// Queries that are all `unsat` where the claims of every step are an inductive invariant: every
/// assumed start meets them, and every step keeps them.
///
/// # Errors
/// There is no claim about every step.
pub fn induction(system: &System) -> Result<String> {
    let claims: Vec<&Claim> =
        system.claims.iter().filter(|c| c.from == 0 && c.until.is_none()).collect();
    if claims.is_empty() {
        return Err(Error::input(
            "claims: expected one about every step, which an induction is about",
        ));
    }
    let mut start = Script::new(system, "does an assumed start break a claim?");
    let before = start.state(0);
    start.assume(&system.start_constraints(), &before);
    start.some_broken(&[(claims.clone(), before)]);
    let mut step =
        Script::new(system, "does a step lead from where the claims hold to where one fails?");
    let (before, after) = (step.state(0), step.state(1));
    let hold: Vec<Constraint> = claims.iter().map(|c| c.predicate.is.clone()).collect();
    step.assume(&hold, &before);
    let modes: Vec<&Mode> = system.modes.iter().collect();
    step.step(1, &modes, &before, &after);
    step.some_broken(&[(claims, after)]);
    Ok(start.done() + "(reset)\n\n" + &step.done())
}

/// One query that is `sat` where some assumed start has a run that breaks a claim at a step from 0 to
/// `last`.
pub fn search(system: &System, last: usize) -> String {
    let question = format!("does a run from an assumed start break a claim at a step 0 .. {last}?");
    let mut script = Script::new(system, &question);
    let mut state = script.state(0);
    script.assume(&system.start_constraints(), &state);
    let mut about = Vec::new();
    for k in 0..=last {
        let claims = system.claims.iter().filter(|c| c.is_about(k)).collect();
        about.push((claims, state.clone()));
        if k < last {
            let next = script.state(k + 1);
            let modes: Vec<&Mode> = match system.mode_of_step(k + 1) {
                Some(mode) => system.modes.get(mode).into_iter().collect(),
                None => system.modes.iter().collect(),
            };
            script.step(k + 1, &modes, &state, &next);
            state = next;
        }
    }
    script.some_broken(&about);
    script.done()
}

/// A script under way.
struct Script<'s> {
    system: &'s System,
    text: String,
}

impl<'s> Script<'s> {
    fn new(system: &'s System, question: &str) -> Self {
        let constant = system.parameters.iter().all(|p| p.fixed().is_some());
        let logic = if constant { "QF_LRA" } else { "QF_NRA" };
        let turn = match &system.schedule {
            Schedule::Any => "",
            Schedule::Cycle(_) => ", modes in turn",
        };
        // A title is the user's: it stays on its line.
        let title = cordon_core::text::one_line(&system.title);
        let text = format!(
            "; {title}: {} agents{turn}\n; {question} unsat: no\n(set-logic {logic})\n",
            system.agents
        );
        let mut script = Self { system, text };
        for p in system.parameters.iter().filter(|p| p.kind == ParameterKind::Constant) {
            script.parameter(p, &format!("p.{}", p.name));
        }
        script
    }

    fn line(&mut self, line: impl AsRef<str>) {
        self.text.push_str(line.as_ref());
        self.text.push('\n');
    }

    /// Declares a parameter that has more than one value.
    fn parameter(&mut self, p: &Parameter, name: &str) {
        if p.fixed().is_some() {
            return;
        }
        let (low, high) = (literal(&p.low), literal(&p.high));
        self.line(format!("(declare-const {name} Real)"));
        self.line(match p.kind {
            ParameterKind::Choice => format!("(assert (or (= {name} {low}) (= {name} {high})))"),
            _ => format!("(assert (<= {low} {name} {high}))"),
        });
    }

    /// Declares the state after `k` steps.
    fn state(&mut self, k: usize) -> Vec<Term> {
        let names: Vec<String> =
            self.system.state.iter().map(|name| format!("{name}.{k}")).collect();
        for name in &names {
            self.line(format!("(declare-const {name} Real)"));
        }
        names.into_iter().map(symbol).collect()
    }

    fn assume(&mut self, constraints: &[Constraint], state: &[Term]) {
        for c in constraints {
            self.line(format!("(assert {})", comparison(c, state)));
        }
    }

    /// Step `k`, by any of the modes.
    fn step(&mut self, k: usize, modes: &[&Mode], before: &[Term], after: &[Term]) {
        let mut values = Vec::new();
        for p in &self.system.parameters {
            let name = match p.kind {
                ParameterKind::Constant => format!("p.{}", p.name),
                ParameterKind::Varying | ParameterKind::Choice => format!("p.{}.{k}", p.name),
            };
            if p.kind != ParameterKind::Constant {
                self.parameter(p, &name);
            }
            values.push(p.fixed().map_or_else(|| symbol(name), number));
        }
        // Numbers are multiplied here, so that what is linear reads so.
        let fixed: Option<Vec<Rational>> =
            self.system.parameters.iter().map(|p| p.fixed().cloned()).collect();
        let moves = |mode: &&Mode| {
            let next = match &fixed {
                Some(fixed) => applied(&mode.at(fixed), before),
                None => mode.step(&number, &values, before),
            };
            let mut all = "(and".to_owned();
            for (to, next) in after.iter().zip(next) {
                // Writing to a string does not fail.
                let _ = write!(all, "\n  (= {to} {next})");
            }
            all + ")"
        };
        let ways: Vec<String> = modes.iter().map(moves).collect();
        self.line(format!("(assert (or {}))", ways.join("\n ")));
    }

    /// At one of the states some claim about it does not hold.
    fn some_broken(&mut self, about: &[(Vec<&Claim>, Vec<Term>)]) {
        let mut any = "(assert (or false".to_owned();
        for (claims, state) in about {
            for claim in claims {
                let holds = comparison(&claim.predicate.is, state);
                let _ = write!(any, "\n  (not {holds})");
            }
        }
        self.line(any + "))");
    }

    fn done(mut self) -> String {
        self.line("(check-sat)");
        self.text
    }
}

/// A map on terms.
fn applied(map: &Map, state: &[Term]) -> Vec<Term> {
    let row = |(constant, row): &(Rational, Vec<(usize, Rational)>)| {
        let terms = row.iter().filter_map(|(j, a)| Some(number(a) * state.get(*j)?));
        terms.fold(number(constant), |sum, term| sum + &term)
    };
    map.rows.iter().map(row).collect()
}

fn symbol(name: impl Into<Rc<str>>) -> Term {
    Term::Symbol(name.into())
}

fn number(x: &Rational) -> Term {
    if x.is_integer() { Term::Int(x.to_integer()) } else { symbol(literal(x)) }
}

/// A number of sort Real.
fn literal(x: &Rational) -> String {
    let size = x.abs();
    let whole = match size.is_integer() {
        true => format!("{}.0", fraction(&size)),
        false => format!("(/ {}.0 {}.0)", size.numer(), size.denom()),
    };
    if x.is_negative() { format!("(- {whole})") } else { whole }
}

/// The comparison of a form in the state with 0.
fn comparison(c: &Constraint, state: &[Term]) -> String {
    let relation = match c.sign {
        Sign::Positive => ">",
        Sign::NonNegative => ">=",
        Sign::Zero => "=",
    };
    let Some((constant, coefficients)) = c.form.parts() else { return "false".to_owned() };
    let terms = coefficients.iter().zip(state).filter(|(a, _)| !a.is_zero());
    let sum = terms.fold(number(constant), |sum, (a, x)| sum + &(number(a) * x));
    format!("({relation} {sum} 0.0)")
}
