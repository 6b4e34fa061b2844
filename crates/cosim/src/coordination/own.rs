//! One drone's share of a protocol file: the rows of its own variables.

use std::collections::BTreeSet;

use cordon_spec::{Phase, Scalar};
use num_traits::Zero;

use super::Law;
use crate::quotient::Quotient;
use crate::unit::Value;
use cordon_core::system::{Map, System};
use cordon_core::{Error, Rational, Result};
use cordon_run::scenario::Own;

/// The state variable along which drones fly, in m.
const POSITION: &str = "x";

/// What a protocol file has one drone do: the same in every step, or rules in turn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OwnLaw {
    /// Names of an agent's state variables.
    pub variables: Vec<String>,
    /// Which of them is the position.
    pub position: usize,
    /// The drone's own variables at the start.
    pub start: Vec<Rational>,
    /// What it hears: of whom, which variable; in the order of its inputs.
    pub heard: Vec<(usize, usize)>,
    /// Of each update in turn a row for each variable: the constant, coefficients of the own
    /// variables, coefficients of what is heard.
    pub updates: Vec<Vec<[Vec<Rational>; 3]>>,
}

impl OwnLaw {
    /// The share of a drone. Where the protocol leaves choices, every link works, every drone acts
    /// and no message is late: what goes wrong in a flight, its faults say.
    pub fn of(own: &Own, start: &[Rational], drone: usize) -> Self {
        let variables: Vec<String> = names(&own.system);
        let per_agent = variables.len();
        let own_places = drone * per_agent..(drone + 1) * per_agent;
        let maps = own.cycle().unwrap_or_default();
        let rows = |map: &Map| map.rows.get(own_places.clone()).unwrap_or_default().to_vec();
        let maps: Vec<_> = maps.iter().map(rows).collect();
        let columns = maps.iter().flatten().flat_map(|(_, row)| row.iter().map(|(j, _)| *j));
        let others: BTreeSet<usize> = columns.filter(|j| !own_places.contains(j)).collect();
        let coefficient = |row: &[(usize, Rational)], column: usize| {
            let found = row.iter().find(|(j, _)| *j == column);
            found.map_or_else(Rational::zero, |(_, a)| a.clone())
        };
        let update = |rows: &Vec<(Rational, Vec<(usize, Rational)>)>| {
            let of = |(constant, row): &(Rational, Vec<(usize, Rational)>)| {
                let own = own_places.clone().map(|j| coefficient(row, j)).collect();
                let heard = others.iter().map(|&j| coefficient(row, j)).collect();
                [vec![constant.clone()], own, heard]
            };
            rows.iter().map(of).collect()
        };
        Self {
            position: position_of(&own.system),
            start: start.get(own_places.clone()).unwrap_or_default().to_vec(),
            heard: others.iter().map(|j| (j / per_agent, j % per_agent)).collect(),
            updates: maps.iter().map(update).collect(),
            variables,
        }
    }

    /// The name of the input at which variable `v` of drone `j` is heard.
    pub fn input(&self, j: usize, v: usize) -> String {
        match self.variables.get(v).filter(|_| v != self.position) {
            Some(name) => format!("heard_{j}_{name}"),
            None => format!("heard_{j}"),
        }
    }
}

impl Law {
    /// Whether input `i` is a position.
    pub(super) fn hears_position(&self, i: usize) -> bool {
        match self {
            Self::Own(law) => law.heard.get(i).is_none_or(|(_, v)| *v == law.position),
            _ => true,
        }
    }
}

fn names(system: &System) -> Vec<String> {
    system.variables.iter().map(|v| v.name.clone()).collect()
}

/// Which variable of an agent is its position: `x`, or the only one.
fn position_of(system: &System) -> usize {
    system.variables.iter().position(|v| v.name == POSITION).unwrap_or(0)
}

/// The position of a drone at the start.
pub(crate) fn position(own: &Own, start: &[Rational], drone: usize) -> Rational {
    let place = drone * own.system.variables.len() + position_of(&own.system);
    start.get(place).cloned().unwrap_or_default()
}

/// Refuses protocols that no drone can fly.
///
/// # Errors
/// No variable `x`; or `y`, across the line along which drones fly.
pub(crate) fn refuse_what_cannot_fly(own: &Own) -> Result<()> {
    let names = names(&own.system);
    let fail = |expected: &str| {
        Err(Error::input(format!(
            "protocol: `{}`: state `{}`: expected {expected}",
            own.file,
            names.join(", ")
        )))
    };
    if names.len() > 1 && !names.iter().any(|name| name == POSITION) {
        return fail("a variable `x`, the position along which drones fly");
    }
    if names.iter().any(|name| name == "y" || name == "z") {
        return fail("no `y` and `z`: drones fly along x only, where they would meet that do not");
    }
    Ok(())
}

/// The machine that a drone is, by a protocol file.
#[derive(Clone, Debug)]
pub(super) struct OwnMachine {
    law: OwnLaw,
    limit: u32,
    /// Ticks since the last update.
    pub counter: u32,
    /// Updates so far.
    updates: u64,
    /// The drone's own variables.
    pub state: Vec<Quotient>,
    /// They, before the last update.
    before: Vec<Quotient>,
}

impl OwnMachine {
    pub fn new(law: &OwnLaw, position: Quotient, limit: u32, phase: Phase) -> Self {
        let mut state: Vec<Quotient> = law.start.iter().map(Quotient::from).collect();
        if let Some(place) = state.get_mut(law.position) {
            *place = position;
        }
        let counter = match phase {
            Phase::First => limit,
            Phase::Last => 0,
        };
        Self { law: law.clone(), limit, counter, updates: 0, before: state.clone(), state }
    }

    pub fn fires(&self) -> bool {
        self.counter == self.limit
    }

    /// One tick; the new position. `heard` is read where the tick is an update.
    pub fn tick(&mut self, heard: &[Quotient]) -> Option<Quotient> {
        if !self.fires() {
            self.counter += 1;
            return self.state.get(self.law.position).cloned();
        }
        self.counter = 0;
        let turn = self.updates % (self.law.updates.len() as u64).max(1);
        let rows = self.law.updates.get(turn as usize).map_or(&[][..], Vec::as_slice);
        let row = |[constant, own, others]: &[Vec<Rational>; 3]| {
            let constant = constant.iter().map(Quotient::from).next();
            let inputs = own.iter().zip(&self.state).chain(others.iter().zip(heard));
            inputs
                .filter(|(a, _)| !a.is_zero())
                .fold(constant.unwrap_or_else(|| Quotient::from_int(0)), |sum, (a, x)| {
                    sum + &(Quotient::from(a) * x)
                })
        };
        let next = rows.iter().map(row).collect();
        self.before = std::mem::replace(&mut self.state, next);
        self.updates += 1;
        self.state.get(self.law.position).cloned()
    }

    /// Undoes the last update of every variable: it was skipped.
    pub fn put_back(&mut self, own: Quotient) {
        self.state = self.before.clone();
        if let Some(place) = self.state.get_mut(self.law.position) {
            *place = own;
        }
    }

    /// The updates so far, and all variables.
    pub fn memory(&self) -> Vec<Value> {
        let updates = Value::Integer(i64::try_from(self.updates).unwrap_or(i64::MAX));
        let state = self.state.iter().map(|x| Value::Exact(x.clone()));
        std::iter::once(updates).chain(state).collect()
    }

    /// Takes up what was remembered; whether it could.
    pub fn recall(&mut self, memory: &[Value]) -> bool {
        let [Value::Integer(updates), state @ ..] = memory else { return false };
        let numbers = state.iter().map(|value| match value {
            Value::Exact(x) => Some(x.clone()),
            _ => None,
        });
        let numbers: Option<Vec<Quotient>> = numbers.collect();
        match (u64::try_from(*updates), numbers) {
            (Ok(updates), Some(state)) if state.len() == self.state.len() => {
                (self.updates, self.before) = (updates, state.clone());
                self.state = state;
                true
            }
            _ => false,
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use std::path::Path;

    use crate::cosimulation::Cosimulation;
    use crate::run::run;
    use cordon_core::exact;
    use cordon_run::scenario::{Flight, Scenario, parse};
    use cordon_run::simulate;

    fn scenario(protocol: &str, rest: &str) -> Scenario {
        let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/own");
        let protocol = match protocol {
            "coverage" => protocol.to_owned(),
            file => own.join(file).display().to_string(),
        };
        let text = format!("protocol = '{protocol}'\ntau = 0.05\n{rest}");
        parse("test", &text).unwrap().finish().unwrap()
    }

    fn flown(scenario: &Scenario) -> Vec<f64> {
        let flight = Flight { duration: Some(2.into_rational()), ..Flight::default() };
        run(&Cosimulation::new(scenario.clone(), flight).unwrap()).unwrap().desired
    }

    trait IntoRational {
        fn into_rational(self) -> cordon_core::Rational;
    }

    impl IntoRational for i32 {
        fn into_rational(self) -> cordon_core::Rational {
            cordon_core::Rational::from_integer(self.into())
        }
    }

    /// Units that hear each other compute the global run: with one variable, with several, with the
    /// first update late; and coverage as a file flies as coverage does.
    #[test]
    fn units_fly_the_global_run() {
        let platoon = "start = [0, 0, 0.25, 0, -0.25, 0, 0.25, 0, 0, 0]\nperiod = 2";
        let coverage = "start = [0, 0.1, 0.2, 0.3, 1]\nweight = 0.2\nperiod = 4\nphase = \"last\"";
        let digraph = "start = [0, 1, 2, 3, 10]\nweight = 0.2";
        let mut compared = 0;
        for (file, rest, variables) in [
            ("platoon.toml", platoon, 2),
            ("coverage.toml", coverage, 1),
            ("digraph.toml", digraph, 1),
        ] {
            let s = scenario(file, rest);
            let desired = flown(&s);
            for (row, snapshot) in desired.chunks(5).zip(simulate::run(&s)) {
                let wanted = snapshot.state.drones.iter().step_by(variables).map(exact::to_f64);
                assert_eq!(row, wanted.collect::<Vec<_>>(), "{file}, tick {}", snapshot.tick);
                compared += 1;
            }
        }
        assert_eq!(compared, 3 * 41);
        let (own, built_in) = (scenario("coverage.toml", coverage), scenario("coverage", coverage));
        assert_eq!(flown(&own), flown(&built_in));
    }

    #[test]
    fn what_cannot_fly_is_named() {
        let start: Vec<String> = (0..32).map(|i| i.to_string()).collect();
        let s = scenario("grid.toml", &format!("start = [{}]\nweight = 0.2", start.join(", ")));
        let said = Cosimulation::new(s, Flight::default()).unwrap_err().to_string();
        assert!(said.contains("state `x, y`: expected no `y`"), "{said}");
    }
}
