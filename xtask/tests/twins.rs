//! Every definition of the spec has a twin in the Rocq and in the Lean mirror, and every twin
//! names a definition that exists.
//!
//! A twin says so in a comment: `Rust: spec/src/coverage.rs exec_cvg`.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use std::collections::{BTreeMap, BTreeSet};

use common::{files, missing};

/// A definition: its file below `spec/src/`, and its name.
type Item = (String, String);

/// A mirror: its name, the folder of its definitions and the ending of its files.
struct Mirror {
    name: &'static str,
    folder: &'static str,
    ending: &'static str,
    exceptions: &'static [(&'static str, &'static str, &'static str)],
}

const MIRRORS: [Mirror; 2] = [
    Mirror { name: "Rocq", folder: "proofs/rocq/theories/Spec", ending: "v", exceptions: &[] },
    Mirror {
        name: "Lean",
        folder: "lean-mirror/CordonMirror/Spec",
        ending: "lean",
        exceptions: &[
            ("scalar.rs", "Scalar", "the mirror is over the rationals alone"),
            ("scalar.rs", "Ordered", "the mirror is over the rationals alone"),
        ],
    },
];

/// In `spec/src/theorems/` the predicates decide what the mirrors state as propositions, which
/// stand in their theorem files. Only what the propositions are made of has twins there; these
/// are looked up from the mirror's side alone.
const THEOREMS: &str = "theorems/";

/// The definitions in a file's text: functions, types and traits; public ones only, or all.
fn definitions(text: &str, public_only: bool) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for line in text.lines() {
        let mut words = line.trim_start();
        if words.starts_with("#[cfg(test)]") {
            break;
        }
        let public = words.starts_with("pub");
        for prefix in ["pub(crate) ", "pub(super) ", "pub ", "const "] {
            words = words.strip_prefix(prefix).unwrap_or(words);
        }
        let name = ["fn ", "struct ", "enum ", "trait "].iter().find_map(|k| words.strip_prefix(k));
        if let Some(name) = name.filter(|_| public || !public_only) {
            let end = name.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(name.len());
            found.insert(name[..end].to_owned());
        }
    }
    found
}

fn spec_items(public_only: bool) -> BTreeSet<Item> {
    let source = common::root().join("spec/src");
    let mut items = BTreeSet::new();
    for path in files(&source, "rs") {
        let name = path.strip_prefix(&source).unwrap().to_str().unwrap().to_owned();
        let text = std::fs::read_to_string(&path).unwrap();
        items.extend(definitions(&text, public_only).into_iter().map(|d| (name.clone(), d)));
    }
    items
}

/// The Rust items that a text names: `Rust: spec/src/<file> <item>`.
fn twins(text: &str) -> Vec<Item> {
    let named = text.split("Rust: spec/src/").skip(1);
    named
        .map(|rest| {
            let mut words = rest.split_whitespace();
            let file = words.next().unwrap_or_default().to_owned();
            let item = words.next().unwrap_or_default();
            let end = item
                .find(|c: char| !c.is_alphanumeric() && c != '_' && c != ':')
                .unwrap_or(item.len());
            // `Type::method` names the method.
            let item = item[..end].trim_end_matches(':');
            (file, item.rsplit("::").next().unwrap_or_default().to_owned())
        })
        .collect()
}

/// What does not agree between the spec and a mirror's texts.
fn disagreements(
    public: &BTreeSet<Item>,
    all: &BTreeSet<Item>,
    named: &[Item],
    exceptions: &BTreeMap<Item, &str>,
) -> Vec<String> {
    let twins: BTreeSet<_> = named.iter().cloned().collect();
    let mut found = Vec::new();
    let defines = |file: &str| !file.starts_with(THEOREMS);
    for item in public.iter().filter(|(file, _)| defines(file)) {
        match (twins.contains(item), exceptions.contains_key(item)) {
            (false, false) => found.push(format!("{} {} has no twin", item.0, item.1)),
            (true, true) => found.push(format!("{} {} is no exception", item.0, item.1)),
            _ => {}
        }
    }
    for item in twins.difference(all) {
        found.push(format!("{} {} is named and does not exist", item.0, item.1));
    }
    for item in exceptions.keys().filter(|i| !public.contains(*i)) {
        found.push(format!("exception {} {} does not exist", item.0, item.1));
    }
    found
}

#[test]
fn spec_and_mirrors_have_the_same_definitions() {
    let (public, all) = (spec_items(true), spec_items(false));
    for mirror in &MIRRORS {
        let paths = files(&common::root().join(mirror.folder), mirror.ending);
        if paths.is_empty() {
            missing("twins", mirror.folder);
            continue;
        }
        let named: Vec<_> =
            paths.iter().flat_map(|p| twins(&std::fs::read_to_string(p).unwrap())).collect();
        let exceptions = mirror
            .exceptions
            .iter()
            .map(|&(file, item, why)| ((file.to_owned(), item.to_owned()), why))
            .collect();
        let found = disagreements(&public, &all, &named, &exceptions);
        assert_eq!(found, Vec::<String>::new(), "{}", mirror.name);
        assert!(named.len() > 40, "{}: {} twins", mirror.name, named.len());
        eprintln!("twins: {} definitions in {}", named.len(), mirror.name);
    }
}

/// Every row of Lean's table is compared by Lean itself: `lake build` prints nothing of a theorem
/// that `Listed.lean` leaves out.
#[test]
fn lean_compares_every_row_of_its_table() {
    let folder = common::root().join("lean-mirror");
    let table = std::fs::read_to_string(folder.join("theorems.tsv")).unwrap();
    let listed = std::fs::read_to_string(folder.join("CordonMirror/Listed.lean")).unwrap();
    let library = std::fs::read_to_string(folder.join("CordonMirror.lean")).unwrap();
    let mut rows = 0;
    for row in table.lines().skip(1) {
        let [_, _, theorem, file, _] = row.split('\t').collect::<Vec<_>>()[..] else {
            panic!("five columns: `{row}`");
        };
        let text = std::fs::read_to_string(folder.join(file)).unwrap();
        assert!(text.contains(&format!("\ntheorem {theorem} ")), "{file}: no `{theorem}`");
        let axioms = "depends on axioms: [propext, Classical.choice, Quot.sound]";
        for expected in [
            format!("\n#guard_msgs in\n#check @{theorem}\n"),
            format!("\n#guard_msgs in\n#print axioms {theorem}\n"),
            format!("info: 'CordonMirror.{theorem}' {axioms}\n"),
        ] {
            assert!(listed.contains(&expected), "Listed.lean: no `{}`", expected.trim());
        }
        rows += 1;
    }
    assert_eq!(listed.matches("#check @").count(), rows);
    assert!(rows >= 41, "{rows} rows");
    // What the library does not import is not built.
    for path in files(&folder.join("CordonMirror"), "lean") {
        let module = path.strip_prefix(&folder).unwrap().with_extension("");
        let module = module.to_str().unwrap().replace('/', ".");
        assert!(library.contains(&format!("import {module}\n")), "{module} is not imported");
    }
}

#[test]
fn the_spec_is_read_whole() {
    let public = spec_items(true);
    let has = |file: &str, item: &str| public.contains(&(file.to_owned(), item.to_owned()));
    assert!(has("coverage.rs", "exec_cvg"));
    assert!(has("coverage.rs", "update"), "pub(crate) counts");
    assert!(has("local.rs", "counter_limit"), "methods count");
    assert!(has("scalar.rs", "Ordered"), "traits count");
    assert!(has("state.rs", "Phase"), "enums count");
    let outside = public.iter().filter(|(file, _)| !file.starts_with(THEOREMS)).count();
    assert!(outside >= 42, "{outside} public definitions outside the theorems");
}

#[test]
fn every_kind_of_disagreement_is_found() {
    let item = |file: &str, name: &str| (file.to_owned(), name.to_owned());
    let public = BTreeSet::from([item("a.rs", "f"), item("a.rs", "g"), item("theorems/t.rs", "h")]);
    let mut all = public.clone();
    all.insert(item("a.rs", "private"));
    let none = BTreeMap::new();
    let named = twins(
        "(* Rust: spec/src/a.rs f: said of it *) -- Rust: spec/src/a.rs T::g.  And so on\n\
         (* Rust: spec/src/a.rs private *)",
    );
    assert_eq!(named, [item("a.rs", "f"), item("a.rs", "g"), item("a.rs", "private")]);
    let ok = disagreements(&public, &all, &named, &none);
    assert_eq!(ok, Vec::<String>::new());
    let fewer = disagreements(&public, &all, &named[..1], &none);
    assert_eq!(fewer, ["a.rs g has no twin"]);
    let excused = BTreeMap::from([(item("a.rs", "g"), "why")]);
    assert_eq!(disagreements(&public, &all, &named[..1], &excused), Vec::<String>::new());
    assert_eq!(disagreements(&public, &all, &named, &excused), ["a.rs g is no exception"]);
    let stale = BTreeMap::from([(item("a.rs", "gone"), "why")]);
    let found = disagreements(&public, &all, &named, &stale);
    assert_eq!(found, ["exception a.rs gone does not exist"]);
    let unknown = [named.clone(), vec![item("b.rs", "f")]].concat();
    let found = disagreements(&public, &all, &unknown, &none);
    assert_eq!(found, ["b.rs f is named and does not exist"]);
}
