//! Assumptions, claims and targets: comparisons about every agent, or about named ones.

use std::cell::Cell;

use toml::{Spanned, Value};

use cordon_core::linear::feasible::Constraint;
use cordon_core::scalar::Polynomial;
use cordon_core::system::expression::{
    Comparison, Expression, Meaning, SyntaxError, comparisons, number,
};
use cordon_core::system::{Claim, Predicate, Variable};
use cordon_core::{Rational, Result};

use super::rules::{syntax, text};
use crate::scenario::file::Source;

/// Most comparisons in the claims, and as many in the assumptions on the start.
const MOST_COMPARISONS: usize = 2_000;

/// The last step that a claim may name.
const LAST_STEP: usize = 1_000;

/// What is needed to read comparisons.
pub(super) struct Claims<'s> {
    pub source: &'s Source<'s>,
    pub agents: usize,
    pub variables: &'s [Variable],
}

/// The names of a comparison about agent `i`.
struct About<'s> {
    claims: &'s Claims<'s>,
    i: usize,
    /// Whether `i` was looked at, outside of sums.
    depends: &'s Cell<bool>,
    /// Whether an agent beyond the ends was named.
    beyond: &'s Cell<bool>,
}

impl About<'_> {
    fn state(&self, agent: usize, name: &str) -> std::result::Result<Polynomial, String> {
        let variables = self.claims.variables;
        match variables.iter().position(|v| v.name == name) {
            Some(v) => {
                let place = agent * variables.len() + v;
                Ok(Polynomial::variable(u32::try_from(place).unwrap_or(u32::MAX)))
            }
            None => Err(format!("`{name}`: expected a state variable, `N` or `i`")),
        }
    }
}

impl Meaning for About<'_> {
    fn name(&self, name: &str) -> std::result::Result<Polynomial, String> {
        let whole = |n: usize| Polynomial::constant(Rational::from_integer(n.into()));
        if name == "N" {
            return Ok(whole(self.claims.agents));
        }
        if name == "i" {
            self.depends.set(true);
            return Ok(whole(self.i));
        }
        match numbered(name) {
            Some((name, agent)) if agent < self.claims.agents => self.state(agent, name),
            Some((_, agent)) => Err(no_agent(agent, self.claims.agents)),
            None => {
                self.depends.set(true);
                self.state(self.i, name)
            }
        }
    }

    fn indexed(&self, name: &str, index: &Rational) -> std::result::Result<Polynomial, String> {
        match usize::try_from(index.to_integer()) {
            Ok(agent) if index.is_integer() && agent < self.claims.agents => {
                self.state(agent, name)
            }
            _ if self.depends.get() && index.is_integer() => {
                self.beyond.set(true);
                Ok(Polynomial::default())
            }
            _ => Err(no_agent(index, self.claims.agents)),
        }
    }

    fn sum(&self, inner: &Expression) -> std::result::Result<Polynomial, SyntaxError> {
        let depends = Cell::new(false);
        (0..self.claims.agents).try_fold(Polynomial::default(), |sum, i| {
            let about = About { i, depends: &depends, ..*self };
            Ok(sum + &inner.value(&about)?)
        })
    }
}

/// A name that ends with an agent's number: `x0`.
pub(super) fn numbered(name: &str) -> Option<(&str, usize)> {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = name.get(letters.len()..)?.parse().ok()?;
    (!letters.is_empty()).then_some((letters, number))
}

pub(super) fn no_agent(given: impl std::fmt::Display, agents: usize) -> String {
    format!("`{given}` is not an agent: expected 0 to {}", agents.saturating_sub(1))
}

impl Claims<'_> {
    /// What is assumed of the start.
    pub fn starts(&self, list: &[Spanned<String>]) -> Result<Vec<Predicate>> {
        let mut all = Vec::new();
        for written in list {
            all.extend(self.predicates("start", &written.span(), written.get_ref())?);
            self.refuse_too_many("start", &written.span(), all.len())?;
        }
        Ok(all)
    }

    /// What is claimed.
    pub fn claims(&self, list: &[Spanned<Value>]) -> Result<Vec<Claim>> {
        let mut all = Vec::new();
        for written in list {
            let fail = || {
                let message = "claims: expected a comparison, or one with its steps like `{ holds = \
                               \"x0 < 1\", from = 3, until = 9 }`";
                self.source.error(&written.span(), message)
            };
            let (text, from, until) = match written.get_ref() {
                Value::String(text) => (text.as_str(), 0, None),
                Value::Table(table) => {
                    let known = |k: &String| ["holds", "from", "until"].contains(&k.as_str());
                    let step = |key: &str| match table.get(key) {
                        None => Ok(None),
                        Some(v) => v
                            .as_integer()
                            .and_then(|k| usize::try_from(k).ok())
                            .filter(|k| *k <= LAST_STEP)
                            .map(Some)
                            .ok_or_else(|| {
                                let message = format!(
                                    "claims: `{key} = {v}`: expected a step from 0 to {LAST_STEP}"
                                );
                                self.source.error(&written.span(), &message)
                            }),
                    };
                    let text = table.get("holds").and_then(Value::as_str).ok_or_else(fail)?;
                    if !table.keys().all(known) {
                        return Err(fail());
                    }
                    (text, step("from")?.unwrap_or(0), step("until")?)
                }
                _ => return Err(fail()),
            };
            if until.is_some_and(|last| last < from) {
                return Err(self.source.error(&written.span(), "claims: `until` is before `from`"));
            }
            let predicates = self.predicates("claims", &written.span(), text)?;
            all.extend(predicates.into_iter().map(|predicate| Claim { predicate, from, until }));
            self.refuse_too_many("claims", &written.span(), all.len())?;
        }
        Ok(all)
    }

    fn refuse_too_many(
        &self,
        field: &str,
        at: &std::ops::Range<usize>,
        count: usize,
    ) -> Result<()> {
        if count <= MOST_COMPARISONS {
            return Ok(());
        }
        let message = format!("{field}: expected at most {MOST_COMPARISONS} comparisons in all");
        Err(self.source.error(at, &message))
    }

    fn predicates(
        &self,
        field: &str,
        at: &std::ops::Range<usize>,
        text: &str,
    ) -> Result<Vec<Predicate>> {
        let wrong = |e: SyntaxError| syntax(self.source, field, at, &e);
        let mut all = Vec::new();
        for comparison in comparisons(text).map_err(wrong)? {
            let found = self.instances(&comparison, text).map_err(wrong)?;
            if found.is_empty() {
                let message = format!(
                    "{field}: expected agents from 0 to {}: there are no others",
                    self.agents.saturating_sub(1)
                );
                return Err(self.source.error(at, &message));
            }
            all.extend(found);
        }
        Ok(all)
    }

    /// One for every agent that it speaks of.
    fn instances(
        &self,
        comparison: &Comparison,
        text: &str,
    ) -> std::result::Result<Vec<Predicate>, SyntaxError> {
        let mut all = Vec::new();
        for i in 0..self.agents {
            let (depends, beyond) = (Cell::new(false), Cell::new(false));
            let about = About { claims: self, i, depends: &depends, beyond: &beyond };
            let difference = comparison.greater.value(&about)? - &comparison.less.value(&about)?;
            let form = difference.affine().ok_or_else(|| SyntaxError {
                at: 0,
                message: "expected no product of state variables".to_owned(),
            })?;
            if !beyond.get() {
                let text = match depends.get() {
                    true => format!("{text} (i = {i})"),
                    false => text.to_owned(),
                };
                all.push(Predicate { text, is: Constraint { form, sign: comparison.relation } });
            }
            if !depends.get() {
                break;
            }
        }
        Ok(all)
    }

    /// The target of every state variable.
    pub fn targets(&self, value: &Spanned<Value>) -> Result<Vec<Rational>> {
        let mut expressions = Vec::new();
        for v in self.variables {
            let written = match value.get_ref() {
                Value::Table(table) => table.get(&v.name),
                single if self.variables.len() == 1 => Some(single),
                _ => None,
            };
            let Some(written) = written.and_then(text) else {
                let message = format!(
                    "target: expected an expression for `{}`, like `{{ {} = \"i/(N - 1)\" }}`",
                    v.name, v.name
                );
                return Err(self.source.error(&value.span(), &message));
            };
            let wrong = |e: SyntaxError| syntax(self.source, "target", &value.span(), &e);
            expressions.push(Expression::parse(&written).map_err(wrong)?);
        }
        let mut targets = Vec::new();
        for i in 0..self.agents {
            for e in &expressions {
                let (depends, beyond) = (Cell::new(false), Cell::new(false));
                let about = About { claims: self, i, depends: &depends, beyond: &beyond };
                let wrong = |e: SyntaxError| syntax(self.source, "target", &value.span(), &e);
                let target = number(&e.value(&about).map_err(wrong)?).ok_or_else(|| {
                    let message = "target: expected numbers, `i` and `N` only";
                    self.source.error(&value.span(), message)
                })?;
                targets.push(target);
            }
        }
        Ok(targets)
    }
}
