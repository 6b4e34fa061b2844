//! The committed certificates are valid, and the permanent bad ones are rejected by the rule that
//! their index states; mended in the one point that is wrong, each is accepted.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use cordon_check::{Verdict, check};
use cordon_spec::Scalar;
use serde_json::{Value, json};

/// How many certificates are committed, and how many clauses they prove.
const CERTIFICATES: usize = 82;
const PROVED: usize = 500;

/// How many bad ones are.
const MUST_NOT_PROVE: usize = 341;

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
    "counterexample",
    "ellipsoid",
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

/// What is proved is what the verdict says: word for word as recorded (`CORDON_BLESS=1` records).
#[test]
fn verdicts_are_those_recorded() {
    let record = folder("checker/tests/checker/verdicts.txt");
    let said: String = files("certificates")
        .iter()
        .map(|p| {
            let verdict = check(&fs::read_to_string(p).unwrap());
            format!("{}: {verdict}\n", p.file_name().unwrap().to_str().unwrap())
        })
        .collect();
    if std::env::var_os("CORDON_BLESS").is_some() {
        fs::write(record, said).unwrap();
        return;
    }
    let recorded = fs::read_to_string(record).unwrap();
    for (said, recorded) in said.lines().zip(recorded.lines()) {
        assert_eq!(said, recorded);
    }
    assert_eq!(said.len(), recorded.len());
}

#[test]
fn every_rule_and_kind_has_a_committed_certificate() {
    let texts: String =
        files("certificates").iter().map(|p| fs::read_to_string(p).unwrap()).collect();
    let words = ["positivity", "absurd", "cases", "induction", "definitions", "assumptions"];
    let kinds = ["theorem", "contraction", "growth", "refutation", "counterexample", "ellipsoid"];
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

/// Of a protocol whose step turns errors, |A| w >= w proves nothing.
#[test]
fn signs_that_allow_cancellation_are_noticed() {
    use cordon_check::check_of;
    use cordon_check::poly::Poly;
    use cordon_check::system::Step;
    // e_1' = a e_1 + b e_2, e_2' = c e_1 + d e_2 for N = 4, the targets being 1 and 2.
    fn turned(x: &[Poly], [a, b, c, d]: [i64; 4]) -> Vec<Poly> {
        let error = |i: usize| Poly::from_index(i) - &x[i];
        let sum = |a: i64, b: i64| Poly::whole(a) * &error(1) + &(Poly::whole(b) * &error(2));
        let inner = [sum(a, b), sum(c, d)];
        vec![
            x[0].clone(),
            Poly::from_index(1) - &inner[0],
            Poly::from_index(2) - &inner[1],
            x[3].clone(),
        ]
    }
    macro_rules! step {
        ($($entry:expr),*) => {
            |_, s| cordon_spec::State { drones: turned(&s.drones, [$($entry),*]), timesteps: 0 }
        };
    }
    let cases: [(Step, bool); 8] = [
        (step![1, 2, 3, 4], true),
        (step![-1, -2, -3, -4], true),
        (step![-1, 2, 3, -4], true),
        (step![1, -2, -3, 4], true),
        (step![0, 1, -1, 0], false),
        (step![0, -1, 1, 0], false),
        (step![1, 1, 1, -1], false),
        (step![1, 1, -1, 1], false),
    ];
    let page = json!({ "drones": 4, "eps": "1", "vector": ["1", "1"] });
    let page = json!({ "schema": "cordon-certificate/2", "certificate": { "growth": page } });
    for (case, (step, grows)) in cases.into_iter().enumerate() {
        let verdict = check_of(&page.to_string(), step);
        assert_eq!(verdict.code() == 0, grows, "{case}: {verdict}");
        assert!(grows || verdict.to_string().contains("signs of A allow"), "{case}: {verdict}");
    }
}

/// What a verdict says of runs in continuous time follows from the edges, and no more.
#[test]
fn verdicts_say_what_was_shown() {
    let page = |name: &str| -> Value {
        let path = folder("certificates").join(format!("{name}.json"));
        serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
    };
    // The switching ellipsoid, without the edge of the soft mode, or without that mode.
    let firm = |alone: bool| {
        let mut page = page("ellipsoid-switching");
        let c = &mut page["certificate"]["ellipsoid"];
        c["edges"].as_array_mut().unwrap().truncate(1);
        if alone {
            c["system"]["modes"].as_object_mut().unwrap().remove("soft");
        }
        page
    };
    let cases = [
        (
            page("ellipsoid-switching"),
            vec!["every run, whatever mode acts at each time, at every time: 3/2 >= x and 2 + v > 0".into()],
        ),
        (
            firm(false),
            vec!["the runs that start at kept, along kept -firm-> kept, at every time: 3/2 >= x and 2 + v > 0".into()],
        ),
        (firm(true), vec!["every run, at every time: 3/2 >= x and 2 + v > 0".into()]),
        (
            page("ellipsoid-schedule"),
            vec![format!("{} slow -drive for 1/4-> fast, fast -brake for 1-> slow, at every time: 13/8 > x", "the runs that start at slow, along")],
        ),
        (
            page("ellipsoid-passage"),
            vec!["the runs that start at a, along a -brake for 1-> b, at every time: 5/4 > x and 3 + x >= 0".into()],
        ),
    ];
    for (page, expected) in cases {
        let Verdict::Valid { claim, .. } = check(&page.to_string()) else { panic!("{page}") };
        let said: Vec<&str> = claim
            .lines()
            .filter_map(|l| l.trim().strip_prefix("proved ").map(|l| l.trim_start_matches("of ")))
            .collect();
        assert_eq!(said, expected, "{claim}");
    }
}
