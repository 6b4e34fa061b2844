//! A system's claims as a PVS theory: its step, an invariant, and that every step keeps it.
//!
//! The invariant is the one that the search for a proof finds; where it finds none, the claims stand in
//! its place and the formulas are conjectures. A coefficient is of degree one in each parameter, so that
//! a half-space after a step is decided at the ends of the ranges, one range after the other
//! (`between_..`), and there by linear arithmetic.

mod names;
mod scripts;

use std::collections::BTreeMap;
use std::fmt::Write as _;

use num_traits::{One, Zero};

use super::{File, proofs};
use crate::claims::Proved;
use crate::claims::automaton::{Automaton, Edge};
use cordon_core::exact::fraction;
use cordon_core::linear::feasible::{Constraint, Sign};
use cordon_core::scalar::Polynomial;
use cordon_core::system::expression::sum_text;
use cordon_core::system::{Mode, Parameter, ParameterKind, System};
use cordon_core::{Error, Rational, Result};
use names::field;
use scripts::{ALWAYS, BETWEEN, FOLLOWS, KEPT, MOVES, START_MEETS, proof};

/// The name of the file and of the theory.
const NAME: &str = "own_protocol";

/// Most ends of ranges, of all half-spaces together, at which a step is looked at.
const MOST_CORNERS: usize = 20_000;

/// The theory of a system, with the invariant of a proof of its claims if there is one.
///
/// # Errors
/// Nothing is claimed of a step, or the proofs would be too long.
pub fn own(system: &System, found: Option<&Proved>) -> Result<File> {
    if system.claims.is_empty() {
        return Err(Error::input("claims: none in the protocol file: expected `claims`"));
    }
    let theories = Theory::of(system, found).text(found.is_some())?;
    Ok(File { name: NAME, proofs: proofs::proofs(&theories), theories })
}

/// An affine form in the state whose coefficients are of degree one in each parameter: by column (none for
/// the constant) and the parameters of a term.
type Form = BTreeMap<(Option<usize>, Vec<usize>), Rational>;

struct Theory<'s> {
    system: &'s System,
    /// State variables, and parameters that have more than one value, as fields.
    state: Vec<String>,
    parameters: Vec<String>,
    moments: Vec<String>,
    edges: Vec<Edge>,
    /// Of each moment, what holds and what is claimed.
    invariant: Vec<Vec<Constraint>>,
    claimed: Vec<Vec<Constraint>>,
}

impl<'s> Theory<'s> {
    fn of(system: &'s System, found: Option<&Proved>) -> Self {
        let automaton = Automaton::of(system);
        let claimed: Vec<Vec<Constraint>> = automaton
            .claims
            .iter()
            .map(|about| {
                about.iter().filter_map(|&j| Some(system.claims.get(j)?.predicate.is.clone()))
            })
            .map(Iterator::collect)
            .collect();
        let invariant = match found {
            None => claimed.clone(),
            Some(found) => (0..claimed.len())
                .map(|moment| found.proof.rows.iter().filter(move |r| r.moment == moment))
                .map(|rows| rows.map(|r| r.is.clone()).collect())
                .collect(),
        };
        let mut theory = Self {
            system,
            state: system.state.iter().map(|name| field(name)).collect(),
            parameters: system.parameters.iter().map(|p| field(&p.name)).collect(),
            moments: automaton.names,
            edges: automaton.edges,
            invariant,
            claimed,
        };
        theory.go_on();
        theory
    }

    /// Where nothing is claimed after a last step, the moment after it lasts for ever.
    fn go_on(&mut self) {
        let last = self.moments.len().saturating_sub(1);
        if self.edges.iter().any(|e| e.from == last) {
            return;
        }
        let later = self.moments.len();
        for from in [last, later] {
            let modes = 0..self.system.modes.len();
            self.edges.extend(modes.map(|mode| Edge { from, mode, to: later }));
        }
        self.moments.push("later".to_owned());
        self.invariant.push(Vec::new());
        self.claimed.push(Vec::new());
    }

    fn text(&self, proved: bool) -> Result<String> {
        let mut text = String::new();
        self.definitions(&mut text, proved);
        text.push_str(BETWEEN);
        let formula = if proved { "LEMMA" } else { "CONJECTURE" };
        let script = |name: &str, script: &str| match proved {
            true => proof(name, script),
            false => String::new(),
        };
        let mut line = |name: &str, kind: &str, says: &str, by: &str| {
            let _ = write!(text, "\n  {name}: {kind}\n    {says}\n{}", script(name, by));
        };
        line("start_meets", formula, "start?(s) IMPLIES invariant?(0)(s)", START_MEETS);
        let mut corners = 0;
        for (e, edge) in self.edges.iter().enumerate() {
            let Some(mode) = self.system.modes.get(edge.mode) else { continue };
            let (from, to, step) = (edge.from, edge.to, self.step_name(edge.mode));
            let rows = self.invariant.get(to).map_or(&[][..], Vec::as_slice);
            let mut by = String::from("(then (skeep)");
            for (j, row) in rows.iter().enumerate() {
                let name = format!("keeps_{e}_{j}");
                let after = self.comparison(row, &format!("{step}(p)(s)"));
                let mut tree = String::new();
                let stepped = self.after(row, mode);
                self.split(&stepped, row.sign, "  ", &mut tree, &mut corners)?;
                line(
                    &name,
                    formula,
                    &format!("allowed?(p) AND invariant?({from})(s) IMPLIES {after}"),
                    &format!(
                        "(then (skeep) (expand \"allowed?\") (expand \"invariant?\") (expand \"{step}\") (flatten)\n{tree})"
                    ),
                );
                let _ = write!(by, "\n  (lemma \"{name}\" (\"p\" \"p\" \"s\" \"s\"))");
            }
            by.push_str("\n  (expand \"invariant?\" 1) (ground))");
            line(
                &format!("keeps_{e}"),
                formula,
                &format!(
                    "allowed?(p) AND invariant?({from})(s) IMPLIES invariant?({to})({step}(p)(s))"
                ),
                &by,
            );
        }
        line(
            "keeps",
            formula,
            "allowed?(p) AND invariant?(m)(s) AND move?(p, m, s, n, t) IMPLIES invariant?(n)(t)",
            &self.every_move(),
        );
        line("follows", formula, "invariant?(m)(s) IMPLIES claimed?(m)(s)", FOLLOWS);
        line(
            "moves",
            formula,
            "run?(q, at, r) IMPLIES\n      allowed?(q(k)) AND move?(q(k), at(k), r(k), at(k + 1), r(k + 1))",
            MOVES,
        );
        line(
            "kept",
            formula,
            "FORALL k: FORALL q, at, r: run?(q, at, r) IMPLIES invariant?(at(k))(r(k))",
            KEPT,
        );
        let theorem = if proved { "THEOREM" } else { "CONJECTURE" };
        line("always", theorem, "run?(q, at, r) IMPLIES claimed?(at(k))(r(k))", ALWAYS);
        let _ = writeln!(text, "\nEND {NAME}");
        Ok(text)
    }

    /// Types, step, start, invariant, claims and runs.
    fn definitions(&self, text: &mut String, proved: bool) {
        let system = self.system;
        let title = cordon_core::text::one_line(&system.title);
        let status = match proved {
            true => {
                "The invariant was found by the search of `cordon prove`; the formulas have their proofs."
            }
            false => {
                "No invariant was found: the claims stand in its place, and nothing here is proved."
            }
        };
        let moments: Vec<String> =
            self.moments.iter().enumerate().map(|(m, name)| format!("{m} {name}")).collect();
        let ranged: Vec<(&Parameter, &String)> = self.ranged().collect();
        let fields: Vec<&str> = ranged.iter().map(|(_, name)| name.as_str()).collect();
        let parameters = match fields.as_slice() {
            [] => "below(1)".to_owned(),
            all => format!("[# {}: real #]", all.join(", ")),
        };
        let allowed = ranged.iter().flat_map(|(p, name)| {
            let (low, high) = (fraction(&p.low), fraction(&p.high));
            let either = (p.kind == ParameterKind::Choice)
                .then(|| format!("(p`{name} = {low} OR p`{name} = {high})"));
            [format!("{low} <= p`{name}"), format!("p`{name} <= {high}")].into_iter().chain(either)
        });
        let constant = ranged
            .iter()
            .filter(|(p, _)| p.kind == ParameterKind::Constant)
            .map(|(_, name)| format!("q(k)`{name} = q(0)`{name}"));
        let same: Vec<String> = constant.collect();
        let same = same.iter().map(|text| format!("{text} AND ")).collect::<String>();
        let moves = self.edges.iter().map(|edge| {
            let (from, to, step) = (edge.from, edge.to, self.step_name(edge.mode));
            format!("(m = {from} AND n = {to} AND t = {step}(p)(s))")
        });
        let starts = system.start_constraints();
        let start = starts.iter().map(|c| self.comparison(c, "s"));
        let holds = |of: &[Vec<Constraint>]| {
            let texts = of.iter().map(|all| and(all.iter().map(|c| self.comparison(c, "s"))));
            by_moment(texts.collect())
        };
        let _ = write!(
            text,
            "% {title}: {} agents.
% {status}
% Moments of a run: {}.

{NAME}: THEORY
BEGIN

  state: TYPE = [# {}: real #]

  % What the protocol leaves open, anew in each step; constants stay as they are in a run.
  parameters: TYPE = {parameters}

  s, t: VAR state
  p: VAR parameters
  m, n: VAR below({})
  k: VAR nat
  r: VAR [nat -> state]
  q: VAR [nat -> parameters]
  at: VAR [nat -> below({})]

  allowed?(p): bool =
    {}
",
            system.agents,
            moments.join(", "),
            self.state.join(", "),
            self.moments.len(),
            self.moments.len(),
            and(allowed)
        );
        for (place, mode) in system.modes.iter().enumerate() {
            let fields: Vec<String> = (0..self.state.len())
                .map(|j| format!("{} := {}", self.state[j], self.sum(&self.row(mode, j))))
                .collect();
            let _ = write!(
                text,
                "\n  {}(p)(s): state =\n    (# {} #)\n",
                self.step_name(place),
                fields.join(",\n       ")
            );
        }
        let _ = write!(
            text,
            "
  move?(p, m, s, n, t): bool =
    {}

  start?(s): bool =
    {}

  invariant?(m)(s): bool =
    {}

  claimed?(m)(s): bool =
    {}

  run?(q, at, r): bool =
    start?(r(0)) AND at(0) = 0 AND
    (FORALL k: allowed?(q(k)) AND {same}move?(q(k), at(k), r(k), at(k + 1), r(k + 1)))
",
            joined(moves, "OR", "FALSE"),
            and(start),
            holds(&self.invariant),
            holds(&self.claimed),
        );
    }

    fn step_name(&self, mode: usize) -> String {
        match self.system.modes.as_slice() {
            [_] => "step".to_owned(),
            _ => format!("step_{mode}"),
        }
    }

    /// The parameters that have more than one value.
    fn ranged(&self) -> impl Iterator<Item = (&Parameter, &String)> {
        self.system.parameters.iter().zip(&self.parameters).filter(|(p, _)| p.fixed().is_none())
    }

    /// A polynomial in the parameters, those with one value put in.
    fn add(&self, form: &mut Form, column: Option<usize>, factor: &Rational, a: &Polynomial) {
        for (monomial, c) in a.terms() {
            let (mut c, mut open) = (c * factor, Vec::new());
            for v in monomial.powers().map(|(v, _)| v as usize) {
                match self.system.parameters.get(v).and_then(Parameter::fixed) {
                    Some(value) => c *= value,
                    None => open.push(v),
                }
            }
            *form.entry((column, open)).or_insert_with(Rational::zero) += c;
        }
    }

    fn row(&self, mode: &Mode, j: usize) -> Form {
        let mut form = Form::new();
        if let Some((constant, entries)) = mode.row(j) {
            entries.iter().for_each(|(j, a)| self.add(&mut form, Some(*j), &Rational::one(), a));
            self.add(&mut form, None, &Rational::one(), constant);
        }
        form.retain(|_, c| !c.is_zero());
        form
    }

    /// What the form of a constraint is after a step.
    fn after(&self, row: &Constraint, mode: &Mode) -> Form {
        let mut form = Form::new();
        if let Some((constant, coefficients)) = row.form.parts() {
            form.insert((None, Vec::new()), constant.clone());
            for (j, factor) in coefficients.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
                for (at, c) in self.row(mode, j) {
                    *form.entry(at).or_insert_with(Rational::zero) += c * factor;
                }
            }
        }
        form.retain(|_, c| !c.is_zero());
        form
    }

    fn sum(&self, form: &Form) -> String {
        let names: Vec<String> = self.state.iter().map(|name| format!("s`{name}")).collect();
        let open: Vec<String> = self.parameters.iter().map(|name| format!("p`{name}")).collect();
        let terms = form.iter().map(|((column, parameters), c)| {
            let factors = parameters.iter().filter_map(|p| open.get(*p));
            let variable = column.and_then(|j| names.get(j));
            (c, factors.chain(variable).map(String::as_str).collect())
        });
        sum_text(terms)
    }

    fn comparison(&self, c: &Constraint, state: &str) -> String {
        let relation = match c.sign {
            Sign::Positive => ">",
            Sign::NonNegative => ">=",
            Sign::Zero => "=",
        };
        let Some((constant, coefficients)) = c.form.parts() else { return "FALSE".to_owned() };
        let names: Vec<String> = self.state.iter().map(|name| format!("{state}`{name}")).collect();
        let terms = coefficients.iter().zip(&names).map(|(a, name)| (a, vec![name.as_str()]));
        let terms = terms.chain([(constant, Vec::new())]).filter(|(a, _)| !a.is_zero());
        format!("{} {relation} 0", sum_text(terms))
    }

    /// The proof that a form is positive, range by range.
    fn split(
        &self,
        form: &Form,
        sign: Sign,
        indent: &str,
        text: &mut String,
        corners: &mut usize,
    ) -> Result<()> {
        let open = form.keys().flat_map(|(_, parameters)| parameters).min().copied();
        let ranged = open.and_then(|v| Some((v, self.system.parameters.get(v)?)));
        let Some((v, p)) = ranged else {
            *corners += 1;
            if *corners > MOST_CORNERS {
                return Err(Error::input(format!(
                    "protocol: more than {MOST_CORNERS} ends of ranges in the proofs: expected fewer agents or \
                     choices"
                )));
            }
            let _ = write!(text, "{indent}(assert)");
            return Ok(());
        };
        // The form is a + b * v.
        let (mut a, mut b) = (form.clone(), Form::new());
        a.retain(|(_, parameters), _| !parameters.contains(&v));
        for ((column, parameters), c) in form.iter().filter(|((_, all), _)| all.contains(&v)) {
            let rest = parameters.iter().filter(|q| **q != v).copied().collect();
            b.insert((*column, rest), c.clone());
        }
        let between = if sign == Sign::Positive { "between_pos" } else { "between_nonneg" };
        let name = self.parameters.get(v).map_or("", String::as_str);
        let _ = write!(
            text,
            "{indent}(then (lemma \"{between}\" (\"a\" \"{}\" \"b\" \"{}\" \"lo\" \"{}\" \"hi\" \"{}\" \"e\" \
             \"p`{name}\"))\n{indent}  (spread (split -1) ((assert) (assert) (assert)",
            self.sum(&a),
            self.sum(&b),
            fraction(&p.low),
            fraction(&p.high)
        );
        for end in [&p.low, &p.high] {
            let mut at = a.clone();
            for (place, c) in &b {
                *at.entry(place.clone()).or_insert_with(Rational::zero) += c * end;
            }
            at.retain(|_, c| !c.is_zero());
            text.push('\n');
            self.split(&at, sign, &format!("{indent}    "), text, corners)?;
        }
        text.push_str(")))");
        Ok(())
    }

    /// The proof that every move keeps the invariant, move by move.
    fn every_move(&self) -> String {
        let one = |e: usize| {
            format!("(then (flatten) (lemma \"keeps_{e}\" (\"p\" \"p\" \"s\" \"s\")) (assert))")
        };
        let each: Vec<String> = (0..self.edges.len()).map(one).collect();
        match each.as_slice() {
            [only] => format!("(then (skeep) (expand \"move?\") {only})"),
            all => format!(
                "(then (skeep) (expand \"move?\") (spread (split -3)\n  ({})))",
                all.join("\n   ")
            ),
        }
    }
}

fn and(texts: impl IntoIterator<Item = String>) -> String {
    joined(texts, "AND", "TRUE")
}

fn joined(texts: impl IntoIterator<Item = String>, by: &str, empty: &str) -> String {
    match texts.into_iter().collect::<Vec<_>>().as_slice() {
        [] => empty.to_owned(),
        all => all.join(&format!(" {by}\n    ")),
    }
}

/// What holds at each moment, as one expression.
fn by_moment(texts: Vec<String>) -> String {
    let Some((last, before)) = texts.split_last() else { return "TRUE".to_owned() };
    if before.is_empty() {
        return last.clone();
    }
    let mut text = String::new();
    for (m, holds) in before.iter().enumerate() {
        let _ = write!(text, "{}IF m = {m} THEN {holds}\n    ", if m == 0 { "" } else { "ELS" });
    }
    format!("{text}ELSE {last} ENDIF")
}
