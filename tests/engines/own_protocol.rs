//! Users' own protocols: proofs, counterexamples, convergence, critical values.
use std::cell::Cell;
use std::path::Path;

use crate::common::{for_cases, q, run};
use crate::own_random::{self, choices, grid, random_protocol};
use cordon_check::Verdict;
use cordon_core::Rational;
use cordon_core::linear::feasible::{Constraint, Premises};
use cordon_core::system::{Consensus, Coverage, System};
use cordon_proof::claims::certificate::certificate;
use cordon_proof::claims::search::{End, Limits};
use cordon_proof::claims::sweep::on_grid;
use cordon_proof::claims::threshold::{Known, Property, critical, known, with};
use cordon_proof::claims::{PROOF, constants, converge, follow, prove, prove_within, refute};
use cordon_run::protocol::{parse, read};
use cordon_run::scenario::Topology;
use proptest::prelude::*;

fn own(name: &str, agents: Option<usize>) -> System {
    let file = read(Path::new(&format!("scenarios/own/{name}.toml"))).unwrap();
    file.with_agents(agents.unwrap_or(file.agents.fewest())).unwrap()
}

fn system(text: &str) -> System {
    parse("own", text).unwrap().system().unwrap()
}

fn is_valid(certificate: &serde_json::Value) -> bool {
    matches!(cordon_check::check(&certificate.to_string()), Verdict::Valid { .. })
}

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
    // The platoon is proved too, in seconds: `cordon prove` in the guide.
    assert_eq!(files.count(), proved.len() + 7);
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
    assert_eq!(ended(&rotation, Limits { work: 100, ..PROOF }), End::Work);
    assert_eq!(ended(&rotation, Limits { steps: 1, ..PROOF }), End::Steps);
    assert_eq!(ended(&rotation, Limits { half_spaces: 1, ..PROOF }), End::HalfSpaces);
    assert_eq!(ended(&own("hasty-coverage", None), PROOF), End::Varying);
    let fixed = with(&own("hasty-coverage", None), 0, &q("3/5"));
    assert_eq!(ended(&fixed, PROOF), End::Failure);
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

/// The spec's protocols, and the same as files, have the same coefficients.
#[test]
fn files_say_what_the_spec_says() {
    let mut compared = 0;
    for count in 3..=9 {
        let eps = (q("0"), q("1/2"));
        let spec =
            System::of(&Coverage { count, min: q("0"), max: q("1"), eps: eps.clone() }).unwrap();
        assert_eq!(own("coverage", Some(count)).modes, spec.modes, "N = {count}");
        let graph = Topology::Path(count);
        let spec = System::of(&Consensus { graph, eps }).unwrap();
        assert_eq!(own("consensus", Some(count)).modes, spec.modes, "N = {count}");
        compared += 2;
    }
    assert_eq!(compared, 14);
}

/// Verdicts of the built-in theorems and of the file at the same weights.
#[test]
fn verdicts_of_files_are_those_of_the_built_in_protocols() {
    let system = own("coverage", Some(4));
    for (eps, holds) in
        [("1/3", true), ("1/2", true), ("51/100", false), ("3/5", false), ("1", false)]
    {
        let (code, _, _) = run(&["refute", "7.2", "--drones", "4", "--eps", eps]);
        let found = known(&with(&system, 0, &q(eps)), Property::Claims).unwrap();
        assert_eq!(
            (code, found),
            if holds { (3, Known::Holds) } else { (1, Known::Fails) },
            "{eps}"
        );
    }
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

/// Departures: what holds is proved, what fails is refuted by a smallest run (the tables of the issue
/// about what is beyond the paper; the runs are exact).
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

#[test]
fn critical_values_are_bracketed_from_both_sides() {
    let mut ordering = own("coverage", Some(5));
    ordering.parameters[0].high = q("1");
    let (found, _) = critical(&ordering, 0, Property::Claims, 4).unwrap();
    let found = found.unwrap();
    assert!(found.holds <= q("1/2") && q("1/2") < found.fails && found.open.is_none());
    assert!(&found.fails - &found.holds <= q("1/10000"));
    // Convergence of coverage: N = 4 up to 2/3.
    let mut limit = own("coverage", Some(4));
    limit.parameters[0] = cordon_core::system::Parameter {
        low: q("1/4"),
        high: q("1"),
        ..limit.parameters[0].clone()
    };
    let targets = (0..4).map(|i| Rational::new(i.into(), 3.into())).collect();
    limit.converges = Some(cordon_core::system::Convergence::To(targets));
    let (found, _) = critical(&limit, 0, Property::Convergence, 2).unwrap();
    let found = found.unwrap();
    assert!(found.holds < q("2/3") && q("2/3") <= found.fails, "{found:?}");
    assert!(&found.fails - &found.holds <= q("1/100"), "{found:?}");
}

/// Two modes without a common form have one for each; a form for each settles as one does.
#[test]
fn modes_have_forms_of_their_own() {
    let system = own("two-modes", None);
    let found = converge::contraction(&system).unwrap().unwrap();
    assert_eq!(found.forms.len(), 2);
    assert!(found.certificate["certificate"]["quadratic"]["matrices"].get("second").is_some());
    assert!(is_valid(&found.certificate));
    let step = cordon_proof::claims::settle::settles(&system, &found, None, &q("1/10")).unwrap();
    // Every word of modes as long as that ends within, from every corner of the box.
    let maps: Vec<_> = system.modes.iter().map(|m| m.at(&[])).collect();
    let mut largest = q("0");
    let mut states: Vec<Vec<Rational>> =
        [["1", "1"], ["1", "-1"]].map(|x| x.map(q).to_vec()).to_vec();
    for _ in 0..step.min(14) {
        states = states.iter().flat_map(|x| maps.iter().map(|m| m.apply(x))).collect();
        largest = states.iter().flatten().map(num_traits::Signed::abs).max().unwrap();
    }
    assert!(step > 14 || largest <= q("1/10"), "{step} {largest}");
    // Factors above 1: it does not converge any more.
    let text = std::fs::read_to_string("scenarios/own/two-modes.toml").unwrap();
    let fast = self::system(&text.replace("4/5", "6/5"));
    assert!(converge::contraction(&fast).unwrap().is_none());
}

/// What a step keeps does not vanish: a start from which it is there does not converge, if such a start
/// is assumed.
#[test]
fn what_is_kept_does_not_converge() {
    let text = |rules: &str, start: &str| {
        system(&format!(
            "agents = 1\nstate = \"x, v\"\nstart = [{start}]\nconverges = \"target\"\ntarget = {{ x = \"0\", \
             v = \"0\" }}\n[rules]\nall = {{ {rules} }}\n"
        ))
    };
    let anywhere = "\"-1 <= x[i] <= 1\", \"-1 < v[i] < 1\"";
    let mut shown = 0;
    for (rules, start, fails) in [
        // A Jordan block, a component that stays, one that changes its sign, a turn by a fourth of a turn
        // and by one whose cosine is 3/5.
        ("x = \"x + v\", v = \"v\"", anywhere, true),
        ("x = \"x/2\", v = \"v\"", anywhere, true),
        ("x = \"x/2\", v = \"x - v\"", anywhere, true),
        ("x = \"-v\", v = \"x\"", anywhere, true),
        ("x = \"3*x/5 - 4*v/5\", v = \"4*x/5 + 3*v/5\"", anywhere, true),
        // What stays is 0 at every assumed start.
        ("x = \"x/2\", v = \"v\"", "\"-1 <= x[i] <= 1\", \"v[i] = 0\"", false),
        ("x = \"x/2\", v = \"v/3\"", anywhere, false),
        ("x = \"2*x\", v = \"v/3\"", anywhere, true),
        ("x = \"2*x\", v = \"v/3\"", "\"x[i] = 0\", \"-1 < v[i] < 1\"", false),
    ] {
        let system = text(rules, start);
        let found = converge::grows(&system).unwrap();
        assert_eq!(found.is_some(), fails, "{rules}, {start}");
        if let Some(found) = found {
            assert!(is_valid(&found.certificate), "{rules}");
            assert!(system.starts.iter().all(|p| p.holds(&found.start)), "{rules}");
            shown += 1;
        }
        assert!(!fails || converge::contraction(&system).unwrap().is_none());
    }
    assert_eq!(shown, 6);
}

/// The grid has the assumed starts that it should, and what fails from one is what an exact run says.
#[test]
fn claims_are_swept_over_the_starts_of_a_grid() {
    let coverage = with(&own("coverage", Some(4)), 0, &q("1/2"));
    let values = constants(&coverage, 1).unwrap();
    // 0 < a < b < 1 in eighths.
    let tried = on_grid(&coverage, &values, 8, 5).unwrap();
    assert_eq!((tried.starts, tried.states, tried.failures.len()), (21, 126, 0));
    let fast = with(&coverage, 0, &q("3/5"));
    let tried = on_grid(&fast, &[vec![q("3/5")]], 8, 5).unwrap();
    let failure = tried.failures.values().min_by_key(|f| f.step).unwrap();
    assert_eq!(failure.step, 1);
    let states = fast.run(&failure.values, &failure.start, 1);
    assert!(fast.claims.iter().all(|c| c.predicate.holds(&states[0])));
    assert!(fast.claims.iter().any(|c| !c.predicate.holds(&states[1])));
    // Any mode in any step, each state once.
    let both = system(
        "agents = 1\nstart = [\"0 <= x0 <= 1\"]\nclaims = [\"x0 < 4\"]\n[modes.up]\nall = \"2*x\"\n\
         [modes.down]\nall = \"x/2\"\n",
    );
    let tried = on_grid(&both, &[vec![]], 1, 2).unwrap();
    assert_eq!((tried.starts, tried.states, tried.failures[&0].step), (2, 3 + 6, 2));
    let free =
        system("agents = 1\nstart = [\"x0 >= 0\"]\nclaims = [\"x0 >= 0\"]\n[rules]\nall = \"x\"\n");
    let message = on_grid(&free, &[vec![]], 4, 1).unwrap_err().to_string();
    assert!(message.contains("`x0` has no bound"), "{message}");
}

#[test]
fn modes_are_in_the_order_in_which_they_are_declared() {
    let both = "agents = 1\nclaims = [\"x0 >= 0\"]\n[modes.up]\nall = \"2*x\"\n[modes.down]\nall = \"x/2\"\n";
    let names: Vec<String> = system(both).modes.into_iter().map(|m| m.name).collect();
    assert_eq!(names, ["up", "down"]);
}

#[test]
fn what_is_proved_never_fails_and_what_is_refuted_replays() {
    own_random::agree(150);
}

/// Whenever a critical value is bracketed, both sides hold.
fn brackets_hold(cases: u32) {
    let (tried, bracketed) = (Cell::new(0), Cell::new(0));
    for_cases(cases, random_protocol(1..2), |text| {
        tried.set(tried.get() + 1);
        let Some(system) = own_random::read(&text.replace("1/4..1/2", "0..4"))? else {
            return Ok(());
        };
        let (found, _) = critical(&system, 0, Property::Claims, 1).unwrap();
        let Some(found) = found else { return Ok(()) };
        bracketed.set(bracketed.get() + 1);
        let at = |value| with(&system, 0, value);
        prop_assert_eq!(known(&at(&found.holds), Property::Claims).unwrap(), Known::Holds);
        for (n, start) in grid(&system).into_iter().enumerate() {
            let by = choices(&system, &found.holds, n);
            prop_assert_eq!(follow(&system, &[], &start, by), None, "{}", text);
        }
        let fails = at(&found.fails);
        let (run, _) = refute(&fails, &constants(&fails, 1).unwrap(), None, 40);
        let run = run.ok_or_else(|| TestCaseError::fail(format!("no run:\n{text}")))?;
        let again = follow(&fails, &run.values, &run.states[0], run.choices.clone());
        prop_assert_eq!(again.as_ref(), Some(&run), "{}", text);
        Ok(())
    });
    assert_eq!(tried.get(), cases);
    assert!(bracketed.get() >= cases / 20, "{bracketed:?}");
}

#[test]
fn brackets_hold_on_both_sides() {
    brackets_hold(40);
}

#[test]
fn a_counterexample_replays_from_the_command_line() {
    let mut replayed = 0;
    for (file, set) in [("hasty-coverage", "eps=0..3/5"), ("coverage-with-losses", "eps=3/5")] {
        let file = format!("scenarios/own/{file}.toml");
        let (code, out, err) = run(&["refute", "--protocol", &file, "--set", set]);
        assert_eq!((code, err.as_str()), (1, ""), "{out}");
        let replay = out.lines().find_map(|l| l.trim().strip_prefix("replay: cordon ")).unwrap();
        let words: Vec<&str> = replay.split(' ').collect();
        let (code, again, _) = run(&words);
        assert_eq!(code, 1);
        // The heading alone says that the constants are the given ones.
        let below = |page: &str| page.split_once('\n').map(|(_, rest)| rest.to_owned());
        assert_eq!(below(&again), below(&out));
        replayed += 1;
    }
    assert_eq!(replayed, 2);
    // A range that was given to what varies belongs to the question.
    let folder = tempfile::tempdir().unwrap();
    let pushed = folder.path().join("pushed.toml");
    let text = "agents = 1\nstart = [\"x0 = 0\"]\nclaims = [\"x0 <= 3\"]\n[parameters]\n\
                w = { varying = \"-1..1\" }\n[rules]\nall = \"x/2 + w\"\n";
    std::fs::write(&pushed, text).unwrap();
    let file = pushed.to_str().unwrap();
    assert_eq!(run(&["prove", "--protocol", file]).0, 0);
    let (code, out, _) = run(&["prove", "--protocol", file, "--set", "w=0..5"]);
    let replay = out.lines().find_map(|l| l.trim().strip_prefix("replay: cordon ")).unwrap();
    assert_eq!((code, run(&replay.split(' ').collect::<Vec<_>>()).0), (1, 1), "{replay}");
    let (code, _, err) = run(&["prove", "7.2", "--set", "eps=1"]);
    assert!(code == 2 && err.contains("set: expected --protocol with it"), "{err}");
    let (code, out, _) = run(&["refute", "--protocol", "scenarios/own/leader-chain.toml"]);
    assert_eq!(code, 3);
    assert!(out.contains("complete for all starts"), "{out}");
}

#[test]
fn prove_ends_with_a_certificate_a_counterexample_or_neither() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path().to_str().unwrap();
    let prove = |file: &str| run(&["prove", "--protocol", file, "--out", dir]);
    let (code, out, err) = prove("scenarios/own/weighted-coverage.toml");
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("proved") && out.contains("certified: 8 half-spaces"), "{out}");
    let file = folder.path().join("weighted-coverage.json");
    assert_eq!(run(&["check", file.to_str().unwrap()]).0, 0);
    let (code, out, _) = prove("scenarios/own/hasty-coverage.toml");
    assert_eq!(code, 1, "{out}");
    assert!(!folder.path().join("hasty-coverage.json").exists());
    // An exact rotation: the disc is kept, no polygon is.
    let turning = folder.path().join("turning.toml");
    let text = "agents = 2\nstart = [\"-1 <= x[i] <= 1\"]\nclaims = [\"x0 <= 3/2\"]\n\
                [rules]\n0 = \"3/5*x0 - 4/5*x1\"\n1 = \"4/5*x0 + 3/5*x1\"\n";
    std::fs::write(&turning, text).unwrap();
    let (code, out, _) = prove(turning.to_str().unwrap());
    assert_eq!(code, 3);
    assert!(out.contains("not refuted") && out.contains("complete for all starts"), "{out}");
    assert!(out.contains("not proved: the invariant needs more "), "{out}");
    let (code, out, _) =
        run(&["prove", "--protocol", "scenarios/own/digraph.toml", "--format", "json"]);
    let page: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!((code, &page["claims"]["proved"]), (0, &serde_json::json!(true)));
    assert_eq!(page["convergence"]["proved"], true);
    assert_eq!(page["schema"], "cordon-own-protocol/2");
    let (code, out, _) = run(&["prove", "--protocol", "no-such-file.toml"]);
    assert_eq!((code, out.as_str()), (74, ""));
    // Too large a weight: neither the box nor agreement.
    let wrong = ["prove", "--protocol", "scenarios/own/digraph.toml", "--set", "eps=2"];
    let (code, out, _) = run(&wrong);
    assert!(code == 1 && out.contains("does not converge at eps = 2"), "{out}");
}

#[test]
fn mistakes_are_named_with_file_line_column_and_key() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.toml");
    let good = "agents = 2\ntopology = \"line\"\nclaims = [\"x0 < x1\"]\n[parameters]\neps = 1\n\
                [rules]\nall = \"x + eps*sum(their.x - x)\"\n";
    let rule = |text: &str| good.replace("x + eps*sum(their.x - x)", text);
    let cases = [
        (
            good.replace("agents = 2", "agents = 0"),
            "p.toml:1:10: agents: `0`: expected a number from 1",
        ),
        (good.replace("agents = 2", "agents = \"x..\""), "p.toml:1:10: agents: `x..`"),
        (
            good.replace("agents = 2", "drones = 2"),
            "p.toml:1:1: drones: is no longer a key: expected `agents = 5`",
        ),
        (good.replace("topology", "graph"), "graph: is no longer a key: expected `topology`"),
        (good.replace("claims", "claim"), "claim: is no longer a key: expected `claims`"),
        (
            good.replace("eps = 1", "eps = \"1/0\""),
            "p.toml:5:7: parameters.eps: `1/0` divides by zero",
        ),
        (
            good.replace("eps = 1", "eps = \"1..0\""),
            "p.toml:5:7: parameters.eps: `1..0`: expected a range",
        ),
        (good.replace("eps = 1", "x = 1"), "p.toml:5:1: parameters.x: expected a name"),
        (
            good.replace("eps = 1\n", ""),
            "rules.all (agent 0): `eps` is no state variable, parameter",
        ),
        (good.replace("line", "lines"), "p.toml:2:12: topology: `lines`: expected `line`, `ring`"),
        (
            good.replace("\"line\"", "[[0, 1], [1, 0]]"),
            "topology: `[1, 0]`: agent 0 hears agent 1 twice",
        ),
        (rule("eps*eps*x"), "rules.all (agent 0): `eps` to the power 2"),
        (rule("x*x"), "rules.all (agent 0): a product of state variables"),
        (
            rule("prev.x").replace("agents = 2", "agents = 1").replace("line", "ring"),
            "rules.all (agent 0): `prev`: expected a ring of two agents or more",
        ),
        (
            good.replace("\"x0 < x1\"", "{ holds = \"x0 < x1\", from = 1001 }"),
            "p.toml:3:11: claims: `from = 1001`: expected a step from 0 to 1000",
        ),
        (
            good.replace("x0 < x1", "2 < 1"),
            "start: no start meets the claims, which are assumed where",
        ),
        (rule("x +"), "p.toml:7:11: rules.all: expected a number, a name or `(`, found the end"),
        (
            rule("prev.x"),
            "rules.all (agent 0): agent 0 has no `prev`: expected a rule of its own for `first`",
        ),
        (rule("x[5]"), "`5` is no agent: expected 0 to 1"),
        (
            good.replace("all =", "7 ="),
            "p.toml:7:1: rules.7: expected `all`, `first`, `inner`, `last` or an agent",
        ),
        (good.replace("all =", "first ="), "rules: agent 1 has no rule"),
        (
            good.replace("x0 < x1", "x0 < x2"),
            "p.toml:3:17: claims: `2` is no agent: expected 0 to 1",
        ),
        (good.replace("x0 < x1", "x0 * x1 < 1"), "claims: expected no product"),
        (good.replace("x0 < x1", "eps < x1"), "claims: `eps`: expected a state variable"),
        (
            good.replace("x0 < x1", "x0"),
            "claims: expected `<`, `<=`, `=`, `>=` or `>`, found the end",
        ),
        (good.replace("x0 < x1", "x0 < 1/0"), "claims: a division by zero"),
        (good.replace("[\"x0 < x1\"]", "[]"), "no claim: expected `claims` or `converges`"),
        (good.replace("rules", "rulez"), "unknown field `rulez`"),
        (good.replace("x0 < x1", "x0 < x0"), "no start meets the claims, which are assumed"),
        (good.replace("x0 < x1", &"(".repeat(500)), "claims: is nested too deeply"),
        (
            rule(&format!("{}x", "x + ".repeat(20_000))),
            "rules.all: expected at most 2000 numbers and names",
        ),
        (good.replace("eps = 1", "eps = 1\nx1ago1 = 1"), "parameters.x1ago1: expected a name"),
        (
            good.replace("eps = 1", "eps = 1\nlink0with1 = 1"),
            "parameters.link0with1: expected a name",
        ),
        (
            good.replace(
                "claims = [\"x0 < x1\"]",
                "start = [\"x0 < x1\"]\nconverges = \"agreement\"",
            ),
            "claims: none in the protocol file",
        ),
    ];
    for (text, expected) in &cases {
        std::fs::write(&path, text).unwrap();
        let (code, out, err) = run(&["refute", "--protocol", path.to_str().unwrap()]);
        assert_eq!((code, out.as_str()), (2, ""), "{text}\n{err}");
        assert!(err.contains(expected), "expected `{expected}` in `{err}`");
    }
    assert_eq!(cases.len(), 34);
    std::fs::write(&path, good).unwrap();
    let with = |flags: &[&str]| {
        let file = path.to_str().unwrap();
        run(&[&["refute", "--protocol", file, "--steps", "1"], flags].concat())
    };
    assert_eq!(with(&["--start", "0,1"]).0, 1, "they swap at eps = 1");
    assert_eq!(with(&["--start", "1,0"]).0, 2, "not an assumed start");
    assert_eq!(with(&["--start", "0"]).0, 2, "too short");
    assert!(
        with(&["--set", "gain=1"]).2.contains("set: `gain` is no parameter: expected one of eps")
    );
    assert!(with(&["--set", "eps=1", "--set", "eps=0"]).2.contains("set: `eps` is there twice"));
    assert!(with(&["--set", "eps"]).2.contains("set: `eps`: expected a parameter and its value"));
}
