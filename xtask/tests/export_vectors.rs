//! Test vectors: what is exported is what the spec computes, and the committed files of the
//! mechanised mirrors are the exported ones, byte for byte.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::{missing, stderr_of, stdout_of};

/// How many vectors there are.
const VECTORS: usize = 232;

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
    assert_eq!(json["schema"], "cordon-vectors/2");
    let list = json["vectors"].as_array().unwrap();
    assert_eq!(list.len(), VECTORS);
    // The same numbers in the same order, whatever the format; names are unique.
    let mut names = std::collections::BTreeSet::new();
    for (row, entry) in tsv.lines().skip(1).zip(list) {
        let columns: Vec<_> = row.split('\t').collect();
        assert_eq!(columns.len(), 4);
        assert_eq!(columns[1], entry["name"]);
        assert_eq!(
            columns[2].split("; ").count(),
            entry["arguments"].as_object().unwrap().len(),
            "{}",
            columns[1]
        );
        let expected: Vec<_> =
            entry["expected"].as_array().unwrap().iter().map(|x| x.as_str().unwrap()).collect();
        assert_eq!(columns[3], expected.join(" "));
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
        // PROTOCOL section 2: eps*_4 = 2/3 is not below itself, eps*_5 = 2 - sqrt 2 = 0.5857..
        ("critical4_high", "0"),
        ("critical5_four", "1"),
        ("critical5_middle", "0"),
    ] {
        let row = tsv.lines().find(|l| l.split('\t').nth(1) == Some(name)).unwrap();
        assert_eq!(row.split('\t').nth(3), Some(expected), "{name}");
    }
}

/// Definitions by the file that they stand in.
type Items = &'static [(&'static str, &'static [&'static str])];

/// Which kind of vectors evaluates a definition of the spec, itself or on the way.
const EVALUATED: &[(&str, Items)] = &[
    (
        "coverage",
        &[
            ("drone_map.rs", &["DroneMap", "count", "lambda"]),
            ("scalar.rs", &["Scalar", "from_index"]),
            ("state.rs", &["Params", "State", "Phase", "initial", "tick_with"]),
            (
                "coverage.rs",
                &[
                    "exec_cvg",
                    "getx",
                    "update",
                    "next_placement",
                    "exec_coverage",
                    "tick",
                    "kth_step",
                ],
            ),
        ],
    ),
    (
        "local",
        &[(
            "local.rs",
            &[
                "TickRatio",
                "reached_by",
                "counter_limit",
                "LocalParams",
                "LocalState",
                "SimState",
                "fmu_exec_cvg",
                "fmu_tick",
                "project",
                "exchange",
                "swarm_tick",
            ],
        )],
    ),
    ("alone", &[("local.rs", &["whole", "fmu_kth_step"])]),
    (
        "consensus",
        &[
            ("graph.rs", &["Graph", "neighbourhood", "Path"]),
            ("consensus.rs", &["pull", "exec_consensus"]),
        ],
    ),
    ("meeting", &[("graph.rs", &["Edges"])]),
    ("formation", &[("formation.rs", &["exec_formation"])]),
    ("active", &[("activation.rs", &["exec_coverage_active"])]),
    ("delayed", &[("delay.rs", &["exec_coverage_delayed"])]),
    (
        "quantities",
        &[(
            "placement.rs",
            &[
                "gap",
                "sum",
                "gaps",
                "scaled_target",
                "scaled_error",
                "scaled_energy",
                "contraction_weight",
            ],
        )],
    ),
    ("residual", &[("theorems/non_decreasing.rs", &["telescoping_residual"])]),
    (
        "predicates",
        &[
            ("scalar.rs", &["Ordered"]),
            (
                "theorems/hypothesis.rs",
                &[
                    "StartSet",
                    "ordered",
                    "in_first_subsegment",
                    "upper_bounded",
                    "at_target",
                    "at_targets",
                ],
            ),
            ("theorems/upper_bound.rs", &["above_targets", "in_box"]),
        ],
    ),
    ("critical", &[("theorems/hypothesis.rs", &["contains", "WeightRange", "below_critical"])]),
];

/// Twins that no vector evaluates, and why.
const PROVED_INSTEAD: Items = &[
    // `sharp_conclusions`, `paper_conclusions` and `conclusion_for_ever` are about these.
    ("theorems/mod.rs", &["Form", "Theorem", "hypothesis", "span", "conclusion"]),
    ("theorems/hypothesis.rs", &["met_by"]),
    ("theorems/sum.rs", &["doubled"]),
    ("theorems/increasing.rs", &["first_off_target_is_late", "exact"]),
    ("theorems/limit.rs", &["magnitude", "at_rate"]),
];

#[test]
fn every_twin_has_a_vector() {
    let tsv = stdout_of(&["vectors", "--to", "tsv"]);
    let kinds: std::collections::BTreeSet<_> =
        tsv.lines().skip(1).filter_map(|l| l.split('\t').next()).collect();
    let mut listed = std::collections::BTreeSet::new();
    for (kind, files) in EVALUATED {
        assert!(kinds.contains(kind), "no vector of kind {kind}");
        for (file, items) in *files {
            listed.extend(items.iter().map(|item| format!("{file} {item}")));
        }
    }
    assert_eq!(kinds.len(), EVALUATED.len(), "{kinds:?}");
    for (file, items) in PROVED_INSTEAD {
        listed.extend(items.iter().map(|item| format!("{file} {item}")));
    }
    let mut named = std::collections::BTreeSet::new();
    for (folder, ending) in
        [("proofs/rocq/theories/Spec", "v"), ("lean-mirror/CordonMirror/Spec", "lean")]
    {
        for path in common::files(&common::root().join(folder), ending) {
            let text = std::fs::read_to_string(&path).unwrap();
            for rest in text.split("Rust: spec/src/").skip(1) {
                let mut words = rest.split_whitespace();
                let file = words.next().unwrap_or_default();
                let item = words.next().unwrap_or_default();
                let end =
                    item.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(item.len());
                named.insert(format!("{file} {}", &item[..end]));
            }
        }
    }
    let unlisted: Vec<_> = named.difference(&listed).collect();
    assert!(unlisted.is_empty(), "twins without a vector: {unlisted:?}");
    let gone: Vec<_> = listed.difference(&named).collect();
    assert!(gone.is_empty(), "no twins: {gone:?}");
    assert!(named.len() > 50, "{} twins", named.len());
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
