//! Claims of users' own protocols: proved, for one number of agents or every one, or refuted.

use super::{is_valid, own, system};
use crate::common::{q, run};
use cordon_core::Rational;
use cordon_core::linear::feasible::{Constraint, Premises};
use cordon_core::system::System;
use cordon_proof::claims::certificate::certificate;
use cordon_proof::claims::search::{End, Limits};
use cordon_proof::claims::threshold::with;
use cordon_proof::claims::{PROOF, Unproved, constants, converge, prove, prove_within, refute};

/// Every file with what has to come out; none is refuted where it is proved.
#[test]
fn examples_are_proved_with_valid_certificates_or_refuted() {
    let proved = [
        "consensus",
        "coverage",
        "coverage-buffered",
        "coverage-heard-in-turn",
        "coverage-joining",
        "coverage-late",
        "coverage-that-waits",
        "coverage-with-losses",
        "damped-pair",
        "digraph",
        "grid",
        "leader-chain",
        "no-overshoot",
        "one-step-late",
        "pd-follower",
        "rendezvous-with-losses",
        "ring-consensus",
        "ring-pulls",
        "rotation",
        "rotation-range",
        "weighted-coverage",
    ];
    for name in proved {
        let system = own(name, None);
        let found = prove(&system).unwrap_or_else(|| panic!("{name} is not proved"));
        let certificate = certificate(&found.system, &found.proof).unwrap();
        assert!(
            is_valid(&certificate),
            "{name}: {}",
            cordon_check::check(&certificate.to_string())
        );
        let (run, _) = refute(&system, &constants(&system, 3).unwrap(), None, 3);
        assert_eq!(run, None, "{name}");
    }
    for name in ["digraph", "grid", "second-order", "two-modes"] {
        let found = converge::contraction(&own(name, None)).unwrap().unwrap();
        assert!(is_valid(&found.certificate) && found.rate < q("1"), "{name}");
    }
    let hasty = own("hasty-coverage", None);
    assert!(prove(&hasty).is_none());
    let (found, _) = refute(&hasty, &constants(&hasty, 8).unwrap(), None, 5);
    let found = found.unwrap();
    assert_eq!((found.step, found.values.clone()), (1, vec![q("3/5")]));
    for name in ["coverage-losses-gap", "coverage-lost-at-targets", "coverage-waits-sum"] {
        let system = own(name, None);
        assert!(prove(&system).is_none(), "{name}");
        let (found, _) = refute(&system, &constants(&system, 8).unwrap(), None, 5);
        assert_eq!(found.unwrap().step, 1, "{name}");
    }
    let files = std::fs::read_dir("scenarios/own").unwrap();
    let files =
        files.filter(|f| f.as_ref().unwrap().path().extension().is_some_and(|e| e == "toml"));
    // The platoon is proved too, in seconds: `cordon prove` in the guide; its critical gain is bracketed there.
    assert_eq!(files.count(), proved.len() + 8);
}

/// What needs the state bounded is proved with bounds, and without them where they are not needed.
#[test]
fn the_invariant_is_strengthened_only_where_it_has_to_be() {
    let claimed = |name: &str| {
        let system = own(name, None);
        let found = prove(&system).unwrap();
        (system.claims.len(), found.system.claims.len(), found.proof.rows.len())
    };
    let (own_claims, with_bounds, _) = claimed("weighted-coverage");
    assert_eq!(own_claims, with_bounds);
    let (own_claims, with_bounds, rows) = claimed("no-overshoot");
    assert!(own_claims == 1 && with_bounds == 5 && rows > 5);
}

/// Of an invariant no row follows from the others of its moment, but for the claims.
#[test]
fn invariants_have_no_row_too_many() {
    let mut added = 0;
    for name in ["rotation", "damped-pair", "no-overshoot", "pd-follower", "coverage-late"] {
        let found = prove(&own(name, None)).unwrap();
        let rows = &found.proof.rows;
        for (j, row) in rows.iter().enumerate().filter(|(_, r)| r.claim.is_none()) {
            let others: Vec<Constraint> = rows
                .iter()
                .enumerate()
                .filter(|(k, r)| *k != j && r.moment == row.moment)
                .map(|(_, r)| r.is.clone())
                .collect();
            let by = Premises::new(&others).unwrap().multipliers(&row.is);
            assert_eq!(by, None, "{name}: row {j} follows from others");
            added += 1;
        }
        assert!(is_valid(&certificate(&found.system, &found.proof).unwrap()), "{name}");
    }
    assert!(added >= 10, "{added}");
}

/// What a search may do is counted, and what ended it has a name.
#[test]
fn searches_end_at_their_limits_and_say_at_which() {
    let rotation = own("rotation", None);
    let ended = |system: &System, limits: Limits| prove_within(system, &limits).unwrap_err();
    assert_eq!(ended(&rotation, Limits { work: 100, ..PROOF }), Unproved::Open(End::Work));
    assert_eq!(ended(&rotation, Limits { steps: 1, ..PROOF }), Unproved::Open(End::Steps));
    assert_eq!(
        ended(&rotation, Limits { half_spaces: 1, ..PROOF }),
        Unproved::Open(End::HalfSpaces)
    );
    assert_eq!(ended(&own("hasty-coverage", None), PROOF), Unproved::Open(End::Varying));
    let fixed = with(&own("hasty-coverage", None), 0, &q("3/5"));
    let Unproved::Fails(run) = ended(&fixed, PROOF) else { panic!("a claim fails") };
    assert_eq!(run.step, 1);
    assert!(prove_within(&rotation, &PROOF).is_ok());
}

/// Order and a box on 200 agents: rows that what is nearest does not show are shown from what is some
/// links away, not from everything.
#[test]
fn order_and_box_on_a_long_line_take_little_work() {
    let line = own("coverage", Some(200));
    assert!(prove_within(&line, &Limits { work: 20_000_000, ..PROOF }).is_ok());
    let fast = with(&line, 0, &q("3/5"));
    let (run, _) = refute(&fast, &constants(&fast, 1).unwrap(), None, 2);
    assert_eq!(run.map(|run| run.step), Some(1));
}

/// A long line: the programs are as large as what a row speaks of, not as the line.
#[test]
fn a_long_line_is_proved_and_its_certificate_is_accepted() {
    let system = own("coverage", Some(120));
    let found = prove(&system).unwrap();
    assert!(is_valid(&certificate(&found.system, &found.proof).unwrap()));
}

#[test]
fn every_number_of_agents_is_proved_where_the_classes_allow_it() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path().to_str().unwrap();
    let mut accepted = 0;
    for name in [
        "coverage",
        "consensus",
        "leader-chain",
        "ring-consensus",
        "ring-pulls",
        "coverage-buffered",
    ] {
        let file = format!("scenarios/own/{name}.toml");
        let (code, out, err) = run(&["prove", "--protocol", &file, "--out", dir]);
        assert_eq!((code, err.as_str()), (0, ""), "{out}");
        assert!(out.contains("every number of agents from 3 on\n  proved"), "{out}");
        let file = folder.path().join(format!("{name}-every-n.json"));
        let (code, out, _) = run(&["check", file.to_str().unwrap()]);
        assert_eq!(code, 0, "{out}");
        accepted += 1;
    }
    assert_eq!(accepted, 6);
    // Too large a weight is proved for no number.
    let wrong = ["prove", "--protocol", "scenarios/own/coverage.toml", "--set", "eps=0..3/5"];
    let (code, out, _) = run(&wrong);
    assert_eq!(code, 1, "{out}");
    assert!(
        out.contains("not proved for every number")
            && out.contains("4 agents, every eps in [0, 3/5]\n  refuted at eps = 3/5"),
        "{out}"
    );
}

/// Departures: what holds is proved, what fails is refuted by a smallest run; the runs are exact.
#[test]
fn departures_hold_up_to_their_weights() {
    let base = |departure: &str, eps: &str, claims: &str| {
        format!(
            "agents = 4\ntopology = \"line\"\nstart = [\"x0 = 0\", \"x3 = 1\", \"x[i] < x[i+1]\"]\n\
             claims = [\"{claims}\"]\n[parameters]\neps = \"{eps}\"\n[rules]\nfirst = \"0\"\n\
             inner = \"x + eps*(prev.x - x) + eps*(next.x - x)\"\nlast = \"1\"\n\
             [departures]\n{departure}\n"
        )
    };
    let order = "x[i] < x[i+1]";
    let hull = "0 <= x[i] <= 1";
    let cases = [
        // A drone that skips: order below and at 1/2.
        ("skip = true", "0..1/2", order, true),
        ("skip = true", "3/5", order, false),
        // Lost links: strict order below 1/2, at 1/2 only weak order.
        ("loss = \"one-sided\"", "0..49/100", order, true),
        ("loss = \"one-sided\"", "1/2", order, false),
        ("loss = \"one-sided\"", "0..1/2", "x[i] <= x[i+1]", true),
        ("loss = \"one-sided\"", "0..1/2", hull, true),
        // The smallest gap is not kept: see the run below.
        ("loss = \"symmetric\"", "0..2/5", order, true),
        // Late messages.
        ("delay = 1", "0..1/2", order, true),
        ("delay = 1", "3/5", order, false),
        ("delay = 2", "1/2", hull, true),
    ];
    let mut decided = 0;
    for (departure, eps, claim, holds) in cases {
        let system = system(&base(departure, eps, claim));
        let found = prove(&system);
        assert_eq!(found.is_some(), holds, "{departure}, eps = {eps}, {claim}");
        match found {
            Some(found) => {
                let certificate = certificate(&found.system, &found.proof).unwrap();
                assert!(is_valid(&certificate), "{departure}, {eps}, {claim}");
            }
            None => {
                let (run, _) = refute(&system, &constants(&system, 1).unwrap(), None, 3);
                assert_eq!(run.unwrap().step, 1, "{departure}, {eps}, {claim}");
            }
        }
        decided += 1;
    }
    assert_eq!(decided, 10);
    // (0, 1/3, 2/3, 1), eps = 1/2, only the middle link up: both drones at 1/2.
    let met = system(&base("loss = \"symmetric\"", "1/2", order));
    let start: Vec<Rational> = ["0", "1/3", "2/3", "1"].map(q).to_vec();
    let (run, _) = refute(&met, &[met.values(|p| p.low.clone())], Some(&start), 1);
    let run = run.unwrap();
    assert_eq!(run.states[1], ["0", "1/2", "1/2", "1"].map(q));
}

#[test]
fn modes_act_in_any_order_or_in_turn() {
    let text = |switching: &str| {
        format!(
            "agents = 1\nstart = [\"-1 <= x0 <= 1\"]\nclaims = [\"-2 <= x0 <= 2\"]\n{switching}\n\
             [modes.up]\nall = \"2*x\"\n[modes.down]\nall = \"x/2\"\n"
        )
    };
    assert!(prove(&system(&text(""))).is_none());
    let (run, _) = refute(&system(&text("")), &[Vec::new()], None, 4);
    assert_eq!(run.unwrap().step, 2, "up twice");
    for (switching, holds) in [
        ("switching = [\"up\", \"down\"]", true),
        ("switching = [\"down\", \"down\", \"up\", \"up\"]", true),
        ("switching = [\"up\", \"up\", \"down\", \"down\"]", false),
    ] {
        let system = system(&text(switching));
        let found = prove(&system);
        assert_eq!(found.is_some(), holds, "{switching}");
        if let Some(found) = found {
            assert!(is_valid(&certificate(&found.system, &found.proof).unwrap()), "{switching}");
        }
    }
}

#[test]
fn claims_about_certain_steps_hold_at_those() {
    let text = |claim: &str| {
        format!(
            "agents = 1\nstart = [\"0 <= x0 <= 8\"]\nclaims = [{claim}]\n[rules]\nall = \"x/2\"\n"
        )
    };
    let claim = |bound: &str, steps: &str| format!("{{ holds = \"x0 <= {bound}\", {steps} }}");
    let cases = [
        (claim("1", "from = 3"), true),
        (claim("1", "from = 2"), false),
        (claim("8", "until = 5"), true),
        (claim("1", "from = 3, until = 3"), true),
        (claim("1/2", "from = 3, until = 4"), false),
    ];
    for (claim, holds) in cases {
        let system = system(&text(&claim));
        let found = prove(&system);
        assert_eq!(found.is_some(), holds, "{claim}");
        match found {
            Some(found) => assert!(is_valid(&certificate(&found.system, &found.proof).unwrap())),
            None => {
                let (run, _) = refute(&system, &[Vec::new()], None, 9);
                assert_eq!(run.unwrap().step, if claim.contains("from = 2") { 2 } else { 3 });
            }
        }
    }
}
