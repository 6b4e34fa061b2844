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
const MUST_NOT_PROVE: usize = 165;

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
fn every_claim_and_kind_has_a_committed_certificate() {
    let mut seen = BTreeSet::new();
    for path in files("certificates") {
        let page: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        let (kind, body) = page["certificate"].as_object().unwrap().iter().next().unwrap();
        seen.insert(kind.clone());
        if kind == "theorem" {
            seen.insert(body["claim"].as_str().unwrap().to_owned());
        }
    }
    let kinds = ["theorem", "exactness", "contraction", "growth", "refutation", "invariance"];
    let claims = cordon_check::claims::CLAIMS.iter().map(|c| c.name);
    for name in kinds.into_iter().chain(claims) {
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
    let there = files("must-not-prove");
    assert_eq!(there.len(), index.len() + 1, "a file without entry, or an entry without file");
    assert_eq!(index.len(), MUST_NOT_PROVE);
}
