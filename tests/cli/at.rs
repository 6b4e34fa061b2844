//! `cordon trace --at` and `cordon swarm`, as a user runs them.
use std::process::Output;

fn cordon(args: &str) -> Output {
    let args = args.split_whitespace();
    assert_cmd::Command::cargo_bin("cordon").unwrap().args(args).output().unwrap()
}

fn stdout(args: &str) -> String {
    let done = cordon(args);
    assert_eq!(done.status.code(), Some(0), "{args}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

/// The message of a refusal: exit code 2, nothing on stdout.
fn refusal(args: &str) -> String {
    let done = cordon(args);
    assert_eq!(done.status.code(), Some(2), "{args}");
    assert!(done.stdout.is_empty(), "{args}");
    String::from_utf8(done.stderr).unwrap()
}

const PAPER: &str = "trace scenarios/paper.toml --numbers fraction --format csv";

/// Chosen rows are the rows of the trace, by every engine, in the order asked for.
#[test]
fn chosen_steps_are_the_rows_of_the_trace() {
    let all = stdout(&format!("{PAPER} --steps 20"));
    let row = |k: usize| all.lines().nth(k + 1).unwrap();
    let wanted = format!("{}\n{}\n{}\n{}\n", all.lines().next().unwrap(), row(17), row(0), row(4));
    for engine in ["auto", "step", "jump"] {
        assert_eq!(stdout(&format!("{PAPER} --at 17,0,4 --engine {engine}")), wanted, "{engine}");
    }
}

#[test]
fn consensus_has_chosen_steps_too() {
    let flags = "trace scenarios/consensus.toml --numbers fraction --format csv";
    let all = stdout(&format!("{flags} --steps 9"));
    let chosen = stdout(&format!("{flags} --at 9 --engine jump"));
    assert_eq!(chosen.lines().last(), all.lines().last());
}

#[test]
fn a_verified_answer_names_its_seed_and_bound() {
    let args = "trace scenarios/paper.toml --at 100,7 --verify 2 --seed 42";
    let done = cordon(args);
    assert_eq!(done.status.code(), Some(0));
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(said.starts_with("verified: all 20 residues are those of the plain spec"), "{said}");
    assert!(said.contains("--seed 42") && said.contains("at most 2^-60"), "{said}");
    assert_eq!(String::from_utf8(cordon(args).stderr).unwrap(), said);
    // Without a seed there is a fresh one, which the message names.
    let fresh = String::from_utf8(cordon("trace scenarios/paper.toml --at 3 --verify").stderr);
    assert!(fresh.unwrap().contains("drawn from --seed "));
}

#[test]
fn certain_digits_after_any_number_of_steps() {
    let flags = "trace scenarios/paper.toml --engine digits --digits 6 --format";
    let csv = stdout(&format!("{flags} csv --at 18446744073709551615,2"));
    assert_eq!(
        csv.lines().collect::<Vec<_>>(),
        [
            "step,x0_decimal,x1_decimal,x2_decimal,x3_decimal,x4_decimal",
            "18446744073709551615,0.000000,25.000000,50.000000,75.000000,100.000000",
            "2,0.000000,10.000000,22.400000,49.200000,100.000000",
        ]
    );
    let page: serde_json::Value =
        serde_json::from_str(&stdout(&format!("{flags} json --at 1000000000000"))).unwrap();
    assert_eq!(page["schema"], "cordon-digits/1");
    assert_eq!(page["rows"][0]["certain_places"], 6);
    assert!(stdout(&format!("{flags} table --at 5")).contains("x4"));
}

#[test]
fn refusals() {
    for (args, wanted) in [
        (
            "trace scenarios/paper.toml --at 1000000000000",
            "take about 1.3 TB: expected at most 1.0 GB",
        ),
        ("trace scenarios/paper.toml --at 18446744073709551615", "expected at most 1.0 GB"),
        ("trace scenarios/paper.toml --at 3,x", "invalid value 'x'"),
        ("trace scenarios/paper.toml --at 3 --steps 4", "cannot be used with"),
        ("trace scenarios/paper.toml --verify", "--at"),
        ("trace scenarios/paper.toml --at 3 --seed 4", "--verify"),
        ("trace scenarios/paper.toml --at 3 --verify 0", "0 is not in 1..=64"),
        ("trace scenarios/paper.toml --at 3 --engine digits --verify", "exact engines only"),
        ("trace scenarios/paper.toml --at 3 --engine digits --format itf", "exact engines only"),
        ("trace scenarios/consensus.toml --graph ring --at 3", "consensus on the path"),
        (
            "trace scenarios/paper-unstable.toml --engine digits --at 1000000000000",
            "weight in [0, 1/2]",
        ),
        ("swarm --drones 2", "drones: `2`: expected 3 to"),
        ("swarm --steps 100000000000", "drone updates"),
        ("swarm --drones 10 --show 10", "show: `10`: expected a drone from 0 to 9"),
        ("swarm --min 7 --max 7", "expected more than min"),
        ("swarm --eps fast", "eps: `fast` is not a number"),
    ] {
        let said = refusal(args);
        assert!(said.contains(wanted), "{args}: {said}");
    }
}

#[test]
fn a_swarm_reports_its_error_bound() {
    let page = stdout("swarm --drones 1000 --steps 100 --format json");
    let page: serde_json::Value = serde_json::from_str(&page).unwrap();
    assert_eq!(page["schema"], "cordon-swarm/1");
    let bound = page["error_bound"].as_f64().unwrap();
    assert!(bound > 0.0 && bound < 1e-10, "{bound}");
    assert_eq!(page["order"], "all drones are in order, in the exact run too");
    assert!(stdout("swarm --drones 1000 --steps 10 --show 7").contains("x7 "));
    // Overflow is not hidden: no bound, exit code 3.
    let done = cordon("swarm --drones 100 --eps 0.7 --steps 9000");
    assert_eq!(done.status.code(), Some(3));
    assert!(String::from_utf8(done.stdout).unwrap().contains("nothing is known"));
}
