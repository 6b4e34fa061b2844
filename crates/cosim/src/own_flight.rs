//! What a protocol file has each drone of a flight do, and whether it can fly.

use std::collections::BTreeSet;

use num_traits::Zero;

use crate::coordination::OwnLaw;
use cordon_core::system::{Map, System};
use cordon_core::{Error, Rational, Result};
use cordon_run::scenario::Own;

/// The state variable along which drones fly, in m.
const POSITION: &str = "x";

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
