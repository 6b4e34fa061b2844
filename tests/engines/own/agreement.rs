//! What is said of a protocol file agrees: with the spec, with exact runs, from command to command.
use std::cell::Cell;

use super::{own, system};
use crate::common::{for_cases, q, run};
use crate::own_random::{self, choices, grid, random_protocol};
use cordon_check::Verdict;
use cordon_core::system::{Consensus, Coverage, System};
use cordon_proof::claims::sweep::on_grid;
use cordon_proof::claims::threshold::{Known, Property, critical, decided, with};
use cordon_proof::claims::{WORK, constants, follow, refute};
use cordon_run::scenario::Topology;
use proptest::prelude::*;

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
        let found =
            decided(&with(&system, 0, &q(eps)), Property::Claims, &mut WORK.clone()).unwrap().known;
        assert_eq!(
            (code, found),
            if holds { (3, Known::Holds) } else { (1, Known::Fails) },
            "{eps}"
        );
    }
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

/// Whenever a critical value is bracketed, both sides hold: the checker says so of both certificates, runs of the
/// one side keep the claims, and of the other one breaks them.
fn brackets_hold(cases: u32) {
    let (tried, bracketed) = (Cell::new(0), Cell::new(0));
    for_cases(cases, random_protocol(1..2), |text| {
        tried.set(tried.get() + 1);
        let Some(system) = own_random::read(&text.replace("1/4..1/2", "0..4"))? else {
            return Ok(());
        };
        let (found, _) = critical(&system, 0, Property::Claims, 1, BRACKET_WORK).unwrap();
        let Some(found) = found else { return Ok(()) };
        bracketed.set(bracketed.get() + 1);
        for certificate in found.certificates.iter().map(Option::as_ref) {
            let verdict = cordon_check::check(&certificate.unwrap().to_string());
            prop_assert!(matches!(verdict, Verdict::Valid { .. }), "{}\n{}", verdict, text);
        }
        for (n, start) in grid(&system).into_iter().enumerate() {
            let by = choices(&system, &found.holds, n);
            prop_assert_eq!(follow(&system, &[], &start, by), None, "{}", text);
        }
        let fails = with(&system, 0, &found.fails);
        let (run, _) = refute(&fails, &constants(&fails, 1).unwrap(), None, 40);
        let run = run.ok_or_else(|| TestCaseError::fail(format!("no run:\n{text}")))?;
        let again = follow(&fails, &run.values, &run.states[0], run.choices.clone());
        prop_assert_eq!(again.as_ref(), Some(&run), "{}", text);
        Ok(())
    });
    assert_eq!(tried.get(), cases);
    assert!(bracketed.get() >= cases / 20, "{bracketed:?}");
}

/// Work for a bracket: little, since of many random systems most are simple.
const BRACKET_WORK: u64 = 2_000_000;

#[test]
fn brackets_hold_on_both_sides() {
    brackets_hold(1_000);
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
