//! What an agent hears of another one.
//!
//! Where links fail, its own value stands for what it does not hear, and where messages are late, any value
//! of the last steps is heard.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use num_traits::{One, Zero};

use super::super::claims::{no_agent, numbered};
use super::super::document::Loss;
use super::super::links::Topology;
use super::Rules;
use cordon_core::Rational;
use cordon_core::scalar::Polynomial;
use cordon_core::system::expression::{Expression, Meaning, SyntaxError};
use cordon_core::system::{Parameter, ParameterKind, state_names};

/// A state variable that holds the past.
pub(super) struct Past {
    /// The agent's variable that it repeats at rest.
    pub(super) source: usize,
    /// What it becomes.
    pub(super) next: Polynomial,
}

/// Which indeterminate stands for what.
pub(super) struct Layout {
    pub(super) state: Vec<String>,
    pub(super) past: Vec<Past>,
    pub(super) parameters: Vec<Parameter>,
    /// The parameter that says whether an agent acts, by agent.
    pub(super) acts: Vec<usize>,
    /// The parameter that says whether a link works, by listener and speaker.
    works: BTreeMap<(usize, usize), usize>,
    /// The parameters that say that a message is older, by listener and speaker; one a step of age.
    late: BTreeMap<(usize, usize), Vec<usize>>,
    /// The places of a variable's past values, by the place of the variable.
    before: BTreeMap<usize, Vec<usize>>,
}

impl Layout {
    pub(super) fn new(rules: &Rules<'_>, heard: &BTreeSet<(usize, usize)>) -> Self {
        let per_agent = rules.variables.len();
        let mut layout = Self {
            state: state_names(rules.count, rules.variables),
            past: Vec::new(),
            parameters: rules.constants.clone(),
            acts: Vec::new(),
            works: BTreeMap::new(),
            late: BTreeMap::new(),
            before: BTreeMap::new(),
        };
        let speakers: BTreeSet<usize> = heard.iter().map(|(_, j)| *j).collect();
        for place in speakers.iter().flat_map(|j| j * per_agent..(j + 1) * per_agent) {
            let mut before = place;
            for age in 1..=rules.delay {
                let name =
                    format!("{}ago{age}", layout.state.get(place).map_or("", String::as_str));
                layout.before.entry(place).or_default().push(layout.state.len());
                layout.past.push(Past { source: place, next: layout.symbol(before) });
                before = layout.state.len();
                layout.state.push(name);
            }
        }
        if rules.skip && !heard.is_empty() {
            layout.acts = (0..rules.count).map(|i| layout.choice(format!("acts{i}"))).collect();
        }
        for &(i, j) in heard {
            match rules.loss {
                None => {}
                Some(Loss::OneSided) => {
                    let p = layout.choice(format!("link{i}from{j}"));
                    layout.works.insert((i, j), p);
                }
                Some(Loss::Symmetric) => {
                    let p = match layout.works.get(&(j, i)) {
                        Some(&p) => p,
                        None => layout.choice(format!("link{}with{}", i.min(j), i.max(j))),
                    };
                    layout.works.insert((i, j), p);
                }
            }
            let older =
                (1..=rules.delay).map(|age| layout.choice(format!("late{age}at{i}from{j}")));
            let older = older.collect::<Vec<_>>();
            layout.late.insert((i, j), older);
        }
        layout
    }

    /// A parameter that is 0 or 1, anew in each step.
    fn choice(&mut self, name: String) -> usize {
        let (low, high) = (Rational::zero(), Rational::one());
        self.parameters.push(Parameter { name, low, high, kind: ParameterKind::Choice });
        self.parameters.len() - 1
    }

    pub(super) fn symbol(&self, place: usize) -> Polynomial {
        Polynomial::variable(u32::try_from(place).unwrap_or(u32::MAX))
    }

    pub(super) fn parameter(&self, p: usize) -> Polynomial {
        self.symbol(self.state.len() + p)
    }
}

/// The names in the rule of agent `i`.
pub(super) struct Names<'r> {
    pub(super) rules: &'r Rules<'r>,
    pub(super) layout: &'r Layout,
    pub(super) heard: &'r RefCell<BTreeSet<(usize, usize)>>,
    pub(super) i: usize,
    /// Within a sum, the neighbour and the weight of its link.
    pub(super) their: Option<(usize, &'r Rational)>,
}

impl Names<'_> {
    fn variable(&self, name: &str) -> Option<usize> {
        self.rules.variables.iter().position(|v| v.name == name)
    }

    fn own(&self, v: usize) -> Polynomial {
        self.layout.symbol(self.i * self.rules.variables.len() + v)
    }

    /// What this agent hears of variable `v` of agent `j`.
    fn of(&self, j: usize, v: usize) -> Polynomial {
        if j == self.i {
            return self.own(v);
        }
        let link = (self.i, j);
        self.heard.borrow_mut().insert(link);
        let place = j * self.rules.variables.len() + v;
        // From the oldest on: each parameter chooses between one age and what is older.
        let past = self.layout.before.get(&place).map_or(&[][..], Vec::as_slice);
        let late = self.layout.late.get(&link).map_or(&[][..], Vec::as_slice);
        let ages: Vec<Polynomial> =
            [place].iter().chain(past).map(|&p| self.layout.symbol(p)).collect();
        let mut said = ages.last().cloned().unwrap_or_default();
        for (newer, &p) in ages.iter().zip(late).rev() {
            let older = said - newer;
            said = newer.clone() + &(self.layout.parameter(p) * &older);
        }
        match self.layout.works.get(&link) {
            Some(&p) => {
                let difference = said - &self.own(v);
                self.own(v) + &(self.layout.parameter(p) * &difference)
            }
            None => said,
        }
    }

    fn of_agent(&self, j: usize, name: &str) -> std::result::Result<Polynomial, String> {
        match self.variable(name) {
            Some(v) if j < self.rules.count => Ok(self.of(j, v)),
            Some(_) => Err(no_agent(j, self.rules.count)),
            None => Err(format!("`{name}` is not a state variable")),
        }
    }
}

impl Meaning for Names<'_> {
    fn name(&self, name: &str) -> std::result::Result<Polynomial, String> {
        let whole = |n: usize| Polynomial::constant(Rational::from_integer(n.into()));
        if let Some(v) = self.variable(name) {
            return Ok(self.own(v));
        }
        if let Some(p) = self.rules.constants.iter().position(|p| p.name == name) {
            return Ok(self.layout.parameter(p));
        }
        match (name, self.their) {
            ("N", _) => return Ok(whole(self.rules.count)),
            ("i", _) => return Ok(whole(self.i)),
            ("weight", Some((_, weight))) => return Ok(Polynomial::constant(weight.clone())),
            _ => {}
        }
        match numbered(name) {
            Some((letters, j)) if self.variable(letters).is_some() => self.of_agent(j, letters),
            _ => Err(format!("`{name}` is not a state variable, parameter, `N` or `i`")),
        }
    }

    fn member(&self, owner: &str, name: &str) -> std::result::Result<Polynomial, String> {
        let step =
            match owner {
                "prev" => -1,
                "next" => 1,
                "their" => {
                    return match self.their {
                        Some((j, _)) => self.of_agent(j, name),
                        None => Err("`their` is the neighbour within `sum(..)`: expected it there"
                            .to_owned()),
                    };
                }
                other => return Err(format!("`{other}.`: expected `prev`, `next` or `their`")),
            };
        match (self.rules.links.beside(self.i, step), self.rules.links.topology) {
            (Some(j), _) => self.of_agent(j, name),
            (None, Topology::Ring) => {
                Err(format!("`{owner}`: expected a ring of two agents or more"))
            }
            (None, Topology::Line) => Err(format!(
                "agent {} has no `{owner}`: expected a rule of its own for {}",
                self.i,
                if step < 0 { "`first`" } else { "`last`" }
            )),
            _ => Err(format!(
                "`{owner}` is on a line or a ring: expected `topology = \"line\"` or `\"ring\"`"
            )),
        }
    }

    fn indexed(&self, name: &str, index: &Rational) -> std::result::Result<Polynomial, String> {
        match usize::try_from(index.to_integer()) {
            Ok(j) if index.is_integer() => self.of_agent(j, name),
            _ => Err(no_agent(index, self.rules.count)),
        }
    }

    fn sum(&self, inner: &Expression) -> std::result::Result<Polynomial, SyntaxError> {
        if self.rules.links.topology == Topology::None {
            let message = "`sum` is over neighbours: expected a key `topology`".to_owned();
            return Err(SyntaxError { at: 0, message });
        }
        let heard = self.rules.links.heard.get(self.i).map_or(&[][..], Vec::as_slice);
        heard.iter().try_fold(Polynomial::default(), |sum, (j, weight)| {
            let names = Names { their: Some((*j, weight)), ..*self };
            Ok(sum + &inner.value(&names)?)
        })
    }
}
