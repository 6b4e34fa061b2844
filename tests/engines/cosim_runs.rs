//! Co-simulated runs against what was recorded, printed and proved (PROTOCOL sections 3, 5).
use crate::common::{q, qs};
use cordon_core::exact::{self, decimal_string};
use cordon_cosim::collision::EventKind;
use cordon_cosim::cosimulation::Cosimulation;
use cordon_cosim::record::Record;
use cordon_cosim::{exact_run, run, store};
use cordon_run::scenario::{self, Draft, Flight, Start};
use cordon_run::simulate;
use cordon_spec::coverage::exec_coverage;

fn swarm_of(file: &str) -> Cosimulation {
    let draft = scenario::read(file.as_ref()).unwrap();
    let flight = draft.flight.clone();
    Cosimulation::new(draft.finish().unwrap(), flight).unwrap()
}

/// The paper's swarm with weight tenths/10 and a period of as many tenths of a second.
fn paper(tenths: u32, protocol: &str, flight: Flight) -> Cosimulation {
    let draft = Draft {
        protocol: Some(protocol.to_owned()),
        start: Some(Start::Listed(qs("0,10,20,30,100"))),
        weight: Some(q(&format!("{tenths}/10"))),
        period: Some(2 * tenths),
        tau: Some(q("0.05")),
        ..Draft::default()
    };
    Cosimulation::new(draft.finish().unwrap(), flight).unwrap()
}

fn flown(swarm: &Cosimulation) -> Record {
    run::run(swarm).unwrap()
}

/// Rows of the grid at a time in hundredths of a second.
fn row(hundredths: usize) -> usize {
    assert_eq!(hundredths % 5, 0);
    hundredths / 5
}

#[test]
fn recorded_runs_match_to_the_last_bit() {
    let mut compared = 0;
    for (file, recording, rows) in [("recorded-a", "run-a", 254), ("recorded", "run-c", 501)] {
        let swarm = swarm_of(&format!("scenarios/{file}.toml")).as_recorded().unwrap();
        let ours = flown(&swarm);
        let path = format!("tests/data/recorded/{recording}.csv");
        let theirs = store::load(path.as_ref()).unwrap();
        assert_eq!((ours.rows(), theirs.rows()), (rows, rows));
        for (name, ours, theirs) in [
            ("time", &ours.times, &theirs.times),
            ("desired", &ours.x.desired, &theirs.x.desired),
            ("actual", &ours.x.actual, &theirs.x.actual),
        ] {
            for (k, (a, b)) in ours.iter().zip(theirs).enumerate() {
                assert_eq!(a.to_bits(), b.to_bits(), "{file}, {name} {k}: {a} against {b}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, (254 + 501) * 11);
}

/// The recorded arithmetic is not the default one: a comparison that cannot tell them apart
/// would show nothing.
#[test]
fn the_default_arithmetic_is_near_the_recorded_one_and_not_it() {
    let theirs = store::load("tests/data/recorded/run-c.csv".as_ref()).unwrap();
    let ours = flown(&swarm_of("scenarios/recorded.toml"));
    let distances = ours.x.actual.iter().zip(&theirs.x.actual).map(|(a, b)| (a - b).abs());
    let largest = distances.fold(0.0, f64::max);
    assert!(largest > 1e-12 && largest < 1e-4, "{largest}");
}

#[test]
fn the_table_of_the_scenarios_is_met_to_its_digits() {
    let times = [100, 200, 500, 1000];
    let table: [(u32, bool, [&str; 4]); 3] = [
        (
            2,
            true,
            [
                "12.42, 30.60, 60.09",
                "17.73, 39.58, 67.54",
                "23.86, 48.39, 73.86",
                "24.95, 49.93, 74.95",
            ],
        ),
        (
            2,
            false,
            [
                "10.00, 20.03, 30.32",
                "10.17, 20.84, 33.33",
                "14.60, 31.27, 51.98",
                "22.05, 44.91, 69.16",
            ],
        ),
        (
            7,
            false,
            [
                "10.00, 20.00, 30.86",
                "10.05, 21.33, 35.39",
                "15.27, 33.61, 54.50",
                "24.98, 42.40, 72.50",
            ],
        ),
    ];
    // The actual positions of the printed table were rounded by way of three decimals, half to
    // even: 30.3252 is printed as 30.32 and 54.4945 as 54.50. The desired ones were not.
    let printed = |x: f64, desired: bool| {
        let exact = cordon_core::Rational::from_float(x).unwrap();
        let by_way = if desired { exact } else { q(&decimal_string(&exact, 3)) };
        decimal_string(&by_way, 2)
    };
    let mut compared = 0;
    for (tenths, desired, cells) in table {
        let record = flown(&paper(tenths, "coverage", Flight::default()));
        for (time, cell) in times.into_iter().zip(cells) {
            let at = row(time);
            let x = if desired { record.desired_at(at) } else { record.actual_at(at) };
            let shown: Vec<_> = x[1..4].iter().map(|x| printed(*x, desired)).collect();
            assert_eq!(shown.join(", "), cell, "eps {tenths}/10 desired {desired} at {time}");
            compared += 1;
        }
    }
    assert_eq!(compared, 12);
}

#[test]
fn the_figures_numbers_are_met() {
    let centre =
        |tenths| flown(&paper(tenths, "coverage", Flight::default())).desired_at(row(800))[2];
    assert_eq!([1, 3, 5].map(|t| format!("{:.2}", centre(t))), ["49.71", "49.80", "49.88"]);

    let record = flown(&paper(7, "coverage", Flight::default()));
    let first = |holds: &dyn Fn(f64) -> bool| {
        let at = (0..record.rows()).find(|r| record.desired_at(*r).iter().any(|x| holds(*x)));
        record.times[at.unwrap()]
    };
    assert_eq!(first(&|x| x < 0.0), 3.55);
    assert_eq!(first(&|x| x.abs() > 1000.0), 10.55);

    let record = flown(&paper(3, "consensus", Flight::default()));
    let shown = record.desired_at(row(1000)).iter().map(|x| format!("{x:.2}"));
    assert_eq!(shown.collect::<Vec<_>>(), ["31.35", "31.60", "32.00", "32.40", "32.65"]);
}

#[test]
fn drones_1_and_2_collide_between_two_samples_at_eps_seven_tenths() {
    for integrator in ["euler", "exact"] {
        let flight = Flight { integrator: Some(integrator.to_owned()), ..Flight::default() };
        let record = flown(&paper(7, "coverage", flight));
        let events = record.events.clone().unwrap();
        assert_eq!(events[0].kind, EventKind::Collision);
        // The exact plant is damped a little more, and others are the first to meet.
        assert_eq!(events[0].drones, if integrator == "euler" { (1, 2) } else { (2, 3) });
        assert_eq!((events[1].kind, events[1].time), (EventKind::OrderLost, events[0].time));
        if integrator == "euler" {
            assert_eq!(format!("{:.2}", events[0].time), "12.59");
        }
        // It is between samples: before it the drones are in order, after it they are not.
        let after = record.times.iter().position(|t| *t > events[0].time).unwrap();
        let (i, j) = events[0].drones;
        let gap = |row: usize| record.actual_at(row)[j] - record.actual_at(row)[i];
        assert!(gap(after - 1) > 0.0 && gap(after) < 0.0, "{integrator}");
    }
    // Below 1/2 nobody meets anybody.
    let record = flown(&paper(2, "coverage", Flight::default()));
    assert_eq!(record.events, Some(Vec::new()));
}

#[test]
fn desired_positions_are_the_specs_run_rounded_once() {
    let mut compared = 0;
    for (tenths, protocol) in [(2, "coverage"), (7, "coverage"), (3, "consensus")] {
        for master in ["jacobi", "gauss-seidel"] {
            let flight = Flight { master: Some(master.to_owned()), ..Flight::default() };
            let swarm = paper(tenths, protocol, flight);
            let record = flown(&swarm);
            for (at, snapshot) in simulate::run(&swarm.scenario).take(record.rows()).enumerate() {
                let exact = snapshot.state.drones.iter().map(cordon_core::exact::to_f64);
                assert!(exact.eq(record.desired_at(at).iter().copied()), "{protocol} {at}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 6 * 501);
}

/// Each drone in turn takes its share of the spec's step, on what the others have by then.
#[test]
fn drones_that_update_in_an_order_hear_the_new_positions_of_those_before() {
    let orders = [
        ("ascending", [0, 1, 2, 3, 4]),
        ("descending", [4, 3, 2, 1, 0]),
        ("2,0,4,1,3", [2, 0, 4, 1, 3]),
    ];
    let mut compared = 0;
    let flight = |order: &str, master: &str| Flight {
        duration: Some(q("4")),
        order: Some(order.to_owned()),
        master: Some(master.to_owned()),
        ..Flight::default()
    };
    let at_once = flown(&paper(2, "coverage", flight("at-once", "jacobi")));
    for (text, order) in orders {
        let swarm = paper(2, "coverage", flight(text, "jacobi"));
        let params = swarm.scenario.params().unwrap();
        let record = flown(&swarm);
        assert!(record.setup.clone().unwrap().flown_with().contains("updates in the order"));
        let mut state = swarm.scenario.initial();
        for row in 0..record.rows() {
            // Updates are in the ticks 1, 5, 9, ..
            if row % 4 == 1 {
                for i in order {
                    state.drones[i] = exec_coverage(&params, &state).drones[i].clone();
                }
            }
            let expected: Vec<f64> = state.drones.iter().map(exact::to_f64).collect();
            assert_eq!(record.desired_at(row), expected, "{text}, row {row}");
            compared += 1;
        }
        assert_ne!(record.x.desired, at_once.x.desired, "{text}");
        let seidel = flown(&paper(2, "coverage", flight(text, "gauss-seidel")));
        assert_eq!(seidel.x.desired, record.x.desired, "{text}: whatever the master");
        let recorded = flown(&swarm.as_recorded().unwrap());
        let distance = |(a, b): (&f64, &f64)| (a - b).abs();
        let most =
            recorded.x.desired.iter().zip(&record.x.desired).map(distance).fold(0.0, f64::max);
        assert!(most > 0.0 && most < 0.01, "six digits: {most}");
    }
    assert_eq!(compared, 3 * 81);
    for wrong in ["upwards", "0,1,2", "0,1,2,3,3", "0,1,2,3,5", ""] {
        let draft = swarm_of("scenarios/paper.toml").scenario;
        let why = Cosimulation::new(draft, flight(wrong, "jacobi")).unwrap_err().to_string();
        assert!(why.starts_with(&format!("order: `{wrong}`: expected")), "{why}");
    }
}

#[test]
fn formation_flies_too() {
    let draft = Draft {
        protocol: Some("formation".to_owned()),
        start: Some(Start::Listed(qs("0,1,5,6"))),
        displacement: Some(qs("-10,0,0,10")),
        weight: Some(q("1/4")),
        period: Some(2),
        tau: Some(q("1/20")),
        ..Draft::default()
    };
    let swarm = Cosimulation::new(draft.finish().unwrap(), Flight::default()).unwrap();
    let record = flown(&swarm);
    let exact = simulate::run(&swarm.scenario).nth(500).unwrap().state.drones;
    assert!(
        exact.iter().map(cordon_core::exact::to_f64).eq(record.desired_at(500).iter().copied())
    );
    // Ten metres apart around the average of the start, 3.
    let last = record.actual_at(500);
    for (x, goal) in last.iter().zip([-12.0, -2.0, 8.0, 18.0]) {
        assert!((x - goal).abs() < 0.1, "{last:?}");
    }
}

#[test]
fn doubles_stay_near_the_run_in_exact_arithmetic() {
    for (integrator, master, exchange) in [
        ("euler", "jacobi", "exact"),
        ("exact", "jacobi", "exact"),
        ("euler", "gauss-seidel", "exact"),
        ("exact", "gauss-seidel", "double"),
    ] {
        let flight = Flight {
            integrator: Some(integrator.to_owned()),
            master: Some(master.to_owned()),
            exchange: Some(exchange.to_owned()),
            ..Flight::default()
        };
        let swarm = paper(2, "coverage", flight);
        let difference = exact_run::difference(&swarm, &flown(&swarm)).unwrap();
        let (desired, actual) = (difference.desired.size, difference.actual.size);
        assert!(desired > 0.0 && desired < 1e-12, "{integrator} {master}: {desired}");
        assert!(actual > 0.0 && actual < 1e-10, "{integrator} {master}: {actual}");
    }
    // Another run's record is told apart: the comparison can fail.
    let swarm = paper(2, "coverage", Flight::default());
    let other = flown(&paper(3, "coverage", Flight::default()));
    assert!(exact_run::difference(&swarm, &other).unwrap().actual.size > 0.1);
}

/// Enough units that threads share the work.
#[test]
fn runs_are_the_same_on_one_and_two_threads() {
    let draft = Draft {
        drones: Some(200),
        start: Some(Start::SpreadTo(q("600"))),
        max: Some(q("1000")),
        weight: Some(q("0.2")),
        period: Some(4),
        tau: Some(q("0.05")),
        ..Draft::default()
    };
    let scenario = draft.finish().unwrap();
    let flight = Flight { duration: Some(q("5")), ..Flight::default() };
    let runs = [1, 2, 2].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let swarm = Cosimulation::new(scenario.clone(), flight.clone()).unwrap();
        pool.install(|| flown(&swarm))
    });
    let bits = |r: &Record| -> Vec<u64> {
        r.x.desired.iter().chain(&r.x.actual).map(|x| x.to_bits()).collect()
    };
    assert_eq!(bits(&runs[0]).len(), 2 * 200 * 101);
    assert_eq!(bits(&runs[0]), bits(&runs[1]));
    assert_eq!(bits(&runs[1]), bits(&runs[2]));
}
