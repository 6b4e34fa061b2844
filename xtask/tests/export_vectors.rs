//! Test vectors: what is exported is what the spec computes, and the committed files of the
//! mechanised mirrors are the exported ones, byte for byte.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::{missing, stderr_of, stdout_of};

/// How many vectors there are.
const VECTORS: usize = 67;

#[test]
fn every_format_has_every_vector() {
    let tsv = stdout_of(&["vectors", "--to", "tsv"]);
    assert_eq!(tsv.lines().count(), VECTORS + 1);
    let rocq = stdout_of(&["vectors", "--to", "rocq"]);
    assert_eq!(rocq.matches("\nExample ").count(), VECTORS);
    let lean = stdout_of(&["vectors", "--to", "lean"]);
    assert_eq!(lean.matches("\n#guard ").count(), VECTORS);
    let json = stdout_of(&["vectors", "--to", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["schema"], "cordon-vectors/1");
    let list = json["vectors"].as_array().unwrap();
    assert_eq!(list.len(), VECTORS);
    // The same numbers in the same order, whatever the format; names are unique.
    let mut names = std::collections::BTreeSet::new();
    for (row, entry) in tsv.lines().skip(1).zip(list) {
        let columns: Vec<_> = row.split('\t').collect();
        assert_eq!(columns.len(), 11);
        assert_eq!(columns[1], entry["name"]);
        let expected: Vec<_> =
            entry["expected"].as_array().unwrap().iter().map(|x| x.as_str().unwrap()).collect();
        assert_eq!(columns[10], expected.join(" "));
        assert_eq!(columns[2], expected.len().to_string());
        assert!(names.insert(columns[1]), "{}", columns[1]);
        assert!(rocq.contains(&format!("Example {} : {} ", columns[1], columns[0])));
        assert!(lean.contains(&format!(" -- {}\n", columns[1])));
    }
}

/// Numbers known from elsewhere: PROTOCOL sections 4 and 5, or computed by hand.
#[test]
fn known_positions_are_among_them() {
    let tsv = stdout_of(&["vectors", "--to", "tsv"]);
    for (name, expected) in [
        // Erratum 4: with eps = 0.7 drone 3 is at 72 after the first update.
        ("high_weight_1", "0 10 20 72 100"),
        // Erratum 11: drone 1 goes from 10 to 8.2.
        ("not_monotonic_1", "0 41/5 67/5 183/5 100"),
        // Fig. 8 at t = 2 s, 40 ticks, rounded 17.73, 39.58, 67.54.
        ("paper_first_40", "0 34620002/1953125 77312656/1953125 131921958/1953125 100"),
        // Listing 4's reading of the first update: nothing moves before tick n + 1 = 4.
        ("paper_last_3", "0 10 20 30 100"),
        ("paper_last_4", "0 10 20 42 100"),
        // eps/stepsize = 7/2 rounds up: an update every 5 ticks.
        ("local_first_5", "0 10 20 42 100"),
        ("local_first_6", "0 10 112/5 246/5 100"),
        ("crossing_1", "0 13/25 12/25 1"),
        ("rendezvous_1", "3 10 20 48 79"),
    ] {
        let row = tsv.lines().find(|l| l.split('\t').nth(1) == Some(name)).unwrap();
        assert_eq!(row.split('\t').nth(10), Some(expected), "{name}");
    }
}

#[test]
fn committed_vectors_are_the_exported_ones() {
    let root = common::root();
    let mut compared = 0;
    for (to, path) in [
        ("tsv", "proofs/rocq/vectors.tsv"),
        ("rocq", "proofs/rocq/theories/Vectors.v"),
        ("lean", "lean-mirror/CordonMirror/Vectors.lean"),
    ] {
        let Ok(committed) = std::fs::read_to_string(root.join(path)) else {
            missing("vectors", path);
            continue;
        };
        let exported = stdout_of(&["vectors", "--to", to]);
        assert!(
            committed == exported,
            "{path} is not what `cargo xtask vectors --to {to} --out {path}` writes"
        );
        compared += 1;
    }
    eprintln!("vectors: {compared} committed files compared");
}

#[test]
fn bad_input_is_named() {
    let error = stderr_of(&["vectors"], 2);
    assert!(error.contains("--to <TO>"), "{error}");
    let error = stderr_of(&["vectors", "--to", "agda"], 2);
    assert!(error.starts_with("error: invalid value 'agda'"), "{error}");
    let error = stderr_of(&["vectors", "--to", "tsv", "--out", "no/such/file"], 74);
    assert!(error.starts_with("error: cannot write `no/such/file`"), "{error}");
}
