//! The committed certificates are valid, and the permanent bad ones are rejected for the
//! reasons that their index states.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use cordon_check::{Verdict, check};
use serde_json::Value;

/// How many certificates are committed.
const CERTIFICATES: usize = 45;

/// How many obligations their claims come to.
const OBLIGATIONS: usize = 243;

/// How many bad ones are.
const MUST_NOT_PROVE: usize = 194;

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
    assert_eq!((count, total), (CERTIFICATES, OBLIGATIONS));
}

#[test]
fn every_claim_kind_and_rule_has_a_committed_certificate() {
    let mut seen = BTreeSet::new();
    for path in files("certificates") {
        let text = fs::read_to_string(&path).unwrap();
        let rules = cordon_check::rules::RULES.iter().map(|(rule, _)| (*rule).to_owned());
        seen.extend(rules.filter(|rule| text.contains(&format!("\"rule\": \"{rule}\""))));
        let page: Value = serde_json::from_str(&text).unwrap();
        let (kind, body) = page["certificate"].as_object().unwrap().iter().next().unwrap();
        seen.insert(kind.clone());
        if kind == "theorem" {
            seen.insert(body["claim"].as_str().unwrap().to_owned());
        }
    }
    let kinds = ["theorem", "exactness", "contraction", "growth", "refutation", "invariance"];
    let claims = cordon_check::claims::CLAIMS.iter().map(|c| c.name);
    let rules = cordon_check::rules::RULES.iter().map(|(rule, _)| *rule);
    for name in kinds.into_iter().chain(claims).chain(rules) {
        assert!(seen.contains(name), "no certificate of {name}");
    }
}

#[test]
fn every_bad_certificate_is_rejected_for_its_reason() {
    let index = fs::read_to_string(folder("must-not-prove/index.json")).unwrap();
    let index: Vec<Value> = serde_json::from_str(&index).unwrap();
    let mut named = BTreeSet::new();
    for entry in &index {
        let text = |key: &str| entry[key].as_str().unwrap_or_else(|| panic!("{key}")).to_owned();
        let file = text("file");
        let bytes = fs::read(folder("must-not-prove").join(&file)).unwrap();
        let verdict = check(&String::from_utf8(bytes).unwrap());
        assert_eq!(verdict.label(), text("verdict"), "{file}: {verdict}");
        if let Verdict::Invalid { rule, .. } = &verdict {
            assert_eq!(*rule, text("rule"), "{file}: {verdict}");
        }
        let shown = verdict.to_string();
        assert!(shown.contains(&text("reason")), "{file}: {shown}");
        assert!(named.insert(file), "an entry is there twice");
    }
    // Every rule of proof and every kind is there.
    let rules = cordon_check::rules::RULES.iter().map(|(name, _)| *name);
    let kinds = ["theorem", "exactness", "contraction", "growth", "refutation", "invariance"];
    for rule in rules.chain(kinds) {
        assert!(index.iter().any(|e| e["rule"] == rule), "no rejected case of {rule}");
    }
    let there = files("must-not-prove");
    assert_eq!(there.len(), index.len() + 1, "a file without entry, or an entry without file");
    assert_eq!(index.len(), MUST_NOT_PROVE);
}

#[test]
fn signs_that_allow_cancellation_are_noticed() {
    let rows = |entries: &[&[i64]]| -> cordon_check::concrete::Rows {
        let row = |r: &&[i64]| {
            let nonzero = r.iter().enumerate().filter(|(_, a)| **a != 0);
            nonzero
                .map(|(j, &a)| (j, cordon_check::poly::Rational::from_integer(a.into())))
                .collect()
        };
        entries.iter().map(row).collect()
    };
    let plain = |entries: &[&[i64]]| cordon_check::concrete::one_sign(&rows(entries), false);
    let alternating = |entries: &[&[i64]]| cordon_check::concrete::one_sign(&rows(entries), true);
    assert!(plain(&[&[1, 2], &[3, 4]]) && !alternating(&[&[1, 2], &[3, 4]]));
    assert!(!plain(&[&[-1, 2], &[3, -4]]) && alternating(&[&[-1, 2], &[3, -4]]));
    // A rotation: no sign pattern helps, and |A| w >= w would prove nothing.
    assert!(!plain(&[&[0, 1], &[-1, 0]]) && !alternating(&[&[0, 1], &[-1, 0]]));
    assert!(!plain(&[&[1, 1], &[1, -1]]) && !alternating(&[&[1, 1], &[1, -1]]));
}
