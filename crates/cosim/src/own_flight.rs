//! Whether drones can fly a protocol file, and where they are at its start.

use crate::coordination::own::{POSITION, position_of};
use cordon_core::system::System;
use cordon_core::{Error, Rational, Result};
use cordon_run::scenario::Own;

fn names(system: &System) -> Vec<String> {
    system.variables.iter().map(|v| v.name.clone()).collect()
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
