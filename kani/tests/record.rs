//! The record of the last run with Kani, and what README.md says of it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::fs;
use std::path::Path;

use serde_json::Value;

fn text(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap()
}

#[test]
fn the_readme_says_what_the_record_says() {
    let run: Value = serde_json::from_str(&text("run.json")).unwrap();
    assert_eq!(run["schema"], "cordon-kani/1");
    let harnesses = run["harnesses"].as_array().unwrap();
    assert!(harnesses.len() >= 40, "{} harnesses", harnesses.len());
    assert_eq!(run["proved"], harnesses.len(), "all of them proved");
    assert!(harnesses.iter().all(|h| h["covers"] == 1 && h["covers_met"] == 1), "every cover met");
    let number = |key: &str| harnesses.iter().map(|h| h[key].as_f64().unwrap()).sum::<f64>();
    let slowest = harnesses.iter().map(|h| h["seconds"].as_f64().unwrap()).fold(0.0, f64::max);
    let found = harnesses.iter().filter(|h| h["expected"] == "counterexample").count();
    let said = format!(
        "{} harnesses, {} of them with the counterexample that they have to find, {} checks, {:.0} s of \
         solving in all, {slowest:.0} s for the slowest",
        harnesses.len(),
        found,
        number("checks"),
        number("seconds"),
    );
    let readme = text("README.md").split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(readme.contains(&said), "README.md should say\n{said}");
}
