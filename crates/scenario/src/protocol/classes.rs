//! A protocol file for any number of agents: its rules by class, in the words of the kernel.
//!
//! Agent i's variable x is written `x(i)`, its neighbours' `x(i-1)` and `x(i+1)`, those of the ends
//! `x(0)` and `x(last)`.

use std::collections::BTreeMap;

use num_traits::{One, Zero};
use toml::Spanned;

use cordon_core::linear::feasible::Sign;
use cordon_core::scalar::{Monomial, Polynomial};
use cordon_core::system::expression::{Expression, Meaning, Words, comparisons};
use cordon_core::system::{Parameter, ParameterKind, Variable};
use cordon_core::{Rational, Result};

use super::ProtocolFile;
use super::claims::numbered;
use super::document::RuleTable;
use super::links::{Links, Topology};
use super::rules::text;
use crate::scenario::file::Source;

/// A protocol of any number N >= 3 of agents on a line or a ring. Agent i's variable x is written
/// `x(i)`, its neighbours' `x(i-1)` and `x(i+1)`, those of the ends `x(0)` and `x(last)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Family {
    /// Whether the last agent and the first are neighbours: one class, `all`, in the place of `first`,
    /// `inner` and `last`.
    pub is_ring: bool,
    /// The variables of an agent.
    pub state: Vec<String>,
    /// Real constants, with the ends of their ranges where they have any.
    pub parameters: BTreeMap<String, [Option<Rational>; 2]>,
    /// For each class the next values of variables, like `x(i) + eps*(x(i+1) - x(i))`: of agent i
    /// and its neighbours. A variable left out keeps its value.
    pub rules: BTreeMap<String, BTreeMap<String, String>>,
    /// Literals about the parameters, like `min < max`; a file has none.
    pub given: Vec<String>,
    /// Literals assumed of the start, like `x(i) <= x(i+1)`: for every i for which there are such agents.
    pub start: Vec<String>,
    /// What is claimed of every step.
    pub claims: Vec<FamilyClaim>,
}

/// A claim about every number of agents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FamilyClaim {
    /// As it stands in the file.
    pub text: String,
    /// What it says: literals, one for each comparison of a chain; or why it is not said for every
    /// number.
    pub literals: std::result::Result<Vec<String>, String>,
}

/// Why a file says nothing for every number of agents at once, in words; or the family.
pub type Reading = std::result::Result<Family, String>;

impl ProtocolFile {
    /// The family of the file, if it is about a line or a ring without departures, with one rule a class;
    /// `parameters` are the file's own, or narrower.
    ///
    /// # Errors
    /// A variable or the topology is wrong.
    pub fn family(&self, parameters: &[Parameter]) -> Result<Reading> {
        let source = Source { name: &self.name, text: &self.text };
        let variables = self.document.variables(&source)?;
        let links = self.document.links(&source, self.agents.fewest().max(3))?;
        Ok(self.read_family(&variables, parameters, &links))
    }

    fn read_family(
        &self,
        variables: &[Variable],
        parameters: &[Parameter],
        links: &Links,
    ) -> Reading {
        let doc = &self.document;
        let departs = doc.departures.skips()
            || doc.departures.loss.is_some()
            || doc.departures.delay.as_ref().is_some_and(|d| *d.get_ref() > 0);
        if departs || !doc.modes.is_empty() {
            return Err("departures and modes are decided for one number of agents".to_owned());
        }
        if let Some(p) = parameters.iter().find(|p| p.kind != ParameterKind::Constant) {
            return Err(format!("`{}` varies: decided for one number of agents", p.name));
        }
        let is_ring = match links.topology {
            Topology::Line => false,
            Topology::Ring => true,
            _ => return Err("the topology is neither a line nor a ring".to_owned()),
        };
        let empty = RuleTable::new();
        let rules = doc.rules.as_ref().map_or(&empty, Spanned::get_ref);
        let classes: &[&str] = if is_ring { &["all"] } else { &["first", "inner", "last"] };
        if let Some(key) =
            rules.keys().find(|k| k.get_ref() != "all" && !classes.contains(&k.get_ref().as_str()))
        {
            return Err(format!("`rules.{}` is about single agents", key.get_ref()));
        }
        let about = |class| About { variables, parameters, class: Some(class), is_ring };
        let mut found = BTreeMap::new();
        for &class in classes {
            let named = |name: &str| rules.iter().find(|(key, _)| key.get_ref() == name);
            let Some((_, value)) = named(class).or_else(|| named("all")) else {
                return Err(format!("no rule for `{class}`"));
            };
            let mut next = BTreeMap::new();
            for v in variables {
                let written = match value.get_ref() {
                    toml::Value::Table(table) => table.get(&v.name).cloned(),
                    single => Some(single.clone()),
                };
                let Some(written) = written.as_ref().and_then(text) else { continue };
                let rule = Expression::parse(&written).map_err(|e| e.message)?;
                next.insert(v.name.clone(), rule.written(&about(class)).map_err(|e| e.message)?);
            }
            found.insert(class.to_owned(), next);
        }
        let about = About { variables, parameters, class: None, is_ring };
        let mut claims = Vec::new();
        for claim in &doc.claims {
            claims.push(match claim.get_ref() {
                toml::Value::String(text) => {
                    FamilyClaim { text: text.clone(), literals: about.literals(text) }
                }
                certain => FamilyClaim {
                    text: certain.to_string(),
                    literals: Err("claims about certain steps are decided for one number of \
                                   agents"
                        .to_owned()),
                },
            });
        }
        let start = match &doc.start {
            None => claims.iter().flat_map(|c| c.literals.iter().flatten().cloned()).collect(),
            Some(list) => {
                let mut starts = Vec::new();
                for text in list {
                    starts.extend(about.literals(text.get_ref())?);
                }
                starts
            }
        };
        if claims.is_empty() {
            return Err("convergence is decided for one number of agents".to_owned());
        }
        let state = variables.iter().map(|v| v.name.clone()).collect();
        let range = |p: &Parameter| (p.name.clone(), [Some(p.low.clone()), Some(p.high.clone())]);
        let parameters = parameters.iter().map(range).collect();
        let given = Vec::new();
        Ok(Family { is_ring, state, parameters, rules: found, given, start, claims })
    }
}

/// The names of a rule of a class, or of a claim.
struct About<'d> {
    variables: &'d [Variable],
    parameters: &'d [Parameter],
    class: Option<&'d str>,
    is_ring: bool,
}

impl About<'_> {
    fn variable(&self, name: &str, agent: &str) -> std::result::Result<String, String> {
        if self.variables.iter().any(|v| v.name == name) {
            Ok(format!("{name}({agent})"))
        } else {
            Err(format!("`{name}` is not said for every number of agents"))
        }
    }

    /// The agent beside those of the class, where every one has it.
    fn beside(&self, owner: &str) -> Option<&'static str> {
        match (owner, self.class) {
            ("prev", Some("first")) | ("next", Some("last")) if !self.is_ring => None,
            ("prev", Some(_)) => Some("i-1"),
            ("next", Some(_)) => Some("i+1"),
            _ => None,
        }
    }

    fn literals(&self, text: &str) -> std::result::Result<Vec<String>, String> {
        let mut literals = Vec::new();
        for c in comparisons(text).map_err(|e| e.message)? {
            let greater = c.greater.written(self).map_err(|e| e.message)?;
            let less = c.less.written(self).map_err(|e| e.message)?;
            let sign = match c.relation {
                Sign::Positive => ">",
                Sign::NonNegative => ">=",
                Sign::Zero => "=",
            };
            literals.push(format!("{greater} {sign} {less}"));
        }
        Ok(literals)
    }
}

impl Words for About<'_> {
    fn name(&self, name: &str) -> std::result::Result<String, String> {
        if self.parameters.iter().any(|p| p.name == name) {
            return Ok(name.to_owned());
        }
        match numbered(name) {
            Some((letters, agent)) => self.variable(letters, &agent.to_string()),
            None => self.variable(name, "i"),
        }
    }

    fn member(&self, owner: &str, name: &str) -> std::result::Result<String, String> {
        match self.beside(owner) {
            Some(agent) => self.variable(name, agent),
            None => Err(format!("`{owner}.{name}` is not there for every agent")),
        }
    }

    fn indexed(&self, name: &str, index: &Expression) -> std::result::Result<String, String> {
        let place = index.value(&Index).map_err(|e| e.message)?;
        let coefficient = |v: u32| {
            place
                .terms()
                .find(|(m, _)| m.powers().eq([(v, 1)]))
                .map(|(_, c)| c.clone())
                .unwrap_or_default()
        };
        let offset = place.coefficient(&Monomial::default());
        let linear = place.terms().all(|(m, _)| m.degree() <= 1);
        let (i, count) = (coefficient(0), coefficient(1));
        let agent = match (i.is_one(), i.is_zero(), count.is_one(), count.is_zero()) {
            (true, _, _, true) => signed("i", &offset),
            // N - 1 is the last.
            (_, true, true, _) => signed("last", &(offset.clone() + Rational::one())),
            (_, true, _, true) => offset.to_string(),
            _ => return Err(format!("`{name}[..]`: expected `i`, `N` or a number, and an offset")),
        };
        if !linear || !offset.is_integer() {
            return Err(format!("`{name}[..]`: expected `i`, `N` or a number, and an offset"));
        }
        self.variable(name, &agent)
    }

    fn sum(&self, inner: &Expression) -> std::result::Result<String, String> {
        let sides = ["prev", "next"].into_iter().filter_map(|owner| self.beside(owner));
        let terms =
            sides.map(|agent| inner.written(&Their { about: self, agent }).map_err(|e| e.message));
        let terms = terms.collect::<std::result::Result<Vec<_>, _>>()?;
        if terms.is_empty() { Ok("0".to_owned()) } else { Ok(format!("({})", terms.join(" + "))) }
    }
}

fn signed(base: &str, offset: &Rational) -> String {
    if offset.is_zero() {
        base.to_owned()
    } else if *offset > Rational::zero() {
        format!("{base}+{offset}")
    } else {
        format!("{base}{offset}")
    }
}

/// The names of an index: `i` and `N`.
struct Index;

impl Meaning for Index {
    fn name(&self, name: &str) -> std::result::Result<Polynomial, String> {
        match name {
            "i" => Ok(Polynomial::variable(0)),
            "N" => Ok(Polynomial::variable(1)),
            _ => Err(format!("`{name}`: expected `i`, `N` or a number")),
        }
    }
}

/// Within a sum, the neighbour.
struct Their<'a> {
    about: &'a About<'a>,
    agent: &'static str,
}

impl Words for Their<'_> {
    fn name(&self, name: &str) -> std::result::Result<String, String> {
        if name == "weight" { Ok("1".to_owned()) } else { self.about.name(name) }
    }

    fn member(&self, owner: &str, name: &str) -> std::result::Result<String, String> {
        if owner == "their" {
            self.about.variable(name, self.agent)
        } else {
            self.about.member(owner, name)
        }
    }

    fn indexed(&self, name: &str, index: &Expression) -> std::result::Result<String, String> {
        self.about.indexed(name, index)
    }

    fn sum(&self, _: &Expression) -> std::result::Result<String, String> {
        Err("a sum within a sum".to_owned())
    }
}
