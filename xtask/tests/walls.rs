//! The walls of the house: which room may depend on which. Cargo keeps them; this test keeps
//! Cargo's manifests.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// Every package of the workspace, and the packages of the workspace it may build on. Tests and
/// benchmarks may use more.
const ROOMS: &[(&str, &[&str])] = &[
    ("cordon-spec", &[]),
    ("cordon-contracts", &["cordon-spec"]),
    ("cordon-check", &["cordon-spec"]),
    ("cordon-kani", &["cordon-spec"]),
    ("cordon-vector", &[]),
    ("cordon-core", &["cordon-spec"]),
    ("cordon-scenario", &["cordon-spec", "cordon-core"]),
    ("cordon-run", &["cordon-spec", "cordon-vector", "cordon-core", "cordon-scenario"]),
    (
        "cordon-proof",
        &["cordon-spec", "cordon-check", "cordon-vector", "cordon-core", "cordon-run"],
    ),
    ("cordon-fmi", &[]),
    ("cordon-cosim", &["cordon-spec", "cordon-core", "cordon-run"]),
    ("cordon-formats", &["cordon-spec", "cordon-core", "cordon-run", "cordon-fmi", "cordon-cosim"]),
    ("cordon-fmu", &["cordon-cosim"]),
    ("cordon-paper", &["cordon-spec", "cordon-core", "cordon-run", "cordon-cosim"]),
    (
        "cordon",
        &[
            "cordon-spec",
            "cordon-check",
            "cordon-fmi",
            "cordon-core",
            "cordon-run",
            "cordon-proof",
            "cordon-cosim",
            "cordon-formats",
            "cordon-paper",
        ],
    ),
    (
        "xtask",
        &[
            "cordon-spec",
            "cordon-check",
            "cordon-kani",
            "cordon-core",
            "cordon-run",
            "cordon-proof",
        ],
    ),
];

/// Packages of elsewhere that one room alone may name.
const KEPT: &[(&str, &[&str])] = &[
    ("clap", &["cordon", "xtask"]),
    ("plotters", &["cordon-paper"]),
    ("image", &["cordon-paper"]),
    ("quick-xml", &["cordon-formats"]),
    ("libloading", &["cordon-fmi"]),
];

fn metadata() -> Value {
    let out = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--no-deps", "--offline"])
        .current_dir(common::root())
        .output()
        .expect("cargo runs");
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    serde_json::from_slice(&out.stdout).expect("JSON")
}

/// The packages of the workspace, each with the names of what it builds on.
fn dependencies() -> BTreeMap<String, BTreeSet<String>> {
    let metadata = metadata();
    let text = |v: &Value| v.as_str().expect("text").to_owned();
    let list = |v: &Value| v.as_array().expect("a list").clone();
    list(&metadata["packages"])
        .iter()
        .map(|package| {
            let built_on = list(&package["dependencies"])
                .iter()
                .filter(|d| d["kind"].is_null())
                .map(|d| text(&d["name"]))
                .collect();
            (text(&package["name"]), built_on)
        })
        .collect()
}

#[test]
fn arrows_point_down() {
    let found = dependencies();
    let rooms: BTreeSet<&str> = ROOMS.iter().map(|(room, _)| *room).collect();
    let packages: BTreeSet<&str> = found.keys().map(String::as_str).collect();
    assert_eq!(packages, rooms, "every package of the workspace is a room");
    for (room, allowed) in ROOMS {
        let below: Vec<&String> =
            found[*room].iter().filter(|d| rooms.contains(d.as_str())).collect();
        for dependency in below {
            assert!(
                allowed.contains(&dependency.as_str()),
                "{room} may not depend on {dependency}"
            );
        }
    }
}

#[test]
fn the_rooms_are_listed_from_the_bottom_up() {
    for (at, (room, allowed)) in ROOMS.iter().enumerate() {
        for below in *allowed {
            let index = ROOMS.iter().position(|(name, _)| name == below);
            assert!(index.is_some_and(|p| p < at), "{room} above {below}");
        }
    }
}

#[test]
fn heavy_packages_stay_in_their_rooms() {
    let found = dependencies();
    for (package, rooms) in KEPT {
        let holders: Vec<&str> = found
            .iter()
            .filter(|(_, d)| d.contains(*package))
            .map(|(room, _)| room.as_str())
            .collect();
        assert_eq!(&holders, rooms, "who names {package}");
    }
}

/// Most packages that the binary inside an exported FMU may be built from, itself included.
const FMU_PACKAGES: usize = 40;

#[test]
fn the_binary_inside_fmus_is_built_from_few_packages() {
    let out = Command::new(env!("CARGO"))
        .args(["tree", "-p", "cordon-fmu", "-e", "normal", "--prefix", "none", "--offline"])
        .args(["--format", "{p}"])
        .current_dir(common::root())
        .output()
        .expect("cargo runs");
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let tree = String::from_utf8(out.stdout).expect("text");
    let packages: BTreeSet<&str> =
        tree.lines().filter_map(|l| l.split(" v").next()).filter(|l| !l.is_empty()).collect();
    assert!(packages.contains("cordon-fmu") && packages.contains("num-bigint"), "{packages:?}");
    assert!(packages.len() < FMU_PACKAGES, "{}: {packages:?}", packages.len());
}

/// Source files that a crate takes from outside its own folder, which no manifest shows.
#[test]
fn no_crate_takes_sources_of_another() {
    let root = common::root().canonicalize().unwrap();
    let out = Command::new("grep")
        .args(["-rnE", "--include=*.rs", r#"#\[path = "|include!\("#])
        .args([
            "spec/src",
            "spec/model",
            "src",
            "crates",
            "fmu/src",
            "kani/src",
            "proofs",
            "xtask/src",
        ])
        .current_dir(&root)
        .output()
        .expect("grep runs");
    let found = String::from_utf8(out.stdout).expect("text");
    for line in found.lines() {
        let file = root.join(line.split(':').next().unwrap());
        let taken = line.split('"').nth(1).expect("a path");
        let taken = file.parent().unwrap().join(taken).canonicalize().expect(line);
        assert_eq!(package(&taken), package(&file), "{line}");
    }
    // The spec's contracts: what is looked for is found.
    assert!(found.contains("spec/src/lib.rs:"), "{found}");
}

/// The folder of the package that a file belongs to.
fn package(file: &Path) -> &Path {
    file.ancestors().find(|a| a.join("Cargo.toml").is_file()).expect("a manifest")
}
