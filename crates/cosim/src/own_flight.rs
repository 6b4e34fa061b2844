//! Whether a protocol file can be flown, and the positions of the drones at its start.

use crate::coordination::own::{POSITION, across_of, position_of};
use cordon_core::system::System;
use cordon_core::{Error, Rational, Result};
use cordon_run::scenario::Own;

fn names(system: &System) -> Vec<String> {
    system.variables.iter().map(|v| v.name.clone()).collect()
}

/// Which variable of an agent of a planar protocol is its position across the line.
pub(crate) fn across(own: &Own) -> Option<usize> {
    across_of(&own.system)
}

/// The positions of all drones at the start: along the line, and across it for planar protocols.
pub(crate) fn positions(own: &Own, start: &[Rational]) -> (Vec<Rational>, Option<Vec<Rational>>) {
    let of = |variable| {
        let places = (variable..).step_by(own.system.variables.len()).take(own.system.agents);
        places.map(|index| start.get(index).cloned().unwrap_or_default()).collect()
    };
    (of(position_of(&own.system)), across_of(&own.system).map(of))
}

/// Refuses protocols that cannot be flown.
///
/// # Errors
/// There is no variable `x`, or there is a `z`: drones hold their height.
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
    if names.iter().any(|name| name == "z") {
        return fail("no `z`: drones fly in x and y, all at one height");
    }
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use std::path::Path;

    use crate::collision::EventKind;
    use crate::cosimulation::Cosimulation;
    use crate::exact_run;
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
        run(&Cosimulation::new(scenario.clone(), flight).unwrap()).unwrap().x.desired
    }

    trait IntoRational {
        fn into_rational(self) -> cordon_core::Rational;
    }

    impl IntoRational for i32 {
        fn into_rational(self) -> cordon_core::Rational {
            cordon_core::Rational::from_integer(self.into())
        }
    }

    /// Units that hear each other compute the global run: with one variable, with several, with a late
    /// first update; and coverage written as a file flies like the built-in coverage.
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

    /// Agents on a grid of 4 by 4, 10 m apart in x and 7 m in y, that converge to one point.
    fn planar(integrator: &str, seconds: i32) -> Cosimulation {
        let start: Vec<String> =
            (0..16).flat_map(|i| [(i % 4 * 10).to_string(), (i / 4 * 7).to_string()]).collect();
        let rest = format!("start = [{}]\nweight = 0.2\nperiod = 4", start.join(", "));
        let flight = Flight {
            duration: Some(seconds.into_rational()),
            integrator: Some(integrator.to_owned()),
            ..Flight::default()
        };
        Cosimulation::new(scenario("grid.toml", &rest), flight).unwrap()
    }

    #[test]
    fn planar_protocols_fly_in_x_and_y() {
        let swarm = planar("euler", 2);
        let record = run(&swarm).unwrap();
        let y = record.y.as_ref().unwrap();
        for (row, snapshot) in simulate::run(&swarm.scenario).take(record.rows()).enumerate() {
            let wanted = |v| snapshot.state.drones.iter().skip(v).step_by(2).map(exact::to_f64);
            assert!(wanted(0).eq(record.desired_at(row).iter().copied()), "{row}");
            assert!(wanted(1).eq(record.at(&y.desired, row).iter().copied()), "{row}");
        }
        let difference = exact_run::difference(&swarm, &record).unwrap();
        assert!(difference.desired.size < 1e-14, "{difference}");
        assert!(difference.actual.size < 1e-11, "{difference}");
    }

    /// Events are found exactly when the centres come within two arms' length, with either integrator.
    #[test]
    fn collisions_are_found_in_the_plane() {
        for integrator in ["euler", "exact"] {
            let swarm = planar(integrator, 25);
            let record = run(&swarm).unwrap();
            let y = record.y.as_ref().unwrap();
            let distance = |row: usize, i: usize, j: usize| {
                let gap = |x: &[f64]| x[j] - x[i];
                gap(record.actual_at(row)).hypot(gap(record.at(&y.actual, row)))
            };
            let nearest = |row: usize| {
                let pairs = (0..16).flat_map(|j| (0..j).map(move |i| (i, j)));
                pairs.map(|(i, j)| distance(row, i, j)).fold(f64::INFINITY, f64::min)
            };
            let events = record.events.as_ref().unwrap();
            let first = &events[0];
            let after = record.times.iter().position(|t| *t >= first.time).unwrap();
            assert!((0..after).all(|row| nearest(row) > 0.6), "{integrator}");
            let (i, j) = first.drones;
            let (before, next) = (distance(after - 1, i, j), distance(after, i, j));
            assert!(before > 0.6 && next <= 0.6, "{integrator}: {before} {next}");
            assert!(events.iter().all(|e| e.kind == EventKind::Collision));
            assert!(events.len() > 20, "{}", events.len());
        }
    }

    #[test]
    fn what_cannot_fly_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("high.toml");
        let text = "agents = 2\nstate = { x = \"m\", z = \"m\" }\ntopology = \"line\"\n\
                    claims = [\"x[i] < x[i+1]\"]\n[rules]\nall = { x = \"x\", z = \"z\" }\n";
        std::fs::write(&file, text).unwrap();
        let s = scenario(&file.display().to_string(), "start = [0, 0, 1, 0]");
        let said = Cosimulation::new(s, Flight::default()).unwrap_err().to_string();
        assert!(said.contains("state `x, z`: expected no `z`"), "{said}");
        let flight = Flight { start: Some(vec![1.into_rational(); 16]), ..Flight::default() };
        let said = Cosimulation::new(planar("euler", 1).scenario, flight).unwrap_err().to_string();
        assert!(said.contains("16 positions given: expected x and y for each"), "{said}");
    }
}
