//! `RULES.md` sets the rules beside those that `Kernel.v` proves sound: a row a premise, each with a file that must not prove.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use serde_json::Value;

fn text(path: &str) -> String {
    fs::read_to_string(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..").join(path)).unwrap()
}

/// How many premises each constructor has: arrows outside of brackets, but for those of what is derived.
fn premises(kernel: &str) -> BTreeMap<String, usize> {
    let (_, rest) = kernel.split_once("Inductive derives").unwrap();
    let (constructors, _) = rest.split_once("\n\n").unwrap();
    let counted = constructors.split("\n| ").skip(1).map(|constructor| {
        let (name, body) = constructor.split_once(' ').unwrap();
        (name.to_owned(), arrows(body))
    });
    let theorem = kernel.split_once("Theorem definition_exists").unwrap().1;
    let theorem = theorem.split_once("exists").unwrap().0;
    counted.chain([("definition_exists".to_owned(), arrows(theorem))]).collect()
}

fn arrows(body: &str) -> usize {
    let mut depth = 0;
    body.char_indices()
        .filter(|(at, c)| {
            depth += i32::from("([{".contains(*c)) - i32::from(")]}".contains(*c));
            depth == 0 && body[*at..].starts_with("->")
        })
        .count()
}

#[test]
fn each_premise_of_each_rule_is_asked_for() {
    let index: Vec<Value> = serde_json::from_str(&text("must-not-prove/index.json")).unwrap();
    let mut rows: BTreeMap<String, usize> = BTreeMap::new();
    for line in text("checker/RULES.md").lines().filter(|l| l.starts_with("| `")) {
        let cells: Vec<&str> = line.trim_matches('|').split(" | ").map(str::trim).collect();
        let [constructor, _, _, file] = cells.as_slice() else { panic!("{line}") };
        *rows.entry(constructor.trim_matches('`').to_owned()).or_default() += 1;
        let file = format!("{}.json", file.trim_matches('`'));
        let there = index.iter().any(|e| e["file"] == file && e["verdict"] == "invalid");
        assert!(there || file == "by construction.json", "{line}");
    }
    assert_eq!(rows, premises(&text("rocq/theories/Kernel.v")));
}
