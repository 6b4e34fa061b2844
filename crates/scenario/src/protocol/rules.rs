//! Rules by class of agents, made into the modes of a system.
//!
//! What an agent hears of another one is in [`heard`]. Whether a link works, how old a message is, and whether
//! an agent acts at all are parameters between 0 and 1 that are chosen anew in each step, so that every
//! departure is a system of one kind.

mod heard;

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::ops::Range;

use toml::{Spanned, Value};

use super::document::{Document, Loss, RuleTable};
use super::links::Links;
use crate::scenario::file::Source;
use cordon_core::scalar::Polynomial;
use cordon_core::system::expression::{Expression, SyntaxError};
use cordon_core::system::{Mode, Parameter, Variable};
use cordon_core::{Error, Result};
use heard::{Layout, Names};

/// A rule: an expression a state variable of an agent, with its place in the file.
#[derive(Clone, Debug)]
struct Rule {
    field: String,
    place: Range<usize>,
    next: Vec<Expression>,
}

/// What a rule says of the variables that it does not name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unnamed {
    /// Their next values are those that they have.
    Kept,
    /// Their derivatives are 0.
    Zero,
}

/// The rules of a file, for one number of agents.
pub(super) struct Rules<'s> {
    source: &'s Source<'s>,
    count: usize,
    variables: &'s [Variable],
    constants: Vec<Parameter>,
    links: Links,
    /// Of each mode its name and the rule of every agent.
    modes: Vec<(String, Vec<Rule>)>,
    cycle: Option<Vec<usize>>,
    skip: bool,
    loss: Option<Loss>,
    delay: usize,
    unnamed: Unnamed,
}

/// What the rules come to.
pub(super) struct Built {
    pub state: Vec<String>,
    pub past: Vec<usize>,
    pub parameters: Vec<Parameter>,
    pub modes: Vec<Mode>,
    pub cycle: Option<Vec<usize>>,
    pub links: Vec<(usize, usize)>,
}

impl<'s> Rules<'s> {
    pub fn new(
        source: &'s Source<'s>,
        doc: &Document,
        count: usize,
        variables: &'s [Variable],
        constants: Vec<Parameter>,
        links: Links,
        unnamed: Unnamed,
    ) -> Result<Self> {
        let mut rules = Self {
            source,
            count,
            variables,
            constants,
            links,
            modes: Vec::new(),
            cycle: None,
            skip: doc.departures.skips(),
            loss: doc.loss(source)?,
            delay: doc.delay(source)?,
            unnamed,
        };
        let base = doc.rules.as_ref().map(Spanned::get_ref);
        let empty = RuleTable::new();
        let base = base.unwrap_or(&empty);
        if doc.modes.is_empty() {
            let place = doc.rules.as_ref().map(Spanned::span);
            rules.modes.push(("step".to_owned(), rules.mode("rules", place, base, None)?));
        }
        // In the order in which they are declared: the first acts in a run of which nothing else is said.
        let mut declared: Vec<_> = doc.modes.iter().collect();
        declared.sort_by_key(|(name, _)| name.span().start);
        for (name, table) in declared {
            let field = format!("modes.{}", name.get_ref());
            if name.get_ref().is_empty()
                || !name.get_ref().chars().all(|c| c.is_ascii_alphanumeric())
            {
                let message = format!("{field}: expected a name of letters and digits");
                return Err(source.error(&name.span(), &message));
            }
            let mode = rules.mode(&field, Some(name.span()), base, Some(table))?;
            rules.modes.push((name.get_ref().clone(), mode));
        }
        if let Some(list) = &doc.switching {
            let place = |mode: &Spanned<String>| {
                let found = rules.modes.iter().position(|(name, _)| name == mode.get_ref());
                found.ok_or_else(|| {
                    let known: Vec<&str> = rules.modes.iter().map(|(n, _)| n.as_str()).collect();
                    let message = format!(
                        "switching: `{}` is not a mode: expected some of {}",
                        mode.get_ref(),
                        known.join(", ")
                    );
                    source.error(&mode.span(), &message)
                })
            };
            let cycle: Vec<usize> = list.get_ref().iter().map(place).collect::<Result<_>>()?;
            if cycle.is_empty() || cycle.len() > 50 {
                return Err(source.error(&list.span(), "switching: expected 1 to 50 modes"));
            }
            rules.cycle = Some(cycle);
        }
        Ok(rules)
    }

    /// The rule of every agent: of the mode, else of the file; of the agent, else of its class, else
    /// of all.
    fn mode(
        &self,
        field: &str,
        place: Option<Range<usize>>,
        base: &RuleTable,
        over: Option<&RuleTable>,
    ) -> Result<Vec<Rule>> {
        let mut chosen: Vec<Option<(u8, Rule)>> = vec![None; self.count];
        let tables = [(base, "rules", 0)].into_iter().chain(over.map(|t| (t, field, 4)));
        for (table, field, rank) in tables {
            for (key, value) in table {
                let (agents, class) = self.class(field, key)?;
                let rule = self.rule(&format!("{field}.{}", key.get_ref()), value)?;
                for i in agents {
                    let Some(slot) = chosen.get_mut(i) else { continue };
                    if slot.as_ref().is_none_or(|(before, _)| *before <= rank + class) {
                        *slot = Some((rank + class, rule.clone()));
                    }
                }
            }
        }
        let mut rules = Vec::new();
        for (i, rule) in chosen.into_iter().enumerate() {
            let Some((_, rule)) = rule else {
                let class = self.class_of(i);
                let message =
                    format!("{field}: agent {i} has no rule: expected `all`, `{class}` or `{i}`");
                return Err(match &place {
                    Some(place) => self.source.error(place, &message),
                    None => Error::input(format!("{}: {message}", self.source.name)),
                });
            };
            rules.push(rule);
        }
        Ok(rules)
    }

    /// The key of the class that agent `i` is of.
    fn class_of(&self, i: usize) -> &'static str {
        match i {
            0 => "first",
            _ if i + 1 == self.count => "last",
            _ => "inner",
        }
    }

    /// The agents that a key of rules speaks of, and how particular it is.
    fn class(&self, field: &str, key: &Spanned<String>) -> Result<(Range<usize>, u8)> {
        let last = self.count.saturating_sub(1);
        match key.get_ref().as_str() {
            "all" => Ok((0..self.count, 0)),
            "first" => Ok((0..1, 1)),
            "inner" => Ok((1..last.max(1), 1)),
            "last" => Ok((last..self.count, 1)),
            other => match other.parse::<usize>() {
                Ok(i) if i < self.count => Ok((i..i + 1, 2)),
                _ => {
                    let message = format!(
                        "{field}.{other}: expected `all`, `first`, `inner`, `last` or an agent from 0 \
                         to {last}"
                    );
                    Err(self.source.error(&key.span(), &message))
                }
            },
        }
    }

    fn rule(&self, field: &str, value: &Spanned<Value>) -> Result<Rule> {
        let place = value.span();
        let parse = |field: &str, written: &Value| {
            let Some(written) = text(written) else {
                let message = format!("{field}: expected an expression in quotes");
                return Err(self.source.error(&place, &message));
            };
            Expression::parse(&written).map_err(|e| syntax(self.source, field, &place, &e))
        };
        let next = match value.get_ref() {
            Value::Table(table) => {
                let is_variable = |name: &String| self.variables.iter().any(|v| v.name == *name);
                if let Some(other) = table.keys().find(|k| !is_variable(k)) {
                    let message = format!("{field}: `{other}` is not a state variable");
                    return Err(self.source.error(&place, &message));
                }
                let own = |v: &Variable| match table.get(&v.name) {
                    Some(written) => parse(&format!("{field}.{}", v.name), written),
                    None => Expression::parse(match self.unnamed {
                        Unnamed::Kept => &v.name,
                        Unnamed::Zero => "0",
                    })
                    .map_err(|e| syntax(self.source, field, &place, &e)),
                };
                self.variables.iter().map(own).collect::<Result<_>>()?
            }
            single if self.variables.len() == 1 => vec![parse(field, single)?],
            _ => {
                let names: Vec<String> =
                    self.variables.iter().map(|v| format!("{} = \"..\"", v.name)).collect();
                let message = format!(
                    "{field}: expected an expression a state variable: {{ {} }}",
                    names.join(", ")
                );
                return Err(self.source.error(&place, &message));
            }
        };
        Ok(Rule { field: field.to_owned(), place, next })
    }

    /// The system's parts.
    pub fn build(self) -> Result<Built> {
        // First who hears whom: executed with nothing missing and nothing late.
        let heard = RefCell::new(BTreeSet::new());
        let mut layout = Layout::new(&self, &BTreeSet::new());
        for (_, rules) in &self.modes {
            self.execute(rules, &layout, &heard)?;
        }
        let heard = heard.into_inner();
        layout = Layout::new(&self, &heard);
        let ignored = RefCell::new(BTreeSet::new());
        let mut modes = Vec::new();
        for (name, rules) in &self.modes {
            let mut next = self.execute(rules, &layout, &ignored)?;
            next.extend(layout.past.iter().map(|p| p.next.clone()));
            let mode = Mode::read(name, &next, layout.state.len(), &layout.parameters);
            let place = rules.first().map_or(0..0, |rule| rule.place.clone());
            modes.push(mode.map_err(|e| self.source.error(&place, &format!("{name}: {e}")))?);
        }
        Ok(Built {
            state: layout.state,
            past: layout.past.iter().map(|p| p.source).collect(),
            parameters: layout.parameters,
            modes,
            cycle: self.cycle,
            links: heard.into_iter().collect(),
        })
    }

    fn execute(
        &self,
        rules: &[Rule],
        layout: &Layout,
        heard: &RefCell<BTreeSet<(usize, usize)>>,
    ) -> Result<Vec<Polynomial>> {
        let mut next = Vec::new();
        for (i, rule) in rules.iter().enumerate() {
            let names = Names { rules: self, layout, heard, i, their: None };
            for (v, expression) in rule.next.iter().enumerate() {
                let wrong = |e: SyntaxError| {
                    let field = format!("{} (agent {i})", rule.field);
                    syntax(self.source, &field, &rule.place, &e)
                };
                let value = expression.value(&names).map_err(wrong)?;
                Mode::read(
                    "step",
                    std::slice::from_ref(&value),
                    layout.state.len(),
                    &layout.parameters,
                )
                .map_err(|e| wrong(SyntaxError { at: 0, message: e.to_string() }))?;
                next.push(match layout.acts.get(i) {
                    Some(&p) => {
                        let own = layout.symbol(i * self.variables.len() + v);
                        let moved = value - &own;
                        own + &(layout.parameter(p) * &moved)
                    }
                    None => value,
                });
            }
        }
        Ok(next)
    }
}

/// The text of an expression: a text in quotes, or a number.
pub(super) fn text(value: &Value) -> Option<String> {
    match value {
        Value::String(text) => Some(text.clone()),
        Value::Integer(n) => Some(n.to_string()),
        Value::Float(x) => Some(x.to_string()),
        _ => None,
    }
}

/// The error that a syntax error is, at its place in a text in quotes.
pub(super) fn syntax(
    source: &Source<'_>,
    field: &str,
    at: &Range<usize>,
    e: &SyntaxError,
) -> Error {
    // Inside the quotation marks; escapes have no use in expressions.
    let start = (at.start + 1 + e.at).min(at.end);
    source.error(&(start..at.end), &format!("{field}: {}", e.message))
}
