//! The scenarios of PROTOCOL section 5 reproduce: desired positions, exactly and to the digits
//! printed there. (The actual positions belong to the co-simulation.)
use std::path::Path;

use crate::common::{q, run};
use cordon_core::Rational;
use cordon_core::exact::decimal_string;
use cordon_run::scenario::{self, Scenario};
use cordon_run::simulate;
use num_traits::Signed;

fn shipped(name: &str) -> Scenario {
    scenario::read(&Path::new("scenarios").join(name)).unwrap().finish().unwrap()
}

/// Positions at a time in seconds, which is a whole number of ticks.
fn at(scenario: &Scenario, seconds: &str) -> Vec<Rational> {
    let ticks = q(seconds) / scenario.tau.clone().unwrap();
    assert!(ticks.is_integer());
    let snapshot =
        simulate::run(scenario).find(|s| Rational::from_integer(s.tick.into()) == ticks).unwrap();
    snapshot.state.drones
}

fn rounded(x: &[Rational]) -> String {
    x.iter().map(|x| decimal_string(x, 2)).collect::<Vec<_>>().join(", ")
}

#[test]
fn figure_8_desired_positions() {
    let paper = shipped("paper.toml");
    let table = [
        ("1", "12.42, 30.60, 60.09"),
        ("2", "17.73, 39.58, 67.54"),
        ("5", "23.86, 48.39, 73.86"),
        ("10", "24.95, 49.93, 74.95"),
    ];
    for (t, expected) in table {
        assert_eq!(rounded(&at(&paper, t)[1..4]), expected, "t = {t}");
    }
}

#[test]
fn figure_10_centre_drone() {
    for (eps, period, expected) in
        [("1/10", 2, "49.71"), ("3/10", 6, "49.80"), ("1/2", 10, "49.88")]
    {
        let mut s = shipped("paper.toml");
        (s.weight, s.period) = (q(eps), period);
        assert_eq!(rounded(&at(&s, "8")[2..3]), expected, "eps = {eps}");
    }
}

#[test]
fn figure_11_diverges_when_it_should() {
    let s = shipped("paper-unstable.toml");
    let time = |tick: u64| Rational::from_integer(tick.into()) * s.tau.clone().unwrap();
    let first = |wanted: fn(&Rational) -> bool| {
        let snapshot = simulate::run(&s).find(|s| s.state.drones.iter().any(wanted)).unwrap();
        time(snapshot.tick)
    };
    assert_eq!(first(Rational::is_negative), q("3.55"));
    assert_eq!(first(|x| x.abs() > Rational::from_integer(1000.into())), q("10.55"));
}

#[test]
fn figure_15_consensus() {
    let s = shipped("consensus.toml");
    assert_eq!(rounded(&at(&s, "10")), "31.35, 31.60, 32.00, 32.40, 32.65");
}

#[test]
fn the_recorded_scenario_moves_as_recorded_at_first() {
    // The first rows of run-c: 4.5 after the first update, then 5.25 and 2.375.
    let s = shipped("recorded.toml");
    assert_eq!(at(&s, "0.05"), crate::common::qs("0,1,2,4.5,10"));
    assert_eq!(at(&s, "0.35"), crate::common::qs("0,1,2.375,5.25,10"));
}

#[test]
fn a_drone_can_move_away_from_its_target() {
    let x = crate::common::qs("0,10,11,24,100");
    let run = crate::common::placements(&crate::common::params_for(q("1/5"), &x), x, 1);
    assert_eq!(run[1][1], q("8.2"));
}

/// Every shipped scenario loads, runs, and prints what it printed before, byte for byte.
#[test]
fn traces_of_the_shipped_scenarios_are_golden() {
    let mut names: Vec<_> = std::fs::read_dir("scenarios")
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.extension().is_some_and(|e| e == "toml"))
        .map(|p| p.file_stem().unwrap().to_str().unwrap().to_owned())
        // A trace has no faults: it refuses this one.
        .filter(|name| name != "faults")
        .collect();
    names.sort();
    let mut compared = 0;
    for name in &names {
        let (code, out, err) = run(&[
            "trace",
            &format!("scenarios/{name}.toml"),
            "--format",
            "csv",
            "--to",
            "12",
            "--digits",
            "6",
        ]);
        assert_eq!((code, err.as_str()), (0, ""), "{name}");
        let golden = format!("tests/golden/{name}.csv");
        if std::env::var_os("CORDON_BLESS").is_some() {
            std::fs::write(&golden, &out).unwrap();
        }
        let expected = std::fs::read_to_string(&golden)
            .unwrap_or_else(|e| panic!("{golden}: {e}; write it with CORDON_BLESS=1"));
        assert_eq!(out, expected, "{name}");
        compared += 1;
    }
    assert_eq!(compared, 8);
}
