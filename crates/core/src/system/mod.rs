//! A system: all that the engines need to know about a co-ordination protocol.
//!
//! Agents, each with one or more state variables; parameters with their ranges; one or more modes, each
//! an affine map of the state whose coefficients are polynomials in the parameters, of degree at most
//! one in each; which modes may follow each other; what is assumed of the start and claimed of a run. A
//! system comes from one of the spec's protocols, from a protocol file (`cordon_run::protocol`), or
//! from a Rust type ([`Protocol`]). In each case its coefficients are read off by executing the step
//! once, on polynomials ([`Mode::executed`]).

pub mod expression;
mod flow;
mod map;
mod mode;
mod protocol;

pub use flow::{Flow, Switching};
pub use map::Map;
pub use mode::Mode;
pub use protocol::{Consensus, Coverage, Protocol};

use num_traits::Zero;

use crate::exact::shortened;
use crate::scalar::Polynomial;
use crate::{Error, Rational};
use expression::{Meaning, SyntaxError, comparisons};

use crate::linear::affine::Affine;
use crate::linear::feasible::{Constraint, Sign};

/// Most state variables of a system, those that hold the past included: the limit of a certificate.
pub const MOST_VARIABLES: usize = 600;

/// A state variable that every agent has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Its name; with the agent's number it names a variable of the state (`x`, `x0`).
    pub name: String,
    /// Its physical unit, for display.
    pub unit: Option<String>,
}

/// A number that the protocol does not fix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Its name in expressions.
    pub name: String,
    /// Lower end of its range.
    pub low: Rational,
    /// Upper end of its range; equal to `low` where it is fixed.
    pub high: Rational,
    /// Whether it is constant in a run or chosen again in each step.
    pub kind: ParameterKind,
}

/// How a parameter varies in a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterKind {
    /// One value in the range, the same in every step.
    Constant,
    /// Any value in the range, possibly a different one in each step: a disturbance.
    Varying,
    /// One end of the range or the other, chosen in each step: whether a message arrives, say.
    Choice,
}

impl Parameter {
    /// The value, where the range holds only one.
    pub fn fixed(&self) -> Option<&Rational> {
        (self.low == self.high).then_some(&self.low)
    }

    /// The value of a choice in normal operation: the high end (the link works, the agent acts), except
    /// for `late..` (the message is that old), where it is the low one.
    pub fn usual(&self) -> &Rational {
        if self.name.starts_with("late") { &self.low } else { &self.high }
    }

    /// The ends of the range, only one where they are equal.
    pub fn ends(&self) -> Vec<Rational> {
        match self.fixed() {
            Some(value) => vec![value.clone()],
            None => vec![self.low.clone(), self.high.clone()],
        }
    }
}

/// A comparison of an affine form in the state with 0, and how it was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Predicate {
    /// As written, for one choice of agents: `x0 < x1`.
    pub text: String,
    /// How the form compares with 0.
    pub is: Constraint,
}

/// The names of a system's state variables.
struct Names<'s>(&'s System);

impl Meaning for Names<'_> {
    fn name(&self, name: &str) -> std::result::Result<Polynomial, String> {
        match self.0.state.iter().position(|s| s == name) {
            Some(index) => Ok(Polynomial::variable(u32::try_from(index).unwrap_or(u32::MAX))),
            None => Err(format!("`{name}`: expected a state variable")),
        }
    }
}

impl Predicate {
    /// One comparison of the state variables of a system, by name: `x0 <= x1`.
    ///
    /// It is not one, or not linear in them.
    /// It is none, or not linear in them.
    pub fn parse(system: &System, text: &str) -> crate::Result<Self> {
        let wrong = |e: SyntaxError| Error::input(format!("`{}`: {}", shortened(text), e.message));
        let [comparison] = comparisons(text)
            .map_err(wrong)?
            .try_into()
            .map_err(|_| Error::input(format!("`{}`: expected one comparison", shortened(text))))?;
        let names = Names(system);
        let greater = comparison.greater.value(&names).map_err(wrong)?;
        let difference = greater - &comparison.less.value(&names).map_err(wrong)?;
        let form = difference.affine().ok_or_else(|| {
            Error::input(format!("`{}`: expected no product of state variables", shortened(text)))
        })?;
        Ok(Self { text: text.to_owned(), is: Constraint { form, sign: comparison.relation } })
    }

    /// The comparison as written in the file, without the agents that it was expanded for: one written
    /// comparison may stand for several.
    pub fn written(&self) -> &str {
        self.text.rsplit_once(" (i = ").map_or(self.text.as_str(), |(written, _)| written)
    }

    /// Whether it holds of a state.
    pub fn holds(&self, state: &[Rational]) -> bool {
        self.is.form.at(state).is_some_and(|value| self.is.sign.met_by(&value))
    }
}

/// What is claimed of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Claim {
    /// What has to hold in steps `from` to `until`.
    pub predicate: Predicate,
    /// The first step at which it has to hold.
    pub from: usize,
    /// The last step at which it has to hold, if there is one.
    pub until: Option<usize>,
}

impl Claim {
    /// Whether it applies to the state after `step` steps.
    pub fn is_about(&self, step: usize) -> bool {
        self.from <= step && self.until.is_none_or(|last| step <= last)
    }
}

/// Which mode acts in which step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Schedule {
    /// Any mode in any step.
    Any,
    /// The listed modes in turn, for ever.
    Cycle(Vec<usize>),
}

/// Where a run is claimed to end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Convergence {
    /// Every state variable tends to its target.
    To(Vec<Rational>),
    /// The agents' variables of one name tend to each other.
    Agreement,
}

/// A co-ordination protocol as a linear system; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct System {
    /// A title, for display.
    pub title: String,
    /// Number of agents, at least 1.
    pub agents: usize,
    /// State variables of an agent.
    pub variables: Vec<Variable>,
    /// Names of all state variables: agent by agent, then those that hold the past.
    pub state: Vec<String>,
    /// For each state variable that holds the past, the variable that it equals at rest.
    pub past: Vec<usize>,
    /// The parameters, in the order in which a step takes them.
    pub parameters: Vec<Parameter>,
    /// The modes, at least one.
    pub modes: Vec<Mode>,
    /// Which mode acts in which step.
    pub schedule: Schedule,
    /// Who hears whom, listener first, for display.
    pub links: Vec<(usize, usize)>,
    /// What is assumed of the start.
    pub starts: Vec<Predicate>,
    /// What is claimed of every run from the start set.
    pub claims: Vec<Claim>,
    /// Whether convergence is claimed, and to what.
    pub converges: Option<Convergence>,
}

impl System {
    /// The system of a protocol written as a Rust type, without assumptions or claims.
    ///
    /// # Errors
    /// The step is not affine in the state, or of a degree above one in a parameter.
    pub fn of<P: Protocol>(protocol: &P) -> crate::Result<Self> {
        let agents = protocol.agents();
        let variables: Vec<Variable> = protocol
            .variables()
            .into_iter()
            .map(|name| Variable { name: name.to_owned(), unit: None })
            .collect();
        let state = state_names(agents, &variables);
        let parameters = protocol.parameters();
        let mode = Mode::executed("step", state.len(), &parameters, |number, p, x| {
            protocol.step(&number, p, x)
        })?;
        Ok(Self {
            title: protocol.title(),
            agents,
            variables,
            past: Vec::new(),
            links: mode.links(agents, state.len() / agents.max(1)),
            state,
            parameters,
            modes: vec![mode],
            schedule: Schedule::Any,
            starts: Vec::new(),
            claims: Vec::new(),
            converges: None,
        })
    }

    /// Every state variable as the variable of a form.
    pub fn forms(&self) -> Vec<Affine> {
        (0..self.state.len()).map(Affine::variable).collect()
    }

    /// The assumptions on the start; variables that hold the past start at rest.
    pub fn start_constraints(&self) -> Vec<Constraint> {
        let now = self.state.len() - self.past.len();
        let rest = self.past.iter().enumerate().map(|(j, &source)| Constraint {
            form: Affine::variable(now + j) - &Affine::variable(source),
            sign: Sign::Zero,
        });
        self.starts.iter().map(|p| p.is.clone()).chain(rest).collect()
    }

    /// The assumptions as written, in order.
    pub fn written_starts(&self) -> Vec<&str> {
        let mut texts: Vec<&str> = self.starts.iter().map(Predicate::written).collect();
        texts.dedup();
        texts
    }

    /// The claims as written, in order, each with the indices of the claims that it stands for.
    pub fn written_claims(&self) -> Vec<(&str, Vec<usize>)> {
        let mut groups: Vec<(&Claim, Vec<usize>)> = Vec::new();
        for (index, claim) in self.claims.iter().enumerate() {
            let same = |c: &Claim| {
                (c.predicate.written(), c.from, c.until)
                    == (claim.predicate.written(), claim.from, claim.until)
            };
            match groups.last_mut().filter(|(first, _)| same(first)) {
                Some((_, group)) => group.push(index),
                None => groups.push((claim, vec![index])),
            }
        }
        groups.into_iter().map(|(first, places)| (first.predicate.written(), places)).collect()
    }

    /// The whole state for a start that gives every agent's variables, agent by agent, with the past at
    /// rest. `None` where the number of values is wrong.
    pub fn at_rest(&self, start: &[Rational]) -> Option<Vec<Rational>> {
        let now = self.state.len() - self.past.len();
        (start.len() == now).then(|| {
            let past = self.past.iter().filter_map(|&source| start.get(source).cloned());
            start.iter().cloned().chain(past).collect()
        })
    }

    /// A value for every parameter: its only one where it is fixed, else `choice`.
    pub fn values(&self, choice: impl Fn(&Parameter) -> Rational) -> Vec<Rational> {
        self.parameters.iter().map(|p| p.fixed().cloned().unwrap_or_else(|| choice(p))).collect()
    }

    /// The mode that acts in step `k >= 1`, where the schedule leaves no choice.
    pub fn mode_of_step(&self, k: usize) -> Option<usize> {
        match &self.schedule {
            Schedule::Any => (self.modes.len() == 1).then_some(0),
            Schedule::Cycle(list) => list.get(k.checked_sub(1)? % list.len().max(1)).copied(),
        }
    }

    /// Whether a run is determined once its constants are fixed: one mode, or modes in turn, and no
    /// parameter that varies.
    pub fn is_deterministic(&self) -> bool {
        let varies = |p: &Parameter| p.kind != ParameterKind::Constant && p.fixed().is_none();
        self.mode_of_step(1).is_some() && !self.parameters.iter().any(varies)
    }

    /// The run of a deterministic system from a whole state: `steps + 1` states.
    pub fn run(&self, values: &[Rational], start: &[Rational], steps: usize) -> Vec<Vec<Rational>> {
        let maps: Vec<Map> = self.modes.iter().map(|m| m.at(values)).collect();
        let mut run = vec![start.to_vec()];
        for k in 1..=steps {
            let next = match (self.mode_of_step(k).and_then(|m| maps.get(m)), run.last()) {
                (Some(map), Some(x)) => map.apply(x),
                _ => break,
            };
            run.push(next);
        }
        run
    }
}

/// The names of all agents' variables, agent by agent: `x0, v0, x1, v1, ...`.
pub fn state_names(agents: usize, variables: &[Variable]) -> Vec<String> {
    let of = |i: usize| variables.iter().map(move |v| format!("{}{i}", v.name));
    (0..agents).flat_map(of).collect()
}

/// An equation as two inequalities, anything else as it is.
pub fn inequalities(c: &Constraint) -> Vec<Constraint> {
    match c.sign {
        Sign::Zero => {
            let negated = Affine::constant(Rational::zero()) - &c.form;
            [c.form.clone(), negated]
                .map(|form| Constraint { form, sign: Sign::NonNegative })
                .to_vec()
        }
        Sign::Positive | Sign::NonNegative => vec![c.clone()],
    }
}
