//! The committed certificates are valid, and the permanent bad ones are rejected by the rule that
//! their index states; mended in the one point that is wrong, each is accepted.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use cordon_check::{Verdict, check};
use serde_json::Value;

/// How many certificates are committed, and how many clauses they prove.
const CERTIFICATES: usize = 59;
const PROVED: usize = 344;

/// How many bad ones are.
const MUST_NOT_PROVE: usize = 316;

/// Where a file can be rejected (a split cannot fail by itself).
const RULES: [&str; 14] = [
    "name",
    "expression",
    "definition",
    "positivity",
    "instance",
    "cases",
    "induction",
    "conclusion",
    "system",
    "contraction",
    "growth",
    "refutation",
    "invariance",
    "quadratic",
];

fn folder(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..").join(name)
}

fn files(name: &str) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> =
        fs::read_dir(folder(name)).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    files
}

#[test]
fn every_committed_certificate_is_valid() {
    let (mut count, mut total) = (0, 0);
    for path in files("certificates") {
        match check(&fs::read_to_string(&path).unwrap()) {
            Verdict::Valid { obligations, .. } => total += obligations,
            verdict => panic!("{}: {verdict}", path.display()),
        }
        count += 1;
    }
    assert_eq!((count, total), (CERTIFICATES, PROVED));
}

#[test]
fn every_rule_and_kind_has_a_committed_certificate() {
    let texts: String =
        files("certificates").iter().map(|p| fs::read_to_string(p).unwrap()).collect();
    let words = ["positivity", "absurd", "cases", "induction", "definitions", "assumptions"];
    let kinds = ["theorem", "contraction", "growth", "refutation", "invariance", "quadratic"];
    for word in words.into_iter().chain(kinds) {
        assert!(texts.contains(&format!("\"{word}\": ")), "no certificate with {word}");
    }
}

#[test]
fn every_bad_certificate_is_rejected_by_its_rule_and_its_twin_accepted() {
    let index = fs::read_to_string(folder("must-not-prove/index.json")).unwrap();
    let index: Vec<Value> = serde_json::from_str(&index).unwrap();
    let mut named = BTreeSet::new();
    for entry in &index {
        let text = |key: &str| entry[key].as_str().unwrap_or_else(|| panic!("{key}")).to_owned();
        let file = text("file");
        let bad = fs::read_to_string(folder("must-not-prove").join(&file)).unwrap();
        let verdict = check(&bad);
        assert_eq!(verdict.label(), text("verdict"), "{file}: {verdict}");
        if let Verdict::Invalid { rule, .. } = &verdict {
            assert_eq!(*rule, text("rule"), "{file}: {verdict}");
        }
        let shown = verdict.to_string();
        assert!(shown.contains(&text("reason")), "{file}: {shown}");
        let twin = check(&mended(&bad, &entry["mend"]));
        assert_eq!(twin.label(), "valid", "{file}, mended: {twin}");
        assert!(named.insert(file), "an entry is there twice");
    }
    for rule in RULES {
        assert!(index.iter().any(|e| e["rule"] == rule), "no rejected case of {rule}");
    }
    let there = files("must-not-prove");
    assert_eq!(there.len(), index.len() + 1, "a file without entry, or an entry without file");
    assert_eq!(index.len(), MUST_NOT_PROVE);
}

/// The file with another value at one place, or another text in the place of one.
fn mended(bad: &str, mend: &Value) -> String {
    match mend["text"].as_str() {
        Some(text) => bad.replacen(text, mend["by"].as_str().unwrap(), 1),
        None if mend["at"] == "" => mend["value"].to_string(),
        None => {
            let mut page: Value = serde_json::from_str(bad).unwrap();
            let place = page.pointer_mut(mend["at"].as_str().unwrap());
            *place.unwrap_or_else(|| panic!("{mend}")) = mend["value"].clone();
            page.to_string()
        }
    }
}

#[test]
fn signs_that_allow_cancellation_are_noticed() {
    use cordon_check::concrete::{Rows, one_sign};
    use cordon_check::number::Number;
    let rows = |entries: &[&[i64]]| -> Rows {
        let row = |r: &&[i64]| {
            let nonzero = r.iter().enumerate().filter(|(_, a)| **a != 0);
            nonzero.map(|(j, &a)| (j, Number::whole(a))).collect()
        };
        entries.iter().map(row).collect()
    };
    let plain = |entries: &[&[i64]]| one_sign(&rows(entries), false);
    let alternating = |entries: &[&[i64]]| one_sign(&rows(entries), true);
    assert!(plain(&[&[1, 2], &[3, 4]]) && !alternating(&[&[1, 2], &[3, 4]]));
    assert!(!plain(&[&[-1, 2], &[3, -4]]) && alternating(&[&[-1, 2], &[3, -4]]));
    // A rotation: no sign pattern helps, and |A| w >= w would prove nothing.
    assert!(!plain(&[&[0, 1], &[-1, 0]]) && !alternating(&[&[0, 1], &[-1, 0]]));
    assert!(!plain(&[&[1, 1], &[1, -1]]) && !alternating(&[&[1, 1], &[1, -1]]));
}
