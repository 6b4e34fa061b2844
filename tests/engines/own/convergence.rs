//! Where users' own protocols end, and critical values.

use super::{is_valid, own, system};
use crate::common::q;
use cordon_core::Rational;
use cordon_proof::claims::converge;
use cordon_proof::claims::settle::settles;
use cordon_proof::claims::threshold::{Known, Property, WORK, critical, decided, with};
use num_traits::{Signed, Zero};

#[test]
fn critical_values_are_bracketed_from_both_sides() {
    let mut ordering = own("coverage", Some(5));
    ordering.parameters[0].high = q("1");
    let (found, _) = critical(&ordering, 0, Property::Claims, 4, WORK).unwrap();
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
    let (found, _) = critical(&limit, 0, Property::Convergence, 2, WORK).unwrap();
    let found = found.unwrap();
    assert!(found.holds < q("2/3") && q("2/3") <= found.fails, "{found:?}");
    assert!(&found.fails - &found.holds <= q("1/100"), "{found:?}");
}

/// At the critical value what turns is kept by a form that need not be a square: on a line of three with damping
/// 1/4 eigenvalues have the product 1/4 + 3g/25, which is 1 at g = 25/4; with five and damping 3/10 all pairs reach
/// the unit circle at gain 30, each at another angle.
#[test]
fn convergence_is_decided_up_to_the_critical_value_and_at_it() {
    let three = "agents = 3\nstate = \"x, v\"\ntopology = \"line\"\nconverges = \"agreement\"\n\
                 [parameters]\ng = \"1/4..30\"\n[rules]\n\
                 all = { x = \"x + v/5\", v = \"v + g/5*sum(their.x - x) + 1/4*sum(their.v - v)\" }\n";
    let mut five = own("second-order", None);
    five.parameters[0].high = q("40");
    for (system, critical_value) in [(system(three), "25/4"), (five, "30")] {
        let (found, _) = critical(&system, 0, Property::Convergence, 4, WORK).unwrap();
        let found = found.unwrap();
        assert!(found.open.is_none() && !found.used_up, "{found:?}");
        assert!(found.holds < q(critical_value) && q(critical_value) <= found.fails);
        assert!(&found.fails - &found.holds <= q("1/10000"));
        assert!(found.certificates.iter().all(|c| is_valid(c.as_ref().unwrap())));
        let at = with(&system, 0, &q(critical_value));
        let known = decided(&at, Property::Convergence, &mut 0).unwrap().known;
        assert_eq!(known, Known::Fails, "{critical_value}");
    }
}

/// Starts without bounds, which have no part along the direction that is found first.
#[test]
fn a_start_that_grows_is_found_among_starts_without_bounds() {
    let text = |e: &str| {
        format!(
            "agents = 3\ntopology = \"ring\"\nstart = [\"sum(x) = 1\", \"x0 = x1\"]\n\
             converges = \"agreement\"\n[rules]\nall = \"x + {e}*sum(their.x - x)\"\n"
        )
    };
    // The factor 1 - 3e.
    for (e, known) in [("1/2", Known::Holds), ("2/3", Known::Fails), ("9/10", Known::Fails)] {
        let found = decided(&system(&text(e)), Property::Convergence, &mut 0).unwrap();
        assert_eq!(found.known, known, "{e}");
        assert!(is_valid(&found.certificate.unwrap()), "{e}");
    }
}

/// Two modes without a common form have one for each; a form for each settles as one does.
#[test]
fn modes_have_forms_of_their_own() {
    let system = own("two-modes", None);
    let found = converge::contraction(&system).unwrap().unwrap();
    assert_eq!(found.forms.len(), 2);
    let form = &found.certificate["certificate"]["theorem"]["statement"]["definitions"][2]["step"];
    assert!(form.as_str().unwrap().contains("second(k)*("), "{form}");
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

/// Modes in turn converge a round at a time, where no mode alone does; acting at will they need not, and
/// two stable modes in turn may grow.
#[test]
fn modes_in_turn_are_judged_by_the_round() {
    let line = |switching: &str| {
        system(&format!(
            "agents = 5\ntopology = \"line\"\n{switching}start = [\"x0 = 0\", \"x4 = 1\", \"0 <= x[i] <= 1\"]\n\
             converges = \"target\"\ntarget = \"i/(N - 1)\"\n[rules]\nall = \"x\"\n[modes.even]\n\
             2 = \"(prev.x + next.x)/2\"\n[modes.odd]\n1 = \"(prev.x + next.x)/2\"\n\
             3 = \"(prev.x + next.x)/2\"\n"
        ))
    };
    let in_turn = line("switching = [\"even\", \"odd\"]\n");
    let found = converge::contraction(&in_turn).unwrap().unwrap();
    assert!(is_valid(&found.certificate));
    assert_eq!((found.round, found.rate < q("3/4")), (2, true));
    // The certificate is about the round as one step: its rows are the two steps one after the other, the ends at 0 and 1.
    let said = cordon_check::check(&found.certificate.to_string()).to_string();
    for row in [
        "if k >= 0 then x1(1 + k) = 1/4*x1(k) + 1/4*x3(k)\n",
        "if k >= 0 then x2(1 + k) = 1/2*x1(k) + 1/2*x3(k)\n",
        "if k >= 0 then x3(1 + k) = 1/2 + 1/4*x1(k) + 1/4*x3(k)\n",
    ] {
        assert!(said.contains(row), "{said}");
    }
    // The step that is promised, from the corner that is slowest; within a round too.
    let start = [q("0"), q("1"), q("1"), q("1"), q("1")];
    let within = q("1/100");
    let step = settles(&in_turn, &found, Some(&start), &within).unwrap();
    let last = usize::try_from(step).unwrap() + 3;
    for state in &in_turn.run(&[], &start, last)[last - 3..] {
        let far = (0..5).map(|i| (&state[i] - q(&format!("{i}/4"))).abs()).max().unwrap();
        assert!(far <= within);
    }
    assert!(converge::grows(&in_turn).unwrap().is_none());

    let at_will = converge::grows(&line("")).unwrap().unwrap();
    assert!(is_valid(&at_will.certificate));
    assert_eq!(at_will.word.len(), 1);
}

/// What may be chosen in every step is chosen so that nothing vanishes, if it can be: one way over and
/// over, or several in turn.
#[test]
fn choices_may_keep_a_system_from_converging() {
    let stable = system(
        "agents = 1\nstate = \"x, v\"\nstart = [\"-1 <= x[i] <= 1\", \"-1 <= v[i] <= 1\"]\n\
         converges = \"target\"\ntarget = { x = \"0\", v = \"0\" }\n[modes.a]\n\
         all = { x = \"x/2 + 2*v\", v = \"v/2\" }\n[modes.b]\nall = { x = \"x/2\", v = \"2*x + v/2\" }\n",
    );
    let found = converge::grows(&stable).unwrap().unwrap();
    assert!(is_valid(&found.certificate));
    assert_eq!(found.word.iter().map(|c| c.mode).collect::<Vec<_>>(), [0, 1]);

    // Each link may fail: nothing moves where all do. Some links alone would move the targets.
    let lossy = |loss: &str| {
        system(&format!(
            "agents = 4\ntopology = \"line\"\nstart = [\"x0 = 0\", \"x3 = 1\", \"0 <= x[i] <= 1\"]\n\
             converges = \"target\"\ntarget = \"i/(N - 1)\"\n[rules]\nfirst = \"x\"\n\
             inner = \"x + sum(their.x - x)/3\"\nlast = \"x\"\n{loss}"
        ))
    };
    let found = converge::grows(&lossy("[departures]\nloss = \"symmetric\"\n")).unwrap().unwrap();
    assert!(is_valid(&found.certificate));
    assert!(found.word.iter().flat_map(|c| &c.values).all(Zero::is_zero));
    assert!(converge::grows(&lossy("")).unwrap().is_none());
    assert!(converge::contraction(&lossy("")).unwrap().is_some());
}

/// Lines of many agents: forms with short numbers, and growth by invariant subspaces.
#[test]
fn many_differences_are_judged() {
    let line = |agents: usize, eps: &str| {
        system(&format!(
            "agents = {agents}\ntopology = \"line\"\nconverges = \"target\"\ntarget = \"i/(N - 1)\"\n\
             [rules]\nfirst = \"0\"\ninner = \"x + {eps}*sum(their.x - x)\"\nlast = \"1\"\n"
        ))
    };
    for agents in [30, 100] {
        let found = converge::contraction(&line(agents, "1/3")).unwrap().unwrap();
        assert!(is_valid(&found.certificate) && found.rate < q("1"), "{agents}");
    }
    for agents in [10, 40] {
        let fast = line(agents, "11/20");
        assert!(converge::contraction(&fast).unwrap().is_none());
        let found = converge::grows(&fast).unwrap().unwrap();
        assert!(is_valid(&found.certificate), "{agents}");
    }
}

/// What the checker's limits allow: sparse forms of up to two hundred differences, dense ones of some fifty.
#[test]
fn long_chains_are_within_the_limits() {
    let agreement = |agents: usize, rest: &str| {
        let head = format!("agents = {agents}\nconverges = \"agreement\"\n{rest}");
        converge::contraction(&system(&head)).unwrap().map(|found| is_valid(&found.certificate))
    };
    let first = "[rules]\nall = \"x + sum(their.x - x)/3\"\n";
    let ranged = "[parameters]\neps = \"1/4..1/3\"\n[rules]\nall = \"x + eps*sum(their.x - x)\"\n";
    let second = "state = \"x, v\"\ntopology = \"line\"\n[rules]\nall = { x = \"x + v/10\", \
                  v = \"v + sum(their.x - x)/10 + 3/10*sum(their.v - v)\" }\n";
    for (agents, rest) in [
        (150, format!("topology = \"line\"\n{first}")),
        (150, format!("topology = \"ring\"\n{first}")),
        (100, format!("topology = \"ring\"\n{ranged}")),
        (26, second.to_owned()),
    ] {
        assert_eq!(agreement(agents, &rest), Some(true), "{agents}: {rest}");
    }
}

/// Without work nothing is said.
#[test]
fn a_search_without_work_is_open() {
    let system = own("coverage", Some(4));
    assert_eq!(decided(&system, Property::Claims, &mut 0).unwrap().known, Known::Open);
}
