//! Faults on links and drones: named in the scenario, seeded, and in accord with the spec.
use crate::common::{for_cases, q, qs};
use cordon_core::Rational;
use cordon_cosim::cosimulation::Cosimulation;
use cordon_cosim::run;
use cordon_run::scenario::{Draft, Fault, FaultKind, Flight, Start};
use proptest::prelude::*;

fn swarm(start: &str, eps: &str, period: u32, flight: Flight) -> Cosimulation {
    try_swarm(start, eps, period, flight).unwrap()
}

fn try_swarm(
    start: &str,
    eps: &str,
    period: u32,
    flight: Flight,
) -> cordon_core::Result<Cosimulation> {
    let draft = Draft {
        start: Some(Start::Listed(qs(start))),
        weight: Some(q(eps)),
        period: Some(period),
        tau: Some(q("0.05")),
        ..Draft::default()
    };
    Cosimulation::new(draft.finish()?, flight)
}

fn desired(swarm: &Cosimulation) -> Vec<Vec<f64>> {
    let record = run::run(swarm).unwrap();
    (0..record.rows()).map(|row| record.desired_at(row).to_vec()).collect()
}

fn fault(kind: FaultKind) -> Fault {
    Fault { kind, from: None, until: None }
}

fn loss(probability: &str) -> Fault {
    fault(FaultKind::Loss { link: None, probability: q(probability) })
}

fn flight(faults: Vec<Fault>, seconds: &str) -> Flight {
    Flight { faults, duration: Some(q(seconds)), ..Flight::default() }
}

const PAPER: &str = "0,10,20,30,100";

/// PROTOCOL section 2: drones 1 and 2 that see each other three steps late cross at step 4.
#[test]
fn stale_messages_let_drones_cross_at_step_4() {
    let late = |link| fault(FaultKind::Delay { link: Some(link), ticks: 3 });
    let start = "0,1/100,98/100,99/100,1";
    let stale = desired(&swarm(start, "1/3", 1, flight(vec![late((1, 2)), late((2, 1))], "1")));
    let crossed = stale.iter().position(|x| x[1] > x[2]);
    assert_eq!(crossed, Some(4));
    let fresh = desired(&swarm(start, "1/3", 1, flight(Vec::new(), "1")));
    assert!(fresh.iter().all(|x| x[1] < x[2]));
    // Three ticks are three steps only where every tick is a step.
    let slow = desired(&swarm(start, "1/3", 6, flight(vec![late((1, 2)), late((2, 1))], "5")));
    assert!(slow.iter().all(|x| x[1] < x[2]));
}

#[test]
fn loss_is_seeded_and_its_extremes_are_sharp() {
    let lossy = |probability: &str, seed: u64| {
        let flight = Flight { seed: Some(seed), ..flight(vec![loss(probability)], "10") };
        desired(&swarm(PAPER, "1/5", 4, flight))
    };
    let perfect = desired(&swarm(PAPER, "1/5", 4, flight(Vec::new(), "10")));
    assert_eq!(lossy("0", 1), perfect);
    assert_eq!(lossy("1/2", 1), lossy("1/2", 1));
    assert_ne!(lossy("1/2", 1), lossy("1/2", 2));
    assert_ne!(lossy("1/2", 1), perfect);
    // All is lost but what was exchanged before the run: every drone tends to the middle of
    // what it saw, as a lonely local machine does.
    let alone = lossy("1", 1);
    let last = alone.last().unwrap();
    assert!((last[1] - 10.0).abs() < 1e-3 && (last[2] - 20.0).abs() < 1e-3);
    assert!((last[3] - 60.0).abs() < 1e-2, "{last:?}");
}

/// A drone that has lost a message may hold the last one or skip the update; where it skips
/// all of them it stays.
#[test]
fn skipping_and_holding_differ() {
    let with = |on_loss: &str| {
        let flight = Flight { on_loss: Some(on_loss.to_owned()), ..flight(vec![loss("1")], "5") };
        desired(&swarm(PAPER, "1/5", 4, flight))
    };
    assert!(with("skip").iter().all(|x| x[1..4] == [10.0, 20.0, 30.0]));
    assert!(with("hold").last().unwrap()[3] > 55.0);
}

/// Any subset of drones may skip any update (PROTOCOL section 2, activation): the order and
/// the bounds hold for eps <= 1/2 whatever is lost. Evidence: 200 sampled runs.
#[test]
fn skipped_updates_keep_order_and_bounds() {
    let cases = (0u64..1000, 0u32..=10, 1i32..=6);
    let met = std::cell::Cell::new(0);
    for_cases(200, cases, |(seed, tenths, twelfths)| {
        let eps = Rational::new(twelfths.into(), 12.into()).to_string();
        let flight = Flight {
            seed: Some(seed),
            on_loss: Some("skip".to_owned()),
            ..flight(vec![loss(&format!("{tenths}/10"))], "2")
        };
        for x in desired(&swarm(PAPER, &eps, 1, flight)) {
            for (i, pair) in x.windows(2).enumerate() {
                prop_assert!(pair[0] < pair[1], "{x:?}");
                prop_assert!(x[i] <= 25.0 * i as f64);
            }
            met.set(met.get() + 1);
        }
        Ok(())
    });
    assert_eq!(met.get(), 200 * 41);
}

#[test]
fn a_drone_that_drops_out_stays_and_comes_back() {
    let out =
        Fault { kind: FaultKind::DropOut { drone: 2 }, from: Some(q("1")), until: Some(q("3")) };
    let x = desired(&swarm(PAPER, "1/5", 4, flight(vec![out], "25")));
    let perfect = desired(&swarm(PAPER, "1/5", 4, flight(Vec::new(), "25")));
    assert_eq!(x[..=20], perfect[..=20]);
    assert!(x[20..=60].iter().all(|row| row[2] == x[20][2]), "it stays");
    assert!(x[60][1] > x[20][1], "the others go on");
    assert!(x[70][2] > x[20][2], "it is back");
    assert!((x[500][2] - 50.0).abs() < 1e-3);
}

#[test]
fn faults_that_make_no_sense_are_refused() {
    let window = |from: &str, until: &str| Fault {
        from: Some(q(from)),
        until: Some(q(until)),
        ..loss("1/2")
    };
    let link = |link| fault(FaultKind::Delay { link: Some(link), ticks: 1 });
    let cases = [
        (loss("3/2"), "fault 1: probability: `3/2`: expected a number from 0 to 1"),
        (loss("-1/2"), "fault 1: probability: `-1/2`: expected a number from 0 to 1"),
        (
            window("0.07", "1"),
            "fault 1: from: `7/100`: expected a whole multiple of the step tau, which is `1/20` s",
        ),
        (window("2", "1"), "fault 1: until: expected a time after `from`"),
        (link((1, 9)), "fault 1: drone `9`: expected 0 to 4"),
        (link((1, 3)), "fault: link `[1, 3]`: expected two drones that exchange positions"),
        (fault(FaultKind::DropOut { drone: 5 }), "fault 1: drone `5`: expected 0 to 4"),
    ];
    for (fault, expected) in cases {
        let swarm = swarm(PAPER, "1/5", 4, flight(vec![fault], "1"));
        assert_eq!(swarm.master().err().unwrap().to_string(), expected);
    }
}

#[test]
fn flights_that_make_no_sense_are_refused() {
    let refused = |flight: Flight| try_swarm(PAPER, "1/5", 4, flight).unwrap_err().to_string();
    let default = Flight::default;
    let name = |n: &str| Some(n.to_owned());
    assert_eq!(
        refused(Flight { integrator: name("rk4"), ..default() }),
        "integrator: `rk4`: expected `euler` or `exact`"
    );
    assert_eq!(
        refused(Flight { master: name("newton"), ..default() }),
        "master: `newton`: expected `jacobi` or `gauss-seidel`"
    );
    assert_eq!(
        refused(Flight { lambda_p: Some(q("0")), ..default() }),
        "lambda_P: `0`: expected a positive number"
    );
    assert!(
        refused(Flight { start: Some(qs("0,1")), ..default() })
            .starts_with("flight.start: 2 positions given")
    );
    assert!(
        refused(Flight { duration: Some(q("0.33")), ..default() })
            .starts_with("duration: `33/100`: expected a whole multiple")
    );
    assert!(refused(Flight { duration: Some(q("-1")), ..default() }).starts_with("duration: `-1`"));
}
