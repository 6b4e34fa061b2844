//! `cargo xtask verify`: the matrix, records, formats and exit codes. The tools outside are stood in
//! for by scripts, so that every verdict is seen on every machine.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "../common/mod.rs"]
mod common;
mod matrix;
mod repository;

use common::{has_tool, stderr_of, stdout_of};
use cordon_spec::theorems::Theorem;
use repository::Repository;
use serde_json::Value;
use xtask::verify::record::Records;
use xtask::verify::sources;
use xtask::verify::{Context, tiers};

fn cell<'p>(page: &'p Value, tier: &str, theorem: &str) -> &'p Value {
    let tiers = page["tiers"].as_array().unwrap();
    let column = tiers.iter().find(|t| t["tier"] == tier).unwrap();
    let cells = column["cells"].as_array().unwrap();
    cells.iter().find(|c| c["theorem"] == theorem).unwrap()
}

#[test]
fn tools_run_on_request_and_are_remembered() {
    let repo = Repository::new();
    // Not asked for, no record.
    let page = repo.json(&["7.2", "--tiers", "rocq"], 3);
    assert_eq!(cell(&page, "rocq", "7.2")["status"], "not run");
    assert_eq!(cell(&page, "rocq", "7.2")["detail"], "on request only: `--run rocq`");
    // Asked for.
    let page = repo.json(&["--tiers", "rocq", "--run", "rocq"], 0);
    let found = cell(&page, "rocq", "7.2");
    assert_eq!((&found["status"], &found["result"]), (&"run now".into(), &"holds".into()));
    assert_eq!(found["detail"], "sharp; paper");
    assert!(found["seconds"].as_f64().unwrap() >= 0.0);
    assert_eq!(cell(&page, "rocq", "7.4ii")["detail"], "paper", "a row `7.4` is about both parts");
    assert_eq!(cell(&page, "rocq", "7.7")["status"], "not claimed");
    // Recorded.
    let out = repo.verify(&["--record", "rocq"]);
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let page = repo.json(&["--tiers", "rocq"], 3);
    let found = cell(&page, "rocq", "7.2");
    assert_eq!((&found["status"], &found["result"]), (&"by record".into(), &"holds".into()));
    assert_eq!(found["record"]["tool"], "a Rocq for tests, 0.1");
    let date = found["record"]["date"].as_str().unwrap();
    assert!(date.len() == 10 && date.starts_with("20"), "{date}");
    // The same text again is the same record: nothing in it but the day is of the moment.
    assert_eq!(repo.json(&["--tiers", "rocq"], 3), page);
    // What a tool builds beside the sources changes nothing.
    repo.write("proofs/rocq/theories/A.vo", "built");
    repo.write("proofs/rocq/.hidden/A.v", "built");
    assert_eq!(repo.json(&["--tiers", "rocq"], 3), page);
    // Other sources, and the record counts for nothing.
    for changed in ["proofs/rocq/theories/A.v", "spec/src/lib.rs", "proofs/rocq/theories/B.v"] {
        let path = repo.root().join(changed);
        let before = std::fs::read_to_string(&path);
        repo.write(changed, "changed");
        let page = repo.json(&["--tiers", "rocq"], 3);
        let found = cell(&page, "rocq", "7.2");
        assert_eq!((&found["status"], &found["result"]), (&"stale".into(), &Value::Null));
        match before {
            Ok(text) => repo.write(changed, &text),
            Err(_) => std::fs::remove_file(path).unwrap(),
        }
    }
    assert_eq!(repo.json(&["--tiers", "rocq"], 3), page);
}

#[test]
fn a_rejected_proof_ends_with_4_and_stays_on_record() {
    let repo = Repository::new();
    repo.script(
        "proofs/rocq/check.sh",
        "echo 'FAILED no Admitted'; echo '2 passed, 1 failed'; exit 1",
    );
    let page = repo.json(&["7.2", "--tiers", "rocq", "--run", "all"], 4);
    let found = cell(&page, "rocq", "7.2");
    assert_eq!(found["result"], "rejected");
    let detail = found["detail"].as_str().unwrap();
    assert!(detail.contains("FAILED no Admitted; 2 passed, 1 failed"), "{detail}");
    assert!(repo.verify(&["--record", "rocq"]).status.success());
    assert_eq!(
        cell(&repo.json(&["7.2", "--tiers", "rocq"], 4), "rocq", "7.2")["status"],
        "by record"
    );
}

#[test]
fn a_missing_tool_is_not_run_never_green() {
    let repo = Repository::new();
    repo.script("bin/coqc", "exit 1");
    let page = repo.json(&["--tiers", "rocq,lean,kani", "--run", "all"], 3);
    assert_eq!(cell(&page, "rocq", "7.2")["detail"], "`coqc` is not installed");
    assert_eq!(cell(&page, "lean", "7.2")["detail"], "no `lean-mirror` here");
    assert_eq!(cell(&page, "kani", "7.2")["detail"], "no `kani` here");
    let error = repo.error(&["--record", "rocq"]);
    assert!(
        error.starts_with("error: --record: `rocq` did not run: `coqc` is not installed"),
        "{error}"
    );
    assert!(!repo.root().join("proofs/records.json").exists());
    // A development without the table of what it claims claims nothing.
    repo.script("bin/coqc", "echo 1");
    std::fs::remove_file(repo.root().join("proofs/rocq/theorems.tsv")).unwrap();
    let page = repo.json(&["--tiers", "rocq", "--run", "rocq"], 3);
    assert_eq!(
        cell(&page, "rocq", "7.2")["detail"],
        "no `proofs/rocq/theorems.tsv` with the list of what is claimed"
    );
}

#[test]
fn a_solver_proves_refutes_or_gives_up() {
    let repo = Repository::new();
    let answering = |answer: &str| {
        repo.script(
            "bin/z3",
            &format!(
                "if [ \"$1\" = --version ]; then echo z; else cat >/dev/null; echo '{answer}'; fi"
            ),
        );
    };
    let found = |code| {
        let page = repo.json(&["7.2,7.8", "--tiers", "smt"], code);
        assert_eq!(cell(&page, "smt", "7.8")["status"], "not claimed");
        cell(&page, "smt", "7.2").clone()
    };
    let holds = found(0);
    assert_eq!(holds["result"], "holds");
    let scope = "N = 3..6, all eps in its range, all starts, all k: 8 obligations";
    assert_eq!(holds["detail"], scope);
    answering("sat");
    let refuted = found(1);
    assert_eq!(refuted["result"], "refuted");
    let why = format!("obligation 7.2-sharp-n3-preserved is satisfiable ({scope})");
    assert_eq!(refuted["detail"], why);
    answering("unknown");
    assert_eq!(found(0)["result"], "inconclusive");
    answering("(error \"line 1\")");
    assert_eq!(found(0)["result"], "inconclusive");
    repo.script("bin/z3", "exit 1");
    assert_eq!(found(3)["detail"], "`z3` is not on PATH");
}

#[test]
fn certificates_are_judged_again() {
    let repo = Repository::new();
    let page = repo.json(&["--tiers", "certificate"], 3);
    assert_eq!(
        cell(&page, "certificate", "7.2")["detail"],
        "no certificates at `proofs/certificates`"
    );
    let contraction = |rate: &str| {
        format!(
            "{{\"schema\": \"cordon-certificate/2\", \"certificate\": {{\"contraction\": \
             {{\"drones\": 5, \"eps\": \"4/7\", \"rate\": \"{rate}\", \"vector\": [\"7\", \"10\", \"7\"]}}}}}}"
        )
    };
    // About no theorem for every N: accepted, and no evidence for any.
    repo.write("proofs/certificates/sub/good.json", &contraction("999/1000"));
    let page = repo.json(&["--tiers", "certificate"], 3);
    assert_eq!(cell(&page, "certificate", "7.8")["detail"], "no certificate about 7.8");
    // Tampered with.
    repo.write("proofs/certificates/sub/bad.json", &contraction("1/1000"));
    let page = repo.json(&["--tiers", "certificate"], 4);
    let problems = page["tiers"][0]["problems"].as_array().unwrap();
    assert_eq!(problems.len(), 1);
    let said = problems[0].as_str().unwrap();
    assert!(
        said.starts_with("rejected: bad.json: invalid: certificate: rule contraction: "),
        "{said}"
    );
    // No certificate at all.
    std::fs::remove_file(repo.root().join("proofs/certificates/sub/bad.json")).unwrap();
    repo.write("proofs/certificates/none.json", "{}");
    let page = repo.json(&["--tiers", "certificate"], 4);
    let said = page["tiers"][0]["problems"][0].as_str().unwrap();
    assert!(said.starts_with("rejected: none.json: unreadable: "), "{said}");
    // An empty proof of a theorem.
    std::fs::remove_file(repo.root().join("proofs/certificates/none.json")).unwrap();
    repo.write(
        "proofs/certificates/empty.json",
        "{\"schema\": \"cordon-certificate/2\", \"certificate\": {\"theorem\": \
         {\"claim\": \"7.2\", \"form\": \"sharp\", \"proofs\": []}}}",
    );
    let page = repo.json(&["7.2,7.3", "--tiers", "certificate"], 4);
    let said = page["tiers"][0]["problems"][0].as_str().unwrap();
    assert!(said.starts_with("rejected: empty.json: "), "{said}");
    assert_eq!(cell(&page, "certificate", "7.3")["status"], "not run");
}

#[test]
fn committed_certificates_prove_every_theorem_and_tampered_ones_none() {
    let page = stdout_of(&["verify", "--tiers", "certificate", "--format", "json"]);
    let page: Value = serde_json::from_str(&page).unwrap();
    for theorem in Theorem::ALL {
        let found = cell(&page, "certificate", theorem.number());
        assert_eq!(found["result"], "holds", "{found}");
        let detail = found["detail"].as_str().unwrap();
        assert!(detail.contains(" (sharp) for every N >= 3, "), "{detail}");
    }
    assert_eq!(page["tiers"][0]["problems"], serde_json::json!([]));

    let read = |name: &str| {
        std::fs::read_to_string(common::root().join("proofs/certificates").join(name)).unwrap()
    };
    let repo = Repository::new();
    // The paper's form, or the sharp form of one N, is not the theorem.
    repo.write("proofs/certificates/a.json", &read("7.2-paper.json"));
    let page = repo.json(&["7.2", "--tiers", "certificate"], 0);
    let found = cell(&page, "certificate", "7.2");
    assert_eq!(found["result"], "inconclusive");
    assert!(found["detail"].as_str().unwrap().starts_with("only parts or extensions of it"));
    // One wrong number.
    let sharp = read("7.2-sharp.json");
    let tampered = sharp.replacen("\"1\"", "\"2\"", 1);
    assert_ne!(sharp, tampered);
    repo.write("proofs/certificates/b.json", &tampered);
    let page = repo.json(&["7.2", "--tiers", "certificate"], 4);
    let found = cell(&page, "certificate", "7.2");
    assert_eq!(found["result"], "rejected");
    assert!(found["detail"].as_str().unwrap().starts_with("b.json: invalid: "), "{found}");
    repo.write("proofs/certificates/b.json", &sharp);
    assert_eq!(
        cell(&repo.json(&["7.2", "--tiers", "certificate"], 0), "certificate", "7.2")["result"],
        "holds"
    );
}

#[test]
fn the_program_s_own_tiers_hold() {
    let page: Value = serde_json::from_str(&stdout_of(&[
        "verify",
        "--tiers",
        "simulated,grid,complete",
        "--format",
        "json",
    ]))
    .unwrap();
    let tiers = page["tiers"].as_array().unwrap();
    assert_eq!(tiers.len(), 3);
    let kinds: Vec<_> = tiers.iter().map(|t| t["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["sampled", "exhaustive on a grid", "complete for all starts"]);
    let mut held = 0;
    for tier in tiers {
        for cell in tier["cells"].as_array().unwrap() {
            assert_eq!(
                (&cell["status"], &cell["result"]),
                (&"run now".into(), &"holds".into()),
                "{cell}"
            );
            held += 1;
        }
    }
    assert_eq!(held, 3 * Theorem::ALL.len());
}

#[test]
fn the_solver_at_hand_proves_every_theorem_that_has_a_step() {
    if !has_tool("z3", "verify: SMT tier") {
        return;
    }
    let text = stdout_of(&["verify", "--tiers", "smt"]);
    let table: Vec<_> = text.lines().take(11).collect();
    assert_eq!(table.iter().filter(|l| l.contains("holds")).count(), 9, "{text}");
    assert!(table[10].trim().starts_with("7.8") && table[10].trim().ends_with('-'), "{text}");
    assert!(text.contains("smt (inductive, for each N):"), "{text}");
}

#[test]
fn bad_input_is_named() {
    let error = stderr_of(&["verify", "9.9"], 2);
    assert!(error.starts_with("error: theorem: `9.9` is unknown: expected `all` or"), "{error}");
    let error = stderr_of(&["verify", "--tiers", "coq"], 2);
    assert_eq!(
        error,
        "error: --tiers: `coq` is not a tier: expected `all` or some of simulated, grid, complete, \
         kani, smt, creusot, certificate, rocq, lean, pvs\n"
    );
    let error = stderr_of(&["verify", "--run", "x"], 2);
    assert!(error.starts_with("error: --run: `x` is not a tier"), "{error}");
    let error = stderr_of(&["verify", "--record", "all"], 2);
    assert_eq!(error, "error: --record: `all`: expected one tier\n");
    let error = stderr_of(&["verify", "--root", "no/such"], 2);
    assert_eq!(error, "error: --root: `no/such`: expected a folder\n");
    let repo = Repository::new();
    for (text, said) in [
        ("{", ":1:1: expected records: "),
        ("{\"schema\": \"cordon-records/1\"}", ": expected records: missing field `records`"),
        (
            "{\"schema\": \"cordon-records/2\", \"records\": []}",
            ": schema `cordon-records/2`: expected `cordon-records/1`",
        ),
        (
            "{\"schema\": \"cordon-records/1\", \"records\": [], \"x\": 1}",
            ": expected records: unknown field `x`",
        ),
    ] {
        repo.write("proofs/records.json", text);
        let error = repo.error(&["7.2", "--tiers", "rocq"]);
        assert!(error.contains(said), "{text}: {error}");
    }
}

/// The record of the model checker is evidence where it is of the sources beside it. One that is
/// not says so: its hash is `null` (declared to be of an earlier spec), and the matrix shows it as
/// stale. A hash of other sources is a record that nobody has looked at.
#[test]
fn the_record_of_the_model_checker_is_fresh_or_shown_as_stale() {
    let root = common::root();
    let text = std::fs::read_to_string(root.join("kani/run.json")).unwrap();
    let run: Value = serde_json::from_str(&text).unwrap();
    let hash = sources::hash(root, &xtask::model_check::SOURCES).unwrap();
    let fresh = match run["sources"].as_str() {
        None => false,
        Some(of) => {
            assert_eq!(of, hash, "stale: `cargo xtask kani --out kani/run.json`, or declare it so");
            true
        }
    };
    let out = common::xtask(&["verify", "--tiers", "kani", "--format", "json"]);
    assert_eq!(out.status.code(), Some(3), "no tier ran now");
    let page: Value = serde_json::from_slice(&out.stdout).unwrap();
    let about: Vec<_> =
        page["tiers"][0]["cells"].as_array().unwrap().iter().map(|c| &c["status"]).collect();
    let expected = if fresh { "by record" } else { "stale" };
    assert!(about.iter().all(|s| *s == expected || *s == "not claimed"), "{about:?}");
    assert!(about.iter().filter(|s| **s == expected).count() >= 8, "{about:?}");
}

#[test]
fn the_record_of_the_model_checker_counts_for_its_sources_only() {
    let repo = Repository::new();
    repo.write("kani/src/lib.rs", "// harnesses");
    let hash = sources::hash(repo.root(), &xtask::model_check::SOURCES).unwrap();
    let record = |sources: &str, verdict: &str, left_out: &str| {
        let rows = cordon_kani::all().filter(|h| h.name != left_out).map(|h| {
            format!(
                "{{\"name\": \"{}\", \"verdict\": \"{verdict}\", \"detail\": \"why\", \"seconds\": 1.5}}",
                h.name
            )
        });
        let rows: Vec<_> = rows.collect();
        repo.write(
            "kani/run.json",
            &format!(
                "{{\"kani\": \"0.67.0\", \"date\": \"2026-01-31\", \"sources\": {sources}, \"harnesses\": [{}]}}",
                rows.join(", ")
            ),
        );
    };
    let found = |code| {
        let page = repo.json(&["7.2", "--tiers", "kani"], code);
        cell(&page, "kani", "7.2").clone()
    };
    let quoted = format!("\"{hash}\"");
    record(&quoted, "proved", "");
    let fresh = found(3);
    assert_eq!((&fresh["status"], &fresh["result"]), (&"by record".into(), &"holds".into()));
    assert_eq!(fresh["record"]["tool"], "Kani 0.67.0");
    // Of other sources, of none that are known: counted for nothing.
    for other in ["\"sha256:0\"", "null"] {
        record(other, "proved", "");
        let stale = found(3);
        assert_eq!((&stale["status"], &stale["result"]), (&"stale".into(), &Value::Null));
    }
    // A harness that failed, one that is missing, a verdict that nobody knows.
    record(&quoted, "refuted", "");
    assert_eq!(found(1)["result"], "refuted");
    record(&quoted, "proved", "harnesses::ordering::step_4");
    assert_eq!(found(3)["result"], "inconclusive");
    record(&quoted, "excellent", "");
    assert_eq!(found(4)["result"], "rejected");
    let error = repo.error(&["--record", "kani"]);
    assert!(error.contains("expected `cargo xtask kani --out kani/run.json`"), "{error}");
}

/// What the repository's records say was found by provers was found of the sources beside them.
#[test]
fn committed_records_of_provers_are_fresh() {
    let root = common::root();
    let records = Records::read(root).unwrap();
    let mut compared = 0;
    for tier in tiers(Context { root, run: &[] }) {
        if !["rocq", "lean", "creusot", "pvs"].contains(&tier.name()) {
            continue;
        }
        let record = records.of(tier.name()).unwrap();
        let hash = sources::hash(root, tier.sources()).unwrap();
        let name = tier.name();
        assert_eq!(record.sources, hash, "stale: `cargo xtask verify --record {name}`");
        compared += 1;
    }
    assert_eq!(compared, 4);
}

/// The list of goals beside the contracts is of the run on record, and no goal in it is open.
#[test]
fn the_list_of_goals_is_that_of_the_record() {
    let root = common::root();
    let text = std::fs::read_to_string(root.join("proofs/creusot/goals.json")).unwrap();
    let goals: Value = serde_json::from_str(&text).unwrap();
    let records = Records::read(root).unwrap();
    assert_eq!(goals["sources"], records.of("creusot").unwrap().sources.as_str());
    let functions = goals["by_function"].as_array().unwrap();
    let sum = |field: &str| functions.iter().map(|f| f[field].as_u64().unwrap()).sum::<u64>();
    assert_eq!(functions.len() as u64, goals["functions"].as_u64().unwrap());
    assert_eq!(sum("goals"), goals["goals"].as_u64().unwrap());
    let open = functions.iter().filter(|f| f["goals"] != f["proved"]);
    let open: Vec<&str> = open.map(|f| f["function"].as_str().unwrap()).collect();
    assert!(open.is_empty(), "open goals in {open:?}");
    assert!(sum("goals") > 1000, "{} goals", sum("goals"));
}
