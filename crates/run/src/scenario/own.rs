//! An own protocol in a run: every parameter has a value, and every choice is made.

use std::collections::BTreeMap;

use num_bigint::BigInt;

use cordon_core::exact::fraction;
use cordon_core::random::SplitMix;
use cordon_core::system::{Map, Parameter, ParameterKind, Schedule, System};
use cordon_core::text::cut;
use cordon_core::{Error, Rational, Result};

/// A system that runs: its parameters have values, and what it leaves open in a step is chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Own {
    /// The protocol file, as it was named.
    pub file: String,
    /// The system, its ranges as the file has them.
    pub system: System,
    /// Draws the choices of every step. Without a seed all links work, all agents act, no message
    /// is late, and of several modes that may act in any step the first one does.
    pub seed: Option<u64>,
    /// The parameters' values; `None` where one is chosen anew in each step.
    values: Vec<Option<Rational>>,
}

/// A parameter that varies is drawn from the multiples of this part of its range.
const PARTS: u64 = 8;

impl Own {
    /// The system with these values for some of its parameters, by name.
    ///
    /// # Errors
    /// A name that no parameter has, a value for a choice that is neither end of it, and a parameter
    /// that is left without a value.
    pub fn new(
        file: String,
        system: System,
        given: &BTreeMap<String, Rational>,
        seed: Option<u64>,
    ) -> Result<Self> {
        if let Some(name) = given.keys().find(|n| system.parameters.iter().all(|p| p.name != **n)) {
            let known: Vec<_> = system.parameters.iter().map(|p| p.name.as_str()).collect();
            let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
            return Err(Error::input(format!(
                "parameters.{name}: no parameter of `{file}`: expected one of {}",
                cut(&known, 120)
            )));
        }
        let value = |p: &Parameter| match (given.get(&p.name), p.kind) {
            (Some(x), ParameterKind::Choice) if !p.ends().contains(x) => {
                Err(Error::input(format!(
                    "parameters.{}: `{}`: expected {} or {}",
                    p.name,
                    fraction(x),
                    fraction(&p.low),
                    fraction(&p.high)
                )))
            }
            (Some(x), _) => Ok(Some(x.clone())),
            (None, ParameterKind::Choice) => Ok(None),
            (None, ParameterKind::Varying) if seed.is_some() => Ok(None),
            (None, kind) => match p.fixed() {
                Some(x) => Ok(Some(x.clone())),
                None => Err(open(p, kind)),
            },
        };
        let values = system.parameters.iter().map(value).collect::<Result<_>>()?;
        Ok(Self { file, system, seed, values })
    }

    /// The names of the agents' variables, agent by agent: what a row of a trace has.
    pub fn columns(&self) -> &[String] {
        let now = self.system.state.len() - self.system.past.len();
        self.system.state.get(..now).unwrap_or_default()
    }

    /// The value of a parameter that is the same in every step.
    pub fn value(&self, name: &str) -> Option<&Rational> {
        let place = self.system.parameters.iter().position(|p| p.name == name)?;
        self.values.get(place)?.as_ref()
    }

    /// The parameters that have one value in all steps.
    pub fn values(&self) -> impl Iterator<Item = (&Parameter, &Rational)> {
        let pairs = self.system.parameters.iter().zip(&self.values);
        pairs.filter_map(|(p, value)| Some((p, value.as_ref()?)))
    }

    /// Whether a step leaves something to choose.
    pub fn has_choices(&self) -> bool {
        self.values.contains(&None) || self.has_free_modes()
    }

    /// Whether any of several modes may act in a step.
    fn has_free_modes(&self) -> bool {
        self.system.schedule == Schedule::Any && self.system.modes.len() > 1
    }

    /// How the run chooses what the protocol leaves open, in words; `None` where it leaves nothing.
    pub fn choices(&self) -> Option<String> {
        if !self.has_choices() {
            return None;
        }
        if let Some(seed) = self.seed {
            return Some(format!("choices drawn from --seed {seed}"));
        }
        let left = self.system.parameters.iter().zip(&self.values).filter(|(_, v)| v.is_none());
        let left: Vec<&str> = left.map(|(p, _)| p.name.as_str()).collect();
        let any = |prefix: &str| left.iter().any(|name| name.starts_with(prefix));
        let mode = self.system.modes.first().filter(|_| self.has_free_modes());
        let said: Vec<String> = [
            any("acts").then(|| "all agents act".to_owned()),
            any("link").then(|| "all links work".to_owned()),
            any("late").then(|| "no message is late".to_owned()),
            mode.map(|m| format!("mode `{}` acts in every step", m.name)),
        ]
        .into_iter()
        .flatten()
        .collect();
        Some(said.join(", "))
    }

    /// Which mode acts in step `k >= 1`, and the values of the parameters in it.
    fn choice(&self, k: u64) -> (usize, Vec<Rational>) {
        let before = k.saturating_sub(1);
        let draws = self.system.parameters.len() as u64 + 1;
        let mut random = self.seed.map(|seed| SplitMix::after(seed, before.wrapping_mul(draws)));
        // A draw for the mode and for each parameter, used or not.
        let mode = random.as_mut().map_or(0, |r| r.below(self.system.modes.len() as u64));
        let mode = match &self.system.schedule {
            // Below the number of modes.
            Schedule::Any => mode as usize,
            Schedule::Cycle(list) => {
                let place = before % (list.len() as u64).max(1);
                list.get(place as usize).copied().unwrap_or(0)
            }
        };
        let mut value = |(p, value): (&Parameter, &Option<Rational>)| {
            let bits = random.as_mut().map(SplitMix::bits);
            match (value, bits) {
                (Some(x), _) => x.clone(),
                (None, None) => p.usual().clone(),
                (None, Some(bits)) if p.kind == ParameterKind::Choice => {
                    if bits >> 63 == 0 {
                        p.low.clone()
                    } else {
                        p.high.clone()
                    }
                }
                (None, Some(bits)) => {
                    let part = BigInt::from(u128::from(bits) * u128::from(PARTS + 1) >> 64);
                    let part = Rational::new(part, PARTS.into());
                    &p.low + (&p.high - &p.low) * part
                }
            }
        };
        let values = self.system.parameters.iter().zip(&self.values).map(&mut value).collect();
        (mode, values)
    }

    /// The map that step `k >= 1` is, on the whole state.
    pub fn map(&self, k: u64) -> Map {
        let (mode, values) = self.choice(k);
        self.system.modes.get(mode).map_or(Map { rows: Vec::new() }, |m| m.at(&values))
    }

    /// The maps that act in turn, for ever; `None` where choices are drawn.
    pub fn cycle(&self) -> Option<Vec<Map>> {
        if self.seed.is_some() && self.has_choices() {
            return None;
        }
        let length = match &self.system.schedule {
            Schedule::Any => 1,
            Schedule::Cycle(list) => list.len() as u64,
        };
        Some((1..=length).map(|k| self.map(k)).collect())
    }
}

fn open(p: &Parameter, kind: ParameterKind) -> Error {
    let middle = (&p.low + &p.high) / Rational::from_integer(2.into());
    let (low, high, middle) = (fraction(&p.low), fraction(&p.high), fraction(&middle));
    let (name, seed) =
        (&p.name, if kind == ParameterKind::Varying { ", or `--seed S`" } else { "" });
    Error::input(format!(
        "parameters.{name}: `{low}..{high}`: expected one value in a run, like `--set {name}={middle}`{seed}"
    ))
}
