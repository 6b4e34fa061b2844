//! The run of a protocol file: every parameter has a value, and every choice is made.

use std::collections::BTreeMap;

use num_bigint::BigInt;

use cordon_core::exact::fraction;
use cordon_core::random::SplitMix;
use cordon_core::system::{Map, Parameter, ParameterKind, Schedule, System};
use cordon_core::text::cut;
use cordon_core::{Error, Rational, Result};

/// A system to run: its parameters have values, and the choices left open in a step are made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Own {
    /// The path of the protocol file, as given.
    pub file: String,
    /// The file's text.
    pub text: String,
    /// The system, with the ranges of the file.
    pub system: System,
    /// Seed for the choices of every step. Without a seed all links work, all agents act, no message is
    /// late, and of several modes that may act in a step the first one does.
    pub seed: Option<u64>,
    /// The parameters' values; `None` where one is chosen in each step.
    values: Vec<Option<Rational>>,
}

/// A varying parameter is drawn from the multiples of this fraction of its range.
const PARTS: u64 = 8;

impl Own {
    /// The system with these values for some of its parameters, by name; `file` is the name and text of
    /// its file.
    ///
    /// # Errors
    /// A name that no parameter has, a value for a choice that is neither of its ends, or a parameter
    /// without a value.
    pub fn new(
        (file, text): (String, String),
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
        Ok(Self { file, text, system, seed, values })
    }

    /// The names of the agents' variables, agent by agent: the columns of a trace.
    pub fn columns(&self) -> &[String] {
        let now = self.system.state.len() - self.system.past.len();
        self.system.state.get(..now).unwrap_or_default()
    }

    /// The value of a parameter that is constant in the run.
    pub fn value(&self, name: &str) -> Option<&Rational> {
        let index = self.system.parameters.iter().position(|p| p.name == name)?;
        self.values.get(index)?.as_ref()
    }

    /// Sets the parameter with this index among the [`constants`](Self::constants).
    pub fn set(&mut self, index: usize, value: Rational) {
        let places = self.system.parameters.iter().zip(&mut self.values);
        let mut constants =
            places.filter(|(p, old)| p.kind != ParameterKind::Choice && old.is_some());
        if let Some((_, old)) = constants.nth(index) {
            *old = Some(value);
        }
    }

    /// The parameters that are declared constant.
    pub fn constants(&self) -> impl Iterator<Item = (&Parameter, &Rational)> {
        self.values().filter(|(p, _)| p.kind != ParameterKind::Choice)
    }

    /// The parameters that have one value in all steps.
    pub fn values(&self) -> impl Iterator<Item = (&Parameter, &Rational)> {
        let pairs = self.system.parameters.iter().zip(&self.values);
        pairs.filter_map(|(p, value)| Some((p, value.as_ref()?)))
    }

    /// Whether a step leaves a choice open.
    pub fn has_choices(&self) -> bool {
        self.values.contains(&None) || self.has_free_modes()
    }

    /// Whether the choices that a step leaves open are drawn at random.
    pub fn is_drawn(&self) -> bool {
        self.seed.is_some() && self.has_choices()
    }

    /// Whether any of several modes may act in a step.
    fn has_free_modes(&self) -> bool {
        self.system.schedule == Schedule::Any && self.system.modes.len() > 1
    }

    /// How open choices are made, in words; `None` where there are none.
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

    /// The mode that acts in step `k >= 1`, and the values of the parameters in it.
    fn choice(&self, k: u64) -> (usize, Vec<Rational>) {
        let before = k.saturating_sub(1);
        let draws = self.system.parameters.len() as u64 + 1;
        let mut random = self.seed.map(|seed| SplitMix::after(seed, before.wrapping_mul(draws)));
        // One draw for the mode and one for each parameter, used or not.
        let mode = random.as_mut().map_or(0, |r| r.below(self.system.modes.len() as u64));
        let mode = match &self.system.schedule {
            // Below the number of modes.
            Schedule::Any => mode as usize,
            Schedule::Cycle(list) => {
                let index = before % (list.len() as u64).max(1);
                list.get(index as usize).copied().unwrap_or(0)
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
                    let part = BigInt::from((u128::from(bits) * u128::from(PARTS + 1)) >> 64);
                    let part = Rational::new(part, PARTS.into());
                    &p.low + (&p.high - &p.low) * part
                }
            }
        };
        let values = self.system.parameters.iter().zip(&self.values).map(&mut value).collect();
        (mode, values)
    }

    /// The map of step `k >= 1`, on the whole state.
    pub fn map(&self, k: u64) -> Map {
        let (mode, values) = self.choice(k);
        self.system.modes.get(mode).map_or(Map { rows: Vec::new() }, |m| m.at(&values))
    }

    /// The maps that act in turn; `None` where choices are drawn.
    pub fn cycle(&self) -> Option<Vec<Map>> {
        if self.is_drawn() {
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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::scenario::{Scenario, parse, read};

    fn q(p: i64, q: u64) -> Rational {
        Rational::new(p.into(), q.into())
    }

    fn file(name: &str) -> String {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/own");
        root.join(format!("{name}.toml")).display().to_string()
    }

    fn scenario(text: &str) -> Scenario {
        parse("test", text).unwrap().finish().unwrap()
    }

    #[test]
    fn what_is_wrong_is_named() {
        let coverage = file("coverage");
        let said = |rest: &str| {
            let text = format!("protocol = '{coverage}'\n{rest}");
            parse("test", &text).unwrap().finish().unwrap_err().to_string()
        };
        let start = "start = [0, 0.5, 1]\n";
        for (rest, wanted) in [
            (start.to_owned(), "parameters.eps: `0..1/2`: expected one value"),
            (format!("{start}weight = 1\n[parameters]\ngain = 2"), "parameters.gain: no parameter"),
            (format!("{start}weight = 1\n[parameters]\neps = 2"), "given as weight too"),
            (format!("{start}weight = 1\nmin = 0"), "min: not a field"),
            ("weight = 1\nspread_to = 4\nmax = 1".to_owned(), "not a field"),
            ("weight = 1".to_owned(), "start (x0,x1 and so on) is missing"),
            (
                "start = [0, 1]\nweight = 1".to_owned(),
                "2 numbers given: expected 1 for each of 3 agents",
            ),
            (
                format!("{start}drones = 4\nweight = 1"),
                "3 numbers given: expected 1 for each of 4 agents",
            ),
        ] {
            assert!(said(&rest).contains(wanted), "{rest}: {}", said(&rest));
        }
        let twin = format!("protocol = '{coverage}'\n{start}[parameters]\neps = \"1/4\"");
        let accepted = scenario(&twin);
        assert_eq!(accepted.weight, q(1, 4));
        let platoon = format!("protocol = '{}'\nstart = [0, 1]", file("platoon"));
        let said = parse("test", &platoon).unwrap().finish().unwrap_err().to_string();
        assert!(said.contains("2 numbers given: expected 2 for each of 5 agents"), "{said}");
        // Relative to the scenario file, wherever the program runs.
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios");
        let beside = folder.join("own-flight.toml");
        let text = "protocol = \"own/coverage.toml\"\nstart = [0, 1, 3]\nweight = 0.1";
        let found = parse(&beside.display().to_string(), text).unwrap().protocol.unwrap();
        assert!(found.ends_with("scenarios/own/coverage.toml"), "{found}");
        assert!(read(Path::new("no-such.toml")).is_err());
    }
}
